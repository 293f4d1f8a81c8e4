// The nearest rows with rulings through one point: proportions alpha of either sign, below and above 1, and against
// eigenvalues in double on a fine grid of them.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

double number(const Real& x) { return x.to_double(); }

Real drawn(std::mt19937_64& rng) { return Real(static_cast<int>(rng() % 2001) - 1000) / Real(997); }

/// q_i = alpha p_i + beta_i V for `count` points p_i, with errors up to about `noise`.
RealNet<4> net_through(const Vec<Real, 4>& v, const Real& alpha, const Real& noise, int count,
                       const Real& length = Real(1)) {
  std::mt19937_64 rng(7);
  RealNet<4> net;
  for (int i = 0; i < count; ++i) {
    Vec<Real, 4> p, q;
    const Real beta = length * drawn(rng);
    for (int j = 0; j < 4; ++j) {
      p[j] = drawn(rng) + Real(j == 0 ? 3 : 0);
      q[j] = alpha * p[j] + beta * v[j] + noise * drawn(rng);
    }
    net.points.insert(net.points.end(), {p, q});
    net.scale.insert(net.scale.end(), {Real(1) / Real(2 + i % 3), Real(1 + i % 2)});
  }
  return net;
}

/// The least sum over the rulings derived - alpha base of their squares beyond the largest eigenvalue of the matrix of
/// their moments, from column `first`, for alpha in [-1, 1] in steps of 2^-10 and either row as base.
double least_by_grid(const RealNet<4>& net, int first) {
  constexpr int steps = 1024;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t base : {0U, 1U}) {
    for (int k = -steps; k <= steps; ++k) {
      const double alpha = static_cast<double>(k) / steps;
      Eigen::MatrixXd moments = Eigen::MatrixXd::Zero(4 - first, 4 - first);
      double sum = 0;
      for (std::size_t i = 0; i < net.size(); i += 2) {
        Eigen::Vector4d ruling;
        for (int j = 0; j < 4; ++j)
          ruling[j] = number(net.points[i + 1 - base][j]) - alpha * number(net.points[i + base][j]);
        const double scale = number(net.scale[i + 1 - base]) + alpha * alpha * number(net.scale[i + base]);
        moments += ruling.tail(4 - first) * ruling.tail(4 - first).transpose() / scale;
        sum += ruling.squaredNorm() / scale;
      }
      least = std::min(least, sum - Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(moments).eigenvalues().maxCoeff());
    }
  }
  return least;
}

TEST(Pencil, WhatHasRulingsThroughOnePointIsFound) {
  const Vec<Real, 4> point(Real(1), Real(2), Real(-1), Real(5));
  const Vec<Real, 4> direction(Real(0), Real(2), Real(-1), Real(5));
  struct Case {
    Real alpha;
    int count;
  };
  for (const auto& [alpha, count] : {Case{Real(3), 4}, Case{Real(-7) / Real(19), 4}, Case{Real(-41) / Real(40), 4},
                                     Case{Real(5) / Real(-7), 130}}) {  // of many points a part is looked at first
    const RealNet<4> cone = net_through(point, alpha, Real(0), count);
    const RealNet<4> cylinder = net_through(direction, alpha, Real(0), count);
    EXPECT_LT(number(pencil_candidate(cone).squared), 1e-60) << number(alpha);
    EXPECT_LT(number(cylinder_candidate<4>(cylinder).squared), 1e-60) << number(alpha);
    EXPECT_GT(number(cylinder_candidate<4>(cone).squared), 1e-3) << number(alpha);
  }
}

TEST(Pencil, ShortRulingsAreFound) {
  const Vec<Real, 4> v(Real(0), Real(2), Real(-1), Real(5));
  for (const int parts : {10, 100, 1000, 10000}) {
    const RealNet<4> net = net_through(v, Real(101) / Real(127), Real(0), 5, Real(1) / Real(parts));
    EXPECT_LT(number(pencil_candidate(net).squared), 1e-60) << parts;
    EXPECT_LT(number(cylinder_candidate<4>(net).squared), 1e-60) << parts;
  }
}

TEST(Pencil, NoOtherProportionIsNearer) {
  const Vec<Real, 4> v(Real(0), Real(2), Real(-1), Real(5));
  for (const Real& alpha : {Real(-3), Real(1) / Real(3), Real(64) / Real(65)}) {
    const RealNet<4> net = net_through(v, alpha, Real(1) / Real(2), 6);
    const double through_point = least_by_grid(net, 0);
    const double along_vector = least_by_grid(net, 1);
    EXPECT_LT(number(pencil_candidate(net).squared), through_point * (1 + 1e-9));
    EXPECT_GT(number(pencil_candidate(net).squared), through_point * (1 - 1e-2));
    EXPECT_LT(number(cylinder_candidate<4>(net).squared), along_vector * (1 + 1e-9));
    EXPECT_GT(number(cylinder_candidate<4>(net).squared), along_vector * (1 - 1e-2));
  }
}

}  // namespace
}  // namespace torse::repair
