// The map from an edge of regression and constants to the two rows of a net; see edge_candidate.
//   EdgeFamily          which edges and constants
//   EdgeMap, edge_map   its terms
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/real.hpp"
#include "torse/spline/knots.hpp"

namespace torse::repair {

/// p = a r_S + b r_T, q = c r_S + d r_T with a, b, c, d of degree j in S = (end - t) / (end - begin), T = 1 - S.
struct EdgeFamily {
  int j;
  Rational begin;
  Rational end;
  bool homogeneous;  ///< rows, or points

  /// How many constants there are: the coefficients of S^j, S^{j-1} T, ..., T^j in a, b, c, d; for points, whose
  /// weights are 1, those of a and c and then kappa: a + b = c + d = kappa (S + T)^j.
  std::size_t constants() const {
    const std::size_t count = static_cast<std::size_t>(j) + 1;
    return homogeneous ? 4 * count : 2 * count + 1;
  }
};

/// coefficient * constant * (control point `edge` of r), a contribution to a point of the net.
struct EdgeTerm {
  std::size_t point;
  std::size_t constant;
  std::size_t edge;
  Rational coefficient;
  Real value;  ///< the coefficient, rounded
};

/// All of them. Points that share an edge point are neighbours: the edge points of a net's point lie within a degree.
struct EdgeMap {
  std::size_t constants;
  std::size_t edge_size;
  std::vector<EdgeTerm> terms;
};

/// The map for nets over u. The edge has degree n + 1 - j; where u has a knot of multiplicity m inside its domain, the
/// edge has one of multiplicity m - j, or none: the rows are as smooth as u allows. Nothing where a control point acts
/// on no piece of positive length.
std::optional<EdgeMap> edge_map(const KnotList<Rational>& u, const EdgeFamily& family);

}  // namespace torse::repair
