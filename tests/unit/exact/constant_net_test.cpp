// Exact nets from edges of regression: no further from the real net than the accuracy promises, at points of any scale
// and across joints that enlarge errors, and not much nearer, which would cost digits.
#include "torse/exact/repair/constant_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include "support/knots.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

using Q = Rational;
using test::knots;
using Row = Vec<Q, 4>;

Q q(int num, int den = 1) { return ratio<Q>(num, den); }

/// The affine blossom value between x and y with weight t of y.
Row between(const Row& x, const Row& y, const Q& t) {
  Row result;
  for (int j = 0; j < 4; ++j) result[j] = (Q(1) - t) * x[j] + t * y[j];
  return result;
}

/// Where x lies between the knots that bound the support of edge points i and i + 1, from 0 to 1.
Q share_of(const KnotList<Q>& u, int i, const Q& x) {
  const Q low = u[std::max(i - 1, 0)];
  const Q high = u[std::min(i + u.degree(), u.size() - 1)];
  return (x - low) / (high - low);
}

struct Design {
  std::vector<Segment> segments;
  std::vector<RelationConstants> constants;
  std::vector<Q> scale;  ///< of the points, repeated
};

/// A net that has edges, exactly: its first edge points at random, those of a later segment's beginning from the
/// control points that it shares.
ExactNet<4> net_with_edges(const Design& design, std::mt19937_64& rng) {
  const auto draw = [&] {
    Row x;
    for (int j = 0; j < 4; ++j) x[j] = q(static_cast<int>(rng() % 20001) - 10000, 3331);
    return x;
  };
  ExactNet<4> net;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    const KnotList<Q>& u = design.segments[s].knots;
    const RelationConstants& k = design.constants[s];
    Row r = draw();
    Row next = draw();
    if (s > 0) {
      const Row d = net.back();
      Row c = net[net.size() - 2];
      for (int j = 0; j < 4; ++j) c[j] = c[j] / k.sigma;
      const Q of_c = share_of(u, 0, k.m);
      const Q of_d = share_of(u, 0, k.lambda);
      next = between(c, d, (Q(1) - of_c) / (of_d - of_c));
    }
    for (int i = 0; i <= u.last(); ++i) {
      if (s == 0 || i > 0) {
        Row c = between(r, next, share_of(u, i, k.m));
        for (int j = 0; j < 4; ++j) c[j] = k.sigma * c[j];
        net.push_back(c);
        net.push_back(between(r, next, share_of(u, i, k.lambda)));
      }
      r = next;
      next = draw();
    }
  }
  return net;
}

/// FJ21.7.1 between each two neighbours of a segment: c at L* is sigma times d at M*.
void expect_relation(const Design& design, const ExactNet<4>& net) {
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    const auto& [begin, end, u] = design.segments[s];
    const RelationConstants& k = design.constants[s];
    for (int i = 0; i < end - begin; ++i) {
      const Q length = u[i + u.degree()] - u[i];
      const auto at = static_cast<std::size_t>(2 * (begin + i));
      const Row of_c = between(net[at], net[at + 2], (k.lambda - u[i]) / length);
      const Row of_d = between(net[at + 1], net[at + 3], (k.m - u[i]) / length);
      for (int j = 0; j < 4; ++j) EXPECT_EQ(of_c[j], k.sigma * of_d[j]) << "segment " << s << ", point " << i;
    }
  }
}

/// The largest error of each point in parts of what Accuracy promises, 2^-5 sqrt(f / count) times the root of its
/// scale, over a few nets.
std::vector<double> errors_of(const Design& design) {
  std::mt19937_64 rng(5);
  std::vector<double> most;
  for (int trial = 0; trial < 12; ++trial) {
    const ExactNet<4> net = net_with_edges(design, rng);
    RealNet<4> real;
    for (std::size_t k = 0; k < net.size(); ++k) {
      real.points.push_back(real_point<4>(net[k]));
      real.scale.push_back(Real::from_rational(design.scale[k % design.scale.size()]));
    }
    const Real squared = Real(static_cast<int>(net.size())) / Real(1 << 10);  // sqrt(f / count) = 2^-5
    const auto exact = realise_constant_net<4>(design.segments, real, design.constants, Accuracy(squared, net.size()));
    EXPECT_TRUE(exact);
    if (!exact || exact->size() != net.size()) return {};
    expect_relation(design, *exact);
    most.resize(net.size(), 0);
    for (std::size_t k = 0; k < net.size(); ++k) {
      Real sum;
      for (int j = 0; j < 4; ++j) {
        const Real error = Real::from_rational((*exact)[k][j] - net[k][j]);
        sum += error * error;
      }
      most[k] = std::max(most[k], ((sum / real.scale[k]).square_root() * Real(1 << 10)).to_double());
    }
  }
  return most;
}

double largest(const std::vector<double>& errors, std::size_t from, std::size_t to) {
  return *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(from),
                           errors.begin() + static_cast<std::ptrdiff_t>(to));
}

