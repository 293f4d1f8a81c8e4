// Polynomials over Q: common denominators, and greatest common divisors by FLINT's modular and heuristic algorithms.
#include "torse/exact/rational/rational.hpp"

#include <gmp.h>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>

namespace torse {
namespace {

/// A polynomial over Q.
class FlintPolynomial {
 public:
  FlintPolynomial() { fmpq_poly_init(f_); }
  explicit FlintPolynomial(const std::vector<Rational>& coefficients) : FlintPolynomial() {
    fmpq_t x;
    fmpq_init(x);
    for (std::size_t i = coefficients.size(); i-- > 0;) {
      fmpq_set_mpq(x, coefficients[i].mpq());
      fmpq_poly_set_coeff_fmpq(f_, static_cast<slong>(i), x);
    }
    fmpq_clear(x);
  }
  FlintPolynomial(const FlintPolynomial&) = delete;
  FlintPolynomial& operator=(const FlintPolynomial&) = delete;
  ~FlintPolynomial() { fmpq_poly_clear(f_); }

  fmpq_poly_struct* get() { return f_; }

  std::vector<Rational> coefficients() const {
    std::vector<Rational> result;
    fmpq_t x;
    mpq_t m;
    fmpq_init(x);
    mpq_init(m);
    for (slong i = 0; i < fmpq_poly_length(f_); ++i) {
      fmpq_poly_get_coeff_fmpq(x, f_, i);
      fmpq_get_mpq(m, x);
      result.push_back(Rational::from_mpq(m));
    }
    mpq_clear(m);
    fmpq_clear(x);
    return result;
  }

 private:
  fmpq_poly_t f_;
};

}  // namespace

Rational ScalarTraits<Rational>::common_denominator(const std::vector<Rational>& list) {
  mpq_t common;
  mpq_init(common);
  mpz_set_ui(mpq_numref(common), 1);
  for (const Rational& x : list) mpz_lcm(mpq_numref(common), mpq_numref(common), mpq_denref(x.mpq()));
  const Rational result = Rational::from_mpq(common);
  mpq_clear(common);
  return result;
}

std::vector<Rational> ScalarTraits<Rational>::polynomial_gcd(const std::vector<Rational>& f,
                                                             const std::vector<Rational>& g) {
  FlintPolynomial x(f);
  FlintPolynomial y(g);
  fmpq_poly_gcd(x.get(), x.get(), y.get());
  return x.coefficients();
}

}  // namespace torse
