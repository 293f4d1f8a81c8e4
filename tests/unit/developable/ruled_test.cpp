// Rows of a ruled surface that do not fit its knots.
#include "torse/developable/ruled.hpp"

#include <gmock/gmock.h>

#include "support/refusal.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using Point = Vec<Q, 3>;

std::string refusal(std::size_t first, std::size_t second) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(2), Q(2)});  // for 4 points
  return test::told([&] {
    return RuledSpline<Q, Point>(u, std::vector<Point>(first, Point(Q(0), Q(0), Q(0))),
                                 std::vector<Point>(second, Point(Q(0), Q(0), Q(0))));
  });
}

TEST(RuledSpline, TellsWhichRowHasHowManyPoints) {
  EXPECT_EQ(refusal(4, 4), "");
  EXPECT_EQ(refusal(3, 4), "c.points: expected 4 control points, found 3");
  EXPECT_EQ(refusal(4, 6), "d.points: expected 4 control points, found 6");
}

}  // namespace
}  // namespace torse
