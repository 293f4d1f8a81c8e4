// Banded matrices against dense ones; the minimum over ordered coefficients against all choices of equal neighbours,
// and by the conditions of Karush, Kuhn and Tucker.
#include "torse/quasi/monotone_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <vector>

namespace torse::quasi {
namespace {

using Dense = Eigen::MatrixXd;
using Column = Eigen::VectorXd;

double drawn(std::mt19937_64& rng) { return static_cast<double>(rng() >> 11) * 0x1p-52 - 1; }

/// A sum of squares of `rows` random linear functions of width + 1 neighbours and `diagonal` times the identity.
BandedMatrix random_matrix(std::size_t size, std::size_t width, int rows, double diagonal, std::mt19937_64& rng) {
  BandedMatrix h(size, width);
  for (std::size_t i = 0; i < size; ++i) h.at(i, 0) = diagonal;
  for (int r = 0; r < rows; ++r) {
    std::vector<double> row(std::min(width + 1, size));
    for (double& x : row) x = drawn(rng);
    const std::size_t first = rng() % (size - row.size() + 1);
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (std::size_t j = i; j < row.size(); ++j) h.at(first + i, j - i) += row[i] * row[j];
    }
  }
  return h;
}

Dense dense(const BandedMatrix& h) {
  const auto n = static_cast<Eigen::Index>(h.size());
  Dense m = Dense::Zero(n, n);
  for (std::size_t i = 0; i < h.size(); ++i) {
    for (std::size_t k = 0; k <= h.width() && i + k < h.size(); ++k) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(i + k);
      m(a, b) = m(b, a) = h.at(i, k);
    }
  }
  return m;
}

std::vector<double> random_vector(std::size_t size, double scale, std::mt19937_64& rng) {
  std::vector<double> x(size);
  for (double& y : x) y = scale * drawn(rng);
  return x;
}

