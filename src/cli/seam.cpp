#include "torse/cli/seam.hpp"

#include <algorithm>
#include <utility>

#include "torse/cli/fitting.hpp"
#include "torse/spline/closed.hpp"

namespace torse::cli {
namespace {

using Row = Vec<Rational, 4>;
using Curve = Spline<Rational, Row>;

constexpr int first_places = 32;
constexpr int halvings = 5;
constexpr int trial_coefficients = 20;
constexpr double least_gain = 0.99;

Curve curve_of(const CurveFile<Rational>& rail) { return {rail.knots, homogeneous(rail.net)}; }

/// The rails with d from its parameter a + share (b - a) on, 0 <= share < 1; none where a control point of d would lie
/// at infinity, as the knot there can have it where weights have both signs.
std::optional<RailsFile<Rational>> from_share(const RailsFile<Rational>& rails, const Rational& share) {
  if (share == Rational(0)) return rails;
  const Curve d = curve_of(rails.d);
  const Rational& a = d.knots.domain_begin();
  const Curve moved = rotated(d, Rational(a + share * (d.knots.domain_end() - a)));
  if (std::ranges::any_of(moved.control, [](const Row& row) { return row[0].sign() == 0; })) return std::nullopt;
  return RailsFile<Rational>{rails.c, {moved.knots, dehomogenize<Rational, 4>(moved.control)}};
}

/// A place of the seam and the measure of its fit, in degrees.
struct Trial {
  Rational share;
  double value;
  RailsFile<Rational> rails;
};

std::optional<Trial> trial_at(const RailsFile<Rational>& rails, Rational share, const quasi::FitOptions& options) {
  if (share < Rational(0)) share += Rational(1);
  std::optional<RailsFile<Rational>> moved = from_share(rails, share);
  if (!moved) return std::nullopt;
  const double value = quasi::fit_rails(unit_rails(*moved), options).value;
  return Trial{std::move(share), value, *std::move(moved)};
}

}  // namespace

bool closed_rails(const RailsFile<Rational>& rails) { return closed(curve_of(rails.c)) && closed(curve_of(rails.d)); }

std::optional<Seam> best_seam(const RailsFile<Rational>& rails, quasi::FitOptions options) {
  options.coefficients = std::max(options.degree + 1, std::min(options.coefficients, trial_coefficients));
  options.adaptive = false;
  Trial best = trial_at(rails, Rational(0), options).value();
  const double own = best.value;
  const auto attempt = [&](const Rational& share) {
    std::optional<Trial> trial = trial_at(rails, share, options);
    if (trial && trial->value < best.value) best = *std::move(trial);
  };
  for (int i = 1; i < first_places; ++i) attempt(ratio<Rational>(i, first_places));
  Rational step = ratio<Rational>(1, first_places);
  for (int i = 0; i < halvings; ++i) {
    step = step / Rational(2);
    const Rational middle = best.share;
    attempt(middle - step);
    attempt(middle + step);
  }
  if (!(best.value < least_gain * own)) return std::nullopt;
  const KnotList<Rational>& u = rails.d.knots;
  return Seam{u.domain_begin() + best.share * (u.domain_end() - u.domain_begin()), std::move(best.rails)};
}

}  // namespace torse::cli
