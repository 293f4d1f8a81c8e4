// Strips from the CAD process that no CAD file has: the program does not trust it.
#include "torse/cli/cad_surface.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "torse/io/limits.hpp"
#include "unit/developable/nets.hpp"

namespace torse::cli {
namespace {

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

}  // namespace
}  // namespace torse::cli
