// The a-priori bound: against a hand computation, and never below an error.
#include "torse/studies/bound.hpp"

#include <gtest/gtest.h>

#include "torse/developable/linear_net.hpp"
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/studies/measure.hpp"

namespace torse::studies {
namespace {

using Q = Rational;

TEST(Bound, GammaByHand) {
  EXPECT_EQ(gamma(3, 4), ratio<Q>(3, 13));  // (3/16) / (1 - 3/16)
  EXPECT_THROW(gamma(16, 4), InvalidInput);
}

/// One cell of degree 1 over [0, 1] with M* = 2, L* = 5: d_1 - c_1 = (1 (d_0 - c_0) + 3 (c_1 - c_0)) / 2.
TEST(Bound, OneCellByHand) {
  Inputs<Q> in{KnotList<Q>(1, {Q(0), Q(1)}),
               {Vec<Q, 3>(Q(0), Q(1), Q(0)), Vec<Q, 3>(Q(4), Q(1), Q(-2))},
               {},
               {},
               {},
               Q(5),
               Q(2),
               Q(1),
               Q(0),
               {Vec<Q, 3>(Q(6), Q(1), Q(0)), {}, {}}};
  const std::vector<Q> d{Q(6), Q(1), Q(0), Q(13), Q(1), Q(-5)};
  const std::vector<Q> bounds = rulings_bound(in, d, 0, in.anchors[0], 10);
  const Q u = ratio<Q>(1, 1024);
  const Q six = Q(6) * u / (Q(1) - Q(6) * u);
  EXPECT_EQ(bounds[0], Q(0));  // d_0 is given
  EXPECT_EQ(bounds[3], u * Q(13) + (Q(1) + u) * six * (Q(3) + Q(6)));
  EXPECT_EQ(bounds[4], u * Q(1));
  EXPECT_EQ(bounds[5], u * Q(5) + (Q(1) + u) * six * Q(3));
}

/// Hostile rather than random: 12 bits, so that every operation rounds, and levels where terms cancel.
template <int Bits>
double worst_share(const Levels& levels, std::uint64_t seed, int anchor) {
  using S = BigFloat<Bits>;
  const Case in = draw_case(levels, seed);
  const auto rounded = lift<S>(in, [](float x, std::size_t) { return S::from_double(x); });
  // What the low precision holds is the exact input.
  const auto numbers = [](const S& x) { return x.to_rational(); };
  const auto row = [&](const std::vector<Vec<S, 3>>& xs) {
    std::vector<Vec<Q, 3>> result;
    for (const Vec<S, 3>& x : xs) result.push_back(Vec<Q, 3>(numbers(x[0]), numbers(x[1]), numbers(x[2])));
    return result;
  };
  std::vector<Q> knots;
  for (const S& u : rounded.u.list()) knots.push_back(numbers(u));
  const auto anchors = row({rounded.anchors.begin(), rounded.anchors.end()});
  const Inputs<Q> exact{KnotList<Q>(in.degree, knots),
                        row(rounded.c),
                        {},
                        {},
                        {},
                        numbers(rounded.lambda),
                        numbers(rounded.m),
                        numbers(rounded.sigma),
                        numbers(rounded.share),
                        {anchors[0], anchors[1], anchors[2]}};
  const int k = exact.u.last() * anchor / 2;
  const std::size_t a = static_cast<std::size_t>(anchor);
  const auto d = net_from<Q, Vec<Q, 3>>(exact.u, exact.c, exact.lambda, exact.m, k, exact.anchors[a]);
  const auto computed =
      row(net_from<S, Vec<S, 3>>(rounded.u, rounded.c, rounded.lambda, rounded.m, k, rounded.anchors[a]));
  std::vector<Q> flat;
  for (const auto& x : d) flat.insert(flat.end(), {x[0], x[1], x[2]});
  const std::vector<Q> bounds = rulings_bound(exact, flat, k, exact.anchors[a], Bits);
  double most = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    Q error = computed[i / 3][static_cast<int>(i % 3)] - flat[i];
    if (error.sign() < 0) error = -error;
    EXPECT_LE(error, bounds[i]);
    if (error.sign() != 0) most = std::max(most, (error / bounds[i]).to_double());
  }
  return most;
}

TEST(Bound, HoldsAndIsNotIdle) {
  double most = 0;
  for (const double ratio : {1.0, 64.0}) {
    for (const double offset : {0.0, 50.0}) {
      for (int side = 0; side < 3; ++side) {
        Levels levels;
        levels[Factor::pieces] = 5;
        levels[Factor::knot_ratio] = ratio;
        levels[Factor::offset] = offset;
        levels[Factor::after] = 0;
        levels[side == 0 ? Factor::before : side == 1 ? Factor::inside : Factor::after] = 0.125;
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
          for (int anchor = 0; anchor < 3; ++anchor) most = std::max(most, worst_share<20>(levels, seed, anchor));
        }
      }
    }
  }
  EXPECT_GT(most, 0.1);
  EXPECT_LE(most, 1);
}

