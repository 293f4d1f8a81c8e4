// Rulings at fixed parameters of the first rail: what a mapping makes of them.
//   Sampling                 parameters, jets of the first rail, basis functions of the mapping
//   Range, midpoints         as many parameters as wanted, evenly spread
//   SampledRuling, sampled_rulings    in space
//   WarpStatistics           mean, root mean square and maximum of sampled warp angles
//   warp_statistics          of a mapping, or of T = t
#pragma once

#include <span>
#include <vector>

#include "torse/quasi/mapping.hpp"
#include "torse/quasi/ruling_angle.hpp"

namespace torse::quasi {

/// Samples of a strip for mappings over one knot list. Row r of the basis holds the degree + 1 functions from
/// coefficient first(r) on that are not 0 at t_r.
class Sampling {
 public:
  /// Takes parameters within [0, 1] and the mapping's knots over [0, 1].
  Sampling(const Rail& c, const KnotList<double>& knots, std::vector<double> parameters);

  std::size_t size() const { return parameters_.size(); }
  int degree() const { return degree_; }
  double parameter(std::size_t r) const { return parameters_[r]; }
  const RailJet& jet(std::size_t r) const { return jets_[r]; }
  std::size_t first(std::size_t r) const { return first_[r]; }
  std::span<const double> basis(std::size_t r) const {
    const std::size_t width = static_cast<std::size_t>(degree_) + 1;
    return {basis_.data() + r * width, width};
  }

  /// sigma(t_r) for the coefficients beta.
  double value(std::span<const double> beta, std::size_t r) const {
    const std::span<const double> row = basis(r);
    double total = 0;
    for (std::size_t i = 0; i < row.size(); ++i) total += row[i] * beta[first_[r] + i];
    return total;
  }

 private:
  int degree_;
  std::vector<double> parameters_;
  std::vector<RailJet> jets_;
  std::vector<std::size_t> first_;
  std::vector<double> basis_;
};

/// A range of parameters of the first rail.
struct Range {
  double from = 0;
  double to = 1;
};

/// The middles of `count` equal parts of a range.
std::vector<double> midpoints(std::size_t count, const Range& range = {});

/// A ruling as it stands in space.
struct SampledRuling {
  double t;
  double target;  ///< sigma(t)
  Vector c;
  Vector d;
  double warp;  ///< degrees
};

/// About `count` rulings, evenly spread by the mean of t and sigma(t), so that they are dense on neither rail alone.
std::vector<SampledRuling> sampled_rulings(const Rails& rails, const Mapping<double>& sigma, std::size_t count,
                                           const Range& range = {});

/// Warp angles in degrees over sampled rulings; `folded` is the share of those whose normal turns by more than 90
/// degrees.
struct WarpStatistics {
  double mean = 0;
  double rms = 0;
  double max = 0;
  double folded = 0;
};

/// Of the strip's rulings at `count` midpoints.
WarpStatistics warp_statistics(const Rails& rails, const Mapping<double>& sigma, std::size_t count,
                               const Range& range = {});

/// Of samples that are at hand.
WarpStatistics warp_statistics(const Rail& d, const Sampling& samples, std::span<const double> beta);

}  // namespace torse::quasi
