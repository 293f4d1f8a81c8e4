// The determinant of a piece at integer parameters: as many of them as its degree asks for.
#include "torse/exact/decide/evaluation.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/developable/nets.hpp"

namespace torse::test {
namespace {

/// c = (t, t^2/2, 0) and d - c = (2 - t^2, -3 t^2, t): by hand det(c', d', d - c) = t (t - 1) (t - 2).
TEST(PieceEvaluator, SeesADeterminantWithZerosAtAllParametersButOne) {
  const std::vector<Integer> knots = integer_knots({Q(0), Q(0), Q(1), Q(1)});
  const std::vector<Point3> c{point(0, 0, 0), Point3(ratio<Q>(1, 2), Q(0), Q(0)), Point3(Q(1), ratio<Q>(1, 2), Q(0))};
  const std::vector<Point3> d{point(2, 0, 0), Point3(ratio<Q>(5, 2), Q(0), ratio<Q>(1, 2)),
                              Point3(Q(2), ratio<Q>(-5, 2), Q(1))};
  EXPECT_FALSE(PieceEvaluator<3>(2, knots, c, d, 1).vanishes());
  std::vector<Point3> shifted;
  for (const Point3& x : c) shifted.push_back(sum(x, point(1, -2, 4)));
  EXPECT_TRUE(PieceEvaluator<3>(2, knots, c, shifted, 1).vanishes());
}

}  // namespace
}  // namespace torse::test
