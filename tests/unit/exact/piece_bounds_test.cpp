// The cheap bounds of the warp angle, and the Bezier points they start from, against the exact values of the same
// doubles.
#include "torse/exact/warp/piece_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/warp.hpp"
#include "torse/exact/warp/sliding_row.hpp"
#include "torse/spline/insertion.hpp"

namespace torse {
namespace {

using Q = Rational;
using Points = std::vector<Vec<double, 3>>;

struct Net {
  KnotList<double> u;
  Points c;
  Points d;
};

std::vector<Vec<Q, 3>> exact(const Points& points) {
  std::vector<Vec<Q, 3>> result;
  for (const auto& x : points) {
    result.emplace_back(Q::from_double(x[0]), Q::from_double(x[1]), Q::from_double(x[2]));
  }
  return result;
}
KnotList<Q> exact(const KnotList<double>& u) {
  std::vector<Q> knots;
  for (const double x : u.list()) knots.push_back(Q::from_double(x));
  return {u.degree(), std::move(knots)};
}
Points rounded(const std::vector<Vec<Q, 3>>& points) {
  Points result;
  for (const auto& x : points) result.emplace_back(x[0].to_double(), x[1].to_double(), x[2].to_double());
  return result;
}

/// A knot list with knots of all multiplicities up to n, clamped or not.
KnotList<double> random_knots(int n, int pieces, std::mt19937_64& rng) {
  std::vector<double> u;
  double x = -1.5;
  const auto repeat = [&](int times) { u.insert(u.end(), static_cast<std::size_t>(times), x); };
  const bool clamped = rng() % 2 == 0;
  for (int i = 0; i < (clamped ? 1 : n); ++i) {
    repeat(clamped ? n : 1);
    x += 0.25 + static_cast<double>(rng() % 1000) / 700;
  }
  for (int i = 1; i < pieces; ++i) {
    repeat(1 + static_cast<int>(rng() % static_cast<unsigned>(n)));
    x += 0.25 + static_cast<double>(rng() % 1000) / 700;
  }
  for (int i = 0; i < (clamped ? 1 : n); ++i) {
    repeat(clamped ? n : 1);
    x += 0.25 + static_cast<double>(rng() % 1000) / 700;
  }
  return {n, std::move(u)};
}

/// Points near two skew lines; `scale` of their coordinates.
Net random_net(int n, int pieces, double spread, double scale, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  Net net{random_knots(n, pieces, rng), {}, {}};
  const auto noise = [&] { return spread * (static_cast<double>(rng() % 2000001) / 1000000 - 1); };
  for (int i = 0; i <= net.u.last(); ++i) {
    const double cx = i + noise(), cy = noise(), cz = noise();
    const double dx = i + noise(), dy = 2 + noise(), dz = noise();
    net.c.emplace_back(scale * cx, scale * cy, scale * cz);
    net.d.emplace_back(scale * dx, scale * dy, scale * dz);
  }
  return net;
}

/// Doubles next to the developable net FJ07.13.
Net nearly_developable(std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto number = [&](int spread) { return Q(static_cast<int>(rng() % 2001) - 1000) / Q(1000) * Q(spread) / Q(7); };
  const KnotList<Q> u(3, {Q(0), Q(0), Q(0), Q(1), Q(2), Q(3), Q(3), Q(3)});
  std::vector<Vec<Q, 3>> c;
  for (int i = 0; i <= u.last(); ++i) c.emplace_back(Q(i), number(3), number(3));
  const auto d = linear_net<Q, Vec<Q, 3>>(u, c, Q(40) + number(9), Q(30) + number(9), Vec<Q, 3>(Q(0), Q(6), number(2)));
  return {KnotList<double>(3, {0, 0, 0, 1, 2, 3, 3, 3}), rounded(c), rounded(d)};
}

std::vector<PieceBound> bounds_of(const Net& net) {
  const auto rounded = rounded_net<3>(net.u, std::span<const Vec<double, 3>>(net.c), net.d);
  return piece_bounds(*rounded, net.u.proper_pieces());
}

/// The bounds against exact values at `count` + 1 parameters of each piece. Returns the largest ratio of an upper bound
/// to the largest value seen.
double expect_certified(const Net& net, int count) {
  const std::vector<PieceBound> bounds = bounds_of(net);
  const KnotList<Q> u = exact(net.u);
  const auto c = exact(net.c), d = exact(net.d);
  const std::vector<int> pieces = net.u.proper_pieces();
  double worst = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int k = pieces[i];
    Q most(0);
    for (int j = 0; j <= count; ++j) {
      const Q t = u.piece_begin(k) + Q(j) / Q(count) * (u.piece_end(k) - u.piece_begin(k));
      const Q sine2 = pointwise_sine_squared<Q>(u, c, d, k, t);
      most = std::max(most, sine2);
      if (j == 0) {
        EXPECT_LE(Q::from_double(bounds[i].at_begin), sine2);
      }
      if (j == count) {
        EXPECT_LE(Q::from_double(bounds[i].at_end), sine2);
      }
    }
    if (bounds[i].upper < 1) {
      EXPECT_GE(Q::from_double(bounds[i].upper), most) << "piece " << k;
    }
    worst = std::max(worst, bounds[i].upper / most.to_double());
  }
  return worst;
}

TEST(PieceBounds, EncloseTheExactAngleOfRandomNets) {
  for (int n = 1; n <= 8; ++n) {
    for (const double spread : {0.01, 0.1, 0.4}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(testing::Message() << n << ", " << spread << ", " << seed);
        expect_certified(random_net(n, 6, spread, 1, seed), 5);
      }
    }
  }
}

