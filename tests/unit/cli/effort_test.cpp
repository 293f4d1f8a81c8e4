// Estimates of work on small inputs, by hand.
#include "torse/cli/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace torse::cli {
namespace {

using Q = Rational;
using Point = Vec<Q, 3>;

Point point(std::int64_t x, std::int64_t y, std::int64_t z) { return {Q(x), Q(y), Q(z)}; }

WeightedPoints<Q, 3> with_ones(std::vector<Point> points) {
  std::vector<Q> weights(points.size(), Q(1));
  return {std::move(points), std::move(weights)};
}

/// A number has the bits of its numerator, none for 0, and of its denominator: a weight 1 has 2, (0, 0, 0) has 3,
/// (3, 1/5, 0) has 3 + 4 + 1 = 8, (1, 1, 1) has 6.
TEST(Effort, CountsTheBitsThatActOnAPiece) {
  const RuledFile<Q> lines{KnotList<Q>(1, {Q(0), Q(1), Q(2)}),
                           with_ones({point(0, 0, 0), {Q(3), ratio<Q>(1, 5), Q(0)}, point(1, 1, 1)}),
                           with_ones({point(1, 1, 1), point(1, 1, 1), point(0, 0, 0)})};
  // Both rows with weights: 13, 18 and 13 bits at the three points, so 31 on each piece.
  EXPECT_EQ(effort_of(lines, 1, 1), 62);
  EXPECT_EQ(effort_of(lines, 5, 2), 2 * 31 * 31);
}

TEST(Effort, GrowsWithTheDegree) {
  const std::vector<Point> zeros(4, point(0, 0, 0));
  const RuledFile<Q> cubic{bezier_knots<Q>(3), with_ones(zeros), with_ones(zeros)};
  // 5 bits a point.
  EXPECT_EQ(effort_of(cubic, 0, 1), 40);
  EXPECT_EQ(effort_of(cubic, 2, 1), 9 * 40);
}

/// N = 3 points; a of degree 2, b of degree 4, so that D = 3 and the width is N; p = 4 of 9/2 or 15, q = 3 of 4 and 2,
/// r = 2 of 3.
TEST(Effort, OfADirectrix) {
  ConstructFile<Q> input{"directrix", bezier_knots<Q>(2),
                         with_ones({point(1, 0, 0), {ratio<Q>(2, 3), Q(0), Q(0)}, point(0, 15, 0)})};
  input.a = {Q(1), ratio<Q>(1, 4), Q(1)};
  input.b = {Q(0), ratio<Q>(9, 2), Q(1), Q(1), Q(1)};
  EXPECT_EQ(directrix_effort(input), 27 * std::pow(3 * (4 + 3) + 2, 1.5));
}

/// 12 points and D = 1, by a of degree 1 and b of degree 2: the width is 11. Zeros and ones have one bit at most.
TEST(Effort, OfADirectrixOfManyPoints) {
  ConstructFile<Q> input{"directrix", bezier_knots<Q>(11), with_ones(std::vector<Point>(12, point(0, 0, 0)))};
  input.a = {Q(1), Q(0)};
  input.b = {Q(0), Q(0), Q(1)};
  EXPECT_EQ(directrix_effort(input), 144 * 11 * std::pow(12 * (1 + 1) + 1, 1.5));
  input.a = {Q(0)};
  input.b = {};
  EXPECT_EQ(directrix_effort(input), 144 * 10 * std::pow(12 * (0 + 1) + 1, 1.5));
}

/// L = 3; knots 0, 7/2, 4: 3 + 2 bits; Lambda 5: 4 bits; points up to 6 over 3: 3 + 2 bits.
TEST(Effort, OfBranches) {
  ConstructFile<Q> input{"interpolate", KnotList<Q>(1, {Q(0), ratio<Q>(7, 2), Q(4), Q(5)}),
                         with_ones({point(0, 0, 0), point(1, 0, 0), {Q(0), ratio<Q>(1, 3), Q(0)}, point(0, 0, 1)})};
  input.va = point(0, 6, 0);
  input.vb = point(1, 0, 0);
  input.lambda = Q(5);
  EXPECT_EQ(branch_effort(input), 9 * (3 + 2 + 3 * (3 * (3 + 2) + 4)));
}

}  // namespace
}  // namespace torse::cli
