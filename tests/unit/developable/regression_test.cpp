// The edge of regression: the twisted cubic and its tangent surface, by hand and by the condition of tangency.
#include "torse/developable/regression.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/algebra/dependence.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse {
namespace {

using namespace test;

/// (1, 3t, 3t^2, t^3) over the Bernstein basis.
std::vector<Row> twisted_cubic() { return {row(1, 0, 0, 0), row(1, 1, 0, 0), row(1, 2, 1, 0), row(1, 3, 3, 1)}; }

TEST(Regression, ParameterAndSpeedByHand) {
  EXPECT_EQ(edge_parameter(Q(0), BlossomFunctions<Q>{q(-4, 3), Q(-2), Q(1)}), Q(3));
  EXPECT_EQ(edge_parameter(Q(1), BlossomFunctions<Q>{Q(3), Q(-1), Q(2)}), q(2, 3));
  const EdgeSpeed<Q> speed = edge_speed(2, Q(1), BlossomFunctions<Q>{Q(3), Q(-1), Q(2)});
  EXPECT_EQ(speed.alpha, q(4, 9));
  EXPECT_EQ(speed.beta, q(1, 3));
}

TEST(Regression, PatchOfTheTwistedCubicByHand) {  // r[t, t, 3] with r = t^3: 3 t^2
  const std::vector<Row> rows = edge_patch(twisted_cubic(), Q(3));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0][3], Q(0));
  EXPECT_EQ(rows[1][3], Q(0));
  EXPECT_EQ(rows[2][3], Q(3));
  EXPECT_EQ(rows[0][1], Q(3));
}

TEST(Regression, PatchAndEdgeAreInverse) {
  const std::vector<Row> r = twisted_cubic();
  const std::vector<Row> p = edge_patch(r, Q(-1));
  const std::vector<Row> d = edge_patch(r, Q(4));
  const BlossomFunctions<Q> f{Q(4), Q(-1), Q(1)};
  EXPECT_TRUE(related(p, d, q(2, 7), f));
  const std::vector<Row> edge = edge_curve(p, d, f);
  ASSERT_EQ(edge.size(), r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    for (int j = 0; j < 4; ++j) EXPECT_EQ(edge[i][j], r[i][j]);
  }
}

TEST(Regression, TheEdgeIsTangentToTheRulingsForEverySigma) {
  const BlossomFunctions<Q> f{Q(3), Q(-2), q(5, 2)};
  const std::vector<Row> p = cubic_row();
  const std::vector<Row> d = rational_net<Q, Row>(bezier_knots<Q>(3), p, f.lambda, f.m, f.sigma, row(1, 2, 2, 2));
  const std::vector<Row> edge = edge_curve(p, d, f);
  ASSERT_EQ(edge.size(), 5U);
  for (const Q& t : {Q(0), q(1, 3), Q(2)}) {
    // The edge point by its parameter, and its derivative on the ruling: 5 R' = sigma q - p times 4.
    const Row by_parameter = edge_row(edge_parameter(t, f), value(p, t), value(d, t));
    for (const Q& minor : proportional_residual<Q, 4>(by_parameter, value(edge, t))) EXPECT_EQ(minor, Q(0));
    const Row along = combine<Row>(f.sigma, value(d, t), Q(-1), value(p, t));
    for (int j = 0; j < 4; ++j) EXPECT_EQ(Q(5) * derivative(edge, t)[j], Q(4) * along[j]);
  }
}

TEST(Regression, EqualLambdaAndMHaveNoEdgeCurve) {
  const std::vector<Row> p = cubic_row();
  EXPECT_EQ(place_of([&] { return edge_curve(p, p, BlossomFunctions<Q>{Q(2), Q(2), Q(1)}); }), "Lambda");
  EXPECT_THROW(edge_parameter(Q(0), BlossomFunctions<Q>{Q(2), Q(2), Q(1)}), DivisionByZero);
}

}  // namespace
}  // namespace torse
