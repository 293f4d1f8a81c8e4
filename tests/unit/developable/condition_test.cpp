// The oracle: surfaces known to be developable or not, by hand, and its parts against each other.
#include "torse/developable/condition.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "rational_rows.hpp"

namespace torse {
namespace {

using namespace test;

/// The tangents of (t, t^2, t^3): c = r, d = r + r'.
std::vector<Point3> cubic() {
  const Q third = q(1, 3);
  return {point(0, 0, 0), Point3(third, Q(0), Q(0)), Point3(third + third, third, Q(0)), point(1, 1, 1)};
}
std::vector<Point3> cubic_and_derivative() {  // (t + 1, t^2 + 2t, t^3 + 3t^2)
  const Q third = q(1, 3);
  return {point(1, 0, 0), Point3(Q(1) + third, third + third, Q(0)), Point3(Q(2) - third, Q(2) - third, Q(1)),
          point(2, 3, 4)};
}

std::vector<Row> lift(const std::vector<Point3>& c) {
  std::vector<Row> rows;
  for (const Point3& x : c) rows.push_back(Row(Q(1), x[0], x[1], x[2]));
  return rows;
}

TEST(Condition, TangentSurfaceIsDevelopable) {
  const KnotList<Q> u = bezier_knots<Q>(3);
  EXPECT_TRUE(developable(u, cubic(), cubic_and_derivative()));
  EXPECT_FALSE((find_witness<Q, 4>(u, lift(cubic()), lift(cubic_and_derivative()))));
}

TEST(Condition, ATinyErrorIsFound) {
  const KnotList<Q> u = bezier_knots<Q>(3);
  std::vector<Point3> d = cubic_and_derivative();
  Q tiny(1);
  for (int i = 0; i < 30; ++i) tiny /= Q(10);
  d[2][1] += tiny;
  const std::optional<DevelopabilityWitness<Q>> witness = find_witness<Q, 3>(u, cubic(), d);
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->piece, 1);
  EXPECT_NE(witness->value, Q(0));
}

TEST(Condition, TheWitnessNamesThePiece) {  // two bilinear cells, the second one not planar
  const KnotList<Q> u = knots(1, {0, 1, 2});
  const std::vector<Point3> c{point(0, 0, 0), point(1, 0, 0), point(2, 0, 0)};
  const std::vector<Point3> d{point(0, 1, 0), point(1, 1, 0), point(2, 1, 1)};
  const std::optional<DevelopabilityWitness<Q>> witness = find_witness<Q, 3>(u, c, d);
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->piece, 2);
  EXPECT_EQ(witness->coefficient, 0);
  EXPECT_EQ(witness->value, Q(1));  // [c_2-c_1, d_1-c_1, d_2-c_1]
}

TEST(Condition, DegreesOfTheDeterminants) {
  for (int n = 1; n <= 4; ++n) {
    const std::vector<Point3> c = points(n + 1, 2);
    const std::vector<Point3> d = points(n + 1, 3);
    const KnotList<Q> u = bezier_knots<Q>(n);
    EXPECT_EQ((span_determinant<Q>(u, std::span<const Point3>(c), std::span<const Point3>(d), 1).degree()),
              3 * (n - 1));
    const std::vector<Row> p = lift(c);
    const std::vector<Row> r = lift(d);
    EXPECT_EQ((span_determinant<Q>(u, std::span<const Row>(p), std::span<const Row>(r), 1).degree()), 4 * (n - 1));
  }
}

TEST(Condition, PolynomialAndRationalDeterminantsAgreeForWeightsOne) {
  const int n = 3;
  const KnotList<Q> u = knots(n, {0, 1, 2, 3, 4, 5, 7, 8});
  const std::vector<Point3> c = points(u.last() + 1, 4);
  const std::vector<Point3> d = points(u.last() + 1, 5);
  const std::vector<Row> p = lift(c);
  const std::vector<Row> r = lift(d);
  for (int k = 1; k <= u.pieces(); ++k) {
    const BinaryForm<Q> affine = span_determinant<Q>(u, std::span<const Point3>(c), std::span<const Point3>(d), k);
    const BinaryForm<Q> homogeneous = span_determinant<Q>(u, std::span<const Row>(p), std::span<const Row>(r), k);
    const Q t = q(2, 7);  // dP/ds has weight n (s+t)^{n-1}, which is n where s + t = 1
    EXPECT_EQ(homogeneous(Q(1) - t, t), Q(n) * affine(Q(1) - t, t)) << "piece " << k;
  }
}

TEST(Condition, PointwiseByHand) {  // the hyperbolic paraboloid z = t v: c = (t, 0, 0), d = (t, 1, t)
  const KnotList<Q> u = bezier_knots<Q>(1);
  const std::vector<Point3> c{point(0, 0, 0), point(1, 0, 0)};
  const std::vector<Point3> d{point(0, 1, 0), point(1, 1, 1)};
  EXPECT_EQ((pointwise_determinant<Q>(u, std::span<const Point3>(c), std::span<const Point3>(d), 1, q(1, 2))), Q(1));
  const std::vector<Row> p = lift(c);
  const std::vector<Row> r = lift(d);
  EXPECT_EQ((pointwise_determinant<Q>(u, std::span<const Row>(p), std::span<const Row>(r), 1, q(1, 2))), Q(-1));
}

// With homogeneous curves P, Q over one piece, [P, P', Q, Q'] is the determinant of the span over n^2 where s + t = 1,
// and -w^2 omega^2 times it is (d-c).(c' x d') times w^4 omega^4: the rows w (1, c), w' (1, c) + w (0, c') and so on.
TEST(Condition, PointwiseOfARationalSurfaceIsTheDeterminantOfItsSpan) {
  const int n = 3;
  const KnotList<Q> u = bezier_knots<Q>(n);
  const std::vector<Row> p = cubic_row();
  const std::vector<Row> r{row(2, 1, 1, 3), row(1, -2, 5, 1), row(5, 3, 2, -4), row(3, 0, 7, 1)};
  const BinaryForm<Q> det = span_determinant<Q>(u, std::span<const Row>(p), std::span<const Row>(r), 1);
  for (int i = 0; i <= 4; ++i) {
    const Q t = q(i, 5);
    const Q weights = value(p, t)[0] * value(r, t)[0];
    EXPECT_EQ(pointwise_determinant<Q>(u, std::span<const Row>(p), std::span<const Row>(r), 1, t),
              -weights * weights * det(Q(1) - t, t) / Q(n * n));
  }
}

}  // namespace
}  // namespace torse
