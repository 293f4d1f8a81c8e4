// Scenes: where things are drawn, and in which order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "torse/figures/scene.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::figures {
namespace {

using testing::HasSubstr;

std::vector<Vector> square(double z) { return {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}; }

TEST(Scene, DrawsWhatIsNearerLater) {
  Scene from_above(-90, 90);
  from_above.facet(square(1), "red");
  from_above.facet(square(0), "blue");
  const std::string seen = from_above.svg({0, 0, 100, 100});
  EXPECT_LT(seen.find("blue"), seen.find("red"));
  Scene from_below(-90, -90);
  from_below.facet(square(1), "red");
  from_below.facet(square(0), "blue");
  const std::string other = from_below.svg({0, 0, 100, 100});
  EXPECT_LT(other.find("red"), other.find("blue"));
}

// From the direction -y the x axis points to the right and z upwards: x = 0..4, z = 0..2 in a frame of 100 by 100 are
// scaled by 25 and centred.
TEST(Scene, FillsItsFrameWithoutChangingShapes) {
  Scene scene(-90, 0);
  scene.line({{0, 0, 0}, {4, 0, 0}}, {"black", 1});
  scene.line({{4, 0, 0}, {4, 0, 2}}, {"black", 1});
  const std::string svg = scene.svg({10, 20, 100, 100});
  EXPECT_THAT(svg, HasSubstr("d=\"M10.00 95.00L110.00 95.00\""));
  EXPECT_THAT(svg, HasSubstr("d=\"M110.00 95.00L110.00 45.00\""));
}

TEST(Scene, DrawsALineOverTheSurfaceThatItLiesIn) {
  Scene scene(-90, 60);
  scene.line({{0.4, 0.4, 0}, {0.6, 0.6, 0}}, {"green", 1});
  scene.facet(square(0), "blue");
  const std::string svg = scene.svg({0, 0, 100, 100});
  EXPECT_LT(svg.find("blue"), svg.find("green"));
}

TEST(Scene, EscapesWords) {
  Scene scene(0, 0);
  scene.word({0, 0, 0}, "a < b");
  EXPECT_THAT(scene.svg({0, 0, 10, 10}), HasSubstr(">a &lt; b</text>"));
}

TEST(Scene, RefusesPlacesThatAreNotFinite) {
  Scene scene(0, 0);
  scene.dot({0, std::numeric_limits<double>::infinity(), 0}, "red");
  EXPECT_THROW(scene.svg({0, 0, 10, 10}), InvalidInput);
}

TEST(Scene, OfNothingIsEmpty) { EXPECT_EQ(Scene(0, 0).svg({0, 0, 10, 10}), ""); }

}  // namespace
}  // namespace torse::figures
