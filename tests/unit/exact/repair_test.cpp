// The nearest developable net: exact nets of every family with known errors, the oracle, and members of the families
// that must not be nearer.
#include "torse/exact/repair/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "torse/developable/classify.hpp"
#include "torse/developable/condition.hpp"
#include "unit/exact/repair_samples.hpp"

namespace torse::test {
namespace {

/// By the oracle of the library, which shares no code with find_witness_over_q.
bool developable(const KnotList<Q>& u, const RuledRows& rows) {
  return !find_witness<Q, 4>(u, homogeneous(rows.c), homogeneous(rows.d));
}

bool same(const RuledRows& x, const RuledRows& y) {
  return x.c.points == y.c.points && x.d.points == y.d.points && x.c.weights == y.c.weights &&
         x.d.weights == y.d.weights;
}

bool has_weights(const RuledRows& rows) { return rows.c.weights != ones(rows.c.weights.size()); }

TEST(Repair, FindsTheNetBehindErrors) {
  for (const Sample& sample : samples()) {
    ASSERT_TRUE(developable(sample.u, sample.rows)) << sample.name;
    for (const long exponent : {-16L, -48L, -100L}) {
      if (exponent == -100 && has_weights(sample.rows)) continue;
      SCOPED_TRACE(std::string(sample.name) + ", 2^" + std::to_string(exponent));
      const RuledRows given = noisy(sample.rows, exponent, 99);
      const double error = distance_between(given, sample.rows).root_mean_square;
      const auto found = nearest_developable(sample.u, given);
      ASSERT_TRUE(found);
      EXPECT_TRUE(developable(sample.u, found->rows));
      EXPECT_EQ(name_of(found->family), name_of(sample.family));
      EXPECT_EQ(found->degree > 0, found->family == NetFamily::edge);
      // The exact net without errors is in the family. Between points nothing of it is nearer but by the share of the
      // rounding, 1 %; between rows the distance counts weights too, which the errors left alone.
      EXPECT_LE(found->distance.root_mean_square, has_weights(sample.rows) ? 3 * error : 1.01 * error);
      EXPECT_GT(found->distance.root_mean_square, 0);
      if (!found->constants.empty()) {
        EXPECT_EQ(found->constants.front().from, sample.u.domain_begin());
        EXPECT_EQ(found->constants.back().to, sample.u.domain_end());
      }
      EXPECT_FALSE(same(found->rows, given));
      if (sample.family == NetFamily::plane) {
        EXPECT_EQ(classify<Q>(sample.u, homogeneous(found->rows.c), homogeneous(found->rows.d)).kind,
                  SurfaceClass::plane);
        EXPECT_EQ(found->distance.weights, 0);
      }
    }
  }
}

/// Weights in the second row only.
TEST(Repair, OfAPolynomialRailAndARationalOne) {
  const KnotList<Q> u(2, {Q(0), Q(0), Q(1), Q(2), Q(3), Q(3)});
  std::vector<Row4> p;
  for (const Point3& x : row(u.last() + 1, 5)) p.push_back(Row4(Q(1), x[0], x[1], x[2]));
  const RuledRows exact =
      rational(p, rational_net<Q, Row4>(u, p, q(-7, 2), q(-9, 4), q(5, 4), Row4(Q(1), Q(1), Q(-3), Q(7))));
  ASSERT_FALSE(has_weights(exact));
  ASSERT_NE(exact.d.weights, ones(exact.d.weights.size()));
  const RuledRows given = noisy(exact, -40, 7);
  const auto found = nearest_developable(u, given);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->family, NetFamily::constant);
  EXPECT_LE(found->distance.root_mean_square, 3 * distance_between(given, exact).root_mean_square);
}

/// Twenty parts between double knots, each with constants of its own: the share of the error that rounding them may
/// add is that of all together.
TEST(Repair, OfManyParts) {
  std::vector<Q> list;
  for (int i = 0; i <= 20; ++i) list.insert(list.end(), 2, Q(i));
  const KnotList<Q> u(2, list);
  const std::vector<Point3> c = row(u.last() + 1, 3);
  std::vector<Point3> d{Point3(Q(1), Q(-3), Q(7))};
  for (std::size_t part = 0; part < 20; ++part) {
    const std::span<const Point3> own = std::span(c).subspan(2 * part, 3);
    const auto next =
        linear_net<Q, Point3>(bezier_knots<Q>(2), own, Q(-3) - q(static_cast<int>(part), 7), Q(-2), d.back());
    d.insert(d.end(), next.begin() + 1, next.end());
  }
  const RuledRows exact = polynomial(c, d);
  ASSERT_TRUE(developable(u, exact));
  const RuledRows given = noisy(exact, -16, 9);
  const auto found = nearest_developable(u, given);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->constants.size(), 20U);
  const auto family = std::ranges::find(found->families, found->family, &FamilyDistance::family);
  ASSERT_NE(family, found->families.end());
  EXPECT_LE(found->distance.root_mean_square, 1.01 * family->root_mean_square);
}

