// The fast decision against the generic one over Q, on surfaces of every kind.
#include "torse/exact/decide/decide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/relation.hpp"
#include "torse/proofs/sources.hpp"
#include "torse/spline/elevation.hpp"

namespace torse {
namespace {

using proofs::FractionSource;
using proofs::Rng;
using proofs::Size;
using proofs::Temper;

template <int D>
struct Net {
  KnotList<Rational> u;
  std::vector<Vec<Rational, D>> c;
  std::vector<Vec<Rational, D>> d;
};

Rational text(const std::string& s) { return Rational::from_text(s); }

template <int D>
Vec<Rational, D> random_point(FractionSource<Rational>& from) {
  Vec<Rational, D> x;
  for (Rational& coordinate : x) coordinate = from.scalar();
  if (D == 4 && x[0].sign() == 0) x[0] = Rational(1);
  return x;
}

/// How the second row is made, and what is done to the net afterwards.
enum class Made { at_random, by_recursion, cone, cylinder };
enum class Change { none, near_miss, plane, coinciding, huge, zero_column };

template <int D>
std::vector<Vec<Rational, D>> second_row(const KnotList<Rational>& u, const std::vector<Vec<Rational, D>>& c, Made made,
                                         FractionSource<Rational>& from) {
  using P = Vec<Rational, D>;
  switch (made) {
    case Made::by_recursion:
      for (;;) {
        try {
          const Rational lambda = from.scalar();
          const Rational m = from.scalar();
          if constexpr (D == 3) return linear_net<Rational, P>(u, c, lambda, m, random_point<D>(from));
          return rational_net<Rational, P>(u, c, lambda, m, from.positive(), random_point<D>(from));
        } catch (const InvalidInput&) {  // M* is a knot: draw another
        }
      }
    case Made::cone:
      return cone_net<Rational, P>(c, from.scalar(), random_point<D>(from));
    case Made::cylinder: {
      std::vector<Rational> lengths;
      for (std::size_t i = 0; i < c.size(); ++i) lengths.push_back(from.scalar());
      return cylinder_net<Rational, P>(c, random_point<D>(from), lengths);
    }
    case Made::at_random:
      break;
  }
  std::vector<P> d;
  for (std::size_t i = 0; i < c.size(); ++i) d.push_back(random_point<D>(from));
  return d;
}

template <int D>
void apply(Change change, Net<D>& net, Rng& rng) {
  const std::size_t at = rng.below(net.c.size());
  const auto column = static_cast<Eigen::Index>(rng.below(D));
  switch (change) {
    case Change::none:
      return;
    case Change::near_miss:
      net.d[at][column] += text("1/1" + std::string(30, '0'));
      return;
    case Change::plane:
      for (auto* row : {&net.c, &net.d}) {
        for (auto& x : *row) x[D - 1] = x[D - 2] + x[D - 3];
      }
      return;
    case Change::coinciding:
      net.c[at] = net.c[net.c.size() - 1 - at];
      net.d[at / 2] = net.c[at / 2];
      return;
    case Change::huge:
      for (auto* row : {&net.c, &net.d}) {
        for (auto& x : *row) x[column] *= text("123456789" + std::string(300, '7'));
      }
      return;
    case Change::zero_column:
      for (auto* row : {&net.c, &net.d}) {
        for (auto& x : *row) x[column] = Rational(0);
      }
      return;
  }
}

template <int D>
Net<D> random_net(std::uint64_t seed) {
  Rng rng(seed);
  FractionSource<Rational> from(seed, static_cast<Temper>(rng.below(proofs::tempers)));
  const Size size{1 + static_cast<int>(rng.below(5)), 1 + static_cast<int>(rng.below(4))};
  KnotList<Rational> u(size.n, from.knots(size));
  std::vector<Vec<Rational, D>> c;
  for (int i = 0; i <= size.last(); ++i) c.push_back(random_point<D>(from));
  const Made kinds[] = {Made::at_random, Made::by_recursion, Made::by_recursion, Made::cone, Made::cylinder};
  std::vector<Vec<Rational, D>> d = second_row<D>(u, c, kinds[rng.below(5)], from);
  Net<D> net{std::move(u), std::move(c), std::move(d)};
  apply(static_cast<Change>(rng.below(6)), net, rng);
  return net;
}

/// Both answers agree; returns the oracle's.
template <int D>
std::optional<DevelopabilityWitness<Rational>> expect_same(const Net<D>& net, const std::string& name) {
  const auto expected = find_witness<Rational, D>(net.u, net.c, net.d);
  const auto found = find_witness_over_q<D>(net.u, net.c, net.d);
  EXPECT_EQ(found.has_value(), expected.has_value()) << name;
  if (found && expected) {
    EXPECT_EQ(found->piece, expected->piece) << name;
    EXPECT_EQ(found->coefficient, expected->coefficient) << name;
    EXPECT_EQ(found->value, expected->value) << name;
  }
  return expected;
}

/// Counts of what was met, so that a run that met nothing fails.
template <int D>
void compare_many(std::uint64_t count) {
  int developable = 0, late_piece = 0, late_coefficient = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const Net<D> net = random_net<D>(seed);
    const auto witness = expect_same<D>(net, "seed " + std::to_string(seed));
    developable += !witness;
    late_piece += witness && witness->piece != net.u.proper_pieces().front();
    late_coefficient += witness && witness->coefficient > 0;
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(developable, static_cast<int>(count / 4));
  EXPECT_LT(developable, static_cast<int>(3 * count / 4));
  EXPECT_GT(late_piece, static_cast<int>(count / 100));
  EXPECT_GT(late_coefficient, static_cast<int>(count / 100));
}

TEST(Decide, AgreesWithTheOracleOnPolynomialSurfaces) { compare_many<3>(2000); }

TEST(Decide, AgreesWithTheOracleOnRationalSurfaces) { compare_many<4>(1000); }

TEST(Decide, CylindersConesAndRecursionsAreDevelopable) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (const Made made : {Made::by_recursion, Made::cone, Made::cylinder}) {
      FractionSource<Rational> from(seed, Temper::repeated);
      const Size size{3, 4};
      const KnotList<Rational> u(size.n, from.knots(size));
      std::vector<Vec<Rational, 3>> c;
      for (int i = 0; i <= size.last(); ++i) c.push_back(random_point<3>(from));
      const std::vector<Vec<Rational, 3>> d = second_row<3>(u, c, made, from);
      EXPECT_FALSE((find_witness_over_q<3>(u, c, d))) << seed;
    }
  }
}

