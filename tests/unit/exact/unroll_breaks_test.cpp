// Where a strip is cut before it is unrolled: at the parameters where a rail, or its speed across the rulings,
// vanishes.
#include <gtest/gtest.h>

#include <vector>

#include "unit/exact/unroll_surfaces.hpp"

namespace torse::test {
namespace {

std::vector<double> breaks(const Surface& surface) {
  std::vector<double> found;
  const std::vector<PieceStrip> strips = surface.strips();
  for (const RealRoot& x : strips.front().breaks) found.push_back(x.lower.to_double());
  return found;
}

/// x = 3t^2/2 - t turns back at t = 1/3 while y = t goes on, under rulings along y: no rail stands still, but both run
/// along their ruling there, which polynomials of degree 1 tell.
TEST(PieceStrips, BreakWhereARailRunsAlongItsRuling) {
  EXPECT_EQ(
      breaks(bezier(rows({{0, 0, 0}, {-0.5, 0.5, 0}, {0.5, 1, 0}}), rows({{0, 1, 0}, {-0.5, 1.5, 0}, {0.5, 2, 0}}))),
      std::vector<double>{1.0 / 3});
}

/// A triangle with its tip for a rail, whose speed is 0 everywhere: that is no break. The other rail turns back.
TEST(PieceStrips, BreakBesideARailThatIsAPoint) {
  const Surface triangle =
      bezier(rows({{0, -5, 0}, {0, -5, 0}, {0, -5, 0}}), rows({{0, 1, 0}, {-0.5, 1, 0}, {0.5, 1, 0}}));
  EXPECT_EQ(breaks(triangle), std::vector<double>{1.0 / 3});
  const std::vector<SingularSet> obstacles = find_obstacles(triangle.strips());
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_EQ(obstacles.front().reason, Singularity::stationary);
}

TEST(PieceStrips, DoNotBreakAtTheirEndsOrBeyond) {
  const auto turning_at = [](double x1, double x2) {
    return breaks(bezier(rows({{0, 0, 0}, {x1, 0.5, 0}, {x2, 1, 0}}), rows({{0, 1, 0}, {x1, 1.5, 0}, {x2, 2, 0}})));
  };
  EXPECT_EQ(turning_at(0, 1), std::vector<double>{});      // x = t^2
  EXPECT_EQ(turning_at(0.5, 2), std::vector<double>{});    // x = t + t^2, which turns at -1/2
  EXPECT_EQ(turning_at(-1.5, -2), std::vector<double>{});  // x = t^2 - 3t, which turns at 3/2
}

}  // namespace
}  // namespace torse::test
