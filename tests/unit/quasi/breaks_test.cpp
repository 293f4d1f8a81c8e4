// Ends of pieces by hand.
#include "torse/quasi/breaks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torse::quasi {
namespace {

using List = std::vector<double>;

TEST(Breaks, EvenOnesAreRoundedToAGrid) {
  EXPECT_EQ(even_breaks(1), (List{0, 1}));
  EXPECT_EQ(even_breaks(4), (List{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(even_breaks(3), (List{0, 5592405 * 0x1p-24, 11184811 * 0x1p-24, 1}));  // 2^24 / 3 = 5592405.3...
}

TEST(Breaks, MeansOfPieces) {
  EXPECT_EQ(means_by_piece({0, 0.25, 0.5, 1}, {0, 0.125, 0.25, 0.5, 0.75, 1}, {1, 3, 5, 7, 8, 12}), (List{2, 5, 9}));
  EXPECT_EQ(means_by_piece({0, 0.25, 0.5, 1}, {0.1, 0.6}, {2, 4}), (List{2, 0, 4}));
  EXPECT_EQ(means_by_piece({0, 1}, {0, 0.5, 1}, {1, 1, 4}), (List{2}));
}

void expect_breaks(const List& found, const List& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], wanted[i], 0x1p-25);
    EXPECT_EQ(found[i], std::round(found[i] * 0x1p24) * 0x1p-24);
  }
}

/// Densities 1.1 and 0.5 = sqrt(0.16) + 0.1: masses 0.55 and 0.25, and their half 0.4 is 8 / 11 of the first piece.
TEST(Breaks, TwoPiecesOfDegree1) {
  for (const double unit : {1.0, 0.01, 1e-9}) {
    expect_breaks(moved_breaks({0, 0.5, 1}, {100 * unit, 16 * unit}, 1), {0, 4.0 / 11, 1});
  }
}

/// Densities 0.1, 0.1, 0.6 = cbrt(1/8) + 0.1 and 1.1: the masses add up to 0.025, 0.05, 0.2, 0.475.
TEST(Breaks, FourPiecesOfDegree2) {
  expect_breaks(moved_breaks({0, 0.25, 0.5, 0.75, 1}, {0, 0, 8, 64}, 2),
                {0, 0.5 + 11.0 / 96, 0.75 + 3.0 / 88, 0.75 + 25.0 / 176, 1});
}

/// Densities 1.1 and 0.1 over pieces of lengths 1/4 and 3/4: masses 0.275 and 0.075, their half 0.175.
TEST(Breaks, UnevenPieces) { expect_breaks(moved_breaks({0, 0.25, 1}, {2, 0}, 2), {0, 7.0 / 44, 1}); }

TEST(Breaks, WithoutWarpPiecesAreEven) {
  expect_breaks(moved_breaks({0, 0.25, 1}, {0, 0}, 3), {0, 0.5, 1});
  expect_breaks(moved_breaks({0, 1}, {0}, 1), {0, 1});
}

/// The shortest piece there can be: all of the warp in one of 10000.
TEST(Breaks, OfManyPiecesAreApart) {
  List warp(10000, 0);
  warp[5000] = 1;
  const List moved = moved_breaks(even_breaks(10000), warp, 1);
  ASSERT_EQ(moved.size(), 10001U);
  for (std::size_t i = 0; i < 10000; ++i) EXPECT_GE(moved[i + 1] - moved[i], 1 / 110000.0 - 0x1p-24);
}

}  // namespace
}  // namespace torse::quasi
