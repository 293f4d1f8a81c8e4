// Losses by hand: values, slopes and curvatures of each measure's function.
#include "torse/quasi/loss.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace torse::quasi {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_loss(const Loss& loss, double angle, const Taylor<double>& wanted) {
  const Taylor<double> found = loss(angle);
  EXPECT_DOUBLE_EQ(found.value, wanted.value) << angle;
  EXPECT_DOUBLE_EQ(found.first, wanted.first) << angle;
  EXPECT_DOUBLE_EQ(found.second, wanted.second) << angle;
}

/// sqrt(a^2 + 9), a / sqrt(a^2 + 9), 9 / sqrt(a^2 + 9)^3.
TEST(Loss, OfTheMean) {
  const Loss loss{Measure::mean, 3, 2, infinity};
  expect_loss(loss, 4, {5, 0.8, 9.0 / 125});
  expect_loss(loss, -4, {5, -0.8, 9.0 / 125});
  expect_loss(loss, 0, {3, 0, 1.0 / 3});
}

/// The cap 4 adds 4 (a / 4)^64, 64 (a / 4)^63, 64 63 (a / 4)^62 / 4. At a = 8 the rest is lost in the rounding.
TEST(Loss, OfTheMeanWithACap) {
  const Loss loss{Measure::mean, 3, 2, 4};
  expect_loss(loss, 4, {5 + 4, 0.8 + 64, 9.0 / 125 + 64 * 63 / 4});
  expect_loss(loss, -4, {5 + 4, -0.8 - 64, 9.0 / 125 + 64 * 63 / 4});
  expect_loss(loss, 8, {0x1p66, 0x1p69, 1008 * 0x1p62});
  expect_loss(loss, -8, {0x1p66, -0x1p69, 1008 * 0x1p62});
  expect_loss(loss, 0, {3, 0, 1.0 / 3});
  const Loss narrow{Measure::mean, 0.375, 2, 0.5};  // sqrt(1/4 + 9/64) = 5/8
  expect_loss(narrow, 0.5, {0.625 + 0.5, 0.8 + 64, 0.576 + 64 * 63 / 0.5});
  expect_loss(narrow, -0.5, {0.625 + 0.5, -0.8 - 64, 0.576 + 64 * 63 / 0.5});
}

TEST(Loss, OfTheMeanSquare) {
  const Loss loss{Measure::rms, 5, 7, infinity};
  expect_loss(loss, 3, {9, 6, 2});
  expect_loss(loss, -3, {9, -6, 2});
}

/// (|a| / 2)^p with p = 2 and 4.
TEST(Loss, OfTheMaximum) {
  expect_loss({Measure::max, 2, 4, infinity}, 1, {1.0 / 16, 1.0 / 4, 3.0 / 4});
  expect_loss({Measure::max, 2, 4, infinity}, -6, {81, -54, 27});
  expect_loss({Measure::max, 2, 2, infinity}, -6, {9, -3, 0.5});
  expect_loss({Measure::max, 2, 2, infinity}, 0, {0, 0, 0.5});
}

}  // namespace
}  // namespace torse::quasi
