// The nearest net of FJ07.13 and FJ21.7.1: constants by descent, simple fractions near them, and an exact edge.
#include <algorithm>
#include <array>
#include <utility>

#include "torse/exact/repair/banded.hpp"
#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// The better descent from the two best starts.
template <int D>
std::optional<Descent<D>> best_descent(const BilinearSystem<Real>& system, const RealNet<D>& net, Real rival) {
  const Projector<D> projector = [&](const std::vector<Real>& theta) { return project<D>(system, net, theta); };
  std::vector<std::pair<Real, std::vector<Real>>> starts;
  for (std::vector<Real>& theta : first_constants<D>(system, net)) {
    if (const auto projection = projector(theta)) starts.emplace_back(projection->squared, std::move(theta));
  }
  std::ranges::stable_sort(starts, {}, [](const auto& start) { return start.first; });
  constexpr std::size_t most_starts = 2;
  std::optional<Descent<D>> best;
  for (std::size_t i = 0; i < std::min(most_starts, starts.size()); ++i) {
    auto descent = descend<D>(projector, std::move(starts[i].second), rival);
    if (!descent || (best && !(descent->nearest.squared < best->nearest.squared))) continue;
    rival = std::min(rival, descent->nearest.squared);
    best = std::move(descent);
  }
  return best;
}

/// The parameter in which the domain is [-1, 1].
struct UnitDomain {
  Rational centre;
  Rational half;

  explicit UnitDomain(const KnotList<Rational>& u)
      : centre((u.domain_begin() + u.domain_end()) / Rational(2)),
        half((u.domain_end() - u.domain_begin()) / Rational(2)) {}

  std::vector<Real> knots(const KnotList<Rational>& u) const {
    std::vector<Real> list;
    for (const Rational& x : u.list()) list.push_back(Real::from_rational((x - centre) / half));
    return list;
  }
};

/// L*, M*, sigma as simple fractions near those of the descent, in the parameter of the file.
template <int D>
std::optional<RelationConstants> simple_constants(const Descent<D>& descent, const UnitDomain& domain,
                                                  std::size_t count) {
  std::vector<Real> theta = descent.theta;
  const Real w = theta[1];
  const Real w_other = D == 4 ? theta[3] : w;
  if (w == Real(0) || w_other == Real(0)) return std::nullopt;
  // The squared distance does not depend on a common factor of the constants: with w = 1 its curvature is w^2 that of
  // the descent.
  const auto curvature = [&](std::size_t i, std::size_t j) { return w * w * descent.nearest.curvature[i][j]; };
  const Real lambda = theta[0] / w;
  const Real m = theta[2] / w_other;
  const Real sigma = w_other / w;
  const Accuracy accuracy(descent.nearest.squared, count);
  const std::size_t constants = D - 1;
  const Real half = Real::from_rational(domain.half);
  const Real centre = Real::from_rational(domain.centre);
  RelationConstants result{
      simplest_near(centre + half * lambda, half * accuracy.tolerance(curvature(0, 0), constants)),
      simplest_near(centre + half * m, half * accuracy.tolerance(sigma * sigma * curvature(2, 2), constants)),
      Rational(1)};
  if constexpr (D == 4) {
    const Real weight = m * m * curvature(2, 2) + Real(2) * m * curvature(2, 3) + curvature(3, 3);
    result.sigma = simplest_near(sigma, accuracy.tolerance(weight, constants));
  }
  return result;
}

/// A row of control points as combinations of neighbours in the edge of regression:
/// point 2 i is sigma r[u_i, ..., u_{i+n-1}, M*], point 2 i + 1 is r[u_i, ..., u_{i+n-1}, L*].
struct EdgeRow {
  std::array<Rational, 2> exact;
  std::array<Real, 2> real;
};

