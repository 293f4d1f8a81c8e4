// How far surfaces are apart of which one is the other but for a point.
#include "torse/quasi/deviation.hpp"

#include <gtest/gtest.h>

#include "support/knots.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using P = Vec<Q, 3>;

/// A point of a polygon is reached, so the bound is the square of its move.
TEST(Deviation, OfPolygonsIsThatOfTheirPoints) {
  const KnotList<Q> u = test::knots(1, {0, 1, 3, 4});
  std::vector<P> c, d;
  for (int i = 0; i < 4; ++i) {
    c.push_back(P(Q(i), Q(i * i), Q(0)));
    d.push_back(P(Q(i), Q(-i), Q(5)));
  }
  const RuledSpline<Q, P> x(u, c, d);
  EXPECT_EQ(largest_deviation(x, x), Q(0));
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<P> moved = c;
    moved[i] += P(Q(1), Q(-2), ratio<Q>(1, 2));
    EXPECT_EQ(largest_deviation(x, RuledSpline<Q, P>(u, moved, d)), ratio<Q>(21, 4)) << i;
    EXPECT_EQ(largest_deviation(RuledSpline<Q, P>(u, d, moved), RuledSpline<Q, P>(u, d, c)), ratio<Q>(21, 4)) << i;
  }
}

}  // namespace
}  // namespace torse
