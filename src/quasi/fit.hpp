// The most developable ruled surface between two rails: the mapping for which its warp is least.
//   FitOptions       what to minimise, over which mappings
//   Fit, fit_rails   the mapping, and how it was found
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torse/quasi/descent.hpp"

namespace torse::quasi {

/// What is minimised, and the mappings that are tried.
struct FitOptions {
  int degree = 2;         ///< of the mapping, 1 to 10
  int coefficients = 50;  ///< of the mapping, degree + 1 to 10000
  Measure measure = Measure::mean;
  AngleKind kind = AngleKind::planes;
  Ends ends = Ends::fixed;
  bool adaptive = true;       ///< move the mapping's knots to where the warp is; otherwise they are evenly spaced
  int samples_per_piece = 3;  ///< of the mapping, and at least 100 together
};

/// One descent of a fit.
struct FitStage {
  std::string start;  ///< "path", "T = t", "shifted", "moved knots"; "mean" of a maximum: then both are of the mean
  double before;      ///< the measure in degrees where it began
  double after;       ///< and where it ended
  int steps;
  int evaluations;
  bool converged;
};

/// The step of a convergence curve.
struct FitStep {
  double value;    ///< the least measure so far, degrees
  double seconds;  ///< since the start of the fit
};

/// The result of a fit. It is never worse than T = t, by the measure at four times as many rulings as the fit looks
/// at.
struct Fit {
  Mapping<double> mapping;
  double value = 0;    ///< that measure, degrees
  double initial = 0;  ///< that of T = t
  std::vector<FitStage> stages{};
  std::vector<FitStep> curve{};
  double seconds = 0;
  /// Where this strip folds over: the measure of the best one found by the angle of sides, degrees.
  std::optional<double> by_sides{};
};

/// The number of rulings at which a fit samples a mapping.
std::size_t fit_samples(const FitOptions& options);

/// Clamped knots of a mapping over [0, 1] with these ends of pieces.
KnotList<double> mapping_knots(int degree, const std::vector<double>& breaks);

/// Fits: the best path through a grid of rulings, a descent from there, shifts of its steep places, and, if wanted, a
/// descent over better knots. By the angle of planes a strip may fold over; then it is fitted by that of sides too, and
/// that is the result if it costs next to nothing. Where the measure between the samples turns out worse, the fit is
/// repeated with four times as many. Throws InvalidInput naming "degree" or "coefficients".
Fit fit_rails(const Rails& rails, const FitOptions& options = {});

}  // namespace torse::quasi
