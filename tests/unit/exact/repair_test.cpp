// The nearest developable net: exact nets of every family with known errors, the oracle, and members of the families
// that must not be nearer.
#include "torse/exact/repair/nearest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "torse/developable/classify.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/spline/elevation.hpp"

namespace torse {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Row4 = Vec<Q, 4>;
using repair::RuledRows;

Q q(int num, int den) { return ratio<Q>(num, den); }

KnotList<Q> knots(int degree, const std::vector<int>& list) {
  std::vector<Q> u;
  for (int knot : list) u.push_back(Q(knot));
  return KnotList<Q>(degree, std::move(u));
}

/// An exactly developable surface, with the family that it was made by.
struct Sample {
  const char* name;
  KnotList<Q> u;
  RuledRows rows;
  NetFamily family;
};

std::vector<Q> ones(std::size_t count) { return std::vector<Q>(count, Q(1)); }

RuledRows polynomial(const std::vector<Point3>& c, const std::vector<Point3>& d) {
  return {{c, ones(c.size())}, {d, ones(d.size())}};
}

RuledRows rational(const std::vector<Row4>& p, const std::vector<Row4>& r) {
  const auto split = [](const std::vector<Row4>& rows) {
    WeightedPoints<Q, 3> net;
    for (const Row4& x : rows) {
      net.points.push_back(Point3(x[1] / x[0], x[2] / x[0], x[3] / x[0]));
      net.weights.push_back(x[0]);
    }
    return net;
  };
  return {split(p), split(r)};
}

/// A winding row of points whose first coordinates grow.
std::vector<Point3> row(int count, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto draw = [&] { return q(static_cast<int>(rng() % 401) - 200, 64); };
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) {
    const Q y = draw();
    points.push_back(Point3(Q(2 * i) + draw() / Q(4), y, draw()));
  }
  return points;
}

std::vector<Row4> weighted(const std::vector<Point3>& points, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<Row4> rows;
  for (const Point3& x : points) {
    const Q w = q(static_cast<int>(rng() % 5) + 6, 8);
    rows.push_back(Row4(w, w * x[0], w * x[1], w * x[2]));
  }
  return rows;
}

Sample constant_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  const auto d = linear_net<Q, Point3>(u, c, q(-7, 2), q(-9, 4), Point3(Q(1), Q(-3), Q(7)));
  return {"constant", u, polynomial(c, d), NetFamily::constant};
}

Sample rational_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  const auto d = rational_net<Q, Row4>(u, p, q(-7, 2), q(-9, 4), q(5, 4), Row4(Q(1), Q(1), Q(-3), Q(7)));
  return {"constant, rational", u, rational(p, d), NetFamily::constant};
}

Sample cylinder_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  std::vector<Q> lengths;
  for (std::size_t i = 0; i < c.size(); ++i) lengths.push_back(q(20 + static_cast<int>((i * i) % 7), 4));
  return {"cylinder", u, polynomial(c, cylinder_net<Q, Point3>(c, Point3(q(1, 3), Q(2), Q(-1)), lengths)),
          NetFamily::cylinder};
}

Sample cone_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  return {"cone", u, polynomial(c, cone_net<Q, Point3>(c, q(1, 3), Point3(Q(2), Q(1), Q(9)))), NetFamily::cone};
}

/// d = V + alpha (c - V) with other weights in each row of rulings: q_i = p_i / 2 + beta_i (1, V).
Sample rational_cone_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  std::vector<Row4> d;
  for (std::size_t i = 0; i < p.size(); ++i) {
    d.push_back(combine(q(1, 2), p[i], q(3 + static_cast<int>(i % 3), 7), Row4(Q(1), Q(3), Q(-1), Q(20))));
  }
  return {"cone, rational", u, rational(p, d), NetFamily::cone};
}

Sample rational_cylinder_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  std::vector<Row4> d;
  for (std::size_t i = 0; i < p.size(); ++i) {
    d.push_back(combine(q(3, 2), p[i], q(30 + static_cast<int>((i * i) % 5), 7), Row4(Q(0), Q(1), Q(-1), Q(3))));
  }
  return {"cylinder, rational", u, rational(p, d), NetFamily::cylinder};
}

Sample plane_sample(const KnotList<Q>& u, std::uint64_t seed, bool with_weights) {
  std::vector<Point3> c = row(u.last() + 1, seed);
  std::vector<Point3> d = row(u.last() + 1, seed + 1);
  for (std::vector<Point3>* points : {&c, &d}) {
    for (Point3& x : *points) x[2] = x[0] / Q(3) - Q(2) * x[1] + q(5, 7);
  }
  if (with_weights) {
    return {"plane, rational", u, rational(weighted(c, seed), weighted(d, seed + 2)), NetFamily::plane};
  }
  return {"plane", u, polynomial(c, d), NetFamily::plane};
}

