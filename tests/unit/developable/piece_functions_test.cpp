// Lam, M, sigma recovered from nets alone: the functions that made the net are the expected ones, carried along by the
// formulas of FJ21 section 5 where the net is changed; and p[t^<n-1>, Lam] = sigma q[t^<n-1>, M] checked at parameters.
#include "torse/developable/piece_functions.hpp"

#include <gtest/gtest.h>

#include <random>

#include "rational_rows.hpp"
#include "torse/developable/factors.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/exact/modular/zp.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"
#include "torse/spline/elevation.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {
namespace {

using namespace test;
using Poly = Polynomial<Q>;
using Ratio = PolynomialFraction<Q>;
using Rows = std::vector<Row>;

Poly poly(const std::vector<int>& coefficients) {
  std::vector<Q> a;
  for (int x : coefficients) a.push_back(Q(x));
  return Poly(std::move(a));
}

Ratio constant(const Q& x) { return Ratio(Poly::constant(x)); }

void expect_functions(const PieceFunctions<Q>& f, const Ratio& lambda, const Ratio& m, const Ratio& sigma) {
  const auto b = f.blossom();
  ASSERT_TRUE(b.has_value());
  EXPECT_TRUE(b->lambda == lambda) << as_text(b->lambda);
  EXPECT_TRUE(b->m == m) << as_text(b->m);
  EXPECT_TRUE(b->sigma == sigma) << as_text(b->sigma);
}

/// Whether p + (Lam-t)/n p' = sigma (q + (M-t)/n q') and p' = lambda W + mu W' + nu p at t, on the library's curve.
void expect_relations(const KnotList<Q>& u, const Rows& p, const Rows& d, const PieceFunctions<Q>& f, const Q& t) {
  const auto b = f.blossom();
  const auto frame = f.frame();
  ASSERT_TRUE(b && frame);
  const Row x = curve_point<Q, Row>(u, p, f.piece, t), dx = curve_derivative<Q, Row>(u, p, f.piece, t);
  const Row y = curve_point<Q, Row>(u, d, f.piece, t), dy = curve_derivative<Q, Row>(u, d, f.piece, t);
  const Q n(u.degree());
  const Q lambda = b->lambda(t), m = b->m(t), sigma = b->sigma(t);
  for (int j = 0; j < 4; ++j) {
    EXPECT_EQ(x[j] + (lambda - t) / n * dx[j], sigma * (y[j] + (m - t) / n * dy[j])) << t.text();
    EXPECT_EQ(dx[j], frame->lambda(t) * (y[j] - x[j]) + frame->mu(t) * (dy[j] - dx[j]) + frame->nu(t) * x[j]);
  }
}

Rows spline_row() {
  return {row(1, 0, 0, 1), row(2, 3, 1, 0), row(1, 4, -1, 2), row(3, 1, 5, 1), row(1, 1, 1, 7), row(2, 0, 3, 4)};
}

TEST(PieceFunctions, Section8FromTheNetsAlone) {
  const proofs::Section8Net<Q> net({});
  expect_functions(recover_piece<Q>(net.u, net.p, net.q, 1), constant(q(-4, 3)), constant(Q(-2)), constant(Q(1)));

  expect_functions(recover_piece<Q>(net.u, moebius_rows(net.p, Q(2)), moebius_rows(net.q, Q(2)), 1), constant(Q(8)),
                   constant(Q(4)), constant(Q(3)));

  const KnotList<Q> quartic = bezier_knots<Q>(4);
  const Linear<Q> unit{Q(1), Q(0)};
  const Rows p = times_linear(net.p, unit);
  expect_functions(recover_piece<Q>(quartic, p, times_linear(net.q, unit), 1), Ratio(poly({-16, -3}), poly({9})),
                   Ratio(poly({-8, -1}), poly({3})), constant(Q(1)));

  Rows rulings = net.q;
  for (std::size_t i = 0; i < rulings.size(); ++i) subtract(rulings[i], net.p[i]);
  Rows trimmed = times_linear(rulings, Linear<Q>{Q(1), q(-3, 4)});
  for (std::size_t i = 0; i < trimmed.size(); ++i) add(trimmed[i], p[i]);
  expect_functions(recover_piece<Q>(quartic, p, trimmed, 1), Ratio(poly({-32, -3, 9}), poly({9, -18})),
                   Ratio(poly({-16, 7}), poly({3, -6})), constant(Q(1)));
}

TEST(PieceFunctions, KnotInsertionAndElevationOfSplines) {
  const KnotList<Q> u = knots(3, {0, 0, 1, 2, 2, 5, 7, 7});
  const Q lambda(11), m = q(-1, 2), sigma = q(2, 3);
  const Rows p = spline_row();
  const Rows d = rational_net<Q, Row>(u, p, lambda, m, sigma, row(1, 2, 2, 2));
  const auto pieces = recover_pieces<Q>(u, p, d);
  ASSERT_EQ(pieces.size(), 2U);  // [1, 2] and [2, 5]; the piece between them is empty
  for (const auto& f : pieces) {
    expect_functions(f, constant(lambda), constant(m), constant(sigma));
    EXPECT_TRUE(f.constant());
    expect_relations(u, p, d, f, q(9, 7));
  }

  const Spline<Q, Row> c(u, p), e(u, d);
  const auto refined_c = insert_knot(c, q(3, 2), 2), refined_e = insert_knot(e, q(3, 2), 2);
  const auto refined = recover_pieces<Q>(refined_c.knots, refined_c.control, refined_e.control);
  ASSERT_EQ(refined.size(), 3U);
  for (const auto& f : refined) expect_functions(f, constant(lambda), constant(m), constant(sigma));

  // FJ21.5.3 with f = g = 1: ((n+1) X - t) / n in the parameter of the spline.
  const auto raised_c = elevate(c), raised_e = elevate(e);
  for (const auto& f : recover_pieces<Q>(raised_c.knots, raised_c.control, raised_e.control)) {
    expect_functions(f, Ratio(poly({44, -1}), poly({3})), Ratio(poly({-2, -1}), poly({3})), constant(sigma));
    EXPECT_FALSE(f.constant());
    expect_relations(raised_c.knots, raised_c.control, raised_e.control, f, q(9, 7));
  }
}

/// A cone with p[t, 2] = (1 + t) X and q[t, 3] = (2 - t) X for its vertex X: Lam and M are constants and sigma is not.
TEST(PieceFunctions, ConstantsWithASigmaThatIsNone) {
  const Row x = row(1, 1, 2, 3);
  const Row speed = row(1, 0, 1, 0);
  const Row other = row(2, 1, 0, 1);
  // A row a + b t + c t^2 has p[t, l] = a + l b / 2 + (b / 2 + l c) t.
  const auto net = [&](const Row& b, int l, int at_zero, int slope) {
    const Row a = Row(x * Q(at_zero) - b * q(l, 2));
    const Row c = Row((x * Q(slope) - b * q(1, 2)) * q(1, l));
    return Rows{a, Row(a + b * q(1, 2)), Row(a + b + c)};
  };
  const Rows p = net(speed, 2, 1, 1);
  const Rows d = net(other, 3, 2, -1);
  const auto f = recover_piece<Q>(bezier_knots<Q>(2), p, d, 1);
  ASSERT_TRUE(f.blossom().has_value());
  EXPECT_EQ(*f.lambda()->constant_value(), Q(2));
  EXPECT_EQ(*f.m()->constant_value(), Q(3));
  EXPECT_FALSE(f.sigma()->constant_value().has_value());
  EXPECT_FALSE(f.constant());
}

TEST(PieceFunctions, LinearNetsOfAllDegrees) {
  for (const KnotList<Q>& u : knot_lists()) {
    if (u.degree() == 1) continue;
    const std::vector<Point3> c = points(u.last() + 1, 3);
    const std::vector<Point3> d = linear_net<Q, Point3>(u, c, Q(17), Q(-1), point(5, 6, 7));
    const std::vector<Q> ones(c.size(), Q(1));
    for (const auto& f : recover_pieces<Q>(u, homogeneous<Q, 3>({c, ones}), homogeneous<Q, 3>({d, ones}))) {
      expect_functions(f, constant(Q(17)), constant(Q(-1)), constant(Q(1)));
    }
  }
}

TEST(PieceFunctions, AnotherIntervalShiftsLambdaAndM) {
  const Rows p = cubic_row();
  const Rows d = rational_net<Q, Row>(bezier_knots<Q>(3), p, Q(4), Q(-3), Q(2), row(1, 1, 2, 2));
  const KnotList<Q> wide = bezier_knots<Q>(3, Q(-2), Q(5));
  expect_functions(recover_piece<Q>(wide, p, d, 1), constant(Q(-2 + 7 * 4)), constant(Q(-2 - 7 * 3)), constant(Q(2)));
}

TEST(PieceFunctions, MoebiusTrimAndFactorsAtParameters) {
  const Rows p = cubic_row();
  const KnotList<Q> cubic = bezier_knots<Q>(3), quartic = bezier_knots<Q>(4);
  const BlossomFunctions<Q> known{q(7, 3), q(-5, 2), q(3, 4)};
  const Rows d = rational_net<Q, Row>(cubic, p, known.lambda, known.m, known.sigma, row(1, 1, 2, 2));

  const auto moebius = recover_piece<Q>(cubic, moebius_rows(p, Q(3)), moebius_rows(d, Q(3)), 1);
  const auto expected = moebius_functions(known, Q(3));
  expect_functions(moebius, constant(expected.lambda), constant(expected.m), constant(expected.sigma));

  const Linear<Q> f{Q(2), q(1, 3)}, g{q(3, 2), q(-1, 5)};
  const auto elevated = recover_piece<Q>(quartic, times_linear(p, f), times_linear(d, g), 1);
  Rows w = d;
  for (std::size_t i = 0; i < w.size(); ++i) subtract(w[i], p[i]);
  Rows trimmed = times_linear(w, g);
  const Rows longer = times_linear(p, f);
  for (std::size_t i = 0; i < trimmed.size(); ++i) add(trimmed[i], longer[i]);
  const auto shortened = recover_piece<Q>(quartic, longer, trimmed, 1);
  for (int i = 0; i < 12; ++i) {
    const Q t = q(2 * i + 1, 13);
    const auto by_factors = elevated_functions(3, t, known, f, g), by_trim = shortened_functions(3, t, known, f, g);
    EXPECT_EQ(elevated.lambda()->operator()(t), by_factors.lambda);
    EXPECT_EQ(elevated.m()->operator()(t), by_factors.m);
    EXPECT_EQ(elevated.sigma()->operator()(t), by_factors.sigma);
    EXPECT_EQ(shortened.lambda()->operator()(t), by_trim.lambda);
    EXPECT_EQ(shortened.m()->operator()(t), by_trim.m);
    EXPECT_EQ(shortened.sigma()->operator()(t), by_trim.sigma);
    expect_relations(quartic, longer, trimmed, shortened, t);
  }
}

TEST(PieceFunctions, CorollaryFourOneHoldsAsFunctions) {
  const Rows p = cubic_row();
  const Rows d = rational_net<Q, Row>(bezier_knots<Q>(3), p, Q(4), Q(-3), Q(2), row(1, 1, 2, 2));
  const Linear<Q> f{Q(2), q(1, 3)}, g{q(3, 2), q(-1, 5)};
  const auto piece = recover_piece<Q>(bezier_knots<Q>(4), times_linear(p, f), times_linear(d, g), 1);
  const auto frame = to_frame(4, Ratio::variable(), *piece.blossom());
  EXPECT_TRUE(frame.lambda == piece.frame()->lambda);
  EXPECT_TRUE(frame.mu == piece.frame()->mu);
  EXPECT_TRUE(frame.nu == piece.frame()->nu);
}

TEST(PieceFunctions, ATranslationCylinderHasLambdaAndMAtInfinity) {
  Rows d = cubic_row();
  for (Row& x : d) add_scaled(x, x[0], row(0, 1, 2, 2));
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), d, 1);
  EXPECT_EQ(f.sweep, Sweep::surface);
  // With q = p + w a and a weight w that is not constant, w' p - w p' = w' q - w q': Lam = M, both finite.
  expect_functions(f, *f.lambda(), *f.lambda(), constant(Q(1)));

  std::vector<Row> polynomial{row(1, 0, 0, 1), row(1, 3, 1, 0), row(1, 4, -1, 2), row(1, 1, 5, 1)};
  Rows moved = polynomial;
  for (Row& x : moved) add(x, row(0, 1, 2, 2));
  const auto g = recover_piece<Q>(bezier_knots<Q>(3), polynomial, moved, 1);
  EXPECT_TRUE(g.lambda_infinite());
  EXPECT_TRUE(g.m_infinite());
  EXPECT_FALSE(g.lambda() || g.m() || g.sigma() || g.blossom() || g.frame());
}

