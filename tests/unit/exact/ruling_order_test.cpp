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
  Tangents tangents{{Direction(0, 0, 1)}, {}, {Direction(0, 0, 5)}};
  for (const auto& [x, y] : normals) tangents.a.push_back(Direction(y, -x, 5));
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
  EXPECT_TRUE(side(with_normals({{1, 0}, {-1, 0.1}, {0, -1}})).allFinite());
  EXPECT_EQ(side(with_normals({{1, 0}, {-1, 0}})).norm(), 0);
  EXPECT_FALSE(side(with_normals({{0, 0}})).allFinite());
}

/// Rulings of a part and rails of one behind it count too: w = (0, 0, 1), t = (0, 1, 0) and w = (0, 1, 0),
/// t = (1, 0, 0). The products w x t are (-1, 0, 0), (0, 0, -1) and, of the first w and the second t, (0, 1, 0).
TEST(RulingOrder, PartsTogether) {
  const Tangents up{{Direction(0, 0, 1)}, {Direction(0, 1, 0)}, {Direction(0, 0, 0)}};
  const Tangents ahead{{Direction(0, 1, 0)}, {Direction(0, 0, 0)}, {Direction(1, 0, 0)}};
  const Direction e = common_side(std::vector{up, ahead});
  EXPECT_LT(e.x(), 0);
  EXPECT_GT(e.y(), 0);
  EXPECT_LT(e.z(), 0);
  // Of the second w and the first t it is 0.
  EXPECT_LT(std::abs(common_side(std::vector{ahead, up}).y()), 1e-15);
}

/// Normals around e_1 at nearly right angles to it: (x, y) with x = 1e-5 and y = 1, -1 and, in between, of all lengths.
TEST(RulingOrder, ANarrowSideIsFound) {
  std::vector<std::array<double, 2>> normals;
  for (const double y : {1.0, -1.0, 0.3, -0.7, 0.01, -1e-3}) normals.push_back({1e-5, y});
  const Direction e = side(with_normals(normals));
  for (const auto& [x, y] : normals) EXPECT_GT(e.x() * x + e.y() * y, 0) << y;
}

/// The tangents w = a = (1, 2t, 0) of a parabola: w(s) x a(t) = (0, 0, 2(t - s)) has one sign for s <= t only.
TEST(RulingOrder, ARailMayBeItsEdgeOfRegression) {
  const auto vector = [](int x, int y, int z) { return Vec<Rational, 3>(Rational(x), Rational(y), Rational(z)); };
  const std::vector<Vec<Rational, 3>> slope{vector(1, 0, 0), vector(1, 2, 0)};
  // b = a + a' for rails one unit of the tangent apart
  const RulingTangents<Rational> ahead{slope, slope, {vector(1, 2, 0), vector(1, 4, 0)}};
  EXPECT_EQ(on_one_side<Rational>(std::vector{ahead}, vector(0, 0, 1)), Truth::yes);
  EXPECT_EQ(on_one_side<Rational>(std::vector{ahead}, vector(0, 0, -1)), Truth::no);
  const Direction up = common_side(std::vector{Tangents{{Direction(1, 0, 0), Direction(1, 2, 0)},
                                                        {Direction(1, 0, 0), Direction(1, 2, 0)},
                                                        {Direction(1, 2, 0), Direction(1, 4, 0)}}});
  EXPECT_LT((up - Direction(0, 0, 1)).norm(), 1e-15);
  // Tangents on both sides of it, and those behind it, from the end to the beginning: (1, 2t) from 1 down to 0.
  const RulingTangents<Rational> both{slope, {vector(1, -2, 0), vector(1, 0, 0)}, {vector(1, 2, 0), vector(1, 4, 0)}};
  EXPECT_EQ(on_one_side<Rational>(std::vector{both}, vector(0, 0, 1)), Truth::no);
  EXPECT_EQ(on_one_side<Rational>(std::vector{both}, vector(0, 0, -1)), Truth::no);
}

