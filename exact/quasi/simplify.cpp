#include "torse/exact/quasi/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/exact/quasi/least_squares.hpp"
#include "torse/exact/repair/real.hpp"
#include "torse/quasi/deviation.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

namespace {

using Q = Rational;
using P = Vec<Q, 3>;
using quasi::Breakpoint;
using quasi::DoublePoint;
using quasi::DoubleSurface;

DoublePoint rounded(const P& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }

/// A parameter as a share of the domain, however far from 0 that is.
double share_of(const KnotList<Q>& u, const Q& t) {
  return Q((t - u.domain_begin()) / (u.domain_end() - u.domain_begin())).to_double();
}

/// The Bezier pieces over [0, 1], without those that are empty there.
DoubleSurface rounded(const ExactSurface& surface) {
  const KnotList<Q>& u = surface.knots;
  const auto polygon = [&](std::span<const P> row, int k) {
    std::vector<DoublePoint> points;
    for (const P& x : bezier_points(u, row, k)) points.push_back(rounded(x));
    return points;
  };
  std::vector<double> list{0};
  std::vector<SurfacePiece<DoublePoint>> pieces;
  for (const int k : u.proper_pieces()) {
    const double end = share_of(u, u.piece_end(k));
    if (!(end > list.back())) continue;
    list.push_back(end);
    pieces.push_back({polygon(surface.c_row(), k), polygon(surface.d_row(), k)});
  }
  return join_pieces(list, pieces, u.degree());
}

/// The search in doubles for knots of one degree.
class KnotSearch {
 public:
  KnotSearch(const DoubleSurface& surface, int degree, double tolerance)
      : surface_(surface),
        degree_(degree),
        square_(tolerance * tolerance),
        samples_(quasi::sampled(surface, surface.knots.degree() + 2)) {}

  /// The breakpoints that are left and the fit over them.
  struct State {
    std::vector<Breakpoint> inside;
    DoubleSurface fit;
  };

  /// All breakpoints with the least number of knots each that is enough, then without those that can go.
  std::optional<State> run() const {
    std::optional<State> state;
    for (int multiplicity = 1; multiplicity <= degree_ && !state; ++multiplicity) state = with_all(multiplicity);
    if (!state) return std::nullopt;
    std::size_t batch = state->inside.size();
    while (batch > 0 && !state->inside.empty()) {
      if (std::optional<State> less = without(*state, cheapest(*state), batch)) {
        state = std::move(less);
      } else {
        batch /= 2;
      }
    }
    const std::vector<std::size_t> order = cheapest(*state);
    std::vector<double> parameters;
    for (const std::size_t i : order) parameters.push_back(state->inside[i].t);
    for (const double t : parameters) {
      const auto found = std::ranges::find(state->inside, t, &Breakpoint::t);
      if (found == state->inside.end()) continue;
      const std::size_t index = static_cast<std::size_t>(found - state->inside.begin());
      if (std::optional<State> less = without(*state, {index}, 1)) state = std::move(less);
    }
    return state;
  }

 private:
  std::optional<State> fitted(std::vector<Breakpoint> inside) const {
    const KnotList<double>& u = surface_.knots;
    std::optional<DoubleSurface> fit =
        quasi::fitted_surface(quasi::knots_with(degree_, u.domain_begin(), u.domain_end(), inside), samples_, surface_);
    if (!fit || !(largest_deviation(*fit, surface_) <= square_)) return std::nullopt;
    return State{std::move(inside), *std::move(fit)};
  }

  std::optional<State> with_all(int multiplicity) const {
    std::vector<Breakpoint> inside;
    for (const double t : breakpoints(surface_.knots, surface_.knots)) inside.push_back({t, multiplicity});
    return fitted({inside.begin() + 1, inside.end() - 1});
  }

  /// The breakpoints, those whose knots cost least first.
  std::vector<std::size_t> cheapest(const State& state) const {
    const std::vector<double> costs = quasi::removal_costs(state.fit, state.inside);
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return costs[i]; });
    return order;
  }

  /// With one knot less at the first `count` of these breakpoints.
  std::optional<State> without(const State& state, const std::vector<std::size_t>& order, std::size_t count) const {
    std::vector<Breakpoint> inside = state.inside;
    for (std::size_t i = 0; i < std::min(count, order.size()); ++i) --inside[order[i]].multiplicity;
    std::erase_if(inside, [](const Breakpoint& x) { return x.multiplicity == 0; });
    return fitted(std::move(inside));
  }

  const DoubleSurface& surface_;
  int degree_;
  double square_;
  std::vector<quasi::SurfaceSample> samples_;
};

