// The certified warp angle against angles known in closed form, exact samples, and its invariances.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/warp.hpp"
#include "unit/exact/warp_nets.hpp"

namespace torse::test {
namespace {

/// The largest angle at `count` parameters of each piece, sin^2 exactly and the arc sine in long double.
double sampled(const Net& net, int count) {
  long double most = 0;
  for (const int k : net.u.proper_pieces()) {
    for (int i = 0; i <= count; ++i) {
      const Q t = net.u.piece_begin(k) + Q(i) / Q(count) * (net.u.piece_end(k) - net.u.piece_begin(k));
      const Q sine2 = pointwise_sine_squared<Q>(net.u, net.c, net.d, k, t);
      most = std::max(most, std::asin(std::sqrt(static_cast<long double>(sine2.to_double()))));
    }
  }
  return static_cast<double>(most / std::numbers::pi_v<long double> * 180);
}

template <class Change>
Net changed(Net net, Change change) {
  for (Row3* row : {&net.c, &net.d}) {
    for (Point3& x : *row) x = change(x);
  }
  return net;
}

TEST(Warp, OfAHyperbolicParaboloid) {
  for (const auto& [a, b, nearest] : {std::tuple{0, 1, 0.0}, {-1, 1, 0.0}, {-3, 2, 0.0}, {2, 5, 2.0}, {-4, -1, 1.0}}) {
    for (const int tenths : {1, 10, 57, 1000}) {
      const WarpEnclosure warp = warp_of(hyperbolic(Q(tenths) / Q(10), Q(a), Q(b)));
      const double h = tenths / 10.0;
      expect_narrow(warp);
      expect_contains(warp, std::atan(h / std::sqrt(1 + h * h * nearest * nearest)) / degree);
      EXPECT_TRUE(warp.stage == WarpStage::rounded || tenths == 1000);
      EXPECT_EQ(warp.piece, 1);
    }
  }
}

TEST(Warp, NeedsNoMoreThanTheTolerance) {
  const Net net = hyperbolic(Q(1), Q(-3), Q(2));
  const WarpEnclosure coarse = warp_of(net, {.tolerance = 0.1});
  const WarpEnclosure fine = warp_of(net, {.tolerance = 1e-8});
  expect_narrow(coarse, 0.1);
  expect_narrow(fine, 1e-8);
  EXPECT_LE(coarse.lower, fine.upper);
  EXPECT_LE(fine.lower, coarse.upper);
  EXPECT_LT(coarse.intervals, fine.intervals);
}

TEST(Warp, LooksAtEveryPiece) {
  for (int pieces : {1, 3, 8}) EXPECT_GE(warp_of(random_net(3, pieces, 4, 7), {.tolerance = 1}).intervals, pieces);
}

TEST(Warp, BoundsEverySample) {
  for (int n = 1; n <= 5; ++n) {
    for (const int spread : {1, 3, 1000}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(testing::Message() << n << ", " << spread << ", " << seed);
        const Net net = random_net(n, 3, spread, seed);
        const WarpEnclosure warp = warp_of(net);
        const double sample = sampled(net, 60);
        expect_narrow(warp);
        EXPECT_LE(sample, warp.upper * (1 + 1e-15));
        EXPECT_GE(sample, warp.lower * 0.95);
        const Q attained = pointwise_sine_squared<Q>(net.u, net.c, net.d, warp.piece, warp.parameter);
        EXPECT_GE(std::asin(std::sqrt(attained.to_double())) / degree, warp.lower * (1 - 1e-14));
      }
    }
  }
}

TEST(Warp, DoesNotDependOnPositionScaleOrDirection) {
  const Net net = random_net(3, 3, 4, 7);
  const WarpEnclosure warp = warp_of(net, {.tolerance = 1e-6});
  const auto expect_same = [&](const Net& other) {
    const WarpEnclosure again = warp_of(other, {.tolerance = 1e-6});
    expect_narrow(again, 1e-6);
    EXPECT_LE(again.lower, warp.upper);
    EXPECT_LE(warp.lower, again.upper);
  };
  expect_same(changed(net, [](const Point3& x) {
    const Q c = Q(3) / Q(5), s = Q(4) / Q(5);
    return Point3(c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]);
  }));
  for (const Q& scale :
       {power(10, 30), power(10, -30), power(10, 300), power(10, -300), power(10, 1000), Q(-1) / Q(3)}) {
    expect_same(changed(net, [&](const Point3& x) { return Point3(scale * x[0], scale * x[1], scale * x[2]); }));
  }
  const Q far = power(10, 40);
  expect_same(changed(net, [&](const Point3& x) { return Point3(x[0] + far, x[1] - far, x[2] + far); }));
  expect_same({net.u, net.d, net.c});
  std::vector<Q> reversed;
  for (int i = net.u.size() - 1; i >= 0; --i) reversed.push_back(power(10, 50) - net.u[i] / Q(7));
  expect_same({KnotList<Q>(3, reversed), Row3(net.c.rbegin(), net.c.rend()), Row3(net.d.rbegin(), net.d.rend())});
}

