// Crossing rulings: strips whose crossings are known by hand; witnesses against exact points of the surface.
#include "torse/exact/quasi/self_intersection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "torse/quasi/mapping.hpp"
#include "torse/spline/blossom.hpp"

namespace torse::test {
namespace {

using Q = Rational;
using Point = Vec<Q, 3>;
using Row = std::vector<Point>;

Point point(int x, int y, int z) { return Point(Q(x), Q(y), Q(z)); }

Row raised(const Row& row, const Q& height) {
  Row up;
  for (const Point& x : row) up.push_back(Point(x[0], x[1], x[2] + height));
  return up;
}

Row looped() { return {point(0, 0, 0), point(3, 2, 0), point(-2, 2, 0), point(1, 0, 0)}; }

Truth crosses(const KnotList<Q>& u, const Row& c, const Row& d) { return find_self_intersection<3>(u, c, d).crosses; }

/// A point of the surface, by blossoms in exact arithmetic.
Vec<double, 3> on_surface(const KnotList<Q>& u, const Row& c, const Row& d, double t, double v) {
  const Q at = Q::from_double(t);
  const Point x = curve_point<Q, Point>(u, c, piece_at(u, at), at);
  const Point y = curve_point<Q, Point>(u, d, piece_at(u, at), at);
  Vec<double, 3> result;
  for (int k = 0; k < 3; ++k) result[k] = (1 - v) * x[k].to_double() + v * y[k].to_double();
  return result;
}

void expect_witness(const KnotList<Q>& u, const Row& c, const Row& d) {
  const SelfIntersection found = find_self_intersection<3>(u, c, d);
  ASSERT_EQ(found.crosses, Truth::yes);
  const RulingCrossing& at = *found.witness;
  EXPECT_NE(at.first, at.second);
  for (const double share : {at.first_share, at.second_share}) {
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
  }
  const Vec<double, 3> gap =
      on_surface(u, c, d, at.first, at.first_share) - on_surface(u, c, d, at.second, at.second_share);
  EXPECT_LT(gap.norm(), 1e-11);
}

/// The same strip with its coordinates in another order: the loop in a plane through the origin.
TEST(SelfIntersection, ALoopInACoordinatePlaneHasAWitnessToo) {
  const auto turned = [](const Row& row) {
    Row result;
    for (const Point& x : row) result.push_back(Point(x[2], x[0], x[1]));
    return result;
  };
  expect_witness(bezier_knots<Q>(3), turned(looped()), turned(raised(looped(), Q(1))));
}

/// The gap is measured against the larger rail, not against the one that is all but a point.
TEST(SelfIntersection, ALoopAboveAMuchSmallerOneHasAWitness) {
  Row small = looped();
  for (Point& x : small) x = Point(scaled(Q::from_double(0x1p-60), x));
  expect_witness(bezier_knots<Q>(3), small, raised(looped(), Q(1)));
  expect_witness(bezier_knots<Q>(3), raised(looped(), Q(1)), small);
}

TEST(SelfIntersection, ItsWitnessIsAsNearAsTheSizeOfTheSurfaceAsks) {
  for (const double size : {0x1p40, 0x1p-40}) {
    Row c = looped();
    for (Point& x : c) x = Point(scaled(Q::from_double(size), x));
    const SelfIntersection found = find_self_intersection<3>(bezier_knots<Q>(3), c, raised(c, Q::from_double(size)));
    ASSERT_EQ(found.crosses, Truth::yes) << size;
    EXPECT_LT(found.witness->distance, 1e-11 * size);
  }
}

/// BZZ19's "guaranteed to have no self-intersections" is refuted by T = t over a curve with a loop.
TEST(SelfIntersection, ALoopThatIsRaisedCrossesItself) {
  expect_witness(bezier_knots<Q>(3), looped(), raised(looped(), Q(1)));
}

TEST(SelfIntersection, RailsAgainstEachOtherCross) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  expect_witness(u, {point(0, 0, 0), point(1, 0, 0)}, {point(1, 1, 0), point(0, 1, 0)});
}

/// The loop lifted by more than the rulings are long.
TEST(SelfIntersection, AHelixDoesNot) {
  Row c = looped();
  for (std::size_t i = 0; i < c.size(); ++i) c[i][2] = Q(static_cast<long>(i));
  const KnotList<Q> u = bezier_knots<Q>(3);
  EXPECT_EQ(crosses(u, c, raised(c, ratio<Q>(1, 10))), Truth::no);
  expect_witness(u, c, raised(c, Q(4)));
}

/// Whitney's umbrella (t v, t^2, v): the rulings of t and -t cross at (0, t^2, 0), nearer and nearer to t = 0, where a
/// ruling and its neighbours do not tell.
TEST(SelfIntersection, RulingsCrossUpToAPinchPoint) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  for (const Q& begin : {Q(-1), ratio<Q>(-1, 7), ratio<Q>(-1, 50)}) {
    // t from `begin` to 1, by its blossoms.
    const auto rail = [&](int v) {
      Row row;
      for (const auto& [s, t] : {std::pair(begin, begin), std::pair(begin, Q(1)), std::pair(Q(1), Q(1))}) {
        row.push_back(Point(Q(v) * (s + t) / Q(2), s * t, Q(v)));
      }
      return row;
    };
    expect_witness(u, rail(-1), rail(1));
  }
}

