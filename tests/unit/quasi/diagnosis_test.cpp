// Diagnoses of strips between two curves in parallel planes, whose developable rulings are those between parallel
// tangents: c' = (1, f(t)) and d' = (1, T), so that T = f(t).
#include "torse/quasi/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rails.hpp"
#include "torse/quasi/fit.hpp"

namespace torse::quasi {
namespace {

using test::hundredths;
using test::Polynomials;
using test::Q;

constexpr double degrees = 180 / std::numbers::pi;

/// c = (t, integral of f, 0), d = (T, T^2 / 2, 1).
Rails rails_with(const Polynomial<Q>& f) {
  std::vector<Q> integral{Q(0)};
  for (int i = 0; i <= f.degree(); ++i) integral.push_back(f[i] / Q(i + 1));
  return {test::rail_of({hundredths({0, 100}), Polynomial<Q>(std::move(integral)), hundredths({0})}),
          test::rail_of({hundredths({0, 100}), hundredths({0, 0, 50}), hundredths({100})})};
}

const Mapping<double> identity = identity_mapping(mapping_knots(1, {0, 1}));

double warp(const Rails& rails, double t, double target) {
  return std::abs(ruling_angle(rails.c(t), rails.d(target), AngleKind::planes).angle.value) * degrees;
}

/// With sigma(t) = t.
std::vector<Finding> findings_of(const Rails& rails, double threshold, std::size_t rulings = 80) {
  return diagnose(rails, identity, {.threshold = threshold, .rulings = rulings});
}

void expect_one(const Polynomial<Q>& f, Obstacle obstacle, double extension) {
  const std::vector<Finding> found = findings_of(rails_with(f), 0.01);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].obstacle, obstacle);
  EXPECT_NEAR(found[0].extension, extension, 1e-4);
}

TEST(Diagnosis, NothingIsFoundWhereNothingIsWarped) {
  EXPECT_TRUE(findings_of(rails_with(hundredths({0, 100})), 1e-9).empty());
}

TEST(Diagnosis, WhereTheDevelopableRulingsAre) {
  expect_one(hundredths({200}), Obstacle::tangents, 0);  // out of reach
  expect_one(hundredths({-100}), Obstacle::tangents, 0);
  expect_one(hundredths({125}), Obstacle::beyond_end, 0.25);
  expect_one(hundredths({-25}), Obstacle::beyond_begin, 0.25);
  expect_one(hundredths({140, -20}), Obstacle::beyond_end, 0.4 - 0.2 / 160);  // the farthest one
  expect_one(hundredths({0, 0, 100}), Obstacle::mapping, 0);
  // At the ends of what is looked at, and of the rail.
  expect_one(hundredths({150}), Obstacle::beyond_end, 0.5);
  expect_one(hundredths({-50}), Obstacle::beyond_begin, 0.5);
  expect_one(hundredths({0}), Obstacle::mapping, 0);
  expect_one(hundredths({100}), Obstacle::mapping, 0);
}

/// f = -1/4 + t/100: of the rulings on the rail that to T = 0 is the nearest to the developable one before it.
TEST(Diagnosis, TheBestRulingMayBeTheFirst) {
  const Rails rails = rails_with(hundredths({-25, 1}));
  const std::vector<Finding> found = findings_of(rails, 0.01);
  ASSERT_EQ(found.size(), 1U);
  double best = 0;
  for (int i = 0; i < 80; ++i) best += warp(rails, (i + 0.5) / 80, 0) / 80;
  EXPECT_NEAR(found[0].best, best, 1e-9);
}

/// All of the warps are less than a degree: f = t + 1/100.
TEST(Diagnosis, MeanAndMaximumOfSmallWarps) {
  const Rails rails = rails_with(hundredths({1, 100}));
  const std::vector<Finding> found = findings_of(rails, 0.01);
  ASSERT_EQ(found.size(), 2U);  // those at the end lead beyond it
  for (std::size_t k = 0; k < 2; ++k) {
    double mean = 0, max = 0;
    const int from = k == 0 ? 0 : 79;
    const int to = k == 0 ? 79 : 80;
    for (int i = from; i < to; ++i) {
      const double t = (i + 0.5) / 80;
      mean += warp(rails, t, t) / (to - from);
      max = std::max(max, warp(rails, t, t));
    }
    EXPECT_LT(max, 1);
    EXPECT_NEAR(found[k].mean, mean, 1e-9);
    EXPECT_NEAR(found[k].max, max, 1e-12);
  }
  EXPECT_TRUE(diagnose(rails, identity).empty()) << "by the threshold of one degree";
  const Rails more = rails_with(hundredths({3, 100}));
  EXPECT_LT(warp(more, 0, 0), 2);
  EXPECT_GT(warp(more, 0, 0), 1);
  EXPECT_FALSE(diagnose(more, identity).empty());
}

/// f = t + t^2 / 4: the warp grows on the way.
TEST(Diagnosis, TheMaximumMayComeLast) {
  const Rails rails = rails_with(hundredths({0, 100, 25}));
  for (const Finding& finding : findings_of(rails, 0.01)) {
    const double last = finding.to - 0.5 / 80;
    EXPECT_NEAR(finding.max, warp(rails, last, last), 1e-9);
    EXPECT_GT(finding.max, 1.02 * warp(rails, finding.from + 0.5 / 80, finding.from + 0.5 / 80));
  }
}

