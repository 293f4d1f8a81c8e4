// Why a strip is not developable: what its rails forbid, parameter by parameter.
//   Obstacle, name_of     what stands against a developable ruling
//   Finding               a range of parameters with one obstacle
//   diagnose              of a fitted strip
#pragma once

#include <string_view>
#include <vector>

#include "torse/quasi/mapping.hpp"
#include "torse/quasi/sampling.hpp"

namespace torse::quasi {

/// Why the warp of the rulings from a part of the first rail is not small.
enum class Obstacle {
  tangents,  ///< none of the rulings from there to any point of the second rail, nor of its extension, is developable
  beyond_begin,  ///< those that are lead before the begin of the second rail
  beyond_end,    ///< or behind its end
  order,         ///< those that are would cross rulings beside them: they run against the order of the rails
  mapping        ///< developable rulings in order exist: more coefficients, free ends or another measure may reach them
};

/// "tangents", "beyond-begin", "beyond-end", "order", "mapping".
std::string_view name_of(Obstacle obstacle);

/// A range of t in [0, 1] where the warp exceeds the threshold, all for one reason.
struct Finding {
  double from;
  double to;
  Obstacle obstacle;
  double mean;  ///< warp there, degrees
  double max;
  double best;  ///< the mean over t of the least warp of any ruling from c(t), degrees
  /// For beyond_begin and beyond_end: by how much of its parameters the second rail would have to go on, at most.
  double extension;
};

/// What a diagnosis looks at.
struct DiagnosisOptions {
  Range range{};              ///< of the first rail
  double threshold = 1;       ///< degrees
  std::size_t rulings = 400;  ///< of the first rail
  std::size_t targets = 400;  ///< on the second rail for each of them
  double reach = 0.5;         ///< of the second rail's parameters, beyond each end, by its last polynomials
};

/// The ranges where the strip's warp exceeds the threshold, in order. Sampled: ranges are as sharp as the samples are
/// dense, and a developable ruling between two targets is found by the change of sign of the warp between them.
std::vector<Finding> diagnose(const Rails& rails, const Mapping<double>& sigma, const DiagnosisOptions& options = {});

}  // namespace torse::quasi
