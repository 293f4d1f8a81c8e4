// The closed forms against a net computed by hand, and against one another and the recursion on larger nets.
#include "torse/developable/closed_forms.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"

namespace torse::test {
namespace {

TEST(ClosedForms, ByHand) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 1});
  const std::vector<Point3> c{point(0, 0, 0), point(2, 0, 0), point(2, 4, 0)};
  const Point3 d2(Q(5) / Q(2), Q(6), Q(2));  // see the test of linear_net
  EXPECT_EQ((eq14<Q, Point3>(u, c, Q(3), Q(2), point(0, 0, 8), 2)), d2);
  EXPECT_EQ((eq15<Q, Point3>(u, c, Q(3), Q(2), point(0, 0, 8), 2)), difference(d2, c[2]));
  EXPECT_EQ((eq16<Q, Point3>(u, c, Q(3), Q(2), point(0, 0, 8), 2)), difference(d2, c[2]));
  EXPECT_EQ(product_p(u, Q(2), 0, 2), Q(1) / Q(4));
  EXPECT_EQ(product_p(u, Q(2), 1, 1), Q(1));
  EXPECT_EQ(product_q(u, Q(2), 0, 2), Q(1) / Q(2));
  EXPECT_EQ(product_q(u, Q(2), 1, 2), Q(1));
}

TEST(ClosedForms, AgreeWithTheRecursion) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    const Point3 d0 = point(3, 5, -7);
    for (const Q& m : {Q(-1), Q(9), Q(1) / Q(2)}) {
      const Q lambda = Q(11) / Q(4);
      const std::vector<Point3> d = linear_net<Q, Point3>(u, c, lambda, m, d0);
      const std::vector<Point3> rulings = eq16_rulings<Q, Point3>(u, c, lambda, m, d0);
      ASSERT_EQ(rulings.size() + 1, d.size());
      for (int vertex = 1; vertex <= u.last(); ++vertex) {
        const std::size_t i = static_cast<std::size_t>(vertex);
        const Point3 ruling = difference(d[i], c[i]);
        EXPECT_EQ((eq14<Q, Point3>(u, c, lambda, m, d0, vertex)), d[i]);
        EXPECT_EQ((eq15<Q, Point3>(u, c, lambda, m, d0, vertex)), ruling);
        EXPECT_EQ((eq16<Q, Point3>(u, c, lambda, m, d0, vertex)), ruling);
        EXPECT_EQ(rulings[i - 1], ruling);
      }
      // The sum of 14 written with product_q, term by term.
      const int last = u.last();
      Point3 total = point(0, 0, 0);
      for (int i = 1; i < last; ++i) {
        add_scaled(total, (u[i + u.degree()] - u[i - 1]) / (m - u[i - 1]) * product_q(u, m, i, last),
                   c[static_cast<std::size_t>(i)]);
      }
      EXPECT_EQ((weighted_vertices<Q, Point3>(u, c, m, last)), total);
    }
  }
}

TEST(ClosedForms, RefuseAKnot) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 1});
  const std::vector<Point3> c = points(3);
  EXPECT_EQ(place_of([&] { return eq14<Q, Point3>(u, c, Q(3), Q(1), c[0], 1); }), "M");
  EXPECT_EQ(place_of([&] { return eq15<Q, Point3>(u, c, Q(3), Q(1), c[0], 1); }), "M");
  EXPECT_EQ(place_of([&] { return eq16<Q, Point3>(u, c, Q(3), Q(0), c[0], 1); }), "M");
  EXPECT_EQ(place_of([&] { return eq16_rulings<Q, Point3>(u, c, Q(3), Q(0), c[0]); }), "M");
}

}  // namespace
}  // namespace torse::test
