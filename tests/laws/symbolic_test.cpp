// Rational functions obey the laws; values against rational arithmetic at random points are the independent path.
#include "torse/exact/symbolic/rational_function.hpp"

#include <string>
#include <vector>

#include "laws/laws.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::laws {

const SymbolicContext& sample_context() {
  static const SymbolicContext context({"x", "y", "z"});
  return context;
}

template <>
struct Samples<RationalFunction> : DyadicSamples<RationalFunction> {
  static constexpr int rounds = 60;

  /// Constants, indeterminates, and quotients of two linear functions.
  static RationalFunction any(Rng& rng) {
    switch (rng() % 4) {
      case 0:
        return FractionSamples<RationalFunction>::any(rng);
      case 1:
        return sample_context().variable(static_cast<int>(rng() % 3));
      default:
        return linear(rng) / (linear(rng) + sample_context().variable(2) * sample_context().variable(2));
    }
  }

  static RationalFunction unit(Rng& rng) {
    const RationalFunction x = any(rng);
    return x.is_zero() ? RationalFunction(1) : x;
  }

 private:
  static RationalFunction linear(Rng& rng) {
    RationalFunction f(integer(rng, -2, 2));
    for (int i = 0; i < 2; ++i) f += RationalFunction(integer(rng, -2, 2)) * sample_context().variable(i);
    return f;
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Symbolic, RingLaws, RationalFunction, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Symbolic, FieldLaws, RationalFunction, ScalarName);

/// The value of f at a point whose coordinates are no zero of a sample's denominator.
Rational value(const RationalFunction& f, const std::vector<std::string>& point) {
  return Rational::from_text(f.evaluate(point));
}

TEST(RationalFunction, EvaluationIsAHomomorphismToTheRationals) {
  Rng rng(6);
  for (int i = 0; i < 60; ++i) {
    const RationalFunction f = Samples<RationalFunction>::unit(rng), g = Samples<RationalFunction>::unit(rng);
    const std::vector<std::string> point = {"1000003/7", "-1000000007/11",
                                            std::to_string(integer(rng, 1'000'000'000'000, 2'000'000'000'000)) + "/13"};
    const Rational x = value(f, point), y = value(g, point);
    EXPECT_EQ(value(f + g, point), x + y);
    EXPECT_EQ(value(f - g, point), x - y);
    EXPECT_EQ(value(f * g, point), x * y);
    EXPECT_EQ(value(f / g, point), x / y);
    EXPECT_EQ(value(-f, point), -x);
  }
}

}  // namespace torse::laws
