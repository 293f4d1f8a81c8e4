#include "torse/exact/quasi/least_squares.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "torse/quasi/mapping.hpp"
#include "torse/spline/basis.hpp"

namespace torse::quasi {

namespace {

/// The basis functions of a piece at t.
std::vector<double> basis_at(const KnotList<double>& u, int k, const std::vector<BinaryForm<double>>& forms, double t) {
  const double a = u.piece_begin(k);
  const double b = u.piece_end(k);
  std::vector<double> values;
  for (const BinaryForm<double>& form : forms) values.push_back(form((b - t) / (b - a), (t - a) / (b - a)));
  return values;
}

/// The r-th derivative of the Bezier polygon at its begin or end, divided by r!, over an interval of this length.
DoublePoint end_derivative(std::vector<DoublePoint> b, int r, bool at_end, double length) {
  double factor = 1;
  for (int i = 0; i < r; ++i) {
    factor *= static_cast<double>(static_cast<int>(b.size()) - 1) / (length * (i + 1));
    for (std::size_t j = 0; j + 1 < b.size(); ++j) b[j] = b[j + 1] - b[j];
    b.pop_back();
  }
  return factor * (at_end ? b.back() : b.front());
}

}  // namespace

std::vector<SurfaceSample> sampled(const DoubleSurface& surface, int count) {
  const KnotList<double>& u = surface.knots;
  std::vector<SurfaceSample> samples;
  for (int k : u.proper_pieces()) {
    for (int i = 0; i < count; ++i) {
      const double t = u.piece_begin(k) + (i + 0.5) / count * (u.piece_end(k) - u.piece_begin(k));
      samples.push_back({t, curve_point(u, surface.c_row(), k, t), curve_point(u, surface.d_row(), k, t)});
    }
  }
  return samples;
}

KnotList<double> knots_with(int degree, double a, double b, const std::vector<Breakpoint>& inside) {
  std::vector<double> list(static_cast<std::size_t>(degree), a);
  for (const Breakpoint& x : inside) list.insert(list.end(), static_cast<std::size_t>(x.multiplicity), x.t);
  list.insert(list.end(), static_cast<std::size_t>(degree), b);
  return KnotList<double>(degree, std::move(list));
}

std::optional<DoubleSurface> fitted_surface(const KnotList<double>& u, const std::vector<SurfaceSample>& samples,
                                            const DoubleSurface& like) {
  using Right = Eigen::Matrix<double, Eigen::Dynamic, 6>;
  const int n = u.degree();
  const int free = u.last() - 1;  // c_1..c_{L-1}
  std::vector<DoublePoint> c(static_cast<std::size_t>(u.last()) + 1, DoublePoint::Zero());
  std::vector<DoublePoint> d = c;
  c.front() = like.c.front();
  c.back() = like.c.back();
  d.front() = like.d.front();
  d.back() = like.d.back();
  if (free <= 0) return DoubleSurface(u, std::move(c), std::move(d));

  std::vector<Eigen::Triplet<double>> entries;
  Right right = Right::Zero(free, 6);
  int k = 0;
  std::vector<BinaryForm<double>> forms;
  for (const SurfaceSample& sample : samples) {
    if (const int here = piece_at(u, sample.t); here != k) {
      k = here;
      forms = basis_forms(u, k);
    }
    const std::vector<double> basis = basis_at(u, k, forms, sample.t);
    Eigen::Matrix<double, 1, 6> rest;
    rest << sample.c.transpose(), sample.d.transpose();
    for (int i = 0; i <= n; ++i) {  // of c and d only the ends are not zero yet
      const std::size_t at = static_cast<std::size_t>(k - 1 + i);
      rest.head<3>() -= basis[static_cast<std::size_t>(i)] * c[at].transpose();
      rest.tail<3>() -= basis[static_cast<std::size_t>(i)] * d[at].transpose();
    }
    for (int i = 0; i <= n; ++i) {
      const int row = k - 2 + i;
      if (row < 0 || row >= free) continue;
      right.row(row) += basis[static_cast<std::size_t>(i)] * rest;
      for (int j = 0; j <= i; ++j) {
        const int column = k - 2 + j;
        if (column < 0) continue;
        entries.emplace_back(row, column, basis[static_cast<std::size_t>(i)] * basis[static_cast<std::size_t>(j)]);
      }
    }
  }
  Eigen::SparseMatrix<double> normal(free, free);
  normal.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(normal);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Right solution = solver.solve(right);
  if (!solution.allFinite()) return std::nullopt;
  for (int i = 0; i < free; ++i) {
    c[static_cast<std::size_t>(i) + 1] = solution.row(i).head<3>().transpose();
    d[static_cast<std::size_t>(i) + 1] = solution.row(i).tail<3>().transpose();
  }
  return DoubleSurface(u, std::move(c), std::move(d));
}

std::vector<double> removal_costs(const DoubleSurface& surface, const std::vector<Breakpoint>& inside) {
  const KnotList<double>& u = surface.knots;
  const std::vector<int> pieces = u.proper_pieces();
  std::vector<double> costs;
  for (std::size_t i = 0; i < inside.size(); ++i) {  // pieces i and i + 1 meet there
    const int r = u.degree() - inside[i].multiplicity + 1;
    const double left = u.piece_end(pieces[i]) - u.piece_begin(pieces[i]);
    const double right = u.piece_end(pieces[i + 1]) - u.piece_begin(pieces[i + 1]);
    double largest = 0;
    for (const bool second : {false, true}) {
      const std::span<const DoublePoint> row = second ? surface.d_row() : surface.c_row();
      const DoublePoint jump = end_derivative(bezier_points(u, row, pieces[i + 1]), r, false, right) -
                               end_derivative(bezier_points(u, row, pieces[i]), r, true, left);
      largest = std::max(largest, jump.norm());
    }
    costs.push_back(largest * std::pow((left + right) / 2, r));
  }
  return costs;
}

}  // namespace torse::quasi
