// Interpolation between two end rulings: a problem whose branches are known by hand, and its errors.
#include "torse/developable/interpolation.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"

namespace torse::test {
namespace {

/// The value at x of the polynomial with coefficients of 1, M, M^2, ...
Q horner(const std::vector<Q>& f, const Q& x) {
  Q value(0);
  for (auto coefficient = f.rbegin(); coefficient != f.rend(); ++coefficient) value = value * x + *coefficient;
  return value;
}

// One quadratic piece on [0, 1]: F(M) = (c_1-c_0)(M-1) + (c_2-c_1) M; with v = (0,0,1), w = (1,-1,0) the branch
// polynomial is [c_1-c_0, v, w] (M-1) + [c_2-c_1, v, w] M with [x, v, w] = x_0 + x_1, that is 2 (M-1) - 5 M, M_0 =
// -2/3.
const KnotList<Q> one_piece = knots(2, {0, 0, 1, 1});
const std::vector<Point3> bow{point(0, 0, 0), point(1, 1, 0), point(-3, 0, 2)};
const Point3 up = point(0, 0, 1);
const Point3 across = point(1, -1, 0);

TEST(BranchPolynomial, ByHand) {
  EXPECT_EQ((branch_polynomial<Q>(one_piece, bow, up, across)), (std::vector<Q>{Q(-2), Q(-3)}));
  EXPECT_EQ((chord_polynomial<Q, Point3>(one_piece, bow)), (std::vector<Point3>{point(-1, -1, 0), point(-3, 0, 2)}));
}

TEST(BranchPolynomial, IsTheClearedDeterminant) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point3> c = points(u.last() + 1);
    const std::vector<Q> f = branch_polynomial<Q>(u, c, point(1, 2, 3), point(-2, 0, 5));
    EXPECT_EQ(static_cast<int>(f.size()), u.last());
    for (const Q& m : {Q(-1), Q(9), Q(1) / Q(2)}) {
      Q cleared(1);
      for (int j = 0; j < u.last() - 1; ++j) cleared *= m - u[j];
      const Point3 chord = difference(c.back(), eq20<Q, Point3>(u, c, m, u.last()));
      EXPECT_EQ(horner(f, m), cleared * det3(chord, point(1, 2, 3), point(-2, 0, 5)));
    }
  }
}

TEST(InterpolatingNet, HasTheEndRulings) {
  const Q branch = Q(-2) / Q(3);
  EXPECT_EQ(horner(branch_polynomial<Q>(one_piece, bow, up, across), branch), Q(0));
  for (const Q& lambda : {Q(-4), Q(0), Q(7) / Q(2)}) {
    const std::vector<Point3> d = interpolating_net<Q>(one_piece, bow, up, across, branch, lambda);
    const EndRulings<Q> ends = end_rulings<Q>(one_piece, bow, up, across, branch, lambda);
    EXPECT_NE(ends.sigma0, Q(0));
    EXPECT_NE(ends.tau0, Q(0));
    EXPECT_EQ(difference(d.front(), bow.front()), scaled(ends.sigma0, up));
    EXPECT_EQ(difference(d.back(), bow.back()), scaled(ends.tau0, across));
    EXPECT_TRUE(developable(one_piece, bow, d));
  }
}

TEST(InterpolatingNet, OffABranchMissesTheLastRuling) {
  const std::vector<Point3> d = interpolating_net<Q>(one_piece, bow, up, across, Q(-1), Q(-4));
  EXPECT_NE(cross(difference(d.back(), bow.back()), across), point(0, 0, 0));
}

TEST(ChordCoordinates, ByHand) {
  const ChordCoordinates<Q> found = chord_coordinates(point(5, -5, -7), up, across);
  EXPECT_EQ(found.alpha, Q(-7));
  EXPECT_EQ(found.beta, Q(5));
}

TEST(InterpolatingNet, NamesWhatIsWrong) {
  EXPECT_EQ(place_of([] { return interpolating_net<Q>(one_piece, bow, up, scaled(Q(-2), up), Q(5), Q(7)); }), "v");
  EXPECT_EQ(place_of([] { return interpolating_net<Q>(one_piece, bow, up, across, Q(1), Q(7)); }), "M");
  EXPECT_EQ(place_of([] {
              return interpolating_net<Q>(knots(2, {0, 1, 2, 3}), bow, up, across, Q(5), Q(7));
            }),
            "knots");
}

}  // namespace
}  // namespace torse::test
