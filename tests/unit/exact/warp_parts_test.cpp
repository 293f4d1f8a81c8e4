// The parts of the certified warp angle one by one: angles against Boost's own
// arithmetic, common zeros, the search where its budget
// ends, limits nearer to the angle than doubles can tell.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "torse/exact/warp/angle.hpp"
#include "torse/exact/warp/common_factor.hpp"
#include "torse/exact/warp/max_warp.hpp"
#include "torse/exact/warp/search.hpp"

namespace torse {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Wide = boost::multiprecision::cpp_bin_float_50;

Wide half_turn() { return 4 * atan(Wide(1)); }

/// Between the neighbours of the true angle.
TEST(Angle, DegreesAreRoundedOutwards) {
  for (const double sine2 : {1e-20, 0.1, 0.2, 1.0 / 3, 0.7, 0.999}) {
    const Wide degrees = asin(sqrt(Wide(sine2))) * 180 / half_turn();
    const Interval found = degrees_of(sine2, sine2, 0);
    EXPECT_LT(Wide(found.lower()), degrees) << sine2;
    EXPECT_GT(Wide(found.upper()), degrees) << sine2;
    EXPECT_GE(std::nextafter(found.lower(), 90), found.upper());
  }
}

TEST(Angle, SquaresOfSinesAreRoundedOutwards) {
  for (const bool radians : {false, true}) {
    for (const int tenths : {1, 3, 5, 9, 11}) {
      const Angle angle{Q(tenths) / Q(10), radians};
      const Wide x = Wide(tenths) / 10 * (radians ? Wide(1) : half_turn() / 180);
      const Interval found = sine_squared_at_most_90(angle, 0);
      EXPECT_LT(Wide(found.lower()), sin(x) * sin(x));
      EXPECT_GT(Wide(found.upper()), sin(x) * sin(x));
      EXPECT_GE(std::nextafter(found.lower(), 2), found.upper());
    }
  }
}

/// A warp angle is at most 90 degrees: beyond that the sine gets smaller, the limit does not.
TEST(Angle, NoneIsMoreThanRight) {
  for (const Angle& angle :
       {Angle{Q(90), false}, Angle{Q(100), false}, Angle{Q(180), false}, Angle{Q(2), true}, Angle{Q(4), true}}) {
    EXPECT_EQ(exact_sine_squared(angle), Q(1));
    const Interval found = sine_squared_at_most_90(angle, 0);
    EXPECT_EQ(found.lower(), 1);
    EXPECT_EQ(found.upper(), 1);
  }
  EXPECT_NE(exact_sine_squared(Angle{Q(3) / Q(2), true}), Q(1));
  EXPECT_NE(exact_sine_squared(Angle{Q(89), false}), Q(1));
}

/// (s^2 t, s t^2, s t (s + t)): divided by s t it vanishes nowhere.
TEST(CommonZeros, AreFoundAtBothEnds) {
  const auto form = [](int a, int b, int c, int d) { return BinaryForm<Q>(std::vector<Q>{Q(a), Q(b), Q(c), Q(d)}); };
  const VectorWithZeros found = without_common_zeros({form(0, 1, 0, 0), form(0, 0, 1, 0), form(0, 1, 1, 0)});
  const std::vector<RealRoot> zeros = zeros_in_unit_interval(found.divisor);
  ASSERT_EQ(zeros.size(), 2U);
  EXPECT_EQ(zeros[0].lower, Q(0));
  EXPECT_EQ(zeros[0].upper, Q(0));
  EXPECT_EQ(zeros[1].lower, Q(1));
  EXPECT_EQ(zeros[1].upper, Q(1));
  EXPECT_EQ(found.direction[0].degree(), 1);
}

/// 2t^2 - (s + t)^2 and that times 3t - (s + t), which have 1/sqrt(2) in common, and both vanish once more at s = 0.
TEST(CommonZeros, OfAProductAreTakenOnce) {
  const BinaryForm<Q> first =
      BinaryForm<Q>(std::vector<Q>{Q(-1), Q(-2), Q(1)}) * BinaryForm<Q>(std::vector<Q>{Q(1), Q(0)});
  const BinaryForm<Q> second = first * BinaryForm<Q>(std::vector<Q>{Q(-1), Q(2)});
  const std::vector<RealRoot> zeros = zeros_in_unit_interval(first * second);
  ASSERT_EQ(zeros.size(), 3U);
  EXPECT_EQ(zeros[0].lower, Q(1) / Q(3));
  EXPECT_LT(Q(2) * zeros[1].lower * zeros[1].lower, Q(1));
  EXPECT_GT(Q(2) * zeros[1].upper * zeros[1].upper, Q(1));
  EXPECT_EQ(zeros[2].upper, Q(1));
}

/// s^2 and t^2: whichever component has the highest power of t, nothing of it is lost.
TEST(CommonZeros, OfNoneIsTheVectorItself) {
  const BinaryForm<Q> low(std::vector<Q>{Q(1), Q(0), Q(0)});   // s^2
  const BinaryForm<Q> high(std::vector<Q>{Q(0), Q(0), Q(1)});  // t^2
  for (std::size_t place = 0; place < 3; ++place) {
    FormVector<Q> v{low, low, low};
    v[place] = high;
    const VectorWithZeros found = without_common_zeros(v);
    EXPECT_TRUE(zeros_in_unit_interval(found.divisor).empty());
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(found.direction[i].degree(), 2);
      for (int j = 0; j <= 2; ++j) EXPECT_EQ(found.direction[i][j], v[i][j]);
    }
  }
}

