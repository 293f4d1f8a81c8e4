// Root isolation by Arb: the complex roots of the square-free part, among which real ones are certified as such.
#include "torse/exact/roots/real_roots.hpp"

#include <gmp.h>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include <acb.h>
#include <arb_fmpz_poly.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace torse {
namespace {

/// An integer polynomial.
class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(f_); }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(f_); }

  fmpz_poly_struct* get() { return f_; }

 private:
  fmpz_poly_t f_;
};

/// Complex balls.
class Balls {
 public:
  explicit Balls(slong size) : size_(size), balls_(_acb_vec_init(size)) {}
  Balls(const Balls&) = delete;
  Balls& operator=(const Balls&) = delete;
  ~Balls() { _acb_vec_clear(balls_, size_); }

  acb_ptr get() { return balls_; }

 private:
  slong size_;
  acb_ptr balls_;
};

/// The primitive square-free part of sum_i coefficients[i] x^i.
void set_square_free(IntegerPolynomial& f, const std::vector<Rational>& coefficients) {
  fmpq_poly_t rational;
  fmpq_poly_init(rational);
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_mpq(x, coefficients[i].mpq());
    fmpq_poly_set_coeff_fmpq(rational, static_cast<slong>(i), x);
    fmpq_clear(x);
  }
  fmpq_poly_get_numerator(f.get(), rational);
  fmpq_poly_clear(rational);

  IntegerPolynomial derivative;
  IntegerPolynomial common;
  fmpz_poly_derivative(derivative.get(), f.get());
  fmpz_poly_gcd(common.get(), f.get(), derivative.get());
  if (fmpz_poly_degree(common.get()) > 0) fmpz_poly_div(f.get(), f.get(), common.get());
  fmpz_poly_primitive_part(f.get(), f.get());
}

Rational from_arf(const arf_t x) {
  fmpq_t q;
  mpq_t m;
  fmpq_init(q);
  mpq_init(m);
  arf_get_fmpq(q, x);
  fmpq_get_mpq(m, q);
  const Rational result = Rational::from_mpq(m);
  mpq_clear(m);
  fmpq_clear(q);
  return result;
}

/// The ball as an interval, rounded outwards to the precision, so that its ends are short numbers.
RealRoot interval_of(const arb_t x, slong precision) {
  arf_t lower, upper;
  arb_t rounded;
  arf_init(lower);
  arf_init(upper);
  arb_init(rounded);
  arb_set_round(rounded, x, precision);
  arb_get_lbound_arf(lower, rounded, ARF_PREC_EXACT);
  arb_get_ubound_arf(upper, rounded, ARF_PREC_EXACT);
  RealRoot root{from_arf(lower), from_arf(upper)};
  arb_clear(rounded);
  arf_clear(lower);
  arf_clear(upper);
  return root;
}

/// The rational root p/q in the ball x, if there is one: q divides the leading coefficient a, so a x is an integer.
/// None, too, where the ball a x is too wide to tell; `open` says so.
std::optional<Rational> rational_root(IntegerPolynomial& f, const arb_t x, slong precision, bool& open) {
  std::optional<Rational> result;
  arb_t scaled;
  fmpz_t numerator;
  arb_init(scaled);
  fmpz_init(numerator);
  const fmpz* leading = fmpz_poly_lead(f.get());
  arb_mul_fmpz(scaled, x, leading, precision);
  if (arb_get_unique_fmpz(numerator, scaled)) {
    fmpq_t candidate, value;
    mpq_t m;
    fmpq_init(candidate);
    fmpq_init(value);
    mpq_init(m);
    fmpq_set_fmpz_frac(candidate, numerator, leading);
    fmpz_poly_evaluate_fmpq(value, f.get(), candidate);
    if (fmpq_is_zero(value)) {
      fmpq_get_mpq(m, candidate);
      result = Rational::from_mpq(m);
    }
    mpq_clear(m);
    fmpq_clear(value);
    fmpq_clear(candidate);
  } else {
    open = open || arb_contains_int(scaled);
  }
  fmpz_clear(numerator);
  arb_clear(scaled);
  return result;
}

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

bool narrow(const RealRoot& root, const Rational& tolerance) {
  const Rational smaller = std::min(magnitude(root.lower), magnitude(root.upper));
  return root.lower.sign() == root.upper.sign() && root.upper - root.lower <= tolerance * smaller;
}

/// The roots at one precision, or none if that does not settle all of them.
std::optional<std::vector<RealRoot>> roots_at(IntegerPolynomial& f, slong precision, const Rational& tolerance) {
  const slong degree = fmpz_poly_degree(f.get());
  Balls balls(degree);
  arb_fmpz_poly_complex_roots(balls.get(), f.get(), 0, precision);
  std::vector<RealRoot> roots;
  for (slong i = 0; i < degree; ++i) {
    const acb_ptr z = balls.get() + i;
    if (!arb_is_zero(acb_imagref(z))) continue;
    bool open = false;
    if (const std::optional<Rational> exact = rational_root(f, acb_realref(z), precision, open)) {
      roots.push_back({*exact, *exact});
      continue;
    }
    RealRoot root = interval_of(acb_realref(z), precision);
    if (open || root.rational() || !narrow(root, tolerance)) return std::nullopt;
    roots.push_back(std::move(root));
  }
  std::ranges::sort(roots, {}, &RealRoot::lower);
  for (std::size_t i = 1; i < roots.size(); ++i) {
    if (roots[i].lower <= roots[i - 1].upper) return std::nullopt;
  }
  return roots;
}

}  // namespace

std::vector<RealRoot> real_roots(const std::vector<Rational>& coefficients, int bits) {
  if (std::ranges::all_of(coefficients, [](const Rational& x) { return x.sign() == 0; })) {
    throw InvalidInput("coefficients", "expected a polynomial that is not zero");
  }
  IntegerPolynomial f;
  set_square_free(f, coefficients);
  if (fmpz_poly_degree(f.get()) == 0) return {};
  Rational tolerance(1);
  for (int i = 0; i < bits; ++i) tolerance /= Rational(2);
  for (slong precision = bits + 16;; precision *= 2) {
    if (std::optional<std::vector<RealRoot>> roots = roots_at(f, precision, tolerance)) return *std::move(roots);
  }
}

}  // namespace torse
