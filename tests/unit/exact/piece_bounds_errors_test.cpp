// The error terms of the cheap bounds against the derivation in piece_bounds.hpp, on planar nets along the axes: all
// that is computed there is exact, so the bounds show nothing but their error terms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "torse/exact/warp/piece_bounds.hpp"

namespace torse {
namespace {

/// c_i = (abscissas[i], 0, 0) and d_i = c_i + (shear, rulings[i], z), one piece on [0, 1]. Numbers are known up to the
/// errors of a RoundedNet.
struct PlanarNet {
  std::vector<double> abscissas;
  std::vector<double> rulings;
  double error = 0;
  double knot_error = 0;
  double lift = 0;  ///< z of all d_i but the first
  double shear = 0;
};

PieceBound bound_of(const PlanarNet& net) {
  const int n = static_cast<int>(net.abscissas.size()) - 1;
  RoundedNet<3> rounded{n, bezier_knots<double>(n).list(), {}, {}, net.knot_error, net.error};
  for (std::size_t i = 0; i < net.abscissas.size(); ++i) {
    rounded.c.emplace_back(net.abscissas[i], 0, 0);
    rounded.d.emplace_back(net.abscissas[i] + net.shear, net.rulings[i], i > 0 ? net.lift : 0);
  }
  return piece_bounds(rounded, {1}).front();
}

/// What the derivation counts with: the largest coordinates of the control points of c'/n, d'/n and of d - c, and the
/// relative error of a factor after them. Each difference of points has two coordinate errors, c' and d' are divided by
/// a difference of knots. In a rotated frame coordinates grow by up to the square root of 3.
struct Sizes {
  double speed = 0;
  double ruling = 0;
  double relative = 0;

  explicit Sizes(const PlanarNet& net) : ruling(net.shear) {
    for (std::size_t i = 0; i < net.rulings.size(); ++i) {
      ruling = std::max(ruling, net.rulings[i]);
      if (i > 0) {
        speed =
            std::max({speed, net.abscissas[i] - net.abscissas[i - 1], std::abs(net.rulings[i] - net.rulings[i - 1])});
      }
    }
    relative = 2 * net.error / std::min(speed, ruling) + net.knot_error;
    speed *= std::numbers::sqrt3;
    ruling *= std::numbers::sqrt3;
  }