TEST(Warp, OfRationalSurfacesDoesNotDependOnAConstantWeight) {
  const Net net = random_net(3, 2, 4, 9);
  const WarpEnclosure warp = warp_of(net, {.tolerance = 1e-6});
  std::vector<Vec<Q, 4>> p, q;
  for (std::size_t i = 0; i < net.c.size(); ++i) {
    p.push_back(Q(2) / Q(3) * Vec<Q, 4>(Q(1), net.c[i][0], net.c[i][1], net.c[i][2]));
    q.push_back(Q(-5) * Vec<Q, 4>(Q(1), net.d[i][0], net.d[i][1], net.d[i][2]));
  }
  const WarpEnclosure homogeneous = max_warp<Q, 4>(net.u, p, q, {.tolerance = 1e-6});
  expect_narrow(homogeneous, 1e-6);
  EXPECT_LE(homogeneous.lower, warp.upper);
  EXPECT_LE(warp.lower, homogeneous.upper);
}

/// A rational surface against samples by the quotient rule.
TEST(Warp, BoundsEverySampleOfRationalSurfaces) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Net net = random_net(3, 2, 4, seed);
    std::mt19937_64 rng(seed);
    std::vector<Vec<Q, 4>> p, q;
    const auto row = [&](const Point3& x) {
      const Q w = Q(static_cast<int>(rng() % 9) + 4) / Q(8);
      return Vec<Q, 4>(w, w * x[0], w * x[1], w * x[2]);
    };
    for (std::size_t i = 0; i < net.c.size(); ++i) {
      p.push_back(row(net.c[i]));
      q.push_back(row(net.d[i]));
    }
    const WarpEnclosure warp = max_warp<Q, 4>(net.u, p, q);
    expect_narrow(warp);
    EXPECT_EQ(warp.stage, WarpStage::rounded);
    double most = 0;
    for (const int k : net.u.proper_pieces()) {
      for (int i = 0; i <= 40; ++i) {
        const Q t = net.u.piece_begin(k) + Q(i) / Q(40) * (net.u.piece_end(k) - net.u.piece_begin(k));
        const auto position = [](const Vec<Q, 4>& x) { return Point3(x[1] / x[0], x[2] / x[0], x[3] / x[0]); };
        const auto velocity = [&](const Vec<Q, 4>& x, const Vec<Q, 4>& dx) {
          const Point3 y = position(x);
          return Point3((dx[1] - dx[0] * y[0]) / x[0], (dx[2] - dx[0] * y[1]) / x[0], (dx[3] - dx[0] * y[2]) / x[0]);
        };
        const Vec<Q, 4> x = curve_point<Q, Vec<Q, 4>>(net.u, p, k, t);
        const Vec<Q, 4> y = curve_point<Q, Vec<Q, 4>>(net.u, q, k, t);
        const Point3 w = difference(position(y), position(x));
        const Point3 m = cross(velocity(x, curve_derivative<Q, Vec<Q, 4>>(net.u, p, k, t)), w);
        const Point3 n = cross(velocity(y, curve_derivative<Q, Vec<Q, 4>>(net.u, q, k, t)), w);
        const Q cosine2 = dot(m, n) * dot(m, n) / (dot(m, m) * dot(n, n));
        most = std::max(most, std::acos(std::sqrt(cosine2.to_double())) / degree);
      }
    }
    EXPECT_LE(most, warp.upper * (1 + 1e-12));
    EXPECT_GE(most, warp.lower * 0.99);
  }
}

TEST(Warp, OfDoublesIsThatOfTheirExactValues) {
  const Net net = random_net(3, 4, 50, 3);
  const auto nearest = [](const Q& x) { return x.to_double(); };
  std::vector<double> knots;
  for (const Q& x : net.u.list()) knots.push_back(nearest(x));
  const KnotList<double> u(3, knots);
  for (const double factor : {1.0, 1e250, 1e-250, 1e-307}) {
    std::vector<Vec<double, 3>> c, d;
    Net exact{net.u, {}, {}};
    std::vector<Q> exact_knots;
    for (const double x : knots) exact_knots.push_back(Q::from_double(x));
    exact.u = KnotList<Q>(3, exact_knots);
    for (std::size_t i = 0; i < net.c.size(); ++i) {
      const auto copy = [&](const Point3& x) {
        return Vec<double, 3>(factor * nearest(x[0]), factor * nearest(x[1]), factor * nearest(x[2]));
      };
      const auto back = [](const Vec<double, 3>& x) {
        return Point3(Q::from_double(x[0]), Q::from_double(x[1]), Q::from_double(x[2]));
      };
      c.push_back(copy(net.c[i]));
      d.push_back(copy(net.d[i]));
      exact.c.push_back(back(c.back()));
      exact.d.push_back(back(d.back()));
    }
    const WarpEnclosure warp = max_warp<double, 3>(u, c, d);
    const WarpEnclosure expected = warp_of(exact);
    expect_narrow(warp);
    EXPECT_LE(warp.lower, expected.upper);
    EXPECT_LE(expected.lower, warp.upper);
  }
}

