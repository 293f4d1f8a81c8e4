// The parts of the search for the nearest net, each against another way to its answer.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "torse/developable/linear_net.hpp"
#include "torse/exact/repair/banded.hpp"
#include "torse/exact/repair/descent.hpp"
#include "torse/exact/repair/edge_solver.hpp"
#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/frame.hpp"
#include "torse/exact/repair/symmetric.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

using Q = Rational;

Real random_real(std::mt19937_64& rng) { return Real(static_cast<int>(rng() % 2001) - 1000) / Real(997); }

template <int D>
RealNet<D> random_net(int count, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  RealNet<D> net;
  for (int i = 0; i < 2 * count; ++i) {
    Vec<Real, D> x;
    for (int j = 0; j < D; ++j) x[j] = random_real(rng) + Real(i * j) / Real(3);
    net.points.push_back(x);
    net.scale.push_back(D == 3 ? Real(1) : Real(1) / Real(2 + i % 3));
  }
  return net;
}

double number(const Real& x) { return x.to_double(); }

TEST(RepairParts, RoundsToMultiplesAndSimpleFractions) {
  EXPECT_EQ(rounded(Real(7) / Real(3), -1), Q(5) / Q(2));
  EXPECT_EQ(rounded(Real(-7) / Real(3), -1), Q(-5) / Q(2));
  EXPECT_EQ(rounded(Real(1000), 4), Q(1008));
  EXPECT_EQ(simplest_near(Real(1) / Real(3), Real(1) / Real(100)), Q(1) / Q(3));
  EXPECT_EQ(simplest_near(Real(1) / Real(3), Real(1)), Q(0));
  EXPECT_EQ(exponent_of(Real(8)), 4);
  EXPECT_EQ(exponent_of(Real(7) / Real(-8)), 0);
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Real x = random_real(rng);
    const Real tolerance = Real(1) / Real(static_cast<int>(rng() % 900 + 20));
    const Q simple = simplest_near(x, tolerance);
    EXPECT_LE(magnitude(Real::from_rational(simple) - x), tolerance);
    for (int den = 1; Q(den) < Q::from_text(simple.text().find('/') == std::string::npos
                                                ? "1"
                                                : simple.text().substr(simple.text().find('/') + 1));
         ++den) {  // no smaller denominator has a numerator in the interval
      const Real nearest = Real::from_rational(rounded(x * Real(den), 0)) / Real(den);
      EXPECT_GT(magnitude(nearest - x), tolerance);
    }
  }
}

TEST(RepairParts, EigenvectorsAreOrthonormalAndSolveTheEquation) {
  std::mt19937_64 rng(2);
  for (const std::size_t size : {1U, 2U, 3U, 7U}) {
    Matrix a = zero_matrix(size);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i][j] = a[j][i] = random_real(rng);
    }
    const std::vector<EigenPair> pairs = symmetric_eigen(a);
    const Real tiny = Real::from_rational(power_of_two(-240));
    for (std::size_t k = 0; k < size; ++k) {
      EXPECT_LE(pairs[k > 0 ? k - 1 : 0].value, pairs[k].value);
      for (std::size_t i = 0; i < size; ++i) {
        Real image;
        for (std::size_t j = 0; j < size; ++j) image += a[i][j] * pairs[k].vector[j];
        EXPECT_LE(magnitude(image - pairs[k].value * pairs[k].vector[i]), tiny);
      }
      for (std::size_t l = 0; l < size; ++l) {
        Real product;
        for (std::size_t j = 0; j < size; ++j) product += pairs[k].vector[j] * pairs[l].vector[j];
        EXPECT_LE(magnitude(product - Real(k == l ? 1 : 0)), tiny);
      }
    }
  }
}

