// Simpler surfaces: what is known to be simple comes back so, and the distance is an upper bound by other samples.
#include "torse/exact/quasi/simplify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/exact/quasi/snap.hpp"
#include "torse/quasi/surface.hpp"

namespace torse {
namespace {

using Q = Rational;
using P = Vec<Q, 3>;

KnotList<Q> uniform(int degree, int pieces) {
  std::vector<Q> list(static_cast<std::size_t>(degree), Q(0));
  for (int i = 1; i < pieces; ++i) list.push_back(ratio<Q>(i, pieces));
  list.insert(list.end(), static_cast<std::size_t>(degree), Q(1));
  return KnotList<Q>(degree, list);
}

Spline<Q, P> rail(int degree, int pieces, std::uint64_t seed, int height) {
  std::mt19937_64 rng(seed);
  std::vector<P> row;
  for (int i = 0; i < pieces + degree; ++i) {
    const Q x = ratio<Q>(10 * i, pieces + degree - 1);
    const Q y = ratio<Q>(static_cast<int>(rng() % 200), 100);
    row.push_back(P(x, y, Q(height)));
  }
  return Spline<Q, P>(uniform(degree, pieces), row);
}

/// t + t (1 - t) / 3 over some knots, with a small ripple.
Mapping<Q> bent(const KnotList<Q>& u, int ripple) {
  Mapping<Q> sigma = identity_mapping(u);
  for (int i = 1; i < u.last(); ++i) {
    Q& b = sigma.control[static_cast<std::size_t>(i)][0];
    b += b * (Q(1) - b) / Q(3) + ratio<Q>(i % 2 == 0 ? ripple : 0, 100000);
  }
  return sigma;
}

ExactSurface result(int ripple) {
  const Spline<Q, P> c1 = rail(3, 2, 1, 0);
  const Spline<Q, P> c2 = rail(3, 2, 2, 4);
  return quasi_surface(c1, c2, snapped(bent(uniform(2, 12), ripple), c1.knots, c2.knots).sigma);
}

double largest_sampled_distance(const ExactSurface& x, const ExactSurface& y) {
  double largest = 0;
  for (int i = 0; i <= 400; ++i) {
    const KnotList<Q>& domain = y.knots;
    const Q t = domain.domain_begin() + ratio<Q>(i, 400) * (domain.domain_end() - domain.domain_begin());
    const auto at = [&](const KnotList<Q>& u, const std::vector<P>& row) {
      return curve_point<Q, P>(u, row, piece_at(u, t), t);
    };
    for (const P& rest :
         {difference(at(x.knots, x.c), at(y.knots, y.c)), difference(at(x.knots, x.d), at(y.knots, y.d))}) {
      largest = std::max(largest, std::sqrt(dot<Q>(rest, rest).to_double()));
    }
  }
  return largest;
}

void expect_near(const SimplifiedSurface& found, const ExactSurface& surface, const Q& tolerance) {
  EXPECT_LE(found.distance, tolerance.to_double() * (1 + 1e-15));
  EXPECT_LE(largest_sampled_distance(found.surface, surface), found.distance);
  for (const bool second : {false, true}) {
    const std::vector<P>& x = second ? found.surface.d : found.surface.c;
    const std::vector<P>& y = second ? surface.d : surface.c;
    EXPECT_EQ(x.front(), y.front());
    EXPECT_EQ(x.back(), y.back());
  }
}

/// The squares of the large one are beyond the doubles.
TEST(Simplified, OfAnySize) {
  for (const double size : {0x1p700, 0x1p-500}) {
    const Q s = Q::from_double(size);
    const std::vector<P> bend{P(Q(0), Q(0), Q(0)), P(Q(4) * s, Q(2) * s, Q(0)), P(Q(8) * s, Q(0), Q(0))};
    const std::vector<P> line{P(Q(0), Q(0), s), P(Q(4) * s, Q(0), s), P(Q(8) * s, Q(0), s)};
    const SimplifiedSurface found = with_lowest_degree(ExactSurface(uniform(1, 2), bend, line), Q(2) * s);
    EXPECT_EQ(found.distance, 2 * size);
  }
}

/// A bend of height h whose straight line is just as far as is allowed: 2 is a double, 2/3 has a root above it.
TEST(Simplified, AsFarAsTheTolerance) {
  for (const Q& h : {Q(2), ratio<Q>(2, 3)}) {
    const std::vector<P> bend{P(Q(0), Q(0), Q(0)), P(Q(4), h, Q(0)), P(Q(8), Q(0), Q(0))};
    const std::vector<P> line{P(Q(0), Q(0), Q(1)), P(Q(4), Q(0), Q(1)), P(Q(8), Q(0), Q(1))};
    const SimplifiedSurface found = with_fewest_points(ExactSurface(uniform(1, 2), bend, line), h);
    EXPECT_LE(Q::from_double(found.distance), h);
    EXPECT_EQ(found.surface.c.size(), h == Q(2) ? 2U : 3U);
    EXPECT_EQ(found.distance, h == Q(2) ? 2 : 0);
  }
}

TEST(Simplify, ACubicInDisguiseIsFoundAgain) {
  // sigma = t over superfluous knots: the rows are the cubic rails with one knot at 1/2, raised to degree 6.
  const Spline<Q, P> c1 = rail(3, 2, 3, 0);
  const Spline<Q, P> c2 = rail(3, 2, 4, 5);
  const ExactSurface surface = quasi_surface(c1, c2, identity_mapping(uniform(2, 8)));
  ASSERT_EQ(surface.c.size(), 49U);
  const Q tolerance = ratio<Q>(1, 1000000000);
  const SimplifiedSurface found = with_lowest_degree(surface, tolerance);
  EXPECT_EQ(found.surface.knots.degree(), 3);
  EXPECT_EQ(found.surface.knots.list(), c1.knots.list());
  expect_near(found, surface, tolerance);
  EXPECT_LT(found.distance, 1e-12);
  EXPECT_EQ(with_fewest_points(surface, tolerance).surface.c.size(), 5U);
}

TEST(Simplify, ResultsOfAlgorithmOne) {
  const ExactSurface surface = result(20);
  ASSERT_EQ(surface.knots.degree(), 6);
  std::size_t last = surface.c.size();
  for (const int digits : {6, 3}) {
    const Q tolerance = Q(1) / Q(static_cast<std::int64_t>(std::pow(10, digits)));
    const SimplifiedSurface found = with_fewest_points(surface, tolerance);
    expect_near(found, surface, tolerance);
    EXPECT_LE(found.surface.c.size(), last);
    last = found.surface.c.size();
    const SimplifiedSurface low = with_lowest_degree(surface, tolerance);
    expect_near(low, surface, tolerance);
    for (int degree = 1; degree < low.surface.knots.degree(); ++degree) {
      EXPECT_FALSE(with_fewest_knots(surface, degree, tolerance).has_value());
    }
  }
  EXPECT_LT(last, 20U);
}

TEST(Simplify, WhereNothingIsNearEnoughTheSurfaceItself) {
  const ExactSurface surface = result(20);
  const SimplifiedSurface found = with_lowest_degree(surface, Q(1) / Q(1LL << 62));
  EXPECT_EQ(found.surface.c, surface.c);
  EXPECT_EQ(found.distance, 0);
}

TEST(Simplify, WhatComesOutExactlyHasNoDistance) {
  const ExactSurface bilinear(bezier_knots<Q>(1), {P(Q(0), Q(0), Q(0)), P(Q(3), Q(1), Q(0))},
                              {P(Q(0), Q(2), Q(1)), P(Q(4), Q(2), Q(5))});
  const std::optional<SimplifiedSurface> found = with_fewest_knots(bilinear, 1, Q(1));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->surface.c, bilinear.c);
  EXPECT_EQ(found->distance, 0);
}

/// Breakpoints that are one double: the first of them stands for both.
TEST(Simplify, KnotsNearerThanDoublesAreOne) {
  const Q middle = Q(1) / Q(2), beside = middle + Q::from_double(0x1p-60);
  const ExactSurface surface(
      KnotList<Q>(2, {Q(0), Q(0), middle, beside, Q(1), Q(1)}),
      {P(Q(0), Q(0), Q(0)), P(Q(1), Q(4), Q(0)), P(Q(2), Q(1), Q(0)), P(Q(3), Q(5), Q(0)), P(Q(4), Q(0), Q(0))},
      {P(Q(0), Q(0), Q(9)), P(Q(1), Q(0), Q(9)), P(Q(2), Q(0), Q(9)), P(Q(3), Q(0), Q(9)), P(Q(4), Q(0), Q(9))});
  const std::optional<SimplifiedSurface> found = with_fewest_knots(surface, 2, Q(1) / Q(1000));
  ASSERT_TRUE(found.has_value());
  expect_near(*found, surface, Q(1) / Q(1000));
  EXPECT_EQ(found->surface.knots.list(), (std::vector<Q>{Q(0), Q(0), middle, middle, Q(1), Q(1)}));
}

/// As Algorithm 1 gives knots, each as often as the degree is, and over a domain whose ends are one double too: a strip
/// of degree 2 that is x = t, with a piece between that doubles do not tell.
TEST(Simplify, PiecesNearerThanDoublesAreLeftOut) {
  const Q begin = Q::from_text("100000000000000000000");
  const auto strip = [&](const Q& at) {
    std::vector<Q> knots;
    std::vector<P> c, d;
    const std::vector<Q> breaks{Q(0), at, at + Q::from_double(0x1p-60), Q(1)};
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      knots.insert(knots.end(), 2, begin + breaks[i]);
      const Q& t = breaks[i];
      for (auto* row : {&c, &d}) {
        if (i > 0) row->push_back(P((breaks[i - 1] + t) / Q(2), breaks[i - 1] * t, Q(row == &c ? 0 : 1)));
        row->push_back(P(t, t * t, Q(row == &c ? 0 : 1)));
      }
    }
    return ExactSurface(KnotList<Q>(2, knots), c, d);
  };
  for (const Q& at : {Q(1) / Q(2), Q::from_double(0x1p-80), Q(1) - Q::from_double(0x1p-58)}) {
    const ExactSurface surface = strip(at);
    const SimplifiedSurface found = with_fewest_points(surface, Q(1) / Q(1000000));
    expect_near(found, surface, Q(1) / Q(1000000));
    EXPECT_EQ(found.surface.knots.list(), (std::vector<Q>{begin, begin, begin + Q(1), begin + Q(1)}));
    EXPECT_NEAR(found.surface.c[1][0].to_double(), 0.5, 1e-9) << "the blossom of (t, t^2) at 0 and 1";
    EXPECT_NEAR(found.surface.c[1][1].to_double(), 0, 1e-9);
  }
}

TEST(Simplify, RefusesWhatIsNoQuestion) {
  const ExactSurface surface = result(0);
  EXPECT_THROW(with_fewest_knots(surface, 0, Q(1)), InvalidInput);
  EXPECT_THROW(with_fewest_knots(surface, 7, Q(1)), InvalidInput);
  EXPECT_THROW(with_fewest_knots(surface, 3, Q(0)), InvalidInput);
  const ExactSurface open(KnotList<Q>(2, {Q(0), Q(1), Q(2), Q(3)}), std::vector<P>(3, P(Q(0), Q(0), Q(0))),
                          std::vector<P>(3, P(Q(0), Q(0), Q(1))));
  EXPECT_THROW(with_fewest_knots(open, 2, Q(1)), InvalidInput);
}

}  // namespace
}  // namespace torse
