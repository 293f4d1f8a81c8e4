// The distance of two nets: counted by hand, rounded upwards, above that of the surfaces at samples.
#include "torse/exact/repair/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "torse/algebra/determinant.hpp"
#include "torse/spline/curve.hpp"
#include "unit/exact/repair_samples.hpp"

namespace torse::test {
namespace {

TEST(RepairDistance, CountsByHand) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  RuledRows after = before;
  after.c.points[1][0] += repair::power_of_two(-50);         // 4 units in the last place of 1
  after.d.points[1][1] += Q(3) * repair::power_of_two(-51);  // 3 units of 3
  after.d.points[0][0] += repair::power_of_two(-60);         // a coordinate 0
  const NetDistance distance = distance_between(before, after);
  const double unit = std::ldexp(1, -51);
  EXPECT_DOUBLE_EQ(distance.largest, 3 * unit);
  EXPECT_NEAR(distance.root_mean_square, unit * std::sqrt((4 + 9) / 4.0), 1e-5 * unit);
  EXPECT_EQ(distance.ulps, 4);
  EXPECT_DOUBLE_EQ(distance.ulps_of_largest, 1.5);  // of 4, which are 2^-50
  EXPECT_NEAR(distance.relative, 3 * unit / std::sqrt(2.25 + 9 + 16), 1e-10 * unit);
  EXPECT_EQ(distance.weights, 0);
  EXPECT_EQ(distance.surfaces, distance.largest);

  after = before;
  after.c.weights[0] = q(4, 3);
  EXPECT_NEAR(distance_between(before, after).weights, 1 / 3.0, 1e-15);
  EXPECT_NEAR(distance_between(before, after).surfaces.value(), std::sqrt(27.25) / 3, 1e-14);
  EXPECT_NEAR(distance_between(after, before).weights, 0.25, 1e-15);
  after.c.weights[0] = Q(-1);
  EXPECT_FALSE(distance_between(before, after).surfaces);
  EXPECT_FALSE(distance_between(after, before).surfaces);
}

/// The largest coordinate is less than 1, and the box is not that of the first points.
TEST(RepairDistance, OfSmallNets) {
  const Point3 middle(q(1, 4), q(1, 4), q(1, 4));
  const RuledRows before = polynomial({middle, Point3(Q(0), q(1, 2), Q(0)), middle},
                                      {Point3(q(1, 2), Q(0), Q(0)), Point3(q(1, 2), q(1, 2), q(1, 2)), middle});
  RuledRows after = before;
  after.c.points[0][2] += repair::power_of_two(-50);  // 16 units of 1/4, 8 of 1/2
  const NetDistance distance = distance_between(before, after);
  EXPECT_EQ(distance.ulps, 16);
  EXPECT_EQ(distance.ulps_of_largest, 8);
  EXPECT_NEAR(distance.relative, std::ldexp(1, -50) / std::sqrt(3 / 4.0), 1e-28);
  EXPECT_NEAR(distance.root_mean_square, std::ldexp(1, -50) / std::sqrt(6), 1e-28);
}

/// Below 2^-1022 the unit does not get smaller.
TEST(RepairDistance, UnitsOfSubnormalCoordinates) {
  const Q least = repair::power_of_two(-1074);
  const RuledRows before = polynomial({2, Point3(least * Q(5), Q(0), Q(0))}, {2, Point3(Q(0), Q(0), Q(0))});
  RuledRows after = before;
  after.c.points[1][0] += least * Q(3);
  EXPECT_EQ(distance_between(before, after).ulps, 3);
}

/// All points in one: there is no length to compare with, and no unit where all coordinates are 0.
TEST(RepairDistance, OfNetsWithoutExtent) {
  const RuledRows before = polynomial({2, Point3(Q(0), Q(0), Q(0))}, {2, Point3(Q(0), Q(0), Q(0))});
  RuledRows after = before;
  after.d.points[1] = Point3(Q(3), Q(4), Q(0));
  const NetDistance distance = distance_between(before, after);
  EXPECT_EQ(distance.largest, 5);
  EXPECT_EQ(distance.relative, 0);
  EXPECT_FALSE(distance.ulps);
  EXPECT_EQ(distance.ulps_of_largest, 0);
  const NetDistance same = distance_between(after, after);
  EXPECT_EQ(same.ulps, 0);
  EXPECT_EQ(same.largest, 0);
}

/// Points between which no control point lies are not bounded by those.
TEST(RepairDistance, OfSurfacesWithNegativeWeightsIsNotKnown) {
  RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                {Point3(Q(0), Q(3), Q(0)), Point3(Q(1), Q(3), Q(0))});
  before.c.weights[0] = Q(-1);
  RuledRows after = before;
  after.c.points[1][0] += Q(1);
  EXPECT_EQ(distance_between(before, after).weights, 0);
  EXPECT_FALSE(distance_between(before, after).surfaces);
}