/// Made to cross by moving one point of c: a quadrilateral folded in its plane, pieces of degree 2 and 3.
TEST(SelfIntersection, CrossingsBesideRulingsThatDoNotTell) {
  expect_witness(bezier_knots<Q>(1), {point(4, 0, -6), point(78, -32, -97)}, {point(-1, 8, -8), point(-7, 8, 3)});
  const auto parts = [](int x, int y, int z) { return Point(ratio<Q>(x, 18), ratio<Q>(y, 18), ratio<Q>(z, 18)); };
  expect_witness(bezier_knots<Q>(2), {point(-2, 0, -3), parts(181, 32, 169), point(7, 0, -6)},
                 {point(8, 1, 1), point(0, 1, -1), point(0, 1, -1)});
  expect_witness(KnotList<Q>(3, {Q(1), Q(1), Q(1), Q(2), Q(2), Q(2)}),
                 {Point(Q(-5), Q(0), ratio<Q>(19, 3)), point(2, 0, -5), point(-1, 0, -5), point(-3, 0, 7)},
                 {point(4, 9, -4), point(4, 9, -5), point(-3, 9, 0), point(-2, 9, -6)});
}

/// Rails over two parallel lines that both go on and on along them: each ruling lies beyond the one before, however
/// steep the rails are.
TEST(SelfIntersection, SteepStripsDoNot) {
  const Row c{point(5, 0, 5), point(11, 0, 0), point(12, 0, -1)};
  const Row d{point(8, 1, 0), point(19, 1, -7), point(23, 1, 4)};
  EXPECT_EQ(find_self_intersection<3>(bezier_knots<Q>(2), c, d, 2).crosses, Truth::no);
  // All pieces of a strip at once: 5 pieces are 15 pairs.
  Row saw, other;
  for (int i = 0; i <= 5; ++i) {
    saw.push_back(point(i, 0, i % 2 == 0 ? 40 : -40));
    other.push_back(point(i, 1, i % 2 == 0 ? -40 : 40));
  }
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3), Q(4), Q(5)});
  EXPECT_EQ(find_self_intersection<3>(u, saw, other, 2).crosses, Truth::no);
}

