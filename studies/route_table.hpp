// The routes themselves.
//   Route<S>, route_table<S>     a name and a function for each
//   run_in<S>                    a route in S with exact values of its results
#pragma once

#include <cmath>
#include <utility>

#include "torse/developable/cells.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/interpolation.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/regression.hpp"
#include "torse/developable/special.hpp"
#include "torse/spline/elevation.hpp"
#include "torse/studies/routes.hpp"

namespace torse::studies {

template <class S>
using Point3 = Vec<S, 3>;
template <class S>
using Row = std::vector<Vec<S, 3>>;
template <class S>
using Homogeneous = std::vector<Vec<S, 4>>;

/// A route: its results as one list of numbers.
template <class S>
struct Route {
  RouteInfo info;
  std::vector<S> (*run)(const Inputs<S>& in);
};

template <class S>
std::vector<S> flat(const Row<S>& row) {
  std::vector<S> list;
  for (const Point3<S>& x : row) list.insert(list.end(), {x[0], x[1], x[2]});
  return list;
}

/// The affine points of homogeneous rows, then the weights.
template <class S>
std::vector<S> flat(const Homogeneous<S>& rows) {
  std::vector<S> list;
  for (const Vec<S, 4>& x : rows) list.insert(list.end(), {x[1] / x[0], x[2] / x[0], x[3] / x[0]});
  for (const Vec<S, 4>& x : rows) list.push_back(x[0]);
  return list;
}

template <class S>
Homogeneous<S> homogeneous(const Row<S>& points, const std::vector<S>& weights) {
  Homogeneous<S> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3<S> x = scaled(weights[i], points[i]);
    rows.push_back(Vec<S, 4>(weights[i], x[0], x[1], x[2]));
  }
  return rows;
}

template <class S>
Vec<S, 4> unit_row(const Point3<S>& x) {
  return {from_int<S>(1), x[0], x[1], x[2]};
}

/// The row c + r from rulings r_1, r_2, ... and d_0.
template <class S>
Row<S> from_rulings(const Inputs<S>& in, const Row<S>& rulings) {
  Row<S> d{in.anchors[0]};
  for (std::size_t i = 0; i < rulings.size(); ++i) d.push_back(sum(in.c[i + 1], rulings[i]));
  return d;
}

