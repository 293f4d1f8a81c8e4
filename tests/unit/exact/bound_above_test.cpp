// The bound of what a search has left open, on a quotient whose maximum and whose bounds are known.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "torse/exact/warp/search.hpp"

namespace torse::test {
namespace {

/// f(t) = t or f(t) = 1 - t on a part of [0, 1], whose bounds are too large by the length of the part.
struct Slope {
  bool rising;
  double from = 0;
  double to = 1;
  int* splits = nullptr;
  double share = 1;  ///< of what the numbers themselves say in the maximum, the rest being their errors

  double greatest() const { return rising ? to : 1 - from; }
  QuotientBound upper() const { return {greatest() + (to - from), share * greatest()}; }
  double lower_at_begin() const { return rising ? from : 1 - from; }
  double lower_at_end() const { return rising ? to : 1 - to; }
  std::pair<Slope, Slope> split() const {
    ++*splits;
    const double middle = (from + to) / 2;
    return {{rising, from, middle, splits, share}, {rising, middle, to, splits, share}};
  }
};

/// Whichever half has the maximum: the part around it is halved until it has the length 2^-48.
TEST(BoundAbove, HalvesThePartOfTheMaximum) {
  for (const bool rising : {true, false}) {
    int splits = 0;
    const double bound = bound_above(std::vector<Slope>{{rising, 0, 1, &splits}}, 0, 1000);
    EXPECT_EQ(bound, 1 + 0x1p-48);
    EXPECT_EQ(splits, 48);
  }
}

TEST(BoundAbove, EndsAtTheThresholdAndWithTheBudget) {
  for (const bool rising : {true, false}) {
    int splits = 0;
    EXPECT_EQ(bound_above(std::vector<Slope>{{rising, 0, 1, &splits}}, 1.25, 1000), 1.25);
    EXPECT_EQ(splits, 2);
    EXPECT_EQ(bound_above(std::vector<Slope>{{rising, 0, 1, &splits}}, 0, 3), 1.125);
    EXPECT_EQ(splits, 5);
    EXPECT_EQ(bound_above(std::vector<Slope>{}, 0, 3), 0);
  }
}

/// A bound that is more than twice what the numbers say is the errors', which halves have too.
TEST(BoundAbove, EndsWhereErrorsAreAllThatIsLeft) {
  int splits = 0;
  EXPECT_EQ(bound_above(std::vector<Slope>{{true, 0, 1, &splits, 0.75}}, 0, 1000), 2);
  EXPECT_EQ(splits, 0);
}

}  // namespace
}  // namespace torse::test
