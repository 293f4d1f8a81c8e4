// Knot insertion and Bezier extraction: the refined curve is the old curve, by Cox-de Boor values on both knot lists.
#include "torse/spline/insertion.hpp"

#include <gtest/gtest.h>

#include "splines.hpp"
#include "torse/exact/ball/ball.hpp"

namespace torse::test {
namespace {

int multiplicity(const KnotList<Q>& u, const Q& t) {
  return static_cast<int>(std::count(u.list().begin(), u.list().end(), t));
}

TEST(InsertKnot, LeavesTheCurveAsItIs) {
  for (const KnotList<Q>& u : knot_lists()) {
    const Spline<Q, Point2> curve(u, points(u));
    for (const Q& t : parameters(u)) {
      if (multiplicity(u, t) >= u.degree()) {
        EXPECT_THROW(static_cast<void>(insert_knot(curve, t)), InvalidInput);
        continue;
      }
      const Spline<Q, Point2> finer = insert_knot(curve, t);
      EXPECT_EQ(finer.knots.size(), u.size() + 1);
      EXPECT_EQ(multiplicity(finer.knots, t), multiplicity(u, t) + 1);
      EXPECT_EQ(finer.knots.domain_begin(), u.domain_begin());
      EXPECT_EQ(finer.knots.domain_end(), u.domain_end());
      for (const Q& x : parameters(finer.knots)) {
        EXPECT_EQ(value(finer.knots, finer.control, x), value(u, curve.control, x));
      }
    }
  }
}

TEST(InsertKnot, ByHand) {
  const Spline<Q, Point2> line(knots(1, {0, 4}), {Point2(Q(0), Q(0)), Point2(Q(8), Q(4))});
  const Spline<Q, Point2> finer = insert_knot(line, Q(1));
  EXPECT_EQ(finer.control[1], Point2(Q(2), Q(1)));
}

TEST(InsertKnot, RejectsParametersOutsideTheDomain) {
  const KnotList<Q> u = knots(2, {0, 1, 2, 3});
  for (const Q& t : {Q(1) / Q(2), Q(5) / Q(2)}) {
    try {
      static_cast<void>(insert_knot(Spline<Q, Point2>(u, points(u)), t));
      FAIL();
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place(), "t");
    }
  }
}

TEST(InsertKnot, DoesNotGuessWhereBallsDoNotTell) {
  using Box = Ball<128>;
  const KnotList<Box> u(2, {Box(0), Box(1), Box(2), Box(3), Box(4)});
  EXPECT_EQ(insertion_interval(u, Box(3) / Box(2)), 1);
  EXPECT_EQ(insertion_interval(u, Box::interval(2.25, 2.5)), 2);
  EXPECT_THROW(insertion_interval(u, Box::interval(0.75, 1.5)), Undecided);
  EXPECT_THROW(insertion_interval(u, Box::interval(1.5, 2.5)), Undecided);
}

TEST(BezierPoints, AreThePieceAndGiveTheVerticesBack) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point2> c = points(u);
    for (int k : u.proper_pieces()) {
      const std::vector<Point2> piece = bezier_points<Q, Point2>(u, c, k);
      const KnotList<Q> local = bezier_knots(u.degree(), u.piece_begin(k), u.piece_end(k));
      const std::vector<Point2> part = restricted_points<Q, Point2>(u, c, k, Q(-3), Q(5));
      for (int i = 0; i <= 5; ++i) {
        const Q t = Q(2 * i - 3) / Q(3);
        EXPECT_EQ(value(local, piece, 1, t), value(u, c, k, t));
        EXPECT_EQ(value(bezier_knots(u.degree(), Q(-3), Q(5)), part, 1, t), value(u, c, k, t));
      }
      for (int i = k - 1; i <= k + u.degree() - 1; ++i) {
        EXPECT_EQ((spline_vertex<Q, Point2>(u, piece, k, i)), c[static_cast<std::size_t>(i)]);
      }
    }
  }
}

}  // namespace
}  // namespace torse::test
