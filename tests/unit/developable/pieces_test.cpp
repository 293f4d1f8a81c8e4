// The pieces of a developable spline one after the other, against the Bezier points of the spline built as a whole.
#include "torse/developable/pieces.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"
#include "torse/developable/linear_net.hpp"

namespace torse::test {
namespace {

TEST(LocalParameter, ByHandAndFromPieceToPiece) {
  const KnotList<Q> u = knots(2, {0, 0, 2, 3, 7, 7});
  EXPECT_EQ(local_parameter(u, Q(-4), 1), Q(-2));
  EXPECT_EQ(local_parameter(u, Q(-4), 2), Q(-6));
  EXPECT_EQ(local_parameter(u, Q(-4), 3), Q(-7) / Q(4));
  EXPECT_EQ(next_local(u, Q(-2), 2), Q(-6));
  EXPECT_EQ(next_local(u, Q(-6), 3), Q(-7) / Q(4));
}

TEST(AffineCell, ByHandAndFromPieceToPiece) {
  const KnotList<Q> u = knots(2, {0, 0, 2, 3, 7, 7});
  const AffineCell<Q> first = affine_from_local(Q(-2), Q(-1));  // L* = -4, M* = -2
  EXPECT_EQ(first.lam, Q(2));
  EXPECT_EQ(first.mu, Q(2));
  const AffineCell<Q> second = next_affine(u, first, 2);  // Lam_2 = -6, M_2 = -4
  EXPECT_EQ(second.lam, Q(3) / Q(2));
  EXPECT_EQ(second.mu, Q(5) / Q(4));
}

TEST(PiecewiseNet, IsTheSplineNet) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    const std::vector<Point3> d = linear_net<Q, Point3>(u, c, Q(11) / Q(4), Q(-1), point(3, 5, -7));
    const std::vector<int> pieces = u.proper_pieces();
    const auto rows =
        piecewise_net<Q, Point3>(u, c, Q(11) / Q(4), Q(-1), bezier_points<Q, Point3>(u, d, pieces.front()).front());
    ASSERT_EQ(rows.size(), pieces.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      EXPECT_EQ(rows[p], (bezier_points<Q, Point3>(u, d, pieces[p])));
    }
  }
}

TEST(AumannNet, ByHandAndItsError) {
  const std::vector<Point3> c{point(0, 0, 0), point(2, 0, 0), point(2, 4, 0)};
  const std::vector<Point3> d = aumann_net<Q, Point3>(c, Q(3), Q(2), point(0, 0, 8));
  EXPECT_EQ(d[1], point(3, 0, 4));
  EXPECT_EQ(d[2], Point3(Q(5) / Q(2), Q(6), Q(2)));
  EXPECT_EQ(place_of([&] { return aumann_net<Q, Point3>(c, Q(3), Q(0), c[0]); }), "M");
  EXPECT_EQ(place_of([&] { return aumann_net<Q, Point3>(c, Q(3), Q(1), c[0]); }), "");
}

}  // namespace
}  // namespace torse::test
