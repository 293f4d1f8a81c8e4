// The nearest cone: its ratio is the simplest fraction that costs no more than a 256th of the squared distance.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

using Q = Rational;

/// Moments of the two rows about their means, and the squared distance of a cone whose second row is alpha times the
/// first but for a translation: the least sum of |x_i|^2 + |y_i|^2 with d_i + y_i - t = alpha (c_i + x_i).
struct Moments {
  double cc = 0, cd = 0, dd = 0;

  explicit Moments(const RealNet<3>& net) {
    Eigen::Vector3d c_mean = Eigen::Vector3d::Zero(), d_mean = c_mean;
    const auto count = static_cast<double>(net.size() / 2);
    const auto at = [&](std::size_t k) {
      return Eigen::Vector3d(net.points[k][0].to_double(), net.points[k][1].to_double(), net.points[k][2].to_double());
    };
    for (std::size_t i = 0; i < net.size(); i += 2) {
      c_mean += at(i) / count;
      d_mean += at(i + 1) / count;
    }
    for (std::size_t i = 0; i < net.size(); i += 2) {
      cc += (at(i) - c_mean).squaredNorm();
      dd += (at(i + 1) - d_mean).squaredNorm();
      cd += (at(i) - c_mean).dot(at(i + 1) - d_mean);
    }
  }

  double distance(double alpha) const { return (dd - 2 * alpha * cd + alpha * alpha * cc) / (1 + alpha * alpha); }
  double least() const { return (cc + dd) / 2 - std::hypot((cc - dd) / 2, cd); }
};

RealNet<3> noisy_cone(double alpha, std::mt19937_64& rng) {
  RealNet<3> net;
  const auto draw = [&] { return Real(static_cast<int>(rng() % 2001) - 1000) / Real(997); };
  for (int i = 0; i < 6; ++i) {
    Vec<Real, 3> c, d;
    for (int j = 0; j < 3; ++j) {
      c[j] = draw();
      d[j] = Real::from_rational(Q::from_double(alpha)) * c[j] + Real(j) + draw() / Real(64);
    }
    net.points.insert(net.points.end(), {c, d});
    net.scale.insert(net.scale.end(), {Real(1), Real(1)});
  }
  return net;
}

TEST(Cone, ItsRatioIsTheSimplestThatIsNearEnough) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 60; ++trial) {
    const double wanted = (trial % 2 == 0 ? 1 : -1) * (0.2 + 0.013 * trial);
    const RealNet<3> net = noisy_cone(wanted, rng);
    const Moments moments(net);
    const Candidate<3> candidate = cone_candidate(net);
    EXPECT_NEAR(candidate.squared.to_double() / moments.least(), 1, 1e-9);
    const auto exact = candidate.realise();
    ASSERT_TRUE(exact);
    const Vec<Q, 3> across = difference((*exact)[2], (*exact)[0]), beside = difference((*exact)[3], (*exact)[1]);
    const Q alpha = beside[0] / across[0];
    EXPECT_EQ(beside[1], alpha * across[1]);
    EXPECT_EQ(beside[2], alpha * across[2]);

    const bool swapped = std::abs(wanted) > 1 || moments.dd > moments.cc;  // the ratio is of the smaller row
    const auto excess = [&](double x) { return moments.distance(swapped ? 1 / x : x) / moments.least() - 1; };
    const Q ratio = swapped ? Q(1) / alpha : alpha;
    EXPECT_LT(excess(ratio.to_double()), 1.02 / 256);
    const std::string text = ratio.text();
    const std::size_t bar = text.find('/');
    const int denominator = bar == std::string::npos ? 1 : std::stoi(text.substr(bar + 1));
    const double best = swapped ? 1 / wanted : wanted;
    for (int den = 1; den < denominator; ++den) {
      for (const double num : {std::floor(best * den), std::ceil(best * den)}) {
        if (num == 0) continue;
        EXPECT_GT(excess(num / den), 0.98 / 256) << text << " " << num << "/" << den;
      }
    }
  }
}

/// The best offset for a ratio is that of the means, d - alpha c. Each of its coordinates is rounded by a 128th of the
/// distance of a point in the mean, or less.
TEST(Cone, ItsOffsetIsTheBestForItsRatioButForRounding) {
  std::mt19937_64 rng(2);
  for (const double wanted : {0.3, 0.5, 0.7}) {
    const RealNet<3> net = noisy_cone(wanted, rng);
    const Candidate<3> candidate = cone_candidate(net);
    const auto exact = candidate.realise();
    ASSERT_TRUE(exact);
    const double alpha = (((*exact)[3][0] - (*exact)[1][0]) / ((*exact)[2][0] - (*exact)[0][0])).to_double();
    const auto count = static_cast<double>(net.size());
    const double allowed = std::sqrt(candidate.squared.to_double() / count) / 128;
    for (int j = 0; j < 3; ++j) {
      double best = 0;
      for (std::size_t i = 0; i < net.size(); i += 2) {
        best += 2 / count * (net.points[i + 1][j].to_double() - alpha * net.points[i][j].to_double());
      }
      EXPECT_NEAR((*exact)[1][j].to_double() - alpha * (*exact)[0][j].to_double(), best, allowed);
    }
  }
}

}  // namespace
}  // namespace torse::repair
