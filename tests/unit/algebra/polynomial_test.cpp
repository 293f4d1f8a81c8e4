// Polynomials and rational functions of t: values at points, FLINT, and products of known factors are the independent
// paths.
#include "torse/algebra/polynomial_fraction.hpp"

#include <gmp.h>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "torse/exact/modular/zp.hpp"
#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using Poly = Polynomial<Q>;
using Ratio = PolynomialFraction<Q>;

Poly poly(const std::vector<int>& coefficients) {
  std::vector<Q> a;
  for (int x : coefficients) a.push_back(Q(x));
  return Poly(std::move(a));
}

Poly random_poly(std::mt19937_64& rng, int degree) {
  std::vector<Q> a;
  for (int i = 0; i <= degree; ++i)
    a.push_back(Q(static_cast<int>(rng() % 41) - 20) / Q(static_cast<int>(rng() % 6) + 1));
  return Poly(std::move(a));
}

/// The monic greatest common divisor by FLINT.
Poly flint_gcd(const Poly& f, const Poly& g) {
  fmpq_poly_t x, y;
  fmpq_t c;
  mpq_t m;
  fmpq_poly_init(x);
  fmpq_poly_init(y);
  fmpq_init(c);
  mpq_init(m);
  const auto set = [&](fmpq_poly_t into, const Poly& from) {
    for (int i = 0; i <= from.degree(); ++i) {
      fmpq_set_mpq(c, from[i].mpq());
      fmpq_poly_set_coeff_fmpq(into, i, c);
    }
  };
  set(x, f);
  set(y, g);
  fmpq_poly_gcd(x, x, y);
  std::vector<Q> a;
  for (slong i = 0; i < fmpq_poly_length(x); ++i) {
    fmpq_poly_get_coeff_fmpq(c, x, i);
    fmpq_get_mpq(m, c);
    a.push_back(Q::from_mpq(m));
  }
  mpq_clear(m);
  fmpq_clear(c);
  fmpq_poly_clear(x);
  fmpq_poly_clear(y);
  return Poly(std::move(a));
}

TEST(Polynomial, HasNoLeadingZeros) {
  EXPECT_EQ(poly({1, 2, 0, 0}).degree(), 1);
  EXPECT_EQ((poly({1, 2, 3}) - poly({4, 5, 3})).degree(), 1);
  EXPECT_EQ(Poly().degree(), -1);
  EXPECT_TRUE(poly({0, 0}).zero());
  EXPECT_TRUE((poly({3, 1}) - poly({3, 1})).zero());
}

TEST(Polynomial, ValuesDerivativesAndCompositions) {
  std::mt19937_64 rng(5);
  for (int round = 0; round < 30; ++round) {
    const Poly f = random_poly(rng, 4), g = random_poly(rng, 3);
    const Q x = ratio<Q>(static_cast<int>(rng() % 50) - 25, 7);
    EXPECT_EQ((f * g)(x), f(x) * g(x));
    EXPECT_EQ(f.compose(g)(x), f(g(x)));
    // f(t + x) = f(x) + f'(x) t + ...
    const Poly shifted = f.compose(Poly(std::vector<Q>{x, Q(1)}));
    EXPECT_EQ(shifted[0], f(x));
    EXPECT_EQ(shifted[1], f.derivative()(x));
  }
}

TEST(Polynomial, DivisionLeavesASmallerRest) {
  std::mt19937_64 rng(6);
  for (int round = 0; round < 40; ++round) {
    const Poly f = random_poly(rng, static_cast<int>(rng() % 7)),
               g = random_poly(rng, static_cast<int>(rng() % 4)) + poly({0, 0, 0, 0, 1});
    const Division<Q> d = divide_with_rest(f, g);
    EXPECT_TRUE(d.quotient * g + d.rest == f);
    EXPECT_LT(d.rest.degree(), g.degree());
  }
  EXPECT_THROW(divide_with_rest(poly({1, 2}), Poly()), DivisionByZero);
}

TEST(Polynomial, GreatestCommonDivisorAgreesWithFlint) {
  std::mt19937_64 rng(7);
  for (int round = 0; round < 60; ++round) {
    const Poly common = random_poly(rng, static_cast<int>(rng() % 4));
    const Poly f = random_poly(rng, static_cast<int>(rng() % 5)) * common;
    const Poly g = random_poly(rng, static_cast<int>(rng() % 5)) * common;
    EXPECT_TRUE(gcd(f, g) == flint_gcd(f, g)) << as_text(f) << " and " << as_text(g);
  }
  EXPECT_TRUE(gcd(Poly(), Poly()).zero());
  EXPECT_TRUE(gcd(Poly(), poly({2, 4})) == Poly(std::vector<Q>{ratio<Q>(1, 2), Q(1)}));
}

TEST(Polynomial, EuclidAgreesWithTheFieldsOwnAlgorithm) {
  std::mt19937_64 rng(9);
  const auto copy = [](const Poly& f) {
    std::vector<CppRational> a;
    for (const Q& x : f.coefficients()) a.push_back(CppRational::from_text(x.text()));
    return Polynomial<CppRational>(std::move(a));
  };
  for (int round = 0; round < 40; ++round) {
    const Poly common = random_poly(rng, static_cast<int>(rng() % 4));
    const Poly f = random_poly(rng, static_cast<int>(rng() % 5)) * common, g = random_poly(rng, 3) * common;
    EXPECT_TRUE(gcd(copy(f), copy(g)) == copy(gcd(f, g))) << as_text(f) << " and " << as_text(g);
  }
}