/// FJ07.13 as d_{i+1} = d_i + ((u_{i+n} - L*) (c_i - d_i) + (L* - u_i) (c_{i+1} - d_i)) / (M* - u_i).
template <class S>
std::vector<S> by_steps(const Inputs<S>& in) {
  const int n = in.u.degree();
  Row<S> d{in.anchors[0]};
  for (int i = 0; i < in.u.last(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    Point3<S> step = combine(in.u[i + n] - in.lambda, difference(in.c[at], d[at]), in.lambda - in.u[i],
                             difference(in.c[at + 1], d[at]));
    divide(step, in.m - in.u[i]);
    d.push_back(sum(d[at], step));
  }
  return flat<S>(d);
}

/// Every vertex by a closed form.
template <class S, class Vertex>
std::vector<S> by_vertices(const Inputs<S>& in, Vertex vertex) {
  Row<S> d{in.anchors[0]};
  for (int i = 1; i <= in.u.last(); ++i) d.push_back(vertex(i));
  return flat<S>(d);
}

/// The Bezier rows of all pieces; `coefficients` gives (Lam_k, M_k) or (lam_k, mu_k), `net` the row from them.
template <class S>
std::vector<S> by_affine_pieces(const Inputs<S>& in) {
  std::vector<S> list;
  AffineCell<S> cell = affine_from_local(local_parameter(in.u, in.lambda, 1), local_parameter(in.u, in.m, 1));
  Point3<S> start = in.anchors[0];
  for (int k = 1; k <= in.u.pieces(); ++k) {
    if (k > 1) cell = next_affine(in.u, cell, k);
    const Row<S> row = affine_net<S, Point3<S>>(bezier_points<S, Point3<S>>(in.u, in.c, k), cell.lam, cell.mu, start);
    start = row.back();
    for (const S& x : flat<S>(row)) list.push_back(x);
  }
  return list;
}

/// Every piece on its own with Lam_k, M_k from L*, M*.
template <class S>
std::vector<S> by_lone_pieces(const Inputs<S>& in) {
  std::vector<S> list;
  Point3<S> start = in.anchors[0];
  for (int k = 1; k <= in.u.pieces(); ++k) {
    const Row<S> row =
        aumann_net<S, Point3<S>>(bezier_points<S, Point3<S>>(in.u, in.c, k), local_parameter(in.u, in.lambda, k),
                                 local_parameter(in.u, in.m, k), start);
    start = row.back();
    for (const S& x : flat<S>(row)) list.push_back(x);
  }
  return list;
}

template <class S>
std::vector<S> by_global_pieces(const Inputs<S>& in) {
  std::vector<S> list;
  for (const Row<S>& row : piecewise_net<S, Point3<S>>(in.u, in.c, in.lambda, in.m, in.anchors[0])) {
    for (const S& x : flat<S>(row)) list.push_back(x);
  }
  return list;
}

template <class S>
std::vector<S> rational_route(const Inputs<S>& in) {
  const Homogeneous<S> p = homogeneous<S>(in.c, in.weights);
  return flat<S>(rational_net<S, Vec<S, 4>>(in.u, p, in.lambda, in.m, in.sigma, unit_row<S>(in.anchors[0])));
}

template <class S>
std::vector<S> printed_rational_route(const Inputs<S>& in) {
  Homogeneous<S> p = homogeneous<S>(in.c, in.weights);
  for (Vec<S, 4>& x : p) divide(x, in.sigma);
  return flat<S>(printed_net<S, Vec<S, 4>>(in.u, p, in.lambda, in.m, 0, unit_row<S>(in.anchors[0])));
}

template <class S>
std::vector<S> aumann_by_rho(const Inputs<S>& in) {
  const S one = from_int<S>(1);
  return flat<S>(affine_net<S, Point3<S>>(in.c, in.lambda / in.m, one - one / in.m, in.anchors[0]));
}

template <class S>
std::vector<S> aumann_by_m(const Inputs<S>& in) {
  return flat<S>(aumann_net<S, Point3<S>>(in.c, in.lambda, in.m, in.anchors[0]));
}

/// Both rows with two knots inserted, at the shares s and s^2 of the domain.
template <class S>
std::vector<S> inserted(const Inputs<S>& in) {
  const S length = in.u.domain_end() - in.u.domain_begin();
  Spline<S, Point3<S>> c(in.u, in.c);
  for (const S& share : {in.share, in.share * in.share}) c = insert_knot(c, in.u.domain_begin() + share * length);
  return flat<S>(c.control);
}

template <class S>
std::vector<S> moebius_route(const Inputs<S>& in) {
  return flat<S>(moebius_rows(homogeneous<S>(in.c, in.weights), in.sigma));
}

/// FJ21.5.4 with f = 1, g = 1 - s t: the second row p + g (q - p).
template <class S>
std::vector<S> trimmed(const Inputs<S>& in) {
  const S one = from_int<S>(1);
  const Homogeneous<S> p = homogeneous<S>(in.c, in.weights);
  Homogeneous<S> rulings = homogeneous<S>(in.e, in.e_weights);
  for (std::size_t i = 0; i < p.size(); ++i) subtract(rulings[i], p[i]);
  Homogeneous<S> row = times_linear(rulings, Linear<S>{one, -in.share});
  const Homogeneous<S> raised = times_linear(p, Linear<S>{one, from_int<S>(0)});
  for (std::size_t i = 0; i < row.size(); ++i) add(row[i], raised[i]);
  return flat<S>(row);
}

template <class S>
std::vector<S> edge_route(const Inputs<S>& in) {
  return flat<S>(edge_curve(in.c, in.e, BlossomFunctions<S>{in.lambda, in.m, from_int<S>(1)}));
}

template <class S>
std::vector<S> interpolated(const Inputs<S>& in) {
  const Point3<S> v = difference(in.e.front(), in.c.front());
  const Point3<S> w = difference(in.e.back(), in.c.back());
  return flat<S>(interpolating_net<S>(in.u, in.c, v, w, in.m, in.lambda));
}

/// All routes and transformations; the names are claim ids where a formula has one.
template <class S>
const std::vector<Route<S>>& route_table() {
  using In = const Inputs<S>&;
  using P = Point3<S>;
  static const std::vector<Route<S>> table{
      {{"FJ07.13", Problem::first, false, true},
       [](In in) { return flat<S>(printed_net<S, P>(in.u, in.c, in.lambda, in.m, 0, in.anchors[0])); }},
      {{"FJ07.13.rulings", Problem::first, false, true},
       [](In in) { return flat<S>(linear_net<S, P>(in.u, in.c, in.lambda, in.m, in.anchors[0])); }},
      {{"FJ07.13.steps", Problem::first, false, true}, by_steps<S>},
      {{"FJ07.14", Problem::first, false, true},
       [](In in) {
         return by_vertices<S>(in, [&](int i) { return eq14<S, P>(in.u, in.c, in.lambda, in.m, in.anchors[0], i); });
       }},
      {{"FJ07.15", Problem::first, false, true},
       [](In in) {
         return by_vertices<S>(in, [&](int i) {
           return sum(in.c[static_cast<std::size_t>(i)], eq15<S, P>(in.u, in.c, in.lambda, in.m, in.anchors[0], i));
         });
       }},
      {{"FJ07.16", Problem::first, false, true},
       [](In in) { return flat<S>(from_rulings(in, eq16_rulings<S, P>(in.u, in.c, in.lambda, in.m, in.anchors[0]))); }},
      {{"FJ07.18", Problem::first, false, true},
       [](In in) { return flat<S>(cell_net<S, P>(in.u, in.c, first_cell(in.u, in.lambda, in.m), in.anchors[0])); }},
      {{"FJ07.13.middle", Problem::middle, false, true, 1},
       [](In in) { return flat<S>(printed_net<S, P>(in.u, in.c, in.lambda, in.m, in.u.last() / 2, in.anchors[1])); }},
      {{"FJ07.13.rulings.middle", Problem::middle, false, true, 1},
       [](In in) { return flat<S>(net_from<S, P>(in.u, in.c, in.lambda, in.m, in.u.last() / 2, in.anchors[1])); }},
      {{"FJ07.13.backward", Problem::last, false, true, 2},
       [](In in) { return flat<S>(printed_net<S, P>(in.u, in.c, in.lambda, in.m, in.u.last(), in.anchors[2])); }},
      {{"FJ07.13.rulings.backward", Problem::last, false, true, 2},
       [](In in) { return flat<S>(net_from<S, P>(in.u, in.c, in.lambda, in.m, in.u.last(), in.anchors[2])); }},
      {{"FJ07.10", Problem::pieces}, by_global_pieces<S>},
      {{"FJ07.11", Problem::pieces}, by_affine_pieces<S>},
      {{"FJ07.12", Problem::pieces}, by_lone_pieces<S>},
      {{"FJ21.7.1", Problem::rational}, rational_route<S>},
      {{"FJ21.7.1.printed", Problem::rational}, printed_rational_route<S>},
      {{"ZW06.20", Problem::aumann, true, true}, aumann_by_rho<S>},
      {{"ZW06.20.M", Problem::aumann, true, true}, aumann_by_m<S>},
      {{"ZW06.12", Problem::other, true, true},
       [](In in) { return flat<S>(cone_net<S, P>(in.c, in.sigma, in.anchors[0])); }},
      {{"ZW06.13", Problem::other, true, true}, [](In in) { return flat<S>(start_cone_net<S, P>(in.c, in.sigma)); }},
      {{"ZW06.16", Problem::other, true, true}, [](In in) { return flat<S>(mean_tangent_net<S, P>(in.c)); }},
      {{"ZW06.17", Problem::other, true, true}, [](In in) { return flat<S>(tangent_net<S, P>(in.c)); }},
      {{"ZW06.18", Problem::other, true, true}, [](In in) { return flat<S>(mean_chord_net<S, P>(in.c)); }},
      {{"insertion"}, inserted<S>},
      {{"elevation"}, [](In in) { return flat<S>(elevate(Spline<S, P>(in.u, in.c)).control); }},
      {{"moebius", Problem::other, true}, moebius_route<S>},
      {{"trimming", Problem::other, true}, trimmed<S>},
      {{"FJ07.17"}, [](In in) { return flat<S>(restrict_rulings<S, P>(in.c, in.e, in.share)); }},
      {{"edge", Problem::other, true}, edge_route<S>},
      {{"interpolation"}, interpolated<S>},
  };
  return table;
}

/// The exact value of a finite number, or false.
template <class S>
bool append_exact(const S& x, std::vector<Rational>& list) {
  if constexpr (std::floating_point<S>) {
    if (!std::isfinite(x)) return false;
    Rational value;
    for (S rest = x; rest != 0;) {
      const double part = static_cast<double>(rest);
      value += Rational::from_double(part);
      rest -= static_cast<S>(part);
    }
    list.push_back(std::move(value));
  } else if constexpr (std::same_as<S, Rational>) {
    list.push_back(x);
  } else {
    if constexpr (requires { x.finite(); }) {
      if (!x.finite()) return false;
    } else {
      if (mpfr_number_p(x.mpfr()) == 0) return false;
    }
    list.push_back(x.to_rational());
  }
  return true;
}

template <class S>
S from_float(float x) {
  if constexpr (std::floating_point<S>) {
    return static_cast<S>(x);
  } else {
    return S::from_double(x);
  }
}

template <class S>
Computed run_in(std::size_t route, const Case& in) {
  Computed computed;
  try {
    const Inputs<S> inputs = lift<S>(in, [](float x, std::size_t) { return from_float<S>(x); });
    for (const S& x : route_table<S>()[route].run(inputs)) {
      computed.finite = computed.finite && append_exact(x, computed.values);
    }
  } catch (const Error&) {
    computed.finite = false;
  }
  if (!computed.finite) computed.values.clear();
  return computed;
}

}  // namespace torse::studies