TEST(RepairParts, BandedAndDenseEquationsAgree) {
  std::mt19937_64 rng(3);
  constexpr std::size_t size = 9, width = 2;
  Matrix a = zero_matrix(size);
  std::vector<std::vector<Real>> below(size);
  std::vector<Real> diagonal, right;
  std::vector<Vec<Real, 1>> b;
  for (std::size_t r = 0; r < size; ++r) {
    for (std::size_t s = r - std::min(r, width); s < r; ++s) {
      a[r][s] = a[s][r] = random_real(rng);
      below[r].push_back(a[r][s]);
    }
    a[r][r] = Real(5);
    diagonal.push_back(a[r][r]);
    right.push_back(random_real(rng));
    b.push_back(Vec<Real, 1>(right.back()));
  }
  const auto dense = solve_positive(a, right);
  const auto banded = BandedFactors::of(below, diagonal);
  ASSERT_TRUE(dense && banded);
  banded->forward(b);
  banded->backward(b);
  for (std::size_t r = 0; r < size; ++r) {
    EXPECT_LE(magnitude(b[r][0] - (*dense)[r]), Real::from_rational(power_of_two(-240)));
    Real image;
    for (std::size_t s = 0; s < size; ++s) image += a[r][s] * (*dense)[s];
    EXPECT_LE(magnitude(image - right[r]), Real::from_rational(power_of_two(-240)));
  }
  diagonal[4] = Real(-1);
  EXPECT_FALSE(BandedFactors::of(below, diagonal));
  a[4][4] = Real(-1);
  EXPECT_FALSE(solve_positive(a, right));
}

/// The pivots of ((4, 2), (2, x)) are 4 and x - 1: any one above 0 will do, none below or at 0.
TEST(RepairParts, EquationsThatAreNotDefiniteHaveNoSolution) {
  const auto solved = [](const Real& x) {
    Matrix a = zero_matrix(2);
    a[0][0] = Real(4);
    a[0][1] = a[1][0] = Real(2);
    a[1][1] = x;
    return solve_positive(a, {Real(1), Real(1)}).has_value();
  };
  const Real little = Real::from_rational(power_of_two(-200));
  EXPECT_TRUE(solved(Real(1) + little));
  EXPECT_FALSE(solved(Real(1)));
  EXPECT_FALSE(solved(Real(1) - little));
}

/// The derivative of the squared distance by difference quotients, against the projection's slope.
template <int D, class Project>
void expect_slope(const Project& projected, const std::vector<Real>& theta) {
  const auto at_theta = projected(theta);
  ASSERT_TRUE(at_theta);
  const Real step = Real::from_rational(power_of_two(-80));
  for (std::size_t m = 0; m < theta.size(); ++m) {
    std::vector<Real> above = theta, under = theta;
    above[m] += step;
    under[m] -= step;
    const Real quotient = (projected(above)->squared - projected(under)->squared) / (Real(2) * step);
    EXPECT_NEAR(number(quotient), 2 * number(at_theta->slope[m]), 1e-12 * (1 + std::abs(number(quotient)))) << m;
    EXPECT_GT(std::abs(number(quotient)), 1e-6);
  }
}

/// The net less `change` obeys the equations, and `change` is orthogonal to every net that does: least squares.
template <int D>
void expect_projection(const BilinearSystem<Real>& system, const RealNet<D>& net, const std::vector<Real>& theta) {
  const auto projection = project<D>(system, net, theta);
  ASSERT_TRUE(projection);
  const Real tiny = Real::from_rational(power_of_two(-230));
  Real squared;
  for (std::size_t i = 0; i < net.size(); ++i) {
    squared += inner<D>(projection->change[i], projection->change[i]) / net.scale[i];
  }
  EXPECT_LE(magnitude(squared - projection->squared), tiny * squared);
  RealNet<D> near = net;
  for (std::size_t i = 0; i < net.size(); ++i) subtract(near.points[i], projection->change[i]);
  EXPECT_LE(project<D>(system, near, theta)->squared, tiny);
  RealNet<D> other = random_net<D>(static_cast<int>(net.size() / 2), 77);
  const auto change = project<D>(system, other, theta)->change;
  Real product;
  for (std::size_t i = 0; i < net.size(); ++i) {
    subtract(other.points[i], change[i]);
    product += inner<D>(projection->change[i], other.points[i]) / net.scale[i];
  }
  EXPECT_LE(magnitude(product), tiny * Real(1000));
}