RelationConstants constants_of(const Q& lambda, const Q& m, const Q& sigma) { return {{}, {}, lambda, m, sigma}; }

TEST(ConstantNet, ErrorsAreWhatThePointsOfTheSmallestScaleAllow) {
  const KnotList<Q> u = knots(3, {0, 0, 1, 2, 4, 7, 9, 9});
  for (const Q& unit : {q(1), q(1, 1 << 20), q(1 << 20)}) {
    // Each point in turn is the one that allows least: by its scale, then by its row, c's being 100 times as large.
    const Design by_scale{{{0, u.last(), u}}, {constants_of(q(20), q(-5), q(1))}, {unit * q(1 << 16), unit}};
    const std::vector<double> errors = errors_of(by_scale);
    ASSERT_EQ(errors.size(), 12U);
    EXPECT_LT(largest(errors, 0, errors.size()), 1);
    EXPECT_GT(largest(errors, 0, errors.size()), 1.0 / 8);
    const Design by_row{{{0, u.last(), u}}, {constants_of(q(20), q(-5), q(100))}, {unit}};
    const std::vector<double> of_rows = errors_of(by_row);
    EXPECT_LT(largest(of_rows, 0, of_rows.size()), 1);
    EXPECT_GT(largest(of_rows, 0, of_rows.size()), 1.0 / 8);
  }
  // d is one of the edge points itself, the first or the second, and allows much less than c.
  for (const int end : {0, 1}) {
    const KnotList<Q> piece = knots(2, {0, 0, 1, 1});
    const std::vector<double> errors =
        errors_of({{{0, 2, piece}}, {constants_of(q(end), q(1, 4), q(1))}, {q(1 << 24), q(1)}});
    ASSERT_EQ(errors.size(), 6U);
    EXPECT_LT(largest(errors, 0, errors.size()), 1);
    EXPECT_GT(largest(errors, 0, errors.size()), 1.0 / 8);
  }
}

/// Three segments, of which the later two have one relation.
Design joined(const RelationConstants& first, const RelationConstants& later, const std::vector<Q>& scale) {
  return {segments_of(knots(2, {0, 0, 1, 3, 3, 4, 6, 6, 8, 8})), {first, later, later}, scale};
}

/// L* and M* so near each other that the beginning of a segment enlarges errors.
RelationConstants enlarging() { return constants_of(q(40), q(40) + q(1, 1000), q(1)); }

TEST(ConstantNet, ErrorsStayPromisedAcrossJoints) {
  // The errors of a segment matter most in the next, where the second pair of points has them enlarged.
  const std::vector<double> errors = errors_of(joined(constants_of(q(20), q(-5), q(1)), enlarging(), {q(1)}));
  ASSERT_EQ(errors.size(), 18U);
  EXPECT_LT(largest(errors, 0, errors.size()), 1);
  EXPECT_LT(largest(errors, 0, 8), 1.0 / 1024);
  EXPECT_GT(largest(errors, 8, 10), 1.0 / 64);
  EXPECT_GT(largest(errors, 14, 16), 1.0 / 64);
  EXPECT_GT(largest(errors, 16, 18), 1.0 / 64);
}

TEST(ConstantNet, ErrorsOfEitherJointPointAreAllowedFor) {
  // sigma makes the errors of c in the first segment as large as its scale allows, and those of d. Where M* or L* ends
  // the support of the second edge point, this is c or d itself.
  const Q large = q(1 << 24);
  for (const auto& later : {enlarging(), constants_of(q(5), q(4), q(1))}) {
    const std::vector<double> errors = errors_of(joined(constants_of(q(20), q(-5), q(1 << 12)), later, {large, q(1)}));
    ASSERT_EQ(errors.size(), 18U);
    EXPECT_LT(largest(errors, 0, errors.size()), 1);
    EXPECT_GT(largest(errors, 9, 10), 1.0 / 512);
  }
  for (const auto& later : {enlarging(), constants_of(q(4), q(5), q(1))}) {
    const std::vector<double> errors =
        errors_of(joined(constants_of(q(20), q(-5), q(1, 1 << 12)), later, {q(1), large}));
    ASSERT_EQ(errors.size(), 18U);
    EXPECT_LT(largest(errors, 0, errors.size()), 1);
    EXPECT_GT(largest(errors, 8, 9), 1.0 / 512);
  }
}

TEST(ConstantNet, ErrorsOfDegreeOneTravelOn) {
  // Enlarged 10^3 times by the second segment, and 10^3 times more by the third.
  const Design design{segments_of(knots(1, {0, 3, 5, 6})),
                      {constants_of(q(20), q(-5), q(1)), enlarging(), constants_of(q(-4000), q(4000), q(1))},
                      {q(1)}};
  const std::vector<double> errors = errors_of(design);
  ASSERT_EQ(errors.size(), 8U);
  EXPECT_LT(largest(errors, 0, errors.size()), 1);
  EXPECT_LT(largest(errors, 0, 4), 1e-5);
  EXPECT_GT(largest(errors, 6, 8), 1.0 / 512);
}

}  // namespace
}  // namespace torse::repair
