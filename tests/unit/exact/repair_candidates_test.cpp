// Exact members of a family: as near as the accuracy promises, with numbers no longer than that asks for; and frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "support/knots.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/repair/edge_solver.hpp"
#include "torse/exact/repair/edge_start.hpp"
#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/frame.hpp"
#include "torse/exact/repair/segments.hpp"
#include "torse/spline/elevation.hpp"

namespace torse::repair {
namespace {

using Q = Rational;
using test::knots;
using Row4 = Vec<Q, 4>;

Q q(int num, int den = 1) { return ratio<Q>(num, den); }

/// A winding row of homogeneous points, with weights from 6/8 to 10/8.
std::vector<Row4> winding(int count, bool weighted, std::mt19937_64& rng) {
  const auto draw = [&] { return q(static_cast<int>(rng() % 401) - 200, 64); };
  std::vector<Row4> points;
  for (int i = 0; i < count; ++i) {
    const Q w = weighted ? q(static_cast<int>(rng() % 5) + 6, 8) : Q(1);
    points.push_back(Row4(w, w * (Q(2 * i) + draw() / Q(4)), w * draw(), w * draw()));
  }
  return points;
}

/// The points of both rows in turns, each coordinate moved by up to a 64th.
template <int D>
RealNet<D> noisy_net(const std::vector<Row4>& p, const std::vector<Row4>& r, std::mt19937_64& rng) {
  RealNet<D> net;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const Row4& x : {p[i], r[i]}) {
      Vec<Real, D> y;
      for (int j = 0; j < D; ++j) {
        const int of_row = j + 4 - D;
        const Q noise = of_row == 0 ? Q(0) : x[0] * q(static_cast<int>(rng() % 2049) - 1024, 1 << 16);
        y[j] = Real::from_rational(x[of_row] + noise);
      }
      net.points.push_back(y);
      net.scale.push_back(Real::from_rational(x[0] * x[0]));
    }
  }
  return net;
}

template <int D>
Real squared_distance(const RealNet<D>& net, const ExactNet<D>& exact) {
  Real sum;
  for (std::size_t i = 0; i < net.size(); ++i) {
    for (int j = 0; j < D; ++j) {
      const Real e = net.points[i][j] - Real::from_rational(exact[i][j]);
      sum += e * e / net.scale[i];
    }
  }
  return sum;
}

std::size_t bits_of(const Q& x) { return x.numerator_bits() + x.denominator_bits(); }

/// Within the shares of Accuracy: 2^-8 for the constants and 2^-10 for the points, a little more as the curvature is
/// approximate.
template <int D>
void expect_near(const RealNet<D>& net, const Candidate<D>& candidate, const char* what) {
  const auto exact = candidate.realise();
  ASSERT_TRUE(exact) << what;
  const double share = (squared_distance<D>(net, *exact) / candidate.squared).to_double();
  EXPECT_LT(share, 1 + 1.0 / 128) << what;
  EXPECT_GT(share, 1 - 1e-9) << what;
}

TEST(RepairCandidates, EdgesAreAsNearAsTheirAccuracy) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 8; ++trial) {
    const KnotList<Q> u = knots(2, {0, 1, 2, 4, 5});
    std::vector<Row4> p = winding(u.last() + 1, trial % 2 == 1, rng);
    for (Row4& x : p) divide(x, Q(trial < 4 ? 1 : 1024));  // small weights, so that roundings of the edge grow
    const auto r = linear_net<Q, Row4>(u, p, q(-7, 2), q(-9, 4), scaled(p[0][0], Row4(Q(1), Q(1), Q(-3), Q(7))));
    const auto c = elevate(Spline<Q, Row4>(u, p));
    const auto d = elevate(Spline<Q, Row4>(u, r));
    const RealNet<4> net = noisy_net<4>(c.control, d.control, rng);
    const auto candidate = edge_candidate<4>(c.knots, net, 1, Real(1000));
    ASSERT_TRUE(candidate);
    expect_near(net, *candidate, "edge");
  }
}

/// What remains of a net after the best edge for constants.
template <int D>
Real remainder_of(const KnotList<Q>& u, const RealNet<D>& net, const EdgeFamily& family,
                  const std::vector<Real>& theta) {
  const auto map = edge_map(u, family);
  const EdgeSolver<D> solver(*map, net.scale, theta);
  const auto rest = solver.remainder(net.points, *solver.edge(net.points));
  return weighted_product<D>(rest, rest, net.scale);
}

/// A net of one piece from a surface with an edge, with noise or without.
struct Piece {
  KnotList<Q> u;
  RealNet<3> net;

  Real remainder() const {
    const EdgeFamily family{1, u.domain_begin(), u.domain_end(), false};
    const auto start = traced_constants<3>(u, net, family);
    EXPECT_TRUE(start);
    return remainder_of<3>(u, net, family, *start);
  }
};

