// Crossing rulings wherever along the strip they are, and strips whose weights are negative, change or are zero.
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

/// x = (2t - 1) / ((t - 1/4)(t - 3/4)) decreases between its poles from every number to every other one, so that each
/// wall over it stands three times.
TEST(SelfIntersectionPlaces, RailsThroughInfinityAreNotInOrder) {
  const auto row = [](const Q& w, int x, const Q& z) { return Vec<Q, 4>(w, Q(x), Q(0), z); };
  const Q end = ratio<Q>(3, 16), middle = ratio<Q>(-5, 16);
  const Row c{row(end, -1, Q(0)), row(middle, 0, Q(0)), row(end, 1, Q(0))};
  const Row d{row(end, -1, end), row(middle, 0, middle), row(end, 1, end)};
  EXPECT_EQ(find_self_intersection<4>(bezier_knots<Q>(2), c, d).crosses, Truth::yes);
}

/// In a plane: d goes up from (0, 0) to (1, 3) and on to the right. c begins above it at (1/2, 26), is at infinity, to
/// the right, where d is at (1, 3), and comes back from the left to (-10, 2). Rulings turn to one side all the time,
/// but those of the second piece go from d back through those of the first one.
TEST(SelfIntersectionPlaces, ARailThatIsInfiniteAtAKnotIsNotInOrder) {
  const auto row = [](int w, int x, int y) { return Vec<Q, 4>(Q(w), Q(x), Q(y), Q(0)); };
  const Row c{row(10, 5, 260), row(11, 24, 130), row(0, 10, 0), row(-5, 55, -10), row(-10, 100, -20)};
  const Row d{row(8, 0, 0), row(8, 4, 24), row(8, 8, 24), row(8, 9, 24), row(8, 10, 24)};
  EXPECT_EQ(find_self_intersection<4>(KnotList<Q>(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)}), c, d).crosses, Truth::yes);
}

/// A slab through a wall near the upper end of its last ruling, away from the other three corners of the wall.
TEST(SelfIntersectionPlaces, EveryCornerCounts) {
  const auto at = [](int x, int y, int z) { return Vec<Q, 4>(Q(20), Q(x), Q(y), Q(z)); };
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3), Q(4), Q(5)});
  const Row c{at(0, 0, 0), at(40, 0, 0), at(80, 0, 18), at(80, -40, 18), at(38, -10, 18), at(38, 10, 18)};
  const Row d{at(0, 0, 20), at(40, 0, 20), at(80, 0, 19), at(80, -40, 19), at(38, -10, 19), at(38, 10, 19)};
  EXPECT_EQ(find_self_intersection<4>(u, c, d).crosses, Truth::yes);
  EXPECT_EQ(find_self_intersection<4>(u, d, c).crosses, Truth::yes);
  Row before = c;
  Row above = d;
  before.back() = at(38, -1, 18);
  above.back() = at(38, -1, 19);
  EXPECT_EQ(find_self_intersection<4>(u, before, above).crosses, Truth::no);
}

}  // namespace
}  // namespace torse::test
