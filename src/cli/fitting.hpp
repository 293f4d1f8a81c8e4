// What torse fit does with a pair of rails.
//   FitMethod           the paper's methods, ours, or T = t as it stands
//   FitWishes           what the command line asks for
//   UnitRails           the rails in doubles, at the origin and of size 1
//   Simplest, Within    what a simpler surface is to have few of, and how near it has to be
//   MethodResult        a mapping and how it was found
//   TrimLine            where extended rails reach their old ends
//   Simplified          what became of the exact surface
//   FittedStrip         the mapping and the exact surface, with all that is known of them
//   fit_strip           from the rails of a file
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torse/cli/warp.hpp"
#include "torse/exact/quasi/folds.hpp"
#include "torse/exact/quasi/monotony.hpp"
#include "torse/exact/quasi/self_intersection.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/quasi/diagnosis.hpp"
#include "torse/quasi/fit.hpp"
#include "torse/quasi/paper_fit.hpp"

namespace torse::cli {

/// warp: ours. paper: BZZ19's continuous mapping. discrete: its discrete one. same: T = t.
enum class FitMethod { warp, paper, discrete, same };

/// What the simpler surface has as few of as is found: knots at the degree of the exact one, degrees, or control
/// points.
enum class Simplest { knots, degree, points };

/// A surface near the exact one is enough.
struct Within {
  Rational distance;  ///< a length in the rails' own unit
  Simplest simplest = Simplest::points;
};

struct FitWishes {
  std::string file;  ///< for errors
  FitMethod method = FitMethod::warp;
  quasi::FitOptions options;
  std::optional<Angle> max_warp;
  /// Lets both rails go on beyond their ends by this share of their parameters; the ends are free then.
  std::optional<Rational> extension;
  std::optional<Within> within{};
};

/// The rails of a file, moved and scaled by one exact map into the unit cube around the origin, then rounded.
quasi::Rails unit_rails(const RailsFile<Rational>& rails);

/// A mapping over [0, 1] with the record of the method that found it.
struct MethodResult {
  Mapping<double> sigma;
  std::optional<quasi::Fit> fit{};         ///< of our method
  std::optional<quasi::PaperFit> paper{};  ///< of the paper's
  double seconds = 0;
};

/// Where the strip between extended rails reaches the old ends: the parameters of the rulings from the end of c and to
/// that of d. The straight lines between the old ends cut the strip off there.
struct TrimLine {
  Rational c;
  Rational d;
};

/// The surface that took the place of the exact one, beside what the strip says of it.
struct Simplified {
  double distance;  ///< no point is further from that of the exact surface with the same parameters: certified
  int exact_degree;
  std::size_t exact_pieces;
  std::size_t exact_points;    ///< on each rail
  quasi::WarpStatistics warp;  ///< of the simplified surface, sampled
};

/// A strip between two rails.
struct FittedStrip {
  MethodResult method;
  Mapping<Rational> sigma;  ///< from the domain of c into that of d
  Rational change;          ///< of the fitted mapping for the exact surface, relative to the domain of d
  MonotonyVerdict monotony;
  RuledFile<Rational> surface;                    ///< (1-v) c(t) + v d(sigma(t)), exactly, unless it is simplified
  std::optional<Simplified> simplified;           ///< how, if it is
  quasi::WarpStatistics before;                   ///< of T = t, sampled
  quasi::WarpStatistics after;                    ///< of the mapping, at other rulings than those of the fit
  std::optional<WarpVerdict> certified;           ///< none for a surface that is exactly developable
  std::optional<RulingPlace> fold;                ///< of the exact surface
  SelfIntersection crossings;                     ///< of its rulings
  std::vector<quasi::SampledRuling> old_rulings;  ///< of T = t, for pictures: of size 1, parameters over [0, 1]
  std::vector<quasi::SampledRuling> rulings;      ///< of the mapping
  std::vector<TrimLine> trims;                    ///< of extended rails, at the begin and at the end
  std::optional<Rational> seam;                   ///< of closed rails, where d begins if not at its own begin
  std::vector<std::string> notes;                 ///< what is unusual about the rails
  quasi::Range range;                             ///< of the surface within the first rail as the fit had it
  double threshold{};                             ///< degrees: the warp beyond which `findings` tell why
  std::vector<quasi::Finding> findings;           ///< parameters over [0, 1]
};

/// The warp, in degrees, that a diagnosis is about where no other is asked for.
inline constexpr double default_threshold = 1;

/// As many rulings as `before` and `after` are measured at.
inline constexpr std::size_t measured_rulings = 2000;

/// And as many are drawn.
inline constexpr std::size_t drawn_rulings = 240;

/// Fits, makes the exact surface, simplifies it if wanted and certifies what came out. Throws InvalidInput naming "c"
/// or "d" for rails that are points or too long for doubles, that have weights where a simpler surface is wanted, whose
/// surface would have a degree or a size beyond the limits, or whose knots no mapping can tell apart.
FittedStrip fit_strip(const RailsFile<Rational>& rails, const FitWishes& wishes);

}  // namespace torse::cli
