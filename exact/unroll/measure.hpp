// True lengths and areas of a surface, enclosed.
//   SurfaceMeasures, measure
#pragma once

#include <vector>

#include "torse/exact/unroll/strip.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

/// The lengths of the rails on the surface, and the area of its development.
struct SurfaceMeasures {
  Interval length_c;
  Interval length_d;
  Interval planar_area;
};

/// By Arb's adaptive, certified Gauss-Legendre quadrature (acb_calc_integrate), to about 60 bits. The strips have no
/// obstacle (strip.hpp).
SurfaceMeasures measure(const std::vector<PieceStrip>& strips);

}  // namespace torse
