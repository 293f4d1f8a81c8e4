// The edge of regression against v of FJ21.6.1, the vertex and direction that made a net, and the curve whose tangents
// were taken; the constant patch against recovery and against the rulings of the piece.
#include "torse/developable/piece_edge.hpp"

#include <gtest/gtest.h>

#include "rational_rows.hpp"
#include "torse/algebra/linear_system.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse {
namespace {

using namespace test;
using Ratio = PolynomialFraction<Q>;
using Rows = std::vector<Row>;

Row at_parameter(const PolynomialRow<Q, 4>& x, const Q& t) { return Row(x[0](t), x[1](t), x[2](t), x[3](t)); }

/// Whether the rows span a space of this dimension at most.
bool rank_at_most(int dimension, const Rows& rows) {
  Echelon<Q, 4> echelon;
  for (const Row& x : rows) echelon.insert(x);
  return echelon.rank() <= dimension;
}

/// Whether the patch has the rulings of the piece, and its own functions are the constants it claims.
void expect_patch(const PieceFunctions<Q>& f, const ConstantPatch<Q>& patch) {
  const KnotList<Q> u = bezier_knots<Q>(static_cast<int>(patch.p.size()) - 1, f.begin, f.end);
  const auto back = recover_piece<Q>(u, patch.p, patch.q, 1);
  ASSERT_TRUE(back.constant());
  EXPECT_EQ(*back.lambda()->constant_value(), patch.lambda);
  EXPECT_EQ(*back.m()->constant_value(), patch.m);
  EXPECT_EQ(*back.sigma()->constant_value(), Q(1));
  for (int i = 0; i < 6; ++i) {
    const Q t = q(3 * i + 1, 17);
    EXPECT_TRUE(rank_at_most(
        2, {at_parameter(f.p, t), at_parameter(f.q, t), at_parameter(back.p, t), at_parameter(back.q, t)}));
  }
}

TEST(PieceEdge, Section8) {
  const proofs::Section8Net<Q> net({});
  const auto f = recover_piece<Q>(net.u, net.p, net.q, 1);
  const auto edge = edge_of(f);
  ASSERT_TRUE(edge && edge->v);
  EXPECT_EQ(as_text(*edge->v), "3/2 t + 3");
  EXPECT_EQ(edge->degree, 4);
  const auto patch = constant_patch(f, *edge);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->lambda, q(-4, 3));
  EXPECT_EQ(patch->m, Q(-2));
  // The piece itself, up to one factor.
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(rank_at_most(1, {patch->p[i], net.p[i]}));
    EXPECT_TRUE(rank_at_most(1, {patch->q[i], net.q[i]}));
  }
  expect_patch(f, *patch);
}

TEST(PieceEdge, DegreeAndCurveStayUnderElevationAndTrimming) {
  const proofs::Section8Net<Q> net({});
  const auto before = edge_of(recover_piece<Q>(net.u, net.p, net.q, 1));
  const Linear<Q> f{Q(2), q(1, 3)}, g{q(3, 2), q(-1, 5)};
  const auto piece = recover_piece<Q>(bezier_knots<Q>(4), times_linear(net.p, f), times_linear(net.q, g), 1);
  const auto after = edge_of(piece);
  EXPECT_EQ(after->degree, 4);
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(rank_at_most(1, {at_parameter(before->row, q(i, 5)), at_parameter(after->row, q(i, 5))}));
  }
  const auto patch = constant_patch(piece, *after);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->p.size(), 4U);
  expect_patch(piece, *patch);
}

/// The tangents of (t^3, t^2, t): the degree is that of the first coordinate, not of the last.
TEST(PieceEdge, DegreeIsThatOfTheHighestCoordinate) {
  const Q third = q(1, 3), one(1), zero(0);
  const Rows c{row(1, 0, 0, 0), Row(one, zero, zero, third), Row(one, zero, third, third + third), row(1, 1, 1, 1)};
  Rows d = c;  // c + c'
  const Rows speed{Row(zero, zero, zero, one), Row(zero, zero, third + third, one), Row(zero, one, third + one, one),
                   row(0, 3, 2, 1)};
  for (std::size_t i = 0; i < 4; ++i) add(d[i], speed[i]);
  const auto edge = edge_of(recover_piece<Q>(bezier_knots<Q>(3), c, d, 1));
  ASSERT_TRUE(edge.has_value());
  EXPECT_EQ(edge->degree, 3);
  EXPECT_TRUE(rank_at_most(1, {at_parameter(edge->row, q(2, 5)), Row(one, q(8, 125), q(4, 25), q(2, 5))}));
}

