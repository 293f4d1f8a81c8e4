// Isolation of real roots: polynomials made from known roots, and sign changes as the independent proof of an interval.
#include "torse/exact/roots/real_roots.hpp"

#include <gtest/gtest.h>

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

TEST(RealRoots, ConstantsAndZero) {
  EXPECT_TRUE(real_roots({q("7")}, 10).empty());
  EXPECT_TRUE(real_roots({q("1"), q("0"), q("1")}, 10).empty());
  EXPECT_TRUE(real_roots({q("7"), q("0"), q("0")}, 10).empty());
  EXPECT_THROW(real_roots({}, 10), InvalidInput);
  EXPECT_THROW(real_roots({q("0"), q("0")}, 10), InvalidInput);
}

}  // namespace
}  // namespace torse
