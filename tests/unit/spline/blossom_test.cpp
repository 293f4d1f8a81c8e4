// Blossoms against Cox-de Boor basis functions, against the polar forms of monomials, and against their own laws.
#include "torse/spline/blossom.hpp"

#include <gtest/gtest.h>

#include "splines.hpp"
#include "support/refusal.hpp"
#include "torse/algebra/bernstein.hpp"

namespace torse::test {
namespace {

using Line = Vec<Q, 1>;

/// The elementary symmetric polynomial of degree j.
Q symmetric(const std::vector<Q>& x, int j) {
  std::vector<Q> e(x.size() + 1, Q(0));
  e[0] = Q(1);
  for (const Q& y : x) {
    for (std::size_t i = e.size() - 1; i > 0; --i) e[i] += y * e[i - 1];
  }
  return e[static_cast<std::size_t>(j)];
}

TEST(Basis, UniformQuadraticByHand) {
  const std::vector<BinaryForm<Q>> basis = basis_forms(knots(2, {0, 1, 2, 3}), 1);  // (1-s)^2/2, 1/2 + s - s^2, s^2/2
  const Q half = Q(1) / Q(2);
  const Q expected[3][3] = {{half, Q(0), Q(0)}, {half, Q(2), half}, {Q(0), Q(0), half}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(basis[i][j], expected[i][j]) << i << ' ' << j;
  }
}

TEST(Blossom, DiagonalIsTheSumOfBasisFunctions) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point2> c = points(u);
    for (int k : u.proper_pieces()) {
      for (const Q& t : {u.piece_begin(k), u.piece_end(k), Q(1) / Q(3), Q(-11)}) {
        EXPECT_EQ((curve_point<Q, Point2>(u, c, k, t)), value(u, c, k, t));
      }
    }
  }
}

TEST(Blossom, OfMonomialsIsTheElementarySymmetricPolynomial) {
  for (const KnotList<Q>& u : knot_lists()) {
    const int n = u.degree();
    std::vector<Q> x;
    std::vector<Parameter<Q>> arguments;
    for (int i = 0; i < n; ++i) {
      x.push_back(Q(3 * i - 4) / Q(i + 2));
      arguments.push_back(at(x.back()));
    }
    for (int j = 0; j <= n; ++j) {
      std::vector<Line> c;
      for (int i = 0; i <= u.last(); ++i) {
        const std::vector<Q> block(u.list().begin() + i, u.list().begin() + i + n);
        c.push_back(Line(symmetric(block, j) / binomial<Q>(n, j)));
      }
      for (int k : u.proper_pieces()) {
        EXPECT_EQ((blossom<Q, Line>(u, c, k, arguments))[0], symmetric(x, j) / binomial<Q>(n, j));
      }
    }
  }
}

TEST(Blossom, IsSymmetricAndReproducesTheVertices) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point2> c = points(u);
    const int n = u.degree();
    for (int k : u.proper_pieces()) {
      std::vector<Parameter<Q>> v;
      for (int i = 0; i < n; ++i) v.push_back(at(Q(7 * i * i - 3) / Q(4)));
      const Point2 forward = blossom<Q, Point2>(u, c, k, v);
      std::reverse(v.begin(), v.end());
      EXPECT_EQ((blossom<Q, Point2>(u, c, k, v)), forward);
      for (int i = k - 1; i <= k + n - 1; ++i) {
        std::vector<Parameter<Q>> block;
        for (int j = i; j < i + n; ++j) block.push_back(at(u[j]));
        EXPECT_EQ((blossom<Q, Point2>(u, c, k, block)), c[static_cast<std::size_t>(i)]);
      }
    }
  }
}

TEST(Blossom, DirectionGivesTheDerivative) {
  for (const KnotList<Q>& u : knot_lists()) {
    const std::vector<Point2> c = points(u);
    for (int k : u.proper_pieces()) {
      const auto forms = piece_forms<Q, 2>(basis_forms(u, k), c, k);
      const Q length = u.piece_end(k) - u.piece_begin(k);
      const Q s = Q(2) / Q(7);
      const Q t = u.piece_begin(k) + s * length;
      const Point2 found = curve_derivative<Q, Point2>(u, c, k, t);
      for (int j = 0; j < 2; ++j) {
        const BinaryForm<Q>& f = forms[static_cast<std::size_t>(j)];
        EXPECT_EQ(found[j] * length, f.derivative_t()(Q(1) - s, s) - f.derivative_s()(Q(1) - s, s));
      }
      const auto [c0, c1] = last_pair<Q, Point2>(u, c, k, t);
      EXPECT_EQ(combine(Q(1) - s, c0, s, c1), value(u, c, k, t));
      EXPECT_EQ((tangent_point<Q, Point2>(u, c, k, t, at(u.piece_begin(k)))), c0);
      EXPECT_EQ((tangent_point<Q, Point2>(u, c, k, t, at(u.piece_end(k)))), c1);
    }
  }
}

TEST(Blossom, EachArgumentShortensTheRow) {
  const KnotList<Q> u = knots(3, {-2, -1, 0, 1, 4, 5, 7, 8});
  const std::vector<Point2> c = points(u);
  for (int r = 0; r <= u.degree(); ++r) {
    const std::vector<Parameter<Q>> v = repeated(at(Q(2)), r);
    EXPECT_EQ((blossom_row<Q, Point2>(u, c, 2, v).size()), static_cast<std::size_t>(u.degree() + 1 - r));
  }
}

TEST(Spline, ChecksTheNumberOfPoints) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 1});
  try {
    Spline<Q, Point2>(u, std::vector<Point2>(4, Point2(Q(0), Q(0))));
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place(), "points");
  }
}

TEST(Homogeneous, RoundTripAndErrors) {
  WeightedPoints<Q, 2> net{{Point2(Q(1), Q(2)), Point2(Q(-3), Q(5))}, {Q(2), Q(-7)}};
  const std::vector<Vec<Q, 3>> rows = homogeneous(net);
  EXPECT_EQ(rows[1], (Vec<Q, 3>(Q(-7), Q(21), Q(-35))));
  const WeightedPoints<Q, 2> back = dehomogenize(rows);
  EXPECT_EQ(back.points, net.points);
  EXPECT_EQ(back.weights, net.weights);
  net.weights[1] = Q(0);
  EXPECT_EQ(place_of([&] { return homogeneous(net); }), "weights[1]");
  net.weights.pop_back();
  EXPECT_EQ(place_of([&] { return homogeneous(net); }), "weights");
  EXPECT_EQ(place_of([] { return dehomogenize(std::vector<Vec<Q, 3>>{Vec<Q, 3>(Q(0), Q(1), Q(1))}); }), "weights[0]");
}

}  // namespace
}  // namespace torse::test