TEST(Repair, LeavesDevelopableNetsAlone) {
  for (const Sample& sample : samples()) {
    const auto found = nearest_developable(sample.u, sample.rows);
    ASSERT_TRUE(found) << sample.name;
    EXPECT_EQ(found->family, NetFamily::unchanged);
    EXPECT_TRUE(same(found->rows, sample.rows));
    EXPECT_EQ(found->distance.largest, 0);
    EXPECT_EQ(found->distance.ulps, 0);
    EXPECT_EQ(found->distance.surfaces.value_or(0), 0);
  }
}

/// The root mean square of the distances of control points.
double distance(const RuledRows& x, const RuledRows& y) { return distance_between(x, y).root_mean_square; }

// Members of the same family about the net that was found, at steps much smaller and larger than its distance.
TEST(Repair, NoMemberOfTheFamilyNearbyIsNearer) {
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    const KnotList<Q> u = knots(3, {0, 0, 0, 1, 2, 4, 4, 4});
    const RuledRows given = noisy(constant_sample(u, seed).rows, -10, seed);
    const auto found = nearest_developable(u, given);
    ASSERT_TRUE(found && found->family == NetFamily::constant);
    const double least = distance(given, found->rows);
    std::mt19937_64 rng(seed);
    double nearest = 1e9;
    for (const long exponent : {-11L, -14L, -17L, -20L}) {
      for (int trial = 0; trial < 40; ++trial) {
        const auto step = [&] {
          return Q(static_cast<int>(rng() % 2049) - 1024) * repair::power_of_two(exponent - 10);
        };
        std::vector<Point3> c = found->rows.c.points;
        Point3 d0 = found->rows.d.points.front();
        for (Point3& x : c) x += Point3(step(), step(), step());
        d0 += Point3(step(), step(), step());
        const auto d = linear_net<Q, Point3>(u, c, found->constants.front().lambda + step(),
                                             found->constants.front().m + step(), d0);
        nearest = std::min(nearest, distance(given, polynomial(c, d)));
      }
    }
    // Exact numbers may cost 1 %; steps of 2^-20 reach what is left of it.
    EXPECT_GE(nearest, least * (1 - 0.01));
    EXPECT_LE(nearest, least * (1 + 0.01)) << "the steps are too large to say anything";
  }
}

TEST(Repair, KnowsTheRootMeanSquareBeforeTheNumbersAreExact) {
  for (const Sample& sample : samples()) {
    if (has_weights(sample.rows)) continue;
    const RuledRows given = noisy(sample.rows, -20, 5);
    const auto found = nearest_developable(sample.u, given);
    ASSERT_TRUE(found);
    for (const FamilyDistance& family : found->families) {
      if (family.family != found->family || family.degree != found->degree) continue;
      EXPECT_NEAR(found->distance.root_mean_square / family.root_mean_square, 1, 0.01) << sample.name;
    }
  }
}

/// Rounded to `digits` decimal places, or to doubles for 0.
RuledRows rounded_rows(const RuledRows& rows, int digits) {
  RuledRows result = rows;
  const auto round = [&](Q& x) {
    const double scale = std::pow(10, digits);
    x = digits == 0 ? Q::from_double(x.to_double()) : Q(std::lround(x.to_double() * scale)) / Q(std::lround(scale));
  };
  for (WeightedPoints<Q, 3>* row : {&result.c, &result.d}) {
    for (Point3& x : row->points) {
      for (int j = 0; j < 3; ++j) round(x[j]);
    }
    for (Q& w : row->weights) round(w);
  }
  return result;
}

// FJ21, section 8.
TEST(Repair, GivesBackTheFunctionsOfTheWorkedExample) {
  const RuledRows exact{
      {{Point3(Q(0), Q(0), Q(0)), Point3(Q(3), Q(3), Q(0)), Point3(Q(4), Q(3), Q(0)), Point3(Q(5), Q(0), Q(0))},
       {Q(1), Q(1), q(3, 5), q(5, 6)}},
      {{Point3(Q(0), Q(0), Q(2)), Point3(Q(2), Q(2), Q(3)), Point3(q(3, 2), q(21, 22), q(135, 22)),
        Point3(q(293, 172), q(-189, 172), q(1215, 172))},
       {Q(1), Q(1), q(11, 15), q(43, 45)}}};
  const KnotList<Q> u = bezier_knots<Q>(3);
  ASSERT_TRUE(developable(u, exact));
  for (const int digits : {0, 6}) {
    const double accuracy = digits == 0 ? 1e-13 : 1e-4;
    const auto found = nearest_developable(u, rounded_rows(exact, digits));
    ASSERT_TRUE(found && found->constants.size() == 1) << digits;
    EXPECT_NEAR(found->constants.front().lambda.to_double(), -4.0 / 3, accuracy);
    EXPECT_NEAR(found->constants.front().m.to_double(), -2, accuracy);
    EXPECT_NEAR(found->constants.front().sigma.to_double(), 1, accuracy);
    EXPECT_LE(found->distance.largest, digits == 0 ? 4e-15 : 2e-6);
    EXPECT_LE(found->distance.ulps_of_largest, digits == 0 ? 4 : 1e10);
  }
}

