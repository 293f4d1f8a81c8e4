// Primes, Montgomery arithmetic against 128-bit remainders, Zp against the integers, Batch against Zp.
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "laws/laws.hpp"
#include "torse/exact/modular/batch.hpp"
#include "torse/exact/modular/prime.hpp"
#include "torse/exact/modular/zp.hpp"

namespace torse::laws {

constexpr std::uint64_t largest_prime = (std::uint64_t{1} << 63) - 25;

const Modulus& sample_modulus() {
  static const Modulus modulus(largest_prime);
  return modulus;
}

template <>
struct Samples<Zp> : FractionSamples<Zp> {
  /// Residues, edge cases, and constants that have met no modulus.
  static Zp any(Rng& rng) {
    switch (rng() % 4) {
      case 0:
        return DyadicSamples<Zp>::any(rng);
      case 1:
        return Zp(sample_modulus(), largest_prime - rng() % 3);
      default:
        return Zp::draw(sample_modulus(), rng);
    }
  }
  static Zp unit(Rng& rng) {
    const Zp x = any(rng);
    return x.is_zero() ? Zp(1) : x;
  }
};

template <>
struct Samples<Batch> : DyadicSamples<Batch> {
  static constexpr bool throws_on_zero = false;

  /// Random lanes with zeros and undefined lanes among them, and constants.
  static Batch any(Rng& rng) {
    if (rng() % 4 == 0) return DyadicSamples<Batch>::any(rng);
    Batch x(sample_modulus(), [&](int) { return rng() % 8 == 0 ? 0 : rng(); });
    if (rng() % 4 == 0) x += Batch(0) / Batch(sample_modulus(), [&](int) { return rng() % 8; });
    return x;
  }
  static Batch unit(Rng& rng) {
    if (rng() % 4 == 0) return DyadicSamples<Batch>::unit(rng);
    return Batch(sample_modulus(), [&](int) { return 1 + rng() % (largest_prime - 1); });
  }
};

using Modular = testing::Types<Zp, Batch>;
INSTANTIATE_TYPED_TEST_SUITE_P(Modular, RingLaws, Modular, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Modular, FieldLaws, Modular, ScalarName);

TEST(Prime, AgreesWithTrialDivision) {
  const auto has_divisor = [](std::uint64_t n) {
    for (std::uint64_t d = 2; d * d <= n; ++d) {
      if (n % d == 0) return true;
    }
    return false;
  };
  for (std::uint64_t n = 0; n < 5000; ++n) EXPECT_EQ(is_prime(n), n >= 2 && !has_divisor(n)) << n;
  for (std::uint64_t n = 4'294'967'000; n < 4'294'967'400; ++n) EXPECT_EQ(is_prime(n), !has_divisor(n)) << n;
}

TEST(Prime, KnowsPrimesAndStrongPseudoprimes) {
  for (const std::uint64_t p : {(std::uint64_t{1} << 61) - 1, largest_prime, ~std::uint64_t{0} - 58})
    EXPECT_TRUE(is_prime(p));
  // Jaeschke's and Sorenson-Webster's least strong pseudoprimes to the first 1, 2, ..., 9 bases, squares and Carmichael
  // numbers.
  for (const std::uint64_t n :
       {2047ULL, 1373653ULL, 25326001ULL, 3215031751ULL, 2152302898747ULL, 3474749660383ULL, 341550071728321ULL,
        3825123056546413051ULL, 561ULL, 1105ULL, 4295098369ULL, 18446744073709551615ULL, 18446744030759878681ULL}) {
    EXPECT_FALSE(is_prime(n)) << n;
  }
}

TEST(Prime, ModulusWantsAPrimeOfTheRightSize) {
  for (const std::uint64_t bad : {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{7}, (std::uint64_t{1} << 61) - 1,
                                  std::uint64_t{1} << 62, largest_prime - 2, ~std::uint64_t{0} - 58}) {
    EXPECT_THROW(Modulus{bad}, InvalidInput) << bad;
  }
  EXPECT_EQ(Modulus(largest_prime).prime(), largest_prime);
}

TEST(Prime, RandomPrimesLieInTheirInterval) {
  Rng rng(1);
  std::set<std::uint64_t> seen;
  int upper_half = 0;
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t p = random_prime(rng).prime();
    EXPECT_TRUE(is_prime(p));
    EXPECT_EQ(p >> 61, 1U);
    seen.insert(p);
    upper_half += static_cast<int>((p >> 60) & 1);
  }
  EXPECT_EQ(seen.size(), 200U);
  EXPECT_GT(upper_half, 60);
  EXPECT_LT(upper_half, 140);
}

