// An owned FLINT polynomial over Z.
//   IntegerPolynomial      fmpz_poly_t with a lifetime
//   square_free            the primitive square-free part of a polynomial over Q
#pragma once

#include <gmp.h>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {

/// An fmpz_poly_t that is initialised, moved and cleared; FLINT's functions work on get().
class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(f_); }
  IntegerPolynomial(IntegerPolynomial&& other) noexcept : IntegerPolynomial() { fmpz_poly_swap(f_, other.f_); }
  IntegerPolynomial& operator=(IntegerPolynomial&& other) noexcept {
    fmpz_poly_swap(f_, other.f_);
    return *this;
  }
  ~IntegerPolynomial() { fmpz_poly_clear(f_); }

  fmpz_poly_struct* get() { return f_; }
  const fmpz_poly_struct* get() const { return f_; }
  slong degree() const { return fmpz_poly_degree(f_); }
  const fmpz* coefficient(slong i) const { return f_->coeffs + i; }

 private:
  fmpz_poly_t f_;
};

/// The primitive polynomial over Z whose roots are those of sum_i coefficients[i] x^i, each once. It is not zero.
inline IntegerPolynomial square_free(const std::vector<Rational>& coefficients) {
  fmpq_poly_t rational;
  fmpq_poly_init(rational);
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_mpq(x, coefficients[i].mpq());
    fmpq_poly_set_coeff_fmpq(rational, static_cast<slong>(i), x);
    fmpq_clear(x);
  }
  IntegerPolynomial f;
  fmpq_poly_get_numerator(f.get(), rational);
  fmpq_poly_clear(rational);

  IntegerPolynomial derivative;
  IntegerPolynomial common;
  fmpz_poly_derivative(derivative.get(), f.get());
  fmpz_poly_gcd(common.get(), f.get(), derivative.get());
  if (common.degree() > 0) fmpz_poly_div(f.get(), f.get(), common.get());
  fmpz_poly_primitive_part(f.get(), f.get());
  return f;
}

}  // namespace torse
