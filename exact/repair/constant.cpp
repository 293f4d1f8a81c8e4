// The nearest nets of FJ07.13 and FJ21.7.1: constants by descent, and simple fractions near them.
#include <algorithm>
#include <utility>

#include "torse/exact/repair/constant_net.hpp"
#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// The best of the descents from all starts.
template <int D>
std::optional<Descent<D>> best_descent(const BilinearSystem<Real>& system, const RealNet<D>& net, const Real& rival) {
  const Projector<D> projector = [&](const std::vector<Real>& theta) { return project<D>(system, net, theta); };
  std::optional<Descent<D>> best;
  for (std::vector<Real>& theta : first_constants<D>(system, net)) {
    auto descent = descend<D>(projector, std::move(theta), system.constants, rival);
    if (descent && (!best || descent->nearest.squared < best->nearest.squared)) best = std::move(descent);
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

/// L*, M*, sigma of a segment as simple fractions near those of the descent, in the parameter of the file.
template <int D>
std::optional<RelationConstants> simple_constants(const Descent<D>& descent, const UnitDomain& domain,
                                                  std::size_t count, std::size_t segment) {
  const std::size_t first = D * segment;  // a group has D constants
  const auto theta = [&](std::size_t i) { return descent.theta[first + i]; };
  const Real w = theta(1);
  const Real w_other = D == 4 ? theta(3) : w;
  if (w == Real(0) || w_other == Real(0)) return std::nullopt;
  // The squared distance does not depend on a common factor of the constants: with w = 1 its curvature is w^2 that of
  // the descent.
  const auto curvature = [&](std::size_t i, std::size_t j) {
    return w * w * descent.nearest.curvature[first + i][first + j];
  };
  const Real lambda = theta(0) / w;
  const Real m = theta(2) / w_other;
  const Real sigma = w_other / w;
  const Accuracy accuracy(descent.nearest.squared, count);
  const std::size_t constants = (D - 1) * descent.fixed.size();
  const Real half = Real::from_rational(domain.half);
  const Real centre = Real::from_rational(domain.centre);
  RelationConstants result{
      {},
      {},
      simplest_near(centre + half * lambda, half * accuracy.tolerance(curvature(0, 0), constants)),
      simplest_near(centre + half * m, half * accuracy.tolerance(sigma * sigma * curvature(2, 2), constants)),
      Rational(1)};
  if constexpr (D == 4) {
    const Real weight = m * m * curvature(2, 2) + Real(2) * m * curvature(2, 3) + curvature(3, 3);
    result.sigma = simplest_near(sigma, accuracy.tolerance(weight, constants));
  }
  return result;
}

/// What the relation is asked of: the whole spline as one segment, or several.
template <int D>
struct Problem {
  const KnotList<Rational>& u;
  const RealNet<D>& net;
  std::vector<Segment> segments;
  UnitDomain domain;
  BilinearSystem<Real> system;

  Problem(const KnotList<Rational>& knots, const RealNet<D>& points, std::vector<Segment> parts)
      : u(knots), net(points), segments(std::move(parts)), domain(knots) {
    std::vector<int> joints;
    for (std::size_t s = 1; s < segments.size(); ++s) joints.push_back(segments[s].begin);
    system = constant_relation<Real>(u.degree(), domain.knots(u), D == 4, joints);
  }

  Projector<D> projector() const {
    return [this](const std::vector<Real>& theta) { return project<D>(system, net, theta); };
  }

  /// The constants of each segment by itself.
  std::optional<std::vector<Real>> start() const {
    std::vector<Real> theta;
    for (const Segment& segment : segments) {
      const RealNet<D> part = part_of(net, segment);
      const auto alone = constant_relation<Real>(u.degree(), domain.knots(segment.knots), D == 4);
      const auto descent = best_descent<D>(alone, part, Real(part.size()));
      if (!descent) return std::nullopt;
      theta.insert(theta.end(), descent->theta.begin(), descent->theta.end());
    }
    return theta;
  }

  std::optional<Candidate<D>> candidate(Descent<D> descent) const {
    std::vector<RelationConstants> constants;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      auto simple = simple_constants<D>(descent, domain, net.size(), s);
      if (!simple) return std::nullopt;
      simple->from = segments[s].knots.domain_begin();
      simple->to = segments[s].knots.domain_end();
      constants.push_back(std::move(*simple));
    }
    const Real squared = descent.nearest.squared;
    return Candidate<D>{.squared = squared,
                        .realise = [*this, constants, squared] { return realise(constants, squared); },
                        .constants = constants,
                        .converged = descent.converged};
  }

  std::optional<ExactNet<D>> realise(const std::vector<RelationConstants>& constants, const Real& squared) const {
    std::vector<Real> theta;
    for (const RelationConstants& each : constants) {
      const auto add = [&](const Rational& x) { theta.push_back(Real::from_rational(x)); };
      add((each.lambda - domain.centre) / domain.half);
      add(Rational(1));
      add(each.sigma * (each.m - domain.centre) / domain.half);
      if (D == 4) add(each.sigma);
    }
    const auto projection = project<D>(system, net, theta);
    if (!projection) return std::nullopt;
    RealNet<D> near = net;
    for (std::size_t i = 0; i < near.size(); ++i) subtract(near.points[i], projection->change[i]);
    return realise_constant_net<D>(segments, near, constants, Accuracy(squared, net.size()));
  }
};

}  // namespace

template <int D>
std::optional<Candidate<D>> constant_candidate(const KnotList<Rational>& u, const RealNet<D>& net, const Real& rival) {
  const Problem<D> problem(u, net, {{0, u.last(), u}});
  const auto descent = best_descent<D>(problem.system, net, rival);
  return descent ? problem.candidate(*descent) : std::nullopt;
}

template <int D>
std::optional<Candidate<D>> segments_candidate(const KnotList<Rational>& u, const RealNet<D>& net, const Real& rival) {
  constexpr std::size_t most_segments = 24;
  std::vector<Segment> segments = segments_of(u);
  if (segments.size() < 2 || segments.size() > most_segments) return std::nullopt;
  const Problem<D> problem(u, net, std::move(segments));
  const auto start = problem.start();
  if (!start) return std::nullopt;
  const auto descent = descend<D>(problem.projector(), *start, D, rival);
  return descent ? problem.candidate(*descent) : std::nullopt;
}

template std::optional<Candidate<3>> constant_candidate<3>(const KnotList<Rational>&, const RealNet<3>&, const Real&);
template std::optional<Candidate<4>> constant_candidate<4>(const KnotList<Rational>&, const RealNet<4>&, const Real&);
template std::optional<Candidate<3>> segments_candidate<3>(const KnotList<Rational>&, const RealNet<3>&, const Real&);
template std::optional<Candidate<4>> segments_candidate<4>(const KnotList<Rational>&, const RealNet<4>&, const Real&);

}  // namespace torse::repair