RuledRows moved(const RuledRows& rows, const Q& factor, const Point3& by) {
  RuledRows result = rows;
  for (WeightedPoints<Q, 3>* row : {&result.c, &result.d}) {
    for (Point3& x : row->points) x = combine(factor, x, Q(1), by);
  }
  return result;
}

// From 1e-300 to 1e300, and far from the origin.
TEST(Repair, FollowsScaleAndTranslation) {
  for (const Sample& sample : {constant_sample(knots(2, {0, 0, 1, 3, 3}), 31), tangent_sample(2, 32),
                               rational_sample(bezier_knots<Q>(2), 33), cone_sample(bezier_knots<Q>(3), 34)}) {
    const RuledRows given = noisy(sample.rows, -24, 7);
    const auto plain = nearest_developable(sample.u, given);
    ASSERT_TRUE(plain);
    for (const long exponent : {-1000L, -3L, 1000L}) {
      const Q factor = repair::power_of_two(exponent) * Q(3);
      const auto scaled = nearest_developable(sample.u, moved(given, factor, Point3(Q(0), Q(0), Q(0))));
      ASSERT_TRUE(scaled);
      EXPECT_EQ(scaled->family, plain->family);
      EXPECT_NEAR(scaled->distance.relative / plain->distance.relative, 1, 0.02) << exponent;
      EXPECT_TRUE(developable(sample.u, scaled->rows));
    }
    for (const long exponent : {30L, 1000L}) {
      const Point3 by(repair::power_of_two(exponent) / Q(3), Q(-7), Q(1) / Q(3));
      const auto far = nearest_developable(sample.u, moved(given, Q(1), by));
      ASSERT_TRUE(far);
      EXPECT_EQ(far->family, plain->family);
      EXPECT_NEAR(far->distance.root_mean_square / plain->distance.root_mean_square, 1, 0.02);
    }
  }
}

TEST(Repair, FindsSomethingForAnyNet) {
  for (const std::uint64_t seed : {41U, 42U, 43U, 44U}) {
    for (const KnotList<Q>& u : {bezier_knots<Q>(1), bezier_knots<Q>(2), knots(1, {0, 1, 3, 4}),
                                 knots(3, {0, 0, 0, 1, 1, 1, 2, 2, 2}), knots(2, {0, 1, 1, 2, 3})}) {
      const RuledRows given = polynomial(row(u.last() + 1, seed), row(u.last() + 1, seed + 100));
      ASSERT_FALSE(developable(u, given));
      const auto found = nearest_developable(u, given);
      ASSERT_TRUE(found);
      EXPECT_TRUE(developable(u, found->rows));
      for (const FamilyDistance& family : found->families) {
        EXPECT_LE(found->distance.root_mean_square, 1.01 * family.root_mean_square) << name_of(family.family);
      }
    }
  }
}

// One row nearly a point, nearly the other row, rows nearly on lines.
TEST(Repair, NearlyDegenerateNets) {
  const KnotList<Q> u = knots(2, {0, 0, 1, 2, 2});
  const std::vector<Point3> c = row(4, 51);
  const std::vector<Point3> point(4, Point3(Q(1), Q(2), Q(9)));
  std::vector<Point3> line, other;
  for (int i = 0; i < 4; ++i) {
    line.push_back(Point3(Q(i), Q(2 * i), Q(0)));
    other.push_back(Point3(Q(i * i), Q(1), Q(7)));
  }
  for (const RuledRows& rows : {polynomial(c, point), polynomial(point, c), polynomial(c, c), polynomial(line, line),
                                polynomial(line, other)}) {
    const RuledRows given = noisy(rows, -40, 52);
    const auto found = nearest_developable(u, given);
    ASSERT_TRUE(found);
    EXPECT_TRUE(developable(u, found->rows));
    EXPECT_LE(found->distance.root_mean_square,
              1.5 * distance(given, rows) + (same(rows, polynomial(line, other)) ? 9 : 0));
  }
}

TEST(Repair, RefusesRowsThatDoNotFit) {
  const RuledRows rows = polynomial(row(3, 61), row(3, 62));
  EXPECT_THROW(nearest_developable(bezier_knots<Q>(3), rows), InvalidInput);
}

}  // namespace
}  // namespace torse::test
