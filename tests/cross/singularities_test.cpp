// Singular parameters against patches whose edge of regression is known in closed form, against FJ07's Corollary 3, and
// against the affine derivatives of the standard parametrisation.
#include "torse/exact/decide/singularities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/piece_edge.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"
#include "unit/developable/rational_rows.hpp"

namespace torse {
namespace {

using namespace test;
using Rows = std::vector<Row>;
using Sets = std::vector<SingularSet>;

Sets singular(const KnotList<Q>& u, const Rows& p, const Rows& d) {
  return find_singularities(recover_pieces<Q>(u, p, d));
}

Sets singular(const Rows& p, const Rows& d) { return singular(bezier_knots<Q>(static_cast<int>(p.size()) - 1), p, d); }

std::string text(const SingularSet::Bound& bound) {
  return bound.root.rational() ? bound.root.lower.text() : "root of " + as_text(bound.zero_of);
}

/// "edge 1/4..2/3; vanishing 1"
std::string text(const Sets& sets) {
  std::string all;
  for (const SingularSet& set : sets) {
    all += (all.empty() ? "" : "; ") + std::string(name_of(set.reason)) + ' ' + text(set.from);
    if (!set.point()) all += ".." + text(set.to);
  }
  return all;
}

/// p + g (q - p)
Rows trimmed(const Rows& p, const Rows& d, const Linear<Q>& g) {
  Rows w = d;
  for (std::size_t i = 0; i < w.size(); ++i) subtract(w[i], p[i]);
  Rows result = times_linear(w, g);
  const Rows raised = times_linear(p, Linear<Q>{Q(1), Q(0)});
  for (std::size_t i = 0; i < result.size(); ++i) add(result[i], raised[i]);
  return result;
}

/// The patch of Theorem 6.1 on the twisted cubic: v = (t-M)/(Lam-M).
std::pair<Rows, Rows> patch(const Q& lambda, const Q& m) {
  const Rows cubic{Row(Q(1), Q(0), Q(0), Q(0)), Row(Q(1), q(1, 3), Q(0), Q(0)), Row(Q(1), q(2, 3), q(1, 3), Q(0)),
                   row(1, 1, 1, 1)};
  return {edge_patch<Q>(cubic, m), edge_patch<Q>(cubic, lambda)};
}

/// The rows with t replaced by a polynomial of degree two.
Rows substituted(const Rows& rows, const Polynomial<Q>& t) {
  const int n = static_cast<int>(rows.size()) - 1;
  PolynomialRow<Q, 4> x = piece_polynomials<Q, 4>(bezier_knots<Q>(n), rows, 1);
  for (Polynomial<Q>& f : x) f = f.compose(t);
  return bezier_rows(x, 2 * n, Q(0), Q(1));
}

TEST(Singularities, Section8IsRegular) {
  const proofs::Section8Net<Q> net({});
  EXPECT_EQ(text(singular(net.p, net.q)), "");
}

TEST(Singularities, TheEdgeCrossesBetweenMAndLambda) {
  const auto [p, d] = patch(q(2, 3), q(1, 4));
  EXPECT_EQ(text(singular(p, d)), "edge 1/4..2/3");
  EXPECT_EQ(text(singular(d, p)), "edge 1/4..2/3");
  const auto [left, right] = patch(q(1, 3), Q(-1));
  EXPECT_EQ(text(singular(left, right)), "edge 0..1/3");
  const auto [from, to] = patch(Q(1), Q(5));
  EXPECT_EQ(text(singular(from, to)), "edge 1");
  const auto [near, far] = patch(Q(-1), Q(-2));
  EXPECT_EQ(text(singular(near, far)), "");
}

TEST(Singularities, SignsAndFactorsOfWeightsDoNotMatter) {
  const auto [p, d] = patch(q(2, 3), q(1, 4));
  Rows negative = d;
  for (Row& x : negative) scale(x, Q(-3));
  EXPECT_EQ(text(singular(p, negative)), "edge 1/4..2/3");
  const Rows raised = times_linear(p, Linear<Q>{Q(2), q(-1, 3)}), other = times_linear(negative, Linear<Q>{Q(1), Q(1)});
  EXPECT_EQ(text(singular(raised, other)), "edge 1/4..2/3");
}

TEST(Singularities, IrrationalEnds) {
  // v = 2 (t - 1/5), rulings times (1-t)(1+t): v = 1 where t^2 + 2t - 7/5 = 0.
  const auto [p, d] = patch(q(7, 10), q(1, 5));
  const Rows once = trimmed(p, d, Linear<Q>{Q(1), Q(-1)});
  const Rows twice = trimmed(times_linear(p, Linear<Q>{Q(1), Q(0)}), once, Linear<Q>{Q(1), Q(1)});
  const Sets sets = singular(times_linear(times_linear(p, Linear<Q>{Q(1), Q(0)}), Linear<Q>{Q(1), Q(0)}), twice);
  EXPECT_EQ(text(sets), "edge 1/5..root of t^2 + 2 t - 7/5; vanishing 1");
  const RealRoot& end = sets[0].to.root;
  const auto value = [](const Q& t) { return t * t + Q(2) * t - q(7, 5); };
  EXPECT_LT(value(end.lower), Q(0));
  EXPECT_GT(value(end.upper), Q(0));
}

TEST(Singularities, APatchAlongItsEdge) {
  const auto [p, d] = patch(q(2, 3), q(1, 4));
  const auto piece = recover_piece<Q>(bezier_knots<Q>(2), p, d, 1);
  const Rows edge = bezier_rows(edge_of(piece)->row, 3, Q(0), Q(1));
  // q(2/3) lies on the edge, too.
  EXPECT_EQ(text(singular(edge, times_linear(d, Linear<Q>{Q(1), Q(0)}))), "edge 0..1; vanishing 2/3");
}

TEST(Singularities, StationaryRulings) {
  const auto [p, d] = patch(Q(-1), Q(-2));
  const Polynomial<Q> square(std::vector<Q>{Q(0), Q(0), Q(1)});
  EXPECT_EQ(text(singular(substituted(p, square), substituted(d, square))), "stationary 0");
  const Polynomial<Q> fold(std::vector<Q>{Q(1), Q(-4), Q(4)});  // (2t-1)^2
  EXPECT_EQ(text(singular(substituted(p, fold), substituted(d, fold))), "stationary 1/2");
}

TEST(Singularities, ConesByTheirVertex) {
  const Row vertex = row(1, 5, 5, 5);
  const auto cone = [&](const Q& factor) {  // q = vertex + factor (c - vertex)
    Rows d;
    for (const Row& x : cubic_row()) d.push_back(combine<Row>(factor, x, (Q(1) - factor) * x[0], vertex));
    return text(singular(cubic_row(), d));
  };
  EXPECT_EQ(cone(q(1, 2)), "");
  EXPECT_EQ(cone(Q(3)), "");
  EXPECT_EQ(cone(Q(-1)), "edge 0..1");
  EXPECT_EQ(cone(Q(0)), "edge 0..1");
  Rows same = cubic_row();
  EXPECT_EQ(text(singular(same, same)), "no surface 0..1");
}

TEST(Singularities, CylindersOnlyWhereARulingVanishes) {
  const auto cylinder = [](const std::vector<int>& lengths) {
    Rows d{row(1, 0, 0, 1), row(1, 3, 1, 0), row(1, 4, -1, 2), row(1, 1, 5, 1)};
    const Rows c = d;
    for (std::size_t i = 0; i < 4; ++i) add_scaled(d[i], Q(lengths[i]), row(0, 1, 2, 2));
    return text(singular(c, d));
  };
  EXPECT_EQ(cylinder({1, 1, 1, 1}), "");
  EXPECT_EQ(cylinder({1, 2, 3, 1}), "");
  EXPECT_EQ(cylinder({-1, 0, 1, 2}), "vanishing 1/3");
  EXPECT_EQ(cylinder({0, 0, 1, 0}), "vanishing 0; vanishing 1");
}

TEST(Singularities, PolesOfTheWeights) {
  const Rows p{row(1, 0, 0, 0), row(-1, 2, 1, 0), row(1, 1, 3, 5)};  // w = (1-2t)^2
  Rows d = p;
  for (Row& x : d) add(x, row(0, 1, 2, 3));
  EXPECT_EQ(text(singular(p, d)), "pole 1/2");
}

TEST(Singularities, ARowAtInfinityIsAPoleEverywhere) {
  const Rows p{row(0, 1, 0, 0), row(0, 0, 1, 0), row(0, 1, 1, 0)};
  const Rows d(3, row(1, 2, 3, 4));
  EXPECT_EQ(text(singular(p, d)), "pole 0..1");
  EXPECT_EQ(text(singular(d, p)), "pole 0..1");
}

TEST(Singularities, CorollaryThreeAndItsConverseOnSplines) {
  for (const KnotList<Q>& u : knot_lists()) {
    if (u.degree() == 1) continue;
    const std::vector<Point3> c = points(u.last() + 1, 3);
    const auto edges = [&](const Q& lambda, const Q& m) {
      const std::vector<Point3> d = linear_net<Q, Point3>(u, c, lambda, m, point(5, 6, 7));
      const std::vector<Q> ones(c.size(), Q(1));
      Sets sets = singular(u, homogeneous<Q, 3>({c, ones}), homogeneous<Q, 3>({d, ones}));
      std::erase_if(sets, [](const SingularSet& s) { return s.reason != Singularity::edge; });
      return text(sets);
    };
    const Q a = u.domain_begin(), b = u.domain_end();
    EXPECT_EQ(edges(b + Q(5), b + q(17, 2)), "");
    EXPECT_EQ(edges(a - Q(17), a - q(37, 2)), "");
    // v = (t - M)/(Lam - M): singular exactly between M and Lam.
    const Q inside = (Q(3) * a + Q(2) * b) / Q(5) + q(1, 97);
    EXPECT_EQ(edges(inside, b + Q(17)), "edge " + inside.text() + ".." + b.text());
    EXPECT_EQ(edges(inside, a - Q(17)), "edge " + a.text() + ".." + inside.text());
    EXPECT_EQ(edges(a - Q(17), b + Q(17)), "edge " + a.text() + ".." + b.text());
  }
}

/// Whether some V in [0, 1] has (1-V) c' x (d-c) + V d' x (d-c) = 0 at t, by the quotient rule.
bool singular_by_derivatives(const Rows& p, const Rows& d, const Q& t) {
  const auto affine = [&](const Rows& rows, Point3& x, Point3& dx) {
    const Row h = value(rows, t), dh = derivative(rows, t);
    for (int j = 0; j < 3; ++j) {
      x[j] = h[j + 1] / h[0];
      dx[j] = (dh[j + 1] - dh[0] * x[j]) / h[0];
    }
  };
  Point3 c, dc, e, de;
  affine(p, c, dc);
  affine(d, e, de);
  const Point3 w = difference(e, c), left = cross(dc, w), right = cross(de, w);
  // Both are multiples of the normal: (1-V) left + V right vanishes for V in [0, 1] iff they do not point the same way.
  return dot(left, right).sign() <= 0;
}

TEST(Singularities, AgreeWithTheDerivativesAtParameters) {
  std::mt19937_64 rng(11);
  int inside = 0, total = 0;
  for (int round = 0; round < 40; ++round) {
    const auto draw = [&] { return static_cast<int>(rng() % 13) - 6; };
    Rows p;
    for (int i = 0; i < 4; ++i) p.push_back(row(rng() % 3 == 0 ? -2 : 3, draw(), draw(), draw()));
    const Q lambda = q(draw(), 5), m = q(2 * draw() + 1, 12);
    const Rows d = trimmed(p, rational_net<Q, Row>(bezier_knots<Q>(3), p, lambda, m, q(3, 2), row(2, 1, draw(), 3)),
                           Linear<Q>{q(draw(), 3), q(5, 2)});
    const Rows c = times_linear(p, Linear<Q>{Q(1), Q(0)});
    const auto piece = recover_piece<Q>(bezier_knots<Q>(4), c, d, 1);
    if (piece.sweep != Sweep::surface || edge_of(piece)->degree < 2) continue;
    const Sets sets = find_singularities({piece});
    for (int i = 1; i < 60; ++i) {
      const Q t = q(i, 61) + q(1, 10007);
      const bool found = std::ranges::any_of(
          sets, [&](const SingularSet& s) { return !s.point() && s.from.root.upper <= t && t <= s.to.root.lower; });
      EXPECT_EQ(found, singular_by_derivatives(c, d, t)) << round << ", t = " << t.text() << ": " << text(sets);
      inside += found ? 1 : 0;
      ++total;
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(total - inside, 200);
}

}  // namespace
}  // namespace torse
