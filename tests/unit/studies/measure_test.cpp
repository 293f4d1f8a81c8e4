// Inputs, errors, condition numbers and backward errors against other ways to them.
#include "torse/studies/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "torse/developable/linear_net.hpp"
#include "torse/io/construct_file.hpp"
#include "torse/studies/verdicts.hpp"

namespace torse::studies {
namespace {

using Q = Rational;

std::size_t route(const std::string& name) {
  const std::vector<std::string> names = route_names();
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

Case some_case(std::uint64_t seed, int pieces = 3) {
  Levels levels;
  levels[Factor::pieces] = pieces;
  return draw_case(levels, seed);
}

TEST(Inputs, LevelsAreKept) {
  Levels levels;
  levels[Factor::degree] = 2;
  levels[Factor::pieces] = 7;
  levels[Factor::knot_ratio] = 100;
  levels[Factor::weight_ratio] = 50;
  levels[Factor::after] = 0;
  levels[Factor::inside] = 0x1p-10;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Case in = draw_case(levels, seed);
    ASSERT_EQ(in.last(), 8);
    double shortest = 1;
    double longest = 0;
    for (int k = 0; k < 7; ++k) {
      const double length = in.knots[static_cast<std::size_t>(k + 2)] - in.knots[static_cast<std::size_t>(k + 1)];
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    EXPECT_NEAR(longest / shortest, 100, 0.1);
    EXPECT_EQ(*std::ranges::max_element(in.weights), 50);
    EXPECT_EQ(*std::ranges::min_element(in.weights), 1);
    EXPECT_EQ(std::ranges::find(in.knots, in.m), in.knots.end());
    float nearest = 1;
    for (const float u : in.knots) nearest = std::min(nearest, std::abs(in.m - u));
    EXPECT_NEAR(nearest, 0x1p-10, 1e-6);
  }
}

TEST(Inputs, TheFileHoldsTheSameNumbers) {
  const Case in = some_case(5);
  const auto file = read_construct<Q>(Document("case", input_file(in)));
  EXPECT_EQ(*file.lambda, Q::from_double(in.lambda));
  EXPECT_EQ(*file.m, Q::from_double(in.m));
  EXPECT_EQ(file.c.points[2][1], Q::from_double(in.c[2][1]));
  EXPECT_EQ((*file.d0)[2], Q::from_double(in.anchors[0][2]));
  EXPECT_EQ(file.knots[3], Q::from_double(in.knots[3]));
}

/// A design that puts M* between the knots, or before them, has none behind them.
TEST(Inputs, MIsInOnePlace) {
  for (const Factor factor : {Factor::inside, Factor::before}) {
    Design design;
    design.variations = {{factor, {0.5}}};
    const Levels levels = design.levels(0);
    EXPECT_EQ(levels[factor], 0.5);
    EXPECT_EQ(levels[Factor::after], 0);
  }
  EXPECT_NE(Design().levels(0)[Factor::after], 0);
}

/// All routes of a problem compute the same numbers.
TEST(Routes, AgreeExactly) {
  const Case in = some_case(7, 4);
  const Case one = some_case(7, 1);
  std::vector<std::pair<Problem, std::vector<Q>>> seen;
  for (const RouteInfo& info : route_infos()) {
    const Computed computed = arithmetic("exact").run(route(info.name), info.one_piece ? one : in);
    ASSERT_TRUE(computed.finite) << info.name;
    if (info.problem == Problem::other) continue;
    const auto before = std::ranges::find(seen, info.problem, &std::pair<Problem, std::vector<Q>>::first);
    if (before == seen.end()) {
      seen.emplace_back(info.problem, computed.values);
    } else {
      EXPECT_EQ(before->second, computed.values) << info.name;
    }
  }
}

TEST(Routes, DoubleIs53BitsAndFloat128Is113) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Case in = some_case(seed);
    for (const char* name : {"FJ07.13", "FJ07.13.rulings", "FJ07.14", "FJ07.16", "FJ07.18", "FJ07.11", "FJ21.7.1"}) {
      const std::size_t r = route(name);
      EXPECT_EQ(arithmetic("double").run(r, in).values, arithmetic("mpfr53").run(r, in).values) << name;
      EXPECT_EQ(arithmetic("float128").run(r, in).values, arithmetic("mpfr113").run(r, in).values) << name;
    }
  }
}

/// Float against double, without rationals: u of double is negligible.
TEST(Measure, ErrorsAgreeWithAHigherPrecision) {
  const Case in = some_case(11);
  const std::vector<Measurement> list = measure_case(in, {"FJ07.13"}, {"float"});
  ASSERT_EQ(list.size(), 1U);
  const Measurement& m = list.front();
  const std::vector<Q> low = arithmetic("float").run(route("FJ07.13"), in).values;
  const std::vector<Q> high = arithmetic("double").run(route("FJ07.13"), in).values;
  double most = 0;
  double largest = 0;
  double ulps = 0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    const double x = high[i].to_double();
    const double error = std::abs(low[i].to_double() - x);
    most = std::max(most, error);
    largest = std::max(largest, std::abs(x));
    ulps = std::max(ulps, error / std::ldexp(1.0, std::ilogb(x) - 23));
  }
  EXPECT_NEAR(m.units, most / largest * 0x1p24, 1e-6 * m.units);
  EXPECT_NEAR(m.ulps, ulps, 1e-6 * ulps);
  EXPECT_GT(m.units, 0);
}

