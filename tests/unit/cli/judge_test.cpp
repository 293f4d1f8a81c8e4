// A class in words.
#include "torse/cli/judge.hpp"

#include <gtest/gtest.h>

#include "unit/developable/nets.hpp"

namespace torse::cli {
namespace {

using test::point;
using test::Q;

/// Rulings from a curve towards (1, 2, 5) end half way.
TEST(Judge, ConesHaveTheirVertex) {
  RuledFile<Q> cone{bezier_knots<Q>(2), {{point(0, 0, 0), point(2, 1, 0), point(4, 0, 1)}, {Q(1), Q(1), Q(1)}}, {}};
  cone.d = cone.c;
  for (Vec<Q, 3>& x : cone.d.points) x = (x + point(1, 2, 5)) / Q(2);
  const Judgement judgement = judge(cone);
  EXPECT_TRUE(judgement.developable());
  EXPECT_EQ(describe(judgement.classification), "cone, vertex (1, 2, 5)");
}

}  // namespace
}  // namespace torse::cli
