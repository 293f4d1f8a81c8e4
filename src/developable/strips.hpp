// A ruled surface cut into strips between rulings, so narrow that two triangles are within a tolerance of each.
//   RuledPiece, RuledArcs       the Bezier pieces of a surface, scaled by a power of two
//   MeshPrecision               of the corners
//   MeshStrip, cut_strips       the strips
//   in_single_precision         a double rounded
//   most_mesh_strips            as many as there may be
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torse/developable/strip.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// As many strips as a surface may be cut into.
inline constexpr std::size_t most_mesh_strips = std::size_t{1} << 15;

/// Both rails over one piece, with equal numbers of points.
struct RuledPiece {
  ArcRow c;
  ArcRow d;
  /// The points where the rails begin and end: equal points in equal intervals, so that pieces meet in one vertex.
  std::array<Vec<Interval, 3>, 2> c_ends;
  std::array<Vec<Interval, 3>, 2> d_ends;
  /// Whether the tangents of the rails may jump where the piece begins.
  bool kink_before = false;
};

/// The pieces of a surface in order; lengths are to be multiplied by 2^exponent.
struct RuledArcs {
  std::vector<RuledPiece> pieces;
  int exponent = 0;
};

/// What the coordinates of a mesh are rounded to.
enum class MeshPrecision { single_float, double_float };

/// A point, or a vector of length 1.
using MeshVector = std::array<double, 3>;

/// The rulings from c[0] to d[0] and from c[1] to d[1], at `from` and `to` of a piece whose parameter is 0 to 1, and
/// all between them. Corners are points of the surface, rounded.
struct MeshStrip {
  std::size_t piece = 0;
  double from = 0;
  double to = 1;
  std::array<MeshVector, 2> c{};
  std::array<MeshVector, 2> d{};
  /// The normals c' x (d - c) and d' x (d - c) at the corners; none where they vanish.
  std::array<std::optional<MeshVector>, 2> c_normal{};
  std::array<std::optional<MeshVector>, 2> d_normal{};
  /// Every point of the strip is at most so far from its two triangles, and conversely.
  double deviation = 0;
};

