// The double stage of the warp angle: what it says of its errors, against the exact numbers, and against exact surfaces
// that are within these errors.
#include "torse/exact/warp/rounded_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/warp.hpp"

namespace torse {
namespace {

using Q = Rational;
using Row3 = std::vector<Vec<Q, 3>>;
using Row4 = std::vector<Vec<Q, 4>>;

Q exact(double x) { return Q::from_double(x); }
Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

/// A number that is no double, or one that is.
Q number(std::mt19937_64& rng, bool dyadic) { return Q(static_cast<int>(rng() % 2001) - 1000) / Q(dyadic ? 64 : 63); }

KnotList<Q> random_knots(std::mt19937_64& rng) {
  std::vector<Q> u{Q(0)};
  for (int i = 0; i < 8; ++i) u.push_back(u.back() + Q(static_cast<int>(rng() % 100) + 1) / Q(77));
  return {3, std::move(u)};
}

void expect_knots_within(const KnotList<Q>& u, const std::vector<double>& knots, double relative) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Q width = u.list()[i] - u.list()[j];
      EXPECT_LE(magnitude(exact(knots[i]) - exact(knots[j]) - width), exact(relative) * width);
    }
  }
}

TEST(RoundedNet, NumbersAreWithinTheirErrors) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 20; ++round) {
    const KnotList<Q> u = random_knots(rng);
    Row3 c, d;
    for (int i = 0; i <= u.last(); ++i) {
      for (Row3* row : {&c, &d}) {
        Vec<Q, 3> x;
        for (int j = 0; j < 3; ++j) x[j] = number(rng, false);
        row->push_back(x);
      }
    }
    const auto net = rounded_net<3>(u, std::span<const Vec<Q, 3>>(c), d);
    ASSERT_TRUE(net.has_value());
    expect_knots_within(u, net->knots, net->knot_error);
    EXPECT_LE(net->coordinate_error, 0x1p-47);
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (int j = 0; j < 3; ++j) {
        EXPECT_LE(magnitude(exact(net->c[i][j]) - (c[i][j] - c[0][j])), exact(net->coordinate_error));
        EXPECT_LE(magnitude(exact(net->d[i][j]) - (d[i][j] - c[0][j])), exact(net->coordinate_error));
      }
    }
  }
}

/// Homogeneous rows beginning at the origin; the coordinates are scaled by a power of two to the size of the weights.
/// Weights or coordinates alone are no doubles.
TEST(RoundedNet, WeightsAndCoordinatesAreWithinTheirErrors) {
  std::mt19937_64 rng(2);
  for (const auto& [dyadic_weights, dyadic_points, heavy] :
       {std::tuple{false, true, 1}, {true, false, 1}, {false, false, 1}, {false, false, 1 << 14}}) {
    const KnotList<Q> u = bezier_knots<Q>(3);
    Row4 p, q;
    for (int i = 0; i <= 3; ++i) {
      for (Row4* row : {&p, &q}) {
        Vec<Q, 4> x(Q(heavy) * (magnitude(number(rng, dyadic_weights)) + Q(1)), Q(0), Q(0), Q(0));
        for (int j = 1; j < 4 && !(row == &p && i == 0); ++j) x[j] = Q(1000) * number(rng, dyadic_points) + Q(1);
        row->push_back(x);
      }
    }
    const auto net = rounded_net<4>(u, std::span<const Vec<Q, 4>>(p), q);
    ASSERT_TRUE(net.has_value());
    const Q scale = exact(std::exp2(std::round(std::log2((exact(net->c[1][1]) / p[1][1]).to_double()))));
    EXPECT_GT(net->coordinate_error, 0);
    EXPECT_LE(net->coordinate_error, 0x1p-44 * heavy);
    double weight = 0, coordinate = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (const Vec<double, 4>& x : {net->c[i], net->d[i]}) {
        weight = std::max(weight, x[0]);
        coordinate = std::max(coordinate, x.tail<3>().lpNorm<Eigen::Infinity>());
      }
      for (int j = 0; j < 4; ++j) {
        const Q factor = j == 0 ? Q(1) : scale;
        EXPECT_LE(magnitude(exact(net->c[i][j]) - factor * p[i][j]), exact(net->coordinate_error));
        EXPECT_LE(magnitude(exact(net->d[i][j]) - factor * q[i][j]), exact(net->coordinate_error));
      }
    }
    EXPECT_GE(coordinate, weight);
    EXPECT_LT(coordinate, 2 * weight);
  }
}

