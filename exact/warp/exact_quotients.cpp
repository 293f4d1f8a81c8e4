// Exact quotients: integer multiples, limits by real roots, powers of 4.
#include "torse/exact/warp/exact_quotients.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "torse/exact/roots/real_roots.hpp"

namespace torse {
namespace {

constexpr long none = std::numeric_limits<long>::min();

/// log2 of the largest coefficient, but for one or two; `none` for the form 0.
long log2_of(const BinaryForm<Rational>& f) {
  long most = none;
  for (int i = 0; i <= f.degree(); ++i) {
    if (f[i].sign() == 0) continue;
    most = std::max(most, static_cast<long>(f[i].numerator_bits()) - static_cast<long>(f[i].denominator_bits()));
  }
  return most;
}

}  // namespace

FormVector<Rational> with_integers(FormVector<Rational> v) {
  std::vector<Rational> all;
  for (const BinaryForm<Rational>& f : v) {
    for (int i = 0; i <= f.degree(); ++i) all.push_back(f[i]);
  }
  const Rational factor = ScalarTraits<Rational>::common_denominator(all);
  for (BinaryForm<Rational>& f : v) f = factor * f;
  return v;
}

bool nowhere_above(const SineForms<Rational>& forms, const Rational& limit) {
  const BinaryForm<Rational> gap = limit * forms.denominator - forms.numerator;
  if (definitely(gap.zero())) return true;
  constexpr int root_bits = 20;
  std::vector<Rational> coefficients(static_cast<std::size_t>(gap.degree()) + 1);
  for (int i = 0; i <= gap.degree(); ++i) coefficients[static_cast<std::size_t>(i)] = gap[i];
  // In x = t / s of [0, infinity]: one test point before, between and after the roots.
  std::vector<Rational> tests;
  Rational from(0);
  for (const RealRoot& root : real_roots(coefficients, root_bits)) {
    if (root.upper.sign() <= 0) continue;
    tests.push_back((from + root.lower) / Rational(2));
    from = root.upper;
  }
  tests.push_back(from + Rational(1));
  return std::ranges::all_of(tests, [&](const Rational& x) { return gap(Rational(1), x).sign() >= 0; });
}

long scale_for(const std::vector<SineForms<Rational>>& forms) {
  constexpr long near_underflow = -800;
  long most = none;
  for (const SineForms<Rational>& f : forms) {
    if (!definitely(f.numerator.zero())) most = std::max(most, log2_of(f.numerator) - log2_of(f.denominator));
  }
  return most == none || most > near_underflow ? 0 : -most / 2;
}

SineForms<Rational> scaled(const SineForms<Rational>& forms, long exponent) {
  Rational power(1);
  const Rational base = exponent < 0 ? Rational(1) / Rational(4) : Rational(4);
  for (long i = 0; i < std::abs(exponent); ++i) power *= base;
  return {power * forms.numerator, forms.denominator};
}

}  // namespace torse
