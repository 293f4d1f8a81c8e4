// Parts of splines and splines brought together: the same curves, compared at parameters by de Boor's algorithm.
#include "torse/spline/compatible.hpp"

#include <gtest/gtest.h>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using P = Vec<Q, 2>;
using Curve = Spline<Q, P>;

Q q(int p, int r = 1) { return Q(p) / Q(r); }
P p(int x, int y) { return P(Q(x), Q(y)); }

/// Degree 3, unclamped, an inner double knot.
Curve cubic() {
  return Curve(KnotList<Q>(3, {q(-2), q(-1), q(0), q(1), q(1), q(5, 2), q(3), q(4), q(6)}),
               {p(0, 0), p(1, 5), p(2, -3), p(4, 4), p(5, 0), p(7, 7), p(9, 1)});
}
/// Degree 2 over [0, 1].
Curve parabola() {
  return Curve(KnotList<Q>(2, {q(0), q(0), q(1, 3), q(1), q(1)}), {p(0, 0), p(3, 2), p(1, 1), p(-4, 5)});
}

P value(const Curve& curve, const Q& t) {
  for (int k : curve.knots.proper_pieces()) {
    if (!(curve.knots.piece_end(k) < t)) return curve_point<Q, P>(curve.knots, curve.points(), k, t);
  }
  throw InvalidInput("t", "is outside");
}

void expect_same(const P& x, const P& y) {
  EXPECT_EQ(x[0], y[0]);
  EXPECT_EQ(x[1], y[1]);
}

TEST(Compatible, APartHasItsEndsAndIsTheSameCurve) {
  const Curve curve = cubic();
  for (const auto& [a, b] : {std::pair(q(0), q(3)), {q(1, 2), q(2)}, {q(1), q(5, 2)}, {q(9, 10), q(11, 10)}}) {
    const Curve part = restrict_spline(curve, a, b);
    EXPECT_EQ(part.knots.domain_begin(), a);
    EXPECT_EQ(part.knots.domain_end(), b);
    EXPECT_TRUE(definitely(part.knots.clamped()));
    expect_same(part.control.front(), value(curve, a));
    for (int i = 0; i <= 10; ++i) {
      const Q t = a + (b - a) * q(i, 10);
      expect_same(value(part, t), value(curve, t));
    }
  }
  EXPECT_THROW(restrict_spline(curve, q(-1), q(1)), InvalidInput);
  EXPECT_THROW(restrict_spline(curve, q(2), q(1)), InvalidInput);
  EXPECT_THROW(restrict_spline(curve, q(1), q(1)), InvalidInput);
}

TEST(Compatible, ReversedAndReparametrized) {
  const Curve curve = cubic();
  const Curve back = reversed_spline(curve);
  const Curve moved = reparametrized(curve, q(10), q(16));  // [0, 3] goes to [10, 16]
  for (int i = 0; i <= 12; ++i) {
    expect_same(value(back, q(3) - q(i, 4)), value(curve, q(i, 4)));
    expect_same(value(moved, q(10) + q(i, 2)), value(curve, q(i, 4)));
  }
}

TEST(Compatible, TwoCurvesGetOneKnotListAndStayThemselves) {
  const auto [c, d] = make_compatible(cubic(), parabola());
  EXPECT_EQ(c.knots.degree(), 3);
  EXPECT_EQ(c.knots.list(), d.knots.list());
  for (int i = 0; i <= 20; ++i) {
    expect_same(value(c, q(3 * i, 20)), value(cubic(), q(3 * i, 20)));
    expect_same(value(d, q(3 * i, 20)), value(parabola(), q(i, 20)));
  }
  const auto [e, f] = make_compatible(parabola(), cubic());
  for (const Curve& curve : {c, d, e, f}) EXPECT_TRUE(definitely(curve.knots.clamped()));
  EXPECT_EQ(e.knots.list(), f.knots.list());
  EXPECT_EQ(e.knots.degree(), 3);
  expect_same(value(e, q(1, 7)), value(parabola(), q(1, 7)));
  expect_same(value(f, q(1, 7)), value(cubic(), q(3, 7)));
}

TEST(Compatible, CurvesThatShareTheirKnotsAreLeftAsTheyAre) {
  const auto [c, d] = make_compatible(cubic(), cubic());
  EXPECT_EQ(c.knots.list(), cubic().knots.list());
  EXPECT_EQ(d.control.size(), cubic().control.size());
}

/// The papers' list of a line in two pieces is that of a parabola in one.
TEST(Compatible, OneListOfKnotsForTwoDegreesIsNotOne) {
  const std::vector<Q> list{q(0), q(1), q(2), q(3)};
  const Curve line{KnotList<Q>(1, list), {p(0, 0), p(3, 1), p(4, -2), p(5, 0)}};
  const Curve bow{KnotList<Q>(2, list), {p(0, 2), p(3, 1), p(4, 5)}};
  const auto [c, d] = make_compatible(line, bow);
  EXPECT_EQ(c.knots.degree(), 2);
  EXPECT_EQ(c.knots.list(), d.knots.list());
  EXPECT_EQ(c.control.size(), d.control.size());
  expect_same(value(d, q(3, 2)), value(bow, q(3, 2)));  // over [0, 3] now: 3/2 is the middle
}

/// Boehm's algorithm makes the same vertices, one knot after the other.
TEST(Refinement, IsTheInsertionOfEachKnot) {
  const Curve coarse = restrict_spline(cubic(), q(0), q(3));
  Curve fine = coarse;
  for (const Q& t : {q(1, 2), q(1, 2), q(5, 2), q(1), q(2), q(2), q(2), q(17, 10)}) fine = insert_knot(fine, t);
  const Curve at_once = refined(coarse, fine.knots);
  ASSERT_EQ(at_once.control.size(), fine.control.size());
  for (std::size_t i = 0; i < fine.control.size(); ++i) expect_same(at_once.control[i], fine.control[i]);
}

TEST(Refinement, UnitedKnotsAreThoseOfTheListThatHasThemMoreOften) {
  const KnotList<Q> u(2, {q(0), q(0), q(1), q(1), q(2), q(4), q(4)});
  const KnotList<Q> v(2, {q(0), q(0), q(1), q(3), q(3), q(4), q(4)});
  EXPECT_EQ(united_knots(u, v).list(), (std::vector<Q>{q(0), q(0), q(1), q(1), q(2), q(3), q(3), q(4), q(4)}));
}

}  // namespace
}  // namespace torse
