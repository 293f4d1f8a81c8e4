// The second implementations that decide the truth about drawn nets, against values by hand.
#include <gtest/gtest.h>

#include "torse/fuzz/draw/disguise.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/plain/elimination.hpp"
#include "torse/fuzz/plain/rewriting.hpp"
#include "torse/fuzz/plain/sturm.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

using Q = Rational;
using Row1 = Vec<Q, 1>;

Row1 one(const Q& x) { return Row1::Constant(x); }
Row4 row(int w, int x, int y, int z) { return {Q(w), Q(x), Q(y), Q(z)}; }

TEST(Plain, AQuadraticSplineIsItsPolynomialsAndBack) {
  // On 0, 0, 1, 3, 3 with vertices 0, 3, 0, 6: t (6 - 4 t) up to 1, where the mean of 3 and 0 by 1 : 2 is 2.
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(3), Q(3)});
  const std::vector<Row1> vertices{one(Q(0)), one(Q(3)), one(Q(0)), one(Q(6))};
  const plain::Pieces<1> curve = plain::pieces_of<1>(u, vertices);
  ASSERT_EQ(curve.rows.size(), 2U);
  EXPECT_EQ(curve.rows[0][0], (plain::Poly{Q(0), Q(6), Q(-4)}));
  EXPECT_EQ(plain::value(curve.rows[1][0], Q(1)), Q(2));
  EXPECT_EQ(plain::value(curve.rows[1][0], Q(3)), Q(6));
  EXPECT_EQ(plain::control_row<1>(curve, u), vertices);
}

TEST(Plain, SubstitutedCurvesHaveTheValuesOfTheOldOnes) {
  const plain::Pieces<4> line = plain::pieces_of<4>(bezier_knots<Q>(1), {row(1, 2, 0, 0), row(1, 4, 6, 0)});
  // t = (s + 1)/(s + 3) has s = -1 at 0; t = 1 is at infinity, so the part up to 1/2 is taken: s = 1.
  const plain::Substitution by{Q(1), Q(1), Q(1), Q(3)};
  const plain::Pieces<4> part = plain::substituted(plain::trimmed(line, Q(0), Q(1) / Q(2)), 1, by);
  EXPECT_EQ(part.breaks, (std::vector<Q>{Q(-1), Q(1)}));
  const Row4 middle = plain::value_at<4>(part.rows[0], Q(0));  // 3 times the line at 1/3
  EXPECT_EQ(middle, row(3, 8, 6, 0));
}

TEST(Plain, RepeatedRootsCountOnceAtEndsToo) {
  // t (t - 1/3)^2 (t - 1): in (a, b] the root b counts, a does not, though each interval ends at one.
  const plain::Poly square{Q(1) / Q(9), Q(-2) / Q(3), Q(1)};
  const plain::Poly f = plain::times(square, {Q(0), Q(-1), Q(1)});
  EXPECT_EQ(plain::roots_between(f, Q(-1), Q(2)), 3);
  EXPECT_EQ(plain::roots_between(f, Q(0), Q(1) / Q(3)), 1);
  EXPECT_EQ(plain::roots_between(f, Q(1) / Q(3), Q(1)), 1);
  EXPECT_EQ(plain::roots_between(f, Q(1) / Q(3), Q(1) / Q(2)), 0);
}

TEST(Plain, WhereAPolynomialIsNegative) {
  const plain::Poly two_less{Q(-2), Q(0), Q(1)};  // t^2 - 2
  const plain::Poly touching = plain::times(two_less, two_less);
  EXPECT_EQ(plain::negative_inside(touching, Q(1), Q(2)), std::nullopt);
  EXPECT_EQ(plain::negative_inside(touching, Q(0), Q(2)), std::nullopt);
  // 2^-10 lower it is below 0 where |t^2 - 2| < 1/32 only.
  const std::optional<Q> x = plain::negative_inside(plain::plus(touching, {Q(-1) / Q(1024)}), Q(0), Q(2));
  ASSERT_TRUE(x);
  EXPECT_LT(*x * *x, Q(2) + Q(1) / Q(32));
  EXPECT_GT(*x * *x, Q(2) - Q(1) / Q(32));
  // At an end alone is not inside.
  EXPECT_EQ(plain::negative_inside({Q(0), Q(1)}, Q(0), Q(1)), std::nullopt);
  EXPECT_TRUE(plain::negative_inside({Q(0), Q(1)}, Q(-1) / Q(100), Q(1)));
  EXPECT_EQ(plain::negative_inside({Q(0), Q(0)}, Q(0), Q(1)), std::nullopt);
}