Piece piece_with_edge(int noise, std::mt19937_64& rng) {
  const KnotList<Q> u = knots(2, {0, 1, 2, 4});
  const std::vector<Row4> p = winding(u.last() + 1, false, rng);
  const auto r = linear_net<Q, Row4>(u, p, q(-7, 2), q(-9, 4), Row4(Q(1), Q(1), Q(-3), Q(7)));
  const auto c = elevate(Spline<Q, Row4>(u, p));
  const auto d = elevate(Spline<Q, Row4>(u, r));
  Piece piece{c.knots, {}};
  for (std::size_t i = 0; i < c.control.size(); ++i) {
    for (const Row4& x : {c.control[i], d.control[i]}) {
      Vec<Real, 3> y;
      for (int j = 0; j < 3; ++j) {
        y[j] = Real::from_rational(x[j + 1] + q(noise * (static_cast<int>(rng() % 2049) - 1024), 1 << 26));
      }
      piece.net.points.push_back(y);
      piece.net.scale.emplace_back(1);
    }
  }
  return piece;
}

/// Where there is an edge, the search starts at it.
TEST(RepairStart, FindsAnEdgeThatIsThere) {
  std::mt19937_64 rng(4);
  for (int trial = 0; trial < 3; ++trial) {
    EXPECT_LE(piece_with_edge(0, rng).remainder(), Real::from_rational(power_of_two(-300)));
    EXPECT_GE(piece_with_edge(1, rng).remainder(), Real::from_rational(power_of_two(-60)));
  }
}

/// A start for the coordinates in another order, for the curves in the other direction, and for the rows exchanged, is
/// as near.
TEST(RepairStart, IsTheSameForMirroredNets) {
  std::mt19937_64 rng(5);
  const Piece piece = piece_with_edge(1, rng);
  const double expected = piece.remainder().to_double();
  Piece turned = piece;
  for (Vec<Real, 3>& x : turned.net.points) x = Vec<Real, 3>(x[1], x[2], x[0]);
  EXPECT_NEAR(turned.remainder().to_double() / expected, 1, 1e-12);
  Piece exchanged = piece;
  for (std::size_t i = 0; i < exchanged.net.size(); i += 2)
    std::swap(exchanged.net.points[i], exchanged.net.points[i + 1]);
  EXPECT_NEAR(exchanged.remainder().to_double() / expected, 1, 1e-12);
  std::vector<Q> list;
  for (auto at = piece.u.list().rbegin(); at != piece.u.list().rend(); ++at) list.push_back(-*at);
  Piece reversed{KnotList<Q>(piece.u.degree(), list), exchanged.net};
  std::ranges::reverse(reversed.net.points);
  EXPECT_NEAR(reversed.remainder().to_double() / expected, 1, 1e-12);
}

/// The lines c = t (0, 1, 1) and d = c + 3 (t - t_0) (1, 0, 0) meet at t_0, one of the parameters where the edge is
/// traced: there it may come to no point at all (for t_0 = 1/8 it does), and the others are to tell.
TEST(RepairStart, RailsMayMeet) {
  constexpr int samples = 12;
  for (int i = 0; i < samples; ++i) {
    const Q meet = q(2 * i + 1, 2 * samples);
    RealNet<3> net;
    for (const Q& t : {q(0), q(1)}) {
      const Real x = Real::from_rational(t), along = Real::from_rational(q(3) * (t - meet));
      net.points.insert(net.points.end(), {Vec<Real, 3>(Real(0), x, x), Vec<Real, 3>(along, x, x)});
      net.scale.insert(net.scale.end(), {Real(1), Real(1)});
    }
    EXPECT_TRUE(traced_constants<3>(bezier_knots<Q>(1), net, {0, q(0), q(1), false})) << i;
  }
}

/// Over a short and a long domain and for large and small sigma. The constants take no more digits than that needs.
TEST(RepairCandidates, ConstantsAreNearAndSimple) {
  std::mt19937_64 rng(2);
  for (const Q& unit : {q(1, 64), q(1), q(64)}) {
    std::vector<Q> list;
    for (const int knot : {0, 0, 0, 1, 2, 4, 4, 4}) list.push_back(unit * q(knot));
    const KnotList<Q> u(3, list);
    for (const Q& sigma : {q(1), q(16), q(1, 16)}) {
      const bool weighted = sigma != q(1);
      const std::vector<Row4> p = winding(u.last() + 1, weighted, rng);
      const Row4 start = scaled(Q(1) / sigma, Row4(Q(1), Q(1), Q(-3), Q(7)));
      const auto r = rational_net<Q, Row4>(u, p, q(-7, 2) * unit, q(-9, 4) * unit, sigma, start);
      const auto expect_good = [&](const auto& net, const auto& candidate) {
        ASSERT_TRUE(candidate);
        expect_near(net, *candidate, sigma.text().c_str());
        const RelationConstants& found = candidate->constants.at(0);
        for (const Q& x : {found.lambda, found.m, found.sigma}) EXPECT_LE(bits_of(x), 24U) << sigma.text();
      };
      if (weighted) {
        const RealNet<4> net = noisy_net<4>(p, r, rng);
        expect_good(net, constant_candidate<4>(u, net, Real(1000)));
      } else {
        const RealNet<3> net = noisy_net<3>(p, r, rng);
        expect_good(net, constant_candidate<3>(u, net, Real(1000)));
      }
    }
  }
}

