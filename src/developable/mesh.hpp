// Triangle meshes of ruled surfaces, from their strips.
//   MeshCorner, TriangleMesh     points, normals, triangles
//   mesh_of_strips               equal points are one vertex, strips between equal points make one triangle or none
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "torse/developable/strips.hpp"

namespace torse {

/// Indices into the points and normals of a mesh.
struct MeshCorner {
  std::uint32_t point = 0;
  std::uint32_t normal = 0;
};

/// Triangles, counterclockwise seen from where the normals c' x (d - c) point to.
struct TriangleMesh {
  std::vector<MeshVector> points{};
  std::vector<MeshVector> normals{};
  std::vector<std::array<MeshCorner, 3>> triangles{};
  /// Every point of the surface is at most so far from a triangle, and conversely; infinite without triangles.
  double deviation = 0;
  /// The piece, counted from 0, where that is so.
  std::size_t worst_piece = 0;
};

namespace detail {

class MeshBuilder {
 public:
  explicit MeshBuilder(int exponent) : exponent_(exponent) {}

  /// `strip` must live until `take`.
  void add(const MeshStrip& strip, bool smooth_before) {
    const std::size_t before = mesh_.triangles.size();
    const std::array<std::uint32_t, 2> c{point(strip.c[0]), point(strip.c[1])};
    const std::array<std::uint32_t, 2> d{point(strip.d[0]), point(strip.d[1])};
    const std::array<Pair, 2> at{smooth_before && last_ ? *last_ : normals_at(strip, 0), normals_at(strip, 1)};
    last_ = at[1];
    const MeshCorner c0{c[0], at[0].c};
    const MeshCorner c1{c[1], at[1].c};
    const MeshCorner d0{d[0], at[0].d};
    const MeshCorner d1{d[1], at[1].d};
    if (distance(strip.c[0], strip.d[1]) < distance(strip.c[1], strip.d[0])) {
      add_triangle({c0, c1, d1});
      add_triangle({c0, d1, d0});
    } else {
      add_triangle({c0, c1, d0});
      add_triangle({c1, d1, d0});
    }
    if (mesh_.triangles.size() == before) {
      flat_.push_back(&strip);
      return;
    }
    note(strip.deviation, strip.piece);
    count_flat(Ruling{strip.c[0], strip.d[0]});
    covered_ = Ruling{strip.c[1], strip.d[1]};
  }

  TriangleMesh take() {
    count_flat(std::nullopt);
    return std::move(mesh_);
  }

 private:
  struct Ruling {
    MeshVector c;
    MeshVector d;
  };

  /// The normals at the ends of a ruling.
  struct Pair {
    std::uint32_t c;
    std::uint32_t d;
  };

  void note(double deviation, std::size_t piece) {
    if (deviation <= mesh_.deviation) return;
    mesh_.deviation = deviation;
    mesh_.worst_piece = piece;
  }

  /// The strips since `covered_` have no triangles: they are as far from the mesh as from the rulings where it ends and
  /// begins again.
  void count_flat(const std::optional<Ruling>& after) {
    for (const MeshStrip* strip : flat_) {
      double gap = std::numeric_limits<double>::infinity();
      for (const std::optional<Ruling>& ruling : {covered_, after}) {
        if (ruling) gap = std::min(gap, gap_between(*strip, *ruling));
      }
      if (std::isfinite(gap)) gap = (Interval::point(strip->deviation) + Interval::point(gap)).upper();
      note(gap, strip->piece);
    }
    flat_.clear();
  }

  /// A bound of the distance of the strip's segments from the ruling: it is a convex function, so the corners decide.
  double gap_between(const MeshStrip& strip, const Ruling& ruling) const {
    double most = 0;
    for (const std::size_t end : {0U, 1U}) {
      most = std::max({most, distance_bound(strip.c[end], ruling), distance_bound(strip.d[end], ruling)});
    }
    return most;
  }

