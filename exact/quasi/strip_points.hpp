// A ruled surface by the Bezier points of its pieces, in any arithmetic.
//   StripPoint      a point of it and the derivatives there
//   StripPoints     the pieces
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"

namespace torse {

/// The point (1 - v) c + v d, its derivative by the share of the piece and the one by v, which is d - c.
template <Field S>
struct StripPoint {
  Vec<S, 3> point;
  Vec<S, 3> by_share;
  Vec<S, 3> by_v;
};

/// Two rails, each by the homogeneous Bezier points of its pieces, two or more of them.
template <Field S>
class StripPoints {
 public:
  using Rows = std::vector<Vec<S, 4>>;

  void push(Rows c, Rows d) {
    c_.push_back(std::move(c));
    d_.push_back(std::move(d));
  }

  std::size_t pieces() const { return c_.size(); }

  /// At this share of a piece and, along the ruling there, at v of the way from c to d.
  StripPoint<S> at(std::size_t piece, const S& share, const S& v) const {
    const auto [c, by_c] = curve(c_[piece], share);
    const auto [d, by_d] = curve(d_[piece], share);
    const S rest = from_int<S>(1) - v;
    return {combine(rest, c, v, d), combine(rest, by_c, v, by_d), difference(d, c)};
  }

 private:
  /// A point of a Bezier curve and its derivative by the share: by de Casteljau's algorithm, whose last step has the
  /// ends of the tangent.
  static std::pair<Vec<S, 3>, Vec<S, 3>> curve(Rows row, const S& share) {
    const S rest = from_int<S>(1) - share;
    const S degree = from_int<S>(static_cast<std::int64_t>(row.size()) - 1);
    for (std::size_t size = row.size(); size > 2; --size) {
      for (std::size_t i = 0; i + 1 < size; ++i) row[i] = combine(rest, row[i], share, row[i + 1]);
    }
    const Vec<S, 4> slope = scaled(degree, difference(row[1], row[0]));
    const Vec<S, 4> value = combine(rest, row[0], share, row[1]);
    Vec<S, 3> point;
    Vec<S, 3> by_share;
    for (int k = 0; k < 3; ++k) {
      point[k] = value[k + 1] / value[0];
      by_share[k] = (slope[k + 1] - slope[0] * point[k]) / value[0];
    }
    return {point, by_share};
  }

  std::vector<Rows> c_;
  std::vector<Rows> d_;
};

}  // namespace torse
