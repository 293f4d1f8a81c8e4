// Pieces as polynomials in the global parameter, against the forms and the basis functions they are made of.
#include "torse/spline/piece_polynomials.hpp"

#include <gtest/gtest.h>

#include "splines.hpp"

namespace torse::test {
namespace {

TEST(PiecePolynomials, InParameterIsTheFormAtItsTwoArguments) {
  const BinaryForm<Q> f(std::vector<Q>{Q(2), Q(-3), Q(0), Q(5)});
  const Q a = ratio<Q>(-1, 3);
  const Q b = ratio<Q>(7, 2);
  const Polynomial<Q> g = in_parameter(f, a, b);
  for (int i = -2; i <= 4; ++i) {
    const Q t(i);
    EXPECT_EQ(g(t), f((b - t) / (b - a), (t - a) / (b - a)));
  }
}

TEST(PiecePolynomials, AreTheCurve) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point2> c = points(u);
    for (int k : u.proper_pieces()) {
      const PolynomialRow<Q, 2> row = piece_polynomials<Q, 2>(u, c, k);
      for (int i = -1; i <= 5; ++i) {
        const Q t = u.piece_begin(k) + ratio<Q>(i, 3) * (u.piece_end(k) - u.piece_begin(k));
        EXPECT_EQ(Point2(row[0](t), row[1](t)), value(u, c, k, t));
      }
    }
  }
}

/// Over an interval that does not begin at 0, with a degree more than that of the polynomials.
TEST(PiecePolynomials, BezierRowsAreTheSamePolynomials) {
  const std::array<Polynomial<Q>, 2> row{Polynomial<Q>(std::vector<Q>{Q(3), Q(-1), Q(2)}),
                                         Polynomial<Q>(std::vector<Q>{Q(0), Q(5)})};
  const Q a(2), b = ratio<Q>(7, 2);
  for (const int degree : {2, 3, 5}) {
    const std::vector<Point2> points = bezier_rows(row, degree, a, b);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(degree) + 1);
    for (int i = -1; i <= 4; ++i) {
      const Q t = a + ratio<Q>(i, 3) * (b - a);
      EXPECT_EQ(Point2(row[0](t), row[1](t)), value(bezier_knots<Q>(degree, a, b), points, 1, t));
    }
  }
}

}  // namespace
}  // namespace torse::test
