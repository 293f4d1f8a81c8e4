// Exactly developable surfaces of every family, for tests of the repair.
//   Sample, samples     a surface with the family that it was made by
//   noisy               its rows with known errors
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "support/knots.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/repair/nearest.hpp"
#include "torse/spline/elevation.hpp"

namespace torse::test {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Row4 = Vec<Q, 4>;
using repair::RuledRows;

inline Q q(int num, int den) { return ratio<Q>(num, den); }

/// An exactly developable surface, with the family that it was made by.
struct Sample {
  const char* name;
  KnotList<Q> u;
  RuledRows rows;
  NetFamily family;
};

inline std::vector<Q> ones(std::size_t count) { return std::vector<Q>(count, Q(1)); }

inline RuledRows polynomial(const std::vector<Point3>& c, const std::vector<Point3>& d) {
  return {{c, ones(c.size())}, {d, ones(d.size())}};
}

inline RuledRows rational(const std::vector<Row4>& p, const std::vector<Row4>& r) {
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
inline std::vector<Point3> row(int count, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto draw = [&] { return q(static_cast<int>(rng() % 401) - 200, 64); };
  std::vector<Point3> points;
  for (int i = 0; i < count; ++i) {
    const Q y = draw();
    points.push_back(Point3(Q(2 * i) + draw() / Q(4), y, draw()));
  }
  return points;
}

inline std::vector<Row4> weighted(const std::vector<Point3>& points, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<Row4> rows;
  for (const Point3& x : points) {
    const Q w = q(static_cast<int>(rng() % 5) + 6, 8);
    rows.push_back(Row4(w, w * x[0], w * x[1], w * x[2]));
  }
  return rows;
}

inline Sample constant_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  const auto d = linear_net<Q, Point3>(u, c, q(-7, 2), q(-9, 4), Point3(Q(1), Q(-3), Q(7)));
  return {"constant", u, polynomial(c, d), NetFamily::constant};
}

inline Sample rational_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  const auto d = rational_net<Q, Row4>(u, p, q(-7, 2), q(-9, 4), q(5, 4), Row4(Q(1), Q(1), Q(-3), Q(7)));
  return {"constant, rational", u, rational(p, d), NetFamily::constant};
}

inline Sample cylinder_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  std::vector<Q> lengths;
  for (std::size_t i = 0; i < c.size(); ++i) lengths.push_back(q(20 + static_cast<int>((i * i) % 7), 4));
  return {"cylinder", u, polynomial(c, cylinder_net<Q, Point3>(c, Point3(q(1, 3), Q(2), Q(-1)), lengths)),
          NetFamily::cylinder};
}

inline Sample cone_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Point3> c = row(u.last() + 1, seed);
  return {"cone", u, polynomial(c, cone_net<Q, Point3>(c, q(1, 3), Point3(Q(2), Q(1), Q(9)))), NetFamily::cone};
}

/// d = V + alpha (c - V) with other weights in each row of rulings: q_i = p_i / 2 + beta_i (1, V).
inline Sample rational_cone_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  std::vector<Row4> d;
  for (std::size_t i = 0; i < p.size(); ++i) {
    d.push_back(combine(q(1, 2), p[i], q(3 + static_cast<int>(i % 3), 7), Row4(Q(1), Q(3), Q(-1), Q(20))));
  }
  return {"cone, rational", u, rational(p, d), NetFamily::cone};
}

inline Sample rational_cylinder_sample(const KnotList<Q>& u, std::uint64_t seed) {
  const std::vector<Row4> p = weighted(row(u.last() + 1, seed), seed + 1);
  std::vector<Row4> d;
  for (std::size_t i = 0; i < p.size(); ++i) {
    d.push_back(combine(q(3, 2), p[i], q(30 + static_cast<int>((i * i) % 5), 7), Row4(Q(0), Q(1), Q(-1), Q(3))));
  }
  return {"cylinder, rational", u, rational(p, d), NetFamily::cylinder};
}

inline Sample plane_sample(const KnotList<Q>& u, std::uint64_t seed, bool with_weights) {
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
inline Sample segments_sample(std::uint64_t seed, bool with_weights) {
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
inline Sample strip_sample(std::uint64_t seed) {
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
inline Sample tangent_sample(int degree, std::uint64_t seed) {
  const std::vector<Point3> c = row(degree + 1, seed);
  return {"tangents", bezier_knots<Q>(degree), polynomial(c, tangent_net<Q, Point3>(c)), NetFamily::edge};
}

inline Sample elevated_sample(const Sample& sample) {
  const Spline<Q, Point3> c = elevate(Spline<Q, Point3>(sample.u, sample.rows.c.points));
  const Spline<Q, Point3> d = elevate(Spline<Q, Point3>(sample.u, sample.rows.d.points));
  return {"elevated", c.knots, polynomial(c.control, d.control), NetFamily::edge};
}

inline std::vector<Sample> samples() {
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
inline RuledRows noisy(const RuledRows& rows, long exponent, std::uint64_t seed) {
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

}  // namespace torse::test