TEST(PieceFunctions, OnlyLambdaOrOnlyMAtInfinity) {
  // p is an integral of q[t^<n-1>, M]: p' = n (p_{i+1} - p_i) is the blossom at the infinite Lam.
  const KnotList<Q> u = bezier_knots<Q>(3);
  const Rows second = cubic_row();
  const Q m(-2);
  Rows first{row(1, 1, 1, 1)};
  for (std::size_t i = 0; i < 3; ++i) {
    first.push_back(sum(first.back(), scaled<Row>(q(1, 3), combine(Q(1) - m, second[i], m, second[i + 1]))));
  }
  const auto f = recover_piece<Q>(u, first, second, 1);
  EXPECT_TRUE(f.lambda_infinite());
  EXPECT_FALSE(f.m_infinite());
  EXPECT_FALSE(f.lambda() || f.sigma());
  EXPECT_TRUE(*f.m() == constant(m));
  ASSERT_TRUE(f.frame().has_value());

  const auto exchanged = recover_piece<Q>(u, second, first, 1);
  EXPECT_TRUE(exchanged.m_infinite());
  EXPECT_FALSE(exchanged.lambda_infinite());
  EXPECT_TRUE(*exchanged.lambda() == constant(m));
  EXPECT_TRUE(*exchanged.sigma() == constant(Q(0)));
}