/// The sign for s <= t of the polynomial itself, by its values, wherever the coefficients tell.
TEST(RulingOrder, TellsTheSignOfValues) {
  int told = 0;
  for (int seed = 0; seed < 400; ++seed) {
    const auto entry = [&](int k) { return (seed * 7919 + k * k * 104729 + k * 31) % 13 - 6; };
    const auto row = [&](int size, int from) {
      std::vector<Vec<Rational, 3>> points;
      for (int i = 0; i < size; ++i) {
        points.push_back(
            {Rational(entry(from + 3 * i)), Rational(entry(from + 3 * i + 1)), Rational(entry(from + 3 * i + 2))});
      }
      return points;
    };
    RulingTangents<Rational> part{row(3, 0), row(2, 20), row(4, 40)};
    // Near the tangents (1, t, 0) ahead of a parabola.
    for (int i = 0; i < 3; ++i)
      part.w[static_cast<std::size_t>(i)] += Vec<Rational, 3>(Rational(20), Rational(10 * i), Rational(0));
    for (int i = 0; i < 2; ++i)
      part.a[static_cast<std::size_t>(i)] += Vec<Rational, 3>(Rational(20), Rational(10 + 20 * i), Rational(0));
    for (int i = 0; i < 4; ++i)
      part.b[static_cast<std::size_t>(i)] += Vec<Rational, 3>(Rational(20), Rational(15 + 8 * i), Rational(0));
    const Vec<Rational, 3> e(Rational(0), Rational(0), Rational(1));
    if (on_one_side<Rational>(std::vector{part}, e) != Truth::yes) continue;
    ++told;
    const auto value = [](std::vector<Vec<Rational, 3>> points, const Rational& t) {
      for (std::size_t size = points.size(); size > 1; --size) {
        for (std::size_t i = 0; i + 1 < size; ++i) {
          for (int k = 0; k < 3; ++k) points[i][k] = (Rational(1) - t) * points[i][k] + t * points[i + 1][k];
        }
      }
      return points[0];
    };
    for (int s = 0; s <= 6; ++s) {
      for (int t = s; t <= 6; ++t) {
        const Vec<Rational, 3> w = value(part.w, ratio<Rational>(s, 6));
        for (const auto* rail : {&part.a, &part.b}) {
          const Vec<Rational, 3> x = value(*rail, ratio<Rational>(t, 6));
          const Rational product = e[0] * (w[1] * x[2] - w[2] * x[1]) + e[1] * (w[2] * x[0] - w[0] * x[2]) +
                                   e[2] * (w[0] * x[1] - w[1] * x[0]);
          EXPECT_GE(product.sign(), 0) << seed << " at " << s << ", " << t;
        }
      }
    }
  }
  EXPECT_GT(told, 20);
}

template <class S>
Truth order(const std::array<int, 3>& w, const std::vector<std::array<int, 3>>& rails, const std::array<int, 3>& e) {
  const auto vector = [](const std::array<int, 3>& x) { return Vec<S, 3>(S(x[0]), S(x[1]), S(x[2])); };
  RulingTangents<S> tangents{{vector(w)}, {}, {vector({0, 0, 0})}};
  for (const auto& rail : rails) tangents.a.push_back(vector(rail));
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
  const RulingTangents<Rational> still{{vector(0, 0, 1)}, {vector(0, 0, 1)}, {vector(0, 0, 2)}};
  const RulingTangents<Rational> moving{{vector(0, 0, 1)}, {vector(0, -1, 0)}, {vector(0, -1, 0)}};
  const Vec<Rational, 3> e = vector(1, 0, 0);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving}, e), Truth::yes);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving, moving}, e), Truth::yes);
  EXPECT_EQ(on_one_side<Rational>(std::vector{still, moving}, e), Truth::no);
  EXPECT_EQ(on_one_side<Rational>(std::vector{moving, still}, e), Truth::no);
}

TEST(RulingOrder, RoundingMayHideASign) {
  const RulingTangents<Interval> tangents{{Vec<Interval, 3>(Interval(0), Interval(0), Interval(1))},
                                          {Vec<Interval, 3>(Interval(0), Interval::hull(-1, 1), Interval(0))},
                                          {Vec<Interval, 3>(Interval(0), Interval(-1), Interval(0))}};
  const Vec<Interval, 3> e(Interval(1), Interval(0), Interval(0));
  EXPECT_EQ(on_one_side<Interval>(std::vector{tangents}, e), Truth::unknown);
}

}  // namespace
}  // namespace torse::test