/// (s^2 + 3t^2)(s + 2t) t / ((s^2 + 3t^2)(s^2 + t^2)): the degree of both is 2 then.
TEST(LowestTerms, AreTheSameQuotient) {
  const auto form = [](std::vector<Q> f) { return BinaryForm<Q>(std::move(f)); };
  const BinaryForm<Q> common = form({Q(1), Q(0), Q(3)});
  const BinaryForm<Q> numerator = form({Q(0), Q(1), Q(2)}), denominator = form({Q(1), Q(0), Q(1)});
  const SineForms<Q> reduced = in_lowest_terms({common * numerator, common * denominator});
  EXPECT_EQ(reduced.numerator.degree(), 2);
  EXPECT_EQ(reduced.denominator.degree(), 2);
  for (int i = 0; i <= 4; ++i) {
    const Q t = Q(i) / Q(4), s = Q(1) - t;
    EXPECT_EQ(reduced.numerator(s, t) * denominator(s, t), numerator(s, t) * reduced.denominator(s, t));
    EXPECT_GT(reduced.denominator(s, t).sign(), 0);
  }
  // A lower degree at the end t = 1 is no common factor of one form alone.
  EXPECT_EQ(in_lowest_terms({form({Q(1), Q(0), Q(0)}), denominator}).denominator.degree(), 2);
}

/// (t, 0, 0) and (t, 1, h t): both normals nearly vanish at t = 0 within 1/h, where the angle is arctan h.
TEST(LowestTerms, OfAnglesThatAreNearlyRight) {
  const Q zero(0), one(1), a = Q(-1) / Q(5), b = Q(4) / Q(5);
  for (const int exponent : {6, 15, 30, 100}) {
    Q h(1);
    for (int i = 0; i < exponent; ++i) h *= Q(10);
    const std::vector<Point3> c{Point3(a, zero, zero), Point3(b, zero, zero)};
    const std::vector<Point3> d{Point3(a, one, h * a), Point3(b, one, h * b)};
    const WarpEnclosure warp = max_warp<Q, 3>(bezier_knots<Q>(1, a, b), c, d, {});
    EXPECT_TRUE(warp.complete);
    EXPECT_GE(warp.upper, 90 - 60 / h.to_double());
    EXPECT_GE(warp.lower, 90 * (1 - 1e-3));
  }
}

/// Two pieces, of which the budget covers a part of the first.
TEST(Search, TheBudgetsEndCountsWhatWasNotLookedAt) {
  using Quotient = BernsteinQuotient<Q>;
  const auto quotient = [](std::vector<Q> numerator) {
    return Quotient(Bernstein<Q>(std::move(numerator)), Bernstein<Q>(std::vector<Q>{Q(1), Q(1), Q(1)}));
  };
  const Q tenth = Q(1) / Q(10);
  std::vector<WarpPiece<Quotient>> pieces{{1, quotient({Q(0), Q(4) * tenth, Q(0)})},
                                          {2, quotient({Q(0), Q(9) * tenth, Q(0)})}};  // up to 0.2 and to 0.45
  WarpRecord record;
  EXPECT_TRUE(search(pieces, WarpGoal{}, 1, record).empty());
  EXPECT_FALSE(record.complete);
  EXPECT_GE(record.upper, 0.45);
  EXPECT_LT(record.upper, 1);
  // No sine is larger than 1, whatever the bound.
  std::vector<WarpPiece<Quotient>> steep{{1, quotient({Q(0), Q(4) * tenth, Q(0)})}, {2, quotient({Q(0), Q(5), Q(0)})}};
  WarpRecord of_steep;
  EXPECT_TRUE(search(steep, WarpGoal{}, 1, of_steep).empty());
  EXPECT_EQ(of_steep.upper, 1);
}

