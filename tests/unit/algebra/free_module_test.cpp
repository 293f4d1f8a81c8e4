// Linear forms against dense columns of coefficients.
#include "torse/algebra/free_module.hpp"

#include <gtest/gtest.h>

#include <random>

#include "torse/exact/ball/ball.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

constexpr int kGenerators = 6;
using F = Form<Rational>;
using Dense = Vec<Rational, kGenerators>;

static_assert(Point<F, Rational>);
static_assert(Point<Form<RationalFunction>, RationalFunction>);
static_assert(Point<Form<Ball<64>>, Ball<64>>);

/// Generators in an order of their own, with gaps.
constexpr int kNames[kGenerators] = {-3, 0, 1, 7, 20, 21};

Dense dense(const F& form) {
  Dense column = PointTraits<Dense>::zero();
  for (int i = 0; i < kGenerators; ++i) column[i] = form.coefficient(kNames[i]);
  return column;
}

void expect_same(const F& form, const Dense& column) {
  EXPECT_EQ(dense(form), column);
  std::size_t nonzero = 0;
  for (int i = 0; i < kGenerators; ++i) nonzero += column[i].sign() != 0 ? 1U : 0U;
  EXPECT_EQ(form.terms().size(), nonzero);
  for (std::size_t i = 1; i < form.terms().size(); ++i) {
    EXPECT_LT(form.terms()[i - 1].generator, form.terms()[i].generator);
  }
}

class Random {
 public:
  Rational scalar() { return ratio<Rational>(value_(engine_), 3); }
  F form() {
    F result;
    for (int name : kNames) {
      if (coin_(engine_) != 0) add_scaled(result, scalar(), F::generator(name));
    }
    return result;
  }

 private:
  std::mt19937_64 engine_{7};
  std::uniform_int_distribution<int> value_{-2, 2};
  std::uniform_int_distribution<int> coin_{0, 1};
};

TEST(Form, ActsAsItsColumnOfCoefficients) {
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const F x = random.form();
    const F y = random.form();
    const Rational a = random.scalar();
    const Rational b = random.scalar();
    expect_same(x, dense(x));
    expect_same(sum(x, y), sum(dense(x), dense(y)));
    expect_same(difference(x, y), difference(dense(x), dense(y)));
    expect_same(scaled(a, x), scaled<Dense>(a, dense(x)));
    expect_same(combine(a, x, b, y), combine<Dense>(a, dense(x), b, dense(y)));
    if (a.sign() == 0) continue;
    F quotient = x;
    Dense column = dense(x);
    divide(quotient, a);
    divide(column, a);
    expect_same(quotient, column);
  }
}

TEST(Form, AFormMayBeAddedToItself) {
  F x = sum(F::generator(1), F::generator(7));
  add(x, x);
  expect_same(x, dense(sum(scaled<F>(Rational(2), F::generator(1)), scaled<F>(Rational(2), F::generator(7)))));
  subtract(x, x);
  EXPECT_TRUE(x.terms().empty());
}

TEST(Form, DividingByZeroThrowsForZeroToo) {
  F x;
  EXPECT_THROW(divide(x, Rational(0)), DivisionByZero);
  add(x, F::generator(0));
  EXPECT_THROW(divide(x, Rational(0)), DivisionByZero);
}

TEST(Form, ExtractTakesATermOut) {
  F x = sum(F::generator(1), scaled<F>(Rational(5), F::generator(7)));
  EXPECT_EQ(x.extract(7), Rational(5));
  EXPECT_EQ(x.extract(7), Rational(0));
  expect_same(x, dense(F::generator(1)));
}

TEST(Form, KeepsTermsThatMayBeZero) {
  using B = Ball<64>;
  Form<B> x = scaled<Form<B>>(B::rational("1/3"), Form<B>::generator(2));
  subtract(x, Form<B>(x));
  ASSERT_EQ(x.terms().size(), 1U);
  EXPECT_EQ(is_zero(x.terms()[0].coefficient), Truth::unknown);
}

}  // namespace
}  // namespace torse
