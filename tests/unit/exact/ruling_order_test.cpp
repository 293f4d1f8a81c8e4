// The side to which rulings leave each other, against directions known by hand.
#include "torse/exact/quasi/ruling_order.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/interval.hpp"

namespace torse::test {
namespace {

using Direction = Vec<double, 3>;
using Tangents = RulingTangents<double>;

/// Tangents t whose w x t for w = (0, 0, 1) are these: (x, y) is that of (y, -x).
Tangents with_normals(const std::vector<std::array<double, 2>>& normals) {
  Tangents tangents{{Direction(0, 0, 1)}, {}};
  for (const auto& [x, y] : normals) tangents.rails.push_back(Direction(y, -x, 5));
  return tangents;
}

Direction side(const Tangents& tangents) { return common_side(std::vector{tangents}); }

TEST(RulingOrder, OneNormalIsItsOwnSide) {
  EXPECT_LT((side(with_normals({{3, 4}})) - Direction(0.6, 0.8, 0)).norm(), 1e-15);
}

/// Many normals on one side pull the mean away from one on the other; (1, 0) and (-0.96, 0.28) have 16 degrees in
/// common.
TEST(RulingOrder, ASideThatTheMeanIsNot) {
  std::vector<std::array<double, 2>> normals(50, {1, 0});
  normals.push_back({-0.96, 0.28});
  const Direction e = side(with_normals(normals));
  EXPECT_NEAR(e.norm(), 1, 1e-15);
  EXPECT_GT(e.x(), 0);
  EXPECT_GT(-0.96 * e.x() + 0.28 * e.y(), 0);
}

/// Lengths do not count, as they are those of factors; zeros do not either.
TEST(RulingOrder, LengthsDoNotMatter) {
  const Direction e = side(with_normals({{1e9, 0}, {0, 1e-9}, {0, 0}}));
  EXPECT_GT(e.x(), 0.1);
  EXPECT_GT(e.y(), 0.1);
}

TEST(RulingOrder, WhereThereIsNoSideItIsAnyOrNone) {
  EXPECT_NEAR(side(with_normals({{1, 0}, {-1, 0.1}, {0, -1}})).norm(), 1, 1e-15);
  EXPECT_EQ(side(with_normals({{1, 0}, {-1, 0}})).norm(), 0);
  EXPECT_FALSE(side(with_normals({{0, 0}})).allFinite());
}

/// Rulings of one part and rails of the other count too: w = (0, 0, 1), t = (0, 1, 0) and w = (0, 1, 0), t = (1, 0, 0).
/// The products of w x t are (-1, 0, 0), (0, 0, -1), across (0, 1, 0) and 0.
TEST(RulingOrder, PartsTogether) {
  const std::vector<Tangents> parts{{{Direction(0, 0, 1)}, {Direction(0, 1, 0)}},
                                    {{Direction(0, 1, 0)}, {Direction(1, 0, 0)}}};
  const Direction e = common_side(parts);
  EXPECT_LT(e.x(), 0);
  EXPECT_GT(e.y(), 0);
  EXPECT_LT(e.z(), 0);
}

template <class S>
Truth order(const std::array<int, 3>& w, const std::vector<std::array<int, 3>>& rails, const std::array<int, 3>& e) {
  const auto vector = [](const std::array<int, 3>& x) { return Vec<S, 3>(S(x[0]), S(x[1]), S(x[2])); };
  RulingTangents<S> tangents{{vector(w)}, {}};
  for (const auto& rail : rails) tangents.rails.push_back(vector(rail));
  return on_one_side<S>(std::vector{tangents}, vector(e));
}

/// With w = (0, 0, 1) and e = (1, 0, 0) the product is e . (w x t) = -t_y.
template <class S>
void expect_signs() {
  const auto of = [](const std::vector<std::array<int, 3>>& rails) { return order<S>({0, 0, 1}, rails, {1, 0, 0}); };
  EXPECT_EQ(of({{7, -1, 3}}), Truth::yes);
  EXPECT_EQ(of({{7, -1, 3}, {0, -2, 0}}), Truth::yes);
  EXPECT_EQ(of({{7, 1, 3}}), Truth::no);
  EXPECT_EQ(of({{7, -1, 3}, {7, 1, 3}}), Truth::no);
}

TEST(RulingOrder, IsTheSignOfTheProducts) {
  expect_signs<Rational>();
  expect_signs<Interval>();
}

/// A rail at rest, or along its ruling, leaves no side; others decide.
TEST(RulingOrder, ZerosAloneAreNoOrder) {
  EXPECT_EQ(order<Rational>({0, 0, 1}, {{7, 0, 3}}, {1, 0, 0}), Truth::no);
  EXPECT_EQ(order<Rational>({0, 0, 1}, {{7, 0, 3}, {0, -1, 0}}, {1, 0, 0}), Truth::yes);
}

/// A part whose rails run along their ruling, and one beside it that leaves the ruling: together all is on one side,
/// but the rulings of the first lie upon each other.
TEST(RulingOrder, EveryPartHasToMove) {
  const auto vector = [](int x, int y, int z) { return Vec<Rational, 3>(Rational(x), Rational(y), Rational(z)); };
  const RulingTangents<Rational> still{{vector(0, 0, 1)}, {vector(0, 0, 1), vector(0, 0, 2)}};
  const RulingTangents<Rational> moving{{vector(0, 0, 1)}, {vector(0, -1, 0), vector(0, -1, 0)}};
  const Vec<Rational, 3> e = vector(1, 0, 0);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving}, e), Truth::yes);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving, moving}, e), Truth::yes);
  EXPECT_EQ(on_one_side<Rational>(std::vector{still, moving}, e), Truth::no);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving, still}, e), Truth::no);
}

TEST(RulingOrder, RoundingMayHideASign) {
  const RulingTangents<Interval> tangents{{Vec<Interval, 3>(Interval(0), Interval(0), Interval(1))},
                                          {Vec<Interval, 3>(Interval(0), Interval::hull(-1, 1), Interval(0))}};
  const Vec<Interval, 3> e(Interval(1), Interval(0), Interval(0));
  EXPECT_EQ(on_one_side<Interval>(std::vector{tangents}, e), Truth::unknown);
}

}  // namespace
}  // namespace torse::test