const std::vector<Real> knots{Real(-1), Real(-1), Real(0), Real(1) / Real(3), Real(1), Real(2)};

TEST(RepairParts, ProjectionsAreLeastSquares) {
  const auto points = constant_relation<Real>(2, knots, false);
  const std::vector<Real> theta{Real(3), Real(1), Real(-2)};
  expect_projection<3>(points, random_net<3>(5, 4), theta);
  expect_slope<3>([net = random_net<3>(5, 4), points](const auto& x) { return project<3>(points, net, x); }, theta);
  const auto rows = constant_relation<Real>(2, knots, true);
  const std::vector<Real> four{Real(3), Real(1), Real(-2), Real(5) / Real(4)};
  expect_projection<4>(rows, random_net<4>(5, 5), four);
  expect_slope<4>([net = random_net<4>(5, 5), rows](const auto& x) { return project<4>(rows, net, x); }, four);
}

/// What a candidate says of its distance is the distance of the exact net that it makes, each row over its scale.
TEST(RepairParts, ConesOfRowsAreAsFarAsTheySay) {
  const RealNet<4> net = random_net<4>(5, 43);
  for (const Candidate<4>& candidate : {pencil_candidate(net), cylinder_candidate<4>(net)}) {
    const auto exact = candidate.realise();
    ASSERT_TRUE(exact.has_value());
    double sum = 0;
    for (std::size_t i = 0; i < net.size(); ++i) {
      for (int j = 0; j < 4; ++j) {
        const double off = number(net.points[i][j] - Real::from_rational((*exact)[i][j]));
        sum += off * off / number(net.scale[i]);
      }
    }
    EXPECT_NEAR(sum, number(candidate.squared), sum / 128);  // its numbers are simple ones nearby
  }
}

/// A row (w, w x) moves its point by 1/w of what it moves itself.
TEST(RepairParts, TheScaleOfARowIsTheSquareOfItsWeight) {
  RuledRows rows;
  for (int i = 0; i < 2; ++i) {
    rows.c.points.emplace_back(Q(i), Q(0), Q(0));
    rows.d.points.emplace_back(Q(i), Q(1), Q(i));
    rows.c.weights.push_back(Q(3 + i));
    rows.d.weights.push_back(Q(-1) / Q(2 + i));
  }
  const RealNet<4> net = real_net<4>(rows, frame_of(rows));
  ASSERT_EQ(net.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(net.scale[i] == net.points[i][0] * net.points[i][0]);
}

/// d_i = c_i + v has alpha = 1 as a cone, which would have no vertex.
TEST(RepairParts, ATranslatedRowIsNoCone) {
  RealNet<3> net = random_net<3>(5, 41);
  const Vec<Real, 3> v(Real(1), Real(-2), Real(3));
  for (std::size_t i = 0; i < net.size(); i += 2) net.points[i + 1] = sum(net.points[i], v);
  EXPECT_FALSE(cone_candidate(net).realise().has_value());
  for (std::size_t i = 0; i < net.size(); i += 2) net.points[i + 1] = sum(scaled(Real(3), net.points[i]), v);
  EXPECT_TRUE(cone_candidate(net).realise().has_value());
}

/// The equations hold for the nets of FJ07.13.
TEST(RepairParts, TheRelationIsThatOfTheLinearConstruction) {
  std::vector<Q> u;
  for (const Real& x : knots) u.push_back(rounded(x, -40));
  const KnotList<Q> list(2, u);
  std::vector<Real> near;
  for (const Q& x : u) near.push_back(Real::from_rational(x));
  std::vector<Vec<Q, 3>> c;
  for (int i = 0; i < 5; ++i) c.push_back(Vec<Q, 3>(Q(i), Q(i * i), Q(3 - i)));
  const auto d = linear_net<Q, Vec<Q, 3>>(list, c, Q(3), Q(-2), Vec<Q, 3>(Q(1), Q(5), Q(8)));
  RealNet<3> net;
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (const auto& x : {c[i], d[i]}) {
      net.points.push_back(real_point<3>(x));
      net.scale.push_back(Real(1));
    }
  }
  const auto system = constant_relation<Real>(2, near, false);
  EXPECT_LE(project<3>(system, net, {Real(3), Real(1), Real(-2)})->squared, negligible_distance());
  EXPECT_GT(project<3>(system, net, {Real(3), Real(1), Real(-3)})->squared, Real(1) / Real(100));
  // From constants that are far off, the descent comes back.
  const auto descent = descend<3>([&](const auto& theta) { return project<3>(system, net, theta); },
                                  {Real(5), Real(1), Real(-4)}, 3, Real(1000));
  ASSERT_TRUE(descent && descent->converged);
  EXPECT_LE(descent->nearest.squared, Real::from_rational(power_of_two(-60)));
  EXPECT_NEAR(number(descent->theta[0] / descent->theta[1]), 3, 1e-8);
  EXPECT_NEAR(number(descent->theta[2] / descent->theta[1]), -2, 1e-8);
}

