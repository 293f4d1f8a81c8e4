// Rational functions of t in words and as integers.
#include "torse/cli/function_report.hpp"

#include <gtest/gtest.h>

namespace torse::cli {
namespace {

using Q = Rational;
using Json = nlohmann::ordered_json;

RationalPolynomial polynomial(std::initializer_list<Q> coefficients) {
  return RationalPolynomial(std::vector<Q>(coefficients));
}

RationalFunctionOfT fraction(const RationalPolynomial& above, const RationalPolynomial& below) {
  return {above, below};
}

TEST(FunctionReport, WordsHaveNoBlankBehindANumberAndKeepThoseAroundSigns) {
  EXPECT_EQ(function_text(fraction(polynomial({Q(-32), Q(-3), Q(9)}), polynomial({Q(9), Q(-18)}))),
            "(-9t^2 + 3t + 32)/(18t - 9)");
  EXPECT_EQ(function_text(fraction(polynomial({Q(1), Q(-1), Q(1)}), polynomial({Q(1)}))), "t^2 - t + 1");
  EXPECT_EQ(function_text(fraction(polynomial({Q(0), Q(-1)}), polynomial({Q(2), Q(0), Q(0), Q(1)}))), "-t/(t^3 + 2)");
  EXPECT_EQ(function_text(fraction(polynomial({ratio<Q>(1, 2), ratio<Q>(1, 3)}), polynomial({Q(1)}))), "(2t + 3)/6");
}

TEST(FunctionReport, LongOnesAreDescribedByTheirDegrees) {
  RationalPolynomial long_one = polynomial({Q(1234567)});
  for (int i = 0; i < 8; ++i) long_one = long_one * polynomial({Q(1234567), Q(7654321)});
  EXPECT_EQ(function_text(fraction(long_one, polynomial({Q(1), Q(1)}))), "[degree 8/1]");
}

TEST(FunctionReport, IntegersHaveNoCommonDivisor) {
  EXPECT_EQ(function_json(fraction(polynomial({ratio<Q>(-4, 3), Q(2)}), polynomial({Q(0), Q(6)}))),
            Json::parse(R"({"num": [-2, 3], "den": [0, 9]})"));
  EXPECT_EQ(function_json(std::nullopt), nullptr);
  EXPECT_EQ(coefficients_json(polynomial({})), Json::array({0}));
}

}  // namespace
}  // namespace torse::cli
