// The multi-modular decision against the generic one over Q, on surfaces of every kind.
#include "torse/exact/decide/decide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/bound.hpp"
#include "torse/exact/decide/lane_surface.hpp"
#include "torse/exact/decide/prime_lanes.hpp"
#include "torse/exact/decide/relation.hpp"
#include "torse/proofs/sources.hpp"

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
  const auto found = find_witness_modular<D>(net.u, net.c, net.d);
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
      EXPECT_FALSE((find_witness_modular<3>(u, c, d))) << seed;
    }
  }
}

/// The product of the first primes of the decision.
Rational product_of_primes(std::size_t count) {
  Rational product(1);
  for (std::size_t i = 0; i < count; ++i) {
    product *= Rational(PrimeLanes::block(i / prime_lanes).prime(i % prime_lanes));
  }
  return product;
}

Vec<Rational, 3> point(const Rational& x, const Rational& y, const Rational& z) {
  Vec<Rational, 3> v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

TEST(Decide, ADeterminantDivisibleByManyPrimesIsNotZero) {
  const Rational zero(0), one(1);
  for (std::size_t count = 1; count <= 25; ++count) {
    const Rational product = product_of_primes(count);
    const Net<3> net{bezier_knots<Rational>(1),
                     {point(zero, zero, zero), point(product, zero, zero)},
                     {point(zero, one, zero), point(zero, zero, one)}};
    const auto witness = find_witness_modular<3>(net.u, net.c, net.d);
    ASSERT_TRUE(witness) << count;
    EXPECT_EQ(witness->value, product);
    expect_same<3>(net, std::to_string(count));
  }
}

TEST(Decide, TheFirstWitnessIsFirstEvenWhereItVanishesModuloThePrimes) {
  Net<3> net = random_net<3>(1);
  for (std::uint64_t seed = 1; net.u.degree() != 3 || net.u.pieces() != 3; ++seed) net = random_net<3>(seed);
  FractionSource<Rational> from(7, Temper::generic);
  for (auto* row : {&net.c, &net.d}) {
    for (auto& x : *row) x = random_point<3>(from);
  }
  const Rational product = product_of_primes(2 * prime_lanes + 1);
  for (std::size_t i = 0; i <= 3; ++i) {  // the first piece's determinant becomes a multiple of the primes
    net.c[i][0] *= product;
    net.d[i][0] *= product;
  }
  const auto witness = expect_same<3>(net, "first piece");
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->piece, net.u.proper_pieces().front());
}

TEST(Decide, PrimesInDenominatorsAreNotCounted) {
  const Rational product = product_of_primes(3 * prime_lanes);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Net<3> net = random_net<3>(seed);
    net.c[0][0] += Rational(1) / product;
    expect_same<3>(net, "point, seed " + std::to_string(seed));
  }
  FractionSource<Rational> from(3, Temper::generic);
  const Rational zero(0), one(1);
  const KnotList<Rational> u(2, {zero, one, product, one + product});
  std::vector<Vec<Rational, 3>> c;
  for (int i = 0; i <= u.last(); ++i) c.push_back(random_point<3>(from));
  EXPECT_FALSE(expect_same<3>({u, c, second_row<3>(u, c, Made::by_recursion, from)}, "knots"));
  EXPECT_TRUE(expect_same<3>({u, c, second_row<3>(u, c, Made::at_random, from)}, "knots"));
}

TEST(Decide, ADeterminantWithTheFirstPrimesBelowAndTheNextAboveIsNotZero) {
  const std::size_t count = 3 * prime_lanes;
  const Rational zero(0), one(1);
  const Rational below = one / product_of_primes(count);
  const Rational above = product_of_primes(2 * count + 1) * below;
  const Net<3> net{bezier_knots<Rational>(1),
                   {point(below, zero, zero), point(below + above * below, zero, zero)},
                   {point(below, one, zero), point(below, zero, one)}};
  const auto witness = expect_same<3>(net, "below and above");
  ASSERT_TRUE(witness);
  EXPECT_EQ(witness->value, above * below);
}

