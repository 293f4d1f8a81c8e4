// Lam, M, sigma and lambda, mu, nu at one parameter: values worked out by hand, and the relations on a patch.
#include "torse/developable/functions.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/ruled.hpp"

namespace torse {
namespace {

using namespace test;

TEST(Functions, DependenceIsNormalised) {
  const BlossomFunctions<Q> f = from_dependence(Q(1), Q(3), Q(2), Q(6));
  EXPECT_EQ(f.lambda, q(3, 4));
  EXPECT_EQ(f.m, q(3, 4));
  EXPECT_EQ(f.sigma, Q(2));
}

TEST(Functions, DependenceOfADerivativeIsRefused) {
  EXPECT_EQ(place_of([] { return from_dependence(Q(1), Q(-1), Q(2), Q(6)); }), "Lambda");
  EXPECT_EQ(place_of([] { return from_dependence(Q(1), Q(3), Q(2), Q(-2)); }), "M");
}

TEST(Functions, FrameByHand) {
  const BlossomFunctions<Q> f = to_blossom(2, Q(1), FrameFunctions<Q>{Q(3), Q(1), Q(1)});
  EXPECT_EQ(f.lambda, Q(3));
  EXPECT_EQ(f.m, q(5, 3));
  EXPECT_EQ(f.sigma, q(3, 2));
  const FrameFunctions<Q> frame = to_frame(2, Q(1), f);
  EXPECT_EQ(frame.lambda, Q(3));
  EXPECT_EQ(frame.mu, Q(1));
  EXPECT_EQ(frame.nu, Q(1));
}

TEST(Functions, FrameDecomposesTheDerivative) {
  const BlossomFunctions<Q> f{Q(3), Q(-2), q(5, 2)};
  const std::vector<Row> p = cubic_row();
  const std::vector<Row> d = rational_net<Q, Row>(bezier_knots<Q>(3), p, f.lambda, f.m, f.sigma, row(1, 2, 2, 2));
  for (const Q& t : {Q(0), q(1, 3), Q(2)}) {
    const FrameFunctions<Q> frame = to_frame(3, t, f);
    Row rest = derivative(p, t);
    add_scaled(rest, -frame.lambda, difference(value(d, t), value(p, t)));
    add_scaled(rest, -frame.mu, difference(derivative(d, t), derivative(p, t)));
    add_scaled(rest, -frame.nu, value(p, t));
    for (int j = 0; j < 4; ++j) EXPECT_EQ(rest[j], Q(0)) << "t = " << t.text() << ", coordinate " << j;
  }
}

TEST(Functions, InfiniteFunctionsAreDivisionsByZero) {
  EXPECT_THROW(to_blossom(2, Q(1), FrameFunctions<Q>{Q(0), Q(1), Q(1)}), DivisionByZero);
  EXPECT_THROW(to_blossom(2, Q(1), FrameFunctions<Q>{Q(1), Q(1), Q(1)}), DivisionByZero);
  EXPECT_THROW(to_frame(2, Q(1), BlossomFunctions<Q>{Q(4), Q(4), Q(1)}), DivisionByZero);
}

TEST(Functions, WeightsAndGauge) {
  const BlossomFunctions<Q> f = scaled_weights(BlossomFunctions<Q>{Q(3), Q(5), Q(7)}, Q(2), Q(3));
  EXPECT_EQ(f.lambda, Q(3));
  EXPECT_EQ(f.m, Q(5));
  EXPECT_EQ(f.sigma, q(14, 3));
  const FrameFunctions<Q> frame = gauged(FrameFunctions<Q>{Q(2), Q(3), Q(5)}, Q(4), Q(8));
  EXPECT_EQ(frame.lambda, Q(-4));
  EXPECT_EQ(frame.mu, Q(3));
  EXPECT_EQ(frame.nu, Q(7));
}

TEST(Functions, StandardParameterOfARuling) {
  EXPECT_EQ(standard_parameter(q(1, 2), Q(2), Q(3)), q(3, 5));
  EXPECT_EQ(standard_parameter(q(3, 5), Q(3), Q(2)), q(1, 2));
  EXPECT_THROW(standard_parameter(q(1, 2), Q(2), Q(-2)), DivisionByZero);
}

}  // namespace
}  // namespace torse