Column column(const std::vector<double>& x) {
  return Eigen::Map<const Column>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// A point that obeys the constraints.
std::vector<double> ordered_point(std::size_t size, Ends ends, std::mt19937_64& rng) {
  std::vector<double> b(size);
  for (double& x : b) x = (1 + drawn(rng)) / 2;
  std::ranges::sort(b);
  if (ends == Ends::fixed) {
    b.front() = 0;
    b.back() = 1;
  }
  return b;
}

TEST(BandedMatrix, ProductsAndSolutionsAreThoseOfDenseMatrices) {
  std::mt19937_64 rng(1);
  for (const std::size_t size : {1U, 2U, 3U, 7U, 30U}) {
    for (const std::size_t width : {0U, 1U, 2U, 5U}) {
      BandedMatrix h = random_matrix(size, width, 3 * static_cast<int>(size), 0.5, rng);
      const Dense m = dense(h);
      const std::vector<double> x = random_vector(size, 1, rng);
      std::vector<double> y(size, 7);
      h.multiply(x, y);
      EXPECT_LT((column(y) - m * column(x)).norm(), 1e-12 * m.norm());
      h.solve(y);
      EXPECT_LT((column(y) - m.llt().solve(m * column(x))).norm(), 1e-11);
      EXPECT_LT((column(y) - column(x)).norm(), 1e-11);
      Dense lower = Dense::Identity(m.rows(), m.cols());  // h has become D, and L^T above it
      for (Eigen::Index i = 0; i < m.rows(); ++i) {
        for (Eigen::Index j = i + 1; j < m.cols(); ++j) lower(j, i) = dense(h)(i, j);
      }
      EXPECT_LT((lower * dense(h).diagonal().asDiagonal() * lower.transpose() - m).norm(), 1e-12 * m.norm());
    }
  }
}

/// The largest entry becomes 4 + (4 + 4e-6) / 2 + 4e-12.
TEST(BandedMatrix, DampingIsRelativeToTheDiagonal) {
  BandedMatrix h(3, 1);
  h.at(0, 0) = 1;
  h.at(1, 0) = 4;
  h.at(0, 1) = 1.5;
  h.at(1, 1) = -7;
  const BandedMatrix damped = h.damped(0.5);
  EXPECT_DOUBLE_EQ(damped.at(0, 0), 1.500002000004);
  EXPECT_DOUBLE_EQ(damped.at(1, 0), 6.000002000004);
  EXPECT_DOUBLE_EQ(damped.at(2, 0), 2.000004e-6);
  EXPECT_EQ(damped.at(0, 1), 1.5);
  EXPECT_EQ(damped.at(1, 1), -7);
  EXPECT_EQ(h.at(1, 0), 4);
}

TEST(BandedMatrix, ClearsToZeroOfAnotherSize) {
  BandedMatrix h(3, 1);
  h.at(1, 1) = 5;
  h.clear(2);
  EXPECT_EQ(h.size(), 2U);
  EXPECT_EQ(h.width(), 1U);
  EXPECT_EQ(dense(h).norm(), 0);
}

/// 1/2 (x - b)^T H (x - b) + g^T (x - b).
double model(const Dense& h, const Column& g, const Column& b, const Column& x) {
  return 0.5 * (x - b).dot(h * (x - b)) + g.dot(x - b);
}

/// The minimum by trying every set of equal neighbours: x_i is 0, 1 or the next unknown where a bit is set or not.
Column by_all_sets(const Dense& h, const Column& g, const Column& b, Ends ends) {
  const Eigen::Index n = b.size();
  Column best = b;
  for (unsigned set = 0; set < 1U << (n + 1); ++set) {
    const auto tied = [&](Eigen::Index i) { return (set >> i & 1) != 0; };
    if (ends == Ends::fixed && !(tied(0) && tied(n))) continue;
    if (set == (1U << (n + 1)) - 1) continue;
    // x = map y + shift
    Dense map = Dense::Zero(n, n);
    Column shift = Column::Zero(n);
    Eigen::Index unknowns = 0;
    Eigen::Index upper = n;  // from here on 1
    while (upper > 0 && tied(upper)) --upper;
    if (tied(n)) {
      for (Eigen::Index i = std::max<Eigen::Index>(upper, 0); i < n; ++i) shift[i] = 1;
    } else {
      upper = n;
    }
    bool zero = tied(0);
    for (Eigen::Index i = 0; i < upper; ++i) {
      if (i > 0 && !tied(i)) zero = false;
      if (zero) continue;
      if (i == 0 || !tied(i)) ++unknowns;
      map(i, unknowns - 1) = 1;
    }
    const Dense m = map.leftCols(unknowns);
    Column x = shift;
    if (unknowns > 0) {
      const Column right = m.transpose() * (h * (b - shift) - g);
      x += m * (m.transpose() * h * m).ldlt().solve(right);
    }
    bool ordered = x[0] >= -1e-12 && x[n - 1] <= 1 + 1e-12;
    for (Eigen::Index i = 1; i < n; ++i) ordered = ordered && x[i] >= x[i - 1] - 1e-12;
    if (ordered && model(h, g, b, x) < model(h, g, b, best)) best = x;
  }
  return best;
}

TEST(MonotoneModel, TheMinimumOverAllSetsOfEqualNeighbours) {
  std::mt19937_64 rng(2);
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    for (std::size_t size = 2; size <= 6; ++size) {
      for (std::size_t width = 1; width <= 3; ++width) {
        for (int trial = 0; trial < 15; ++trial) {
          const BandedMatrix h = random_matrix(size, width, 2 * static_cast<int>(size), 0.1, rng);
          const std::vector<double> g = random_vector(size, trial < 5 ? 0.3 : trial < 10 ? 2 : 20, rng);
          const std::vector<double> b = ordered_point(size, ends, rng);
          MonotoneModel minimizer(size, width, ends);
          const std::vector<double> x = minimizer.minimize(h, g, b);
          const Column best = by_all_sets(dense(h), column(g), column(b), ends);
          EXPECT_LT((column(x) - best).norm(), 1e-8) << column(x).transpose() << "\n" << best.transpose();
        }
      }
    }
  }
}

