// Greatest common divisors through FLINT, in the parameter x = t / s: the divisors s^k of the forms are the degrees
// that the polynomials in x lack.
#include "torse/exact/warp/common_factor.hpp"

#include <gmp.h>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>

#include <algorithm>

namespace torse {
namespace {

/// A polynomial over Q.
class Polynomial {
 public:
  Polynomial() { fmpq_poly_init(f_); }
  explicit Polynomial(const BinaryForm<Rational>& form) : Polynomial() {
    fmpq_t x;
    fmpq_init(x);
    for (int i = 0; i <= form.degree(); ++i) {
      fmpq_set_mpq(x, form[i].mpq());
      fmpq_poly_set_coeff_fmpq(f_, i, x);
    }
    fmpq_clear(x);
  }
  Polynomial(const Polynomial&) = delete;
  Polynomial& operator=(const Polynomial&) = delete;
  ~Polynomial() { fmpq_poly_clear(f_); }

  fmpq_poly_struct* get() { return f_; }
  /// -1 for zero.
  int degree() const { return static_cast<int>(fmpq_poly_degree(f_)); }

  /// The coefficients of 1, x, ..., x^degree, zeros beyond the polynomial's own.
  std::vector<Rational> coefficients(int degree) const {
    std::vector<Rational> list;
    fmpq_t x;
    mpq_t m;
    fmpq_init(x);
    mpq_init(m);
    for (int i = 0; i <= degree; ++i) {
      fmpq_poly_get_coeff_fmpq(x, f_, i);
      fmpq_get_mpq(m, x);
      list.push_back(Rational::from_mpq(m));
    }
    mpq_clear(m);
    fmpq_clear(x);
    return list;
  }

 private:
  fmpq_poly_t f_;
};

/// The coefficients of f / g as a form of the degree, which is at least that of the quotient.
BinaryForm<Rational> quotient(Polynomial& f, Polynomial& g, int degree) {
  Polynomial rest;
  fmpq_poly_div(rest.get(), f.get(), g.get());
  return BinaryForm<Rational>(rest.coefficients(degree));
}

}  // namespace

VectorWithZeros without_common_zeros(const FormVector<Rational>& v) {
  const int degree = v[0].degree();
  std::array<Polynomial, 3> f{Polynomial(v[0]), Polynomial(v[1]), Polynomial(v[2])};
  const int most = std::max({f[0].degree(), f[1].degree(), f[2].degree()});
  if (most < 0) throw InvalidInput("vector", "expected a vector that is not identically zero");
  Polynomial common;
  for (Polynomial& component : f) fmpq_poly_gcd(common.get(), common.get(), component.get());

  VectorWithZeros result{{}, BinaryForm<Rational>(common.coefficients(degree - most + common.degree()))};
  for (std::size_t j = 0; j < 3; ++j) result.direction[j] = quotient(f[j], common, most - common.degree());
  return result;
}

std::vector<RealRoot> zeros_in_unit_interval(const BinaryForm<Rational>& form) {
  constexpr int root_bits = 40;
  Polynomial f(form);
  std::vector<RealRoot> zeros;
  for (const RealRoot& x : real_roots(f.coefficients(f.degree()), root_bits)) {
    const auto parameter = [](const Rational& r) { return r / (Rational(1) + r); };
    if (x.lower.sign() >= 0) zeros.push_back({parameter(x.lower), parameter(x.upper)});
  }
  if (f.degree() < form.degree()) zeros.push_back({Rational(1), Rational(1)});
  return zeros;
}

SineForms<Rational> in_lowest_terms(const SineForms<Rational>& forms) {
  Polynomial numerator(forms.numerator);
  Polynomial denominator(forms.denominator);
  Polynomial common;
  fmpq_poly_gcd(common.get(), numerator.get(), denominator.get());
  const int degree = std::max(numerator.degree(), denominator.degree()) - common.degree();
  return {quotient(numerator, common, degree), quotient(denominator, common, degree)};
}

}  // namespace torse