TEST(PieceFunctions, ARowThatIsOnePoint) {
  Rows vertex;
  for (int w : {1, 2, 5, 3}) vertex.push_back(row(w, 2 * w, 3 * w, 4 * w));
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), vertex, cubic_row(), 1);
  EXPECT_TRUE(f.c_is_a_point());
  EXPECT_FALSE(f.d_is_a_point());
  EXPECT_FALSE(f.m().has_value());
  EXPECT_TRUE(*f.sigma() == constant(Q(0)));
  const auto g = recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), vertex, 1);
  EXPECT_TRUE(g.d_is_a_point());
  EXPECT_FALSE(g.lambda() || g.sigma());
}

TEST(PieceFunctions, ARowOnTheTangentsOfTheOther) {
  // 3 q[t, t, 0] = 3 q - t q' needs one derivative only: with M = 0 and Lam = t for p there.
  const Rows edge = cubic_row();
  Rows on_tangents{edge[0]};
  for (int i = 1; i <= 3; ++i) {
    const Q share = q(i, 3);
    on_tangents.push_back(
        combine(share, edge[static_cast<std::size_t>(i - 1)], Q(1) - share, edge[static_cast<std::size_t>(i)]));
  }
  const auto f = recover_piece<Q>(bezier_knots<Q>(3), on_tangents, edge, 1);
  const auto g = recover_piece<Q>(bezier_knots<Q>(3), edge, on_tangents, 1);
  for (const auto& piece : {f, g}) {
    EXPECT_EQ(piece.sweep, Sweep::surface);
    EXPECT_FALSE(piece.c_is_a_point());
    EXPECT_FALSE(piece.d_is_a_point());
  }
  EXPECT_TRUE(f.beta.zero());
  EXPECT_TRUE(g.delta.zero());
  EXPECT_TRUE(*f.lambda() == Ratio::variable());
  EXPECT_TRUE(*f.m() == constant(Q(0)));
}

