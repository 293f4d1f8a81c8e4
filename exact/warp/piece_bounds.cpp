// Four pieces at a time, each in its own lane.
#include "torse/exact/warp/piece_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "torse/algebra/triple.hpp"
#include "torse/exact/warp/rounded_forms.hpp"
#include "torse/exact/warp/sliding_row.hpp"

namespace torse {
namespace {

constexpr int lanes = 4;
using Lanes = Eigen::Array<double, lanes, 1>;
constexpr int most_degree = SlidingRow<3>::most - 1;

/// A form per lane, in coefficients times binomials.
template <int Size>
using LaneForm = std::array<Lanes, static_cast<std::size_t>(Size)>;
using Vector = std::array<Lanes, 3>;
using Factor = std::array<LaneForm<most_degree + 1>, 3>;  // coordinate, coefficient

/// Coordinates outside are left to other arithmetics: products of eight of them stay far from overflow and underflow.
constexpr double largest = 0x1p120;
constexpr double smallest = 0x1p-120;

/// The frame may deviate from an orthonormal one by this in the products of its axes. Its singular values are then
/// within 2^-41 of 1, which changes sin^2 of an angle computed in it by less than frame_slack.
constexpr double frame_defect = 0x1p-44;
constexpr double frame_slack = 0x1p-36;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// h += x y.
void add_product(Lanes* h, const Lanes* x, int dx, const Lanes* y, int dy) {
  for (int i = 0; i <= dx; ++i) {
    for (int j = 0; j <= dy; ++j) h[i + j] += x[i] * y[j];
  }
}
/// h -= x y.
void subtract_product(Lanes* h, const Lanes* x, int dx, const Lanes* y, int dy) {
  for (int i = 0; i <= dx; ++i) {
    for (int j = 0; j <= dy; ++j) h[i + j] -= x[i] * y[j];
  }
}

/// Four pieces of degree n.
class Batch {
 public:
  Batch(int degree, double knot_error) : n_(degree), knot_error_(knot_error) {}

  /// Fills a lane: Bezier points of c' and d' (degree n-1) and of d - c (degree n), the largest coordinates of the
  /// control points that they come from, the length of the piece and the error of the control points of d - c.
  void set(int lane, const SlidingRow<6>& speed, const SlidingRow<4>& ruling, double speed_norm, double ruling_norm,
           double length, double coordinate_error) {
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < 3; ++j) {
        a_[at(j)][at(i)][lane] = speed[i][j];
        b_[at(j)][at(i)][lane] = speed[i][j + 3];
      }
    }
    for (int i = 0; i <= n_; ++i) {
      for (int j = 0; j < 3; ++j) w_[at(j)][at(i)][lane] = ruling[i][j];
    }
    speed_[lane] = speed_norm;
    ruling_[lane] = ruling_norm;
    length_[lane] = length;
    error_[lane] = coordinate_error;
  }

  /// The bounds of all lanes.
  void bound(std::array<PieceBound, lanes>& bounds) {
    measure();
    rotate();
    const Lanes upper = upper_bound();
    const Lanes at_begin = lower_bound(0, 0);
    const Lanes at_end = lower_bound(n_ - 1, n_);
    for (int lane = 0; lane < lanes; ++lane) bounds[at(lane)] = {at_begin[lane], at_end[lane], upper[lane]};
  }

 private:
  /// Whether the lanes are in range, the bounds V and W of their rotated coordinates, and the relative error `eta_` of
  /// whatever is computed from them: at most 5 factors with an error epsilon each, fewer than 16 (n + 2) operations,
  /// and two factors h.
  void measure() {
    const double means = n_ * (n_ + 1) / 2;
    const double fixed = (8 * means + 12) * rounding::unit + (3 * means + 1) * knot_error_;
    const Lanes epsilon = fixed + 2 * rounding::up * error_ / ruling_.min(length_ * speed_);
    constexpr double most_error = 0x1p-20;
    usable_ = speed_ >= smallest && speed_ <= largest && ruling_ >= smallest && ruling_ <= largest &&
              length_ * speed_ <= largest && epsilon <= most_error;
    eta_ = 6 * epsilon + 2 * knot_error_ + 16 * (n_ + 2) * rounding::unit;
    constexpr double root_of_three = 1.75;  // somewhat more
    speed_ *= root_of_three;
    ruling_ *= root_of_three;
  }

  static Vector sum(const Factor& x, int degree) {
    Vector total{x[0][0], x[1][0], x[2][0]};
    for (int i = 1; i <= degree; ++i) {
      for (std::size_t j = 0; j < 3; ++j) total[j] += x[j][at(i)];
    }
    return total;
  }