TEST(PieceEdge, IsThePapersFormula) {
  const Rows p = cubic_row();
  const Rows d = rational_net<Q, Row>(bezier_knots<Q>(3), p, q(7, 3), q(-5, 2), q(3, 4), row(1, 1, 2, 2));
  const Linear<Q> f{Q(2), q(1, 3)}, g{q(3, 2), q(-1, 5)};
  const auto piece = recover_piece<Q>(bezier_knots<Q>(4), times_linear(p, f), times_linear(d, g), 1);
  const auto edge = edge_of(piece);
  EXPECT_TRUE(*edge->v == edge_parameter(Ratio::variable(), *piece.blossom()));
  // The rulings touch it.
  for (int i = 0; i < 6; ++i) {
    const Q t = q(2 * i + 1, 7);
    EXPECT_TRUE(rank_at_most(2, {at_parameter(piece.p, t), at_parameter(piece.q, t), at_parameter(edge->row, t),
                                 at_parameter(derivative(edge->row), t)}));
  }
}

/// Constants with another sigma are not those of a patch with sigma 1: it starts at the parameters before the piece.
TEST(PieceEdge, AnotherSigmaHasAPatchOfItsOwn) {
  const Rows p = cubic_row();
  const Rows d = rational_net<Q, Row>(bezier_knots<Q>(3), p, q(7, 3), q(-5, 2), q(3, 4), row(1, 1, 2, 2));
  const auto piece = recover_piece<Q>(bezier_knots<Q>(3), p, d, 1);
  ASSERT_TRUE(piece.constant());
  const auto edge = edge_of(piece);
  EXPECT_EQ(edge->degree, 4);
  const auto patch = constant_patch(piece, *edge);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->m, Q(-1));
  EXPECT_EQ(patch->lambda, Q(-2));
  expect_patch(piece, *patch);
}

TEST(PieceEdge, OfAConeIsItsVertex) {
  Rows d = cubic_row();
  int factor = 1;
  for (Row& x : d) add_scaled(x, Q(factor++), row(2, 3, 4, 5));
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), d, 1);
  const auto edge = edge_of(f);
  EXPECT_EQ(edge->degree, 0);
  EXPECT_TRUE(rank_at_most(1, {at_parameter(edge->row, Q(0)), row(2, 3, 4, 5)}));
  EXPECT_FALSE(constant_patch(f, *edge).has_value());
}

TEST(PieceEdge, OfACylinderIsItsDirection) {
  Rows d = cubic_row();
  int length = -2;
  for (Row& x : d) add_scaled(x, Q(++length), row(0, 3, 4, 5));
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), d, 1);
  const auto edge = edge_of(f);
  EXPECT_EQ(edge->degree, 0);
  EXPECT_TRUE(rank_at_most(1, {at_parameter(edge->row, Q(0)), row(0, 3, 4, 5)}));
  EXPECT_FALSE(constant_patch(f, *edge).has_value());
}

TEST(PieceEdge, OfTangentsIsTheirCurve) {
  // c = (t, t^2, t^3), d = c + c', so that c is the edge: v = 0.
  const Rows c{Row(Q(1), Q(0), Q(0), Q(0)), Row(Q(1), q(1, 3), Q(0), Q(0)), Row(Q(1), q(2, 3), q(1, 3), Q(0)),
               row(1, 1, 1, 1)};
  const Rows d{row(1, 1, 0, 0), Row(Q(1), q(4, 3), q(2, 3), Q(0)), Row(Q(1), q(5, 3), q(5, 3), Q(1)), row(1, 2, 3, 4)};
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), c, d, 1);
  const auto edge = edge_of(f);
  EXPECT_EQ(edge->degree, 3);
  EXPECT_TRUE(*edge->v == Ratio(0));
  const auto patch = constant_patch(f, *edge);
  ASSERT_TRUE(patch.has_value());
  EXPECT_EQ(patch->p.size(), 3U);
  expect_patch(f, *patch);
}

