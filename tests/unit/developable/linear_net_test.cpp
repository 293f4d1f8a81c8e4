// The linear construction against the oracle, a hand-computed net, and its errors.
#include "torse/developable/linear_net.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"

namespace torse::test {
namespace {

TEST(LinearNet, ByHand) {
  // n = 2 on [0, 1], L* = 3, M* = 2: d_{i+1} = ((u_{i+2}-3) c_i + (3-u_i) c_{i+1} + (2-u_{i+2}) d_i) / (2-u_i)
  const std::vector<Point3> c{point(0, 0, 0), point(2, 0, 0), point(2, 4, 0)};
  const std::vector<Point3> d = linear_net<Q, Point3>(knots(2, {0, 0, 1, 1}), c, Q(3), Q(2), point(0, 0, 8));
  EXPECT_EQ(d[0], point(0, 0, 8));
  EXPECT_EQ(d[1], point(3, 0, 4));
  EXPECT_EQ(d[2], Point3(Q(5) / Q(2), Q(6), Q(2)));
}

TEST(LinearNet, IsDevelopable) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    for (const Q& m : {Q(-1), Q(9), Q(1) / Q(2)}) {
      for (const Q& lambda : {Q(0), m, Q(-7) / Q(3)}) {
        EXPECT_TRUE(developable(u, c, linear_net<Q, Point3>(u, c, lambda, m, point(3, 5, -7))));
        EXPECT_TRUE(developable(u, c, linear_net<Q, Point3>(u, c, lambda, m, c[0])));
      }
    }
  }
}

TEST(LinearNet, OfAMovedVertexIsNot) {
  const KnotList<Q> u = knots(3, {0, 0, 0, 2, 3, 3, 5, 5, 5});
  const std::vector<Point3> c = points(u.last() + 1);
  std::vector<Point3> d = linear_net<Q, Point3>(u, c, Q(-2), Q(-1), point(3, 5, -7));
  d[3][1] += Q(1) / Q(1000000007);
  EXPECT_FALSE(developable(u, c, d));
}

TEST(LinearNet, NamesWhatIsWrong) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 2, 2});
  const std::vector<Point3> c = points(4);
  for (int m : {0, 1, 2}) {
    EXPECT_EQ(place_of([&] { return linear_net<Q, Point3>(u, c, Q(7), Q(m), c[0]); }), "M");
  }
  const KnotList<Q> unclamped = knots(2, {0, 1, 2, 4, 7});
  for (int m : {0, 1, 2, 4, 7}) {
    EXPECT_EQ(place_of([&] { return linear_net<Q, Point3>(unclamped, c, Q(9), Q(m), c[0]); }), "M");
  }
  EXPECT_EQ(place_of([&] { return linear_net<Q, Point3>(u, points(3), Q(7), Q(5), c[0]); }), "points");
  EXPECT_EQ(place_of([&] { return linear_net<Q, Point3>(u, c, Q(1), Q(5), c[0]); }), "");
  for (const auto& [k, place] : {std::pair{-1, "k"}, {4, "k"}, {0, ""}, {3, ""}}) {
    EXPECT_EQ(place_of([&, vertex = k] { return net_from<Q, Point3>(u, c, Q(1), Q(5), vertex, c[0]); }), place);
    EXPECT_EQ(place_of([&, vertex = k] { return printed_net<Q, Point3>(u, c, Q(1), Q(5), vertex, c[0]); }), place);
  }
}

TEST(RationalNet, ObeysItsEquationsAndTheOracle) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> affine = points(u.last() + 1);
    std::vector<Vec<Q, 4>> p;
    for (std::size_t i = 0; i < affine.size(); ++i) {
      const Q w = Q(static_cast<int>(i) + 2) / Q(3);
      p.push_back(Vec<Q, 4>(w, w * affine[i][0], w * affine[i][1], w * affine[i][2]));
    }
    const Q sigma = Q(-3) / Q(5);
    const std::vector<Vec<Q, 4>> q =
        rational_net<Q, Vec<Q, 4>>(u, p, Q(-3), Q(-1), sigma, Vec<Q, 4>(Q(2), Q(1), Q(4), Q(7)));
    const auto witness = find_witness<Q, 4>(u, p, q);
    EXPECT_FALSE(witness.has_value());
    EXPECT_EQ(cell_point(u, std::span<const Vec<Q, 4>>(p), 0, Q(-3)),
              scaled(sigma, cell_point(u, std::span<const Vec<Q, 4>>(q), 0, Q(-1))));
  }
  const std::vector<Vec<Q, 4>> row(3, Vec<Q, 4>(Q(1), Q(0), Q(0), Q(0)));
  EXPECT_EQ(place_of([&] {
              return rational_net<Q, Vec<Q, 4>>(knots(2, {0, 0, 1, 1}), row, Q(3), Q(2), Q(0), row[0]);
            }),
            "sigma");
}

}  // namespace
}  // namespace torse::test