/// A net of one piece over these knots, of which there are six.
bool has_net(std::vector<Q> knots) {
  Row3 c, d;
  for (int i = 0; i < 4; ++i) {
    c.emplace_back(Q(i), Q(0), Q(0));
    d.emplace_back(Q(i), Q(1), Q(0));
  }
  return rounded_net<3>(KnotList<Q>(3, std::move(knots)), std::span<const Vec<Q, 3>>(c), d).has_value();
}

/// At either end of the list two knots that differ by 2^-60 round to one double; equal ones are one, and those that
/// differ by 2^-40 are two.
TEST(RoundedNet, KnotsThatCoincideWhenRoundedHaveNone) {
  for (const auto& [gap, told_apart] : {std::pair{0x1p-60, false}, {0x1p-40, true}, {0.0, true}}) {
    EXPECT_EQ(has_net({Q(-1) - exact(gap), Q(-1), Q(0), Q(1), Q(2), Q(3)}), told_apart) << gap;
    EXPECT_EQ(has_net({Q(-2), Q(-1), Q(0), Q(1), Q(2), Q(2) + exact(gap)}), told_apart) << gap;
  }
}

/// 4/3 is no double: an error of 2^-53 is more than a 2^-31st of the gap to the next knot, or less.
TEST(RoundedNet, KnotsNearerThanTheirErrorsHaveNone) {
  const Q knot = Q(4) / Q(3);
  EXPECT_FALSE(has_net({Q(-2), Q(-1), Q(0), Q(1), knot, knot + exact(0x1p-24)}));
  EXPECT_TRUE(has_net({Q(-2), Q(-1), Q(0), Q(1), knot, knot + exact(0x1p-20)}));
}

TEST(RoundedNet, RangesBeyondThatOfProductsHaveNone) {
  for (const auto& [size, held] : {std::pair{0x1p119, true}, {0x1p121, false}, {0x1p-119, true}, {0x1p-121, false}}) {
    std::vector<Q> knots;
    for (int i = 0; i < 6; ++i) knots.push_back(Q(i / 3) * exact(size));
    EXPECT_EQ(has_net(knots), held) << size;
  }
}

/// sin^2 at the ends of the only piece, enclosed, and a bound over all of it.
struct Enclosure {
  double at_begin;
  double at_end;
  double upper;
};

template <int D>
Enclosure enclosure_of(const RoundedNet<D>& net) {
  const auto quotient = rounded_quotient(net, 1);
  return {quotient->lower_at_begin(), quotient->lower_at_end(), quotient->upper().value};
}

/// (t, 0, 0) and (t, 1, t) as nets of degree n, with equal weights for D = 4: sin^2 = 1 / (2 + t^2). The degree of the
/// quotient is 8n - 4 or 16n - 8, of which there may be 130.
template <int D>
std::optional<RoundedNet<D>> raised_paraboloid(int n) {
  std::vector<Vec<Q, D>> c, d;
  for (int i = 0; i <= n; ++i) {
    const Q t = Q(i) / Q(n);
    if constexpr (D == 3) {
      c.emplace_back(t, Q(0), Q(0));
      d.emplace_back(t, Q(1), t);
    } else {
      c.emplace_back(Q(1), t, Q(0), Q(0));
      d.emplace_back(Q(1), t, Q(1), t);
    }
  }
  return rounded_net<D>(bezier_knots<Q>(n), std::span<const Vec<Q, D>>(c), d);
}

template <int D>
void expect_paraboloid(int n) {
  const auto net = raised_paraboloid<D>(n);
  ASSERT_TRUE(net.has_value());
  const Enclosure found = enclosure_of(*net);
  EXPECT_LE(found.at_begin, 1.0 / 2);
  EXPECT_GE(found.at_begin, 0.499);
  EXPECT_LE(found.at_end, 1.0 / 3);
  EXPECT_GE(found.at_end, 0.333);
  EXPECT_GE(found.upper, 1.0 / 2);
}

