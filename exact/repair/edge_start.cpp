// The point where each ruling would touch the edge, a curve through these points, and the constants that suit it.
#include "torse/exact/repair/edge_start.hpp"

#include <array>
#include <utility>

#include "torse/algebra/bernstein.hpp"
#include "torse/exact/repair/edge_solver.hpp"
#include "torse/exact/repair/symmetric.hpp"
#include "torse/spline/basis.hpp"

namespace torse::repair {
namespace {

/// A homogeneous point for each of a few parameters: where the ruling would touch the edge. With the combination of the
/// derivatives alpha p_s + beta p_t + gamma q_s + delta q_t that is smallest, it is (beta s - alpha t) p + (delta s -
/// gamma t) q, whose derivative is nearly on the ruling.
template <int D>
std::vector<Vec<Real, 4>> traced_edge(const KnotList<Rational>& u, const RealNet<D>& net,
                                      const std::vector<Real>& parameters) {
  std::vector<std::array<BinaryForm<Real>, 4>> rows;
  const std::vector<BinaryForm<Rational>> basis = basis_forms(u, 1);
  for (std::size_t row = 0; row < 2; ++row) {
    rows.emplace_back();
    rows.back().fill(BinaryForm<Real>(u.degree()));
    for (std::size_t i = 0; i < basis.size(); ++i) {
      for (int k = 0; k <= u.degree(); ++k) {
        const Real b = Real::from_rational(basis[i][k]);
        const Vec<Real, D>& x = net.points[2 * i + row];
        for (int j = 0; j < 4; ++j) {
          const int from = j + D - 4;
          rows[row][static_cast<std::size_t>(j)][k] += from < 0 ? b : b * x[from];
        }
      }
    }
  }
  std::vector<Vec<Real, 4>> result;
  for (const Real& t : parameters) {
    const Real s = Real(1) - t;
    std::array<Vec<Real, 4>, 4> derivatives;
    std::array<Vec<Real, 4>, 2> points;
    for (std::size_t row = 0; row < 2; ++row) {
      for (int j = 0; j < 4; ++j) {
        const BinaryForm<Real>& f = rows[row][static_cast<std::size_t>(j)];
        points[row][j] = f(s, t);
        derivatives[2 * row][j] = f.derivative_s()(s, t);
        derivatives[2 * row + 1][j] = f.derivative_t()(s, t);
      }
    }
    Matrix gram = zero_matrix(4);
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) {
        for (int j = 0; j < 4; ++j) gram[a][b] += derivatives[a][j] * derivatives[b][j];
      }
    }
    const std::vector<Real> x = symmetric_eigen(std::move(gram)).front().vector;
    result.push_back(combine(x[1] * s - x[0] * t, points[0], x[3] * s - x[2] * t, points[1]));
  }
  return result;
}

/// The Bezier points of the curve of degree rho whose points at the parameters are nearest to the lines of these
/// homogeneous points. For D = 3 the curve has one weight for all, which is left out.
template <int D>
Points<D> fitted_edge(const std::vector<Real>& parameters, const std::vector<Vec<Real, 4>>& traced, int rho) {
  const std::size_t size = static_cast<std::size_t>(rho) + 1;
  const std::size_t unknowns = D == 4 ? 4 * size : 3 * size + 1;
  Matrix squares = zero_matrix(unknowns);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Real& t = parameters[i];
    Matrix rows(4, std::vector<Real>(unknowns));  // the curve's coordinates
    Real power(1);
    for (std::size_t k = 0; k < size; ++k) {
      Real value = Real::from_rational(binomial<Rational>(rho, static_cast<int>(k))) * power;
      for (std::size_t l = k + 1; l < size; ++l) value *= Real(1) - t;
      for (std::size_t j = 4 - D; j < 4; ++j) rows[j][k * D + j + D - 4] = value;
      power *= t;
    }
    if (D == 3) rows[0].back() = Real(1);
    Real length;
    for (int j = 0; j < 4; ++j) length += traced[i][j] * traced[i][j];
    if (length == Real(0)) continue;
    for (std::size_t a = 0; a < unknowns; ++a) {
      for (std::size_t b = 0; b < unknowns; ++b) {
        Real along_a, along_b;
        for (std::size_t j = 0; j < 4; ++j) {
          squares[a][b] += rows[j][a] * rows[j][b];
          along_a += rows[j][a] * traced[i][static_cast<int>(j)];
          along_b += rows[j][b] * traced[i][static_cast<int>(j)];
        }
        squares[a][b] -= along_a * along_b / length;
      }
    }
  }
  const std::vector<Real> best = symmetric_eigen(std::move(squares)).front().vector;
  Points<D> edge(size);
  for (std::size_t k = 0; k < size; ++k) {
    for (int j = 0; j < D; ++j) edge[k][j] = best[k * D + static_cast<std::size_t>(j)];
  }
  return edge;
}

}  // namespace

template <int D>
std::optional<std::vector<Real>> traced_constants(const KnotList<Rational>& u, const RealNet<D>& net,
                                                  const EdgeFamily& family) {
  const auto map = edge_map(u, family);
  if (!map) return std::nullopt;
  const int rho = u.degree() + 1 - family.j;
  std::vector<Real> parameters;
  const int samples = 4 * (rho + 1);
  for (int i = 0; i < samples; ++i) parameters.push_back(Real(2 * i + 1) / Real(2 * samples));
  const Points<D> edge = fitted_edge<D>(parameters, traced_edge<D>(u, net, parameters), rho);
  const std::vector<Points<D>> columns = contributions<D>(*map, net.size(), edge);
  Matrix normal = zero_matrix(map->constants);
  std::vector<Real> right;
  for (std::size_t m = 0; m < map->constants; ++m) {
    for (std::size_t k = 0; k < map->constants; ++k) {
      normal[m][k] = weighted_product<D>(columns[m], columns[k], net.scale);
    }
    right.push_back(weighted_product<D>(columns[m], net.points, net.scale));
  }
  return solve_positive(std::move(normal), std::move(right));
}

template std::optional<std::vector<Real>> traced_constants<3>(const KnotList<Rational>&, const RealNet<3>&,
                                                              const EdgeFamily&);
template std::optional<std::vector<Real>> traced_constants<4>(const KnotList<Rational>&, const RealNet<4>&,
                                                              const EdgeFamily&);

}  // namespace torse::repair