/// Nets of FJ07.13 with other constants beyond the knot 2, joined at a common ruling.
Sample segments_sample(std::uint64_t seed, bool with_weights) {
  const KnotList<Q> u = knots(3, {0, 0, 0, 1, 2, 2, 2, 3, 3, 3});
  const KnotList<Q> left = knots(3, {0, 0, 0, 1, 2, 2, 2}), right = knots(3, {2, 2, 2, 3, 3, 3});
  const std::vector<Point3> points = row(u.last() + 1, seed);
  const std::vector<Row4> p = with_weights ? weighted(points, seed + 1) : homogeneous(polynomial(points, points).c);
  const Q sigma = with_weights ? q(5, 4) : Q(1);
  const std::vector<Row4> first(p.begin(), p.begin() + left.last() + 1), second(p.begin() + left.last(), p.end());
  auto d = rational_net<Q, Row4>(left, first, q(-7, 2), q(-9, 4), sigma, Row4(Q(1), Q(1), Q(-3), Q(7)));
  const auto rest = rational_net<Q, Row4>(right, second, q(-4, 3), q(1, 5), Q(1) / sigma, d.back());
  d.insert(d.end(), rest.begin() + 1, rest.end());
  return {with_weights ? "segments, rational" : "segments", u, rational(p, d), NetFamily::segments};
}

/// Planar quadrilaterals in a strip.
Sample strip_sample(std::uint64_t seed) {
  const KnotList<Q> u = knots(1, {0, 1, 3, 4, 6, 7});
  const std::vector<Point3> c = row(u.last() + 1, seed);
  std::vector<Point3> d{Point3(Q(0), Q(1), Q(9))};
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    Point3 next =
        combine(Q(1) + q(static_cast<int>(i), 20), difference(c[i + 1], c[i]), q(2, 19), difference(d[i], c[i]));
    add(next, d[i]);
    d.push_back(next);
  }
  return {"strip", u, polynomial(c, d), NetFamily::segments};
}

/// The surface of tangents c + v c' of one piece.
Sample tangent_sample(int degree, std::uint64_t seed) {
  const std::vector<Point3> c = row(degree + 1, seed);
  return {"tangents", bezier_knots<Q>(degree), polynomial(c, tangent_net<Q, Point3>(c)), NetFamily::edge};
}

Sample elevated_sample(const Sample& sample) {
  const Spline<Q, Point3> c = elevate(Spline<Q, Point3>(sample.u, sample.rows.c.points));
  const Spline<Q, Point3> d = elevate(Spline<Q, Point3>(sample.u, sample.rows.d.points));
  return {"elevated", c.knots, polynomial(c.control, d.control), NetFamily::edge};
}

std::vector<Sample> samples() {
  const KnotList<Q> smooth = knots(3, {0, 0, 0, 1, 2, 4, 4, 4});
  const KnotList<Q> loose = knots(2, {0, 1, 2, 4, 5});
  const KnotList<Q> piece = bezier_knots<Q>(3, Q(0), Q(4));
  return {constant_sample(smooth, 1),
          constant_sample(loose, 2),
          constant_sample(piece, 3),
          rational_sample(smooth, 4),
          rational_sample(piece, 5),
          cylinder_sample(smooth, 6),
          cylinder_sample(loose, 7),
          cone_sample(smooth, 8),
          rational_cone_sample(smooth, 9),
          rational_cylinder_sample(loose, 10),
          plane_sample(smooth, 11, false),
          plane_sample(loose, 12, true),
          tangent_sample(3, 13),
          elevated_sample(constant_sample(loose, 14)),
          elevated_sample(constant_sample(bezier_knots<Q>(2), 15)),
          segments_sample(16, false),
          segments_sample(17, true),
          strip_sample(18)};
}

/// The rows with every coordinate moved by up to 2^exponent.
RuledRows noisy(const RuledRows& rows, long exponent, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  RuledRows result = rows;
  const Q unit = repair::power_of_two(exponent - 10);
  for (WeightedPoints<Q, 3>* row : {&result.c, &result.d}) {
    for (Point3& x : row->points) {
      for (int j = 0; j < 3; ++j) x[j] += Q(static_cast<int>(rng() % 2049) - 1024) * unit;
    }
  }
  return result;
}

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
      // The exact net without errors is in the family. Between points nothing of it is nearer but by the share of the
      // rounding, 1 %; between rows the distance counts weights too, which the errors left alone.
      EXPECT_LE(found->distance.root_mean_square, has_weights(sample.rows) ? 3 * error : 1.01 * error);
      EXPECT_GT(found->distance.root_mean_square, 0);
      EXPECT_FALSE(same(found->rows, given));
      if (sample.family == NetFamily::plane) {
        EXPECT_EQ(classify<Q>(sample.u, homogeneous(found->rows.c), homogeneous(found->rows.d)).kind,
                  SurfaceClass::plane);
        EXPECT_EQ(found->distance.weights, 0);
      }
    }
  }
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

