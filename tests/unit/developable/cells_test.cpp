// Nets by cells against the linear construction, and cones, cylinders and errors.
#include "torse/developable/cells.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"
#include "torse/developable/special.hpp"

namespace torse::test {
namespace {

TEST(CellNet, IsTheLinearNet) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    for (const Q& m : {Q(-1), Q(9), Q(1) / Q(2)}) {
      const Q lambda = Q(11) / Q(4);
      EXPECT_EQ((cell_net<Q, Point3>(u, c, first_cell(u, lambda, m), point(3, 5, -7))),
                (linear_net<Q, Point3>(u, c, lambda, m, point(3, 5, -7))));
    }
  }
}

TEST(CellNet, WithMOneIsACone) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    const std::vector<Point3> d = cell_net<Q, Point3>(u, c, {Q(3), Q(1)}, point(3, 5, -7));
    EXPECT_EQ(d, (cone_net<Q, Point3>(c, Q(3), point(3, 5, -7))));
    EXPECT_TRUE(developable(u, c, d));
  }
}

TEST(CellNet, WithLOneIsACylinder) {
  const KnotList<Q> u = knots(3, {0, 1, 2, 3, 4, 5, 7, 8});
  const std::vector<Point3> c = points(u.last() + 1);
  Cell<Q> cell{Q(1), Q(1) / Q(2)};
  const std::vector<Point3> d = cell_net<Q, Point3>(u, c, cell, point(3, 5, -7));
  for (int i = 2; i <= u.last(); ++i) {
    cell = next_cell(u, cell, i);
    EXPECT_EQ(cell.l, Q(1));
    EXPECT_EQ(cross(difference(d[static_cast<std::size_t>(i)], c[static_cast<std::size_t>(i)]), difference(d[0], c[0])),
              point(0, 0, 0));
  }
}

TEST(CellNet, IsConstantOnABezierPiece) {
  const KnotList<Q> u = knots(3, {0, 0, 0, 2, 2, 2});
  const Cell<Q> first{Q(5) / Q(3), Q(-2)};
  for (int i = 2; i <= 3; ++i) {
    EXPECT_EQ(next_cell(u, first, i).l, first.l);
    EXPECT_EQ(next_cell(u, first, i).m, first.m);
  }
}

TEST(CellNet, NamesWhatIsWrong) {
  const KnotList<Q> u = knots(2, {0, 1, 2, 3, 4});
  const std::vector<Point3> c = points(4);
  EXPECT_EQ(place_of([&] { return first_cell(u, Q(7), Q(2)); }), "M");
  EXPECT_EQ(place_of([&] { return cell_net<Q, Point3>(u, c, {Q(3), Q(-1)}, c[0]); }), "cell[2]");  // M* = u_1
  EXPECT_EQ(place_of([&] { return cell_net<Q, Point3>(u, c, {Q(3), Q(0)}, c[0]); }), "cell[3]");   // M* = u_2
  EXPECT_EQ(place_of([&] { return cell_net<Q, Point3>(u, points(5), {Q(3), Q(5)}, c[0]); }), "points");
}

}  // namespace
}  // namespace torse::test
