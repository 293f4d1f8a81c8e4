// Bernstein polynomials over the rationals against values by hand and against evaluation.
#include "torse/algebra/bernstein.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;

Bernstein<Q> polynomial(const std::vector<int>& numerators, int denominator = 1) {
  std::vector<Q> b;
  for (int x : numerators) b.push_back(ratio<Q>(x, denominator));
  return Bernstein<Q>(std::move(b));
}

const std::vector<Q> parameters{Q(-1), Q(0), ratio<Q>(1, 3), Q(1), ratio<Q>(7, 2)};

TEST(Binomial, SmallAndLarge) {
  EXPECT_EQ(binomial<Q>(5, 2), Q(10));
  EXPECT_EQ(binomial<Q>(5, -1), Q(0));
  EXPECT_EQ(binomial<Q>(5, 6), Q(0));
  EXPECT_EQ(binomial<Q>(61, 30), Q(232714176627630544));
  EXPECT_EQ(binomial<Q>(70, 35), Q(112186277816662845) * Q(1000) + Q(432));  // beyond 64 bits
  for (int n = 62; n <= 80; ++n) {
    EXPECT_EQ(binomial<Q>(n, 0), Q(1));
    for (int k = 1; k <= n; ++k) EXPECT_EQ(binomial<Q>(n, k) * Q(k), binomial<Q>(n - 1, k - 1) * Q(n)) << n << ' ' << k;
  }
}

TEST(Bernstein, ValueByHand) {  // 1 - 2t + 3t^2 has the coefficients 1, 0, 2
  const Bernstein<Q> f = polynomial({1, 0, 2});
  for (const Q& t : parameters) EXPECT_EQ(f(t), Q(1) - Q(2) * t + Q(3) * t * t);
}

TEST(Bernstein, ArithmeticIsPointwise) {
  const Bernstein<Q> f = polynomial({1, 0, 2, 5}, 3);
  const Bernstein<Q> g = polynomial({4, -7});
  EXPECT_EQ((f * g).degree(), 4);
  for (const Q& t : parameters) {
    EXPECT_EQ((f + g)(t), f(t) + g(t));
    EXPECT_EQ((g - f)(t), g(t) - f(t));
    EXPECT_EQ((f * g)(t), f(t) * g(t));
    EXPECT_EQ(f.compose(g)(t), f(g(t)));
    EXPECT_EQ(f.elevated(6)(t), f(t));
  }
  EXPECT_EQ(f.elevated(6).degree(), 6);
}

TEST(Bernstein, FormAndBack) {
  const Bernstein<Q> f = polynomial({1, 0, 2, 5}, 3);
  EXPECT_EQ(f.form()[1], Q(0));
  EXPECT_EQ(f.form()[2], Q(2));
  EXPECT_EQ(Bernstein<Q>::from_form(f.form()).coefficients(), f.coefficients());
}

TEST(Bernstein, Derivative) {  // (1 - 2t + 3t^2)' = -2 + 6t
  const Bernstein<Q> df = polynomial({1, 0, 2}).derivative();
  EXPECT_EQ(df.degree(), 1);
  for (const Q& t : parameters) EXPECT_EQ(df(t), Q(-2) + Q(6) * t);
  EXPECT_EQ(polynomial({4}).derivative().coefficients(), (std::vector<Q>{Q(0)}));
}

TEST(Bernstein, Subdivision) {
  const Bernstein<Q> f = polynomial({1, -4, 2, 5}, 3);
  const Q cut = ratio<Q>(2, 5);
  const auto [left, right] = f.subdivide(cut);
  for (const Q& t : parameters) {
    EXPECT_EQ(left(t), f(cut * t));
    EXPECT_EQ(right(t), f(cut + (Q(1) - cut) * t));
  }
}

TEST(Bernstein, Zero) {
  EXPECT_TRUE(definitely(polynomial({0, 0, 0}).zero()));
  EXPECT_FALSE(possibly(polynomial({0, 0, 1}).zero()));
  const Bernstein<Q> f = polynomial({1, 0, 2});
  EXPECT_TRUE(definitely((f.elevated(5) - f).zero()));
}

}  // namespace
}  // namespace torse
