// Crossing rulings wherever along the strip they are, and strips whose weights are negative or change.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "torse/exact/quasi/self_intersection.hpp"

namespace torse::test {
namespace {

using Q = Rational;
using Row = std::vector<Vec<Q, 4>>;
using Corners = std::vector<std::array<int, 2>>;

/// Walls between these corners of the ground plan, from `bottom` up to one more. Weights change no wall, only the speed
/// along it.
Truth walls_cross(const Corners& corners, int bottom, const std::vector<Q>& weights) {
  Row c, d;
  std::vector<Q> knots;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Q& w = weights[i];
    const auto& [x, y] = corners[i];
    c.push_back(Vec<Q, 4>(w, w * Q(x), w * Q(y), w * Q(bottom)));
    d.push_back(Vec<Q, 4>(w, w * Q(x), w * Q(y), w * Q(bottom + 1)));
    knots.push_back(Q(static_cast<int>(i)));
  }
  return find_self_intersection<4>(KnotList<Q>(1, knots), c, d).crosses;
}

Truth walls_cross(const Corners& corners) { return walls_cross(corners, 0, std::vector<Q>(corners.size(), Q(1))); }

/// Four walls, the last of which goes through the first, before or behind others that lead away.
TEST(SelfIntersectionPlaces, AmongTheFirstAndTheLastWalls) {
  for (const int others : {4, 12, 16}) {
    Corners corners{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, -1}};
    for (int i = 1; i <= others; ++i) corners.push_back({1 + i % 2, -1 - i});
    EXPECT_EQ(walls_cross(corners), Truth::yes) << others;
    std::ranges::reverse(corners);
    EXPECT_EQ(walls_cross(corners), Truth::yes) << others;
  }
}

/// A wall that ends in front of the first one, in all quarters of the plane.
TEST(SelfIntersectionPlaces, WallsOfNegativeWeights) {
  for (const int x : {-9, 9}) {
    for (const int y : {-9, 9}) {
      for (const Q& w : {Q(1), ratio<Q>(1, 2), Q(-1), ratio<Q>(-1, 2)}) {
        const Corners corners{{x, y}, {x + 2, y}, {x + 2, y + 2}, {x + 1, y + 2}, {x + 1, y + 1}};
        EXPECT_EQ(walls_cross(corners, -5, std::vector<Q>(5, w)), Truth::no) << x << ' ' << y;
      }
    }
  }
}

/// The last wall, of other weights than the first, goes through it.
TEST(SelfIntersectionPlaces, WallsOfOtherWeights) {
  for (const int bottom : {-4, 3}) {
    const Corners corners{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, -1}};
    EXPECT_EQ(walls_cross(corners, bottom, {Q(1), Q(1), Q(4), Q(16), Q(16)}), Truth::yes);
    EXPECT_EQ(walls_cross(corners, bottom, {Q(16), Q(16), Q(4), Q(1), Q(1)}), Truth::yes);
  }
}

/// The same point with another weight is where it was.
TEST(SelfIntersectionPlaces, ASeamOfOtherWeightsIsNone) {
  const Corners square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  EXPECT_EQ(walls_cross(square, 1, {Q(1), Q(1), Q(1), Q(1), Q(3)}), Truth::no);
}

/// In a plane, without a knot of multiplicity 2 at the begin: there a row is half the sum of the first two, whose
/// weights may be 1 and -1, and its rail comes from the left. In the second piece the rulings all pass (1, 1/2), or are
/// parallel: those near infinity are apart from none.
TEST(SelfIntersectionPlaces, RailsThatBeginAtInfinity) {
  const KnotList<Q> u(2, {Q(0), Q(1), Q(2), Q(2), Q(3), Q(3)});
  const auto row = [](int w, int x, int y) { return Vec<Q, 4>(Q(w), Q(w * x), Q(w * y), Q(0)); };
  const auto rail = [&](bool infinite, int y, const std::array<int, 3>& x) {
    return Row{infinite ? row(1, 0, y) : row(-1, -4, y), row(-1, -2, y), row(-1, x[0], y), row(-1, x[1], y),
               row(-1, x[2], y)};
  };
  for (const auto& [c, d] : {std::pair{true, true}, {true, false}, {false, true}}) {
    EXPECT_EQ(find_self_intersection<4>(u, rail(c, 0, {0, 1, 2}), rail(d, 1, {2, 1, 0})).crosses, Truth::yes);
    EXPECT_EQ(find_self_intersection<4>(u, rail(c, 0, {0, 1, 2}), rail(d, 1, {0, 1, 2})).crosses, Truth::unknown);
  }
  EXPECT_EQ(find_self_intersection<4>(u, rail(false, 0, {0, 1, 2}), rail(false, 1, {0, 1, 2})).crosses, Truth::no);
}

}  // namespace
}  // namespace torse::test
