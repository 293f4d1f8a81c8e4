// The ruling search of developable lofts: rulings from points of one rail to points of the other, chosen for the least
// total twist.
//   least_twist      their parameters on the second rail
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "torse/quasi/search.hpp"

namespace torse::bench {

/// T_0 <= ... <= T_{rulings - 1} for rulings that leave the first rail at evenly spaced parameters, both ends among
/// them, out of candidates + 1 parameters on the second one: the sum of the angles between the tangent planes at both
/// ends of the rulings is least. The rulings in between are interpolated by whoever lofts through them.
inline std::vector<double> least_twist(const quasi::Rails& rails, int rulings, int candidates, quasi::Ends ends) {
  using quasi::RailJet;
  const std::size_t height = static_cast<std::size_t>(candidates) + 1;
  const std::size_t width = static_cast<std::size_t>(rulings);
  std::vector<RailJet> second;
  for (int j = 0; j <= candidates; ++j) second.push_back(rails.d(static_cast<double>(j) / candidates));

  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<double> least(height, ends == quasi::Ends::free ? 0 : never);  // of the paths up to here, by row
  least[0] = 0;
  std::vector<std::uint32_t> from(width * height);
  for (std::size_t i = 0; i < width; ++i) {
    const RailJet c = rails.c(static_cast<double>(i) / (rulings - 1));
    std::size_t below = 0;  // the row up to j that is cheapest to come from
    double cheapest = never;
    for (std::size_t j = 0; j < height; ++j) {
      if (i == 0 || least[j] < cheapest) {
        cheapest = least[j];
        below = j;
      }
      from[i * height + j] = static_cast<std::uint32_t>(below);
      least[j] = cheapest + std::abs(ruling_angle(c, second[j], quasi::AngleKind::planes).angle.value);
    }
  }

  std::size_t j = height - 1;
  if (ends == quasi::Ends::free) {
    for (std::size_t k = 0; k < height; ++k) {
      if (least[k] < least[j]) j = k;
    }
  }
  std::vector<double> path(width);
  for (std::size_t i = width; i-- > 0;) {
    path[i] = static_cast<double>(j) / candidates;
    j = from[i * height + j];
  }
  return path;
}

}  // namespace torse::bench
