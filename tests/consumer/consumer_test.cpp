// A CAD team's own test of a surface, with the matchers that torse installs.
#include <gtest/gtest.h>

#include "torse/exact/testing/matchers.hpp"

namespace {

using torse::testing::IsDevelopable;
using torse::testing::IsDevelopableWithin;
using Point = torse::Vec<double, 3>;

TEST(HullPlate, BendsOutOfFlatSheet) {
  const auto plate = torse::testing::test_surface<double, 3>(2, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0.5}, {2, 0, 0}},
                                                             {{0, 3, 0.125}, {1, 3, 0.625}, {2, 3, 0.125}});
  EXPECT_THAT(plate, IsDevelopable());
}

TEST(HullPlate, ATwistedOneNearlyDoes) {
  const auto plate = torse::testing::test_surface<double, 3>(2, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0.5}, {2, 0, 0}},
                                                             {{0, 3, 0.125}, {1, 3, 0.625}, {2, 3, 0.126}});
  EXPECT_THAT(plate, ::testing::Not(IsDevelopable()));
  EXPECT_THAT(plate, IsDevelopableWithin(0.1));
}

}  // namespace
