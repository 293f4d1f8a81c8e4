// From exact control nets to intervals.
#include "torse/cli/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/exact/warp/quotient.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::cli {
namespace {

using Row = Vec<Rational, 4>;

/// Pieces times (degree + 1)^3: what their Bezier points may cost, as much as most_mesh_strips cubic ones.
constexpr double most_bezier_steps = 0x1p21;

struct ExactPiece {
  std::vector<Row> c;
  std::vector<Row> d;
  bool kink_before;
};

/// The Bezier rows of a piece, divided by their largest weight.
std::vector<Row> bezier_row(const KnotList<Rational>& u, std::span<const Row> row, int k) {
  std::vector<Row> points = bezier_points(u, row, k);
  Rational most;
  for (const Row& x : points) {
    const Rational size = x[0].sign() < 0 ? -x[0] : x[0];
    if (most < size) most = size;
  }
  if (most.sign() == 0) throw InvalidInput("weights", "are zero on a whole piece");
  for (Row& x : points) divide(x, most);
  return points;
}

std::vector<ExactPiece> exact_pieces(const RuledFile<Rational>& surface) {
  const std::vector<int> proper = surface.knots.proper_pieces();
  if (proper.size() > most_mesh_strips) {
    throw InvalidInput("tolerance", "needs more than " + std::to_string(most_mesh_strips) +
                                        " strips, one for each of " + std::to_string(proper.size()) +
                                        " pieces at least");
  }
  if (static_cast<double>(proper.size()) * std::pow(surface.knots.degree() + 1, 3) > most_bezier_steps) {
    throw InvalidInput("knots", "make " + std::to_string(proper.size()) + " pieces: too many of degree " +
                                    std::to_string(surface.knots.degree()) + " for a mesh");
  }
  const std::vector<Row> p = homogeneous(surface.c);
  const std::vector<Row> q = homogeneous(surface.d);
  std::vector<ExactPiece> pieces;
  int before = 0;
  for (int k : proper) {
    // Between two pieces lie as many empty ones as the knot is repeated.
    const bool kink = before != 0 && k - before >= surface.knots.degree();
    pieces.push_back({bezier_row(surface.knots, p, k), bezier_row(surface.knots, q, k), kink});
    before = k;
  }
  return pieces;
}

/// The largest extent in a coordinate.
Rational extent_of(const std::vector<ExactPiece>& pieces) {
  Rational most;
  for (int j = 1; j < 4; ++j) {
    std::vector<Rational> values;
    for (const ExactPiece& piece : pieces) {
      for (const std::vector<Row>* row : {&piece.c, &piece.d}) {
        for (const Row& x : *row) {
          if (x[0].sign() != 0) values.push_back(x[j] / x[0]);
        }
      }
    }
    const auto [low, high] = std::ranges::minmax(values);
    most = std::max(most, high - low);
  }
  return most;
}

/// e with 2^(e-2) < x < 2^(e+1), not below what leaves room for squares.
int exponent_of(const Rational& x) {
  constexpr int least = -1000;
  if (x.sign() == 0) throw InvalidInput("points", "coincide: there is no surface");
  const long exponent = static_cast<long>(x.numerator_bits()) - static_cast<long>(x.denominator_bits());
  if (exponent >= std::numeric_limits<double>::max_exponent) {
    throw InvalidInput("points", "are beyond the range of double");
  }
  return static_cast<int>(std::max<long>(exponent, least));
}

ArcRow enclosed(const std::vector<Row>& row, const Rational& factor) {
  ArcRow arc;
  for (const Row& x : row) {
    Vec<Interval, 4> y;
    y[0] = enclosure(x[0]);
    for (int j = 1; j < 4; ++j) y[j] = enclosure(x[j] * factor);
    arc.push_back(std::move(y));
  }
  return arc;
}

std::array<Vec<Interval, 3>, 2> enclosed_ends(const std::vector<Row>& row, const Rational& factor) {
  std::array<Vec<Interval, 3>, 2> ends;
  for (std::size_t i : {0U, 1U}) {
    const Row& x = i == 0 ? row.front() : row.back();
    if (x[0].sign() == 0) throw InvalidInput("weights", "the weight of the rail vanishes at an end of a piece");
    for (int j = 0; j < 3; ++j) ends[i][j] = enclosure(x[j + 1] / x[0] * factor);
  }
  return ends;
}

}  // namespace

RuledArcs arcs_of(const RuledFile<Rational>& surface) {
  const std::vector<ExactPiece> pieces = exact_pieces(surface);
  RuledArcs arcs;
  arcs.exponent = exponent_of(extent_of(pieces));
  const Rational factor = Rational(1) / Rational::from_double(std::ldexp(1.0, arcs.exponent));
  for (const ExactPiece& piece : pieces) {
    arcs.pieces.push_back({enclosed(piece.c, factor), enclosed(piece.d, factor), enclosed_ends(piece.c, factor),
                           enclosed_ends(piece.d, factor), piece.kink_before});
  }
  return arcs;
}

double default_tolerance(const RuledArcs& arcs) {
  std::array<double, 3> extent{};
  for (int j = 0; j < 3; ++j) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const RuledPiece& piece : arcs.pieces) {
      for (const ArcRow* row : {&piece.c, &piece.d}) {
        for (const Vec<Interval, 4>& x : *row) {
          if (x[0].contains(0)) continue;
          const double value = x[j + 1].lower() / x[0].lower();
          low = std::min(low, value);
          high = std::max(high, value);
        }
      }
    }
    extent[static_cast<std::size_t>(j)] = high - low;
  }
  constexpr double part = 1e-3;
  return part * std::ldexp(std::hypot(extent[0], extent[1], extent[2]), arcs.exponent);
}

TriangleMesh mesh_surface(const RuledArcs& arcs, double tolerance, MeshPrecision precision) {
  TriangleMesh mesh = mesh_of_strips(arcs, cut_strips(arcs, tolerance, precision));
  if (mesh.triangles.empty()) throw InvalidInput("points", "sweep no surface: both rails are one curve");
  if (mesh.deviation > tolerance) {
    throw InvalidInput("points", "sweep no surface in piece " + std::to_string(mesh.worst_piece + 1) +
                                     " farther than the tolerance from the rest: both rails are one curve there");
  }
  return mesh;
}

}  // namespace torse::cli
