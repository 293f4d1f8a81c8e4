// Degree elevation by factors and the change of the rulings' length, on a patch whose functions are known.
#include "torse/developable/factors.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse {
namespace {

using namespace test;

class FactorsTest : public testing::Test {
 protected:
  static void expect_equal(const BlossomFunctions<Q>& a, const BlossomFunctions<Q>& b) {
    EXPECT_EQ(a.lambda, b.lambda);
    EXPECT_EQ(a.m, b.m);
    EXPECT_EQ(a.sigma, b.sigma);
  }

  BlossomFunctions<Q> plain_{Q(3), Q(-2), q(5, 2)};
  std::vector<Row> p_ = cubic_row();
  std::vector<Row> q_ =
      rational_net<Q, Row>(bezier_knots<Q>(3), p_, plain_.lambda, plain_.m, plain_.sigma, row(1, 2, 2, 2));
  Linear<Q> f_{Q(2), q(1, 3)};
  Linear<Q> g_{Q(1), q(-3, 4)};
  std::vector<Q> parameters_{Q(0), q(1, 3), Q(1), Q(5)};
};

TEST_F(FactorsTest, ProductByHand) {  // (1 + t)(2 - t) = 2 + t - t^2
  const std::vector<Row> rows =
      times_linear(std::vector<Row>{row(1, 0, 0, 0), row(2, 0, 0, 0)}, Linear<Q>{Q(2), Q(-1)});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0][0], Q(2));
  EXPECT_EQ(rows[1][0], q(5, 2));
  EXPECT_EQ(rows[2][0], Q(2));
}

TEST_F(FactorsTest, ElevatedFunctionsBelongToTheElevatedRows) {
  for (const Q& t : parameters_) {
    const BlossomFunctions<Q> raised = elevated_functions(3, t, plain_, f_, g_);
    EXPECT_TRUE(related(times_linear(p_, f_), times_linear(q_, g_), t, raised)) << "t = " << t.text();
    expect_equal(unelevated(3, t, raised, f_, g_), plain_);
  }
}

TEST_F(FactorsTest, PlainElevationByHand) {
  const Linear<Q> unit{Q(1), Q(0)};
  expect_equal(elevated_functions(3, Q(1), plain_, unit, unit), {q(11, 3), Q(-3), q(5, 2)});
}

TEST_F(FactorsTest, ShortenedFunctionsBelongToTheShortenedRows) {
  const std::vector<Row> fp = times_linear(p_, f_);
  std::vector<Row> q_new = fp;
  const std::vector<Row> gp = times_linear(p_, g_);
  const std::vector<Row> gq = times_linear(q_, g_);
  for (std::size_t i = 0; i < q_new.size(); ++i) add(q_new[i], difference(gq[i], gp[i]));
  for (const Q& t : parameters_) {
    const BlossomFunctions<Q> raised = shortened_functions(3, t, plain_, f_, g_);
    EXPECT_TRUE(related(fp, q_new, t, raised)) << "t = " << t.text();
    expect_equal(unshortened(3, t, raised, f_, g_), plain_);
  }
}

TEST_F(FactorsTest, EqualFactorsOnlyElevate) {
  for (const Q& t : parameters_) {
    expect_equal(shortened_functions(3, t, plain_, g_, g_), elevated_functions(3, t, plain_, g_, g_));
    expect_equal(unshortened(3, t, plain_, g_, g_), unelevated(3, t, plain_, g_, g_));
  }
}

TEST_F(FactorsTest, ARulingOfLengthZeroIsDefined) {  // g(4/3) = 0: p~ = q~ there, and both functions are t
  const Q t = q(4, 3);
  const BlossomFunctions<Q> raised = shortened_functions(3, t, plain_, Linear<Q>{Q(1), Q(0)}, g_);
  expect_equal(raised, {t, t, Q(1)});
}

TEST_F(FactorsTest, InfiniteFunctionsAreDivisionsByZero) {
  const Linear<Q> unit{Q(1), Q(0)};
  const Linear<Q> slope{Q(0), Q(1)};  // 3 f(1) + f_1 (1 - Lam) = 0 for Lam = 4
  EXPECT_THROW(elevated_functions(3, Q(1), BlossomFunctions<Q>{Q(4), Q(2), Q(1)}, slope, unit), DivisionByZero);
  EXPECT_THROW(shortened_functions(3, Q(1), BlossomFunctions<Q>{Q(2), Q(4), Q(1)}, unit, slope), DivisionByZero);
}

}  // namespace
}  // namespace torse
