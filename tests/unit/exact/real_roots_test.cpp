// Isolation of real roots: polynomials made from known roots, and sign changes as the independent proof of an interval.
#include "torse/exact/roots/real_roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "torse/exact/roots/integer_polynomial.hpp"

namespace torse {
namespace {

Rational q(const char* text) { return Rational::from_text(text); }

std::vector<Rational> product(const std::vector<Rational>& f, const std::vector<Rational>& g) {
  std::vector<Rational> h(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) h[i + j] += f[i] * g[j];
  }
  return h;
}

Rational value(const std::vector<Rational>& f, const Rational& x) {
  Rational y;
  for (std::size_t i = f.size(); i-- > 0;) y = y * x + f[i];
  return y;
}

std::vector<Rational> linear(const char* root) { return {-q(root), Rational(1)}; }

TEST(RealRoots, RationalRootsAreExactAndCountOnce) {
  std::vector<Rational> f{q("-3/7")};
  for (const char* root :
       {"5/3", "-2/7", "5/3", "0", "-2/7", "5/3", "1000000000000000000001/1000000000000000000000", "1"}) {
    f = product(f, linear(root));
  }
  std::vector<std::string> found;
  for (const RealRoot& root : real_roots(f, 32)) {
    EXPECT_TRUE(root.rational());
    found.push_back(root.lower.text());
  }
  const std::vector<std::string> expected{"-2/7", "0", "1", "1000000000000000000001/1000000000000000000000", "5/3"};
  EXPECT_EQ(found, expected);
}

TEST(RealRoots, IrrationalRootsAreIsolatedByASignChange) {
  // (x^2 - 2)(x^2 + 1)(x - 3/2): the conjugate pair is left out, 3/2 lies close to the square root of 2.
  const std::vector<Rational> f = product(product({q("-2"), q("0"), q("1")}, {q("1"), q("0"), q("1")}), linear("3/2"));
  const std::vector<RealRoot> roots = real_roots(f, 100);
  ASSERT_EQ(roots.size(), 3U);
  for (std::size_t i : {0U, 1U}) {
    EXPECT_FALSE(roots[i].rational());
    EXPECT_LT((value(f, roots[i].lower) * value(f, roots[i].upper)).sign(), 0);
    const Rational width = roots[i].upper - roots[i].lower;
    EXPECT_LT(width, q("1/1000000000000000000000000000000"));  // 10^-30 < 2^(1/2) 2^-99
  }
  EXPECT_LT(roots[0].upper.sign(), 0);
  EXPECT_EQ(roots[2].lower, q("3/2"));
}

TEST(RealRoots, RationalRootWithALargeDenominatorIsNotTakenForAnInterval) {
  const std::vector<Rational> f =
      product(linear("1/123456789012345678901234567890123456789"), {q("-2"), q("0"), q("1")});
  const std::vector<RealRoot> roots = real_roots(f, 8);
  ASSERT_EQ(roots.size(), 3U);
  EXPECT_EQ(roots[1].lower, q("1/123456789012345678901234567890123456789"));
  EXPECT_TRUE(roots[1].rational());
}

TEST(RealRoots, CloseIrrationalRootsStayApart) {
  // (x^2 - 2)(x^2 - 2 - 10^-40)
  const std::vector<Rational> f =
      product({q("-2"), q("0"), q("1")}, {q("-2") - q("1/10000000000000000000000000000000000000000"), q("0"), q("1")});
  const std::vector<RealRoot> roots = real_roots(f, 16);
  ASSERT_EQ(roots.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(roots[i - 1].upper, roots[i].lower);
}

/// (x^2 - 2)(x^2 - 2 - h) with h = 2^-20000: as many halvings as h has bits would part the two positive roots.
TEST(RealRoots, HoweverNearTheyAre) {
  Rational h(1);
  for (int i = 0; i < 20000; ++i) h /= Rational(2);
  const Rational two(2);
  const Rational more = two + h;
  const std::vector<Rational> f = product({-two, Rational(0), Rational(1)}, {-more, Rational(0), Rational(1)});
  const std::vector<RealRoot> roots = real_roots(f, 1);
  ASSERT_EQ(roots.size(), 4U);
  const std::array<Rational, 4> squares{more, two, two, more};
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational lower = roots[i].lower * roots[i].lower;
    const Rational upper = roots[i].upper * roots[i].upper;
    EXPECT_TRUE(std::min(lower, upper) < squares[i] && squares[i] < std::max(lower, upper)) << i;
    const Rational& other = i % 3 == 0 ? two : more;
    EXPECT_FALSE(std::min(lower, upper) <= other && other <= std::max(lower, upper)) << i;
  }
  EXPECT_LT(roots[2].upper, roots[3].lower);
}

TEST(RealRoots, RoundingDoesNotJoinCloseRoots) {
  // Mignotte's polynomial x^8 - 2 (1000 x - 1)^2 has two roots within 2^-48 of 1/1000 and of each other.
  const std::vector<Rational> f{q("-2"), q("4000"), q("-2000000"), q("0"), q("0"), q("0"), q("0"), q("0"), q("1")};
  const std::vector<RealRoot> roots = real_roots(f, 8);
  ASSERT_EQ(roots.size(), 4U);
  for (const RealRoot& root : roots) EXPECT_LT((value(f, root.lower) * value(f, root.upper)).sign(), 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(roots[i - 1].upper, roots[i].lower);
}

TEST(RealRoots, IrrationalRootsNextToIntegersAreNotTakenForThem) {
  Rational power(1);
  for (int digits = 1; digits <= 40; ++digits) {  // x^2 = 10^(2 digits) + 1
    power *= Rational(10);
    const std::vector<RealRoot> roots = real_roots({-(power * power + Rational(1)), Rational(0), Rational(1)}, 8);
    ASSERT_EQ(roots.size(), 2U);
    EXPECT_FALSE(roots[1].rational()) << digits;
  }
}

Rational power_of_ten(int exponent) {
  Rational power(1);
  for (int i = 0; i < std::abs(exponent); ++i) power *= Rational(10);
  return exponent < 0 ? Rational(1) / power : power;
}

/// Roots 10^e 3/7 and +-10^e sqrt(2) for exponents e from -1500 to 1500, the ends of the range of a long double and
/// more.
TEST(RealRoots, OfAllSizesTogether) {
  const std::vector<int> exponents{-1500, -1000, -300, 0, 1, 300, 1500};
  std::vector<Rational> f{Rational(1)};
  for (const int e : exponents) {
    f = product(f, {q("-3/7") * power_of_ten(e), Rational(1)});
    f = product(f, {Rational(-2) * power_of_ten(2 * e), Rational(0), Rational(1)});
  }
  const std::vector<RealRoot> roots = real_roots(f, 64);
  ASSERT_EQ(roots.size(), 3 * exponents.size());
  std::size_t i = exponents.size();  // the negative ones come first
  for (const int e : exponents) {
    EXPECT_EQ(roots[i].lower, q("3/7") * power_of_ten(e));
    EXPECT_EQ(roots[i].upper, roots[i].lower);
    const RealRoot& root = roots[i + 1];
    const Rational square = Rational(2) * power_of_ten(2 * e);
    EXPECT_LT(root.lower * root.lower, square);
    EXPECT_GT(root.upper * root.upper, square);
    EXPECT_LE((root.upper - root.lower) * power_of_ten(19), root.lower);  // 2^-64 < 10^-19
    i += 2;
  }
}

/// As many roots as Sturm's theorem counts, each with a sign change or exact.
TEST(RealRoots, AsManyAsSturmCounts) {
  std::mt19937_64 rng(1);
  for (int degree = 1; degree <= 24; ++degree) {
    for (const int spread : {1, 5, 1000}) {
      std::vector<Rational> f;
      for (int i = 0; i < degree; ++i)
        f.emplace_back(static_cast<int>(rng() % static_cast<unsigned>(2 * spread + 1)) - spread);
      f.emplace_back(1 + static_cast<int>(rng() % static_cast<unsigned>(spread)));
      if (rng() % 2 == 0) f = product(f, linear("5/3"));
      const IntegerPolynomial simple = square_free(f);
      std::vector<Rational> g;
      for (slong i = 0; i <= simple.degree(); ++i) {
        char* text = fmpz_get_str(nullptr, 10, simple.coefficient(i));
        g.push_back(q(text));
        flint_free(text);
      }
      const std::vector<RealRoot> roots = real_roots(f, 20);
      EXPECT_EQ(static_cast<slong>(roots.size()), fmpz_poly_num_real_roots_sturm(simple.get()));
      for (const RealRoot& root : roots) {
        EXPECT_EQ((value(g, root.lower) * value(g, root.upper)).sign(), root.rational() ? 0 : -1);
      }
      for (std::size_t i = 1; i < roots.size(); ++i) EXPECT_LT(roots[i - 1].upper, roots[i].lower);
    }
  }
}

/// A linear factor with numbers of thousands of digits, which no short fraction comes near.
/// One change of sign, so one positive root (Descartes); at 1.25 of the least that the coefficients allow.
TEST(RealRoots, TheOnlyPositiveOneWhereItIsLarge) {
  const std::vector<RealRoot> roots = real_roots({q("-7"), q("-7"), q("-7"), q("-7"), q("-7"), q("0"), q("16")}, 20);
  EXPECT_EQ(std::ranges::count_if(roots, [](const RealRoot& x) { return x.upper.sign() > 0; }), 1);
  for (int degree = 2; degree <= 12; ++degree) {
    for (int lead = 1; lead <= 4096; lead *= 2) {
      for (const bool reversed : {false, true}) {
        std::vector<Rational> f(static_cast<std::size_t>(degree), Rational(-7));
        f.emplace_back(lead);
        if (reversed) std::ranges::reverse(f);
        const std::vector<RealRoot> found = real_roots(f, 20);
        EXPECT_EQ(std::ranges::count_if(found, [](const RealRoot& x) { return x.upper.sign() > 0; }), 1)
            << degree << ' ' << lead;
      }
    }
  }
}

TEST(RealRoots, RationalOnesOfAnyHeight) {
  const Rational x = (power_of_ten(3000) + Rational(7)) / (power_of_ten(2999) * Rational(3) + Rational(1));
  const std::vector<RealRoot> roots = real_roots(product({-x, Rational(1)}, {q("-11"), q("0"), q("1")}), 8);
  ASSERT_EQ(roots.size(), 3U);
  EXPECT_FALSE(roots[1].rational());  // 11^(1/2) = 3.316..., x = 3.333...
  EXPECT_EQ(roots[2].lower, x);
  EXPECT_TRUE(roots[2].rational());
}

TEST(RealRoots, ConstantsAndZero) {
  EXPECT_TRUE(real_roots({q("7")}, 10).empty());
  EXPECT_TRUE(real_roots({q("1"), q("0"), q("1")}, 10).empty());
  EXPECT_TRUE(real_roots({q("7"), q("0"), q("0")}, 10).empty());
  EXPECT_THROW(real_roots({}, 10), InvalidInput);
  try {
    real_roots({q("0"), q("0")}, 10);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place(), "coefficients");
  }
}

TEST(RealRoots, NegativeOnesHaveTheirEndsInOrder) {
  const std::vector<RealRoot> roots = real_roots({Rational(-2), Rational(0), Rational(1)}, 40);  // x^2 - 2
  ASSERT_EQ(roots.size(), 2U);
  for (const RealRoot& x : roots) {
    EXPECT_LT(x.lower, x.upper);
    EXPECT_EQ(x.lower.sign(), x.upper.sign());
    EXPECT_EQ((x.lower * x.lower - Rational(2)).sign(), -(x.upper * x.upper - Rational(2)).sign());
  }
  EXPECT_LT(roots[0].upper.sign(), 0);
  EXPECT_GT(roots[1].lower.sign(), 0);
}

}  // namespace
}  // namespace torse
