// Parts of the development: bounds that are attained, and joints at the end of a rail that stands still.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "torse/exact/unroll/arb_types.hpp"
#include "torse/exact/unroll/development.hpp"
#include "torse/exact/unroll/plate.hpp"

namespace torse {
namespace {

using Q = Rational;
using Rows = std::vector<Vec<Q, 4>>;

/// The two legs of an isosceles triangle, 5 and 5 over the base 6, are 4 away from it: the bound is attained.
TEST(Sagitta, IsTheHeightOfAnIsoscelesTriangle) {
  arb::Complex chord;
  acb_set_si(chord.get(), 6);
  const double found = sagitta(arb::real(Q(10), 64), chord);
  EXPECT_GE(found, 4);
  EXPECT_LE(found, 4 * (1 + 1e-15));
}

/// A chord that is longer than its curve, by rounding or by more, leaves no room.
TEST(Sagitta, IsNothingWhereTheChordIsLonger) {
  arb::Complex chord;
  acb_set_si(chord.get(), 2);
  EXPECT_EQ(sagitta(arb::real(Q(1), 64), chord), 0);
}

Rows rows(const std::vector<std::array<double, 3>>& points) {
  Rows result;
  for (const auto& x : points) {
    result.emplace_back(Q(1), Q::from_double(x[0]), Q::from_double(x[1]), Q::from_double(x[2]));
  }
  return result;
}

/// The rails are straight, so all that is left between the drawing and the plate is that vertices are rounded.
TEST(PlateDeviation, OfStraightRailsIsThatOfTheirVertices) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  const Rows p = rows({{0, 0, 0}, {1, 2, 0}}), q = rows({{0, 3, 0}, {2, 4, 0}});
  const auto strips = piece_strips(u, p, q);
  const Plate plate = unroll_plate(strips, {1e-2, ruling_marks(u, strips, 3), 0, false});
  EXPECT_GT(plate.vertex_error, 0);
  for (const PlateRail* rail : {&plate.c, &plate.d}) {
    for (const double x : rail->deviation) EXPECT_GE(x, plate.vertex_error);
  }
}

TEST(PlateOutline, EveryEdgeHasItsOwnSlack) {
  Plate plate{};
  plate.c.points = {{0, 0}, {1, 0}, {2, 0}};
  plate.d.points = {{0, 1}, {1, 1}, {2, 1}};
  plate.c.deviation = {0.1, 0.2};
  plate.d.deviation = {0.3, 0.4};
  plate.vertex_error = 0.05;
  EXPECT_EQ(outline_of(plate).slack, (std::vector<double>{0.1, 0.2, 0.05, 0.4, 0.3, 0.05}));
}

TEST(PlateRulings, AreMarkedInAnyOrder) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  const auto strips = piece_strips(u, rows({{0, 0, 0}, {1, 2, 0}}), rows({{0, 3, 0}, {2, 4, 0}}));
  const auto marked = [&](std::vector<Q> marks) {
    std::vector<Q> parameters;
    for (const PlateRuling& ruling : unroll_plate(strips, {1e-2, std::move(marks), 0, false}).rulings) {
      parameters.push_back(ruling.t);
    }
    return parameters;
  };
  const std::vector<Q> expected{Q(0), ratio<Q>(1, 4), ratio<Q>(1, 2), ratio<Q>(3, 4), Q(1)};
  EXPECT_EQ(marked(expected), expected);
  EXPECT_EQ(marked({ratio<Q>(3, 4), ratio<Q>(1, 4), Q(1), ratio<Q>(1, 2), Q(0)}), expected);
}

/// A square of which the first ruling, of length 5, goes from 0 to 5 i and the last from 5 to 5 + 5 i.
TEST(Development, TheFirstRulingPointsUp) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  const auto strips = piece_strips(u, rows({{1, 1, 1}, {1, 1, 6}}), rows({{4, 5, 1}, {4, 5, 6}}));
  const std::vector<Station> stations = develop(strips, {Q(0), Q(1)}, 1e-6, 100);
  const auto at = [](const arb::Complex& x, double re, double im) {
    EXPECT_NEAR(arf_get_d(arb_midref(acb_realref(x.get())), ARF_RND_NEAR), re, 1e-12);
    EXPECT_NEAR(arf_get_d(arb_midref(acb_imagref(x.get())), ARF_RND_NEAR), im, 1e-12);
  };
  at(stations.front().p, 0, 0);
  at(stations.front().q, 0, 5);
  at(stations.back().p, 5, 0);
  at(stations.back().q, 5, 5);
}

/// A rectangle of 1/4 by 1/8, drawn upwards and downwards.
TEST(PlateArea, IsPositiveForEitherOrientation) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  const Rows p = rows({{0, 0, 0}, {0.25, 0, 0}}), q = rows({{0, 0.125, 0}, {0.25, 0.125, 0}});
  for (const auto& [c, d] : {std::pair{p, q}, {q, p}}) {
    for (const bool reversed : {false, true}) {
      Rows first = c, second = d;
      if (reversed) {
        std::ranges::reverse(first);
        std::ranges::reverse(second);
      }
      const auto strips = piece_strips(u, first, second);
      const Plate plate = unroll_plate(strips, {1e-6, ruling_marks(u, strips, 2), 0, false});
      EXPECT_LE(plate.area_after.lower(), 1.0 / 32);
      EXPECT_GE(plate.area_after.upper(), 1.0 / 32);
      EXPECT_GT(plate.area_after.lower(), 0.999 / 32);
    }
  }
}

/// Two planes, 60 degrees apart. Both rails come to rest at the joint, C = (2 - 2(1-t)^2, ...), so that they have no
/// speed there that could tell of the sides. The angle is that of a sheet of any size.
TEST(PlateBends, AtAJointWhereTheRailsStandStill) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)});
  for (const double size : {1.0, 0x1p-300}) {
    const double root = size * std::sqrt(3.0);
    const auto rail = [&](double y) {
      return rows({{0, y, 0}, {2 * size, y, 0}, {2 * size, y, 0}, {2.5 * size, y, root / 2}, {3 * size, y, root}});
    };
    const auto strips = piece_strips(u, rail(0), rail(size));
    const Plate plate = unroll_plate(strips, {1e-4 * size, ruling_marks(u, strips, 2), 0, false});
    EXPECT_NEAR(plate.width / size, 4, 1e-6);
    const auto joint = std::ranges::find(plate.rulings, Q(1), &PlateRuling::t);
    ASSERT_NE(joint, plate.rulings.end());
    EXPECT_NEAR(joint->bend, 60, 1e-9);
  }
}

}  // namespace
}  // namespace torse