  /// Changes to a frame with the first axis along the mean ruling and the third one along a mean normal.
  void rotate() {
    const Vector a = sum(a_, n_ - 1);
    const Vector b = sum(b_, n_ - 1);
    const Vector w = sum(w_, n_);
    const Lanes opposite = (dot(a, b) >= 0).select(Lanes::Ones(), -Lanes::Ones());
    const Vector tangent{a[0] + opposite * b[0], a[1] + opposite * b[1], a[2] + opposite * b[2]};
    Vector third = cross(tangent, w);
    const Lanes square = dot(w, w);
    const Lanes scale = 1 / square.sqrt();
    const Vector first{w[0] * scale, w[1] * scale, w[2] * scale};
    const Lanes normal_scale = 1 / dot(third, third).sqrt();
    for (Lanes& x : third) x *= normal_scale;
    const Vector second = cross(third, first);
    usable_ = usable_ && (dot(first, first) - 1).abs() <= frame_defect &&
              (dot(third, third) - 1).abs() <= frame_defect && dot(first, third).abs() <= frame_defect;
    mean_square_ = square / ((n_ + 1) * (n_ + 1));
    const std::array<Vector, 3> frame{first, second, third};
    change(a_, n_ - 1, frame);
    change(b_, n_ - 1, frame);
    change(w_, n_, frame);
  }

  static void change(Factor& x, int degree, const std::array<Vector, 3>& frame) {
    for (int i = 0; i <= degree; ++i) {
      const Vector v{x[0][at(i)], x[1][at(i)], x[2][at(i)]};
      for (std::size_t j = 0; j < 3; ++j) x[j][at(i)] = dot(frame[j], v);
    }
  }

  /// x with its coefficients 0 ... degree times binomials.
  static Factor form(const Factor& x, int degree) {
    const auto& binomial = rounding::binomials.value[at(degree)];
    Factor f;
    for (std::size_t j = 0; j < 3; ++j) {
      for (int i = 0; i <= degree; ++i) f[j][at(i)] = binomial[at(i)] * x[j][at(i)];
    }
    return f;
  }

  template <std::size_t Size>
  static void clear(std::array<Lanes, Size>& f, int degree) {
    for (int i = 0; i <= degree; ++i) f[at(i)].setZero();
  }

  Lanes upper_bound() const {
    const int d = n_ - 1;
    const Factor a = form(a_, d), b = form(b_, d), start = form(w_, d);
    LaneForm<2 * most_degree> x, y, z;
    for (auto* f : {&x, &y, &z}) clear(*f, 2 * d);
    const auto minor = [d](auto& h, const Factor& p, const Factor& q) {
      add_product(h.data(), p[0].data(), d, q[1].data(), d);
      subtract_product(h.data(), p[1].data(), d, q[0].data(), d);
    };
    minor(x, a, b);
    minor(y, a, start);
    minor(z, b, start);
    LaneForm<3 * most_degree> det;
    clear(det, 3 * d);
    add_product(det.data(), a[2].data(), d, z.data(), 2 * d);
    subtract_product(det.data(), b[2].data(), d, y.data(), 2 * d);
    add_product(det.data(), start[2].data(), d, x.data(), 2 * d);
    return largest_quotient(numerator(det), denominator(x, y, z));
  }

  using Top = LaneForm<5 * most_degree>;

  /// [a, b, w] (|w|^2 + r^2).
  Top numerator(const LaneForm<3 * most_degree>& det) const {
    const Factor w = form(w_, n_);
    const auto& binomial = rounding::binomials.value[at(2 * n_)];
    LaneForm<2 * most_degree + 1> square;
    for (int i = 0; i <= 2 * n_; ++i) square[at(i)] = binomial[at(i)] * mean_square_;
    for (const auto& f : w) add_product(square.data(), f.data(), n_, f.data(), n_);
    Top f;
    clear(f, 5 * n_ - 3);
    add_product(f.data(), det.data(), 3 * n_ - 3, square.data(), 2 * n_);
    return f;
  }

  /// M N, raised in degree by n-1.
  Top denominator(const LaneForm<2 * most_degree>& x, const LaneForm<2 * most_degree>& y,
                  const LaneForm<2 * most_degree>& z) const {
    const int d = 2 * n_ - 2;
    LaneForm<2 * most_degree> m, n;
    m[0] = y[0];
    n[0] = z[0];
    for (int i = 1; i <= d; ++i) {
      const Lanes slope = length_ * x[at(i - 1)];
      m[at(i)] = y[at(i)] + (y[at(i - 1)] + slope);
      n[at(i)] = z[at(i)] + (z[at(i - 1)] + slope);
    }
    const Lanes slope = length_ * x[at(d)];
    m[at(d + 1)] = y[at(d)] + slope;
    n[at(d + 1)] = z[at(d)] + slope;
    Top f;
    clear(f, 5 * n_ - 3);
    add_product(f.data(), m.data(), d + 1, n.data(), d + 1);
    for (int degree = 2 * d + 3; degree <= 5 * n_ - 3; ++degree) {
      for (int i = degree; i > 0; --i) f[at(i)] += f[at(i - 1)];
    }
    return f;
  }

