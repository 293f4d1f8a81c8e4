// Where a developable patch is singular, decided exactly over Q.
//   Singularity          the reason: edge, vanishing ruling, stationary ruling, pole, no surface
//   SingularSet          a closed interval of parameters, or one parameter, with its reason
//   find_singularities   all of them, in order; none is a proof that the patch is regular
#pragma once

#include <string_view>
#include <vector>

#include "torse/developable/piece_functions.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/roots/real_roots.hpp"

namespace torse {

/// Why the rulings at some parameters hold a singular point.
///   edge         the edge of regression meets the ruling between c(t) and d(t), ends included
///   vanishing    c(t) = d(t)
///   stationary   p, p', q, q' have rank 2: every point of the ruling is singular
///   pole         w(t) = 0 or omega(t) = 0: c or d is not a finite point or has a base point
///   no_surface   the rulings sweep a curve or a line
enum class Singularity { edge, vanishing, stationary, pole, no_surface };

/// The word for it in reports.
std::string_view name_of(Singularity reason);

/// The parameters from <= t <= to. One parameter where both are the same root. A bound that is not rational is the only
/// root of its polynomial (square-free, with rational coefficients) in the interval.
struct SingularSet {
  struct Bound {
    RealRoot root;
    Polynomial<Rational> zero_of{};
  };

  Singularity reason;
  Bound from;
  Bound to;

  bool point() const { return from.root.lower == to.root.lower && from.root.upper == to.root.upper; }
};

/// The singular parameters of the patch (1-V) c(t) + V d(t), 0 <= V <= 1, over the closed pieces.
///
/// On a ruling with c(t) != d(t), both finite, the point x p + y q is singular iff x p' + y q' depends on p and q. By
/// the dependence alpha p + beta p' = gamma q + delta q' that is the one point -beta p + delta q of the edge of
/// regression, unless rank(p, p', q, q') = 2, where it is every point. The point is (1-V) c + V d with (1-V) : V =
/// -beta w : delta omega, so it lies on the patch iff f(t) = -beta delta w omega >= 0: signs of weights count. All of
/// this is decided by the signs of f between the isolated real roots of beta, delta, w, omega and of the two
/// polynomials whose roots are the vanishing rulings and the rulings of rank 2.
std::vector<SingularSet> find_singularities(const std::vector<PieceFunctions<Rational>>& pieces);

}  // namespace torse
