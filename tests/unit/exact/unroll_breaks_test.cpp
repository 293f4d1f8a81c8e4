// Where a strip is cut before it is unrolled: at the parameters where a rail, or its speed across the rulings,
// vanishes.
#include <gtest/gtest.h>

#include <vector>

#include "torse/exact/unroll/stretch.hpp"
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

/// x = 2t^3 - 3t turns back at t = 1/sqrt 2: what is around that is a stretch of its own, the only one where a factor
/// vanishes. The mark 1/2 cuts, too.
TEST(Stretches, BreakInsideOneOnly) {
  const Surface surface = bezier(rows({{0, 0, 0}, {-1, 1, 0}, {-2, 2, 0}, {-1, 3, 0}}),
                                 rows({{0, 1, 0}, {-1, 2, 0}, {-2, 3, 0}, {-1, 4, 0}}));
  const std::vector<Stretch> found = stretches(surface.strips().front(), {ratio<Q>(1, 2)});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[1].from(), ratio<Q>(1, 2));
  EXPECT_EQ(found[3].to(), Q(1));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].breaking(), i == 2) << i;
    EXPECT_EQ(found[i].from(), i > 0 ? found[i - 1].to() : Q(0));
  }
  const auto square = [](const Q& x) { return x * x; };
  EXPECT_LT(square(found[2].from()), ratio<Q>(1, 2));
  EXPECT_GT(square(found[2].to()), ratio<Q>(1, 2));
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
