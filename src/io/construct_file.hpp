// The input of `torse construct` as JSON.
//   ConstructFile            what the file holds
//   MethodKeys, method_keys  the keys that a method needs and those that it may have
//   read_construct           from a document
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/io/spline_file.hpp"

namespace torse {

/// The keys of a method besides "torse", "type", "method", "degree" and "c".
struct MethodKeys {
  std::string_view method;
  std::vector<std::string_view> needed;
  std::vector<std::string_view> optional;
  bool weights;
};

/// The methods of `torse construct`, in the order of its help.
inline const std::vector<MethodKeys>& method_keys() {
  static const std::vector<MethodKeys> methods{
      {"bspline", {"Lambda", "M", "d0"}, {"knots"}, false},
      {"bezier", {"Lambda", "M", "d0"}, {}, false},
      {"rational", {"Lambda", "M", "sigma", "d0", "omega0"}, {"knots"}, true},
      {"cylinder", {"d0"}, {"knots", "M", "Lambda"}, true},
      {"cone", {"Lambda", "d0"}, {"knots"}, true},
      {"tangent", {}, {"knots"}, false},
      {"interpolate", {"va", "vb", "Lambda"}, {"knots"}, false},
      {"directrix", {"a", "b"}, {"d0", "v"}, false},
  };
  return methods;
}

/// The first row, and the parameters that the method has.
template <ExactField S>
struct ConstructFile {
  std::string method;
  KnotList<S> knots;
  WeightedPoints<S, 3> c;
  std::optional<S> lambda{};
  std::optional<S> m{};
  std::optional<S> sigma{};
  std::optional<S> omega0{};
  std::optional<Vec<S, 3>> d0{};
  std::optional<Vec<S, 3>> va{};
  std::optional<Vec<S, 3>> vb{};
  std::vector<S> a{};
  std::vector<S> b{};
  std::optional<Vec<S, 3>> v{};
};

namespace detail {

template <ExactField S>
std::optional<S> read_optional(const Value& root, std::string_view key) {
  const std::optional<Value> value = root.find(key);
  return value ? std::optional<S>(value->number<S>()) : std::nullopt;
}

template <ExactField S>
std::optional<S> read_nonzero(const Value& root, std::string_view key) {
  const std::optional<S> number = read_optional<S>(root, key);
  if (number && definitely(is_zero(*number))) root.at(key).expected("a value that is not zero");
  return number;
}

template <ExactField S>
std::optional<Vec<S, 3>> read_optional_point(const Value& root, std::string_view key) {
  const std::optional<Value> value = root.find(key);
  return value ? std::optional<Vec<S, 3>>(read_point<S>(*value)) : std::nullopt;
}

/// Bernstein coefficients of a polynomial; none where the key is absent.
template <ExactField S>
std::vector<S> read_polynomial(const Value& root, std::string_view key) {
  const std::optional<Value> value = root.find(key);
  if (!value) return {};
  const std::size_t count = value->items().size();
  if (count < 1 || count > static_cast<std::size_t>(limits::degree) + 1) {
    value->expected("1 to " + std::to_string(limits::degree + 1) + " Bernstein coefficients");
  }
  return read_numbers<S>(*value);
}

inline const MethodKeys& find_method(const Value& method) {
  std::string names;
  for (const MethodKeys& keys : method_keys()) {
    if (keys.method == method.string()) return keys;
    names += (names.empty() ? "" : ", ") + std::string(keys.method);
  }
  method.expected("one of the methods " + names);
}

}  // namespace detail

/// Reads {"torse": 1, "type": "construct", "method", "degree", "c": {"points", "weights"?}, ...} with the keys of its
/// method, no more and no fewer. Throws FileError.
template <ExactField S>
ConstructFile<S> read_construct(const Document& document) {
  require_type(document, "construct");
  const Value root = document.root();
  const MethodKeys& method = detail::find_method(root.at("method"));
  std::vector<std::string_view> keys{"torse", "type", "method", "degree", "c"};
  keys.insert(keys.end(), method.needed.begin(), method.needed.end());
  keys.insert(keys.end(), method.optional.begin(), method.optional.end());
  root.expect_keys(keys);
  for (std::string_view key : method.needed) root.at(key);

  const Value c = root.at("c");
  c.expect_keys({"points", "weights"});
  WeightedPoints<S, 3> net = detail::read_net<S>(c);
  if (!method.weights && !unit_weights(net)) {
    c.at("weights").fail("expected weights 1 for the method " + std::string(method.method) + ", found others");
  }
  KnotList<S> knots = detail::read_knots<S>(document, root, c.at("points"), static_cast<int>(net.points.size()));
  return {.method = std::string(method.method),
          .knots = std::move(knots),
          .c = std::move(net),
          .lambda = detail::read_optional<S>(root, "Lambda"),
          .m = detail::read_optional<S>(root, "M"),
          .sigma = detail::read_nonzero<S>(root, "sigma"),
          .omega0 = detail::read_nonzero<S>(root, "omega0"),
          .d0 = detail::read_optional_point<S>(root, "d0"),
          .va = detail::read_optional_point<S>(root, "va"),
          .vb = detail::read_optional_point<S>(root, "vb"),
          .a = detail::read_polynomial<S>(root, "a"),
          .b = detail::read_polynomial<S>(root, "b"),
          .v = detail::read_optional_point<S>(root, "v")};
}

}  // namespace torse
