// Equal coefficients that are moved apart, by hand.
#include "torse/quasi/equal_runs.hpp"

#include <gtest/gtest.h>

namespace torse::quasi {
namespace {

using List = std::vector<double>;

void expect_parted(List beta, const RunLimits& limits, const List& wanted) {
  part_equal(beta, limits);
  ASSERT_EQ(beta.size(), wanted.size());
  for (std::size_t i = 0; i < beta.size(); ++i) EXPECT_DOUBLE_EQ(beta[i], wanted[i]) << i;
}

/// A third of 1e-6 for each of three, a half for each of two.
TEST(EqualRuns, ArePartedUpwardsAndAtTheEndDownwards) {
  expect_parted({0, 0, 0, 1}, {.at_end = 2, .inside = 2}, {0, 1e-6 / 3, 2e-6 / 3, 1});
  expect_parted({0, 1, 1, 1}, {.at_end = 2, .inside = 2}, {0, 1 - 2e-6 / 3, 1 - 1e-6 / 3, 1});
  expect_parted({0, 0.25, 0.25, 1}, {.at_end = 2, .inside = 2}, {0, 0.25, 0.25 + 5e-7, 1});
  expect_parted({0, 0, 0.25, 0.5, 0.5, 0.75, 1, 1}, {.at_end = 2, .inside = 2},
                {0, 5e-7, 0.25, 0.5, 0.5 + 5e-7, 0.75, 1 - 5e-7, 1});
}

/// Gaps of 2^-20 and 2^-21, half of which are less than 1e-6.
TEST(EqualRuns, StayOnTheirSideOfASmallGap) {
  expect_parted({0, 0, 0x1p-20, 1}, {.at_end = 2, .inside = 2}, {0, 0x1p-22, 0x1p-20, 1});
  expect_parted({0, 0.5, 0.5, 0.5 + 0x1p-21, 1}, {.at_end = 2, .inside = 2}, {0, 0.5, 0.5 + 0x1p-23, 0.5 + 0x1p-21, 1});
  expect_parted({0, 1 - 0x1p-20, 1, 1}, {.at_end = 2, .inside = 2}, {0, 1 - 0x1p-20, 1 - 0x1p-22, 1});
}

TEST(EqualRuns, ShortOnesStay) {
  const List beta{0, 0, 0.25, 0.25, 0.25, 0.5, 1, 1};
  const double third = 1e-6 / 3;
  expect_parted(beta, {.at_end = 3, .inside = 4}, beta);
  expect_parted(beta, {.at_end = 3, .inside = 3}, {0, 0, 0.25, 0.25 + third, 0.25 + 2 * third, 0.5, 1, 1});
  expect_parted(beta, {.at_end = 2, .inside = 4}, {0, 5e-7, 0.25, 0.25, 0.25, 0.5, 1 - 5e-7, 1});
  expect_parted({0, 0.5, 1}, {.at_end = 2, .inside = 2}, {0, 0.5, 1});
}

TEST(EqualRuns, WithoutAnotherCoefficientThereIsNoRoom) {
  expect_parted({0.5, 0.5, 0.5}, {.at_end = 2, .inside = 2}, {0.5, 0.5, 0.5});
}

}  // namespace
}  // namespace torse::quasi
