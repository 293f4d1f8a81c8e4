// The constants of the nearest net: fractions as simple as their accuracy lets them be, and no simpler.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "support/knots.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/repair/families.hpp"

namespace torse::repair {
namespace {

using Q = Rational;
using test::knots;
using Row4 = Vec<Q, 4>;

Q q(int num, int den = 1) { return ratio<Q>(num, den); }

/// The relation with constants L*, M*, sigma over knots as they are, for a net of points (3) or homogeneous rows (4).
template <int D>
struct Relation {
  BilinearSystem<Real> system;
  const RealNet<D>& net;

  Relation(const KnotList<Q>& u, const RealNet<D>& points) : net(points) {
    std::vector<Real> list;
    for (const Q& x : u.list()) list.push_back(Real::from_rational(x));
    system = constant_relation<Real>(u.degree(), list, D == 4);
  }

  static std::vector<Real> theta(const std::array<Real, 3>& x) {
    const auto& [lambda, m, sigma] = x;
    return D == 4 ? std::vector<Real>{lambda, Real(1), sigma * m, sigma} : std::vector<Real>{lambda, Real(1), m};
  }

  Real squared(const std::array<Real, 3>& x) const { return project<D>(system, net, theta(x))->squared; }

  /// The constants of the minimum near x.
  std::array<Real, 3> minimum(const std::array<Real, 3>& x) const {
    const Projector<D> projector = [this](const std::vector<Real>& t) { return project<D>(system, net, t); };
    const std::vector<Real> t = descend<D>(projector, theta(x), D, Real(1))->theta;
    const Real other = t[D == 4 ? 3 : 1];
    return {t[0] / t[1], t[2] / other, other / t[1]};
  }

  /// Half the second derivative of the squared distance by constant k, by differences.
  Real weight(const std::array<Real, 3>& x, std::size_t k) const {
    const Real h = Real::from_rational(power_of_two(-60));
    std::array<Real, 3> less = x;
    std::array<Real, 3> more = x;
    less[k] -= h;
    more[k] += h;
    return (squared(less) - Real(2) * squared(x) + squared(more)) / (Real(2) * h * h);
  }
};

/// Each constant is off by no more than what adds f / 2^8 where all of them do, and no fraction with a smaller
/// denominator is.
template <int D>
void expect_simplest(const KnotList<Q>& u, const RealNet<D>& net) {
  const auto candidate = constant_candidate<D>(u, net, Real(1));
  ASSERT_TRUE(candidate);
  const RelationConstants& found = candidate->constants.at(0);
  const std::array<Q, 3> fractions{found.lambda, found.m, found.sigma};
  const Relation<D> relation(u, net);
  std::array<Real, 3> start;
  for (std::size_t k = 0; k < 3; ++k) start[k] = Real::from_rational(fractions[k]);
  const std::array<Real, 3> x = relation.minimum(start);
  const int count = D - 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const Real share = relation.squared(x) / Real(256);
    const Real error = (share / relation.weight(x, k)).square_root() / Real(count);
    EXPECT_LE((magnitude(start[k] - x[k]) / error).to_double(), 1.001) << k;
    const Q simplest = simplest_near(x[k], Real::from_rational(q(999, 1000)) * error);
    EXPECT_LE(mpz_cmp(mpq_denref(fractions[k].mpq()), mpq_denref(simplest.mpq())), 0) << k;
  }
}

/// Nets with constants but for errors of 2^-20, over a domain that is not [-1, 1].
template <int D>
void expect_simplest_of_drawn(const Q& sigma, std::mt19937_64& rng) {
  const KnotList<Q> u = knots(3, {2, 2, 2, 4, 5, 8, 8, 8});
  std::vector<Row4> p;
  const auto draw = [&](int unit) { return q(static_cast<int>(rng() % 401) - 200, unit); };
  for (int i = 0; i <= u.last(); ++i) {
    const Q w = D == 4 ? q(static_cast<int>(rng() % 5) + 6, 8) : Q(1);
    p.push_back(Row4(w, Q(2 * i) + draw(256), draw(64), draw(64)));
  }
  const auto r = rational_net<Q, Row4>(u, p, Q(-1) + draw(400), Q(11) + draw(400), sigma,
                                       scaled(Q(1) / sigma, Row4(Q(1), Q(1), Q(-3), Q(7))));
  RealNet<D> net;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const Row4& x : {p[i], r[i]}) {
      Vec<Real, D> y;
      for (int j = 0; j < D; ++j) y[j] = Real::from_rational(x[j + 4 - D] + draw(1 << 28));
      net.points.push_back(y);
      net.scale.push_back(Real(1));
    }
  }
  expect_simplest<D>(u, net);
}

