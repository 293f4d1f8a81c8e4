// Which families the nearest net is looked for in, and that what comes back is decided with its weights.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "torse/exact/decide/decide.hpp"
#include "unit/exact/repair_samples.hpp"

namespace torse::test {
namespace {

bool developable_rows(const KnotList<Q>& u, const RuledRows& rows) {
  return !find_witness_over_q<4>(u, homogeneous(rows.c), homogeneous(rows.d));
}

/// A plate of points that is developable; with a weight at one of them it is not.
TEST(RepairFamilies, OneRowOfUnitWeights) {
  const Sample sample = constant_sample(knots(2, {0, 0, 1, 2, 2}), 5);
  for (const bool second : {false, true}) {
    RuledRows rows = sample.rows;
    (second ? rows.d : rows.c).weights[1] = Q(2);
    ASSERT_FALSE(developable_rows(sample.u, rows));
    const auto found = nearest_developable(sample.u, rows);
    ASSERT_TRUE(found);
    EXPECT_NE(found->family, NetFamily::unchanged);
    EXPECT_TRUE(developable_rows(sample.u, found->rows));
  }
}

/// Degrees n and n - 1 up to n = 8, but 1.
TEST(RepairFamilies, DegreesOfEdges) {
  std::mt19937_64 rng(4);
  const auto draw = [&] { return q(static_cast<int>(rng() % 401) - 200, 64); };
  for (const int n : {1, 2, 3, 8, 9}) {
    std::vector<Point3> c, d;
    for (int i = 0; i <= n; ++i) {
      c.push_back(Point3(Q(2 * i), draw(), draw()));
      d.push_back(Point3(Q(2 * i), draw(), draw() + Q(9)));
    }
    const auto found = nearest_developable(bezier_knots<Q>(n), polynomial(c, d));
    ASSERT_TRUE(found);
    std::vector<int> degrees;
    for (const FamilyDistance& family : found->families) {
      if (family.family == NetFamily::edge) degrees.push_back(family.degree);
    }
    const std::vector<int> expected = n == 1 || n == 9 ? std::vector<int>{}
                                      : n == 2         ? std::vector<int>{2}
                                                       : std::vector<int>{n, n - 1};
    EXPECT_EQ(degrees, expected) << n;
  }
}

}  // namespace
}  // namespace torse::test