TEST(RepairDistance, CountsByHand) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  RuledRows after = before;
  after.c.points[1][0] += repair::power_of_two(-50);         // 4 units in the last place of 1
  after.d.points[1][1] += Q(3) * repair::power_of_two(-51);  // 3 units of 3
  after.d.points[0][0] += repair::power_of_two(-60);         // a coordinate 0
  const NetDistance distance = distance_between(before, after);
  const double unit = std::ldexp(1, -51);
  EXPECT_DOUBLE_EQ(distance.largest, 3 * unit);
  EXPECT_NEAR(distance.root_mean_square, unit * std::sqrt((4 + 9) / 4.0), 1e-5 * unit);
  EXPECT_EQ(distance.ulps, 4);
  EXPECT_DOUBLE_EQ(distance.ulps_of_largest, 1.5);  // of 4, which are 2^-50
  EXPECT_NEAR(distance.relative, 3 * unit / std::sqrt(2.25 + 9 + 16), 1e-10 * unit);
  EXPECT_EQ(distance.weights, 0);
  EXPECT_EQ(distance.surfaces, distance.largest);

  after = before;
  after.c.weights[0] = q(4, 3);
  EXPECT_NEAR(distance_between(before, after).weights, 0.25, 1e-15);
  EXPECT_NEAR(distance_between(before, after).surfaces.value(), std::sqrt(27.25) / 4, 1e-14);
  after.c.weights[0] = Q(-1);
  EXPECT_FALSE(distance_between(before, after).surfaces);
  EXPECT_FALSE(distance_between(after, before).surfaces);
}

/// A length that is over a double by less than 106 bits can tell.
TEST(RepairDistance, IsRoundedUpwardsHoweverLittle) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  RuledRows after = before;
  after.d.points[0][0] += Q(1);
  after.d.points[0][1] += repair::power_of_two(-80);
  EXPECT_GT(distance_between(before, after).largest, 1);
}

/// No double has these lengths and quotients: the numbers are above, and the next ones below are not.
TEST(RepairDistance, IsRoundedUpwards) {
  const RuledRows before = polynomial({Point3(Q(0), Q(0), Q(0)), Point3(Q(1), Q(0), Q(0))},
                                      {Point3(Q(0), Q(3), Q(0)), Point3(q(3, 2), Q(3), Q(4))});
  const auto exact = [](double x) { return Q::from_double(x); };
  const auto below = [](double x) { return Q::from_double(std::nextafter(x, 0)); };
  for (const int n : {2, 3, 5, 6, 7, 10}) {
    RuledRows after = before;
    const Q unit = repair::power_of_two(-20);
    after.c.points[1][0] += unit;
    after.c.points[1][1] += Q(n) * unit;
    const Q square = (Q(1) + Q(n * n)) * unit * unit;
    const NetDistance distance = distance_between(before, after);
    EXPECT_GE(exact(distance.largest) * exact(distance.largest), square);
    EXPECT_LT(below(distance.largest) * below(distance.largest), square);
    EXPECT_GE(Q(4) * exact(distance.root_mean_square) * exact(distance.root_mean_square), square);
    after.c.weights[0] = Q(n) / Q(n + 1);
    const double weights = distance_between(before, after).weights;
    EXPECT_GE(exact(weights), Q(1) / Q(n));
    EXPECT_LE(below(weights), Q(1) / Q(n));
  }
}

// The bound of the distance of surfaces holds at samples, also with weights.
TEST(RepairDistance, BoundsTheSurfaces) {
  const Sample sample = rational_sample(bezier_knots<Q>(2), 71);
  RuledRows other = noisy(sample.rows, -6, 72);
  other.c.weights[1] += q(1, 50);
  const double bound = distance_between(sample.rows, other).surfaces.value();
  const auto at_point = [&](const RuledRows& rows, const Q& t, const Q& v) {
    const Row4 p = curve_point<Q, Row4>(sample.u, homogeneous(rows.c), 1, t);
    const Row4 x = combine(Q(1) - v, p, v, curve_point<Q, Row4>(sample.u, homogeneous(rows.d), 1, t));
    return Point3(x[1] / x[0], x[2] / x[0], x[3] / x[0]);
  };
  double largest = 0;
  for (int i = 0; i <= 10; ++i) {
    for (int k = 0; k <= 4; ++k) {
      const Point3 gap = difference(at_point(sample.rows, q(i, 10), q(k, 4)), at_point(other, q(i, 10), q(k, 4)));
      largest = std::max(largest, std::sqrt(dot(gap, gap).to_double()));
    }
  }
  EXPECT_LE(largest, bound);
  EXPECT_GE(largest, bound / 50);
}

}  // namespace
}  // namespace torse
