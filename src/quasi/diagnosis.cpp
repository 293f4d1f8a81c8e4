#include "torse/quasi/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace torse::quasi {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A warp that counts as none, as a part of the threshold.
constexpr double small_share = 0.5;

/// The developable rulings from one point of the first rail.
struct Targets {
  std::vector<double> zeros;  ///< parameters T, also beyond the ends, in order
  double best = infinity;     ///< the least warp with T in [0, 1], degrees
};

/// The points of the second rail that rulings may lead to.
class TargetRow {
 public:
  TargetRow(const Rail& d, const DiagnosisOptions& options) {
    const double count = static_cast<double>(options.targets);
    for (std::size_t i = 0; i <= options.targets; ++i) {
      const double t = -options.reach + (1 + 2 * options.reach) * static_cast<double>(i) / count;
      parameters_.push_back(t);
      jets_.push_back(d(t));
    }
  }

  /// Zeros are changes of sign that are no jumps between +90 and -90 degrees, and samples of at most `small` degrees.
  Targets from(const RailJet& c, double small) const {
    Targets targets;
    double before = 0;
    for (std::size_t i = 0; i < jets_.size(); ++i) {
      const double t = parameters_[i];
      const double warp = ruling_angle(c, jets_[i], AngleKind::planes).angle.value * degrees;
      if (t >= 0 && t <= 1) targets.best = std::min(targets.best, std::abs(warp));
      const bool crosses = before * warp < 0 && std::abs(before - warp) < 90;
      if (crosses) {
        targets.zeros.push_back(parameters_[i - 1] + (t - parameters_[i - 1]) * before / (before - warp));
        if (targets.zeros.back() >= 0 && targets.zeros.back() <= 1) targets.best = 0;
      } else if (std::abs(warp) <= small) {
        targets.zeros.push_back(t);
      }
      before = warp;
    }
    return targets;
  }

 private:
  std::vector<double> parameters_;
  std::vector<RailJet> jets_;
};

/// One ruling of the first rail.
struct Place {
  double t;
  double value;  ///< sigma(t)
  double warp;   ///< degrees
  Targets targets;
  Obstacle obstacle = Obstacle::mapping;
  double extension = 0;
};

/// Whether a developable ruling from `place` exists on the rail itself that keeps the order with the rulings that are
/// good already: those before and behind it whose warp is small.
Obstacle obstacle_at(const Place& place, double after, double before, double& extension) {
  double beyond = infinity;
  Obstacle outside = Obstacle::tangents;
  const auto leads_out = [&](double distance, Obstacle end) {
    if (distance < beyond) {
      beyond = distance;
      outside = end;
    }
  };
  bool inside = false;
  for (const double zero : place.targets.zeros) {
    if (zero < 0) {
      leads_out(-zero, Obstacle::beyond_begin);
    } else if (zero > 1) {
      leads_out(zero - 1, Obstacle::beyond_end);
    } else if (zero >= after && zero <= before) {
      return Obstacle::mapping;
    } else {
      inside = true;
    }
  }
  if (inside) return Obstacle::order;
  if (outside != Obstacle::tangents) extension = beyond;
  return outside;
}

std::vector<Place> places_of(const Rails& rails, const Mapping<double>& sigma, const DiagnosisOptions& options) {
  const Sampling samples(rails.c, sigma.knots, midpoints(options.rulings, options.range));
  const std::vector<double> beta = coefficients(sigma);
  const TargetRow row(rails.d, options);
  std::vector<Place> places;
  for (std::size_t r = 0; r < samples.size(); ++r) {
    const double value = samples.value(beta, r);
    const double warp = std::abs(ruling_angle(samples.jet(r), rails.d(value), AngleKind::planes).angle.value) * degrees;
    places.push_back({samples.parameter(r), value, warp, {}});
    if (warp > options.threshold) places.back().targets = row.from(samples.jet(r), small_share * options.threshold);
  }
  return places;
}

/// The values of sigma at the nearest good rulings before and behind each place bound where its ruling may lead.
void find_obstacles(std::vector<Place>& places, double threshold) {
  std::vector<double> before(places.size());
  double bound = infinity;
  for (std::size_t i = places.size(); i-- > 0;) {
    before[i] = bound;
    if (places[i].warp <= small_share * threshold) bound = places[i].value;
  }
  double after = -infinity;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Place& place = places[i];
    if (place.warp > threshold) place.obstacle = obstacle_at(place, after, before[i], place.extension);
    if (place.warp <= small_share * threshold) after = place.value;
  }
}

}  // namespace

std::string_view name_of(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::tangents:
      return "tangents";
    case Obstacle::beyond_begin:
      return "beyond-begin";
    case Obstacle::beyond_end:
      return "beyond-end";
    case Obstacle::order:
      return "order";
    default:
      return "mapping";
  }
}

std::vector<Finding> diagnose(const Rails& rails, const Mapping<double>& sigma, const DiagnosisOptions& options) {
  std::vector<Place> places = places_of(rails, sigma, options);
  find_obstacles(places, options.threshold);
  const double half = 0.5 * (options.range.to - options.range.from) / static_cast<double>(options.rulings);
  std::vector<Finding> findings;
  std::optional<std::size_t> last;  // the place before belongs to the last finding
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    if (!(place.warp > options.threshold)) continue;
    const bool goes_on = last && *last + 1 == i && findings.back().obstacle == place.obstacle;
    if (!goes_on) {
      findings.push_back({place.t - half, place.t, place.obstacle, 0, place.warp, 0, place.extension});
      counts.push_back(0);
    }
    Finding& finding = findings.back();
    finding.to = place.t + half;
    finding.mean += place.warp;
    finding.max = std::max(finding.max, place.warp);
    finding.best += std::isfinite(place.targets.best) ? place.targets.best : place.warp;
    finding.extension = std::max(finding.extension, place.extension);
    ++counts.back();
    last = i;
  }
  for (std::size_t i = 0; i < findings.size(); ++i) {
    findings[i].mean /= static_cast<double>(counts[i]);
    findings[i].best /= static_cast<double>(counts[i]);
  }
  return findings;
}

}  // namespace torse::quasi