/// x rounded to single precision. Without volatile GCC 12 at -O2 drops both conversions where it makes vectors of them.
inline double in_single_precision(double x) {
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

namespace detail {

/// The middle of an interval times 2^exponent, rounded; never -0.
inline double rounded_coordinate(const Interval& x, int exponent, MeshPrecision precision) {
  const double value = std::ldexp(x.lower() / 2 + x.upper() / 2, exponent);
  const double rounded = precision == MeshPrecision::single_float ? in_single_precision(value) : value;
  if (!std::isfinite(rounded)) {
    throw InvalidInput("points", precision == MeshPrecision::single_float
                                     ? "are beyond the numbers of single precision that the format has"
                                     : "are beyond the range of double");
  }
  return rounded == 0 ? 0 : rounded;
}

/// The first difference from an end's point, in the order of the others, that is certainly not zero: a multiple of the
/// one-sided tangent.
inline std::optional<Vec<Interval, 3>> tangent_at(const ArcPoints& points, bool end) {
  const std::size_t n = points.size() - 1;
  for (std::size_t j = 1; j <= n; ++j) {
    Vec<Interval, 3> step = end ? difference(points[n], points[n - j]) : difference(points[j], points[0]);
    for (int k = 0; k < 3; ++k) {
      if (!step[k].contains(0)) return step;
    }
  }
  return std::nullopt;
}

/// x / |x| to shade with; none where x may be zero.
inline std::optional<MeshVector> unit_vector(const Vec<Interval, 3>& x) {
  MeshVector y{};
  for (std::size_t j = 0; j < 3; ++j) y[j] = x[static_cast<int>(j)].lower() / 2 + x[static_cast<int>(j)].upper() / 2;
  const double length = std::hypot(y[0], y[1], y[2]);
  const bool zero = x[0].contains(0) && x[1].contains(0) && x[2].contains(0);
  if (zero || !(length > 0) || !std::isfinite(length)) return std::nullopt;
  for (double& v : y) v = v / length == 0 ? 0 : v / length;
  return y;
}

inline std::optional<MeshVector> normal_at(const ArcPoints& rail, bool end, const Vec<Interval, 3>& ruling) {
  const std::optional<Vec<Interval, 3>> tangent = tangent_at(rail, end);
  return tangent ? unit_vector(cross(*tangent, ruling)) : std::nullopt;
}

/// Cuts one surface.
class StripCutter {
 public:
  StripCutter(int exponent, double tolerance, MeshPrecision precision)
      : exponent_(exponent), tolerance_(tolerance), precision_(precision) {}

  /// Adds the strips of a piece.
  void cut(std::size_t piece, const RuledPiece& rails) {
    require_finite(rails.c, 0);
    require_finite(rails.d, 0);
    ends_ = &rails;
    cut(Part{piece, 0, 1}, rails.c, rails.d, 0);
  }

  std::vector<MeshStrip> take() { return std::move(strips_); }

 private:
  struct Part {
    std::size_t piece;
    double from;
    double to;
  };

  /// Halvings of a piece: parameters stay exact in double.
  static constexpr int depth = 48;

  /// Throws unless the weights certainly keep one sign, part by part.
  static void require_finite(const ArcRow& row, int level) {
    if (arc_points(row)) return;
    if (level == depth) throw InvalidInput("weights", "a weight of the rail vanishes: it goes to infinity");
    const auto [left, right] = halves(row);
    require_finite(left, level + 1);
    require_finite(right, level + 1);
  }

  void cut(const Part& part, const ArcRow& c_row, const ArcRow& d_row, int level) {
    const std::optional<ArcPoints> c = arc_points(c_row);
    const std::optional<ArcPoints> d = arc_points(d_row);
    if (c && d && accept(part, *c, *d)) return;
    if (level == depth) throw InvalidInput("tolerance", "is below what double arithmetic can certify here");
    const auto [c_left, c_right] = halves(c_row);
    const auto [d_left, d_right] = halves(d_row);
    const double middle = (part.from + part.to) / 2;
    cut({part.piece, part.from, middle}, c_left, d_left, level + 1);
    cut({part.piece, middle, part.to}, c_right, d_right, level + 1);
  }

  /// Adds the part as a strip if it is within the tolerance: its rails from their chords, the rounding of the corners,
  /// and the quadrangle of the rounded corners from its triangles.
  bool accept(const Part& part, const ArcPoints& c, const ArcPoints& d) {
    const double rails = std::max(rail_deviation(c), rail_deviation(d));
    if (!(rails <= tolerance_)) return false;
    const bool begin = part.from == 0;
    const bool end = part.to == 1;
    const Corner c0 = rounded(begin ? ends_->c_ends[0] : c.front());
    const Corner c1 = rounded(end ? ends_->c_ends[1] : c.back());
    const Corner d0 = rounded(begin ? ends_->d_ends[0] : d.front());
    const Corner d1 = rounded(end ? ends_->d_ends[1] : d.back());
    const double rounding = std::max({c0.error, c1.error, d0.error, d1.error});
    if (!(rounding <= tolerance_)) {
      throw InvalidInput("tolerance", "is below " + as_text(std::ldexp(rounding, exponent_)) +
                                          ", the rounding of the points in this format");
    }
    const Interval total = Interval::point(rails) + Interval::point(rounding) +
                           Interval::point(quad_deviation(c0.scaled, c1.scaled, d0.scaled, d1.scaled));
    if (!(total.upper() <= tolerance_)) return false;
    if (strips_.size() == most_mesh_strips) {
      throw InvalidInput("tolerance", "needs more than " + std::to_string(most_mesh_strips) + " strips");
    }
    const Vec<Interval, 3> first = difference(d.front(), c.front());
    const Vec<Interval, 3> last = difference(d.back(), c.back());
    strips_.push_back({.piece = part.piece,
                       .from = part.from,
                       .to = part.to,
                       .c = {c0.value, c1.value},
                       .d = {d0.value, d1.value},
                       .c_normal = {normal_at(c, false, first), normal_at(c, true, last)},
                       .d_normal = {normal_at(d, false, first), normal_at(d, true, last)},
                       .deviation = std::ldexp(total.upper(), exponent_)});
    return true;
  }

  struct Corner {
    MeshVector value{};
    Vec<Interval, 3> scaled{};
    double error = 0;
  };

  Corner rounded(const Vec<Interval, 3>& x) const {
    Corner corner;
    for (int j = 0; j < 3; ++j) {
      const double value = rounded_coordinate(x[j], exponent_, precision_);
      corner.value[static_cast<std::size_t>(j)] = value;
      corner.scaled[j] = Interval::point(std::ldexp(value, -exponent_));
    }
    corner.error = norm_bound(difference(corner.scaled, x)).upper();
    return corner;
  }

  int exponent_;
  double tolerance_;
  MeshPrecision precision_;
  const RuledPiece* ends_ = nullptr;
  std::vector<MeshStrip> strips_;
};

}  // namespace detail

/// Cuts the pieces, each by halving its parameter, until two triangles for each strip are within `tolerance` > 0 of it.
/// Throws InvalidInput naming "weights" where a rail has a point at infinity, "points" where a coordinate is out of
/// range, "tolerance" where that is too small: for the rounding of the coordinates, or for most_mesh_strips.
inline std::vector<MeshStrip> cut_strips(const RuledArcs& arcs, double tolerance, MeshPrecision precision) {
  detail::StripCutter cutter(arcs.exponent, std::ldexp(tolerance, -arcs.exponent), precision);
  for (std::size_t i = 0; i < arcs.pieces.size(); ++i) cutter.cut(i, arcs.pieces[i]);
  return cutter.take();
}

}  // namespace torse
