// The normal equations of the projection.
#include "torse/exact/repair/projection.hpp"

#include <utility>

#include "torse/exact/repair/banded.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// A row of B: its entries by points.
struct Entry {
  std::size_t point;
  Real value;
};
using Row = std::vector<Entry>;

std::vector<Row> rows_at(const BilinearSystem<Real>& system, const std::vector<Real>& theta) {
  std::vector<Row> rows;
  rows.reserve(system.equations.size());
  for (const auto& terms : system.equations) {
    Row row;
    for (const Term<Real>& term : terms) {
      if (row.empty() || row.back().point != term.point) row.push_back({term.point, Real(0)});
      row.back().value += term.coefficient * theta[term.constant];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// x . K y.
Real product(const Row& x, const Row& y, const std::vector<Real>& scale) {
  Real sum;
  for (std::size_t i = 0, j = 0; i < x.size() && j < y.size();) {
    if (x[i].point < y[j].point) {
      ++i;
    } else if (x[i].point > y[j].point) {
      ++j;
    } else {
      sum += x[i].value * y[j].value * scale[x[i].point];
      ++i, ++j;
    }
  }
  return sum;
}

std::optional<BandedFactors> factors_of(const std::vector<Row>& rows, const std::vector<Real>& scale) {
  std::vector<std::vector<Real>> below;
  std::vector<Real> diagonal;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::size_t first = r;
    while (first > 0 && rows[first - 1].back().point >= rows[r].front().point) --first;
    below.emplace_back();
    for (std::size_t s = first; s < r; ++s) below.back().push_back(product(rows[r], rows[s], scale));
    diagonal.push_back(product(rows[r], rows[r], scale));
  }
  return BandedFactors::of(std::move(below), std::move(diagonal));
}

/// B_m x for every constant m: a column of points, one for each equation.
template <int D>
std::vector<std::vector<Vec<Real, D>>> columns(const BilinearSystem<Real>& system,
                                               const std::vector<Vec<Real, D>>& points) {
  using Point = Vec<Real, D>;
  std::vector<std::vector<Point>> result(system.constants,
                                         std::vector<Point>(system.equations.size(), PointTraits<Point>::zero()));
  for (std::size_t r = 0; r < system.equations.size(); ++r) {
    for (const Term<Real>& term : system.equations[r]) {
      add_scaled(result[term.constant][r], term.coefficient, points[term.point]);
    }
  }
  return result;
}

/// The sum of the scalar products of two columns, each divided by its weight.
template <int D>
Real column_product(const std::vector<Vec<Real, D>>& x, const std::vector<Vec<Real, D>>& y,
                    const std::vector<Real>& weights) {
  Real sum;
  for (std::size_t r = 0; r < x.size(); ++r) sum += inner<D>(x[r], y[r]) / weights[r];
  return sum;
}

}  // namespace

template <int D>
std::optional<Projection<D>> project(const BilinearSystem<Real>& system, const RealNet<D>& net,
                                     const std::vector<Real>& theta) {
  using Point = Vec<Real, D>;
  const std::vector<Row> rows = rows_at(system, theta);
  const std::optional<BandedFactors> factors = factors_of(rows, net.scale);
  if (!factors) return std::nullopt;

  Projection<D> result{
      Real(0), std::vector<Point>(net.size(), PointTraits<Point>::zero()), {}, zero_matrix(system.constants)};
  std::vector<std::vector<Point>> y = columns<D>(system, net.points);
  std::vector<Point> mu(rows.size(), PointTraits<Point>::zero());
  for (std::size_t m = 0; m < y.size(); ++m) {
    factors->forward(y[m]);
    for (std::size_t r = 0; r < rows.size(); ++r) add_scaled(mu[r], theta[m], y[m][r]);
    for (std::size_t k = 0; k <= m; ++k) {
      result.curvature[m][k] = result.curvature[k][m] = column_product<D>(y[m], y[k], factors->pivots());
    }
  }
  result.squared = column_product<D>(mu, mu, factors->pivots());
  factors->backward(mu);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const Entry& entry : rows[r]) {
      add_scaled(result.change[entry.point], entry.value * net.scale[entry.point], mu[r]);
    }
  }
  std::vector<Point> nearest = net.points;
  for (std::size_t i = 0; i < nearest.size(); ++i) subtract(nearest[i], result.change[i]);
  const std::vector<Real> ones(rows.size(), Real(1));
  for (const std::vector<Point>& column : columns<D>(system, nearest)) {
    result.slope.push_back(column_product<D>(mu, column, ones));
  }
  return result;
}

template <int D>
std::vector<std::vector<Real>> first_constants(const BilinearSystem<Real>& system, const RealNet<D>& net) {
  Matrix squares = zero_matrix(system.constants);
  const auto y = columns<D>(system, net.points);
  const std::vector<Real> ones(system.equations.size(), Real(1));
  for (std::size_t m = 0; m < y.size(); ++m) {
    for (std::size_t k = 0; k < y.size(); ++k) squares[m][k] = column_product<D>(y[m], y[k], ones);
  }
  std::vector<std::vector<Real>> result;
  for (EigenPair& pair : symmetric_eigen(std::move(squares))) result.push_back(std::move(pair.vector));
  return result;
}

template std::optional<Projection<3>> project<3>(const BilinearSystem<Real>&, const RealNet<3>&,
                                                 const std::vector<Real>&);
template std::optional<Projection<4>> project<4>(const BilinearSystem<Real>&, const RealNet<4>&,
                                                 const std::vector<Real>&);
template std::vector<std::vector<Real>> first_constants<3>(const BilinearSystem<Real>&, const RealNet<3>&);
template std::vector<std::vector<Real>> first_constants<4>(const BilinearSystem<Real>&, const RealNet<4>&);

}  // namespace torse::repair