Vec<Rational, 3> point(const Rational& x, const Rational& y, const Rational& z) {
  Vec<Rational, 3> v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

TEST(Decide, NetsOfRaisedDegreeAreDevelopable) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const Temper temper : {Temper::generic, Temper::repeated}) {
      FractionSource<Rational> from(seed, temper);
      const Size size{1 + static_cast<int>(seed % 3), 3};
      const KnotList<Rational> u(size.n, from.knots(size));
      std::vector<Vec<Rational, 4>> p;
      for (int i = 0; i <= size.last(); ++i) p.push_back(random_point<4>(from));
      const std::vector<Vec<Rational, 4>> q = second_row<4>(u, p, Made::by_recursion, from);
      const auto raised = [&](const auto& row) { return elevate(Spline<Rational, Vec<Rational, 4>>(u, row)); };
      Net<4> net{raised(p).knots, raised(p).control, raised(q).control};
      const std::string name = "seed " + std::to_string(seed);
      EXPECT_FALSE((find_witness_over_q<4>(net.u, net.c, net.d))) << name;
      net.d[seed % net.d.size()][1] += text("1/1" + std::string(30, '0'));
      expect_same<4>(net, name);
    }
  }
}

TEST(Decide, ADeterminantThatVanishesAtAllParametersButOneIsNotZero) {
  // With c = (t^2/2 - t, 0, 0) and d - c = (0, t^2, 2t - 2), [c', d-c, d'-c'] = -2 t (t-1) (t-2): of degree 3, and zero
  // at the first three parameters.
  const auto row = [](int y0, int y1, int y2, int z0, int z1, int z2) {
    const Rational zero(0), half = Rational(-1) / Rational(2);
    return std::vector<Vec<Rational, 3>>{point(zero, Rational(y0), Rational(z0)),
                                         point(half, Rational(y1), Rational(z1)),
                                         point(half, Rational(y2), Rational(z2))};
  };
  const Net<3> net{bezier_knots<Rational>(2), row(0, 0, 0, 0, 0, 0), row(0, 0, 1, -2, -1, 0)};
  const auto witness = expect_same<3>(net, "cubic");
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->coefficient, 1);
}

