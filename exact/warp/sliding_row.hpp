// Bezier points of one piece after another, from B-spline control points in doubles. Neighbours share their work: the
// points that knot insertion at the end of a piece leaves over begin the next one.
//   SlidingRow<K>      a row of points with K coordinates
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace torse {

/// A B-spline of degree m at most 8, piece by piece from the first one on. Every step is a mean of two points, with
/// weights that are not negative; a Bezier point takes at most m(m+1)/2 of them one upon the other. With u = 2^-53 and
/// differences of knots that are off by a relative e, a mean adds at most (8u + 3e) times the largest coordinate among
/// the piece's control points to the error.
template <int K>
class SlidingRow {
 public:
  using Point = Eigen::Array<double, K, 1>;
  static constexpr int most = 9;

  /// Control points and the list of their 2m knots and more in the papers' convention; both have to outlive this
  /// object. `first` is the index of the first piece that is not empty, from 0.
  SlidingRow(int degree, std::span<const double> knots, std::span<const Point> points, std::size_t first)
      : m_(degree), knots_(knots), points_(points), piece_(first) {
    for (int i = 0; i <= m_; ++i) row_[at(i)] = points_[piece_ + at(i)];
    std::array<Point, most> left;
    left[at(m_)] = row_[at(m_)];
    const double* t = local();
    const double a = t[m_ - 1];
    for (int r = 1; r <= m_; ++r) {
      for (int i = m_; i >= r; --i) insert(i, t[i - 1], t[i + m_ - r], a);
      left[at(m_ - r)] = row_[at(m_)];
    }
    row_ = left;
    make_bezier();
  }

  /// The Bezier points of the current piece.
  const Point& operator[](int i) const { return row_[at(i)]; }

  /// Moves on to the next piece that is not empty. There has to be one.
  void advance() {
    piece_ += at(multiplicity_);
    row_ = next_;
    make_bezier();
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const double* local() const { return knots_.data() + piece_; }

  /// Replaces point i, between the knots lo and hi, by its mean with the point before at x.
  void insert(int i, double lo, double hi, double x) {
    const double over = 1 / (hi - lo);
    row_[at(i)] = ((hi - x) * over) * row_[at(i - 1)] + ((x - lo) * over) * row_[at(i)];
  }

  /// Inserts the end b of the piece until it is m-fold. With b of multiplicity s and the further knots x_1, x_2, ...
  /// the last point is the blossom at (b^<s+r>, x_1, ..., x_{m-s-r}) after round r, a point of the next piece.
  void make_bezier() {
    const double* t = local();
    const double a = t[m_ - 1];
    const double b = t[m_];
    int s = 1;
    while (piece_ + at(m_ + s) < knots_.size() && t[m_ + s] == b) ++s;
    multiplicity_ = s;
    if (s <= m_) next_[at(m_ - s)] = row_[at(m_)];
    for (int i = std::max(1, s - m_); i <= s && piece_ + at(m_ + i) < points_.size(); ++i) {
      next_[at(m_ - s + i)] = points_[piece_ + at(m_ + i)];
    }
    for (int r = 1; r <= m_ - s; ++r) {
      for (int j = m_; j >= s + r; --j) insert(j, a, t[m_ + j - r], b);
      next_[at(m_ - s - r)] = row_[at(m_)];
    }
  }

  int m_;
  std::span<const double> knots_;
  std::span<const Point> points_;
  std::size_t piece_;
  int multiplicity_ = 1;
  std::array<Point, most> row_;
  std::array<Point, most> next_;
};

}  // namespace torse