TEST(PieceBounds, AreNarrowWhereTheNormalsTurnLittle) {
  for (int n = 1; n <= 4; ++n) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(testing::Message() << n << ", " << seed);
      const Net net = random_net(n, 6, 0.05, 1, seed);
      EXPECT_LE(expect_certified(net, 32), 1.4);
      for (const PieceBound& bound : bounds_of(net)) EXPECT_GE(bound.at_begin + bound.at_end, 1e-9);
    }
  }
}

/// Boundary curves that diverge, so that c' x d' is as large as the normals, and ones that run against each other.
Net diverging_net(int n, int pieces, double spread, bool opposite, std::uint64_t seed) {
  Net net = random_net(n, pieces, spread, 1, seed);
  const int last = net.u.last();
  for (int i = 0; i <= last; ++i) {
    auto& d = net.d[static_cast<std::size_t>(i)];
    if (opposite) {
      d[0] = last - d[0];
      d[1] += last;
    } else {
      d[1] += i;
    }
  }
  return net;
}

TEST(PieceBounds, HoldForBoundaryCurvesOfAnyDirection) {
  for (const bool opposite : {false, true}) {
    for (int n = 1; n <= 3; ++n) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(testing::Message() << opposite << ", " << n << ", " << seed);
        EXPECT_LE(expect_certified(diverging_net(n, 5, 0.03, opposite, seed), 24), 2);
      }
    }
  }
}

/// The determinant is all rounding errors here, those of the data and those of the bound.
TEST(PieceBounds, CountRoundingErrors) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Net net = nearly_developable(seed);
    expect_certified(net, 4);
    for (const PieceBound& bound : bounds_of(net)) EXPECT_LE(bound.upper, 1e-18);
  }
}

/// A net declared with errors stands for every exact surface within them; one of those against the bounds.
void expect_errors_counted(const Net& net, const Net& within, double knot_error, double coordinate_error) {
  const RoundedNet<3> declared{3, net.u.list(), net.c, net.d, knot_error, coordinate_error};
  const std::vector<int> pieces = net.u.proper_pieces();
  const std::vector<PieceBound> bounds = piece_bounds(declared, pieces);
  const auto u = exact(within.u);
  const auto c = exact(within.c), d = exact(within.d);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (int j = 0; j <= 4; ++j) {
      const int k = pieces[i];
      const Q t = u.piece_begin(k) + Q(j) / Q(4) * (u.piece_end(k) - u.piece_begin(k));
      EXPECT_LE(pointwise_sine_squared<Q>(u, c, d, k, t), Q::from_double(bounds[i].upper));
    }
  }
}

