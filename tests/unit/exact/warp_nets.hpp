// Nets for tests of the certified warp angle, and what every enclosure promises.
//   Net, hyperbolic, random_net      warp_of, at_most
//   expect_narrow, expect_contains
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "torse/exact/warp/max_warp.hpp"
#include "torse/spline/curve.hpp"

namespace torse::test {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Row3 = std::vector<Point3>;

inline constexpr double degree = std::numbers::pi / 180;

inline Q power(int base, int exponent) {
  Q result(1);
  for (int i = 0; i < std::abs(exponent); ++i) result *= Q(base);
  return exponent < 0 ? Q(1) / result : result;
}

struct Net {
  KnotList<Q> u;
  Row3 c;
  Row3 d;
};

inline WarpEnclosure warp_of(const Net& net, const WarpOptions& options = {}) {
  return max_warp<Q, 3>(net.u, net.c, net.d, options);
}
inline Truth at_most(const Net& net, const Q& degrees, const WarpOptions& options = {}) {
  return warp_at_most<Q, 3>(net.u, net.c, net.d, Angle{degrees}, options);
}

/// Complete, in order and as narrow as promised.
inline void expect_narrow(const WarpEnclosure& warp, double tolerance = 1e-3) {
  EXPECT_TRUE(warp.complete);
  EXPECT_LE(warp.lower, warp.upper);
  EXPECT_LE(warp.upper - warp.lower, tolerance * warp.upper);
}
inline void expect_contains(const WarpEnclosure& warp, double degrees) {
  EXPECT_LE(warp.lower, degrees * (1 + 1e-14));
  EXPECT_GE(warp.upper, degrees * (1 - 1e-14));
}

/// (t, 0, 0) and (t, 1, h t) over [a, b]: sin^2 = h^2 / (1 + h^2 + h^2 t^2).
inline Net hyperbolic(const Q& h, const Q& a, const Q& b) {
  const Q zero(0);
  return {bezier_knots<Q>(1, a, b),
          {Point3(a, zero, zero), Point3(b, zero, zero)},
          {Point3(a, Q(1), h * a), Point3(b, Q(1), h * b)}};
}

/// A net of random points near two lines, over `pieces` pieces.
inline Net random_net(int n, int pieces, int spread, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto noise = [&] { return Q(static_cast<int>(rng() % 2001) - 1000) / Q(1000 * spread); };
  std::vector<Q> u(static_cast<std::size_t>(n), Q(0));
  for (int i = 1; i < pieces; ++i) u.push_back(Q(i) / Q(3));
  u.insert(u.end(), static_cast<std::size_t>(n), Q(pieces) / Q(3));
  Net net{KnotList<Q>(n, std::move(u)), {}, {}};
  for (int i = 0; i <= net.u.last(); ++i) {
    const Q x(i);
    const Q cx = x + noise(), cy = noise(), cz = noise();
    const Q dx = x + noise(), dy = Q(1) + noise(), dz = noise();
    net.c.push_back(Point3(cx, cy, cz));
    net.d.push_back(Point3(dx, dy, dz));
  }
  return net;
}

}  // namespace torse::test
