// Derivatives against divided differences, which know no rules of differentiation.
#include "torse/exact/instrumented/dual.hpp"

#include <gtest/gtest.h>

#include <random>

#include "torse/exact/rational/rational.hpp"
#include "unit/exact/random_program.hpp"

namespace torse {
namespace {

using Q = Rational;
using D = Dual<Q>;
static_assert(ExactField<D> && OrderedField<D>);

Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

TEST(Dual, ByHand) {
  const D x = D::variable(Q(2), 0);
  const D y = D::variable(Q(3), 1);
  const D f = (x * x - y) / (x + y * D(4));  // 1/14
  EXPECT_EQ(f.value(), ratio<Q>(1, 14));
  EXPECT_EQ(f.derivative(0), (Q(4) * Q(14) - Q(1)) / Q(196));
  EXPECT_EQ(f.derivative(1), (Q(-1) * Q(14) - Q(4)) / Q(196));
  EXPECT_EQ(f.derivative(7), Q(0));
}

TEST(Dual, OperandsMayBeTheResult) {
  D x = D::variable(Q(3), 0);
  const D& also_x = x;
  x *= also_x;
  EXPECT_EQ(x.derivative(0), Q(6));
  x -= also_x;
  EXPECT_EQ(x.derivative(0), Q(0));
  D y = D::variable(Q(5), 0);
  const D& also_y = y;
  y /= also_y;
  EXPECT_EQ(y.value(), Q(1));
  EXPECT_EQ(y.derivative(0), Q(0));
  EXPECT_THROW(y / D(0), DivisionByZero);
}

/// f(t + h e_k) - f(t) = h f_k + O(h^2): halving h twice makes the rest four times smaller each time, up to O(h).
TEST(Dual, AgreesWithDividedDifferences) {
  std::mt19937_64 random(1);
  constexpr std::size_t inputs = 3;
  int checked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const test::Program program = test::random_program(random, inputs, 9, "+-*/");
    std::vector<Q> point;
    for (const CppRational& x : test::random_point(random, inputs)) point.push_back(Q::from_text(x.text()));
    const Q h = Q(1) / Q(1L << 50);
    try {
      std::vector<D> lifted;
      for (std::size_t k = 0; k < inputs; ++k) lifted.push_back(D::variable(point[k], k));
      const D f = program.run(lifted).back();
      ASSERT_EQ(f.value(), program.run(point).back());
      for (std::size_t k = 0; k < inputs; ++k) {
        const auto rest = [&](const Q& step) {
          std::vector<Q> moved = point;
          moved[k] += step;
          return (program.run(moved).back() - f.value()) / step - f.derivative(k);
        };
        const Q far = rest(h);
        const Q near = rest(h / Q(2));
        ++checked;
        EXPECT_TRUE(magnitude(far - near - near) <= magnitude(far) / Q(1000)) << trial << ' ' << k;
      }
    } catch (const DivisionByZero&) {
      continue;
    }
  }
  EXPECT_GT(checked, 60);
}

}  // namespace
}  // namespace torse