/// The rulings of the middle piece slide along themselves, so that they lie upon each other; before and behind it the
/// strip goes on to one side.
TEST(SelfIntersection, RulingsThatSlideAlongThemselvesCross) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3)});
  const Row c{point(0, 0, -1), point(0, 0, 0), point(1, 0, 0), point(1, 0, 1)};
  const Row d{point(3, 0, -1), point(3, 0, 0), point(4, 0, 0), point(4, 0, 1)};
  expect_witness(u, c, d);
  // Without the middle piece.
  const KnotList<Q> two(1, {Q(0), Q(1), Q(2)});
  EXPECT_EQ(crosses(two, {c[0], c[1], point(0, 0, 1)}, {d[0], d[1], point(3, 0, 1)}), Truth::no);
}

/// Tangents of the cubic (t, t^2, t^3) ahead of it, up to one derivative away, and those on both sides of its shadow.
TEST(SelfIntersection, ARailMayBeItsEdgeOfRegression) {
  const auto third = [](int x, int y, int z) { return Point(ratio<Q>(x, 3), ratio<Q>(y, 3), ratio<Q>(z, 3)); };
  const Row edge{third(0, 0, 0), third(1, 0, 0), third(2, 1, 0), third(3, 3, 3)};
  const Row ahead{third(3, 0, 0), third(4, 2, 0), third(5, 5, 3), third(6, 9, 12)};
  EXPECT_EQ(crosses(bezier_knots<Q>(3), edge, ahead), Truth::no);
  EXPECT_EQ(crosses(bezier_knots<Q>(3), ahead, edge), Truth::no);
  const auto reversed = [](Row row) {
    std::ranges::reverse(row);
    return row;
  };
  EXPECT_EQ(crosses(bezier_knots<Q>(3), reversed(edge), reversed(ahead)), Truth::no);
  const auto flat = [](Row row) {
    for (Point& x : row) x[2] = Q(0);
    return row;
  };
  Row behind = flat(edge);
  for (std::size_t i = 0; i < 4; ++i) behind[i] = Point(behind[i] * Q(2) - flat(ahead)[i]);
  expect_witness(bezier_knots<Q>(3), behind, flat(ahead));
}

TEST(SelfIntersection, PlanesConesAndClosedStripsDoNot) {
  EXPECT_EQ(crosses(bezier_knots<Q>(1), {point(0, 0, 0), point(1, 0, 0)}, {point(0, 1, 0), point(1, 1, 0)}), Truth::no);
  const Row tip(3, point(0, 0, 1));
  EXPECT_EQ(crosses(bezier_knots<Q>(2), tip, {point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)}), Truth::no);
  const KnotList<Q> square(1, {Q(0), Q(1), Q(2), Q(3), Q(4)});
  const Row base{point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(0, 1, 0), point(0, 0, 0)};
  EXPECT_EQ(crosses(square, base, raised(base, Q(1))), Truth::no);
}

/// A tube whose last wall goes through its first one.
TEST(SelfIntersection, FarPartsThatMeetAreFound) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3), Q(4)});
  const Row base{point(0, 0, 0), point(2, 0, 0), point(2, 2, 0), point(1, 2, 0), point(1, -1, 0)};
  expect_witness(u, base, raised(base, Q(1)));
}

/// Two sheets 2^-44 apart or less, which bend together so that no plane parts them soon; their distance is a rounding
/// error of the size, but they do not cross.
TEST(SelfIntersection, SheetsThatAllButTouchDoNotCross) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2), Q(3), Q(3)});
  const auto strip = [&](double gap) {
    Row c{point(0, 0, 0), point(1, 1, 0), point(2, 0, 0), point(3, -1, 0),
          point(2, 0, 0), point(1, 1, 0), point(0, 0, 0)};
    for (std::size_t i = 4; i < c.size(); ++i) c[i][1] += Q::from_double(gap);
    return find_self_intersection<3>(u, c, raised(c, Q(1)));
  };
  for (const double gap : {0x1p-44, 0x1p-200}) EXPECT_NE(strip(gap).crosses, Truth::yes) << gap;
}

