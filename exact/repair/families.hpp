// The families of developable nets, a file each.
//   plane_candidate       all points in a plane                                                            plane.cpp
//   cone_candidate        d_i - V = alpha (c_i - V) (FJ07.6)                                               cone.cpp
//   cylinder_candidate    d_i - c_i along one vector (FJ07.4); rows: q_i = alpha p_i + beta_i (0, v)       pencil.cpp
//   pencil_candidate      rows with q_i = alpha p_i + beta_i V                                             pencil.cpp
//   constant_candidate    FJ07.13 and FJ21.7.1                                                             constant.cpp
//   segments_candidate    the same between knots of multiplicity n                                         constant.cpp
//   edge_candidate        both rows from an edge of regression of lower degree                             edge.cpp
#pragma once

#include "torse/exact/repair/candidate.hpp"

namespace torse::repair {

Candidate<3> plane_candidate(const RealNet<3>& net);
Candidate<3> cone_candidate(const RealNet<3>& net);

/// For given alpha the nearest net with d_i - alpha c_i along V moves d_i and c_i against each other: with rho_i the
/// part of d_i - alpha c_i across V it costs |rho_i|^2 / (scale of d_i + alpha^2 scale of c_i). The best V is an
/// eigenvector. Points have alpha = 1 and any V, homogeneous rows any alpha and V at infinity.
template <int D>
Candidate<D> cylinder_candidate(const RealNet<D>& net);

/// Homogeneous rows with any alpha and V.
Candidate<4> pencil_candidate(const RealNet<4>& net);

/// The nearest of the nets with constant L*, M*, sigma. Nothing where the equations stay dependent, or a constant is at
/// infinity.
template <int D>
std::optional<Candidate<D>> constant_candidate(const KnotList<Rational>& u, const RealNet<D>& net, const Real& rival);

/// The same with constants of their own for each part between knots of multiplicity n, where there are 2 to 24.
template <int D>
std::optional<Candidate<D>> segments_candidate(const KnotList<Rational>& u, const RealNet<D>& net, const Real& rival);

/// The nearest surface between two curves on the tangents of an edge r, a spline of degree rho = n + 1 - j for 1 <= j <
/// n: with S + T = 1 over the domain,
///   p = a r_S + b r_T,   q = c r_S + d r_T
/// for polynomials a, b, c, d of degree j is developable for every r. j = 0 would be constant_candidate's nets. j = 1
/// has their products with linear factors (degree elevation FJ21.5.3, change of the rulings' length FJ21.5.4) and
/// surfaces of tangents c + v c' (FJ07.7). Nothing where no start was found.
template <int D>
std::optional<Candidate<D>> edge_candidate(const KnotList<Rational>& u, const RealNet<D>& net, int j,
                                           const Real& rival);

}  // namespace torse::repair
