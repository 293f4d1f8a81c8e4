// A scalar that counts what an algorithm does.
//   Tally             numbers of operations by kind
//   CountingScope     counts the operations of this thread into a tally while it lives
//   Counting<S>       S with its operations counted
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "torse/scalar/concepts.hpp"

namespace torse {

/// Numbers of operations by kind. A subtraction and a negation count as additions, a fused y += a b as one addition and
/// one multiplication, a zero test as a comparison.
struct Tally {
  std::int64_t additions = 0;
  std::int64_t multiplications = 0;
  std::int64_t divisions = 0;
  std::int64_t comparisons = 0;
  std::int64_t square_roots = 0;

  friend bool operator==(const Tally&, const Tally&) = default;
};

/// While it lives, operations on Counting<S> in this thread add to the tally; an inner scope takes over from an outer.
class CountingScope {
 public:
  explicit CountingScope(Tally& tally) : outer_(std::exchange(current(), &tally)) {}
  CountingScope(const CountingScope&) = delete;
  CountingScope& operator=(const CountingScope&) = delete;
  ~CountingScope() { current() = outer_; }

  /// Adds one to a kind of operation, where a scope lives.
  static void count(std::int64_t Tally::*kind) {
    if (Tally* const tally = current()) ++(tally->*kind);
  }

 private:
  static Tally*& current() {
    static thread_local Tally* tally = nullptr;
    return tally;
  }

  Tally* outer_;
};

/// S with its operations counted.
template <Field S>
class Counting {
 public:
  Counting() : value_(from_int<S>(0)) {}
  template <std::integral T>
  explicit Counting(T i) : value_(from_int<S>(static_cast<std::int64_t>(i))) {}
  explicit Counting(S value) : value_(std::move(value)) {}

  const S& value() const { return value_; }

  Counting& operator+=(const Counting& x) { return apply(&Tally::additions, value_ += x.value_); }
  Counting& operator-=(const Counting& x) { return apply(&Tally::additions, value_ -= x.value_); }
  Counting& operator*=(const Counting& x) { return apply(&Tally::multiplications, value_ *= x.value_); }
  Counting& operator/=(const Counting& x) { return apply(&Tally::divisions, value_ /= x.value_); }

  friend Counting operator+(Counting x, const Counting& y) { return std::move(x += y); }
  friend Counting operator-(Counting x, const Counting& y) { return std::move(x -= y); }
  friend Counting operator*(Counting x, const Counting& y) { return std::move(x *= y); }
  friend Counting operator/(Counting x, const Counting& y) { return std::move(x /= y); }
  friend Counting operator-(const Counting& x) {
    CountingScope::count(&Tally::additions);
    return Counting(S(-x.value_));
  }

  /// y += a b by the means of S.
  void add_product(const Counting& a, const Counting& b) {
    torse::add_product(value_, a.value_, b.value_);
    CountingScope::count(&Tally::additions);
    CountingScope::count(&Tally::multiplications);
  }

 private:
  Counting& apply(std::int64_t Tally::*kind, const S&) {
    CountingScope::count(kind);
    return *this;
  }

  S value_;
};

template <class S>
struct ScalarTraits<Counting<S>> {
  static constexpr std::string_view name = "counting";
  static constexpr bool exact = ScalarTraits<S>::exact;
  static constexpr bool decided = ScalarTraits<S>::decided;
  static constexpr bool ordered = ScalarTraits<S>::ordered;
  static constexpr bool prefers_reciprocal = ScalarTraits<S>::prefers_reciprocal;

  static Counting<S> from_int(std::int64_t i) { return Counting<S>(torse::from_int<S>(i)); }
  static Truth is_zero(const Counting<S>& x) {
    CountingScope::count(&Tally::comparisons);
    return torse::is_zero(x.value());
  }
  static Truth less(const Counting<S>& x, const Counting<S>& y) requires OrderedField<S> {
    CountingScope::count(&Tally::comparisons);
    return torse::less(x.value(), y.value());
  }
  static Counting<S> sqrt(const Counting<S>& x) requires RealField<S> {
    CountingScope::count(&Tally::square_roots);
    return Counting<S>(ScalarTraits<S>::sqrt(x.value()));
  }
  static void add_product(Counting<S>& y, const Counting<S>& a, const Counting<S>& b) { y.add_product(a, b); }
  static auto weight(const Counting<S>& x) requires requires(const S& s) { ScalarTraits<S>::weight(s); }
  { return ScalarTraits<S>::weight(x.value()); }
  static std::string text(const Counting<S>& x) { return as_text(x.value()); }
};

}  // namespace torse
