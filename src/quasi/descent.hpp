// The descent: Newton's method on the sampled warp over ordered coefficients.
//   DescentStep          one step, for the convergence curve
//   Descent, descend     down to a local minimum
#pragma once

#include <limits>
#include <vector>

#include "torse/quasi/loss.hpp"
#include "torse/quasi/monotone_step.hpp"
#include "torse/quasi/sampling.hpp"

namespace torse::quasi {

/// The value of the measure, in radians, after a step.
struct DescentStep {
  double value;
  double seconds;  ///< since the start of the descent
};

/// Where a descent ended.
struct Descent {
  std::vector<double> beta;
  double value = 0;  ///< of the measure, in radians
  std::vector<DescentStep> steps;
  int evaluations = 0;
  /// The last stage changed the value by no more than a part in 10^4, or it is 0 but for rounding errors; false where
  /// the steps ran out.
  bool converged = false;
};

/// How far to go.
struct DescentOptions {
  Measure measure = Measure::mean;
  AngleKind kind = AngleKind::planes;
  Ends ends = Ends::fixed;
  int stages = 24;           ///< rounds with a sharper loss each
  int steps_per_stage = 12;  ///< of Newton's method
  /// For the mean: no sample's angle may exceed this, in radians, as none does at the start.
  double cap = std::numeric_limits<double>::infinity();
};

/// Descends from beta, whose order and ends are those of the options.
///
/// The measure is not smooth (mean) or not separable (max), so a sequence of smooth sums over the samples is minimised:
/// sqrt(a^2 + delta^2) with delta -> 0 for the mean, a^2 for the mean square, (a / largest)^p with p = 2, 4, ... for
/// the maximum. A cap adds cap (a / cap)^64 to each sample. Each step minimises a quadratic model with the exact
/// gradient, the exact second derivative of each sample where it is positive and a part of the Gauss-Newton term where
/// it is not, damped after Levenberg and Marquardt. A step that does not lower the sum is not taken, so the result is
/// never worse than beta.
Descent descend(const Rail& d, const Sampling& samples, std::vector<double> beta, const DescentOptions& options);

/// The measure at beta, in radians.
double measured(const Rail& d, const Sampling& samples, std::span<const double> beta, const DescentOptions& options);

}  // namespace torse::quasi
