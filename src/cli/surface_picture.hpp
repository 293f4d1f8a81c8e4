// What a page draws of a ruled surface: its control net and sampled rulings, in doubles, moved and scaled to size 1.
//   UnitFrame, unit_frame     the map into the unit cube
//   Known                     what was decided of the surface
//   net_json                  the control net          state_json      sampled rulings with their warp and edge
//   surface_picture           both, and where the patch is singular
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/developable/classify.hpp"
#include "torse/exact/decide/singularities.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/quasi/sampling.hpp"

namespace torse::cli {

/// x -> (x - middle) / size, which takes points into [-1/2, 1/2]^3. The size is not 0.
struct UnitFrame {
  Vec<Rational, 3> middle;
  Rational size;
};

/// The frame of two rows of points; none where all of them are one point.
std::optional<UnitFrame> unit_frame(const WeightedPoints<Rational, 3>& c, const WeightedPoints<Rational, 3>& d);

/// {"degree", "knots", "c": {"points", "weights"}, "d"}: points in the frame, weights and knots as doubles; null for
/// more than 1000 points in a row.
nlohmann::ordered_json net_json(const RuledFile<Rational>& surface, const UnitFrame& frame);

/// {"label", "t", "targets"?, "rulings", "warp", "edge"?}: for each ruling its parameters on both rails over [0, 1],
/// six coordinates (null for a ruling that is not finite or too far away) and the warp angle in degrees. `edge` has the
/// v of the point (1-v) c + v d of the edge of regression, given or null.
nlohmann::ordered_json state_json(const std::string& label, const std::vector<quasi::SampledRuling>& rulings,
                                  const std::vector<std::optional<double>>& edge = {});

/// v of the point where neighbouring rulings of a developable surface meet: with W = d - c the point (1-v) c + v d has
/// a derivative along W iff v = -(c' x W).(W' x W) / |W' x W|^2. None where W' x W vanishes, as on all of a cylinder.
std::optional<double> edge_position(const quasi::RailJet& c, const quasi::RailJet& d);

/// What was decided of a surface exactly. A developable one is drawn without warp, which doubles would find where a
/// normal nearly vanishes.
struct Known {
  bool developable = false;
  bool edge = false;  ///< whether it has an edge of regression or a vertex
  std::optional<std::vector<SingularSet>> singular{};
};

/// Of a surface of this class, its singular places found if that is quick.
Known known_of(const RuledFile<Rational>& surface, SurfaceClass kind);

/// {"name", "size", "net", "states": [one], "singular"}, or null for a surface that doubles cannot draw or that is too
/// large to sample.
nlohmann::ordered_json surface_picture(const std::string& name, const RuledFile<Rational>& surface, const Known& known,
                                       std::size_t rulings);

}  // namespace torse::cli
