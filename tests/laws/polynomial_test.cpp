// S[t] obeys the laws of a ring and S(t) those of a field.
#include "torse/algebra/polynomial_fraction.hpp"

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

template <>
struct Samples<Polynomial<Rational>> : DyadicSamples<Polynomial<Rational>> {
  static constexpr int rounds = 60;

  static Polynomial<Rational> any(Rng& rng) {
    std::vector<Rational> a;
    for (std::int64_t i = integer(rng, 0, 4); i > 0; --i) a.push_back(FractionSamples<Rational>::any(rng));
    return Polynomial<Rational>(std::move(a));
  }
};

template <>
struct Samples<PolynomialFraction<Rational>> : DyadicSamples<PolynomialFraction<Rational>> {
  static constexpr int rounds = 60;

  static PolynomialFraction<Rational> any(Rng& rng) {
    const Polynomial<Rational> f = Samples<Polynomial<Rational>>::any(rng), g = Samples<Polynomial<Rational>>::any(rng);
    return g.zero() ? PolynomialFraction<Rational>(f) : PolynomialFraction<Rational>(f, g);
  }
  static PolynomialFraction<Rational> unit(Rng& rng) {
    const PolynomialFraction<Rational> x = any(rng);
    return definitely(is_zero(x)) ? PolynomialFraction<Rational>(1) : x;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Polynomial, RingLaws, Polynomial<Rational>, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(PolynomialFraction, RingLaws, PolynomialFraction<Rational>, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(PolynomialFraction, FieldLaws, PolynomialFraction<Rational>, ScalarName);

}  // namespace torse::laws