/// A length that is over a double by less than 106 bits can tell.
TEST(RepairDistance, IsRoundedUpwardsHoweverLittle) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  RuledRows after = before;
  after.d.points[0][0] += Q(1);
  after.d.points[0][1] += repair::power_of_two(-80);
  EXPECT_GT(distance_between(before, after).largest, 1);
}

/// No double has these lengths and quotients: the numbers are above, and the next ones below are not.
TEST(RepairDistance, IsRoundedUpwards) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  const auto exact = [](double x) { return Q::from_double(x); };
  const auto below = [](double x) { return Q::from_double(std::nextafter(x, 0)); };
  for (const int n : {2, 3, 5, 6, 7, 10}) {
    RuledRows after = before;
    const Q unit = repair::power_of_two(-20);
    after.c.points[1][0] += unit;
    after.c.points[1][1] += Q(n) * unit;
    const Q square = (Q(1) + Q(n * n)) * unit * unit;
    const NetDistance distance = distance_between(before, after);
    EXPECT_GE(exact(distance.largest) * exact(distance.largest), square);
    EXPECT_LT(below(distance.largest) * below(distance.largest), square);
    EXPECT_GE(Q(4) * exact(distance.root_mean_square) * exact(distance.root_mean_square), square);
    after.c.weights[0] = Q(n - 1) / Q(n);
    const double weights = distance_between(before, after).weights;
    EXPECT_GE(exact(weights), Q(1) / Q(n));
    EXPECT_LE(below(weights), Q(1) / Q(n));
  }
}

// The bound of the distance of surfaces holds at samples, also with weights that become much smaller or larger.
TEST(RepairDistance, BoundsTheSurfaces) {
  const Sample sample = rational_sample(bezier_knots<Q>(2), 71);
  const auto at_point = [&](const RuledRows& rows, const Q& t, const Q& v) {
    const Row4 p = curve_point<Q, Row4>(sample.u, homogeneous(rows.c), 1, t);
    const Row4 x = combine(Q(1) - v, p, v, curve_point<Q, Row4>(sample.u, homogeneous(rows.d), 1, t));
    return Point3(x[1] / x[0], x[2] / x[0], x[3] / x[0]);
  };
  for (const Q& factor : {q(1, 16), q(1, 4), q(51, 50), Q(4)}) {
    RuledRows other = noisy(sample.rows, -6, 72);
    other.c.weights[1] *= factor;
    const double bound = distance_between(sample.rows, other).surfaces.value();
    double largest = 0;
    for (int i = 0; i <= 10; ++i) {
      for (int k = 0; k <= 4; ++k) {
        const Point3 gap = difference(at_point(sample.rows, q(i, 10), q(k, 4)), at_point(other, q(i, 10), q(k, 4)));
        largest = std::max(largest, std::sqrt(dot(gap, gap).to_double()));
      }
    }
    EXPECT_LE(largest, bound);
    EXPECT_GE(largest, bound / 50);
  }
}

}  // namespace
}  // namespace torse::test
