// The routes to developable nets and the transformations of them, over any scalar.
//   Problem            what a route computes: routes of one problem compute the same numbers
//   RouteInfo          name, problem, and what applies to it
//   route_infos, route_names, scalar_names
//   Computed, Arithmetic, arithmetic     a route in an arithmetic that is chosen at run time
//   Sensitivities, sensitivities         the exact numbers with their derivatives by all inputs
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/studies/inputs.hpp"

namespace torse::studies {

/// Routes of one problem have equal results in exact arithmetic.
enum class Problem {
  first,     ///< d_0..d_L from d_0
  middle,    ///< the same from d_{L/2}
  last,      ///< the same from d_L
  pieces,    ///< the Bezier rows of all pieces from d(u_{n-1})
  rational,  ///< weights and points of the rational net from d_0 with weight 1
  aumann,    ///< ZW06.20 on one Bezier piece
  other,     ///< a route alone with its problem
};

/// What is known of a route.
struct RouteInfo {
  std::string name;
  Problem problem = Problem::other;
  bool one_piece = false;  ///< for N = 1 only
  bool net = false;        ///< its results begin with the row d over the input's knots, beside c
  int anchor = 0;          ///< the anchor that it starts from
};

/// All routes.
const std::vector<RouteInfo>& route_infos();
std::vector<std::string> route_names();

/// What a route came to: exact values of the computed numbers.
struct Computed {
  std::vector<Rational> values;
  bool finite = true;  ///< false: an infinity, NaN, or a refused input; `values` is empty then
};

/// A scalar by its name.
struct Arithmetic {
  std::string name;
  int precision;  ///< the bits of its significand; 0 for exact numbers
  Computed (*run)(std::size_t route, const Case& in);
};

/// float, double, long double, float128, mpfr53, mpfr113, mpfr200.
std::vector<std::string> scalar_names();
/// One of these, or "exact".
const Arithmetic& arithmetic(const std::string& name);

/// Values x_i and the derivatives by the inputs t_k of Case, which are exact.
struct Sensitivities {
  std::vector<Rational> values;
  std::vector<std::vector<Rational>> derivatives;  ///< [i][k]
};
Sensitivities sensitivities(std::size_t route, const Case& in);

}  // namespace torse::studies
