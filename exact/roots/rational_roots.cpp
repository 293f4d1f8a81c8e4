// Roots modulo primes, and their lifting.
#include "torse/exact/roots/rational_roots.hpp"

#include <flint/fmpz.h>
#include <flint/nmod_poly.h>
#include <flint/nmod_poly_factor.h>
#include <flint/ulong_extras.h>

#include <optional>

namespace torse {
namespace {

/// An owned FLINT integer.
class Fmpz {
 public:
  Fmpz() { fmpz_init(x_); }
  explicit Fmpz(ulong value) { fmpz_init_set_ui(x_, value); }
  Fmpz(const Fmpz&) = delete;
  Fmpz& operator=(const Fmpz&) = delete;
  ~Fmpz() { fmpz_clear(x_); }
  fmpz* get() { return x_; }

 private:
  fmpz_t x_;
};

/// The roots of f modulo p; none if p divides the leading coefficient or the discriminant.
std::optional<std::vector<ulong>> roots_modulo(const IntegerPolynomial& f, ulong p) {
  nmod_poly_t image, derivative, common;
  nmod_poly_init(image, p);
  nmod_poly_init(derivative, p);
  nmod_poly_init(common, p);
  fmpz_poly_get_nmod_poly(image, f.get());
  nmod_poly_derivative(derivative, image);
  nmod_poly_gcd(common, image, derivative);
  std::optional<std::vector<ulong>> roots;
  if (nmod_poly_degree(image) == f.degree() && nmod_poly_degree(common) == 0) {
    roots.emplace();
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_roots(factors, image, 0);
    for (slong i = 0; i < factors->num; ++i) {
      roots->push_back(nmod_neg(nmod_poly_get_coeff_ui(factors->p + i, 0), image->mod));
    }
    nmod_poly_factor_clear(factors);
  }
  nmod_poly_clear(common);
  nmod_poly_clear(derivative);
  nmod_poly_clear(image);
  return roots;
}

struct ResidueRoots {
  ulong prime;
  std::vector<ulong> roots;
};

/// The roots modulo a prime where they are few: all have the rational roots, many have no other.
ResidueRoots fewest_roots(const IntegerPolynomial& f) {
  constexpr int primes = 12;
  std::optional<ResidueRoots> best;
  ulong p = ulong{1} << 40;
  for (int used = 0; used < primes;) {
    p = n_nextprime(p, 1);
    std::optional<std::vector<ulong>> roots = roots_modulo(f, p);
    if (!roots) continue;
    ++used;
    if (!best || roots->size() < best->roots.size()) best = ResidueRoots{p, *std::move(roots)};
    if (best->roots.empty()) break;
  }
  return *std::move(best);
}

/// Whether the fraction x is a root of f, which is not 0 at 0.
bool is_root(const IntegerPolynomial& f, const fmpq_t x) {
  if (fmpz_is_zero(fmpq_numref(x)) || !fmpz_divisible(f.coefficient(f.degree()), fmpq_denref(x)) ||
      !fmpz_divisible(f.coefficient(0), fmpq_numref(x))) {
    return false;
  }
  fmpq_t value;
  fmpq_init(value);
  fmpz_poly_evaluate_fmpq(value, f.get(), x);
  const bool zero = fmpq_is_zero(value) != 0;
  fmpq_clear(value);
  return zero;
}

/// f /= (denominator x - numerator).
void divide_out(IntegerPolynomial& f, const fmpq_t x) {
  IntegerPolynomial factor;
  fmpz_poly_set_coeff_fmpz(factor.get(), 1, fmpq_denref(x));
  Fmpz constant;
  fmpz_neg(constant.get(), fmpq_numref(x));
  fmpz_poly_set_coeff_fmpz(factor.get(), 0, constant.get());
  fmpz_poly_div(f.get(), f.get(), factor.get());
}

/// One step: from a root modulo m to that modulo m^2.
void lift(const IntegerPolynomial& f, const IntegerPolynomial& derivative, fmpz* root, fmpz* m) {
  Fmpz value, slope;
  fmpz_mul(m, m, m);
  IntegerPolynomial reduced;
  fmpz_poly_scalar_mod_fmpz(reduced.get(), f.get(), m);
  const auto evaluate = [&](const IntegerPolynomial& g, fmpz* y) {
    fmpz_zero(y);
    for (slong i = g.degree(); i >= 0; --i) {
      fmpz_mul(y, y, root);
      fmpz_add(y, y, g.coefficient(i));
      fmpz_mod(y, y, m);
    }
  };
  evaluate(reduced, value.get());
  fmpz_poly_scalar_mod_fmpz(reduced.get(), derivative.get(), m);
  evaluate(reduced, slope.get());
  fmpz_invmod(slope.get(), slope.get(), m);
  fmpz_submul(root, value.get(), slope.get());
  fmpz_mod(root, root, m);
}

/// The rational root of f over a root modulo p, if there is one; f loses it.
std::optional<Rational> rational_root_over(IntegerPolynomial& f, ulong residue, ulong p) {
  Fmpz most_numerator, most_denominator;
  fmpz_abs(most_numerator.get(), f.coefficient(0));
  fmpz_abs(most_denominator.get(), f.coefficient(f.degree()));
  const flint_bitcnt_t bits = fmpz_bits(most_numerator.get()) + fmpz_bits(most_denominator.get()) + 2;
  IntegerPolynomial derivative;
  fmpz_poly_derivative(derivative.get(), f.get());
  Fmpz root(residue), m(p);
  std::optional<Rational> found;
  fmpq_t x;
  fmpq_init(x);
  for (;;) {
    const bool last = fmpz_bits(m.get()) > bits;
    const int known =
        last ? fmpq_reconstruct_fmpz_2(x, root.get(), m.get(), most_numerator.get(), most_denominator.get())
             : fmpq_reconstruct_fmpz(x, root.get(), m.get());
    if (known != 0 && is_root(f, x)) {
      divide_out(f, x);
      mpq_t q;
      mpq_init(q);
      fmpq_get_mpq(q, x);
      found = Rational::from_mpq(q);
      mpq_clear(q);
      break;
    }
    if (last) break;
    lift(f, derivative, root.get(), m.get());
  }
  fmpq_clear(x);
  return found;
}

}  // namespace

std::vector<Rational> divide_out_rational_roots(IntegerPolynomial& f) {
  std::vector<Rational> found;
  if (f.degree() > 0 && fmpz_is_zero(f.coefficient(0))) {
    fmpz_poly_shift_right(f.get(), f.get(), 1);
    found.emplace_back(0);
  }
  if (f.degree() < 1) return found;
  const ResidueRoots residues = fewest_roots(f);
  for (const ulong residue : residues.roots) {
    if (std::optional<Rational> root = rational_root_over(f, residue, residues.prime)) {
      found.push_back(*std::move(root));
    }
  }
  return found;
}

}  // namespace torse
