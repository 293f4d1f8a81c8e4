// Ruled B-spline surfaces in doubles, fitted to samples of another.
//   Breakpoint           a parameter with the number of its knots
//   SurfaceSamples       both rows of a surface at parameters of each piece
//   fitted_surface       the least squares fit over given knots, ends kept
//   removal_costs        what the derivatives say of removing one knot
#pragma once

#include <optional>
#include <vector>

#include "torse/developable/ruled.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::quasi {

using DoublePoint = Vec<double, 3>;
using DoubleSurface = RuledSpline<double, DoublePoint>;

/// A breakpoint inside the domain and how often it is a knot.
struct Breakpoint {
  double t;
  int multiplicity;
};

/// Points of both rows at one parameter, which lies in a piece of the sampled surface.
struct SurfaceSample {
  double t;
  DoublePoint c;
  DoublePoint d;
};

/// `count` parameters in each proper piece, evenly spread.
std::vector<SurfaceSample> sampled(const DoubleSurface& surface, int count);

/// The knots of degree n with n-fold ends a, b.
KnotList<double> knots_with(int degree, double a, double b, const std::vector<Breakpoint>& inside);

/// The surface over these knots with the least sum of squared distances from the samples and the end points of `like`.
/// Nothing where the samples do not determine it.
std::optional<DoubleSurface> fitted_surface(const KnotList<double>& u, const std::vector<SurfaceSample>& samples,
                                            const DoubleSurface& like);

/// For each breakpoint of the surface the jump of the first derivative that its knots leave free, times the power of
/// the knots' distance that makes it a length: 0 where one of its knots is superfluous.
std::vector<double> removal_costs(const DoubleSurface& surface, const std::vector<Breakpoint>& inside);

}  // namespace torse::quasi
