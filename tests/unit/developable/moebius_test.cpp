// Moebius reparametrisation: values by hand and the same points in space.
#include "torse/developable/moebius.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse {
namespace {

using namespace test;

TEST(Moebius, ParameterByHand) {
  EXPECT_EQ(moebius_parameter(Q(2), q(1, 2)), q(1, 3));
  EXPECT_EQ(moebius_parameter(Q(2), Q(0)), Q(0));
  EXPECT_EQ(moebius_parameter(Q(2), Q(1)), Q(1));
  EXPECT_THROW(moebius_parameter(Q(2), Q(2)), DivisionByZero);
}

TEST(Moebius, RowsAreWeightedByPowers) {
  const std::vector<Row> rows = moebius_rows(std::vector<Row>(4, row(1, 1, 1, 1)), Q(2));
  EXPECT_EQ(rows[0][0], Q(8));
  EXPECT_EQ(rows[1][1], Q(4));
  EXPECT_EQ(rows[2][2], Q(2));
  EXPECT_EQ(rows[3][3], Q(1));
}

TEST(Moebius, ThePointsInSpaceStay) {
  const std::vector<Row> p = cubic_row();
  const std::vector<Row> changed = moebius_rows(p, Q(3));
  for (const Q& u : {q(1, 4), q(2, 3), Q(1)}) {
    const Row x = value(changed, u);
    const Row y = value(p, moebius_parameter(Q(3), u));
    for (int j = 1; j < 4; ++j) EXPECT_EQ(x[j] / x[0], y[j] / y[0]);
  }
}

TEST(Moebius, FunctionsOfThePatch) {
  const BlossomFunctions<Q> f{Q(3), Q(-2), q(5, 2)};
  const std::vector<Row> p = cubic_row();
  const std::vector<Row> d = rational_net<Q, Row>(bezier_knots<Q>(3), p, f.lambda, f.m, f.sigma, row(1, 2, 2, 2));
  const BlossomFunctions<Q> changed = moebius_functions(f, Q(3));
  EXPECT_EQ(changed.lambda, q(9, 7));
  EXPECT_EQ(changed.m, Q(2));
  EXPECT_EQ(changed.sigma, q(5, 2) * q(-3, 7));
  EXPECT_TRUE(related(moebius_rows(p, Q(3)), moebius_rows(d, Q(3)), q(1, 5), changed));
  EXPECT_FALSE(related(moebius_rows(p, Q(3)), moebius_rows(d, Q(3)), q(1, 5), f));
}

TEST(Moebius, InfiniteFunctionsAreDivisionsByZero) {
  EXPECT_THROW(moebius_functions(BlossomFunctions<Q>{Q(-1), Q(3), Q(1)}, Q(2)), DivisionByZero);
  EXPECT_THROW(moebius_functions(BlossomFunctions<Q>{Q(3), q(-1, 2), Q(1)}, Q(3)), DivisionByZero);
}

}  // namespace
}  // namespace torse