/// d_1 = d_0 (M - u_1) / (M - u_0) for c = 0 is 41 / 41, and 41 times the float nearest to 1/41 is 1 - 2^-24: half a
/// unit in the last place of 1, one of the numbers below 1.
TEST(Measure, UnitsInTheLastPlaceOfAPowerOfTwo) {
  Case in;
  in.knots = {0, 40};
  in.c = in.e = {FloatPoint{0, 0, 0}, FloatPoint{0, 0, 0}};
  in.weights = in.e_weights = {1, 1};
  in.lambda = -1;
  in.m = 41;
  in.anchors.fill({41, 0, 0});
  const std::vector<Measurement> list = measure_case(in, {"FJ07.14"}, {"float"});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list.front().ulps, 0.5);
  EXPECT_EQ(list.front().units, 1.0 / 41);
}

/// The condition number is what moving the inputs one by one does.
TEST(Measure, ConditionIsWhatPerturbationsDo) {
  const Case in = some_case(13, 2);
  const std::size_t r = route("FJ07.13");
  const Sensitivities s = sensitivities(r, in);
  ASSERT_EQ(s.values, arithmetic("exact").run(r, in).values);
  const Q step = Q(1) / Q(1L << 40);
  const std::size_t slots = numbers_of(in).size();
  for (const std::size_t slot : {std::size_t{3}, std::size_t{9}, std::size_t{12}, slots - 9, slots - 12, slots - 13}) {
    const auto moved = lift<Q>(in, [&](float x, std::size_t k) {
      const Q q = Q::from_double(x);
      return k == slot ? q + step : q;
    });
    const auto d = printed_net<Q, Vec<Q, 3>>(moved.u, moved.c, moved.lambda, moved.m, 0, moved.anchors[0]);
    for (std::size_t i = 0; i < s.values.size(); ++i) {
      const double slope = ((d[i / 3][static_cast<int>(i % 3)] - s.values[i]) / step).to_double();
      const double derivative = s.derivatives[i][slot].to_double();
      EXPECT_NEAR(slope, derivative, 1e-6 * (1 + std::abs(derivative))) << slot << ' ' << i;
    }
  }
}

TEST(Measure, LeastPerturbationByHand) {
  EXPECT_NEAR(*least_perturbation({{1, 1}}, {1}), 0.5, 1e-12);
  EXPECT_NEAR(*least_perturbation({{3, 4}}, {5}), 0.8, 1e-12);
  EXPECT_EQ(*least_perturbation({{3, 4}}, {0}), 0);
  EXPECT_EQ(least_perturbation({{1, 0}, {1, 0}}, {1, 2}), std::nullopt);
}

/// The wrong sizes of errors would show here: a backward error of some u for a formula of a few operations.
TEST(Measure, TheShippedRouteIsAccurate) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (const Measurement& m : measure_case(some_case(seed), {"FJ07.13.rulings"}, {"float", "double", "mpfr200"})) {
      EXPECT_GT(m.units, 0);
      EXPECT_LT(m.conditioned, 10);
      EXPECT_LT(*m.backward, 20);
      EXPECT_LE(*m.bound, 1);
      EXPECT_GT(m.condition, 1);
    }
  }
}

TEST(Verdicts, TheTruthIsKnown) {
  Levels levels;
  levels[Factor::degree] = 2;
  levels[Factor::pieces] = 2;
  const std::vector<std::string> tests{"relative 1e-06", "relative 1e-12", "fixed 1e-06"};
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    levels[Factor::moved] = 0;
    const Verdicts still = judge_case(levels, seed, tests);
    EXPECT_TRUE(still.developable);
    EXPECT_TRUE(still.said[0]);
    levels[Factor::moved] = 0x1p-30;
    const Verdicts moved = judge_case(levels, seed, tests);
    EXPECT_FALSE(moved.developable);
    EXPECT_TRUE(moved.said[0]);  // wrong
  }
}

}  // namespace
}  // namespace torse::studies