void expect_feasible(const std::vector<double>& x, Ends ends) {
  EXPECT_GE(x.front(), 0);
  EXPECT_LE(x.back(), 1);
  for (std::size_t i = 1; i < x.size(); ++i) EXPECT_GE(x[i], x[i - 1]);
  if (ends == Ends::fixed) {
    EXPECT_EQ(x.front(), 0);
    EXPECT_EQ(x.back(), 1);
  }
}

/// With the gradient r of the model at x the multipliers of x_i - x_{i-1} >= 0 (x_{-1} = 0, x_n = 1) are l_i with r_i =
/// l_i - l_{i+1}: none is negative, and those of unequal neighbours are 0.
void expect_optimal(const Dense& h, const Column& g, const Column& b, const Column& x, Ends ends) {
  const Eigen::Index n = x.size();
  const Column r = h * (x - b) + g;
  const double tolerance = 1e-9 * (h.norm() + g.norm());
  const auto apart = [&](Eigen::Index i) { return (i == n ? 1 : x[i]) - (i == 0 ? 0 : x[i - 1]); };
  Eigen::Index loose = 0;
  while (apart(loose) <= 0) ++loose;
  double multiplier = r.head(loose).sum();
  for (Eigen::Index i = 0; i <= n; ++i) {
    const bool equality = ends == Ends::fixed && (i == 0 || i == n);
    if (!equality) {
      EXPECT_GE(multiplier, -tolerance) << i;
    }
    if (apart(i) > 1e-9) {
      EXPECT_NEAR(multiplier, 0, tolerance) << i;
    }
    if (i < n) multiplier -= r[i];
  }
}

TEST(MonotoneModel, KarushKuhnAndTucker) {
  std::mt19937_64 rng(3);
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    for (int trial = 0; trial < 60; ++trial) {
      const std::size_t size = 60;
      const BandedMatrix h = random_matrix(size, 2, 180, 0.01, rng);
      const std::vector<double> g = random_vector(size, trial % 3 == 0 ? 0.01 : trial % 3 == 1 ? 0.3 : 10, rng);
      const std::vector<double> b = ordered_point(size, ends, rng);
      MonotoneModel minimizer(size, 2, ends);
      const std::vector<double> x = minimizer.minimize(h, g, b);
      expect_feasible(x, ends);
      expect_optimal(dense(h), column(g), column(b), column(x), ends);
    }
  }
}

TEST(MonotoneModel, TheActiveSetOfOneCallServesTheNext) {
  std::mt19937_64 rng(4);
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    MonotoneModel kept(20, 2, ends);
    for (int trial = 0; trial < 40; ++trial) {
      const BandedMatrix h = random_matrix(20, 2, 60, 0.1, rng);
      const std::vector<double> g = random_vector(20, 1, rng);
      const std::vector<double> b = ordered_point(20, ends, rng);
      MonotoneModel fresh(20, 2, ends);
      EXPECT_LT((column(kept.minimize(h, g, b)) - column(fresh.minimize(h, g, b))).norm(), 1e-9);
    }
  }
}

TEST(MonotoneModel, NearlySingularMatricesGiveOrderedCoefficients) {
  std::mt19937_64 rng(5);
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    for (const double diagonal : {1e-12, 1e-16, 1e-300}) {
      for (int trial = 0; trial < 20; ++trial) {
        const BandedMatrix h = random_matrix(30, 3, 8, diagonal, rng);
        MonotoneModel minimizer(30, 3, ends);
        expect_feasible(minimizer.minimize(h, random_vector(30, 1, rng), ordered_point(30, ends, rng)), ends);
      }
    }
  }
}

TEST(MonotoneModel, AllCoefficientsAtOneEnd) {
  for (const double force : {-100.0, 100.0}) {
    BandedMatrix h(5, 1);
    for (std::size_t i = 0; i < 5; ++i) h.at(i, 0) = 1;
    MonotoneModel minimizer(5, 1, Ends::free);
    const std::vector<double> x =
        minimizer.minimize(h, std::vector<double>(5, force), std::vector<double>{0, 0.25, 0.5, 0.75, 1});
    EXPECT_EQ(x, std::vector<double>(5, force > 0 ? 0 : 1));
  }
}

}  // namespace
}  // namespace torse::quasi