/// The map from edge to rows against p = a r_S + b r_T at a parameter, on every piece.
TEST(RepairParts, EdgeMapsAreTheirForms) {
  std::mt19937_64 rng(6);
  for (const int j : {1, 2}) {
    const KnotList<Q> u(3, {Q(0), Q(0), Q(0), Q(1), Q(1), Q(2), Q(2), Q(2), Q(3), Q(4), Q(5)});
    const EdgeFamily family{j, u.domain_begin(), u.domain_end(), true};
    const auto map = edge_map(u, family);
    ASSERT_TRUE(map);
    const auto draw = [&] { return Q(static_cast<int>(rng() % 41) - 20); };
    std::vector<Q> theta, edge;
    for (std::size_t m = 0; m < map->constants; ++m) theta.push_back(draw());
    for (std::size_t e = 0; e < map->edge_size; ++e) edge.push_back(draw());
    std::vector<Vec<Q, 1>> p(static_cast<std::size_t>(u.last()) + 1, Vec<Q, 1>(Q(0)));
    for (const EdgeTerm& term : map->terms) {
      if (term.point % 2 == 0) p[term.point / 2][0] += term.coefficient * theta[term.constant] * edge[term.edge];
    }
    // The knots of the edge: multiplicities less j inside.
    const int rho = 4 - j;
    std::vector<Q> v(static_cast<std::size_t>(rho), Q(0));
    if (j == 1) v.insert(v.end(), {Q(1), Q(2), Q(2)});
    if (j == 2) v.insert(v.end(), {Q(2)});
    v.insert(v.end(), static_cast<std::size_t>(rho), Q(3));
    const KnotList<Q> edge_knots(rho, v);
    ASSERT_EQ(edge_knots.last() + 1, static_cast<int>(map->edge_size));
    std::vector<Vec<Q, 1>> r;
    for (const Q& x : edge) r.push_back(Vec<Q, 1>(x));
    for (const int k : u.proper_pieces()) {
      for (const int step : {1, 2}) {
        const Q t = u.piece_begin(k) + (u.piece_end(k) - u.piece_begin(k)) * Q(step) / Q(3);
        const Q big_t = t / Q(3), big_s = Q(1) - big_t;
        Q a(0), b(0);
        for (int l = 0; l <= j; ++l) {
          Q monomial(1);
          for (int i = 0; i < j; ++i) monomial *= i < l ? big_t : big_s;
          a += theta[static_cast<std::size_t>(l)] * monomial;
          b += theta[static_cast<std::size_t>(j + 1 + l)] * monomial;
        }
        int piece = 1;
        while (edge_knots.piece_end(piece) < t) ++piece;
        const Vec<Q, 1> at_begin = tangent_point<Q, Vec<Q, 1>>(edge_knots, r, piece, t, at(Q(0)));
        const Vec<Q, 1> at_end = tangent_point<Q, Vec<Q, 1>>(edge_knots, r, piece, t, at(Q(3)));
        EXPECT_EQ((curve_point<Q, Vec<Q, 1>>(u, p, k, t))[0], a * at_begin[0] + b * at_end[0]) << j << ' ' << k;
      }
    }
  }
}

}  // namespace
}  // namespace torse::repair