/// The walls z = x^2 and z = -x^2 of one strip touch along the ruling over x = 0, one third along each: no halving
/// comes to it, and nothing parts them there.
TEST(SelfIntersection, SheetsThatTouchAreNotSaidNotTo) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2), Q(3), Q(3)});
  const Row c{point(-2, 0, 2), point(1, 0, -4), point(4, 0, 8),  point(9, 0, 0),
              point(4, 0, -8), point(1, 0, 4),  point(-2, 0, -2)};
  Row d = c;
  for (Point& x : d) x[1] += Q(1);
  EXPECT_NE(crosses(u, c, d), Truth::no);
}

/// A wall that is gone along twice: every ruling is there again four walls later.
TEST(SelfIntersection, SheetsUponEachOtherCross) {
  std::vector<Q> knots;
  Row base;
  for (int i = 0; i <= 8; ++i) {
    knots.push_back(Q(i));
    base.push_back(point((i % 4 == 1 || i % 4 == 2) ? 1 : 0, i % 4 >= 2 ? 1 : 0, 0));
  }
  const KnotList<Q> u(1, knots);
  expect_witness(u, base, raised(base, Q(1)));
  const RulingCrossing at = *find_self_intersection<3>(u, base, raised(base, Q(1))).witness;
  EXPECT_EQ(std::abs(at.first - at.second), 4);
}

/// Strips in a plane that is not parallel to the axes: there two numbers of a gap tell whether it is one.
TEST(SelfIntersection, CrossingsInAPlane) {
  const auto tilted = [](const std::vector<std::array<int, 2>>& corners) {
    Row row;
    for (const auto& [x, y] : corners) row.push_back(Point(Q(x), Q(y) + ratio<Q>(x, 3), ratio<Q>(x, 7) - Q(5 * y)));
    return row;
  };
  expect_witness(bezier_knots<Q>(1), tilted({{0, 0}, {3, 0}}), tilted({{2, 1}, {0, 1}}));
  // A band about a corner, wider than the radius of its turn.
  expect_witness(bezier_knots<Q>(3), tilted({{0, 0}, {6, 4}, {-4, 4}, {2, 0}}),
                 tilted({{0, 1}, {6, 5}, {-4, 5}, {2, 1}}));
}

/// A figure of eight whose arms meet at knots, where the pieces have other slopes: the crossing is within no piece.
TEST(SelfIntersection, ACrossingAtKnots) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(3), Q(4), Q(5), Q(6), Q(9)});
  const Row base{point(-4, -4, 0), point(0, 0, 0), point(3, 4, 0), point(4, 0, 0),
                 point(4, -2, 0),  point(0, 0, 0), point(-4, 3, 0)};
  expect_witness(u, base, raised(base, Q(1)));
}

/// A closed strip is one at its seam: that its first ruling is its last one is no crossing.
TEST(SelfIntersection, ASeamIsNone) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)});
  for (const int bend : {0, 1, 3}) {
    const Row c{point(0, 0, 0), point(2, bend, 0), point(4, 4, 0), point(-bend, 2, 0), point(0, 0, 0)};
    EXPECT_NE(crosses(u, c, raised(c, Q(1))), Truth::yes) << bend;
  }
}

/// Only one rail is closed: the last wall, which comes back to the start of c, ends with d elsewhere and goes through
/// the first one, though both go on in the direction of x.
TEST(SelfIntersection, OneClosedRailIsNoSeam) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3), Q(4), Q(5)});
  const Row c{point(0, 0, 0), point(5, 0, 0), point(5, 0, 9), point(-5, 0, 9), point(-5, 0, 0), point(0, 0, 0)};
  const Row d{point(0, 5, 0), point(5, 5, 0), point(5, 5, 9), point(1, 5, 9), point(1, 5, 0), point(6, 5, 0)};
  expect_witness(u, c, d);
  expect_witness(u, d, c);
}

