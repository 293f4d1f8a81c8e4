// What a route's rounding errors come to on one input.
//   Measurement          of one route in one arithmetic
//   measure_case         of all routes and scalars of a design on a case
//   least_perturbation   the backward error
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torse/studies/routes.hpp"

namespace torse::studies {

/// All errors are of the computed numbers x^ against the exact results x of the same inputs, with the arithmetic's unit
/// roundoff u = 2^-p.
struct Measurement {
  std::string route;
  std::string scalar;
  bool finite = true;      ///< false: something is not finite; nothing else is known then
  double ulps = 0;         ///< the largest |x^-x| in units of the last place of its x
  double units = 0;        ///< max |x^-x| / max |x|, in u
  double conditioned = 0;  ///< max |x^-x| / sum_k |t_k dx/dt_k|, in u: what moving all inputs by 1 u may do is 1
  double condition = 0;    ///< of the problem: max_x sum_k |t_k dx/dt_k| / max |x|
  std::optional<double> backward;  ///< least_perturbation, in u
  std::optional<double> warp;      ///< degrees, the largest in the middle of the pieces
  std::optional<double> bound;     ///< max |x^-x| / bound, for the routes of FJ07.13.rulings
};

/// Routes that do not apply to the case (N > 1) are left out.
std::vector<Measurement> measure_case(const Case& in, const std::vector<std::string>& routes,
                                      const std::vector<std::string>& scalars);

/// The relative perturbations e_k of the inputs that explain the errors r_i to first order, sum_k e_k t_k dx_i/dt_k =
/// r_i, least in the Euclidean norm: their largest |e_k|. None where no perturbation explains them.
std::optional<double> least_perturbation(const std::vector<std::vector<double>>& weighed,
                                         const std::vector<double>& errors);

}  // namespace torse::studies