TEST(PieceFunctions, WithoutASurfaceNothingIsUnique) {
  const auto same = recover_piece<Q>(bezier_knots<Q>(3), cubic_row(), cubic_row(), 1);
  EXPECT_EQ(same.sweep, Sweep::curve);
  EXPECT_FALSE(same.lambda() || same.m() || same.sigma() || same.frame());
  const Rows c{row(1, 0, 0, 0), row(1, 1, 0, 0), row(1, 5, 0, 0)}, d{row(1, 2, 0, 0), row(2, 3, 0, 0), row(1, 9, 0, 0)};
  const auto line = recover_piece<Q>(bezier_knots<Q>(2), c, d, 1);
  EXPECT_EQ(line.sweep, Sweep::line);
  EXPECT_FALSE(line.lambda() || line.m() || line.sigma() || line.frame());
}

/// A field whose numbers have no denominators to clear.
TEST(PieceFunctions, ModuloAPrimeTheyAreConstantToo) {
  const Modulus modulus((std::uint64_t{1} << 63) - 25);
  std::vector<Vec<Zp, 4>> p;
  std::mt19937_64 rng(1);
  for (int i = 0; i <= 3; ++i) {
    Vec<Zp, 4> x;
    for (int j = 0; j < 4; ++j) x[j] = Zp::draw(modulus, rng);
    p.push_back(x);
  }
  const KnotList<Zp> u = bezier_knots<Zp>(3);
  const Zp lambda = Zp::draw(modulus, rng), m = Zp::draw(modulus, rng), sigma = Zp::draw(modulus, rng);
  const Vec<Zp, 4> start(Zp::draw(modulus, rng), Zp(2), Zp(5), Zp(7));
  const auto f = recover_piece<Zp>(u, p, rational_net<Zp, Vec<Zp, 4>>(u, p, lambda, m, sigma, start), 1);
  EXPECT_TRUE(*f.lambda() == PolynomialFraction<Zp>(Polynomial<Zp>::constant(lambda)));
  EXPECT_TRUE(*f.m() == PolynomialFraction<Zp>(Polynomial<Zp>::constant(m)));
  EXPECT_TRUE(*f.sigma() == PolynomialFraction<Zp>(Polynomial<Zp>::constant(sigma)));
}

TEST(PieceFunctions, APieceThatIsNotDevelopableIsRefused) {
  const Rows c{row(1, 0, 0, 0), row(1, 1, 0, 0)}, d{row(1, 0, 1, 0), row(1, 1, 1, 1)};
  EXPECT_EQ(place_of([&] { return recover_piece<Q>(bezier_knots<Q>(1), c, d, 1); }), "piece[1]");
}

}  // namespace
}  // namespace torse