TEST(SelfIntersection, ABudgetThatRunsOutIsUnknown) {
  EXPECT_EQ(find_self_intersection<3>(bezier_knots<Q>(3), looped(), raised(looped(), Q(1)), 2).crosses, Truth::unknown);
}

/// Turned in its plane by an angle with cosine 3/5, in thirds: products that vanish do so but for their rounding.
Row turned(const std::vector<std::array<int, 2>>& corners) {
  Row row;
  for (const auto& [x, y] : corners)
    row.push_back(Point(ratio<Q>(3 * x - 4 * y, 15), ratio<Q>(4 * x + 3 * y, 15), Q(0)));
  return row;
}

/// The first ruling lies along its rail, which one look without rounding tells; 300 pairs pay for one.
TEST(SelfIntersection, ExactLooksAreRationed) {
  const Row c = turned({{0, 0}, {1, 0}}), d = turned({{-1, 0}, {1, 1}});
  const auto within = [&](long pairs) { return find_self_intersection<3>(bezier_knots<Q>(1), c, d, pairs).crosses; };
  EXPECT_EQ(within(300), Truth::no);
  EXPECT_EQ(within(299), Truth::unknown);
}

/// A strip whose last piece turns about and whose others are straight: only parts of the last one are in order, the
/// outermost of which ends on a ruling along its rail, and there only a look without rounding tells.
TEST(SelfIntersection, ExactLooksAreAtTheRightPart) {
  for (int straight = 1; straight <= 3; ++straight) {
    std::vector<std::array<int, 2>> on_c{{0, 0}, {0, 4}, {-6, 4}, {-6, 0}}, on_d{{-1, 0}, {0, 3}, {-5, 2}, {-6, -1}};
    std::vector<Q> knots(3, Q(straight + 1));
    for (int i = 1; i <= 3 * straight; ++i) {
      on_c.insert(on_c.begin(), {0, -4 * i});
      on_d.insert(on_d.begin(), {-1, -4 * i});
    }
    for (int i = straight; i >= 0; --i) knots.insert(knots.begin(), 3, Q(i));
    const KnotList<Q> u(3, knots);
    Row c = turned(on_c), d = turned(on_d);
    EXPECT_EQ(crosses(u, c, d), Truth::no);
    EXPECT_EQ(crosses(u, d, c), Truth::no);
    // Turned further by 2^-70, the last ruling crosses those before it.
    Row beyond = d;
    beyond.back()[0] -= Q::from_double(0x1p-70) * ratio<Q>(3, 5);
    beyond.back()[1] -= Q::from_double(0x1p-70) * ratio<Q>(4, 5);
    EXPECT_NE(crosses(u, c, beyond), Truth::no);
    std::ranges::reverse(c);
    std::ranges::reverse(d);
    EXPECT_EQ(crosses(u, c, d), Truth::no);
  }
}

/// A quarter of a cylinder in homogeneous rows.
TEST(SelfIntersection, RationalStrips) {
  using Row4 = std::vector<Vec<Q, 4>>;
  const auto row = [](int w, int x, int y, int z) { return Vec<Q, 4>(Q(w), Q(x), Q(y), Q(z)); };
  const Row4 c{row(1, 1, 0, 0), row(1, 1, 1, 0), row(2, 0, 2, 0)};
  const Row4 d{row(1, 1, 0, 1), row(1, 1, 1, 1), row(2, 0, 2, 2)};
  EXPECT_EQ(find_self_intersection<4>(bezier_knots<Q>(2), c, d).crosses, Truth::no);
}

