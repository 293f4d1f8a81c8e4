// What the figures have in common.
//   c_colour, d_colour, ruling_colour, ...    the same thing has the same colour in all of them
//   Eye                                       a direction to look from
//   net_scene                                 a surface with its rulings and its control net
//   warp_scene                                a strip in the colours of its warp
#pragma once

#include <vector>

#include "torse/figures/sampled.hpp"
#include "torse/quasi/sampling.hpp"

namespace torse::figures {

inline constexpr const char* c_colour = "#1f5fa8";
inline constexpr const char* d_colour = "#1e7d45";
inline constexpr const char* ruling_colour = "#444";
inline constexpr const char* tangent_colour = "#b8860b";
inline constexpr const char* edge_colour = "#c0392b";
inline constexpr const char* help_colour = "#888";

/// Azimuth and elevation in degrees.
struct Eye {
  double azimuth;
  double elevation;
};

/// The surface with rulings and both boundaries, and with its control polygons and their sides c_i d_i if `net`.
Scene net_scene(const Surface& surface, const DrawnSurface& drawn, const Eye& eye, bool net);

/// The strip between sampled rulings; `largest` is the warp, in degrees, that has the last colour.
Scene warp_scene(const std::vector<quasi::SampledRuling>& rulings, double largest, const Eye& eye);

}  // namespace torse::figures
