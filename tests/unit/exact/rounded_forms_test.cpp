// The error bounds of products of forms in doubles, against the exact products.
#include "torse/exact/warp/rounded_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "torse/algebra/bernstein.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;

/// Random doubles as exact forms.
RoundedForms<3> random_forms(int degree, std::mt19937_64& rng) {
  RoundedForms<3> x(degree);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= degree; ++i) x.at(j, i) = static_cast<double>(rng() >> 11) * 0x1p-52 - 1;
  }
  x.close(0);
  return x;
}

TEST(RoundedForms, AreZeroExactlyAtFirst) {
  const RoundedForms<2> x(3);
  EXPECT_EQ(x.radius(), 0);
  EXPECT_EQ(x.norm(), 0);
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i <= 3; ++i) EXPECT_EQ(x.at(j, i), 0);
  }
}

template <int K>
BinaryForm<Q> exact(const RoundedForms<K>& x, int j) {
  BinaryForm<Q> f(x.degree());
  for (int i = 0; i <= x.degree(); ++i) f[i] = Q::from_double(x.at(j, i));
  return f;
}

/// Whether form j is within its radius of the exact one, which is within the norm. Counts the inexact coefficients.
template <int K>
void expect_enclosed(const RoundedForms<K>& x, int j, const BinaryForm<Q>& value, int& inexact) {
  const auto magnitude = [](const Q& q) { return q.sign() < 0 ? -q : q; };
  for (int i = 0; i <= x.degree(); ++i) {
    const Q choose = binomial<Q>(x.degree(), i);
    const Q error = magnitude(Q::from_double(x.at(j, i)) - value[i]);
    EXPECT_LE(error, choose * Q::from_double(x.radius()));
    EXPECT_LE(magnitude(value[i]), choose * Q::from_double(x.norm()));
    if (error.sign() > 0) ++inexact;
  }
}

/// 2^-600 times itself is 2^-1200, which is 0 in doubles, but not in the bound.
TEST(RoundedForms, WhatUnderflowsIsInTheRadius) {
  RoundedForms<3> x(2);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= 2; ++i) x.at(j, i) = std::ldexp(1.0 + i, -600 - j);
  }
  x.close(0);
  const RoundedForms<1> square = rounded_dot(x, x);
  for (int i = 0; i <= 4; ++i) EXPECT_EQ(square.at(0, i), 0);
  EXPECT_GT(square.radius(), 0);
}

TEST(RoundedForms, EncloseTheExactProducts) {
  std::mt19937_64 rng(4);
  int inexact = 0;
  for (int round = 0; round < 200; ++round) {
    const RoundedForms<3> x = random_forms(static_cast<int>(rng() % 6), rng);
    const RoundedForms<3> y = random_forms(static_cast<int>(rng() % 6), rng);
    expect_enclosed(rounded_dot(x, y), 0,
                    exact(x, 0) * exact(y, 0) + exact(x, 1) * exact(y, 1) + exact(x, 2) * exact(y, 2), inexact);
    const RoundedForms<3> product = rounded_cross(x, y);
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      expect_enclosed(product, j, exact(x, k) * exact(y, l) - exact(x, l) * exact(y, k), inexact);
    }
    const RoundedForms<1> squares = rounded_dot(x, x);
    const RoundedForms<1> fourth = rounded_dot(squares, squares);
    const BinaryForm<Q> norm = exact(x, 0) * exact(x, 0) + exact(x, 1) * exact(x, 1) + exact(x, 2) * exact(x, 2);
    expect_enclosed(fourth, 0, norm * norm, inexact);
    expect_enclosed(rounded_sum(fourth, -1, fourth), 0, BinaryForm<Q>(fourth.degree()), inexact);
  }
  EXPECT_GT(inexact, 1000);
}

/// Form 0 alone, times a double, exact.
RoundedForms<1> first(const RoundedForms<3>& x, double factor) {
  RoundedForms<1> f(x.degree());
  for (int i = 0; i <= x.degree(); ++i) f.at(0, i) = factor * x.at(0, i);
  f.close(0);
  return f;
}

TEST(RoundedForms, EncloseTheExactSumsOfExactForms) {
  std::mt19937_64 rng(5);
  int inexact = 0;
  for (int round = 0; round < 200; ++round) {
    const int degree = static_cast<int>(rng() % 6);
    const double size = std::ldexp(1, static_cast<int>(rng() % 41) - 20);
    const RoundedForms<1> x = first(random_forms(degree, rng), size);
    const RoundedForms<1> y = first(random_forms(degree, rng), size * 0x1.8p-9);
    for (const double sign : {1.0, -1.0}) {
      const BinaryForm<Q> value = sign > 0 ? exact(x, 0) + exact(y, 0) : exact(x, 0) - exact(y, 0);
      expect_enclosed(rounded_sum(x, sign, y), 0, value, inexact);
      expect_enclosed(rounded_sum(y, sign, x), 0, sign > 0 ? value : exact(y, 0) - exact(x, 0), inexact);
    }
  }
  EXPECT_GT(inexact, 500);
}

/// The forms (s + t)^degree times `size`, known up to `radius`: a constant, whose error may be the same everywhere.
template <int K>
RoundedForms<K> constant(int degree, double size, double radius) {
  RoundedForms<K> x(degree);
  for (int j = 0; j < K; ++j) {
    for (int i = 0; i <= degree; ++i) x.at(j, i) = size * binomial<Q>(degree, i).to_double();
  }
  x.close(radius);
  return x;
}

/// With errors that add up: (x + r)(y + s) - x y = r y + x s + r s in each product of two forms.
TEST(RoundedForms, AllErrorsOfTheOperandsAreInherited) {
  for (const auto& [r, s] : {std::pair{0x1p-10, 0.0}, {0.0, 0x1p-10}, {0x1p-10, 0x1p-12}}) {
    const double x = 3, y = 0.5;
    const double product = r * y + x * s + r * s;
    EXPECT_GE(rounded_dot(constant<1>(2, x, r), constant<1>(3, y, s)).radius(), product);
    EXPECT_GE(rounded_dot(constant<3>(2, x, r), constant<3>(3, y, s)).radius(), 3 * product);
    EXPECT_GE(rounded_cross(constant<3>(2, x, r), constant<3>(3, y, s)).radius(), 2 * (product - r * s));
    EXPECT_GE(rounded_minors(constant<4>(2, x, r), constant<4>(3, y, s)).radius(), 2 * (product - r * s));
    EXPECT_GE(rounded_sum(constant<1>(2, x, r), -1, constant<1>(2, y, s)).radius(), r + s);
    EXPECT_GE(rounded_dot(constant<1>(2, x, r), constant<1>(3, y, s)).norm(), (x + r) * (y + s));
    EXPECT_LE(rounded_dot(constant<1>(2, x, r), constant<1>(3, y, s)).radius(), product * (1 + 0x1p-9));
  }
}

}  // namespace
}  // namespace torse
