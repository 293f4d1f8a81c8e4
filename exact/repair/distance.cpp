// Exact differences, square roots and quotients rounded upwards.
#include "torse/exact/repair/distance.hpp"

#include <algorithm>
#include <array>

namespace torse {
namespace {

using Points = WeightedPoints<Rational, 3>;

Rational magnitude_of(const Rational& x) { return x.sign() < 0 ? -x : x; }

/// The smallest double that is not below x >= 0.
double upwards(const Rational& x) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, x.mpq(), MPFR_RNDU);
  const double result = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return result;
}

/// A double that is not below the square root of x >= 0.
double root_upwards(const Rational& x) {
  mpfr_t value;
  mpfr_init2(value, 106);
  mpfr_set_q(value, x.mpq(), MPFR_RNDU);
  mpfr_sqrt(value, value, MPFR_RNDU);
  const double result = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return result;
}

/// The unit in the last place of the double at x, which is not zero.
Rational unit_in_last_place(const Rational& x) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, x.mpq(), MPFR_RNDZ);
  const long exponent = mpfr_get_exp(value);
  mpfr_clear(value);
  return repair::power_of_two(std::max(exponent - 53, -1074L));
}

struct Rows {
  const Points& before;
  const Points& after;
};

Rational squared(const Vec<Rational, 3>& x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }

/// The squared diagonal of the bounding box of both rows.
Rational squared_diagonal(const std::array<Rows, 2>& rows) {
  Vec<Rational, 3> low = rows[0].before.points.front();
  Vec<Rational, 3> high = low;
  for (const Rows& row : rows) {
    for (const Vec<Rational, 3>& x : row.before.points) {
      for (int j = 0; j < 3; ++j) {
        low[j] = std::min<Rational>(low[j], x[j]);
        high[j] = std::max<Rational>(high[j], x[j]);
      }
    }
  }
  return squared(difference(high, low));
}

}  // namespace

NetDistance distance_between(const repair::RuledRows& before, const repair::RuledRows& after) {
  const std::array<Rows, 2> rows{Rows{before.c, after.c}, Rows{before.d, after.d}};
  Rational largest(0), sum(0), largest_change(0), largest_coordinate(0), ulps(0), weights(0);
  bool any_ulps = false, positive = true;
  for (const auto& [old, now] : rows) {
    for (std::size_t i = 0; i < old.points.size(); ++i) {
      const Vec<Rational, 3> change = difference(now.points[i], old.points[i]);
      const Rational square = squared(change);
      largest = std::max<Rational>(largest, square);
      sum += square;
      for (int j = 0; j < 3; ++j) {
        const Rational size = magnitude_of(change[j]);
        largest_change = std::max<Rational>(largest_change, size);
        largest_coordinate = std::max<Rational>(largest_coordinate, magnitude_of(old.points[i][j]));
        if (old.points[i][j].sign() == 0) continue;
        any_ulps = true;
        ulps = std::max<Rational>(ulps, size / unit_in_last_place(old.points[i][j]));
      }
      weights = std::max<Rational>(weights, magnitude_of((now.weights[i] - old.weights[i]) / old.weights[i]));
      positive = positive && old.weights[i].sign() > 0 && now.weights[i].sign() > 0;
    }
  }
  const Rational diagonal = squared_diagonal(rows);
  NetDistance distance;
  distance.largest = root_upwards(largest);
  distance.root_mean_square = root_upwards(sum / Rational(2 * static_cast<long>(before.c.points.size())));
  if (diagonal.sign() != 0) distance.relative = root_upwards(largest / diagonal);
  distance.weights = upwards(weights);
  if (any_ulps) distance.ulps = upwards(ulps);
  if (largest_coordinate.sign() != 0) {
    distance.ulps_of_largest = upwards(largest_change / unit_in_last_place(largest_coordinate));
  }
  if (positive && weights.sign() == 0) distance.surfaces = distance.largest;
  if (positive && weights.sign() != 0) {
    // (a + b)^2 <= 2 a^2 + 2 b^2 would lose accuracy; the sum of two doubles is rounded up by one step.
    distance.surfaces = std::nextafter(distance.largest + root_upwards(diagonal * weights * weights),
                                       std::numeric_limits<double>::infinity());
  }
  return distance;
}

}  // namespace torse