/// The lanes of the first block that count for piece 1.
LaneSet valid_lanes(const Net<3>& net) {
  return LaneSurface<3>(PrimeLanes::block(0), net.u.degree(), integer_knots(net.u.list()), net.c, net.d)
      .determinant(1)
      .valid;
}

TEST(Decide, LanesWhosePrimeDividesADenominatorAreNotValid) {
  const Rational zero(0), one(1);
  const Rational first = product_of_primes(1);
  const std::vector<Vec<Rational, 3>> row(3, point(one, one, one));
  EXPECT_EQ(valid_lanes({bezier_knots<Rational>(2), row, row}), all_lanes);
  EXPECT_EQ(valid_lanes({KnotList<Rational>(2, {zero, one, first, one + first}), row, row}), all_lanes & ~1U);
  std::vector<Vec<Rational, 3>> fraction = row;
  fraction[2][1] = one / first;
  EXPECT_EQ(valid_lanes({bezier_knots<Rational>(2), row, fraction}), all_lanes & ~1U);
}

/// The bound of bound.hpp holds the numerators of f / n^D, which divide the integers that it is about.
template <int D>
void expect_bound(const Net<D>& net) {
  const std::vector<Integer> knots = integer_knots(net.u.list());
  for (const int k : net.u.proper_pieces()) {
    const long bits = determinant_bits<D>(net.u, knots, net.c, net.d, k);
    BinaryForm<Rational> det = span_determinant<Rational>(net.u, net.c, net.d, k);
    for (int i = 0; i < D; ++i) det = (Rational(1) / Rational(net.u.degree())) * det;
    for (int i = 0; i <= det.degree(); ++i) {
      ASSERT_LE(static_cast<long>(det[i].numerator_bits()), std::max(bits, 0L));
    }
  }
}

TEST(Decide, TheBoundHolds) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    expect_bound<3>(random_net<3>(seed));
    expect_bound<4>(random_net<4>(seed));
  }
}

TEST(Decide, TheBoundHoldsWhereEverySignAddsUp) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Rng rng(seed);
    const int n = 1 + static_cast<int>(rng.below(4));
    Net<3> net{bezier_knots<Rational>(n), {}, {}};
    for (auto* row : {&net.c, &net.d}) {
      for (int i = 0; i <= n; ++i) {
        const auto sign = [&] { return Rational(rng.once_in(2) ? 1 : -1); };
        row->push_back(point(sign(), sign(), sign()));
      }
    }
    expect_bound<3>(net);
    expect_same<3>(net, "seed " + std::to_string(seed));
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
  EXPECT_THROW((find_witness_modular<3>(bezier_knots<Rational>(1), row, row)), InvalidInput);
}

TEST(PrimeLanes, ResiduesOfIntegers) {
  Rng rng(5);
  const PrimeLanes& field = PrimeLanes::block(1);
  const std::vector<Lanes> powers = field.powers(8);
  for (int trial = 0; trial < 2000; ++trial) {
    Integer x;
    for (std::uint64_t limbs = rng.below(9); limbs > 0; --limbs) {
      mpz_mul_2exp(x.get(), x.get(), 64);
      mpz_add_ui(x.get(), x.get(), rng.once_in(3) ? ~0UL - rng.below(2) : rng());
    }
    if (mpz_sizeinbase(x.get(), 2) > 8 * 64) continue;
    if (rng.once_in(2)) mpz_neg(x.get(), x.get());
    const Lanes residues = field.integer(x.get(), powers);
    for (std::size_t k = 0; k < prime_lanes; ++k) {
      Lanes expected = field.word(mpz_fdiv_ui(x.get(), field.prime(k)));
      EXPECT_EQ(residues[k], expected[k]);
    }
  }
}

}  // namespace
}  // namespace torse
