// The nearest nets with an edge of regression of lower degree: separable least squares.
#include <utility>

#include "torse/exact/repair/edge_solver.hpp"
#include "torse/exact/repair/edge_start.hpp"
#include "torse/exact/repair/families.hpp"

namespace torse::repair {
namespace {

/// With e what remains of the points after the best edge r: half the slope is -e . A_m r; Kaufman's approximation of
/// the curvature uses what remains of A_m r (BIT 15, 1975).
template <int D>
std::optional<Projection<D>> project_edge(const EdgeMap& map, const RealNet<D>& net, const std::vector<Real>& theta) {
  const EdgeSolver<D> solver(map, net.scale, theta);
  const auto edge = solver.edge(net.points);
  if (!edge) return std::nullopt;
  Projection<D> result{Real(0), solver.remainder(net.points, *edge), std::vector<Real>(map.constants),
                       zero_matrix(map.constants)};
  result.squared = weighted_product<D>(result.change, result.change, net.scale);
  std::vector<Points<D>> across = contributions<D>(map, net.size(), *edge);
  for (std::size_t m = 0; m < map.constants; ++m) {
    result.slope[m] = -weighted_product<D>(result.change, across[m], net.scale);
    const auto along = solver.edge(across[m]);
    across[m] = solver.remainder(std::move(across[m]), *along);
    for (std::size_t k = 0; k <= m; ++k) {
      result.curvature[m][k] = result.curvature[k][m] = weighted_product<D>(across[m], across[k], net.scale);
    }
  }
  return result;
}

template <int D>
std::optional<ExactNet<D>> realise_map(const EdgeMap& map, const RealNet<D>& net, const Descent<D>& descent) {
  const Accuracy accuracy(descent.nearest.squared, net.size());
  std::vector<Rational> theta;
  std::vector<Real> near;
  for (std::size_t m = 0; m < map.constants; ++m) {
    const Real tolerance = accuracy.tolerance(descent.nearest.curvature[m][m], map.constants - 1);
    theta.push_back(m == descent.fixed.front() ? Rational(1) : simplest_near(descent.theta[m], tolerance));
    near.push_back(Real::from_rational(theta.back()));
  }
  const EdgeSolver<D> solver(map, net.scale, near);
  const auto edge = solver.edge(net.points);
  if (!edge) return std::nullopt;
  ExactNet<D> r;
  for (const Vec<Real, D>& x : *edge) {
    r.push_back(rounded_point<D>(x, accuracy.exponent() - exponent_of(solver.growth())));
  }
  ExactNet<D> result(net.size(), PointTraits<Vec<Rational, D>>::zero());
  for (const EdgeTerm& term : map.terms) {
    add_scaled(result[term.point], term.coefficient * theta[term.constant], r[term.edge]);
  }
  return result;
}

/// The piece k as a surface of its own.
template <int D>
std::optional<std::vector<Real>> start_on(const KnotList<Rational>& u, const RealNet<D>& net, const EdgeFamily& family,
                                          int k) {
  const std::size_t n = static_cast<std::size_t>(u.degree());
  const std::size_t first = static_cast<std::size_t>(k - 1);
  const auto knots = u.list().begin() + (k - 1);
  RealNet<D> part;
  for (std::size_t i = 2 * first; i < 2 * (first + n + 1); ++i) {
    part.points.push_back(net.points[i]);
    part.scale.push_back(net.scale[i]);
  }
  return traced_constants<D>(KnotList<Rational>(u.degree(), {knots, knots + 2 * u.degree()}), part, family);
}

}  // namespace

template <int D>
std::optional<Candidate<D>> edge_candidate(const KnotList<Rational>& u, const RealNet<D>& net, int j,
                                           const Real& rival) {
  const EdgeFamily family{j, u.domain_begin(), u.domain_end(), D == 4};
  const auto map = edge_map(u, family);
  if (!map) return std::nullopt;
  const std::vector<int> pieces = u.proper_pieces();
  const auto start = start_on<D>(u, net, family, pieces[pieces.size() / 2]);
  if (!start) return std::nullopt;
  const auto descent = descend<D>([&](const std::vector<Real>& theta) { return project_edge<D>(*map, net, theta); },
                                  *start, map->constants, rival);
  if (!descent) return std::nullopt;
  return Candidate<D>{.squared = descent->nearest.squared,
                      .realise = [map, &net, descent] { return realise_map<D>(*map, net, *descent); },
                      .constants = {},
                      .converged = descent->converged};
}

template std::optional<Candidate<3>> edge_candidate<3>(const KnotList<Rational>&, const RealNet<3>&, int, const Real&);
template std::optional<Candidate<4>> edge_candidate<4>(const KnotList<Rational>&, const RealNet<4>&, int, const Real&);

}  // namespace torse::repair
