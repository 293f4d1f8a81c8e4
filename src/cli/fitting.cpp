#include "torse/cli/fitting.hpp"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <string>
#include <utility>

#include "torse/cli/effort.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/rails.hpp"
#include "torse/cli/seam.hpp"
#include "torse/exact/quasi/simplify.hpp"
#include "torse/exact/quasi/snap.hpp"
#include "torse/io/limits.hpp"
#include "torse/quasi/extension.hpp"
#include "torse/quasi/surface.hpp"

namespace torse::cli {
namespace {

/// The degree of a surface: the numbers of an exact one grow with it, and with them the time of every exact decision.
constexpr int most_degree = 40;

using Row = Vec<Rational, 4>;
using Curve = Spline<Rational, Row>;

Curve curve_of(const CurveFile<Rational>& file) { return {file.knots, homogeneous(file.net)}; }

/// x -> factor (x - middle), which takes all control points into [-1/2, 1/2]^3.
struct UnitFrame {
  Vec<Rational, 3> middle;
  Rational factor;
};

UnitFrame unit_frame(const RailsFile<Rational>& rails) {
  Vec<Rational, 3> low = rails.c.net.points.front();
  Vec<Rational, 3> high = low;
  for (const auto* net : {&rails.c.net, &rails.d.net}) {
    for (const auto& point : net->points) {
      for (int j = 0; j < 3; ++j) {
        low[j] = std::min(low[j], point[j]);
        high[j] = std::max(high[j], point[j]);
      }
    }
  }
  UnitFrame frame;
  Rational size(0);
  for (int j = 0; j < 3; ++j) {
    frame.middle[j] = (low[j] + high[j]) / Rational(2);
    size = std::max(size, Rational(high[j] - low[j]));
  }
  if (size.sign() == 0) throw InvalidInput("c", "expected rails, found one point");
  frame.factor = Rational(1) / size;
  return frame;
}

/// The Bezier pieces of a curve in the frame, divided by the largest weight, over [0, 1].
quasi::Rail unit_rail(const CurveFile<Rational>& file, const UnitFrame& frame) {
  Rational largest(0);
  for (const Rational& w : file.net.weights) largest = std::max(largest, w.sign() < 0 ? Rational(-w) : w);
  Curve curve = curve_of(file);
  for (Row& row : curve.control) {
    for (int j = 0; j < 3; ++j) row[j + 1] = frame.factor * (row[j + 1] - row[0] * frame.middle[j]) / largest;
    row[0] /= largest;
  }
  const KnotList<Rational>& u = curve.knots;
  const Rational length = u.domain_end() - u.domain_begin();
  std::vector<double> breaks{0};
  std::vector<Vec<double, 4>> control;
  for (const int k : u.proper_pieces()) {
    const double end =
        k == u.proper_pieces().back() ? 1 : Rational((u.piece_end(k) - u.domain_begin()) / length).to_double();
    if (!(end > breaks.back())) continue;
    breaks.push_back(end);
    for (const Row& row : bezier_points(u, curve.points(), k)) {
      control.push_back(Vec<double, 4>(row[0].to_double(), row[1].to_double(), row[2].to_double(), row[3].to_double()));
    }
  }
  return {u.degree(), std::move(breaks), std::move(control)};
}

/// The fitted mapping between the domains of the rails, as the exact numbers that its doubles are.
Mapping<Rational> between_domains(const Mapping<double>& sigma, const KnotList<Rational>& c,
                                  const KnotList<Rational>& d) {
  const Rational c_length = c.domain_end() - c.domain_begin();
  const Rational d_length = d.domain_end() - d.domain_begin();
  std::vector<Rational> knots;
  for (const double t : sigma.knots.list()) knots.push_back(c.domain_begin() + c_length * Rational::from_double(t));
  std::vector<Rational> beta;
  for (const double b : coefficients(sigma)) beta.push_back(d.domain_begin() + d_length * Rational::from_double(b));
  return mapping_of(KnotList<Rational>(sigma.knots.degree(), std::move(knots)), beta);
}

/// The literal method may leave the rail: there it is held at the rail's end.
std::vector<double> on_the_rail(std::vector<double> beta, quasi::Ends ends) {
  for (double& b : beta) b = std::clamp(b, 0.0, 1.0);
  if (ends == quasi::Ends::fixed) {
    beta.front() = 0;
    beta.back() = 1;
  }
  return beta;
}

/// T = t over [0, 1].
Mapping<double> same_parameter() { return identity_mapping(bezier_knots<double>(1)); }

KnotList<double> even_knots(const quasi::FitOptions& options) {
  const int pieces = options.coefficients - options.degree;
  std::vector<double> breaks;
  for (int i = 0; i <= pieces; ++i) breaks.push_back(static_cast<double>(i) / pieces);
  return quasi::mapping_knots(options.degree, breaks);
}

MethodResult run_paper(const quasi::Rails& rails, const quasi::FitOptions& options) {
  const KnotList<double> knots = even_knots(options);
  quasi::PaperFit fit = quasi::paper_fit(rails, knots, {.ends = options.ends, .check_gradient = true});
  MethodResult result{.sigma = mapping_of(knots, on_the_rail(fit.beta, options.ends))};
  result.paper = std::move(fit);
  return result;
}

MethodResult run_discrete(const quasi::Rails& rails, quasi::FitOptions options) {
  options.degree = 1;
  const std::size_t samples = static_cast<std::size_t>(options.coefficients);
  quasi::PaperFit fit = quasi::discrete_fit(rails, {.samples = samples, .ends = options.ends, .check_gradient = true});
  MethodResult result{.sigma = mapping_of(even_knots(options), on_the_rail(fit.beta, options.ends))};
  result.paper = std::move(fit);
  return result;
}

MethodResult run_warp(const quasi::Rails& rails, const quasi::FitOptions& options) {
  quasi::Fit fit = quasi::fit_rails(rails, options);
  MethodResult result{.sigma = fit.mapping};
  result.fit = std::move(fit);
  return result;
}

MethodResult run_method(const quasi::Rails& rails, const quasi::FitOptions& options, FitMethod method) {
  const auto start = std::chrono::steady_clock::now();
  MethodResult result = method == FitMethod::warp       ? run_warp(rails, options)
                        : method == FitMethod::paper    ? run_paper(rails, options)
                        : method == FitMethod::discrete ? run_discrete(rails, options)
                                                        : MethodResult{same_parameter()};
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

/// Throws InvalidInput naming "d.knots" where no mapping near the fitted one passes them.
SnappedMapping exact_mapping(const MethodResult& method, const RailsFile<Rational>& rails) {
  try {
    return snapped(between_domains(method.sigma, rails.c.knots, rails.d.knots), rails.c.knots, rails.d.knots);
  } catch (const Undecided&) {
    throw InvalidInput("d.knots",
                       "expected knots further from each other and from the ends: no mapping that increases "
                       "within the tolerance of the fitted one passes them all");
  }
}

CurveFile<Rational> extended_rail(const CurveFile<Rational>& rail, const Rational& share) {
  const Curve longer = extended(curve_of(rail), share);
  return {longer.knots, dehomogenize<Rational, 4>(longer.control)};
}

/// Throws InvalidInput naming "weights[i]" where a weight would vanish.
RailsFile<Rational> extended_rails(const RailsFile<Rational>& rails, const Rational& share) {
  return {extended_rail(rails.c, share), extended_rail(rails.d, share)};
}

/// Whether the mapping covers the old domain of d.
bool reaches_ends(const Mapping<Rational>& sigma, const KnotList<Rational>& d) {
  return mapping_value(sigma, sigma.knots.domain_begin()) <= d.domain_begin() &&
         d.domain_end() <= mapping_value(sigma, sigma.knots.domain_end());
}

/// Where sigma, which passes the knots of the longer d at knots of its own, has the value of an old end of d.
Rational parameter_of(const SnappedMapping& exact, const Rational& value) {
  const KnotList<Rational>& u = exact.sigma.knots;
  std::vector<Rational> candidates = exact.parameters;
  candidates.insert(candidates.end(), {u.domain_begin(), u.domain_end()});
  for (const Rational& t : candidates) {
    if (mapping_value(exact.sigma, t) == value) return t;
  }
  throw Undecided("the mapping does not pass the end of the second rail");
}

std::vector<TrimLine> trim_lines(const SnappedMapping& exact, const RailsFile<Rational>& rails) {
  return {{rails.c.knots.domain_begin(), parameter_of(exact, rails.d.knots.domain_begin())},
          {rails.c.knots.domain_end(), parameter_of(exact, rails.d.knots.domain_end())}};
}

/// The first row of weight 0 that is not an end of a Bezier piece; 0 for none.
std::size_t row_at_infinity(const RuledSpline<Rational, Row>& surface) {
  const std::size_t degree = static_cast<std::size_t>(surface.knots.degree());
  for (std::size_t i = 0; i < surface.c.size(); ++i) {
    if (i % degree != 0 && (surface.c[i][0].sign() == 0 || surface.d[i][0].sign() == 0)) return i;
  }
  return 0;
}

/// The surface of a mapping. A finite piece of a rail whose weights have both signs may have a control point at
/// infinity: the mapping gets a knot in its middle. Throws InvalidInput naming "weights[i]" where that does not help,
/// since a rail is infinite at a knot.
RuledFile<Rational> surface_of(const RailsFile<Rational>& rails, Mapping<Rational>& sigma) {
  for (int left = 100;; --left) {
    const RuledSpline<Rational, Row> surface = quasi_surface(curve_of(rails.c), curve_of(rails.d), sigma);
    const KnotList<Rational>& u = surface.knots;
    const int row = static_cast<int>(row_at_infinity(surface));
    if (row == 0 || left == 0) {
      return {u, dehomogenize<Rational, 4>(surface.c), dehomogenize<Rational, 4>(surface.d)};
    }
    const int begin = row - row % u.degree();
    sigma = insert_knot(sigma, Rational((u[begin] + u[begin + u.degree()]) / Rational(2)));
  }
}

void require_size(const RailsFile<Rational>& rails, const FitWishes& wishes) {
  const bool linear = wishes.method == FitMethod::discrete || wishes.method == FitMethod::same;
  const int mapping = linear ? 1 : wishes.options.degree;
  const int degree = std::max(rails.c.knots.degree(), rails.d.knots.degree() * mapping);
  if (degree > most_degree) {
    throw InvalidInput("d.degree", "a mapping of degree " + std::to_string(mapping) + " gives a surface of degree " +
                                       std::to_string(degree) + ", expected at most " + std::to_string(most_degree));
  }
  const std::size_t pieces = rails.c.knots.proper_pieces().size() + rails.d.knots.proper_pieces().size() +
                             static_cast<std::size_t>(wishes.options.coefficients);
  if (pieces * static_cast<std::size_t>(degree) > static_cast<std::size_t>(limits::points)) {
    throw InvalidInput("c.knots", "the surface would have " + std::to_string(pieces) + " pieces of degree " +
                                      std::to_string(degree) + ", expected at most " + std::to_string(limits::points) +
                                      " control points");
  }
}

/// The warp of a surface's own rulings.
quasi::WarpStatistics own_warp(const RuledFile<Rational>& surface) {
  const quasi::Rails rails = unit_rails({{surface.knots, surface.c}, {surface.knots, surface.d}});
  return quasi::warp_statistics(rails, same_parameter(), measured_rulings);
}

SimplifiedSurface simpler(const ExactSurface& surface, const Within& within) {
  if (within.simplest == Simplest::points) return with_fewest_points(surface, within.distance);
  if (within.simplest == Simplest::degree) return with_lowest_degree(surface, within.distance);
  std::optional<SimplifiedSurface> found = with_fewest_knots(surface, surface.knots.degree(), within.distance);
  return found ? *std::move(found) : SimplifiedSurface{surface, 0};
}

/// Puts the simpler surface into the place of the exact one.
void simplify(FittedStrip& strip, const Within& within) {
  RuledFile<Rational>& file = strip.surface;
  for (const auto& [net, place] : {std::pair{&file.c, "c"}, std::pair{&file.d, "d"}}) {
    if (!unit_weights(*net)) {
      throw InvalidInput(std::string(place) + ".weights", "expected a rail without weights for a simpler surface");
    }
  }
  const ExactSurface exact(file.knots, file.c.points, file.d.points);
  SimplifiedSurface found = simpler(exact, within);
  const std::vector<Rational> ones(found.surface.c.size(), Rational(1));
  file = {found.surface.knots, {found.surface.c, ones}, {found.surface.d, ones}};
  strip.simplified = {found.distance, exact.knots.degree(), exact.knots.proper_pieces().size(), exact.c.size(),
                      own_warp(file)};
}

/// Folds and crossings of the surface.
void certify_order(FittedStrip& strip) {
  const KnotList<Rational>& u = strip.surface.knots;
  const auto certify = [&]<int D>(const std::vector<Vec<Rational, D>>& c, const std::vector<Vec<Rational, D>>& d) {
    strip.fold = find_fold<D>(u, c, d);
    strip.crossings = find_self_intersection<D>(u, c, d);
  };
  if (unit_weights(strip.surface.c) && unit_weights(strip.surface.d)) {
    certify.operator()<3>(strip.surface.c.points, strip.surface.d.points);
  } else {
    certify.operator()<4>(homogeneous(strip.surface.c), homogeneous(strip.surface.d));
  }
}

/// A mapping between rails, before it is certified.
struct Found {
  RailsFile<Rational> rails;
  quasi::Rails unit;
  MethodResult method;
  SnappedMapping exact;
  std::vector<TrimLine> trims{};
  quasi::Range range{};
  quasi::WarpStatistics after{};  ///< within the range
};

Found find_mapping(const RailsFile<Rational>& rails, const FitWishes& wishes) {
  quasi::Rails unit = unit_rails(rails);
  MethodResult method = run_method(unit, wishes.options, wishes.method);
  SnappedMapping exact = exact_mapping(method, rails);
  Found found{rails, std::move(unit), std::move(method), std::move(exact)};
  found.after = quasi::warp_statistics(found.unit, found.method.sigma, measured_rulings);
  return found;
}

FitWishes with_fixed_ends(FitWishes wishes) {
  wishes.options.ends = quasi::Ends::fixed;
  return wishes;
}

/// Cuts the mapping between longer rails off at the outer ones of the rulings through the old ends.
void trim(Found& found, const RailsFile<Rational>& rails) {
  found.trims = trim_lines(found.exact, rails);
  const std::vector<TrimLine>& trims = found.trims;
  found.exact.sigma =
      restrict_spline(found.exact.sigma, std::min(trims[0].c, trims[0].d), std::max(trims[1].c, trims[1].d));
  const KnotList<Rational>& u = found.exact.sigma.knots;
  const KnotList<Rational>& c = found.rails.c.knots;
  const Rational length = c.domain_end() - c.domain_begin();
  found.range = {Rational((u.domain_begin() - c.domain_begin()) / length).to_double(),
                 Rational((u.domain_end() - c.domain_begin()) / length).to_double()};
  found.after = quasi::warp_statistics(found.unit, found.method.sigma, measured_rulings, found.range);
}

double measure_of(const quasi::WarpStatistics& warp, quasi::Measure measure) {
  return measure == quasi::Measure::mean ? warp.mean : measure == quasi::Measure::rms ? warp.rms : warp.max;
}

/// Of the mapping between the extended rails and that between the old ones with fixed ends, which is a strip between
/// the old ends too, the better one.
Found best_extended(const RailsFile<Rational>& rails, const FitWishes& wishes) {
  const RailsFile<Rational> longer = extended_rails(rails, *wishes.extension);
  Found found = find_mapping(longer, wishes);
  if (!reaches_ends(found.exact.sigma, rails.d.knots)) found = find_mapping(longer, with_fixed_ends(wishes));
  trim(found, rails);
  Found fixed = find_mapping(rails, with_fixed_ends(wishes));
  const quasi::Measure measure = wishes.options.measure;
  const double seconds = found.method.seconds + fixed.method.seconds;
  if (measure_of(fixed.after, measure) <= measure_of(found.after, measure)) {
    found = std::move(fixed);
    trim(found, rails);
  }
  found.method.seconds = seconds;
  return found;
}

/// Closed rails with fixed ends may be joined anywhere.
std::optional<Seam> wanted_seam(const RailsFile<Rational>& rails, const FitWishes& wishes) {
  const bool free = wishes.method == FitMethod::warp && wishes.options.ends == quasi::Ends::fixed && !wishes.extension;
  return free && closed_rails(rails) ? best_seam(rails, wishes.options) : std::nullopt;
}

double degrees_of(const Angle& angle) { return angle.value.to_double() * (angle.radians ? 180 / std::numbers::pi : 1); }

}  // namespace

quasi::Rails unit_rails(const RailsFile<Rational>& rails) {
  const UnitFrame frame = unit_frame(rails);
  return {unit_rail(rails.c, frame), unit_rail(rails.d, frame)};
}

FittedStrip fit_strip(const RailsFile<Rational>& rails, const FitWishes& wishes) {
  require_size(rails, wishes);
  const auto start = std::chrono::steady_clock::now();
  const std::optional<Seam> seam = wanted_seam(rails, wishes);
  const double seam_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Found found = wishes.extension ? best_extended(rails, wishes) : find_mapping(seam ? seam->rails : rails, wishes);
  found.method.seconds += seam_seconds;
  const double threshold = wishes.max_warp ? degrees_of(*wishes.max_warp) : default_threshold;
  const quasi::Rails old = unit_rails(rails);
  const RailsFile<Rational>& used = found.rails;
  const Mapping<double> sigma = found.method.sigma;
  RuledFile<Rational> surface = surface_of(used, found.exact.sigma);
  FittedStrip strip{
      .method = std::move(found.method),
      .sigma = found.exact.sigma,
      .change = found.exact.change / (used.d.knots.domain_end() - used.d.knots.domain_begin()),
      .monotony = decide_monotony(found.exact.sigma),
      .surface = std::move(surface),
      .simplified = {},
      .before = quasi::warp_statistics(old, same_parameter(), measured_rulings),
      .after = found.after,
      .certified = {},
      .fold = {},
      .crossings = {},
      .old_rulings = quasi::sampled_rulings(old, same_parameter(), drawn_rulings),
      .rulings = quasi::sampled_rulings(found.unit, sigma, drawn_rulings, found.range),
      .trims = std::move(found.trims),
      .seam = seam ? std::optional(seam->parameter) : std::nullopt,
      .notes = notes_on(rails),
      .range = found.range,
      .threshold = threshold,
      .findings = quasi::diagnose(found.unit, sigma, {.range = found.range, .threshold = threshold}),
  };
  if (wishes.within) simplify(strip, *wishes.within);
  require_effort(wishes.file, strip.surface, "a fitted surface", most_fit_effort);
  certify_order(strip);
  // Where all rulings meet in one point of a rail the question is not whether two of them do.
  if (one_point(rails.c) || one_point(rails.d)) strip.crossings = {};
  if (!judge(strip.surface).developable()) strip.certified = judge_warp(strip.surface, wishes.max_warp);
  return strip;
}

}  // namespace torse::cli
