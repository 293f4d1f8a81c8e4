#include "torse/quasi/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torse::quasi {
namespace {

/// The piece on which t lies, the last one at the end of the domain.
int piece_of(const KnotList<double>& u, double t) {
  const auto& list = u.list();
  const auto begin = list.begin() + (u.degree() - 1);
  const auto end = list.begin() + u.last();
  return static_cast<int>(std::upper_bound(begin, end, t) - begin);
}

/// Parameters t in the range at which t + sigma(t) takes `count` evenly spread values, found on a grid.
std::vector<double> evenly_on_both(const Rail& c, const Mapping<double>& sigma, std::size_t count, const Range& range) {
  const Sampling grid(c, sigma.knots, midpoints(16 * count, range));
  const std::vector<double> beta = coefficients(sigma);
  const auto place = [&](std::size_t r) { return grid.parameter(r) + grid.value(beta, r); };
  const double begin = place(0);
  const double length = place(grid.size() - 1) - begin;
  const double steps = static_cast<double>(count - 1);
  std::vector<double> parameters;
  for (std::size_t r = 0; r < grid.size(); ++r) {
    const double wanted = length * static_cast<double>(parameters.size());
    if ((place(r) - begin) * steps >= wanted) parameters.push_back(grid.parameter(r));
  }
  return parameters;
}

}  // namespace

Sampling::Sampling(const Rail& c, const KnotList<double>& knots, std::vector<double> parameters)
    : degree_(knots.degree()), parameters_(std::move(parameters)) {
  const std::size_t width = static_cast<std::size_t>(degree_) + 1;
  jets_.reserve(size());
  first_.reserve(size());
  basis_.resize(size() * width);
  for (std::size_t r = 0; r < size(); ++r) {
    const int k = piece_of(knots, parameters_[r]);
    jets_.push_back(c(parameters_[r]));
    first_.push_back(static_cast<std::size_t>(k - 1));
    fill_basis<double>(knots, k, parameters_[r], std::span(basis_).subspan(r * width, width));
  }
}

std::vector<double> midpoints(std::size_t count, const Range& range) {
  std::vector<double> parameters;
  parameters.reserve(count);
  for (std::size_t r = 0; r < count; ++r) {
    const double share = (static_cast<double>(r) + 0.5) / static_cast<double>(count);
    parameters.push_back(range.from + share * (range.to - range.from));
  }
  return parameters;
}

std::vector<SampledRuling> sampled_rulings(const Rails& rails, const Mapping<double>& sigma, std::size_t count,
                                           const Range& range) {
  const std::vector<double> beta = coefficients(sigma);
  const Sampling samples(rails.c, sigma.knots, evenly_on_both(rails.c, sigma, count, range));
  std::vector<SampledRuling> rulings;
  for (std::size_t r = 0; r < samples.size(); ++r) {
    const double target = samples.value(beta, r);
    const RailJet d = rails.d(target);
    const RulingAngle ruling = ruling_angle(samples.jet(r), d, AngleKind::planes);
    rulings.push_back({samples.parameter(r), target, samples.jet(r).point, d.point,
                       std::abs(ruling.angle.value) * 180 / std::numbers::pi});
  }
  return rulings;
}

WarpStatistics warp_statistics(const Rail& d, const Sampling& samples, std::span<const double> beta) {
  WarpStatistics statistics;
  for (std::size_t r = 0; r < samples.size(); ++r) {
    const RulingAngle ruling = ruling_angle(samples.jet(r), d(samples.value(beta, r)), AngleKind::planes);
    const double degrees = std::abs(ruling.angle.value) * 180 / std::numbers::pi;
    statistics.mean += degrees;
    statistics.rms += degrees * degrees;
    statistics.max = std::max(statistics.max, degrees);
    statistics.folded += ruling.folded ? 1 : 0;
  }
  const double count = static_cast<double>(samples.size());
  statistics.mean /= count;
  statistics.rms = std::sqrt(statistics.rms / count);
  statistics.folded /= count;
  return statistics;
}

WarpStatistics warp_statistics(const Rails& rails, const Mapping<double>& sigma, std::size_t count,
                               const Range& range) {
  return warp_statistics(rails.d, Sampling(rails.c, sigma.knots, midpoints(count, range)), coefficients(sigma));
}

}  // namespace torse::quasi
