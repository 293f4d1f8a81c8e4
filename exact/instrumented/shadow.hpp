// A double beside the exact value of the same computation, with a record of every operation.
//   Operation           one of them: operands, rounded and exact result, and the formula that it belongs to
//   RecordScope         the record of this thread while it lives
//   Shadow, ScalarTraits<Shadow>
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// Which entry of which row an operation computes, by which formula.
struct FormulaPlace {
  std::string formula;
  std::string row;
  int index = 0;

  friend bool operator==(const FormulaPlace&, const FormulaPlace&) = default;
};

/// An operation, an input ('=') or a constant ('#').
struct Operation {
  char kind;  ///< = # + - * / or n for a negation
  int left;   ///< the operands' numbers in the record; -1 for none
  int right;
  double value;      ///< what double gives
  Rational exact;    ///< what the same operations give without rounding
  int place;         ///< in RecordScope::places, -1 outside of a formula
  std::string name;  ///< of an input
};

/// Collects the operations on Shadow in this thread while it lives; an inner scope takes over from an outer.
class RecordScope {
 public:
  /// More operations than this throw InvalidInput.
  static constexpr std::size_t most = 1'000'000;

  RecordScope() : outer_(std::exchange(current(), this)) {}
  RecordScope(const RecordScope&) = delete;
  RecordScope& operator=(const RecordScope&) = delete;
  ~RecordScope() { current() = outer_; }

  const std::vector<Operation>& operations() const { return operations_; }
  const std::vector<FormulaPlace>& places() const { return places_; }

  /// Adds an operation and returns its number; -1 where no scope lives.
  static int add(char kind, int left, int right, double value, const Rational& exact, std::string name = {}) {
    RecordScope* const scope = current();
    if (scope == nullptr) return -1;
    if (scope->operations_.size() >= most) throw InvalidInput("operations", "expected a million at most");
    const int place = scope->stack_.empty() ? -1 : scope->stack_.back();
    scope->operations_.push_back({kind, left, right, value, exact, place, std::move(name)});
    return static_cast<int>(scope->operations_.size()) - 1;
  }

  static void enter(std::string_view formula, std::string_view row, int index) {
    if (RecordScope* const scope = current()) {
      scope->places_.push_back({std::string(formula), std::string(row), index});
      scope->stack_.push_back(static_cast<int>(scope->places_.size()) - 1);
    }
  }
  static void leave() {
    if (RecordScope* const scope = current()) scope->stack_.pop_back();
  }

 private:
  static RecordScope*& current() {
    static thread_local RecordScope* scope = nullptr;
    return scope;
  }

  std::vector<Operation> operations_;
  std::vector<FormulaPlace> places_;
  std::vector<int> stack_;
  RecordScope* outer_;
};

/// A double that knows what it should be. Predicates speak of the double, so the computation takes the path that double
/// takes.
class Shadow {
 public:
  /// The constant zero.
  Shadow() : Shadow(0) {}
  /// The constant i.
  template <std::integral T>
  explicit Shadow(T i) : value_(static_cast<double>(i)), exact_(static_cast<long>(i)) {
    number_ = RecordScope::add('#', -1, -1, value_, exact_);
  }

  /// An input: the nearest double to x beside x.
  static Shadow input(std::string name, const Rational& x) {
    const double value = x.to_double();
    return Shadow(value, x, RecordScope::add('=', -1, -1, value, x, std::move(name)));
  }

  double value() const { return value_; }
  const Rational& exact() const { return exact_; }
  /// In the record.
  int number() const { return number_; }

  friend Shadow operator+(const Shadow& a, const Shadow& b) {
    return made('+', a, b, a.value_ + b.value_, a.exact_ + b.exact_);
  }
  friend Shadow operator-(const Shadow& a, const Shadow& b) {
    return made('-', a, b, a.value_ - b.value_, a.exact_ - b.exact_);
  }
  friend Shadow operator*(const Shadow& a, const Shadow& b) {
    return made('*', a, b, a.value_ * b.value_, a.exact_ * b.exact_);
  }
  /// Throws DivisionByZero where the exact divisor is zero.
  friend Shadow operator/(const Shadow& a, const Shadow& b) {
    return made('/', a, b, a.value_ / b.value_, a.exact_ / b.exact_);
  }
  friend Shadow operator-(const Shadow& a) {
    return Shadow(-a.value_, -a.exact_, RecordScope::add('n', a.number_, -1, -a.value_, -a.exact_));
  }
  Shadow& operator+=(const Shadow& b) { return *this = *this + b; }
  Shadow& operator-=(const Shadow& b) { return *this = *this - b; }
  Shadow& operator*=(const Shadow& b) { return *this = *this * b; }
  Shadow& operator/=(const Shadow& b) { return *this = *this / b; }

 private:
  Shadow(double value, Rational exact, int number) : value_(value), exact_(std::move(exact)), number_(number) {}

  static Shadow made(char kind, const Shadow& a, const Shadow& b, double value, Rational exact) {
    const int number = RecordScope::add(kind, a.number_, b.number_, value, exact);
    return Shadow(value, std::move(exact), number);
  }

  double value_;
  Rational exact_;
  int number_;
};

template <>
struct ScalarTraits<Shadow> {
  static constexpr std::string_view name = "shadow";
  static constexpr bool exact = false;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Shadow from_int(std::int64_t i) { return Shadow(i); }
  static Truth is_zero(const Shadow& x) { return truth(x.value() == 0); }
  static Truth less(const Shadow& x, const Shadow& y) { return truth(x.value() < y.value()); }
  static std::string text(const Shadow& x) { return ScalarTraits<double>::text(x.value()); }
  static void enter(std::string_view formula, std::string_view row, int index) {
    RecordScope::enter(formula, row, index);
  }
  static void leave() { RecordScope::leave(); }
};

}  // namespace torse