/// vertex of proofs/coq/Rounding.v in one coordinate: the operations that the proof of the bound speaks of, in their
/// order.
double proved_vertex(double lambda, double m, const std::vector<double>& near, const std::vector<double>& far,
                     const std::vector<double>& p, double d) {
  double ruling = d - p[0];
  for (std::size_t j = 0; j < near.size(); ++j) {
    ruling = ((p[j + 1] - p[j]) * (lambda - m) + (m - near[j]) * ruling) / (m - far[j]);
  }
  return near.empty() ? d : p[near.size()] + ruling;
}

/// Equal in every bit, or the theorem is about another program.
TEST(Bound, TheLibraryDoesTheOperationsOfTheProof) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case in = draw_case(Levels{}, seed);
    const auto x = lift<double>(in, [](float y, std::size_t) { return static_cast<double>(y) / 3; });
    const int n = in.degree;
    for (const int k : {0, in.last() / 2, in.last()}) {
      const Vec<double, 3>& dk = x.anchors[0];
      const auto d = net_from<double, Vec<double, 3>>(x.u, x.c, x.lambda, x.m, k, dk);
      for (int i = 0; i <= in.last(); ++i) {
        for (int j = 0; j < 3; ++j) {
          std::vector<double> near, far, p{x.c[static_cast<std::size_t>(k)][j]};
          for (int at = k; at != i; at += i > k ? 1 : -1) {
            near.push_back(i > k ? x.u[at + n] : x.u[at - 1]);
            far.push_back(i > k ? x.u[at] : x.u[at - 1 + n]);
            p.push_back(x.c[static_cast<std::size_t>(i > k ? at + 1 : at - 1)][j]);
          }
          EXPECT_EQ(d[static_cast<std::size_t>(i)][j], proved_vertex(x.lambda, x.m, near, far, p, dk[j]));
        }
      }
    }
  }
}

/// The same for `printed` of proofs/coq/Rounding_printed.v, upwards and downwards from any vertex.
TEST(Bound, ThePrintedNetDoesTheOperationsOfItsProof) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case in = draw_case(Levels{}, seed);
    const auto x = lift<double>(in, [](float y, std::size_t) { return static_cast<double>(y) / 3; });
    const int n = in.degree;
    for (const int k : {0, in.last() / 2, in.last()}) {
      const Vec<double, 3>& dk = x.anchors[0];
      const auto d = printed_net<double, Vec<double, 3>>(x.u, x.c, x.lambda, x.m, k, dk);
      for (int j = 0; j < 3; ++j) {
        const auto sides = [&](int i) {
          const auto at = static_cast<std::size_t>(i);
          return (x.u[i + n] - x.lambda) * x.c[at][j] + (x.lambda - x.u[i]) * x.c[at + 1][j];
        };
        double vertex = dk[j];
        for (int i = k; i < in.last(); ++i) {
          vertex = (sides(i) + (x.m - x.u[i + n]) * vertex) / (x.m - x.u[i]);
          EXPECT_EQ(d[static_cast<std::size_t>(i + 1)][j], vertex);
        }
        vertex = dk[j];
        for (int i = k - 1; i >= 0; --i) {
          vertex = (sides(i) + (x.u[i] - x.m) * vertex) / (x.u[i + n] - x.m);
          EXPECT_EQ(d[static_cast<std::size_t>(i)][j], vertex);
        }
      }
    }
  }
}

/// The bound speaks of FJ07.13.rulings: the formula as printed does not obey it far from the origin.
TEST(Bound, ThePrintedFormulaDoesNotObeyIt) {
  Levels levels;
  levels[Factor::offset] = 1e4;
  const Case in = draw_case(levels, 3);
  const Inputs<Q> exact = lift<Q>(in, [](float x, std::size_t) { return Q::from_double(x); });
  const auto route = [](const char* name) {
    const std::vector<std::string> names = route_names();
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  const std::vector<Q> d = arithmetic("exact").run(route("FJ07.13"), in).values;
  const std::vector<Q> bounds = rulings_bound(exact, d, 0, exact.anchors[0], 53);
  const auto exceeds = [&](const char* name) {
    const std::vector<Q> computed = arithmetic("double").run(route(name), in).values;
    for (std::size_t i = 0; i < d.size(); ++i) {
      const Q error = computed[i] - d[i];
      if (error > bounds[i] || -error > bounds[i]) return true;
    }
    return false;
  };
  EXPECT_TRUE(exceeds("FJ07.13"));
  EXPECT_FALSE(exceeds("FJ07.13.rulings"));
}

}  // namespace
}  // namespace torse::studies