P exact_point(const DoublePoint& x) { return {Q::from_double(x[0]), Q::from_double(x[1]), Q::from_double(x[2])}; }

/// The fit with the breakpoints and corners of the given surface themselves in the place of their rounded values.
ExactSurface exact_surface(const KnotSearch::State& state, int degree, const ExactSurface& like) {
  std::vector<Breakpoint> left = state.inside;
  std::vector<Q> list(static_cast<std::size_t>(degree), like.knots.domain_begin());
  for (const Q& t : breakpoints(like.knots, like.knots)) {
    const auto found = std::ranges::find(left, share_of(like.knots, t), &Breakpoint::t);
    if (found == left.end()) continue;
    list.insert(list.end(), static_cast<std::size_t>(found->multiplicity), t);
    left.erase(found);
  }
  list.insert(list.end(), static_cast<std::size_t>(degree), like.knots.domain_end());
  const auto row = [](const std::vector<DoublePoint>& points, const P& first, const P& last) {
    std::vector<P> exact;
    for (const DoublePoint& x : points) exact.push_back(exact_point(x));
    exact.front() = first;
    exact.back() = last;
    return exact;
  };
  return ExactSurface(KnotList<Q>(degree, std::move(list)), row(state.fit.c, like.c.front(), like.c.back()),
                      row(state.fit.d, like.d.front(), like.d.back()));
}

/// An upper bound of the root of x >= 0, the root itself where that is a double; infinite beyond the doubles.
double root_above(const Q& x) {
  const int half = (static_cast<int>(x.numerator_bits()) - static_cast<int>(x.denominator_bits())) / 2;
  const double near_one = (x / repair::power_of_two(2 * half)).to_double();
  double root = std::ldexp(std::sqrt(near_one), half);
  const auto is_below = [&] { return Q::from_double(root) * Q::from_double(root) < x; };
  while (std::isfinite(root) && is_below()) root = std::nextafter(root, detail::infinity);
  return root;
}

void check(const ExactSurface& surface, int degree, const Q& tolerance) {
  if (tolerance.sign() <= 0) throw InvalidInput("tolerance", "expected a positive length, found " + as_text(tolerance));
  if (degree < 1 || degree > surface.knots.degree()) {
    throw InvalidInput("degree",
                       "expected 1 to " + std::to_string(surface.knots.degree()) + ", found " + std::to_string(degree));
  }
  if (!definitely(surface.knots.clamped())) throw InvalidInput("knots", "expected a clamped surface");
}

}  // namespace

std::optional<SimplifiedSurface> with_fewest_knots(const ExactSurface& surface, int degree, const Rational& tolerance) {
  check(surface, degree, tolerance);
  const DoubleSurface start = rounded(surface);
  // The search rounds; where it takes a surface that is just too far, one that is nearer is looked for.
  constexpr int trials = 4;
  double near = tolerance.to_double();
  for (int trial = 0; trial < trials; ++trial, near /= 2) {
    const std::optional<KnotSearch::State> state = KnotSearch(start, degree, near).run();
    if (!state) return std::nullopt;
    ExactSurface exact = exact_surface(*state, degree, surface);
    const Q square = largest_deviation(exact, surface);
    const double distance = root_above(square);
    if (std::isfinite(distance) && Q::from_double(distance) <= tolerance)
      return SimplifiedSurface{std::move(exact), distance};
  }
  return std::nullopt;
}

SimplifiedSurface with_lowest_degree(const ExactSurface& surface, const Rational& tolerance) {
  for (int degree = 1; degree <= surface.knots.degree(); ++degree) {
    if (std::optional<SimplifiedSurface> found = with_fewest_knots(surface, degree, tolerance))
      return *std::move(found);
  }
  return {surface, 0};
}

SimplifiedSurface with_fewest_points(const ExactSurface& surface, const Rational& tolerance) {
  SimplifiedSurface best{surface, 0};
  for (int degree = 1; degree <= surface.knots.degree(); ++degree) {
    std::optional<SimplifiedSurface> found = with_fewest_knots(surface, degree, tolerance);
    if (found && found->surface.c.size() < best.surface.c.size()) best = *std::move(found);
  }
  return best;
}

}  // namespace torse
