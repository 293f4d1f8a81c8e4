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

}  // namespace
}  // namespace torse::test