/// The piece between a curve of degree 3 over an interval, its own edge, and the points c + c' on its tangents.
PieceFunctions<Q> tangents_of(const Rows& c, const Q& begin = Q(0), const Q& end = Q(1)) {
  Rows d = c;
  for (std::size_t i = 0; i < 4; ++i) {
    const int left = static_cast<int>(i);  // of c' as a row of degree 3, the mean of its neighbours by these weights
    if (i > 0) add_scaled(d[i], Q(left), difference(c[i], c[i - 1]));
    if (i < 3) add_scaled(d[i], Q(3 - left), difference(c[i + 1], c[i]));
  }
  return recover_piece<Q>(bezier_knots<Q>(3, begin, end), c, d, 1);
}

/// With x = -k a weight of the patch is (1 + k) w_i - k w_{i+1}: for weights 1, 2, 3, 4 one of them is zero for
/// k = 1, 2 and 3 each.
TEST(PieceEdge, PatchesBeginWhereNoWeightVanishes) {
  const Rows c{row(1, 0, 0, 0), row(2, 1, 0, 0), row(3, 0, 1, 0), row(4, 0, 0, 1)};
  for (const auto& [begin, end] : {std::pair{0, 1}, {1, 3}}) {
    const auto f = tangents_of(c, Q(begin), Q(end));
    const auto edge = edge_of(f);
    ASSERT_EQ(edge->degree, 3);
    const auto patch = constant_patch(f, *edge);
    ASSERT_TRUE(patch.has_value());
    EXPECT_EQ(patch->m, Q(begin - 4 * (end - begin)));
    EXPECT_EQ(patch->lambda, Q(begin - 5 * (end - begin)));
    expect_patch(f, *patch);
  }
}

/// Two neighbouring points of the edge's polygon at infinity: so is one of every patch.
TEST(PieceEdge, NoPatchWhereAWeightAlwaysVanishes) {
  const auto f = tangents_of({row(1, 0, 0, 0), row(0, 1, 0, 0), row(0, 0, 1, 0), row(1, 0, 0, 1)});
  const auto edge = edge_of(f);
  ASSERT_EQ(edge->degree, 3);
  EXPECT_FALSE(constant_patch(f, *edge).has_value());
}

/// Edges as they are given: of degree 2 there is a patch of degree 1, also with one point of the polygon at infinity;
/// of degree 1 there is none.
TEST(PieceEdge, PatchesOfGivenEdges) {
  const auto f = tangents_of({row(1, 0, 0, 0), row(1, 1, 0, 0), row(1, 0, 1, 0), row(1, 0, 0, 1)});
  const Polynomial<Q> t(std::vector<Q>{Q(0), Q(1)});
  const auto patch_of = [&](const Polynomial<Q>& weight, const Polynomial<Q>& y, int degree) {
    return constant_patch(f, EdgeOfRegression<Q>{{weight, t, y, Polynomial<Q>()}, degree, std::nullopt});
  };
  for (const Polynomial<Q>& weight : {Polynomial<Q>(1), Polynomial<Q>(std::vector<Q>{Q(1), Q(-2), Q(2)})}) {
    const auto patch = patch_of(weight, t * t, 2);
    ASSERT_TRUE(patch.has_value());
    EXPECT_EQ(patch->p.size(), 2U);
    EXPECT_EQ(patch->m, Q(-1));
    EXPECT_EQ(patch->lambda, Q(-2));
  }
  EXPECT_FALSE(patch_of(Polynomial<Q>(1), Polynomial<Q>(), 1).has_value());
}

TEST(PieceEdge, ThereIsNoneWithoutASurface) {
  EXPECT_FALSE(edge_of(recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), cubic_row(), 1)).has_value());
}

}  // namespace
}  // namespace torse