/// With a tolerance of 0.1 an error is too large where it adds more than 5 %, or hides that the threshold holds.
TEST(Search, ErrorsThatKeepABoundHigh) {
  WarpGoal goal;
  goal.tolerance = 0.1;
  EXPECT_TRUE(detail::error_rules({0.2, 0.1}, 0.05, goal));
  EXPECT_TRUE(detail::error_rules({0.106, 0.1}, 0.05, goal));
  EXPECT_FALSE(detail::error_rules({0.104, 0.1}, 0.05, goal));
  EXPECT_TRUE(detail::error_rules({0.104, 0.1}, 0.1, goal));
  EXPECT_TRUE(detail::error_rules({0.104, 0.1}, 0.102, goal));
}

TEST(CommonFactor, OfConstantVectors) {
  const auto form = [](std::vector<Q> a) { return BinaryForm<Q>(std::move(a)); };
  const VectorWithZeros constant = without_common_zeros({form({Q(2)}), form({Q(0)}), form({Q(-6)})});
  EXPECT_TRUE(zeros_in_unit_interval(constant.divisor).empty());
  const VectorWithZeros twice = without_common_zeros(
      {form({Q(2), Q(0), Q(0)}), form({Q(0), Q(0), Q(0)}), form({Q(-6), Q(0), Q(0)})});  // s^2 (2, 0, -6)
  const std::vector<RealRoot> zeros = zeros_in_unit_interval(twice.divisor);
  ASSERT_EQ(zeros.size(), 1U);
  EXPECT_EQ(zeros[0].lower, Q(1));
  EXPECT_EQ(zeros[0].upper, Q(1));
  for (const VectorWithZeros* x : {&constant, &twice}) {
    for (const BinaryForm<Q>& f : x->direction) EXPECT_EQ(f.degree(), 0);
    EXPECT_EQ(x->direction[2][0], Q(-3) * x->direction[0][0]);
    EXPECT_EQ(x->direction[1][0], Q(0));
    EXPECT_GT(x->direction[0][0], Q(0));
  }
  EXPECT_THROW(without_common_zeros({form({Q(0)}), form({Q(0)}), form({Q(0)})}), InvalidInput);
}

/// (t, 0, 0) and (t, 1, t/2) over [0, 1]: tan = 1/2 at t = 0. sin^2 = 1/5 and those of the limits are between the same
/// two doubles.
TEST(WarpLimit, NearerThanDoublesCanTell) {
  const Q zero(0), one(1), half = one / Q(2);
  const std::vector<Point3> c{Point3(zero, zero, zero), Point3(one, zero, zero)};
  const std::vector<Point3> d{Point3(zero, one, zero), Point3(one, one, half)};
  const auto at_most = [&](const char* degrees) {
    return warp_at_most<Q, 3>(bezier_knots<Q>(1), c, d, Angle{Q::from_text(degrees)});
  };
  const std::string angle = "26565051177077989351572193720453294671204214299645";  // arctan 1/2
  const std::string unit = "/1" + std::string(48, '0');
  std::string below = angle, above = angle;
  below[25] = static_cast<char>(below[25] - 1);
  above[25] = static_cast<char>(above[25] + 1);
  EXPECT_NE(at_most((below + unit).c_str()), Truth::yes);
  EXPECT_NE(at_most((above + unit).c_str()), Truth::no);
}

/// Rulings of length zero in the middle of the pieces 1 and 3 (2 is empty), which are excluded at 1/2 and at 3/2.
TEST(WarpExclusions, BelongToTheirPieces) {
  const Q zero(0), half = Q(1) / Q(2);
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(1), Q(2), Q(2)});
  std::vector<Point3> c, d;
  const std::vector<std::array<Q, 2>> offsets{
      {-half, zero}, {zero, -half * half}, {half, half}, {zero, -half * half}, {-half, zero}};
  for (int i = 0; i < 5; ++i) {
    const auto& [y, z] = offsets[static_cast<std::size_t>(i)];
    c.emplace_back(Q(i) * half, zero, zero);
    d.emplace_back(Q(i) * half, y, z);
  }
  const WarpEnclosure warp = max_warp<Q, 3>(u, c, d, {});
  ASSERT_EQ(warp.exclusions.size(), 2U);
  EXPECT_LT(warp.exclusions[0].piece, warp.exclusions[1].piece);
  for (const WarpExclusion& at : warp.exclusions) {
    EXPECT_EQ(at.lower, Q(at.piece) * half);
    EXPECT_EQ(at.upper, Q(at.piece) * half);
  }
}

}  // namespace
}  // namespace torse