  /// Six products of three coordinates.
  double volume() const { return 6 * speed * speed * ruling; }
};

/// The upper bound of a net whose determinant is zero: the error of [a, b, w] (|w|^2 + r^2), five factors, over
/// 2 r M N at the beginning of the piece, where M = N = (slope of the abscissas) (length of the ruling).
double least_upper_bound(const PlanarNet& net) {
  const Sizes sizes(net);
  double mean = 0;
  for (const double x : net.rulings) mean += x;
  mean /= static_cast<double>(net.rulings.size());
  const double square = mean * mean;
  const double error = 5 * sizes.relative * sizes.volume() * (3 * sizes.ruling * sizes.ruling + square);
  const double normal = (net.abscissas[1] - net.abscissas[0]) * net.rulings[0];
  const double sine = error / (2 * mean * normal * normal);
  return sine * sine;
}

constexpr double error = 0x1p-33;

TEST(PieceBoundErrors, OfTheUpperBoundCountAllFactors) {
  for (const PlanarNet& net :
       {PlanarNet{{0, 1}, {1, 1}, error}, PlanarNet{{0, 1, 2}, {1, 1, 1}, error}, PlanarNet{{0, 4}, {1, 1}, error},
        PlanarNet{{0, 1}, {4, 4}, error}, PlanarNet{{0, 1, 2, 3}, {2, 2, 2, 2}, error}}) {
    const double least = least_upper_bound(net);
    EXPECT_GE(bound_of(net).upper, least);
    EXPECT_LE(bound_of(net).upper, 4 * least);
  }
}

TEST(PieceBoundErrors, OfTheKnotsAreErrorsOfAllFactors) {
  const PlanarNet net{{0, 1}, {1, 1}, 0, error};
  EXPECT_GE(bound_of(net).upper, least_upper_bound(net));
  const PlanarNet lifted{{0, 1}, {1, 1}, 0, error, 2 * error};
  EXPECT_EQ(bound_of(lifted).at_begin, 0);
}

/// On the way to a Bezier point are up to 2n - 1 means with weights off by twice the error of the knots, and c' and d'
/// are divided by one more difference of knots.
TEST(PieceBoundErrors, OfTheKnotsCountEveryMean) {
  for (const int n : {1, 2, 3, 5}) {
    PlanarNet net{{}, {}, 0, error};
    for (int i = 0; i <= n; ++i) {
      net.abscissas.push_back(i);
      net.rulings.push_back(1);
    }
    PlanarNet counted = net;
    counted.knot_error = (2 * (2 * n - 1) + 1) * error;
    EXPECT_GE(bound_of(net).upper, least_upper_bound(counted)) << n;
    EXPECT_LE(bound_of(net).upper, 20 * least_upper_bound(counted)) << n;
  }
}

/// The largest coordinates are those of the last point, or of the first.
TEST(PieceBoundErrors, CountTheLargestOfAllPoints) {
  for (const PlanarNet& net :
       {PlanarNet{{0, 1, 9}, {1, 1, 1}, error}, PlanarNet{{0, 8, 9}, {1, 1, 1}, error},
        PlanarNet{{0, 1, 2, 3}, {1, 1, 1, 8}, error}, PlanarNet{{0, 1, 2, 3}, {8, 1, 1, 1}, error}}) {
    EXPECT_GE(bound_of(net).upper, least_upper_bound(net));
  }
}

/// At the beginning a = (1, 0, 0), b = (1, 0, z), w = (0, 1, 0), so [a, b, w] = -z. Where the error of these three
/// factors may be as large as that, nothing is known; well beyond it something is.
TEST(PieceBoundErrors, OfTheLowerBoundCoverTheVolume) {
  PlanarNet net{{0, 1}, {1, 1}, error};
  const Sizes sizes(net);
  const double volume_error = 3 * sizes.relative * sizes.volume();
  net.lift = 0.9 * volume_error;
  EXPECT_EQ(bound_of(net).at_begin, 0);
  net.lift = 4 * volume_error;
  EXPECT_GT(bound_of(net).at_begin, 0);
}

/// a = b = (1, 0, 0) and w = (1, y, 0) may be parallel within the errors of a x w: two products of two factors.
TEST(PieceBoundErrors, CoverNormalsThatMayVanish) {
  PlanarNet net{{0, 1}, {0, 0}, error, 0, 0, 1};
  const Sizes sizes(net);
  const double normal_error = 2 * 2 * sizes.relative * sizes.speed * sizes.ruling;
  net.rulings = {0.9 * normal_error, 0.9 * normal_error};
  EXPECT_EQ(bound_of(net).upper, detail::infinity);
  net.rulings = {0.25, 0.25};
  EXPECT_LE(bound_of(net).upper, 1e-10);
}

/// With z = 1 sin^2 is 1/2 at the beginning: a x w = (0, 0, 1), b x w = (-1, 0, 1). The lower bound has to leave room
/// for the error of the squares of both normals, of four factors and 12 products each.
TEST(PieceBoundErrors, OfTheLowerBoundCoverTheNormals) {
  const PlanarNet net{{0, 1}, {1, 1}, error, 0, 1};
  const Sizes sizes(net);
  const double normal_error = 12 * 4 * sizes.relative * std::pow(sizes.speed * sizes.ruling, 2);
  const double most = 1 / ((1 + normal_error) * (2 + normal_error));
  EXPECT_LE(bound_of(net).at_begin, most);
  EXPECT_GE(bound_of(net).at_begin, 0.49);
}

}  // namespace
}  // namespace torse