/// The tangents turn past a right angle from those of c: the warp jumps from 90 to -90 degrees, and none is 0.
TEST(Diagnosis, AJumpOfTheWarpIsNoDevelopableRuling) {
  const Rails rails{test::rail_of({hundredths({50, 1}), hundredths({50}), hundredths({0})}),
                    test::rail_of({hundredths({0, 100, -100}), hundredths({0, 100}), hundredths({1000})})};
  const std::vector<Finding> found = findings_of(rails, 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].obstacle, Obstacle::tangents);
  EXPECT_GT(found[0].best, 40);
}

/// f = 1 - t: only the ruling in the middle is good, all others would cross it.
TEST(Diagnosis, RulingsAgainstTheOrder) {
  const std::vector<Finding> found = findings_of(rails_with(hundredths({100, -100})), 1, 81);
  ASSERT_EQ(found.size(), 2U);
  for (const Finding& finding : found) EXPECT_EQ(finding.obstacle, Obstacle::order);
  EXPECT_LT(found[0].to, 0.5);
  EXPECT_GT(found[1].from, 0.5);
  EXPECT_NEAR(found[0].from, 0, 1e-12);
  EXPECT_NEAR(found[1].to, 1, 1e-12);
}

/// A threshold of 0 too has rulings that count as good: those of no warp.
TEST(Diagnosis, ExactRulingsAreGoodByAnyThreshold) {
  const std::vector<Finding> found = findings_of(rails_with(hundredths({100, -100})), 0, 81);
  ASSERT_EQ(found.size(), 2U);
  for (const Finding& finding : found) EXPECT_EQ(finding.obstacle, Obstacle::order);
  // T = 1/2 is a target, where the warp is 0 without a change of sign between two targets.
  const std::vector<Finding> other = findings_of(rails_with(hundredths({50})), 0);
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(other[0].obstacle, Obstacle::mapping);
  // The good ruling from t = 1/2 shares T = 1/2 with those that are wanted: that is in order.
  const std::vector<Finding> shared = findings_of(rails_with(hundredths({50})), 0, 81);
  ASSERT_EQ(shared.size(), 2U);
  for (const Finding& finding : shared) EXPECT_EQ(finding.obstacle, Obstacle::mapping);
}

/// f - t = 0.15 - 0.2 t falls to 0 at 3/4. With the warp at t = 1/4 for the threshold the rulings behind it, up to
/// about 1/2, count neither as warped nor as good: they stand in nobody's way.
TEST(Diagnosis, OnlyRulingsOfLittleWarpAreInTheWay) {
  const Rails rails = rails_with(hundredths({15, 80}));
  const std::vector<Finding> found = findings_of(rails, warp(rails, 0.25, 0.25));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].obstacle, Obstacle::mapping);
  EXPECT_NEAR(found[0].to, 0.25, 1.0 / 80);
}

/// The same from the other end: f - t = 0.05 - 0.2 t.
TEST(Diagnosis, AndSoAreThoseBefore) {
  const Rails rails = rails_with(hundredths({5, 80}));
  const std::vector<Finding> found = findings_of(rails, warp(rails, 0.75, 0.75));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].obstacle, Obstacle::mapping);
  EXPECT_NEAR(found[0].from, 0.75, 1.0 / 80);
}

/// f = t + 0.3 leaves the rail at t = 0.7.
TEST(Diagnosis, FindingsEndWhereTheObstacleChanges) {
  const Rails rails = rails_with(hundredths({30, 100}));
  const std::vector<Finding> found = findings_of(rails, 0.01, 100);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].obstacle, Obstacle::mapping);
  EXPECT_EQ(found[1].obstacle, Obstacle::beyond_end);
  EXPECT_NEAR(found[0].from, 0, 1e-12);
  EXPECT_NEAR(found[0].to, 0.7, 1e-12);
  EXPECT_NEAR(found[1].from, 0.7, 1e-12);
  EXPECT_NEAR(found[1].to, 1, 1e-12);
  EXPECT_NEAR(found[1].extension, 0.295, 1e-4);
  EXPECT_EQ(found[0].best, 0);
  double mean = 0, best = 0, max = 0;
  for (int i = 70; i < 100; ++i) {
    const double t = (i + 0.5) / 100;
    mean += warp(rails, t, t) / 30;
    max = std::max(max, warp(rails, t, t));
    best += warp(rails, t, 1) / 30;  // the nearest to the developable one
  }
  EXPECT_NEAR(found[1].mean, mean, 1e-9);
  EXPECT_NEAR(found[1].max, max, 1e-9);
  EXPECT_NEAR(found[1].best, best, 1e-9);
}

TEST(Diagnosis, APartOfTheRail) {
  const DiagnosisOptions part{.range = {0.5, 0.75}, .threshold = 1, .rulings = 10};
  const std::vector<Finding> found = diagnose(rails_with(hundredths({200})), identity, part);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].from, 0.5, 1e-12);
  EXPECT_NEAR(found[0].to, 0.75, 1e-12);
}

TEST(Diagnosis, Names) {
  EXPECT_EQ(name_of(Obstacle::tangents), "tangents");
  EXPECT_EQ(name_of(Obstacle::beyond_begin), "beyond-begin");
  EXPECT_EQ(name_of(Obstacle::beyond_end), "beyond-end");
  EXPECT_EQ(name_of(Obstacle::order), "order");
  EXPECT_EQ(name_of(Obstacle::mapping), "mapping");
}

}  // namespace
}  // namespace torse::quasi
