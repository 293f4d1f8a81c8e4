// Homogeneous polynomials in two variables: products by hand, Euler's identity, evaluation.
#include "torse/algebra/binary_form.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;

BinaryForm<Q> form(const std::vector<int>& coefficients) {
  std::vector<Q> f;
  for (int x : coefficients) f.push_back(Q(x));
  return BinaryForm<Q>(std::move(f));
}

TEST(BinaryForm, ValueByHand) {  // s^2 - 3 s t + 2 t^2 at (2, 5)
  EXPECT_EQ(form({1, -3, 2})(Q(2), Q(5)), Q(24));
  EXPECT_EQ(form({7})(Q(2), Q(5)), Q(7));
}

TEST(BinaryForm, ProductByHand) {  // (s - t)(s - 2t) = s^2 - 3 s t + 2 t^2
  const BinaryForm<Q> f = form({1, -1}) * form({1, -2});
  ASSERT_EQ(f.degree(), 2);
  EXPECT_EQ(f[0], Q(1));
  EXPECT_EQ(f[1], Q(-3));
  EXPECT_EQ(f[2], Q(2));
}

TEST(BinaryForm, SumAndMultiple) {
  const BinaryForm<Q> f = form({1, -3, 2});
  const BinaryForm<Q> g = form({4, 0, 5});
  EXPECT_EQ((f + g)(Q(2), Q(5)), f(Q(2), Q(5)) + g(Q(2), Q(5)));
  EXPECT_EQ((f - g)(Q(2), Q(5)), f(Q(2), Q(5)) - g(Q(2), Q(5)));
  EXPECT_EQ((Q(3) * f)(Q(2), Q(5)), Q(72));
}

TEST(BinaryForm, DerivativesByHand) {  // s^2 - 3 s t + 2 t^2: 2s - 3t and -3s + 4t
  const BinaryForm<Q> f = form({1, -3, 2});
  EXPECT_EQ(f.derivative_s()(Q(2), Q(5)), Q(-11));
  EXPECT_EQ(f.derivative_t()(Q(2), Q(5)), Q(14));
  EXPECT_TRUE(definitely(form({7}).derivative_s().zero()));
  EXPECT_TRUE(definitely(form({7}).derivative_t().zero()));
}

TEST(BinaryForm, EulersIdentity) {
  const BinaryForm<Q> f = form({3, -1, 4, 1, -5});
  const BinaryForm<Q> rest = form({1, 0}) * f.derivative_s() + form({0, 1}) * f.derivative_t() - Q(4) * f;
  EXPECT_TRUE(definitely(rest.zero()));
}

TEST(BinaryForm, FirstNonzeroCoefficient) {
  EXPECT_EQ(form({0, 0, 3, 1}).first_nonzero(), 2);
  EXPECT_FALSE(form({0, 0}).first_nonzero());
  EXPECT_FALSE(possibly(form({0, 0, 3}).zero()));
  EXPECT_TRUE(definitely(BinaryForm<Q>(3).zero()));
}

}  // namespace
}  // namespace torse
