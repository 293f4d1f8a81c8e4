// Krawczyk's test on equations whose zeros are known: it finds those that are there, and none where there is none.
#include "torse/exact/quasi/krawczyk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torse::test {
namespace {

/// One equation f(x) = 0 by its value and its slope, a monotone function, and what is taken for the inverse.
struct Equation {
  double x;
  Interval value;
  double inverse;
};

template <class Slope>
bool has_zero(const Equation& f, Slope slope) {
  const Krawczyk test(Eigen::MatrixXd::Constant(1, 1, f.inverse), IntervalVector::Constant(1, f.value));
  const double r = test.box()[0].upper();
  return test.has_zero(IntervalMatrix::Constant(1, 1, Interval::hull(slope(f.x - r), slope(f.x + r))));
}

/// x^2 - a at x.
bool square_has_zero(double x, double a, double inverse) {
  const Interval at = Interval::point(x);
  return has_zero({x, at * at - Interval::point(a), inverse}, [](double t) { return 2 * t; });
}

TEST(Krawczyk, FindsTheRootOfTwo) {
  for (const double x : {1.3, 1.41, 1.4142135623730951, 1.5}) EXPECT_TRUE(square_has_zero(x, 2, 1 / (2 * x))) << x;
  EXPECT_TRUE(square_has_zero(-1.41, 2, -1 / 2.82)) << "the negative one";
  EXPECT_TRUE(square_has_zero(1.41, 2, 0.3)) << "an inverse that is rough will do";
}

TEST(Krawczyk, FindsNoneWhereThereIsNone) {
  EXPECT_FALSE(square_has_zero(1e-10, -1e-20, 5e9)) << "the squares that come near -1e-20";
  EXPECT_FALSE(square_has_zero(1e-3, 0, 500)) << "a double root";
  EXPECT_FALSE(square_has_zero(1.41, 2, 0.001)) << "an inverse that leads nowhere near";
  EXPECT_FALSE(square_has_zero(1.41, 2, -0.35)) << "one that leads away";
}

TEST(Krawczyk, AValueOfZeroHasABoxToo) {
  const Equation exact{0.25, Interval(), 1};
  EXPECT_TRUE(has_zero(exact, [](double) { return 1.0; }));
  EXPECT_FALSE(has_zero(exact, [](double t) { return t < 0.25 ? -1.0 : 3.0; })) << "slopes of both signs";
}

/// 2^-53 + t/4 is 0 at t = -2^-51, where the box about 0 ends: what is not inside is not told.
TEST(Krawczyk, AZeroAtTheEndOfTheBoxIsNotTold) {
  const Krawczyk test(Eigen::MatrixXd::Identity(1, 1), IntervalVector::Constant(1, Interval::point(0x1p-53)));
  ASSERT_EQ(test.box()[0].upper(), 0x1p-51);
  for (const double value : {0x1p-53, -0x1p-53}) {
    EXPECT_FALSE(has_zero({0, Interval::point(value), 1}, [](double) { return 0.25; }));
    EXPECT_TRUE(has_zero({0, Interval::point(value), 1}, [](double) { return 0.3125; })) << "at 4/5 of it";
  }
}

/// What is not known of the value counts: 0 in its middle does not make it a zero.
TEST(Krawczyk, AnUncertainValueWidensTheBox) {
  const Krawczyk test(Eigen::MatrixXd::Identity(1, 1), IntervalVector::Constant(1, Interval::hull(-0.25, 0.125)));
  EXPECT_GE(test.box()[0].upper(), 0.5);
  EXPECT_LE(test.box()[0].upper(), 0.5 + 0x1p-50);
  const Krawczyk other(Eigen::MatrixXd::Identity(1, 1), IntervalVector::Constant(1, Interval::hull(-0.125, 0.25)));
  EXPECT_EQ(other.box()[0].upper(), test.box()[0].upper());
  EXPECT_EQ(test.box()[0].lower(), -test.box()[0].upper());
}

/// x + 8 y^2 = 2^-20, y + x = 2^-30: at (0, 0) the value is (-2^-20, -2^-30), the slopes are (1, 16 y; 1, 1), and Y is
/// (1, 0; -1, 1). Each of these matters: with Y or the slopes transposed the test fails.
TEST(Krawczyk, TwoEquations) {
  Eigen::MatrixXd inverse(2, 2);
  inverse << 1, 0, -1, 1;
  IntervalVector value(2);
  value << Interval::point(-0x1p-20), Interval::point(-0x1p-30);
  const auto zero = [&](const Eigen::MatrixXd& y, bool transposed) {
    const Krawczyk test(y, value);
    const double r = test.box()[1].upper();
    IntervalMatrix slopes(2, 2);
    slopes << Interval(1), Interval::hull(-16 * r, 16 * r), Interval(1), Interval(1);
    return test.has_zero(transposed ? IntervalMatrix(slopes.transpose()) : slopes);
  };
  EXPECT_TRUE(zero(inverse, false));
  EXPECT_FALSE(zero(inverse, true));
  EXPECT_FALSE(zero(inverse.transpose(), false));
}

TEST(Krawczyk, NothingIsFoundInABoxWithoutEnds) {
  const Krawczyk test(Eigen::MatrixXd::Identity(1, 1), IntervalVector::Constant(1, Interval::line()));
  EXPECT_FALSE(std::isfinite(test.box()[0].upper()));
}

}  // namespace
}  // namespace torse::test
