// Into the frame and out of it.
#include "torse/exact/repair/frame.hpp"

#include <algorithm>

namespace torse::repair {
namespace {

/// (x - centre) / 2^exponent, exactly rounded.
Vec<Real, 3> framed(const Vec<Rational, 3>& x, const Frame& frame) {
  const Rational scale = power_of_two(-frame.exponent);
  Vec<Real, 3> y;
  for (int j = 0; j < 3; ++j) y[j] = Real::from_rational((x[j] - frame.centre[j]) * scale);
  return y;
}

template <int D>
void append(RealNet<D>& net, const Vec<Rational, 3>& x, const Rational& weight, const Frame& frame) {
  const Vec<Real, 3> y = framed(x, frame);
  if constexpr (D == 3) {
    net.points.push_back(y);
    net.scale.push_back(Real(1));
  } else {
    const Real w = Real::from_rational(weight);
    net.points.push_back(Vec<Real, 4>(w, w * y[0], w * y[1], w * y[2]));
    net.scale.push_back(w * w);
  }
}

}  // namespace

Frame frame_of(const RuledRows& rows) {
  Vec<Rational, 3> low = rows.c.points.front();
  Vec<Rational, 3> high = low;
  for (const auto* points : {&rows.c.points, &rows.d.points}) {
    for (const Vec<Rational, 3>& x : *points) {
      for (int j = 0; j < 3; ++j) {
        if (x[j] < low[j]) low[j] = x[j];
        if (x[j] > high[j]) high[j] = x[j];
      }
    }
  }
  Rational extent(0);
  for (int j = 0; j < 3; ++j) extent = std::max<Rational>(extent, high[j] - low[j]);
  // The centre moves by less than a quarter of the extent when it is rounded to a multiple of 2^(exponent - 3).
  Frame frame{low, exponent_of(Real::from_rational(extent))};
  for (int j = 0; j < 3; ++j) {
    frame.centre[j] = rounded((low[j] + high[j]) / Rational(2), frame.exponent - 3);
  }
  return frame;
}

template <int D>
RealNet<D> real_net(const RuledRows& rows, const Frame& frame) {
  RealNet<D> net;
  for (std::size_t i = 0; i < rows.c.points.size(); ++i) {
    append(net, rows.c.points[i], rows.c.weights[i], frame);
    append(net, rows.d.points[i], rows.d.weights[i], frame);
  }
  return net;
}

Vec<Real, 3> mean_point(const RealNet<3>& net, std::size_t first, std::size_t step) {
  Vec<Real, 3> sum = PointTraits<Vec<Real, 3>>::zero();
  std::size_t count = 0;
  for (std::size_t i = first; i < net.size(); i += step, ++count) add(sum, net.points[i]);
  divide(sum, Real(count));
  return sum;
}

template <int D>
std::optional<RuledRows> rows_of(const ExactNet<D>& net, const Frame& frame, const RuledRows& original) {
  const Rational scale = power_of_two(frame.exponent);
  RuledRows rows;
  for (std::size_t i = 0; i < net.size(); ++i) {
    WeightedPoints<Rational, 3>& row = i % 2 == 0 ? rows.c : rows.d;
    const WeightedPoints<Rational, 3>& before = i % 2 == 0 ? original.c : original.d;
    const Rational weight = D == 3 ? Rational(1) : Rational(net[i][0]);
    if (weight.sign() == 0) return std::nullopt;
    Vec<Rational, 3> x;
    for (int j = 0; j < 3; ++j) x[j] = frame.centre[j] + scale * net[i][j + D - 3] / weight;
    row.points.push_back(x);
    row.weights.push_back(D == 3 ? before.weights[i / 2] : weight);
  }
  return rows;
}

template RealNet<3> real_net<3>(const RuledRows&, const Frame&);
template RealNet<4> real_net<4>(const RuledRows&, const Frame&);
template std::optional<RuledRows> rows_of<3>(const ExactNet<3>&, const Frame&, const RuledRows&);
template std::optional<RuledRows> rows_of<4>(const ExactNet<4>&, const Frame&, const RuledRows&);

}  // namespace torse::repair
