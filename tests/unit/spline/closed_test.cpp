// Closed curves begin anywhere.
#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/spline/closed.hpp"

namespace torse {
namespace {

using Row = Vec<Rational, 4>;
using Curve = Spline<Rational, Row>;

Rational q(int p, int r = 1) { return ratio<Rational>(p, r); }

Row row(const Rational& w, const Rational& x, const Rational& y, const Rational& z) {
  Row result;
  result << w, w * x, w * y, w * z;
  return result;
}

/// A loop whose row has another weight at its end than at its begin.
Curve loop() {
  return Curve(KnotList<Rational>(2, {q(1), q(1), q(2), q(4), q(4)}),
               {row(q(1), q(0), q(0), q(1)), row(q(2), q(3), q(0), q(0)), row(q(1), q(2), q(5), q(1, 3)),
                row(q(3), q(0), q(0), q(1))});
}

Vec<Rational, 3> point(const Curve& curve, const Rational& t) {
  for (int k : curve.knots.proper_pieces()) {
    if (t <= curve.knots.piece_end(k)) {
      const Row p = curve_point(curve.knots, curve.points(), k, t);
      return p.tail<3>() / p[0];
    }
  }
  throw InvalidInput("t", "outside");
}

TEST(Closed, TellsLoopsFromOthers) {
  EXPECT_TRUE(closed(loop()));
  for (const Row& end : {row(q(3), q(1), q(0), q(1)), row(q(3), q(0), q(1), q(1)), row(q(3), q(0), q(0), q(2))}) {
    Curve open = loop();
    open.control.back() = end;
    EXPECT_FALSE(closed(open));
  }
}

/// Points without weights; without n-fold knots at its ends the curve begins and ends between them.
TEST(Closed, OfPointsToo) {
  using Flat = Vec<Rational, 3>;
  const KnotList<Rational> u(2, {q(0), q(1), q(2), q(3), q(4)});
  const std::vector<Flat> points{{q(0), q(0), q(1)}, {q(4), q(0), q(1)}, {q(5), q(5), q(0)}, {q(-1), q(-5), q(2)}};
  EXPECT_TRUE(closed(Spline<Rational, Flat>(u, points))) << "from (2, 0, 1) to (2, 0, 1)";
  std::vector<Flat> open = points;
  open.back()[2] = q(3);
  EXPECT_FALSE(closed(Spline<Rational, Flat>(u, open)));
}

/// From infinity to infinity in one direction, and from a point to the direction of it.
TEST(Closed, NoLoopRunsThroughInfinityAtItsEnds) {
  Curve at_infinity = loop();
  at_infinity.control.front() = at_infinity.control.back() = Row(q(0), q(0), q(0), q(1));
  EXPECT_FALSE(closed(at_infinity));
  Curve begin = loop();
  begin.control.front()[0] = q(0);
  EXPECT_FALSE(closed(begin));
  Curve end = loop();
  end.control.back() = Row(q(0), q(0), q(0), q(0));
  EXPECT_FALSE(closed(end));
}

TEST(Closed, RotatedRunsThroughTheSamePoints) {
  const Curve curve = loop();
  for (const Rational& begin : {q(3, 2), q(2), q(7, 2)}) {
    const Curve moved = rotated(curve, begin);
    EXPECT_EQ(moved.knots.domain_begin(), begin);
    EXPECT_EQ(moved.knots.domain_end(), begin + q(3));
    EXPECT_TRUE(closed(moved));
    for (int i = 0; i <= 12; ++i) {
      const Rational t = begin + q(i, 4);
      EXPECT_EQ(point(moved, t), point(curve, t <= q(4) ? t : t - q(3))) << begin.text() << " " << t.text();
    }
  }
}

/// With the blossom f of [2, 4] and g of [1, 2]: f(2, 2) = g(2, 2) is two thirds of f(1, 2) and one of f(2, 4), and the
/// rows of the second part are 3 times what they were, as 3 is the weight at the end and 1 that at the begin. The same
/// for rows that are all 5 times as long.
TEST(Closed, RotatedByHand) {
  for (int factor : {1, 5}) {
    Curve curve = loop();
    for (Row& r : curve.control) r *= q(factor);
    const Row middle = curve.control[1] * q(2, 3) + curve.control[2] * q(1, 3);
    const Curve moved = rotated(curve, q(2));
    EXPECT_EQ(moved.knots.list(), (std::vector<Rational>{q(2), q(2), q(4), q(4), q(5), q(5)}));
    const std::vector<Row> expected{middle, curve.control[2], curve.control[3], curve.control[1] * q(3), middle * q(3)};
    ASSERT_EQ(moved.control.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(moved.control[i], expected[i]) << i;
  }
}

TEST(Closed, RotatedNeedsAParameterInside) {
  for (const Rational& t : {q(1, 2), q(1), q(4), q(5)}) {
    EXPECT_EQ(test::told([&] { return rotated(loop(), t); }), "t: expected a parameter inside the domain") << t.text();
  }
}

}  // namespace
}  // namespace torse