TEST(Prime, ASeedFixesTheRandomPrime) {
  Rng one(42), other(42);
  EXPECT_EQ(random_prime(one).prime(), random_prime(other).prime());
}

/// Words from a list.
struct Words {
  using result_type = std::uint64_t;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }
  result_type operator()() { return list.at(next++); }

  std::vector<result_type> list;
  std::size_t next = 0;
};

TEST(Prime, DrawsBelowTheModulusAlone) {
  const Modulus modulus((std::uint64_t{1} << 62) - 57);
  Words words{{modulus.prime(), modulus.prime() + 1, ~std::uint64_t{0}, modulus.prime() - 1, 0}};
  EXPECT_EQ(modulus.draw(words), modulus.prime() - 1);
  EXPECT_EQ(modulus.draw(words), 0U);
}

TEST(Prime, CountBoundFollowsFromRosserAndSchoenfeld) {
  const double log2 = std::log(2.0);
  const double bound = std::ldexp(1.0, 62) / (62 * log2 - 0.5) - std::ldexp(1.0, 61) / (61 * log2 - 1.5);
  EXPECT_LT(static_cast<double>(prime_count_lower_bound), bound);
  EXPECT_LT(prime_count_lower_bound, 109'932'807'585'469'973 - 55'890'484'045'084'135);
}

/// The least prime >= n that is r modulo 8: a prime of each odd class tries the Newton iteration from a start of 3
/// bits.
std::uint64_t least_prime_above(std::uint64_t n, std::uint64_t r) {
  while (n % 8 != r || !is_prime(n)) ++n;
  return n;
}

class MontgomeryTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  /// Calls check(x, y) for edge cases and random integers below the modulus.
  template <class Check>
  void for_pairs(Check check) const {
    const std::uint64_t p = m_.prime();
    Rng rng(p);
    std::vector<std::uint64_t> x = {
        0, 1, 2, p - 1, p - 2, p / 2, p / 2 + 1, (std::uint64_t{1} << 32), (std::uint64_t{1} << 61)};
    while (x.size() < 60) x.push_back(rng() % p);
    for (const std::uint64_t a : x) {
      for (const std::uint64_t b : x) check(a, b);
    }
  }
  const Modulus m_{GetParam()};
};

TEST_P(MontgomeryTest, AgreesWithRemainders) {
  const std::uint64_t p = m_.prime();
  for_pairs([&](std::uint64_t x, std::uint64_t y) {
    const std::uint64_t a = m_.encode(x), b = m_.encode(y);
    EXPECT_EQ(m_.decode(a), x);
    EXPECT_EQ(m_.decode(m_.multiply(a, b)), static_cast<std::uint64_t>(uint128{x} * y % p));
    EXPECT_EQ(m_.decode(m_.add(a, b)), static_cast<std::uint64_t>((uint128{x} + y) % p));
    EXPECT_EQ(m_.decode(m_.subtract(a, b)), static_cast<std::uint64_t>((uint128{x} + p - y) % p));
    EXPECT_EQ(m_.decode(m_.negate(a)), (p - x) % p);
    EXPECT_EQ(a == b, x == y);
    for (const std::uint64_t r : {m_.multiply(a, b), m_.add(a, b), m_.subtract(a, b), m_.negate(a)}) EXPECT_LT(r, p);
  });
}

