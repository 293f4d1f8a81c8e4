// Rank and kernel: the kernel solves the equations, and its size is what the rank leaves.
#include "torse/algebra/linear_system.hpp"

#include <gtest/gtest.h>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using Row = Vec<Q, 4>;

Row row(int a, int b, int c, int d) { return Row(Q(a), Q(b), Q(c), Q(d)); }

Q dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

TEST(Echelon, KernelSolvesEveryEquation) {
  const std::vector<Row> equations{row(0, 2, 4, -6), row(0, 1, 2, -3), row(3, 1, 0, 5), row(3, 3, 4, -1),
                                   row(0, 0, 0, 0)};
  Echelon<Q, 4> system;
  std::vector<bool> independent;
  for (const Row& equation : equations) independent.push_back(system.insert(equation));
  EXPECT_EQ(independent, (std::vector<bool>{true, false, true, false, false}));
  EXPECT_EQ(system.rank(), 2);
  const std::vector<Row> kernel = system.kernel();
  ASSERT_EQ(kernel.size(), 2U);
  for (const Row& x : kernel) {
    for (const Row& equation : equations) EXPECT_EQ(dot(equation, x), Q(0));
  }
  Echelon<Q, 4> span;
  for (const Row& x : kernel) EXPECT_TRUE(span.insert(x));
}

TEST(Echelon, ExtremeRanks) {
  Echelon<Q, 4> none;
  EXPECT_EQ(none.kernel().size(), 4U);
  Echelon<Q, 4> all;
  for (const Row& equation : {row(0, 0, 0, 1), row(0, 0, 1, 7), row(1, 2, 3, 4), row(5, 1, 0, 0)}) {
    EXPECT_TRUE(all.insert(equation));
  }
  EXPECT_TRUE(all.kernel().empty());
}

}  // namespace
}  // namespace torse