  /// A bound of the distance of x from the ruling: that from the point of it which doubles take for the nearest.
  double distance_bound(const MeshVector& x, const Ruling& ruling) const {
    double along = 0;
    double squared = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const double w = std::ldexp(ruling.d[j] - ruling.c[j], -exponent_);
      along += w * std::ldexp(x[j] - ruling.c[j], -exponent_);
      squared += w * w;
    }
    const double v = along > 0 ? std::min(along / squared, 1.0) : 0;
    Vec<Interval, 3> e;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto scaled = [&](const MeshVector& y) { return Interval::point(std::ldexp(y[j], -exponent_)); };
      const Interval share = Interval::point(v);
      const Interval rest = Interval::point(1) - share;
      e[static_cast<int>(j)] = scaled(x) - (rest * scaled(ruling.c) + share * scaled(ruling.d));
    }
    return std::ldexp(norm_bound(e).upper(), exponent_);
  }

  static double distance(const MeshVector& x, const MeshVector& y) {
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
  }

  std::uint32_t point(const MeshVector& x) {
    const auto [at, inserted] = index_.try_emplace(x, static_cast<std::uint32_t>(mesh_.points.size()));
    if (inserted) mesh_.points.push_back(x);
    return at->second;
  }

  std::uint32_t normal(const MeshVector& x) {
    if (mesh_.normals.empty() || mesh_.normals.back() != x) mesh_.normals.push_back(x);
    return static_cast<std::uint32_t>(mesh_.normals.size() - 1);
  }

  /// Where a normal vanishes, that of the ruling's other end stands for it, or one of the other ruling, or of the
  /// quadrangle.
  Pair normals_at(const MeshStrip& strip, std::size_t end) {
    const auto either = [](const auto& x, const auto& y) { return x ? x : y; };
    const auto& c = strip.c_normal;
    const auto& d = strip.d_normal;
    const std::optional<MeshVector> other = either(c[1 - end], d[1 - end]);
    const MeshVector spare = other ? *other : facet(strip);
    const MeshVector at_c = either(c[end], d[end]).value_or(spare);
    const MeshVector at_d = either(d[end], c[end]).value_or(spare);
    const std::uint32_t first = normal(at_c);
    return {first, normal(at_d)};
  }

  /// The unit vector across both diagonals; any one where they are parallel.
  static MeshVector facet(const MeshStrip& strip) {
    Vec<Interval, 3> e;
    Vec<Interval, 3> f;
    for (std::size_t j = 0; j < 3; ++j) {
      e[static_cast<int>(j)] = Interval::point(strip.d[1][j]) - Interval::point(strip.c[0][j]);
      f[static_cast<int>(j)] = Interval::point(strip.d[0][j]) - Interval::point(strip.c[1][j]);
    }
    return unit_vector(cross(e, f)).value_or(MeshVector{0, 0, 1});
  }

  void add_triangle(const std::array<MeshCorner, 3>& t) {
    if (t[0].point == t[1].point || t[1].point == t[2].point || t[2].point == t[0].point) return;
    mesh_.triangles.push_back(t);
  }

  int exponent_;
  TriangleMesh mesh_;
  std::vector<const MeshStrip*> flat_;
  std::optional<Ruling> covered_;
  std::map<MeshVector, std::uint32_t> index_;
  std::optional<Pair> last_;
};

}  // namespace detail

/// The mesh of the strips of `arcs`: two triangles each, on the shorter diagonal, without those of which two corners
/// are one point. A strip of which none is left counts in the deviation by its distance from the strips beside it. A
/// corner at a kink has a normal for either side.
inline TriangleMesh mesh_of_strips(const RuledArcs& arcs, const std::vector<MeshStrip>& strips) {
  detail::MeshBuilder builder(arcs.exponent);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const bool same_piece = i > 0 && strips[i].piece == strips[i - 1].piece;
    builder.add(strips[i], same_piece || !arcs.pieces[strips[i].piece].kink_before);
  }
  return builder.take();
}

}  // namespace torse
