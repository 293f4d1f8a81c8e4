// Strips from the CAD process: those that no CAD file has, as the program does not trust it, and turns about any axis.
#include "torse/cli/cad_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "torse/io/limits.hpp"
#include "torse/quasi/mapping.hpp"
#include "unit/developable/nets.hpp"

namespace torse::cli {
namespace {

using test::Q;

/// A Bezier curve of this degree along x.
CadRail straight(int degree) {
  CadRail rail;
  rail.degree = degree;
  for (const double end : {0.0, 1.0}) rail.knots.insert(rail.knots.end(), static_cast<std::size_t>(degree), end);
  for (int i = 0; i <= degree; ++i) rail.points.push_back({static_cast<double>(i), 0, 0});
  rail.weights.assign(rail.points.size(), 1);
  return rail;
}

std::string place(const CadRail& rail) {
  return test::place_of([&] { curve_file(rail, cad_identity); });
}

TEST(CadSurface, RailsThatFitTogetherOnly) {
  EXPECT_EQ(place(straight(3)), "");
  EXPECT_EQ(place(straight(limits::degree)), "");
  EXPECT_EQ(place(straight(limits::degree + 1)), "degree");
  CadRail weightless = straight(2);
  weightless.weights.pop_back();
  EXPECT_EQ(place(weightless), "weights");
  CadRail spot = straight(1);
  spot.points.pop_back();
  spot.weights.pop_back();
  EXPECT_EQ(place(spot), "weights");
}

TEST(CadSurface, PointsBeyondTheLimit) {
  CadRail polyline;
  const auto count = static_cast<std::size_t>(limits::points) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    polyline.knots.push_back(static_cast<double>(i));
    polyline.points.push_back({static_cast<double>(i), 0, 0});
  }
  polyline.weights.assign(count, 1);
  EXPECT_EQ(place(polyline), "degree");
}

std::string place_of(const CadStrip& strip) {
  return test::place_of([&] { surface_of(strip, cad_identity); });
}

/// A curve of degree n over uniform knots.
CadRail uniform(int degree, int count) {
  CadRail rail;
  rail.degree = degree;
  for (int i = 0; i < count; ++i) rail.points.push_back({static_cast<double>(i), 0, 0});
  for (int i = 0; i < count + degree + 1; ++i) rail.knots.push_back(i);
  rail.weights.assign(rail.points.size(), 1);
  return rail;
}

/// Equal degrees 64 cost 64^2 for each of the points of both: 2048 of them are 2^23.
TEST(CadSurface, RailsThatAreJoinedInTime) {
  EXPECT_EQ(place_of({.surface = CadRails{uniform(64, 1024), uniform(64, 1024)}}), "");
  EXPECT_EQ(place_of({.surface = CadRails{uniform(64, 1024), uniform(64, 1025)}}), "degree");
}

TEST(CadSurface, AnExtrusionToAPointBeginsAtOne) {
  CadRail far = straight(1);
  const CadPoint end{0, 2, 0};
  EXPECT_EQ(place_of({.surface = CadExtrusion{far, {}, end}}), "");
  far.weights[0] = 0;
  EXPECT_EQ(place_of({.surface = CadExtrusion{far, {}, end}}), "weights");
}

/// Rails of two pieces each, as polygons on a line.
TEST(CadSurface, SpeedsOfPiecesThatStandStill) {
  const auto row = [](std::vector<int> x) {
    WeightedPoints<Q, 3> points;
    for (const int t : x) points.points.push_back(Vec<Q, 3>(Q(t), Q(0), Q(0)));
    points.weights.assign(x.size(), Q(1));
    return points;
  };
  const auto proportional = [&](std::vector<int> c, std::vector<int> d) {
    return speeds_are_proportional({KnotList<Q>(1, {Q(0), Q(1), Q(2)}), row(std::move(c)), row(std::move(d))});
  };
  EXPECT_TRUE(proportional({0, 0, 2}, {5, 5, 6}));
  EXPECT_FALSE(proportional({0, 0, 2}, {5, 6, 7}));
  EXPECT_FALSE(proportional({0, 1, 3}, {5, 5, 6}));
  EXPECT_TRUE(proportional({0, 1, 3}, {5, 7, 11}));
  EXPECT_FALSE(proportional({0, 1, 3}, {5, 7, 9}));
}

std::string place_of_turn(double from, double to, double axis) {
  CadRevolution turn;
  turn.axis = {0, 0, axis};
  turn.radial = {1, 0, 0};
  turn.turn = {from, to};
  turn.meridian[0].radius = turn.meridian[1].radius = 1;
  turn.meridian[1].height = 1;
  CadStrip strip;
  strip.surface = turn;
  return test::place_of([&] { surface_of(strip, cad_identity); });
}

TEST(CadSurface, TurnsAboutAnAxis) {
  EXPECT_EQ(place_of_turn(0, 3, 1), "");
  EXPECT_EQ(place_of_turn(0, 3, 0), "turn");
  EXPECT_EQ(place_of_turn(0, 0, 1), "turn");
  EXPECT_EQ(place_of_turn(0, 7, 1), "turn");
  EXPECT_EQ(place_of_turn(0, std::numeric_limits<double>::quiet_NaN(), 1), "turn");
}

/// From the points (1, 0, 0) and (2, 0, 0), about an axis through the origin.
CadRevolution turned(const CadPoint& axis, double angle) {
  CadRevolution revolution;
  revolution.axis = axis;
  revolution.meridian = {CadMeridianEnd{.base = {1, 0, 0}}, CadMeridianEnd{.base = {2, 0, 0}}};
  revolution.turn = {0, angle};
  return revolution;
}

RuledFile<Q> surface(const CadRevolution& revolution) {
  return surface_of(CadStrip{.surface = revolution}, cad_identity);
}

CadPoint last_of(const WeightedPoints<Q, 3>& net) {
  const Vec<Q, 3>& p = net.points.back();
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

/// Rodrigues: x cos a + (n x x) sin a + n (n . x) (1 - cos a).
CadPoint rotated(const CadPoint& n, double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {cosine + n[0] * n[0] * (1 - cosine), n[2] * sine + n[0] * n[1] * (1 - cosine),
          -n[1] * sine + n[0] * n[2] * (1 - cosine)};
}

TEST(CadSurface, TurnsAboutAnyAxis) {
  for (const CadPoint& axis : {CadPoint{0, 0, 1}, CadPoint{0, 3, 0}, CadPoint{0, 3, 4}, CadPoint{2, 3, 6}}) {
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    const CadPoint n{axis[0] / length, axis[1] / length, axis[2] / length};
    for (const double angle : {0.5, 2.0, 4.0, 6.0}) {
      const RuledFile<Q> made = surface(turned(axis, angle));
      const CadPoint wanted = rotated(n, angle);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(last_of(made.c)[i], wanted[i], 1e-15);
        EXPECT_NEAR(last_of(made.d)[i], 2 * wanted[i], 2e-15);
      }
      EXPECT_EQ(made.c.points.size(), 1 + 2 * static_cast<std::size_t>(std::ceil(angle / (std::numbers::pi / 2))));
    }
  }
}

/// Every point of an arc about z has its begin's distance from the axis, exactly.
TEST(CadSurface, ArcsAreOnTheirCircleExactly) {
  const RuledFile<Q> made = surface(turned({0, 0, 1}, 4));
  const std::vector<Vec<Q, 4>> rows = homogeneous(made.c);
  for (int i = 0; i <= 12; ++i) {
    const Q t = made.knots.domain_begin() + (made.knots.domain_end() - made.knots.domain_begin()) * ratio<Q>(i, 12);
    const Vec<Q, 4> p = curve_point<Q, Vec<Q, 4>>(made.knots, rows, piece_at(made.knots, t), t);
    EXPECT_EQ(p[1] * p[1] + p[2] * p[2], p[0] * p[0]);
    EXPECT_EQ(p[3], Q(0));
  }
}

}  // namespace
}  // namespace torse::cli