TEST(Polynomial, SquareFreePartHasEachRootOnce) {
  const Poly one = poly({-1, 1}), two = poly({-2, 1}), no_root = poly({1, 0, 1});
  EXPECT_TRUE(square_free_part(one * one * one * two * two * no_root * poly({7})) == one * two * no_root);
  EXPECT_TRUE(square_free_part(poly({5})) == poly({1}));
}

TEST(Polynomial, AlsoOverAPrimeField) {
  const Modulus prime((std::uint64_t{1} << 63) - 25);
  using P = Polynomial<Zp>;
  const auto linear = [&](std::uint64_t constant, std::uint64_t slope) {
    return P(std::vector<Zp>{Zp(prime, constant), Zp(prime, slope)});
  };
  const P a = linear(3, 1), b = linear(5, 2), c = linear(1, 1);
  EXPECT_TRUE(gcd(a * b, c * a) == a);
}

TEST(Polynomial, Text) {
  EXPECT_EQ(as_text(Poly()), "0");
  EXPECT_EQ(as_text(poly({0, -1})), "-t");
  EXPECT_EQ(as_text(Poly(std::vector<Q>{Q(-5), Q(0), Q(1), ratio<Q>(3, 2)})), "3/2 t^3 + t^2 - 5");
  EXPECT_EQ(as_text(Ratio(poly({1, 2}), poly({0, 2}))), "(t + 1/2)/(t)");
  EXPECT_EQ(as_text(Ratio(poly({1, 2}))), "2 t + 1");
  const Polynomial<Ratio> nested(std::vector<Ratio>{Ratio(3), Ratio(), Ratio(poly({1, 2}))});
  EXPECT_EQ(as_text(nested), "(2 t + 1) t^2 + 3");
}

TEST(Polynomial, TimesZeroIsTheZeroPolynomial) {
  EXPECT_TRUE(poly({1, 2}).scale(Q(0)).zero());
  EXPECT_EQ(poly({1, 2}).scale(Q(0)).degree(), -1);
  EXPECT_TRUE(poly({1, 2}).scale(Q(3)) == poly({3, 6}));
}

TEST(Polynomial, CommonDivisorOfAList) {
  const Poly x = poly({0, 1});
  const Poly y = poly({-1, 1});
  const Poly z = poly({-2, 1});
  EXPECT_TRUE(common_divisor(std::vector<Poly>{x * y, x * z, x}) == x);
  EXPECT_TRUE(common_divisor(std::vector<Poly>{x, y, x}) == poly({1}));
  EXPECT_TRUE(common_divisor(std::vector<Poly>{Poly(), x * y, poly({0, -3, 3})}) == x * y);
  EXPECT_TRUE(common_divisor(std::vector<Poly>{}).zero());
}

TEST(PolynomialFraction, IsReducedWithMonicDenominator) {
  const Ratio x(poly({-2, 0, 2}), poly({3, -3}));  // 2 (t-1)(t+1) / -3 (t-1)
  EXPECT_TRUE(x.denominator() == poly({1}));
  EXPECT_TRUE(x == Ratio(poly({-2, -2}), poly({3})));
  EXPECT_EQ(x(Q(1)), ratio<Q>(-4, 3));
  EXPECT_EQ(Ratio(poly({4, 2}), poly({6, 3})).constant_value(), ratio<Q>(2, 3));
  EXPECT_EQ(Ratio(Poly(), poly({6, 3})).constant_value(), Q(0));
  EXPECT_FALSE(Ratio(poly({1}), poly({6, 3})).constant_value());
  EXPECT_THROW(Ratio(poly({1}), Poly()), DivisionByZero);
  EXPECT_THROW(Ratio(poly({1}), poly({6, 3}))(Q(-2)), DivisionByZero);
}

TEST(PolynomialFraction, AnIntegerIsOverOne) {
  EXPECT_TRUE(Ratio(3).numerator() == poly({3}));
  EXPECT_TRUE(Ratio(3).denominator() == poly({1}));
  EXPECT_TRUE(Ratio().denominator() == poly({1}));
}

TEST(PolynomialFraction, ValueIsAHomomorphism) {
  std::mt19937_64 rng(8);
  for (int round = 0; round < 30; ++round) {
    const Ratio x(random_poly(rng, 3), random_poly(rng, 2) + poly({0, 0, 0, 1}));
    const Ratio y(random_poly(rng, 2), random_poly(rng, 1) + poly({0, 0, 1}));
    const Q t = ratio<Q>(1000003, 7);
    EXPECT_EQ((x + y)(t), x(t) + y(t));
    EXPECT_EQ((x * y)(t), x(t) * y(t));
    EXPECT_EQ((x - y)(t), x(t) - y(t));
    ASSERT_FALSE(definitely(is_zero(y)));
    EXPECT_EQ((x / y)(t), x(t) / y(t));
  }
}

}  // namespace
}  // namespace torse
