// Pairs of rails drawn at random, of the kinds that strips are made of, in the unit box.
//   RailKind, kind_of     which kind the pair with a number is of
//   draw_rails            the pair with a number: the same on every machine that rounds alike
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "torse/quasi/rail.hpp"

namespace torse::bench {

/// What a pair is like.
enum class RailKind { strip, hull, twisted, touching, mixed };

inline constexpr std::array<const char*, 5> rail_kinds{"random strips", "hulls", "twisted by 20 to 150 degrees",
                                                       "nearly touching", "different degrees and knots"};

inline RailKind kind_of(int id) { return static_cast<RailKind>(id % 5); }

namespace detail {

using quasi::Vector;

/// Numbers by formulas of our own: those of the standard distributions differ between libraries.
class Dice {
 public:
  explicit Dice(int id) : rng_(1234567 + 7919 * static_cast<std::uint64_t>(id)) {}

  double uniform(double from = 0, double to = 1) {
    return from + (to - from) * static_cast<double>(rng_() >> 11) * 0x1p-53;
  }
  int whole(int from, int to) { return from + static_cast<int>(rng_() % static_cast<std::uint64_t>(to - from + 1)); }
  /// After Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  Vector vector(double size) {
    const double x = normal(), y = normal();
    return size * Vector(x, y, normal());
  }

 private:
  std::mt19937_64 rng_;
};

/// Knots and control points of one rail.
struct Curve {
  KnotList<double> knots;
  std::vector<Vector> points;
};

/// Clamped knots for so many control points, the inner ones evenly spaced or up to 0.3 spaces off.
inline KnotList<double> clamped(int degree, int count, Dice& dice, bool even) {
  const int inner = count - 1 - degree;
  std::vector<double> list(static_cast<std::size_t>(degree), 0);
  for (int i = 1; i <= inner; ++i) list.push_back((i + (even ? 0 : dice.uniform(-0.3, 0.3))) / (inner + 1));
  list.insert(list.end(), static_cast<std::size_t>(degree), 1);
  return {degree, std::move(list)};
}

/// Control points on a segment, moved at random.
inline Curve segment_like(int degree, int count, const Vector& from, const Vector& to, double noise, Dice& dice) {
  Curve curve{clamped(degree, count, dice, dice.whole(0, 1) == 1), {}};
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / (count - 1);
    curve.points.push_back((1 - s) * from + s * to + dice.vector(noise));
  }
  return curve;
}

inline std::array<Curve, 2> strip(Dice& dice) {
  const double rise = 0.5 * dice.normal();
  const int first = dice.whole(5, 8), second = dice.whole(5, 8);
  Curve c = segment_like(3, first, {0, 0, 0}, {4, 0, 0}, 0.35, dice);
  return {c, segment_like(3, second, {0, 1.5, 0}, {4, 1.5, rise}, 0.35, dice)};
}

/// Chine and sheer of a hull: the beam grows from the bow on, the bow is raked.
inline std::array<Curve, 2> hull(Dice& dice) {
  const int count = 6;
  const KnotList<double> knots = clamped(3, count, dice, true);
  Curve c{knots, {}}, d{knots, {}};
  const double beam = dice.uniform(0.8, 1.6), flare = dice.uniform(0.3, 0.8), rake = dice.uniform(0, 0.5);
  const double fullness = dice.uniform(0.7, 0.9);
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / (count - 1);
    const double width = beam * std::pow(std::sin(0.15 + s * (std::numbers::pi / 2 - 0.15)), fullness);
    const double lift = (1 - s) * (1 - s);
    c.points.push_back(Vector(6 * s, 0.8 * width, 0.4 * lift) + dice.vector(0.04));
    d.points.push_back(Vector(6 * s - rake * (1 - s), width * (1 + 0.4 * flare), 1 + 0.3 * lift) + dice.vector(0.04));
  }
  return {c, d};
}

/// Both sides of a bent axis, turning around it.
inline std::array<Curve, 2> twisted(Dice& dice) {
  const int count = dice.whole(4, 7);
  const KnotList<double> knots = clamped(3, count, dice, true);
  Curve c{knots, {}}, d{knots, {}};
  const double turn = dice.uniform(20, 150) * std::numbers::pi / 180;
  const double bend = dice.uniform(0, 0.6), width = dice.uniform(0.5, 1.5);
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / (count - 1);
    const Vector axis(4 * s, bend * std::sin(3 * s), bend * std::cos(2 * s));
    const Vector side = width * Vector(0, std::cos(turn * s), std::sin(turn * s));
    c.points.push_back(axis - side + dice.vector(0.05));
    d.points.push_back(axis + side + dice.vector(0.05));
  }
  return {c, d};
}

/// The second rail comes near to the first one at an end or in the middle.
inline std::array<Curve, 2> touching(Dice& dice) {
  Curve c = segment_like(3, 6, {0, 0, 0}, {3, 0, 0}, 0.25, dice);
  Curve d = c;
  const int where = dice.whole(0, 2);
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(d.points.size() - 1);
    const double gap = 0.02 + (where == 0 ? s : where == 1 ? 1 - s : 4 * (s - 0.5) * (s - 0.5));
    const double along = 0.1 * dice.normal();
    d.points[i] += gap * Vector(along, 1, 0.6 * dice.normal());
  }
  return {c, d};
}

inline std::array<Curve, 2> mixed(Dice& dice) {
  const int m = dice.whole(2, 4), n = dice.whole(2, 5);
  const int first = m + dice.whole(2, 5), second = n + dice.whole(1, 5);
  Curve c = segment_like(m, first, {0, 0, 0}, {4, 0, 0}, 0.3, dice);
  return {c, segment_like(n, second, {0.2, 1.2, 0}, {3.6, 1.6, 0.5}, 0.3, dice)};
}

/// The rail of a curve moved by -origin and scaled.
inline quasi::Rail rail_of(const Curve& curve, const Vector& origin, double scale) {
  std::vector<Vec<double, 4>> rows;
  for (const Vector& x : curve.points) {
    const Vector y = scale * (x - origin);
    rows.emplace_back(1, y[0], y[1], y[2]);
  }
  return quasi::Rail(Spline<double, Vec<double, 4>>(curve.knots, std::move(rows)));
}

}  // namespace detail

/// Their control points fill the unit box: the paper scales its models so.
inline quasi::Rails draw_rails(int id) {
  detail::Dice dice(id);
  const auto draw = [&] {
    switch (kind_of(id)) {
      case RailKind::strip:
        return detail::strip(dice);
      case RailKind::hull:
        return detail::hull(dice);
      case RailKind::twisted:
        return detail::twisted(dice);
      case RailKind::touching:
        return detail::touching(dice);
      default:
        return detail::mixed(dice);
    }
  };
  const std::array<detail::Curve, 2> pair = draw();
  quasi::Vector low = pair[0].points.front(), high = low;
  for (const detail::Curve& curve : pair) {
    for (const quasi::Vector& x : curve.points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  }
  const double scale = 1 / (high - low).maxCoeff();
  return {detail::rail_of(pair[0], low, scale), detail::rail_of(pair[1], low, scale)};
}

}  // namespace torse::bench