/// Whatever the size of the warp, its enclosure has relative accuracy.
TEST(Warp, TinyAnglesKeepTheirRelativeAccuracy) {
  for (const int digits : {6, 12, 17, 40, 200, 300}) {
    const WarpEnclosure warp = warp_of(hyperbolic(power(10, -digits), Q(-1), Q(2)));
    expect_narrow(warp);
    expect_contains(warp, std::pow(10.0, -digits) / degree);
  }
  Row3 c;
  for (const int x : {0, 1, 3, 4, 6, 7}) c.push_back(Point3(Q(x), Q(x * x) / Q(5), Q(x * (7 - x)) / Q(3)));
  const KnotList<Q> u(3, {Q(0), Q(0), Q(0), Q(1) / Q(3), Q(2), Q(3), Q(3), Q(3)});
  Net net{u, c, linear_net<Q, Point3>(u, c, Q(9), Q(7), Point3(Q(0), Q(5), Q(1)))};
  EXPECT_EQ(warp_of(net).upper, 0);
  net.d[2][2] += power(10, -5);
  const WarpEnclosure reference = warp_of(net);
  EXPECT_EQ(reference.stage, WarpStage::rounded);
  for (const int digits : {12, 15, 30, 90, 170}) {
    net.d[2][2] -= power(10, -5);
    net.d[2][2] += power(10, -digits);
    const WarpEnclosure warp = warp_of(net);
    expect_narrow(warp);
    const double factor = std::pow(10.0, 5 - digits);
    EXPECT_NEAR(warp.upper / (reference.upper * factor), 1, 3e-3);
    if (digits >= 15) {
      EXPECT_NE(warp.stage, WarpStage::rounded);
    }
    net.d[2][2] -= power(10, -digits);
    net.d[2][2] += power(10, -5);
  }
}

TEST(Warp, ARightAngleInsideIsFound) {
  // (t, 0, 0) and (0, 1, t): the normals (0, -t, 1) and (-1, -t, 0).
  for (const int begin : {0, -1, -2}) {
    const Q a(begin), b(1), zero(0);
    const Net net{bezier_knots<Q>(1, a, b),
                  {Point3(a, zero, zero), Point3(b, zero, zero)},
                  {Point3(zero, Q(1), a), Point3(zero, Q(1), b)}};
    const WarpEnclosure warp = warp_of(net);
    expect_narrow(warp);
    EXPECT_EQ(warp.upper, 90);
    EXPECT_EQ(at_most(net, Q(90)), Truth::yes);
    EXPECT_EQ(at_most(net, Q(89)), Truth::no);
  }
}

TEST(Warp, ComparesWithALimit) {
  const Net inside = hyperbolic(Q(1), Q(-1), Q(2));  // 45 degrees at t = 0
  const Net outside = hyperbolic(Q(1), Q(0), Q(1));
  for (const Net& net : {inside, outside}) {
    EXPECT_EQ(at_most(net, Q(45)), Truth::yes);
    EXPECT_EQ(at_most(net, Q(45) + power(10, -9)), Truth::yes);
    EXPECT_EQ(at_most(net, Q(45) - power(10, -9)), Truth::no);
    EXPECT_EQ(at_most(net, Q(0)), Truth::no);
    EXPECT_EQ(at_most(net, Q(30)), Truth::no);
    EXPECT_EQ(at_most(net, Q(60)), Truth::yes);
    EXPECT_EQ((warp_at_most<Q, 3>(net.u, net.c, net.d, Angle{Q(7854) / Q(10000), true})), Truth::yes);
    EXPECT_EQ((warp_at_most<Q, 3>(net.u, net.c, net.d, Angle{Q(7853) / Q(10000), true})), Truth::no);
    EXPECT_EQ((warp_at_most<Q, 3>(net.u, net.c, net.d, Angle{Q(2), true})), Truth::yes);
  }
  EXPECT_EQ(at_most(hyperbolic(Q(0), Q(0), Q(1)), Q(0)), Truth::yes);
  EXPECT_EQ(at_most(hyperbolic(power(10, -250), Q(0), Q(1)), Q(0)), Truth::no);
  EXPECT_EQ(at_most(hyperbolic(power(10, -250), Q(0), Q(1)), power(10, -248)), Truth::yes);
  EXPECT_EQ(at_most(hyperbolic(power(10, -250), Q(0), Q(1)), power(10, -249)), Truth::no);
}

TEST(Warp, RefusesRowsThatDoNotFit) {
  Net net = hyperbolic(Q(1), Q(0), Q(1));
  net.d.pop_back();
  EXPECT_THROW(static_cast<void>(warp_of(net)), InvalidInput);
  EXPECT_THROW(static_cast<void>(warp_of(hyperbolic(Q(1), Q(0), Q(1)), {.tolerance = 0})), InvalidInput);
}

}  // namespace
}  // namespace torse::test