std::vector<EdgeRow> edge_rows(const KnotList<Rational>& u, const RelationConstants& constants) {
  const std::vector<Rational> v = u.cad_list();
  std::vector<EdgeRow> rows;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(u.last()); ++i) {
    const Rational& low = v[i];
    const Rational& high = v[i + static_cast<std::size_t>(u.degree()) + 1];
    for (const bool first : {true, false}) {
      const Rational& x = first ? constants.m : constants.lambda;
      const Rational factor = first ? constants.sigma : Rational(1);
      EdgeRow row{{factor * (high - x) / (high - low), factor * (x - low) / (high - low)}, {}};
      for (std::size_t j = 0; j < 2; ++j) row.real[j] = Real::from_rational(row.exact[j]);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// The points r_0, ..., r_{L+1} whose net is nearest: tridiagonal normal equations. Nothing where they are singular.
template <int D>
std::optional<std::vector<Vec<Real, D>>> nearest_edge(const std::vector<EdgeRow>& rows, const RealNet<D>& net) {
  const std::size_t count = rows.size() / 2 + 1;
  std::vector<Real> diagonal(count);
  std::vector<std::vector<Real>> below(count, std::vector<Real>(1));
  below.front().clear();
  std::vector<Vec<Real, D>> r(count, PointTraits<Vec<Real, D>>::zero());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::size_t i = k / 2;
    const auto& [a, b] = rows[k].real;
    diagonal[i] += a * a / net.scale[k];
    diagonal[i + 1] += b * b / net.scale[k];
    below[i + 1].front() += a * b / net.scale[k];
    add_scaled(r[i], a / net.scale[k], net.points[k]);
    add_scaled(r[i + 1], b / net.scale[k], net.points[k]);
  }
  const auto factors = BandedFactors::of(std::move(below), std::move(diagonal));
  if (!factors) return std::nullopt;
  factors->forward(r);
  factors->backward(r);
  return r;
}

template <int D>
std::optional<ExactNet<D>> realise_edge(const KnotList<Rational>& u, const RealNet<D>& net,
                                        const RelationConstants& constants, const Real& squared) {
  if (constants.lambda == constants.m) return std::nullopt;  // a cylinder or a cone, without an edge
  const Accuracy accuracy(squared, net.size());
  const std::vector<EdgeRow> rows = edge_rows(u, constants);
  const auto edge = nearest_edge<D>(rows, net);
  if (!edge) return std::nullopt;
  Real most(0);  // how much a row enlarges errors, in units of its scale
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Real norm = magnitude(rows[k].real[0]) + magnitude(rows[k].real[1]);
    most = std::max(most, norm / net.scale[k].square_root());
  }
  std::vector<Vec<Rational, D>> r;
  for (const Vec<Real, D>& x : *edge) r.push_back(rounded_point<D>(x, accuracy.exponent() - exponent_of(most)));
  ExactNet<D> result;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    result.push_back(combine(rows[k].exact[0], r[k / 2], rows[k].exact[1], r[k / 2 + 1]));
  }
  return result;
}

}  // namespace

template <int D>
std::optional<Candidate<D>> constant_candidate(const KnotList<Rational>& u, const RealNet<D>& net, const Real& rival) {
  const UnitDomain domain(u);
  const auto system = constant_relation<Real>(u.degree(), domain.knots(u), D == 4);
  const auto descent = best_descent<D>(system, net, rival);
  if (!descent) return std::nullopt;
  const auto constants = simple_constants<D>(*descent, domain, net.size());
  if (!constants) return std::nullopt;
  const Real squared = descent->nearest.squared;
  return Candidate<D>{
      .squared = squared,
      .realise = [&u, &net, constants, squared] { return realise_edge<D>(u, net, *constants, squared); },
      .constants = constants,
      .converged = descent->converged};
}

template std::optional<Candidate<3>> constant_candidate<3>(const KnotList<Rational>&, const RealNet<3>&, const Real&);
template std::optional<Candidate<4>> constant_candidate<4>(const KnotList<Rational>&, const RealNet<4>&, const Real&);

}  // namespace torse::repair
