// Real numbers as balls of a fixed precision: every result encloses the exact one.
//   Ball<Bits>     a real field with three-valued predicates
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "torse/exact/ball/arb_ball.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// A ball [midpoint +/- radius] whose midpoint carries Bits bits. Division by a ball that contains zero gives a ball
/// that is not finite (it contains everything and decides nothing); division by exactly zero throws DivisionByZero.
template <int Bits>
requires(Bits >= 2) class Ball {
 public:
  /// Exactly zero.
  Ball() = default;

  /// The integer i, exactly.
  template <std::integral T>
  explicit Ball(T i) {
    if constexpr (std::signed_integral<T>) {
      ball_.set_integer(static_cast<std::int64_t>(i));
    } else {
      ball_.set_integer(static_cast<std::uint64_t>(i));
    }
  }

  /// An enclosure of the rational number "p/q" or "p". Throws InvalidInput for another text, DivisionByZero for q = 0.
  static Ball rational(std::string_view text) {
    Ball x;
    x.ball_.set_rational(text, Bits);
    return x;
  }

  /// The hull of [low, high]. Throws InvalidInput unless low <= high are finite.
  static Ball interval(double low, double high) {
    Ball x;
    x.ball_.set_interval(low, high, Bits);
    return x;
  }

  Ball& operator+=(const Ball& x) { return set(&ArbBall::set_sum, *this, x); }
  Ball& operator-=(const Ball& x) { return set(&ArbBall::set_difference, *this, x); }
  Ball& operator*=(const Ball& x) { return set(&ArbBall::set_product, *this, x); }
  Ball& operator/=(const Ball& x) { return set(&ArbBall::set_quotient, *this, x); }

  friend Ball operator+(const Ball& x, const Ball& y) { return Ball().set(&ArbBall::set_sum, x, y); }
  friend Ball operator-(const Ball& x, const Ball& y) { return Ball().set(&ArbBall::set_difference, x, y); }
  friend Ball operator*(const Ball& x, const Ball& y) { return Ball().set(&ArbBall::set_product, x, y); }
  friend Ball operator/(const Ball& x, const Ball& y) { return Ball().set(&ArbBall::set_quotient, x, y); }
  friend Ball operator-(Ball x) {
    x.ball_.set_negative(x.ball_);
    return x;
  }

  bool contains_zero() const { return ball_.contains_zero(); }
  /// Whether the rational number "p/q" or "p" is inside. Throws as `rational` does.
  bool contains(std::string_view text) const { return ball_.contains_rational(text); }
  bool is_finite() const { return ball_.is_finite(); }
  /// The midpoint, rounded to nearest.
  double midpoint() const { return ball_.midpoint(); }
  /// The radius.
  double radius() const { return ball_.radius(); }

 private:
  friend struct ScalarTraits<Ball>;
  using Operation = void (ArbBall::*)(const ArbBall&, const ArbBall&, int);

  Ball& set(Operation operation, const Ball& x, const Ball& y) {
    (ball_.*operation)(x.ball_, y.ball_, Bits);
    return *this;
  }

  ArbBall ball_;
};

template <int Bits>
struct ScalarTraits<Ball<Bits>> {
  static constexpr std::string_view name = "ball";
  static constexpr bool exact = false;
  static constexpr bool decided = false;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;

  static Ball<Bits> from_int(std::int64_t i) { return Ball<Bits>(i); }
  static Truth is_zero(const Ball<Bits>& x) { return x.ball_.is_zero(); }
  static Truth less(const Ball<Bits>& x, const Ball<Bits>& y) { return ArbBall::less(x.ball_, y.ball_); }
  /// Not finite where x contains a negative number.
  static Ball<Bits> sqrt(const Ball<Bits>& x) {
    Ball<Bits> root;
    root.ball_.set_square_root(x.ball_, Bits);
    return root;
  }
  static void add_product(Ball<Bits>& y, const Ball<Bits>& a, const Ball<Bits>& b) {
    y.ball_.add_product(a.ball_, b.ball_, Bits);
  }
  static std::string text(const Ball<Bits>& x) { return x.ball_.text(Bits * 3 / 10 + 1); }
};

}  // namespace torse