TEST_P(MontgomeryTest, EncodesEveryWordAndInverts) {
  const std::uint64_t p = m_.prime();
  for (const std::uint64_t x : {p, p + 1, ~std::uint64_t{0}}) EXPECT_EQ(m_.decode(m_.encode(x)), x % p);
  EXPECT_EQ(m_.decode(m_.one()), 1U);
  for_pairs([&](std::uint64_t x, std::uint64_t) {
    if (x == 0) return;
    EXPECT_EQ(static_cast<std::uint64_t>(uint128{m_.decode(m_.inverse(m_.encode(x)))} * x % p), 1U);
  });
  EXPECT_THROW(static_cast<void>(m_.inverse(0)), DivisionByZero);
}

INSTANTIATE_TEST_SUITE_P(Primes, MontgomeryTest,
                         testing::Values(largest_prime, least_prime_above(std::uint64_t{1} << 61, 1),
                                         least_prime_above(std::uint64_t{1} << 61, 3),
                                         least_prime_above(std::uint64_t{1} << 62, 5),
                                         least_prime_above(0x5555555555555555, 7)));

TEST(Zp, ConstantsAdoptTheModulusTheyMeet) {
  const Modulus& m = sample_modulus();
  const Zp x(m, 10);
  EXPECT_EQ(Zp(3).modulus(), nullptr);
  EXPECT_EQ((Zp(3) + x).modulus(), &m);
  EXPECT_EQ((x + Zp(3)).value(), 13U);
  EXPECT_EQ((Zp(3) - x).value(), largest_prime - 7);
  EXPECT_EQ((Zp(-3) * x).value(), largest_prime - 30);
  EXPECT_EQ((ratio<Zp>(1, 5) * x).value(), 2U);
  EXPECT_EQ((x / Zp(5)).value(), 2U);
  EXPECT_EQ((Zp(std::numeric_limits<std::int64_t>::min()) + Zp(m, 0)).value(),
            static_cast<std::uint64_t>(uint128{largest_prime} * 2 - (uint128{1} << 63)));
  EXPECT_EQ(ratio<Zp>(-6, 4).text(), "-3/2");
}

TEST(Zp, ConstantsAreExactOrThrow) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  EXPECT_THROW(static_cast<void>(Zp(largest) + Zp(1)), Error);
  EXPECT_THROW(static_cast<void>(Zp(largest) * Zp(largest)), Error);
  EXPECT_THROW(static_cast<void>((Zp(1) / Zp(largest)) * (Zp(1) / Zp(largest - 1))), Error);
  EXPECT_THROW(static_cast<void>(-Zp(std::numeric_limits<std::int64_t>::min())), Error);
  EXPECT_THROW(static_cast<void>(Zp(~std::uint64_t{0})), Error);
  EXPECT_EQ((Zp(largest) / Zp(largest)).text(), "1");
  EXPECT_EQ((Zp(largest) * (Zp(2) / Zp(largest))).text(), "2");
}

TEST(Zp, DifferentModuliDoNotMix) {
  const Modulus a(largest_prime), b(least_prime_above(std::uint64_t{1} << 61, 1)), same_as_a(largest_prime);
  EXPECT_THROW(static_cast<void>(Zp(a, 1) + Zp(b, 1)), InvalidInput);
  EXPECT_THROW(static_cast<void>(Zp(a, 1) / Zp(b, 1)), InvalidInput);
  EXPECT_EQ((Zp(a, 1) + Zp(same_as_a, 1)).value(), 2U);
  const auto lanes = [](int) { return 1U; };
  EXPECT_THROW(static_cast<void>(Batch(a, lanes) * Batch(b, lanes)), InvalidInput);
  Batch y(b, lanes);
  EXPECT_THROW(add_product(y, Batch(a, lanes), Batch(a, lanes)), InvalidInput);
}

