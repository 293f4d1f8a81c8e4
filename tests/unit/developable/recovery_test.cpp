// Lam, M, sigma from the cells of a net that was made with known ones.
#include "torse/developable/recovery.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse {
namespace {

using namespace test;

TEST(Recovery, EveryCellOfASplineGivesTheSameFunctions) {
  const KnotList<Q> u = knots(3, {0, 1, 2, 3, 4, 5, 7, 8});
  const std::vector<Row> p{row(1, 0, 0, 1), row(2, 3, 1, 0), row(1, 4, -1, 2),
                           row(3, 1, 5, 1), row(1, 1, 1, 7), row(2, 0, 3, 4)};
  const std::vector<Row> d = rational_net<Q, Row>(u, p, Q(11), q(-1, 2), q(2, 3), row(1, 2, 2, 2));
  for (int i = 0; i < u.last(); ++i) {
    const BlossomFunctions<Q> f = cell_functions<Q>(u, p, d, i);
    EXPECT_EQ(f.lambda, Q(11)) << "cell " << i;
    EXPECT_EQ(f.m, q(-1, 2)) << "cell " << i;
    EXPECT_EQ(f.sigma, q(2, 3)) << "cell " << i;
  }
}

TEST(Recovery, ACellThatIsNotPlanarIsRefused) {
  const std::vector<Row> p{row(1, 0, 0, 0), row(1, 1, 0, 0)};
  const std::vector<Row> d{row(1, 0, 1, 0), row(1, 0, 0, 1)};
  EXPECT_EQ(place_of([&] { return cell_functions<Q>(bezier_knots<Q>(1), p, d, 0); }), "cell[0]");
}

TEST(Recovery, ACellOnALineIsRefused) {
  const std::vector<Row> p{row(1, 0, 0, 0), row(1, 1, 0, 0)};
  const std::vector<Row> d{row(1, 2, 0, 0), row(1, 3, 0, 0)};
  EXPECT_EQ(place_of([&] { return cell_functions<Q>(bezier_knots<Q>(1), p, d, 0); }), "cell[0]");
}

TEST(Recovery, AParallelogramHasInfiniteLambda) {
  const std::vector<Row> p{row(1, 0, 0, 0), row(1, 1, 0, 0)};
  const std::vector<Row> d{row(1, 0, 1, 0), row(1, 1, 1, 0)};
  EXPECT_EQ(place_of([&] { return cell_functions<Q>(bezier_knots<Q>(1), p, d, 0); }), "Lambda");
}

}  // namespace
}  // namespace torse