TEST(Plain, RanksAndWhatIsOrthogonal) {
  plain::Rows<4> rows;
  rows.insert(row(0, 1, 2, 3));
  rows.insert(row(0, 2, 4, 6));
  EXPECT_EQ(rows.rank(), 1);
  rows.insert(row(1, 0, 1, 0));
  rows.insert(row(1, 1, 0, 0));
  ASSERT_EQ(rows.rank(), 3);
  ASSERT_EQ(rows.orthogonal().size(), 1U);
  const Row4 x = rows.orthogonal().front();
  for (const Row4& y : {row(0, 1, 2, 3), row(1, 0, 1, 0), row(1, 1, 0, 0)}) {
    EXPECT_EQ(x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3], Q(0));
  }
}

TEST(Plain, TheTwistOfTheHyperbolicParaboloidIsNotZero) {
  const KnotList<Q> u = bezier_knots<Q>(1);
  const plain::Strip strip = plain::strip_of(u, std::vector<Row4>{row(1, 0, 0, 0), row(1, 1, 0, 0)},
                                             std::vector<Row4>{row(1, 0, 1, 0), row(1, 1, 1, 1)});
  EXPECT_NE(plain::twist(strip, 0, Q(1) / Q(2)), Q(0));
  EXPECT_TRUE(plain::refuted(strip));
  EXPECT_FALSE(plain::holds_by_samples(strip));
}

TEST(Plain, ClassesByHand) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  const std::vector<Row4> p{row(1, 0, 0, 0), row(1, 1, 0, 0), row(1, 2, 3, 0)};
  const std::vector<Row4> moved{row(1, 0, 0, 5), row(1, 1, 0, 5), row(1, 2, 3, 5)};
  const std::vector<Row4> apex(3, row(1, 1, 1, 1));
  const std::vector<Row4> flat{row(1, 4, 0, 0), row(1, 1, 7, 0), row(1, 2, 5, 0)};
  EXPECT_EQ(plain::class_of(u, p, moved).name, "cylinder");
  EXPECT_EQ(*plain::class_of(u, p, moved).common, row(0, 0, 0, 1));
  EXPECT_EQ(plain::class_of(u, p, apex).name, "cone");
  EXPECT_EQ(plain::class_of(u, p, flat).name, "plane");
  // (t, t^2, t^3) and its tangents' ends: p + p'/3.
  const KnotList<Q> cubic = bezier_knots<Q>(3);
  const std::vector<Row4> c{row(3, 0, 0, 0), row(3, 1, 0, 0), row(3, 2, 1, 0), row(3, 3, 3, 3)};
  const std::vector<Row4> d{row(3, 1, 0, 0), row(9, 6, 2, 0), row(9, 9, 7, 3), row(3, 4, 5, 6)};
  std::vector<Row4> scaled_d;
  for (std::size_t i = 0; i < 4; ++i) scaled_d.push_back(torse::scaled(i % 3 == 0 ? Q(1) : Q(1) / Q(3), d[i]));
  EXPECT_TRUE(plain::holds_by_samples(plain::strip_of(cubic, c, scaled_d)));
  EXPECT_EQ(plain::class_of(cubic, c, scaled_d).name, "tangent");
}

TEST(Disguise, KeepsTheSurfaceWhereItOnlyRewritesIt) {
  // The ruling at a parameter is the same line: with knots and degrees at the same parameter.
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Choices choices = Choices::from_seed(seed);
    Draft draft = draft_free(choices, {}, Weights::nonzero);
    const plain::Strip before = plain::strip_of(draft.knots, draft.p, draft.q);
    refine(choices, {}, Weights::nonzero, draft);
    const plain::Strip after = plain::strip_of(draft.knots, draft.p, draft.q);
    const Q t = (before.p.breaks[0] + Q(2) * before.p.breaks[1]) / Q(3);
    std::size_t j = 0;
    while (after.p.breaks[j + 1] <= t) ++j;
    EXPECT_EQ(plain::value_at<4>(before.p.rows[0], t), plain::value_at<4>(after.p.rows[j], t)) << draft.disguise;
    EXPECT_EQ(plain::value_at<4>(before.q.rows[0], t), plain::value_at<4>(after.q.rows[j], t)) << draft.disguise;
  }
}

}  // namespace
}  // namespace torse::fuzz
