// What keeps a strip from being unrolled, and where, by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "unit/exact/unroll_surfaces.hpp"

namespace torse::test {
namespace {

using ::testing::SizeIs;

/// The first obstacle by reason and place.
std::pair<Singularity, std::array<double, 2>> first_obstacle(const Surface& surface) {
  const std::vector<SingularSet> sets = find_obstacles(surface.strips());
  EXPECT_FALSE(sets.empty());
  if (sets.empty()) return {};
  return {sets.front().reason, {sets.front().from.root.lower.to_double(), sets.front().to.root.lower.to_double()}};
}

TEST(Obstacles, AreNamedWithTheirParameters) {
  using enum Singularity;
  const auto at = [](Singularity reason, double from, double to) {
    return std::pair(reason, std::array<double, 2>{from, to});
  };
  // Planar rails that cross at t = 1/2.
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 1, 0}}), rows({{0, 1, 0}, {1, 0, 0}}))),
            at(vanishing, 0.5, 0.5));
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 1, 0}}), rows({{0, 0, 0}, {1, 1, 0}}))), at(vanishing, 0, 1));
  // Rails 4 t^2 - 1 apart: they cross at t = -1/2 too, outside.
  EXPECT_EQ(
      first_obstacle(bezier(rows({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}), rows({{0, -1, 0}, {0.5, -1, 0}, {1, 3, 0}}))),
      at(vanishing, 0.5, 0.5));
  // A plane whose edge of regression comes between the rails: the D rail turns back at t = 1/2.
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), rows({{0, 1, 0}, {1, 1, 0}, {0, 1, 0}}))),
            at(edge, 0.5, 1));
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 0, 0}}, {1, -1}), rows({{0, 1, 0}, {1, 1, 0}}))),
            at(pole, 0.5, 0.5));
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 0, 0}}), rows({{3, 0, 0}, {5, 0, 0}}))), at(no_surface, 0, 1));
  // A cylinder whose section comes back on its own way.
  EXPECT_EQ(first_obstacle(bezier(rows({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}), rows({{0, 1, 0}, {1, 1, 0}, {0, 1, 0}}))),
            at(stationary, 0.5, 0.5));
  EXPECT_THAT(find_obstacles(tangent_surface().strips()), SizeIs(0));
}

/// A wall that comes back on its own way, at rest where it turns or not; one that turns by a right angle goes on.
TEST(Obstacles, ASheetThatTurnsBackAtAKnot) {
  const auto wall = [](const KnotList<Q>& u, std::vector<std::array<double, 3>> c) {
    std::vector<std::array<double, 3>> d = c;
    for (auto& x : d) x[1] += 1;
    return find_obstacles(Surface{u, rows(c), rows(d)}.strips());
  };
  const KnotList<Q> corner(1, {Q(0), Q(1), Q(3)});
  const KnotList<Q> smooth(2, {Q(0), Q(0), Q(1), Q(2), Q(2)});
  const auto back = wall(corner, {{0, 0, 0}, {1, 0, 2}, {0, 0, 0}});
  ASSERT_THAT(back, SizeIs(1));
  EXPECT_EQ(back[0].reason, Singularity::stationary);
  EXPECT_EQ(back[0].from.root.lower, Q(1));
  EXPECT_EQ(back[0].to.root.upper, Q(1));
  ASSERT_THAT(wall(smooth, {{0, 0, 0}, {1, 0, 2}, {1, 0, 2}, {0, 0, 0}}), SizeIs(1));
  EXPECT_THAT(wall(corner, {{0, 0, 0}, {1, 0, 1}, {2, 0, 0}}), SizeIs(0));
  EXPECT_THAT(wall(smooth, {{0, 0, 0}, {1, 0, 1}, {1, 0, 1}, {2, 0, 0}}), SizeIs(0));
  EXPECT_THAT(wall(corner, {{0, 0, 0}, {1, 0, 2}, {2, 0, 4}}), SizeIs(0));
}

/// Two triangles at a common corner. A ruling of length zero at either end of the surface is none.
TEST(Obstacles, ARulingOfLengthZeroAtAKnotInside) {
  const KnotList<Q> u(1, {Q(0), Q(1), Q(2)});
  const Surface bow{u, rows({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), rows({{0, 1, 0}, {1, 0, 0}, {2, 1, 0}})};
  const auto [reason, place] = first_obstacle(bow);
  EXPECT_EQ(reason, Singularity::vanishing);
  EXPECT_EQ(place, (std::array<double, 2>{1, 1}));
  const Surface roof{u, rows({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), rows({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}})};
  EXPECT_THAT(find_obstacles(roof.strips()), SizeIs(0));
}

}  // namespace
}  // namespace torse::test