/// Two parts with constants of their own, each between the knots where it begins and ends.
TEST(RepairCandidates, PartsHaveTheirConstants) {
  std::mt19937_64 rng(3);
  const KnotList<Q> u = knots(2, {-3, -3, 1, 1, 2, 2});
  const std::vector<Row4> p = winding(u.last() + 1, false, rng);
  const std::vector<Row4> r = winding(u.last() + 1, false, rng);
  const RealNet<3> net = noisy_net<3>(p, r, rng);
  const auto candidate = segments_candidate<3>(u, net, Real(1000));
  ASSERT_TRUE(candidate);
  ASSERT_EQ(candidate->constants.size(), 2U);
  EXPECT_EQ(candidate->constants[0].from, q(-3));
  EXPECT_EQ(candidate->constants[0].to, q(1));
  EXPECT_EQ(candidate->constants[1].from, q(1));
  EXPECT_EQ(candidate->constants[1].to, q(2));
  EXPECT_FALSE(segments_candidate<3>(knots(2, {-3, -3, 2, 2}), part_of(net, {0, 2, u}), Real(1000))) << "one part";
}

/// One equation over the knots -1 and 1, w (c_0 + c_1) + a (c_1 - c_0) = w' (d_0 + d_1) + a' (d_1 - d_0), which holds
/// for the constants named below alone: every other constant has a vector across those of these.
template <int D>
bool has_constants(const std::vector<std::vector<int>>& points) {
  RealNet<D> net;
  for (const std::vector<int>& point : points) {
    Vec<Real, D> x;
    for (int j = 0; j < D; ++j) x[j] = Real(point[static_cast<std::size_t>(j)]);
    net.points.push_back(x);
    net.scale.push_back(Real(1));
  }
  return constant_candidate<D>(knots(1, {-1, 1}), net, Real(1)).has_value();
}

TEST(RepairCandidates, AConstantAtInfinityIsNone) {
  EXPECT_FALSE(has_constants<3>({{-1, 0, 0}, {-2, 0, 1}, {1, 0, 0}, {2, 0, 1}})) << "2 a = 4 a'";
  EXPECT_FALSE(has_constants<4>({{1, -3, 0, 0}, {1, 1, 0, 1}, {3, -1, 0, 0}, {1, 1, 0, -1}})) << "a = w'";
  EXPECT_FALSE(has_constants<4>({{1, 1, 0, 1}, {1, -3, 0, 0}, {1, 1, 0, -1}, {3, -1, 0, 0}})) << "w = a'";
  EXPECT_TRUE(has_constants<4>({{1, 1, 0, 1}, {1, 2, 0, 0}, {1, 1, 0, -1}, {1, 0, 0, 0}})) << "w = w'";
}

/// The centre is near the middle of the box and short, however far away that is.
TEST(RepairFrame, CentreIsInTheMiddle) {
  std::mt19937_64 rng(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Q far = power_of_two(static_cast<long>(rng() % 200) - 100);
    const Q size = power_of_two(static_cast<long>(rng() % 100) - 50) * q(static_cast<int>(rng() % 1000) + 1000, 1999);
    RuledRows rows;
    for (auto* row : {&rows.c, &rows.d}) {
      for (int i = 0; i < 4; ++i) {
        Vec<Q, 3> x;
        for (int j = 0; j < 3; ++j) x[j] = far + size * q(static_cast<int>(rng() % 1001), 1000 * (j + 1));
        row->points.push_back(x);
        row->weights.push_back(Q(1));
      }
    }
    const Frame frame = frame_of(rows);
    Q extent(0);
    Vec<Q, 3> middle;
    for (int j = 0; j < 3; ++j) {
      Q low = rows.c.points[0][j], high = low;
      for (const auto* row : {&rows.c, &rows.d}) {
        for (const Vec<Q, 3>& x : row->points) {
          low = std::min<Q>(low, x[j]);
          high = std::max<Q>(high, x[j]);
        }
      }
      extent = std::max<Q>(extent, high - low);
      middle[j] = (low + high) / Q(2);
    }
    for (int j = 0; j < 3; ++j) {
      const Q shift = frame.centre[j] - middle[j];
      EXPECT_LT(shift * shift, extent * extent / Q(64)) << trial;
      EXPECT_EQ(rounded(frame.centre[j], frame.exponent - 3), frame.centre[j]) << trial;
    }
    EXPECT_LE(power_of_two(frame.exponent - 1), extent);
    EXPECT_LT(extent, power_of_two(frame.exponent));
  }
}

}  // namespace
}  // namespace torse::repair