/// A factor of all rows changes no point, however tiny or huge it is.
TEST(SelfIntersection, FactorsOfHomogeneousRowsDoNotMatter) {
  using Row4 = std::vector<Vec<Q, 4>>;
  const auto strip = [](const std::vector<std::array<int, 4>>& numbers, const Q& factor) {
    Row4 rows;
    for (const auto& [w, x, y, z] : numbers) rows.push_back(Vec<Q, 4>(Q(w), Q(x), Q(y), Q(z)) * factor);
    return rows;
  };
  for (const double factor : {0x1p-900, 0x1p-400, 0x1p900}) {
    const auto crosses = [&](const std::vector<std::array<int, 4>>& c, const std::vector<std::array<int, 4>>& d) {
      return find_self_intersection<4>(bezier_knots<Q>(2), strip(c, Q::from_double(factor)),
                                       strip(d, Q::from_double(factor)))
          .crosses;
    };
    EXPECT_EQ(crosses({{1, 1, 0, 0}, {1, 1, 1, 0}, {2, 0, 2, 0}}, {{1, 1, 0, 1}, {1, 1, 1, 1}, {2, 0, 2, 2}}),
              Truth::no)
        << factor;
    // From x = t to x = 1 - t.
    EXPECT_EQ(crosses({{1, 0, 0, 0}, {2, 1, 0, 0}, {1, 1, 0, 0}}, {{1, 1, 1, 0}, {2, 1, 2, 0}, {1, 0, 1, 0}}),
              Truth::yes)
        << factor;
  }
}

/// A tube whose last wall goes through its first one, and one whose last wall ends before it.
TEST(SelfIntersection, SizesDoNotMatter) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2), Q(3), Q(4)});
  for (const double size : {0x1p-900, 0x1p-300, 1.0, 0x1p300, 0x1p900}) {
    const auto tube = [&](int end) {
      Row base{point(0, 0, 0), point(2, 0, 0), point(2, 2, 0), point(1, 2, 0), point(1, end, 0)};
      for (Point& x : base) x = x * Q::from_double(size);
      return crosses(u, base, raised(base, Q::from_double(size)));
    };
    EXPECT_EQ(tube(-1), Truth::yes) << size;
    EXPECT_EQ(tube(1), Truth::no) << size;
  }
}

/// With a negative weight the first arc leaves the hull of its control points, which lie at y >= 0: it comes down to y
/// = -0.857 near x = 2.94. The last wall, at x = 2.94 from y = -20 up to -0.428, goes through it.
TEST(SelfIntersection, ANegativeWeightLeadsOutOfTheHull) {
  std::vector<Vec<Q, 4>> c;
  const auto add = [&](const Q& w, const Q& x, const Q& y) { c.push_back(Vec<Q, 4>(w, w * x, w * y, Q(0))); };
  const auto wall = [&](const Q& x, const Q& y, const Q& to_x, const Q& to_y) {
    for (int i = 1; i <= 3; ++i) {
      add(Q(1), x + ratio<Q>(i, 3) * (to_x - x), y + ratio<Q>(i, 3) * (to_y - y));
    }
  };
  add(Q(1), Q(0), Q(0));
  add(ratio<Q>(-3, 8), Q(1), Q(2));
  add(Q(1), Q(5), Q(0));
  add(Q(1), Q(6), Q(0));
  const Q place = ratio<Q>(147, 50);
  wall(Q(6), Q(0), Q(6), Q(-20));
  wall(Q(6), Q(-20), place, Q(-20));
  wall(place, Q(-20), place, ratio<Q>(-428, 1000));
  std::vector<Q> knots;
  for (int i = 0; i < 15; ++i) knots.push_back(Q(i / 3));
  for (const Q& unit : {Q(1), ratio<Q>(1, 4), ratio<Q>(-1, 4)}) {
    std::vector<Vec<Q, 4>> bottom = c;
    for (Vec<Q, 4>& row : bottom) row = scaled(unit, row);
    std::vector<Vec<Q, 4>> top = bottom;
    for (Vec<Q, 4>& row : top) row[3] = row[0];
    EXPECT_EQ(find_self_intersection<4>(KnotList<Q>(3, knots), bottom, top).crosses, Truth::yes) << unit.text();
  }
}

}  // namespace
}  // namespace torse::test
