// Inputs of properties as JSON objects, so that a failing case needs no random numbers to run again.
//   HasFields                    what can be written and read
//   write_input, read_input      an input as a JSON object and back, number for number
//   Bytes                        any text, valid UTF-8 or not; in JSON as hexadecimal digits
// An input is an aggregate In with default values and
//   template <class Self, class Visitor> static void fields(Self& in, Visitor& visit) { visit("name", in.member); ... }
// Members are bool, int, double (finite; in JSON as a hexadecimal float), Rational, std::string (printable), Bytes,
// KnotList<Rational>, Vec<S, D>, std::vector and std::optional of these, and aggregates with fields of their own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/document.hpp"
#include "torse/spline/knots.hpp"

namespace torse::fuzz {

/// Any bytes.
struct Bytes {
  std::string text;
  friend bool operator==(const Bytes&, const Bytes&) = default;
};

namespace detail {

struct AnyField {
  template <class T>
  void operator()(std::string_view, T&) const {}
};

}  // namespace detail

/// An aggregate whose members are fields.
template <class In>
concept HasFields = requires(In& in, const detail::AnyField& visit) {
  In::fields(in, visit);
};

template <HasFields In>
std::string write_input(const In& in);
template <HasFields In>
In read_input(const Value& value);

namespace detail {

std::string hex_text(std::string_view bytes);
/// Throws FileError unless `value` is a string of pairs of hexadecimal digits.
std::string bytes_of(const Value& value);

template <class T>
struct Field {
  static std::string write(const T& x) { return write_input(x); }
  static T read(const Value& value) { return read_input<T>(value); }
};
template <>
struct Field<bool> {
  static std::string write(bool x) { return x ? "1" : "0"; }
  static bool read(const Value& value) { return value.integer(0, 1) == 1; }
};
template <>
struct Field<int> {
  static std::string write(int x) { return std::to_string(x); }
  static int read(const Value& value) { return value.integer(-2147483647, 2147483647); }
};
template <>
struct Field<double> {
  static std::string write(double x);
  static double read(const Value& value) { return value.number<Rational>().to_double(); }
};
template <>
struct Field<Rational> {
  static std::string write(const Rational& x) { return '"' + x.text() + '"'; }
  static Rational read(const Value& value) { return value.number<Rational>(); }
};
template <>
struct Field<std::string> {
  static std::string write(const std::string& x) { return '"' + x + '"'; }
  static std::string read(const Value& value) { return value.string(); }
};
template <>
struct Field<Bytes> {
  static std::string write(const Bytes& x) { return '"' + hex_text(x.text) + '"'; }
  static Bytes read(const Value& value) { return {bytes_of(value)}; }
};
template <class T>
struct Field<std::vector<T>> {
  static std::string write(const std::vector<T>& list) {
    std::string text;
    for (const T& x : list) text += (text.empty() ? "" : ", ") + Field<T>::write(x);
    return '[' + text + ']';
  }
  static std::vector<T> read(const Value& value) {
    std::vector<T> list;
    for (const Value& item : value.items()) list.push_back(Field<T>::read(item));
    return list;
  }
};
/// None is the empty array.
template <class T>
struct Field<std::optional<T>> {
  static std::string write(const std::optional<T>& x) { return x ? '[' + Field<T>::write(*x) + ']' : "[]"; }
  static std::optional<T> read(const Value& value) {
    const std::vector<Value> items = value.items();
    if (items.size() > 1) value.expected("an array of at most one entry");
    return items.empty() ? std::nullopt : std::optional<T>(Field<T>::read(items.front()));
  }
};
template <class S, int D>
struct Field<Vec<S, D>> {
  static std::string write(const Vec<S, D>& x) {
    return Field<std::vector<S>>::write(std::vector<S>(x.data(), x.data() + D));
  }
  static Vec<S, D> read(const Value& value) {
    const auto list = Field<std::vector<S>>::read(value);
    if (static_cast<int>(list.size()) != D) value.expected(std::to_string(D) + " numbers");
    Vec<S, D> x;
    for (int i = 0; i < D; ++i) x[i] = list[static_cast<std::size_t>(i)];
    return x;
  }
};
template <>
struct Field<KnotList<Rational>> {
  static std::string write(const KnotList<Rational>& u) {
    return "{\"degree\": " + std::to_string(u.degree()) +
           ", \"list\": " + Field<std::vector<Rational>>::write(u.list()) + '}';
  }
  static KnotList<Rational> read(const Value& value) {
    value.expect_keys({"degree", "list"});
    try {
      return {value.at("degree").integer(1, limits::degree), Field<std::vector<Rational>>::read(value.at("list"))};
    } catch (const InvalidInput& invalid) {
      value.fail(invalid.what());
    }
  }
};

}  // namespace detail

/// {"name": value, ...} in the order of In's fields.
template <HasFields In>
std::string write_input(const In& in) {
  std::string text;
  const auto visit = [&]<class T>(std::string_view name, const T& member) {
    text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\": " + detail::Field<T>::write(member);
  };
  In::fields(in, visit);
  return '{' + text + '}';
}

/// Throws FileError where a field is missing, of another type or unknown.
template <HasFields In>
In read_input(const Value& value) {
  In in;
  std::vector<std::string_view> names;
  const auto collect = [&](std::string_view name, const auto&) { names.push_back(name); };
  In::fields(in, collect);
  value.expect_keys(names);
  const auto visit = [&]<class T>(std::string_view name, T& member) {
    member = detail::Field<T>::read(value.at(name));
  };
  In::fields(in, visit);
  return in;
}

}  // namespace torse::fuzz
