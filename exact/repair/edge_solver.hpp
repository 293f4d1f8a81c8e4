// Least squares for the edge of an EdgeMap whose constants are known.
//   Points<D>            points of an edge or of a net
//   EdgeSolver<D>        the matrix from edge to net, with its normal equations
//   contributions        what each constant adds to the net
//   weighted_product     the scalar product behind the squared distance
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "torse/exact/repair/banded.hpp"
#include "torse/exact/repair/edge_map.hpp"
#include "torse/exact/repair/frame.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {

template <int D>
using Points = std::vector<Vec<Real, D>>;

/// The sum of x_i . y_i / scale_i.
template <int D>
Real weighted_product(const Points<D>& x, const Points<D>& y, const std::vector<Real>& scale) {
  Real sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum += inner<D>(x[i], y[i]) / scale[i];
  return sum;
}

/// The contribution of constant m to the points of the net, at [m].
template <int D>
std::vector<Points<D>> contributions(const EdgeMap& map, std::size_t points, const Points<D>& edge) {
  std::vector<Points<D>> result(map.constants, Points<D>(points, PointTraits<Vec<Real, D>>::zero()));
  for (const EdgeTerm& term : map.terms) add_scaled(result[term.constant][term.point], term.value, edge[term.edge]);
  return result;
}

template <int D>
class EdgeSolver {
 public:
  /// `scale` has to outlive this object.
  EdgeSolver(const EdgeMap& map, const std::vector<Real>& scale, const std::vector<Real>& theta)
      : scale_(scale), edge_size_(map.edge_size), rows_(scale.size()) {
    for (const EdgeTerm& term : map.terms) {
      Row& row = rows_[term.point];
      if (row.values.empty()) row.first = term.edge;
      if (term.edge < row.first) {
        row.values.insert(row.values.begin(), row.first - term.edge, Real(0));
        row.first = term.edge;
      }
      if (term.edge - row.first >= row.values.size()) row.values.resize(term.edge - row.first + 1);
      row.values[term.edge - row.first] += term.value * theta[term.constant];
    }
    factor();
  }

  /// The edge whose net is nearest to x; nothing where it is not unique.
  std::optional<Points<D>> edge(const Points<D>& x) const {
    if (!factors_) return std::nullopt;
    Points<D> result(edge_size_, PointTraits<Vec<Real, D>>::zero());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t a = 0; a < rows_[i].values.size(); ++a) {
        add_scaled(result[rows_[i].first + a], rows_[i].values[a] / scale_[i], x[i]);
      }
    }
    factors_->forward(result);
    factors_->backward(result);
    return result;
  }

  /// x less the net of an edge.
  Points<D> remainder(Points<D> x, const Points<D>& edge) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t a = 0; a < rows_[i].values.size(); ++a) {
        add_scaled(x[i], -rows_[i].values[a], edge[rows_[i].first + a]);
      }
    }
    return x;
  }

  /// How much errors of an edge grow at most: the largest sum of a row's absolute values by the root of its scale.
  Real growth() const {
    Real most(0);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Real norm(0);
      for (const Real& x : rows_[i].values) norm += magnitude(x);
      most = std::max(most, norm / scale_[i].square_root());
    }
    return most;
  }

 private:
  /// A row of the matrix from its first entry that is not zero.
  struct Row {
    std::size_t first = 0;
    std::vector<Real> values{};
  };

  void factor() {
    std::size_t width = 0;
    for (const Row& row : rows_) width = std::max(width, row.values.size());
    std::vector<Real> diagonal(edge_size_);
    std::vector<std::vector<Real>> below;
    for (std::size_t e = 0; e < edge_size_; ++e) below.emplace_back(std::min(e, width));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      for (std::size_t a = 0; a < row.values.size(); ++a) {
        const std::size_t at = row.first + a;
        const Real weighted = row.values[a] / scale_[i];
        diagonal[at] += weighted * row.values[a];
        for (std::size_t b = 0; b < a; ++b) below[at][below[at].size() - (a - b)] += weighted * row.values[b];
      }
    }
    factors_ = BandedFactors::of(std::move(below), std::move(diagonal));
  }

  const std::vector<Real>& scale_;
  std::size_t edge_size_;
  std::vector<Row> rows_;
  std::optional<BandedFactors> factors_;
};

}  // namespace torse::repair