TEST(Zp, AMultipleOfThePrimeIsZeroOnceItHasTheModulus) {
  const Zp p(largest_prime);
  EXPECT_FALSE(p.is_zero());
  EXPECT_TRUE((p + Zp(sample_modulus(), 0)).is_zero());
  EXPECT_THROW(static_cast<void>(Zp(sample_modulus(), 1) / p), DivisionByZero);
  EXPECT_THROW(static_cast<void>(Zp(sample_modulus(), 1) * (Zp(1) / p)), DivisionByZero);
}

/// A batch and its lanes one by one.
struct Lanes {
  std::array<Zp, Batch::lanes> lane;
  LaneMask undefined = 0;

  explicit Lanes(const Batch& x) : undefined(x.undefined()) {
    for (int i = 0; i < Batch::lanes; ++i) {
      lane[static_cast<std::size_t>(i)] = x.modulus() != nullptr ? Zp(*x.modulus(), x.value(i)) : Zp(0);
    }
  }
};

/// Whether every lane of `r` is f of the lanes of x and y, and undefined where theirs are or where f divides by zero.
template <class F>
testing::AssertionResult lane_by_lane(const Batch& r, const Batch& x, const Batch& y, F f) {
  const Lanes a(x), b(y), c(r);
  LaneMask undefined = a.undefined | b.undefined;
  for (std::size_t i = 0; i < Batch::lanes; ++i) {
    if ((undefined >> i) & 1) continue;
    try {
      if (!(f(a.lane[i], b.lane[i]) - c.lane[i]).is_zero()) return testing::AssertionFailure() << "lane " << i;
    } catch (const DivisionByZero&) {
      undefined |= LaneMask{1} << i;
    }
  }
  if (undefined != c.undefined) return testing::AssertionFailure() << "undefined lanes " << c.undefined;
  return testing::AssertionSuccess();
}

TEST(Batch, WorksLaneByLane) {
  Rng rng(5);
  for (int round = 0; round < 50; ++round) {
    const Batch zero(sample_modulus(), [](int) { return 0U; });
    const Batch x = Samples<Batch>::any(rng) + zero, y = Samples<Batch>::any(rng) + zero;
    EXPECT_TRUE(lane_by_lane(x + y, x, y, [](const Zp& a, const Zp& b) { return a + b; }));
    EXPECT_TRUE(lane_by_lane(x - y, x, y, [](const Zp& a, const Zp& b) { return a - b; }));
    EXPECT_TRUE(lane_by_lane(x * y, x, y, [](const Zp& a, const Zp& b) { return a * b; }));
    EXPECT_TRUE(lane_by_lane(x / y, x, y, [](const Zp& a, const Zp& b) { return a / b; }));
    EXPECT_TRUE(lane_by_lane(-x, x, x, [](const Zp& a, const Zp&) { return -a; }));
    EXPECT_TRUE(lane_by_lane(Batch(7) - x, x, x, [](const Zp& a, const Zp&) { return Zp(7) - a; }));
    EXPECT_TRUE(lane_by_lane(x / Batch(7), x, x, [](const Zp& a, const Zp&) { return a / Zp(7); }));
    EXPECT_TRUE(lane_by_lane(Batch(7) / x, x, x, [](const Zp& a, const Zp&) { return Zp(7) / a; }));
    Batch z = x;
    add_product(z, x, y);
    EXPECT_TRUE(lane_by_lane(z, x, y, [](const Zp& a, const Zp& b) { return a + a * b; }));
  }
}

TEST(Batch, EveryLaneIsAskedForOnce) {
  std::vector<int> asked;
  const Batch batch(sample_modulus(), [&](int i) {
    asked.push_back(i);
    return std::uint64_t{1};
  });
  std::vector<int> lanes(Batch::lanes);
  std::iota(lanes.begin(), lanes.end(), 0);
  EXPECT_EQ(asked, lanes);
}