TEST(Decide, EveryCoefficientMayBeTheFirst) {
  // The ruling turns with t^m from its direction at t = 0: [c', d-c, d'-c'] = m t^(m-1) for c = (t, 0, 0).
  constexpr int n = 5;
  for (int m = 1; m <= n; ++m) {
    std::vector<Vec<Rational, 3>> c, d;
    for (int i = 0; i <= n; ++i) {
      const Rational x = Rational(i) / Rational(n);
      const Rational power = binomial<Rational>(i, m) / binomial<Rational>(n, m);  // t^m in Bernstein form
      c.push_back(point(x, Rational(0), Rational(0)));
      d.push_back(point(x, Rational(1), power));
    }
    const auto witness = expect_same<3>({bezier_knots<Rational>(n), c, d}, std::to_string(m));
    ASSERT_TRUE(witness);
    EXPECT_EQ(witness->coefficient, m - 1);
  }
}

TEST(Decide, ARelationThatHoldsModuloItsPrimeOnlyProvesNothing) {
  const Rational prime(RelationProver<3>::prime);
  int developable = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    FractionSource<Rational> from(seed, Temper::clamped);
    const Size size{1 + static_cast<int>(seed % 4), 2};
    Net<3> net{KnotList<Rational>(size.n, from.knots(size)), {}, {}};
    for (int i = 0; i <= size.last(); ++i) net.c.push_back(random_point<3>(from));
    net.d = second_row<3>(net.u, net.c, Made::by_recursion, from);
    developable += !expect_same<3>(net, "seed " + std::to_string(seed));
    net.d[seed % net.d.size()][0] += prime;
    developable += !expect_same<3>(net, "changed, seed " + std::to_string(seed));
  }
  EXPECT_LT(developable, 150);
}

TEST(RelationProver, FindsTheRelationOfTheRecursion) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    FractionSource<Rational> from(seed, Temper::repeated);
    const Size size{1 + static_cast<int>(seed % 5), 1 + static_cast<int>(seed % 3)};
    const KnotList<Rational> u(size.n, from.knots(size));
    std::vector<Vec<Rational, 4>> p;
    for (int i = 0; i <= size.last(); ++i) p.push_back(random_point<4>(from));
    const std::vector<Vec<Rational, 4>> q = second_row<4>(u, p, Made::by_recursion, from);
    const std::vector<Integer> knots = integer_knots(u.list());
    RelationProver<4> prover(size.n, knots, p, q);
    for (const int k : u.proper_pieces()) EXPECT_TRUE(prover.prove(k)) << seed;
  }
}

TEST(Decide, RowsOfAWrongLengthAreAnError) {
  const std::vector<Vec<Rational, 3>> row(3, point(Rational(0), Rational(0), Rational(0)));
  EXPECT_THROW((find_witness_over_q<3>(bezier_knots<Rational>(1), row, row)), InvalidInput);
}

}  // namespace
}  // namespace torse
