// The nearest exactly developable net, after docs/decisions/0007-nearest-developable.md.
//   NetFamily, name_of        the families that are compared
//   NearestNet                the net, its constants, its distance, the distances of all families
//   nearest_developable       least squares over the free parameters of each family
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "torse/exact/repair/candidate.hpp"
#include "torse/exact/repair/distance.hpp"

namespace torse {

/// Families of developable nets, simple ones first.
enum class NetFamily { unchanged, plane, cylinder, cone, constant, edge, segments };

/// The word for a family in reports; `constant` is FJ07.13 and FJ21.7.1, `segments` the same between knots of
/// multiplicity n, `edge` a surface by its edge of regression.
constexpr std::string_view name_of(NetFamily f) {
  constexpr std::array<std::string_view, 7> names{"unchanged", "plane", "cylinder", "cone",
                                                  "constant",  "edge",  "segments"};
  return names[static_cast<std::size_t>(f)];
}

/// The nearest net of one family, before its numbers are made exact.
struct FamilyDistance {
  NetFamily family;
  int degree = 0;               ///< of the edge of regression, for NetFamily::edge
  double root_mean_square = 0;  ///< about; between homogeneous rows for rational surfaces
  bool converged = true;        ///< false where the search ran out of steps, or another family is 1000 times nearer
};

/// An exactly developable net near a given one.
struct NearestNet {
  NetFamily family = NetFamily::unchanged;
  int degree = 0;                                      ///< of the edge of regression, for NetFamily::edge
  std::vector<repair::RelationConstants> constants{};  ///< for NetFamily::constant (one) and segments
  repair::RuledRows rows;
  NetDistance distance{};
  std::vector<FamilyDistance> families{};  ///< all that were found, the chosen one among them
};

/// The nearest net of the families, with rational numbers, decided to be developable by find_witness_over_q; the rows
/// themselves if they are. Where it is nearer than a thousandth of the surface's size, the simplest family within twice
/// its distance is taken instead: a noisy cone is a cone, not a surface with an edge of regression far away. Rows whose
/// weights are all 1 stay so. Nothing where no family gives a net with finite points. Throws InvalidInput naming
/// "points" for rows that do not fit the knots.
std::optional<NearestNet> nearest_developable(const KnotList<Rational>& u, const repair::RuledRows& rows);

}  // namespace torse
