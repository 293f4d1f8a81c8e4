// Degree elevation: the elevated curve is the old curve, with every joint as smooth as it was.
#include "torse/spline/elevation.hpp"

#include <gtest/gtest.h>

#include "splines.hpp"
#include "torse/exact/ball/ball.hpp"

namespace torse::test {
namespace {

TEST(ElevatedKnots, ByHand) {
  EXPECT_EQ(elevated_knots(knots(2, {0, 0, 1, 2, 2})).list(),
            (std::vector<Q>{Q(0), Q(0), Q(0), Q(1), Q(1), Q(2), Q(2), Q(2)}));
  EXPECT_EQ(elevated_knots(knots(2, {0, 1, 2, 3})).list(), (std::vector<Q>{Q(0), Q(1), Q(1), Q(2), Q(2), Q(3)}));
}

TEST(ElevatedKnots, OfWideBallsByTheirOrder) {
  // 1/3 is no dyadic number: the ball of a knot is not decidedly equal even to itself.
  using B = Ball<128>;
  const KnotList<B> simple(2, {B::rational("-1/3"), B::rational("1/3"), B::rational("2/3"), B::rational("5/3")});
  const std::vector<B> raised = elevated_knots(simple).list();
  ASSERT_EQ(raised.size(), 6U);
  const char* const expected[] = {"-1/3", "1/3", "1/3", "2/3", "2/3", "5/3"};
  for (std::size_t i = 0; i < raised.size(); ++i) EXPECT_TRUE(raised[i].contains(expected[i]));
  const KnotList<B> clamped(2, {B::rational("1/3"), B::rational("1/3"), B::rational("2/3"), B::rational("2/3")});
  EXPECT_THROW(elevated_knots(clamped), Undecided);
}

TEST(Elevate, LeavesTheCurveAsItIs) {
  for (const KnotList<Q>& u : knot_lists()) {
    Spline<Q, Point2> curve(u, points(u));
    for (int times = 1; times <= 2; ++times) {
      curve = elevate(curve);
      EXPECT_EQ(curve.knots.degree(), u.degree() + times);
      EXPECT_EQ(curve.knots.domain_begin(), u.domain_begin());
      EXPECT_EQ(curve.knots.domain_end(), u.domain_end());
      for (int i = 0; i < u.size(); ++i) {
        if (!(u.domain_begin() < u[i] && u[i] < u.domain_end())) continue;
        EXPECT_EQ(std::count(curve.knots.list().begin(), curve.knots.list().end(), u[i]),
                  std::count(u.list().begin(), u.list().end(), u[i]) + times);
      }
      for (const Q& t : parameters(u)) EXPECT_EQ(value(curve.knots, curve.control, t), value(u, points(u), t));
    }
  }
}

TEST(Elevate, ByHand) {
  const KnotList<Q> u = bezier_knots<Q>(2);
  const Spline<Q, Point2> raised =
      elevate(Spline<Q, Point2>(u, {Point2(Q(0), Q(0)), Point2(Q(3), Q(6)), Point2(Q(6), Q(0))}));
  EXPECT_EQ(raised.control,
            (std::vector<Point2>{Point2(Q(0), Q(0)), Point2(Q(2), Q(4)), Point2(Q(4), Q(4)), Point2(Q(6), Q(0))}));
}

}  // namespace
}  // namespace torse::test