TEST(RoundedNet, HoldsDegreesUpToItsRoom) {
  expect_paraboloid<3>(1);
  expect_paraboloid<3>(16);
  EXPECT_FALSE(raised_paraboloid<3>(17).has_value());
  expect_paraboloid<4>(1);
  expect_paraboloid<4>(8);
  EXPECT_FALSE(raised_paraboloid<4>(9).has_value());
}

/// A rectangle, short in the direction of the rails, whose corners may be off by `error`: it may be twisted by an angle
/// of about 4 error / length.
TEST(RoundedQuotientErrors, CountTheErrorsOfShortRails) {
  const Q zero(0), one(1);
  for (const int exponent : {-4, -10, -16}) {
    const double length = std::ldexp(1.0, exponent), error = length * 0x1p-24;
    const RoundedNet<3> net{1, {0, 1}, {{0, 0, 0}, {length, 0, 0}}, {{0, 1, 0}, {length, 1, 0}}, 0, error};
    const Q l = exact(length), e = exact(error);
    const Row3 c{{zero, zero, e}, {l, zero, -e}}, d{{zero, one, -e}, {l, one, e}};
    const Q attained = pointwise_sine_squared<Q>(bezier_knots<Q>(1), c, d, 1, one / Q(2));
    EXPECT_GE(exact(enclosure_of(net).upper), attained);
    EXPECT_LE(exact(enclosure_of(net).upper), Q(1000) * attained);
  }
}

/// The same the other way round: a twist that may be none.
TEST(RoundedQuotientErrors, KnowNothingOfATwistWithinTheErrors) {
  for (const int exponent : {-4, -10, -16}) {
    const double length = std::ldexp(1.0, exponent), error = length * 0x1p-24;
    const RoundedNet<3> net{1, {0, 1}, {{0, 0, error}, {length, 0, -error}}, {{0, 1, -error}, {length, 1, error}},
                            0, error};
    EXPECT_EQ(enclosure_of(net).at_begin, 0);
    EXPECT_EQ(enclosure_of(net).at_end, 0);
  }
}

/// Doubles next to the net of FJ07.13, which is developable for other knots, as far away as the declared error.
TEST(RoundedQuotientErrors, CountTheErrorsOfTheKnots) {
  constexpr double error = 0x1p-34;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 rng(seed);
    const auto small = [&] { return Q(static_cast<int>(rng() % 2001) - 1000) / Q(2333); };
    std::vector<double> knots{-2, -1, 0, 1, 2, 3};
    std::vector<Q> moved;
    for (const double x : knots) moved.push_back(exact(x + (rng() % 2 == 0 ? error : -error) / 2));
    const KnotList<Q> u(3, moved);
    Row3 c;
    for (int i = 0; i <= u.last(); ++i) c.emplace_back(Q(i), small(), small());
    const Row3 d = linear_net<Q, Vec<Q, 3>>(u, c, Q(9) + small(), Q(8) + small(), Vec<Q, 3>(Q(0), Q(6), small()));
    RoundedNet<3> net{3, knots, {}, {}, error, 0x1p-48};
    for (const auto& x : c) net.c.emplace_back(x[0].to_double(), x[1].to_double(), x[2].to_double());
    for (const auto& x : d) net.d.emplace_back(x[0].to_double(), x[1].to_double(), x[2].to_double());
    const auto quotient = rounded_quotient(net, 1);
    ASSERT_TRUE(quotient.has_value());
    EXPECT_EQ(quotient->lower_at_begin(), 0);
    EXPECT_EQ(quotient->lower_at_end(), 0);
  }
}

/// On a plane rectangle all that is left of the bound is errors. Of the derivation in rounded_net.cpp: 2m means with
/// weights off by 2 knot_error each in c' and d' of degree m, and [a, b, w] sums up six products of these two and w.
TEST(RoundedQuotientErrors, CountEveryMean) {
  constexpr double error = 0x1p-40;
  for (const int n : {2, 4, 6}) {
    RoundedNet<3> net{n, bezier_knots<double>(n).list(), {}, {}, error, 0};
    for (int i = 0; i <= n; ++i) {
      net.c.emplace_back(i, 0, 0);
      net.d.emplace_back(i, 1, 0);
    }
    const double volume = 6 * 2 * (2 * (n - 1) * 2 * error);
    EXPECT_GE(enclosure_of(net).upper, volume * volume);
    EXPECT_LE(enclosure_of(net).upper, 100 * volume * volume);
  }
}

}  // namespace
}  // namespace torse