TEST(Batch, AZeroDivisorUndefinesItsLaneForGood) {
  const Modulus& m = sample_modulus();
  const Batch x(m, [](int i) { return static_cast<std::uint64_t>(i % 2); });
  constexpr LaneMask even = 0x5555555555555555;
  const Batch y = Batch(1) / x;
  EXPECT_EQ(y.undefined(), even);
  EXPECT_EQ(y.nonzero(), ~even);
  EXPECT_EQ((y * Batch(0)).undefined(), even);
  EXPECT_EQ((y - y).undefined(), even);
  EXPECT_EQ((Batch(3) + y).undefined(), even);
  EXPECT_EQ((-y).undefined(), even);
  EXPECT_EQ((Batch(1) / y).undefined(), even);
  EXPECT_EQ((y + Batch(1) / (x - Batch(1))).undefined(), ~LaneMask{0});
  Batch z(5);
  add_product(z, y, y);
  EXPECT_EQ(z.undefined(), even);
  z = x;
  add_product(z, x, y);
  EXPECT_EQ(z.undefined(), even);
  z = Batch(1);
  EXPECT_EQ(z.undefined(), 0U);
}

TEST(Batch, ConstantsDivideLikeLanes) {
  const Batch x(sample_modulus(), [](int) { return 1U; });
  constexpr LaneMask all = ~LaneMask{0};
  EXPECT_EQ((Batch(1) / Batch(0)).undefined(), all);
  EXPECT_EQ((Batch(1) / Batch(0) + x).undefined(), all);
  EXPECT_EQ((x / Batch(0)).undefined(), all);
  EXPECT_EQ((x * (Batch(1) / Batch(largest_prime))).undefined(), all);
  EXPECT_EQ((x / Batch(largest_prime)).undefined(), all);
  EXPECT_EQ((x / Batch(2) * Batch(2) - x).is_zero(), Truth::yes);
  EXPECT_EQ((Batch(1) / Batch(0)).text(), "?");
  EXPECT_EQ(ratio<Batch>(1, 2).text(), "1/2");
}

TEST(Batch, TextShowsTheFirstLanes) {
  const Batch count(sample_modulus(), [](int i) { return static_cast<std::uint64_t>(i) + 3; });
  const Batch odd(sample_modulus(), [](int i) { return static_cast<std::uint64_t>(i % 2); });
  EXPECT_EQ(count.text(), "[3, 4, 5, 6, ...]");
  EXPECT_EQ((count / odd).text(), "[?, 4, ?, 6, ...]");
}

TEST(Batch, ZeroTestSpeaksOfDefinedLanes) {
  const Modulus& m = sample_modulus();
  const Batch ones(m, [](int) { return 1U; });
  const Batch first(m, [](int i) { return i == 0 ? 1U : 0U; });
  const Batch other_lanes_defined = Batch(0) / (ones - first);
  const Batch first_lane_defined = Batch(0) / first;
  EXPECT_EQ(ones.is_zero(), Truth::no);
  EXPECT_EQ((ones - ones).is_zero(), Truth::yes);
  EXPECT_EQ(first.is_zero(), Truth::unknown);
  EXPECT_EQ((first + other_lanes_defined).is_zero(), Truth::yes);
  EXPECT_EQ((first + first_lane_defined).is_zero(), Truth::no);
  EXPECT_EQ((other_lanes_defined + first_lane_defined).is_zero(), Truth::unknown);
  EXPECT_EQ(Batch(0).is_zero(), Truth::yes);
  EXPECT_EQ(Batch(2).is_zero(), Truth::no);
  EXPECT_EQ(first.nonzero(), 1U);
  EXPECT_EQ(Batch(2).nonzero(), ~LaneMask{0});
  EXPECT_EQ(Batch(0).nonzero(), 0U);
}

TEST(Batch, DrawsDifferentLanes) {
  Rng rng(9);
  const Batch x = Batch::draw(sample_modulus(), rng);
  std::set<std::uint64_t> seen;
  for (int i = 0; i < Batch::lanes; ++i) seen.insert(x.value(i));
  EXPECT_EQ(seen.size(), 64U);
  EXPECT_LT(*seen.rbegin(), largest_prime);
}

}  // namespace torse::laws
