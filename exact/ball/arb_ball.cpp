// Balls through Arb. The C headers stay in this file: FLINT defines macros with short lower-case names.
#include "torse/exact/ball/arb_ball.hpp"

#include <gmp.h>

#include <flint/fmpq.h>

#include <arb.h>

#include <cmath>

#include "torse/scalar/errors.hpp"

namespace torse {

struct ArbBall::Access {
  static_assert(sizeof(arb_struct) == sizeof(storage_) && alignof(arb_struct) <= 8);

  static arb_struct* arb(ArbBall& x) { return reinterpret_cast<arb_struct*>(x.storage_); }
  static const arb_struct* arb(const ArbBall& x) { return reinterpret_cast<const arb_struct*>(x.storage_); }
};

namespace {

/// The rational number that a text stands for.
class Number {
 public:
  explicit Number(std::string_view text) {
    fmpq_init(value_);
    const bool is_read = fmpq_set_str(value_, std::string(text).c_str(), 10) == 0;
    const bool has_denominator = fmpz_is_zero(fmpq_denref(value_)) == 0;
    if (is_read && has_denominator) {
      fmpq_canonicalise(value_);
      return;
    }
    fmpq_clear(value_);
    if (is_read) throw DivisionByZero();
    throw InvalidInput("number", "'" + std::string(text) + "' is not a rational number");
  }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { fmpq_clear(value_); }

  const fmpq* get() const { return value_; }

 private:
  fmpq_t value_;
};

}  // namespace

ArbBall::ArbBall() { arb_init(Access::arb(*this)); }

ArbBall::ArbBall(const ArbBall& x) : ArbBall() { arb_set(Access::arb(*this), Access::arb(x)); }

ArbBall::ArbBall(ArbBall&& x) noexcept : ArbBall() { arb_swap(Access::arb(*this), Access::arb(x)); }

ArbBall& ArbBall::operator=(const ArbBall& x) {
  arb_set(Access::arb(*this), Access::arb(x));
  return *this;
}

ArbBall& ArbBall::operator=(ArbBall&& x) noexcept {
  arb_swap(Access::arb(*this), Access::arb(x));
  return *this;
}

ArbBall::~ArbBall() { arb_clear(Access::arb(*this)); }

void ArbBall::set_integer(std::int64_t i) { arb_set_si(Access::arb(*this), i); }

void ArbBall::set_integer(std::uint64_t i) { arb_set_ui(Access::arb(*this), i); }

void ArbBall::set_rational(std::string_view text, int bits) {
  arb_set_fmpq(Access::arb(*this), Number(text).get(), bits);
}

void ArbBall::set_interval(double low, double high, int bits) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high) {
    throw InvalidInput("interval", "expected finite ends in increasing order");
  }
  arf_t from;
  arf_t to;
  arf_init(from);
  arf_init(to);
  arf_set_d(from, low);
  arf_set_d(to, high);
  arb_set_interval_arf(Access::arb(*this), from, to, bits);
  arf_clear(from);
  arf_clear(to);
}

void ArbBall::set_sum(const ArbBall& x, const ArbBall& y, int bits) {
  arb_add(Access::arb(*this), Access::arb(x), Access::arb(y), bits);
}

void ArbBall::set_difference(const ArbBall& x, const ArbBall& y, int bits) {
  arb_sub(Access::arb(*this), Access::arb(x), Access::arb(y), bits);
}

void ArbBall::set_product(const ArbBall& x, const ArbBall& y, int bits) {
  arb_mul(Access::arb(*this), Access::arb(x), Access::arb(y), bits);
}

void ArbBall::set_quotient(const ArbBall& x, const ArbBall& y, int bits) {
  if (arb_is_zero(Access::arb(y)) != 0) throw DivisionByZero();
  arb_div(Access::arb(*this), Access::arb(x), Access::arb(y), bits);
}

void ArbBall::set_negative(const ArbBall& x) { arb_neg(Access::arb(*this), Access::arb(x)); }

void ArbBall::set_square_root(const ArbBall& x, int bits) { arb_sqrt(Access::arb(*this), Access::arb(x), bits); }

void ArbBall::add_product(const ArbBall& x, const ArbBall& y, int bits) {
  arb_addmul(Access::arb(*this), Access::arb(x), Access::arb(y), bits);
}

bool ArbBall::contains_zero() const { return arb_contains_zero(Access::arb(*this)) != 0; }

bool ArbBall::contains_rational(std::string_view text) const {
  return arb_contains_fmpq(Access::arb(*this), Number(text).get()) != 0;
}

bool ArbBall::is_finite() const { return arb_is_finite(Access::arb(*this)) != 0; }

Truth ArbBall::is_zero() const {
  if (arb_is_zero(Access::arb(*this)) != 0) return Truth::yes;
  return contains_zero() ? Truth::unknown : Truth::no;
}

Truth ArbBall::less(const ArbBall& x, const ArbBall& y) {
  if (arb_lt(Access::arb(x), Access::arb(y)) != 0) return Truth::yes;
  return arb_ge(Access::arb(x), Access::arb(y)) != 0 ? Truth::no : Truth::unknown;
}

double ArbBall::midpoint() const { return arf_get_d(arb_midref(Access::arb(*this)), ARF_RND_NEAR); }

double ArbBall::radius() const { return mag_get_d(arb_radref(Access::arb(*this))); }

std::string ArbBall::text(int digits) const {
  char* const buffer = arb_get_str(Access::arb(*this), digits, 0);
  std::string result(buffer);
  flint_free(buffer);
  return result;
}

}  // namespace torse