TEST(PieceBounds, CountErrorsOfTheData) {
  constexpr double error = 1e-9;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Net net = nearly_developable(seed);
    std::mt19937_64 rng(seed);
    const auto moved = [&](double x, double most) { return rng() % 2 == 0 ? x + most : x - most; };
    Net coordinates = net;
    for (Points* row : {&coordinates.c, &coordinates.d}) {
      for (auto& x : *row) {
        for (int j = 0; j < 3; ++j) x[j] = moved(x[j], 0.99 * error);
      }
    }
    expect_errors_counted(net, coordinates, 0, error);
    std::vector<double> knots = net.u.list();
    for (std::size_t i = 3; i < 5; ++i) knots[i] = moved(knots[i], error / 3);
    expect_errors_counted(net, {KnotList<double>(3, knots), net.c, net.d}, error, 0);
  }
}

TEST(PieceBounds, DoNotDependOnTheSizeOfTheSurface) {
  const std::vector<PieceBound> bounds = bounds_of(random_net(3, 6, 0.2, 1, 1));
  for (const double scale : {0x1p100, 0x1p-100}) {
    const std::vector<PieceBound> again = bounds_of(random_net(3, 6, 0.2, scale, 1));
    for (std::size_t i = 0; i < bounds.size(); ++i) EXPECT_DOUBLE_EQ(again[i].upper, bounds[i].upper);
  }
  for (const double scale : {0x1p200, 0x1p-200, 1e300}) {
    for (const PieceBound& bound : bounds_of(random_net(3, 6, 0.2, scale, 1))) {
      EXPECT_EQ(bound.upper, detail::infinity);
      EXPECT_EQ(bound.at_begin, 0);
      EXPECT_EQ(bound.at_end, 0);
    }
  }
}

TEST(PieceBounds, SayNothingWhereANormalVanishes) {
  const KnotList<double> u(2, {0, 0, 1, 1});
  const Points c{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}};
  const Points through{{0, -0.5, 0}, {0.5, 0, -0.25}, {1, 0.5, 0.5}};  // d - c = (t - 1/2) (0, 1, t)
  EXPECT_EQ(bounds_of({u, c, through}).front().upper, detail::infinity);
  EXPECT_EQ(bounds_of({u, c, c}).front().upper, detail::infinity);
  EXPECT_EQ(bounds_of({u, Points(3, c[1]), c}).front().upper, detail::infinity);
}

TEST(SlidingRow, HoldsTheBezierPointsOfEachPiece) {
  for (int n = 1; n <= 8; ++n) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << n << ", " << seed);
      const Net net = random_net(n, 7, 1, 1, seed);
      std::vector<Eigen::Array<double, 3, 1>> points;
      double norm = 0;
      for (const auto& x : net.c) {
        points.push_back(x.array());
        norm = std::max(norm, points.back().abs().maxCoeff());
      }
      const std::vector<int> pieces = net.u.proper_pieces();
      SlidingRow<3> row(n, net.u.list(), points, static_cast<std::size_t>(pieces.front() - 1));
      const double bound = n * (n + 1) / 2 * 8 * 0x1p-53 * norm;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i > 0) row.advance();
        const auto expected = bezier_points<Q, Vec<Q, 3>>(exact(net.u), exact(net.c), pieces[i]);
        for (int j = 0; j <= n; ++j) {
          for (int x = 0; x < 3; ++x) {
            const Q error = Q::from_double(row[j][x]) - expected[static_cast<std::size_t>(j)][x];
            EXPECT_LE(std::abs(error.to_double()), bound) << "piece " << pieces[i] << ", point " << j;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace torse