TEST(RepairConstants, AreTheSimplestWithinTheirShare) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 12; ++trial) {
    expect_simplest_of_drawn<3>(Q(1), rng);
    expect_simplest_of_drawn<4>(q(1 + trial, 4), rng);
  }
}

/// Nets without constants, where descents from different starts end at different places.
TEST(RepairConstants, NoStartIsNearer) {
  std::mt19937_64 rng(2);
  const KnotList<Q> u = knots(2, {-1, -1, 0, 1, 1});
  const auto domain = Relation<4>(u, {}).system;
  for (int trial = 0; trial < 12; ++trial) {
    RealNet<4> net;
    for (int i = 0; i < 2 * (u.last() + 1); ++i) {
      Vec<Real, 4> x;
      for (int j = 0; j < 4; ++j) x[j] = Real(static_cast<int>(rng() % 41) - 20);
      net.points.push_back(x);
      net.scale.push_back(Real(1));
    }
    const auto candidate = constant_candidate<4>(u, net, Real(1000));
    ASSERT_TRUE(candidate);
    const Projector<4> projector = [&](const std::vector<Real>& t) { return project<4>(domain, net, t); };
    for (const std::vector<Real>& start : first_constants<4>(domain, net)) {
      EXPECT_LE(candidate->squared, descend<4>(projector, start, 4, Real(1000))->nearest.squared) << trial;
    }
  }
}

/// The sum of squares of the equations for constants of length 1.
template <int D>
double residual(const BilinearSystem<Real>& system, const RealNet<D>& net, const std::vector<Real>& theta) {
  Real sum, length;
  for (const std::vector<Term<Real>>& equation : system.equations) {
    for (int j = 0; j < D; ++j) {
      Real value;
      for (const Term<Real>& term : equation) {
        value += term.coefficient * theta[term.constant] * net.points[term.point][j];
      }
      sum += value * value;
    }
  }
  for (const Real& x : theta) length += x * x;
  return (sum / length).to_double();
}

/// Stationary, the smallest first: the first is the least of all, the last the largest.
TEST(RepairConstants, StartsAreInTheOrderOfTheirEquations) {
  std::mt19937_64 rng(3);
  RealNet<4> net;
  const KnotList<Q> u = knots(2, {-1, -1, 0, 1, 1});
  for (int i = 0; i < 2 * (u.last() + 1); ++i) {
    Vec<Real, 4> x;
    for (int j = 0; j < 4; ++j) x[j] = Real(static_cast<int>(rng() % 41) - 20);
    net.points.push_back(x);
    net.scale.push_back(Real(1));
  }
  const auto system = Relation<4>(u, net).system;
  const std::vector<std::vector<Real>> starts = first_constants<4>(system, net);
  ASSERT_EQ(starts.size(), 4U);
  for (std::size_t i = 0; i + 1 < 4; ++i) {
    EXPECT_LT(residual<4>(system, net, starts[i]), residual<4>(system, net, starts[i + 1])) << i;
  }
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Real> theta;
    for (int m = 0; m < 4; ++m) theta.push_back(Real(static_cast<int>(rng() % 41) - 20));
    if (trial < 4) theta = {Real(trial == 0), Real(trial == 1), Real(trial == 2), Real(trial == 3)};
    EXPECT_LE(residual<4>(system, net, starts[0]), residual<4>(system, net, theta));
    EXPECT_GE(residual<4>(system, net, starts[3]), residual<4>(system, net, theta));
  }
}

/// 24 parts are tried, 25 are not.
TEST(RepairConstants, TheMostPartsThatAreTried) {
  for (const int parts : {24, 25}) {
    std::vector<int> list;
    std::vector<Row4> p;
    for (int i = 0; i <= parts; ++i) {
      list.push_back(i);
      p.push_back(Row4(Q(1), Q(i), Q(i * i % 7), Q(i % 4)));
    }
    const KnotList<Q> u = knots(1, list);
    const auto r = linear_net<Q, Row4>(u, p, q(-1), q(-2), Row4(Q(1), Q(0), Q(1), Q(5)));
    RealNet<3> net;
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (const Row4& x : {p[i], r[i]}) {
        net.points.push_back(
            Vec<Real, 3>(Real::from_rational(x[1]), Real::from_rational(x[2]), Real::from_rational(x[3])));
        net.scale.push_back(Real(1));
      }
    }
    EXPECT_EQ(segments_candidate<3>(u, net, Real(1)).has_value(), parts == 24);
  }
}

}  // namespace
}  // namespace torse::repair
