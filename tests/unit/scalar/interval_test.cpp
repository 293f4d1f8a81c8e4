// Bounds by doubles: compared with exact rationals, and by hand where a double is infinite or its error underflows.
#include "torse/scalar/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;

constexpr double inf = detail::infinity;
constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr double largest = std::numeric_limits<double>::max();

Q exact(double x) { return Q::from_double(x); }
double above(double x) { return std::nextafter(x, inf); }

/// Doubles of either sign with few or many bits, of sizes from 2^-300 to 2^300.
std::vector<double> doubles(int count) {
  std::mt19937_64 random(11);
  std::vector<double> list{1, -1, 3, -0.1};
  while (static_cast<int>(list.size()) < count) {
    const auto bits = static_cast<double>(random() >> (random() % 60));
    const int power = static_cast<int>(random() % 537) - 300;
    const double x = std::ldexp(random() % 2 == 0 ? bits : -bits, power);
    if (x != 0) list.push_back(x);
  }
  return list;
}

/// The largest double that is not above it.
void expect_largest_below(double bound, const Q& value) {
  EXPECT_TRUE(exact(bound) <= value) << bound;
  EXPECT_TRUE(value < exact(above(bound))) << bound;
}

TEST(Interval, LowerBoundsAreTheLargestOnes) {
  const std::vector<double> list = doubles(80);
  int exact_ones = 0;
  for (double a : list) {
    for (double b : list) {
      expect_largest_below(lower_sum(a, b), exact(a) + exact(b));
      expect_largest_below(lower_product(a, b), exact(a) * exact(b));
      expect_largest_below(lower_quotient(a, b), exact(a) / exact(b));
      exact_ones += exact(lower_product(a, b)) == exact(a) * exact(b) ? 1 : 0;
    }
  }
  EXPECT_GT(exact_ones, 100);
}

TEST(Interval, RootsAreBetweenNeighbours) {
  int exact_ones = 0;
  std::vector<double> list = doubles(300);
  for (int i = 1; i < 40; ++i) list.push_back(i * i);
  for (double x : list) {
    const double a = std::abs(x);
    const double lower = lower_root(a);
    const double upper = upper_root(a);
    EXPECT_TRUE(exact(lower) * exact(lower) <= exact(a)) << a;
    EXPECT_TRUE(exact(a) <= exact(upper) * exact(upper)) << a;
    EXPECT_EQ(upper, exact(lower) * exact(lower) == exact(a) ? lower : above(lower)) << a;
    exact_ones += upper == lower ? 1 : 0;
  }
  EXPECT_GT(exact_ones, 39);
  EXPECT_EQ(lower_root(0), 0);
  EXPECT_EQ(upper_root(0), 0);
  EXPECT_EQ(lower_root(inf), inf);
  EXPECT_EQ(upper_root(inf), inf);
}

/// From 2^-960 on the error of a product is a double; below, the bound is one double lower.
TEST(Interval, TinyResults) {
  EXPECT_EQ(lower_product(0x1p-480, 0x1p-480), 0x1p-960);
  EXPECT_EQ(above(lower_product(0x1p-480, 0x1p-481)), 0x1p-961);
  EXPECT_EQ(lower_product(denormal, 0.25), -denormal);
  EXPECT_EQ(lower_quotient(0x1p-480, 0x1p480), 0x1p-960);
  EXPECT_EQ(above(lower_quotient(0x1p-481, 0x1p480)), 0x1p-961);
  EXPECT_EQ(above(lower_quotient(0x1p-1000, 0x1p-1000)), 1);
  EXPECT_EQ(lower_quotient(-denormal, 4), -denormal);
  EXPECT_EQ(above(lower_root(0x1p-1000)), 0x1p-500);
  EXPECT_EQ(upper_root(0x1p-1000), above(0x1p-500));
}

TEST(Interval, OverflowIsNoInfinity) {
  EXPECT_EQ(lower_sum(largest, largest), largest);
  EXPECT_EQ(lower_product(largest, 2), largest);
  EXPECT_EQ(lower_quotient(largest, 0.5), largest);
  EXPECT_EQ(lower_sum(-largest, -largest), -inf);
  EXPECT_EQ(lower_product(-largest, 2), -inf);
}

TEST(Interval, InfiniteEnds) {
  EXPECT_EQ(lower_sum(-inf, 3), -inf);
  EXPECT_EQ(lower_product(-2, inf), -inf);
  EXPECT_EQ(lower_product(inf, -2), -inf);
  EXPECT_EQ(lower_product(-2, -inf), inf);
  EXPECT_EQ(lower_product(-inf, 2), -inf);
  EXPECT_EQ(lower_product(0, inf), 0);
  EXPECT_EQ(lower_product(-inf, 0), 0);
  EXPECT_EQ(lower_quotient(inf, -2), -inf);
  EXPECT_EQ(lower_quotient(inf, 2), inf);
  EXPECT_EQ(lower_quotient(-inf, 2), -inf);
  EXPECT_EQ(lower_quotient(inf, inf), -inf);
  EXPECT_EQ(lower_quotient(-inf, inf), -inf);
  EXPECT_EQ(lower_quotient(3, inf), -denormal);
  EXPECT_EQ(lower_quotient(3, -inf), -denormal);
  EXPECT_EQ(lower_quotient(0, inf), 0);
}

TEST(Interval, NoEndIsANegativeZero) {
  for (const Interval& x : {Interval(1) - Interval(1), -Interval(0), Interval::point(-0.0)}) {
    EXPECT_FALSE(std::signbit(x.lower()));
    EXPECT_FALSE(std::signbit(x.upper()));
  }
}

}  // namespace
}  // namespace torse
