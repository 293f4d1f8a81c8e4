// A real interval as a midpoint and a radius, through Arb's arb_t.
//   ArbBall     the C library's ball behind a value type; every operation is told its precision
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/scalar/truth.hpp"

namespace torse {

/// An Arb ball. Operations set *this to a ball that contains every result of the operation on elements of the operands,
/// which may be *this; midpoints are rounded to `bits` bits.
class ArbBall {
 public:
  /// Exactly zero.
  ArbBall();
  ArbBall(const ArbBall& x);
  ArbBall(ArbBall&& x) noexcept;
  ArbBall& operator=(const ArbBall& x);
  ArbBall& operator=(ArbBall&& x) noexcept;
  ~ArbBall();

  /// The integer i, exactly.
  void set_integer(std::int64_t i);
  void set_integer(std::uint64_t i);

  /// The rational number "p/q" or "p". Throws InvalidInput for another text and DivisionByZero for q = 0.
  void set_rational(std::string_view text, int bits);

  /// The hull of [low, high]. Throws InvalidInput unless low <= high are finite.
  void set_interval(double low, double high, int bits);

  void set_sum(const ArbBall& x, const ArbBall& y, int bits);
  void set_difference(const ArbBall& x, const ArbBall& y, int bits);
  void set_product(const ArbBall& x, const ArbBall& y, int bits);
  /// Not finite where y contains zero; throws DivisionByZero where y is exactly zero.
  void set_quotient(const ArbBall& x, const ArbBall& y, int bits);
  void set_negative(const ArbBall& x);
  /// Not finite where x contains a negative number.
  void set_square_root(const ArbBall& x, int bits);
  void add_product(const ArbBall& x, const ArbBall& y, int bits);

  bool contains_zero() const;
  bool contains_rational(std::string_view text) const;
  bool is_finite() const;
  /// yes: exactly zero; no: zero is outside.
  Truth is_zero() const;
  /// yes: all of x below all of y; no: all of x not below all of y.
  static Truth less(const ArbBall& x, const ArbBall& y);

  /// The midpoint, rounded to nearest.
  double midpoint() const;
  /// The radius; Arb keeps 30 bits of it, so the double is exact unless it overflows or underflows.
  double radius() const;

  /// "[midpoint +/- radius]" with `digits` significant digits.
  std::string text(int digits) const;

 private:
  struct Access;
  alignas(8) std::byte storage_[48];
};

}  // namespace torse
