// The matchers for other people's tests: verdicts, explanations, broken surfaces.
#include "torse/exact/testing/matchers.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace torse::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Point = Vec<double, 3>;
using Surface = RuledSpline<double, Point>;

/// The bilinear patch over the unit square with its last corner lifted: the warp angle is atan(height) at the end.
Surface lifted(double height) {
  return test_surface<double, 3>(1, {0, 1}, {Point(0, 0, 0), Point(1, 0, 0)}, {Point(0, 1, 0), Point(1, 1, height)});
}

/// The reason that a matcher gives.
std::string reason(const DevelopableMatcher& matcher, const Surface& surface) {
  ::testing::StringMatchResultListener listener;
  const ::testing::Matcher<Surface> m = matcher;
  m.MatchAndExplain(surface, &listener);
  return listener.str();
}

TEST(Matchers, DoublesCountExactly) {
  EXPECT_THAT(lifted(0), IsDevelopable());
  EXPECT_THAT(lifted(std::numeric_limits<double>::denorm_min()), Not(IsDevelopable()));
}

TEST(Matchers, TheAngleIsALimit) {
  constexpr double degrees_of_a_seventh = 8.1301023541559787;  // atan(1/7)
  EXPECT_THAT(lifted(1.0 / 7), IsDevelopableWithin(degrees_of_a_seventh + 1e-9));
  EXPECT_THAT(lifted(1.0 / 7), Not(IsDevelopableWithin(degrees_of_a_seventh - 1e-9)));
  EXPECT_THAT(lifted(1), IsDevelopableWithin(45));
  EXPECT_THAT(lifted(0), IsDevelopableWithin(0));
  EXPECT_THAT(lifted(1.0 / 7), IsDevelopableWithin(Angle{ratio<Rational>(1419, 10000), true}));
  EXPECT_THAT(lifted(1.0 / 7), Not(IsDevelopableWithin(Angle{ratio<Rational>(1418, 10000), true})));
}

/// atan(1/7) in degrees is less than 1e-60 below: nothing is certified so near.
TEST(Matchers, ALimitThatIsNotDecidedIsNotKept) {
  const Angle nearly{Rational::from_text("81301023541559787031443874409065893424084285992904420559720327/"
                                         "10000000000000000000000000000000000000000000000000000000000000"),
                     false};
  EXPECT_THAT(lifted(1.0 / 7), Not(IsDevelopableWithin(nearly)));
}

TEST(Matchers, TheReasonNamesWitnessAndAngle) {
  EXPECT_THAT(reason(IsDevelopable(), lifted(1)),
              AllOf(HasSubstr("not developable: piece 1, u from 0 to 1: coefficient 0 of the determinant is 1"),
                    HasSubstr("the largest warp angle is between 44.99"), HasSubstr("degrees, at u = ")));
  EXPECT_EQ(reason(IsDevelopable(), lifted(0)), "developable");
  EXPECT_EQ(::testing::DescribeMatcher<Surface>(IsDevelopable()), "is developable");
  EXPECT_EQ(::testing::DescribeMatcher<Surface>(Not(IsDevelopableWithin(0.5))),
            "is not developable within a warp angle of 1/2 degrees");
}

TEST(Matchers, RowsMayBeHomogeneousAndExact) {
  using Row = Vec<Rational, 4>;
  const auto row = [](int w, int x, int y, int z) { return Row(Rational(w), Rational(x), Rational(y), Rational(z)); };
  // Two half circles of radius 1 one above the other: weights 1, 0, 1. Then the middle of one is moved.
  const std::vector<Row> c{row(1, 1, 0, 0), row(0, 0, 1, 0), row(1, -1, 0, 0)};
  std::vector<Row> d{row(1, 1, 0, 2), row(0, 0, 1, 0), row(1, -1, 0, 2)};
  const auto surface = [&] {
    return test_surface<Rational, 4>(2, {Rational(0), Rational(0), Rational(1), Rational(1)}, c, d);
  };
  EXPECT_THAT(surface(), IsDevelopable());
  d[1][1] = ratio<Rational>(1, 1'000'000'000);
  EXPECT_THAT(surface(), AllOf(Not(IsDevelopable()), IsDevelopableWithin(1e-6)));
}

TEST(Matchers, NumbersThatAreNotFiniteMatchNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(lifted(nan), Not(IsDevelopableWithin(90)));
  EXPECT_THAT(reason(IsDevelopable(), lifted(nan)), HasSubstr("finite"));
}

TEST(Matchers, BothConventionsOfKnots) {
  const auto bent =
      test_surface<float, 3>(1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}});
  EXPECT_EQ(bent.knots.pieces(), 2);
  EXPECT_THAT(bent, IsDevelopable());
  EXPECT_THROW((test_surface<float, 3>(1, {0, 1}, {{0, 0, 0}}, {{0, 0, 1}})), InvalidInput);
}

}  // namespace
}  // namespace torse::testing
