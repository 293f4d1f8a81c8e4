// Budgets by the number of bits, and singular sets in words.
#include "torse/cli/surface_report.hpp"

#include <gtest/gtest.h>

namespace torse::cli {
namespace {

using Q = Rational;

/// Ones everywhere, each 2 bits with its denominator, but for the last knot.
RuledFile<Q> ones(int degree, const Q& end) {
  std::vector<Q> knots(static_cast<std::size_t>(degree), Q(1));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), end);
  const auto count = static_cast<std::size_t>(degree) + 1;
  const WeightedPoints<Q, 3> row{std::vector<Vec<Q, 3>>(count, Vec<Q, 3>(Q(1), Q(1), Q(1))),
                                 std::vector<Q>(count, Q(1))};
  return {KnotList<Q>(degree, knots), row, row};
}

/// Degree 1: the knots 1 and 7 (2 + 4 bits), 4 points (24 bits), 4 weights (8 bits).
TEST(SurfaceReport, BudgetsCountKnotsPointsAndWeights) {
  EXPECT_TRUE(within_budget(ones(1, Q(7)), 38));
  EXPECT_FALSE(within_budget(ones(1, Q(7)), 37));
  EXPECT_TRUE(within_budget(ones(1, Q(15)), 39));
  EXPECT_FALSE(within_budget(ones(1, Q(15)), 38));
}

/// Degree 3 has 6 knots (18 bits), 8 points (48 bits), 8 weights (16 bits); degree 6 has 12, 14 and 14 (148 bits),
/// twice.
TEST(SurfaceReport, BudgetsShrinkWithTheDegreeFromFour) {
  EXPECT_TRUE(within_budget(ones(3, Q(7)), 82));
  EXPECT_FALSE(within_budget(ones(3, Q(7)), 81));
  EXPECT_TRUE(within_budget(ones(6, Q(7)), 296));
  EXPECT_FALSE(within_budget(ones(6, Q(7)), 295));
}

SingularSet set(int from, int to) {
  const auto bound = [](int t) { return SingularSet::Bound{{Q(t), Q(t)}, {}}; };
  SingularSet result{};
  result.from = bound(from);
  result.to = bound(to);
  return result;
}

TEST(SurfaceReport, SingularSetsInWords) {
  EXPECT_EQ(singular_text({}, 2), "regular: no singular point on the patch");
  const std::string reason = " (" + std::string(name_of(set(1, 1).reason)) + ")";
  EXPECT_EQ(singular_text({set(1, 1), set(2, 3)}, 2), "singular at t = 1" + reason + ", 2 to 3" + reason);
  EXPECT_EQ(singular_text({set(1, 1), set(2, 3), set(4, 4), set(5, 5)}, 2),
            "singular at t = 1" + reason + ", 2 to 3" + reason + " and 2 more");
}

}  // namespace
}  // namespace torse::cli
