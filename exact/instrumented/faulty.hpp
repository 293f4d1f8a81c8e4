// A scalar whose k-th operation goes wrong: what no such fault changes is not checked by the test at hand.
//   FaultScope<S>     counts the operations of this thread on Faulty<S> and corrupts the k-th of them
//   Faulty<S>         S with its operations open to a fault
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "torse/scalar/concepts.hpp"

namespace torse {

/// While it lives, operations on Faulty<S> in this thread (+ - * /, negation, square root) are counted, and `error` is
/// added to the result of the operation number `index`, counted from 0. An inner scope takes over from an outer.
template <Field S>
class FaultScope {
 public:
  /// Counts only.
  FaultScope() : FaultScope(std::nullopt, from_int<S>(0)) {}

  /// Corrupts operation `index` by `error`, which should not be zero.
  explicit FaultScope(std::int64_t index, S error = from_int<S>(1))
      : FaultScope(std::optional<std::int64_t>(index), std::move(error)) {}

  FaultScope(const FaultScope&) = delete;
  FaultScope& operator=(const FaultScope&) = delete;
  ~FaultScope() { current() = outer_; }

  /// The number of operations so far.
  std::int64_t operations() const { return operations_; }

  /// Whether the fault has happened.
  bool struck() const { return index_ && *index_ < operations_; }

  /// Passes the result of an operation, corrupted where it is the one.
  static void pass(S& result) {
    FaultScope* const scope = current();
    if (scope != nullptr && scope->operations_++ == scope->index_) result += scope->error_;
  }

 private:
  FaultScope(std::optional<std::int64_t> index, S error)
      : index_(index), error_(std::move(error)), outer_(std::exchange(current(), this)) {}

  static FaultScope*& current() {
    static thread_local FaultScope* scope = nullptr;
    return scope;
  }

  std::optional<std::int64_t> index_;
  S error_;
  std::int64_t operations_ = 0;
  FaultScope* outer_;
};

/// S with its operations open to a fault; made outside of a FaultScope, a value is what it would be in S.
template <Field S>
class Faulty {
 public:
  Faulty() : value_(from_int<S>(0)) {}
  template <std::integral T>
  explicit Faulty(T i) : value_(from_int<S>(static_cast<std::int64_t>(i))) {}
  explicit Faulty(S value) : value_(std::move(value)) {}

  const S& value() const { return value_; }

  Faulty& operator+=(const Faulty& x) { return pass(value_ += x.value_); }
  Faulty& operator-=(const Faulty& x) { return pass(value_ -= x.value_); }
  Faulty& operator*=(const Faulty& x) { return pass(value_ *= x.value_); }
  Faulty& operator/=(const Faulty& x) { return pass(value_ /= x.value_); }

  friend Faulty operator+(Faulty x, const Faulty& y) { return std::move(x += y); }
  friend Faulty operator-(Faulty x, const Faulty& y) { return std::move(x -= y); }
  friend Faulty operator*(Faulty x, const Faulty& y) { return std::move(x *= y); }
  friend Faulty operator/(Faulty x, const Faulty& y) { return std::move(x /= y); }
  friend Faulty operator-(const Faulty& x) {
    S negative = -x.value_;
    FaultScope<S>::pass(negative);
    return Faulty(std::move(negative));
  }

 private:
  Faulty& pass(S& result) {
    FaultScope<S>::pass(result);
    return *this;
  }

  S value_;
};

template <class S>
struct ScalarTraits<Faulty<S>> {
  static constexpr std::string_view name = "faulty";
  static constexpr bool exact = ScalarTraits<S>::exact;
  static constexpr bool decided = ScalarTraits<S>::decided;
  static constexpr bool ordered = ScalarTraits<S>::ordered;
  static constexpr bool prefers_reciprocal = ScalarTraits<S>::prefers_reciprocal;

  static Faulty<S> from_int(std::int64_t i) { return Faulty<S>(torse::from_int<S>(i)); }
  static Truth is_zero(const Faulty<S>& x) { return torse::is_zero(x.value()); }
  static Truth less(const Faulty<S>& x, const Faulty<S>& y) requires OrderedField<S> {
    return torse::less(x.value(), y.value());
  }
  static Faulty<S> sqrt(const Faulty<S>& x) requires RealField<S> {
    S root = ScalarTraits<S>::sqrt(x.value());
    FaultScope<S>::pass(root);
    return Faulty<S>(std::move(root));
  }
  static auto weight(const Faulty<S>& x) requires requires(const S& s) { ScalarTraits<S>::weight(s); }
  { return ScalarTraits<S>::weight(x.value()); }
  static std::string text(const Faulty<S>& x) { return as_text(x.value()); }
};

}  // namespace torse