  /// The square of the largest quotient, its denominator times 2r.
  Lanes largest_quotient(const Top& numerator, const Top& denominator) const {
    const Lanes volume = 6 * speed_ * speed_ * ruling_;
    const Lanes numerator_error = volume * (3 * ruling_ * ruling_ + mean_square_) * eta_;
    const Lanes normal = 2 * speed_ * (ruling_ + length_ * speed_);
    const Lanes denominator_error = normal * normal * eta_;
    const Lanes sign = (denominator[0] >= 0).select(Lanes::Ones(), -Lanes::Ones());
    const auto& binomial = rounding::binomials.value[at(5 * n_ - 3)];
    Lanes most = Lanes::Zero();
    auto positive = usable_;
    for (int i = 0; i <= 5 * n_ - 3; ++i) {
      const Lanes below = sign * denominator[at(i)] - binomial[at(i)] * denominator_error;
      positive = positive && below > 0;
      most = most.max((numerator[at(i)].abs() + binomial[at(i)] * numerator_error) / below);
    }
    const Lanes square = most * most / (4 * mean_square_) * (1 + frame_slack) + rounding::underflow;
    return positive.select(square, Lanes::Constant(detail::infinity));
  }

  /// sin^2 at an end from the points there.
  Lanes lower_bound(int i, int j) const {
    const Vector a{a_[0][at(i)], a_[1][at(i)], a_[2][at(i)]};
    const Vector b{b_[0][at(i)], b_[1][at(i)], b_[2][at(i)]};
    const Vector w{w_[0][at(j)], w_[1][at(j)], w_[2][at(j)]};
    const Vector m = cross(a, w);
    const Vector n = cross(b, w);
    const Lanes size = speed_ * ruling_;
    const Lanes normal_error = 32 * size * size * eta_;
    const Lanes det = (dot(a, n).abs() - 6 * speed_ * size * eta_).max(0);
    const Lanes square = (dot(w, w) - 8 * ruling_ * ruling_ * eta_).max(0);
    const Lanes value = square * det * det / ((dot(m, m) + normal_error) * (dot(n, n) + normal_error));
    return (usable_ && value > rounding::underflow).select(value * (1 - frame_slack), Lanes::Zero());
  }

  int n_;
  double knot_error_;
  Factor a_, b_, w_;
  Lanes speed_, ruling_, length_, error_, mean_square_, eta_;
  Eigen::Array<bool, lanes, 1> usable_;
};

/// The largest coordinate of the points that act on a piece; `first` is the first of them.
template <int K>
double norm_of(const std::vector<Eigen::Array<double, K, 1>>& points, std::size_t first, int degree) {
  Eigen::Array<double, K, 1> norm = points[first].abs();
  for (int i = 1; i <= degree; ++i) norm = norm.max(points[first + at(i)].abs());
  return norm.maxCoeff();
}

/// The control points of c'/n and d'/n, and of d - c.
struct DifferenceRows {
  std::vector<Eigen::Array<double, 6, 1>> speed;
  std::vector<Eigen::Array<double, 4, 1>> ruling;

  explicit DifferenceRows(const RoundedNet<3>& net) : speed(net.c.size() - 1), ruling(net.c.size()) {
    for (std::size_t i = 0; i < ruling.size(); ++i) {
      ruling[i] << (net.d[i] - net.c[i]).array(), 0;
      if (i + 1 == ruling.size()) break;
      const double width = net.knots[i + at(net.degree)] - net.knots[i];
      speed[i] << (net.c[i + 1] - net.c[i]).array(), (net.d[i + 1] - net.d[i]).array();
      speed[i] /= width;
    }
  }
};

}  // namespace

std::vector<PieceBound> piece_bounds(const RoundedNet<3>& net, const std::vector<int>& pieces) {
  std::vector<PieceBound> bounds(pieces.size());
  const int n = net.degree;
  if (n > most_degree || pieces.empty()) return bounds;
  const DifferenceRows rows(net);
  const std::span<const double> knots(net.knots);
  const std::size_t begin = at(pieces.front() - 1);
  SlidingRow<6> speed(n - 1, knots.subspan(1), rows.speed, begin);
  SlidingRow<4> ruling(n, knots, rows.ruling, begin);
  Batch batch(n, net.knot_error);
  for (std::size_t first = 0; first < pieces.size(); first += lanes) {
    const std::size_t count = std::min<std::size_t>(lanes, pieces.size() - first);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (lane < count) {
        if (first + lane > 0) {
          speed.advance();
          ruling.advance();
        }
      }
      const std::size_t k = at(pieces[first + std::min(lane, count - 1)] - 1);
      batch.set(static_cast<int>(lane), speed, ruling, norm_of(rows.speed, k, n - 1), norm_of(rows.ruling, k, n),
                knots[k + at(n)] - knots[k + at(n - 1)], net.coordinate_error);
    }
    std::array<PieceBound, lanes> four;
    batch.bound(four);
    std::copy_n(four.begin(), count, bounds.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return bounds;
}

}  // namespace torse
