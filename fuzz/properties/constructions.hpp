// The constructions of the library by name, over any scalar.
//   ConstructionInput        what they take, in fractions          Ingredients<S>       the same in S
//   construction_names       all of them                           construct<S>         the surface of one
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/developable/cells.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/interpolation.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/regression.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/developable/special.hpp"
#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/spline/elevation.hpp"

namespace torse::fuzz {

/// Functions of one Bezier piece take the first n + 1 rows of p, on [0, 1].
struct ConstructionInput {
  std::string method{"13"};
  KnotList<Rational> knots = bezier_knots<Rational>(1);
  std::vector<Row4> p{};
  Row4 q0 = Row4::Constant(Rational());
  Functions functions{};
  std::vector<Rational> lengths{};        ///< as many as p
  Rational a{2};                          ///< not 0, not 1
  Rational b{3};                          ///< not 0
  Row4 end = Row4::Constant(Rational());  ///< the last ruling of "interpolate"
  /// The polynomials a, b of "directrix" by Bernstein coefficients; its curve is p.
  std::vector<Rational> polynomial_a{};
  std::vector<Rational> polynomial_b{};

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("method", in.method);
    visit("knots", in.knots);
    visit("p", in.p);
    visit("q0", in.q0);
    visit("functions", in.functions);
    visit("lengths", in.lengths);
    visit("a", in.a);
    visit("b", in.b);
    visit("end", in.end);
    visit("polynomial_a", in.polynomial_a);
    visit("polynomial_b", in.polynomial_b);
  }
};

/// The names in the order of the papers.
inline constexpr std::array construction_names{
    "13",        "7.1",         "14",      "15",   "16",         "16 rulings",   "18",         "pieces",
    "cylinder",  "cone",        "tangent", "part", "start cone", "mean tangent", "mean chord", "affine",
    "directrix", "interpolate", "moebius", "edge", "factors",    "elevate",      "insert"};

template <class S>
using SurfaceOver = RuledSpline<S, Vec<S, 4>>;

template <class S>
struct Ingredients {
  KnotList<S> u;
  std::vector<Vec<S, 4>> p;
  Vec<S, 4> q0;
  S lambda;
  S m;
  S sigma;
  std::vector<S> lengths;
  S a;
  S b;
  Vec<S, 4> end;
  std::vector<S> polynomial_a;
  std::vector<S> polynomial_b;
};

/// The input in S, number by number.
template <class S, class Lift>
Ingredients<S> ingredients(const ConstructionInput& in, const Lift& lift) {
  const auto numbers = [&](const std::vector<Rational>& list) {
    std::vector<S> lifted;
    for (const Rational& x : list) lifted.push_back(lift(x));
    return lifted;
  };
  const auto row = [&](const Row4& x) { return Vec<S, 4>(lift(x[0]), lift(x[1]), lift(x[2]), lift(x[3])); };
  std::vector<Vec<S, 4>> p;
  for (const Row4& x : in.p) p.push_back(row(x));
  return {KnotList<S>(in.knots.degree(), numbers(in.knots.list())),
          std::move(p),
          row(in.q0),
          lift(in.functions.lambda),
          lift(in.functions.m),
          lift(in.functions.sigma),
          numbers(in.lengths),
          lift(in.a),
          lift(in.b),
          row(in.end),
          numbers(in.polynomial_a),
          numbers(in.polynomial_b)};
}

namespace detail {

template <class S>
using RowsOver = std::vector<Vec<S, 4>>;

template <class S>
RowsOver<S> linear_row(const Ingredients<S>& in) {
  return linear_net<S, Vec<S, 4>>(in.u, in.p, in.lambda, in.m, in.q0);
}

/// q by one of the ways to the net of FJ07.13.
template <class S>
RowsOver<S> net_row(std::string_view method, const Ingredients<S>& in) {
  using P = Vec<S, 4>;
  const std::span<const P> p = in.p;
  if (method == "7.1") return rational_net<S, P>(in.u, p, in.lambda, in.m, in.sigma, in.q0);
  if (method == "18") return cell_net<S, P>(in.u, p, first_cell(in.u, in.lambda, in.m), in.q0);
  RowsOver<S> q{in.q0};
  if (method == "16 rulings") {
    for (P& ruling : eq16_rulings<S, P>(in.u, p, in.lambda, in.m, in.q0)) q.push_back(sum(ruling, in.p[q.size()]));
    return q;
  }
  for (int i = 1; i <= in.u.last(); ++i) {
    const P& vertex = in.p[static_cast<std::size_t>(i)];
    if (method == "14") q.push_back(eq14<S, P>(in.u, p, in.lambda, in.m, in.q0, i));
    if (method == "15") q.push_back(sum(eq15<S, P>(in.u, p, in.lambda, in.m, in.q0, i), vertex));
    if (method == "16") q.push_back(sum(eq16<S, P>(in.u, p, in.lambda, in.m, in.q0, i), vertex));
  }
  return method == "13" ? linear_row(in) : q;
}

/// The Bezier rows of all pieces as one net.
template <class S>
SurfaceOver<S> joined_pieces(const Ingredients<S>& in) {
  using P = Vec<S, 4>;
  const int n = in.u.degree();
  const auto rows = piecewise_net<S, P>(in.u, in.p, in.lambda, in.m, in.q0);
  std::vector<S> knots(static_cast<std::size_t>(n), in.u.piece_begin(in.u.proper_pieces().front()));
  RowsOver<S> p;
  RowsOver<S> q;
  std::size_t next = 0;
  for (const int k : in.u.proper_pieces()) {
    const RowsOver<S> piece = bezier_points<S, P>(in.u, in.p, k);
    const int skip = p.empty() ? 0 : 1;
    p.insert(p.end(), piece.begin() + skip, piece.end());
    q.insert(q.end(), rows[next].begin() + skip, rows[next].end());
    ++next;
    knots.insert(knots.end(), static_cast<std::size_t>(n), in.u.piece_end(k));
  }
  return {KnotList<S>(n, std::move(knots)), std::move(p), std::move(q)};
}

/// A surface of one Bezier piece.
template <class S>
SurfaceOver<S> bezier_surface(std::string_view method, const Ingredients<S>& in) {
  using P = Vec<S, 4>;
  const int n = in.u.degree();
  const auto bezier = bezier_knots<S>(n);
  RowsOver<S> first(in.p.begin(), in.p.begin() + n + 1);
  const std::span<const P> p = first;
  if (method == "tangent") return {bezier, first, tangent_net<S, P>(p)};
  if (method == "start cone") return {bezier, first, start_cone_net<S, P>(p, in.a)};
  if (method == "mean tangent") return {bezier, first, mean_tangent_net<S, P>(p)};
  if (method == "mean chord") return {bezier, first, mean_chord_net<S, P>(p)};
  if (method == "affine") return {bezier, first, affine_net<S, P>(p, in.a, in.b, in.q0)};
  if (method == "directrix") {
    const DirectrixEquation<S> equation{Bernstein<S>(in.polynomial_a), Bernstein<S>(in.polynomial_b)};
    const DirectrixSolution<S, P> solution = solve_directrix<S, P>(p, equation);
    RowsOver<S> q = first;
    for (std::size_t i = 0; i < q.size(); ++i) add(q[i], solution.tau.at(i));
    return {bezier, first, std::move(q)};
  }
  if (method == "edge") {
    RowsOver<S> r = first;
    r.push_back(in.q0);
    return {bezier, edge_patch<S, P>(r, in.m), edge_patch<S, P>(r, in.lambda)};
  }
  const RowsOver<S> q = linear_net<S, P>(bezier, p, in.lambda, in.m, in.q0);
  if (method == "moebius") return {bezier, moebius_rows<S, P>(first, in.b), moebius_rows<S, P>(q, in.b)};
  return {bezier_knots<S>(n + 1), times_linear<S, P>(first, {in.a, in.b}), times_linear<S, P>(q, {in.b, in.a})};
}

template <class S>
std::vector<Vec<S, 3>> points_of(const RowsOver<S>& rows) {
  std::vector<Vec<S, 3>> points;
  for (const Vec<S, 4>& x : rows) points.emplace_back(x[1], x[2], x[3]);
  return points;
}

}  // namespace detail

/// The surface of a construction.
template <class S>
SurfaceOver<S> construct(std::string_view method, const Ingredients<S>& in) {
  using P = Vec<S, 4>;
  const std::span<const P> p = in.p;
  const auto with = [&](std::vector<P> q) { return SurfaceOver<S>(in.u, in.p, std::move(q)); };
  if (method == "pieces") return detail::joined_pieces(in);
  if (method == "cylinder") return with(cylinder_net<S, P>(p, in.q0, in.lengths));
  if (method == "cone") return with(cone_net<S, P>(p, in.a, in.q0));
  if (method == "part") return with(restrict_rulings<S, P>(p, detail::linear_row(in), in.a));
  if (method == "interpolate") {
    std::vector<P> q;
    for (const Vec<S, 3>& x :
         interpolating_net<S>(in.u, detail::points_of<S>(in.p), Vec<S, 3>(in.q0[1], in.q0[2], in.q0[3]),
                              Vec<S, 3>(in.end[1], in.end[2], in.end[3]), in.m, in.lambda)) {
      q.emplace_back(from_int<S>(1), x[0], x[1], x[2]);
    }
    return with(std::move(q));
  }
  if (method == "elevate" || method == "insert") {
    const auto changed = [&](std::vector<P> row) {
      const Spline<S, P> curve(in.u, std::move(row));
      if (method == "elevate") return elevate(curve);
      const int k = in.u.proper_pieces().front();
      const S middle = (in.u.piece_begin(k) + in.u.piece_end(k)) / from_int<S>(2);
      return insert_knot(curve, middle, in.u.degree() + k - 2);
    };
    Spline<S, P> first = changed(in.p);
    return {std::move(first.knots), std::move(first.control), changed(detail::linear_row(in)).control};
  }
  for (const std::string_view name : {"13", "7.1", "14", "15", "16", "16 rulings", "18"}) {
    if (method == name) return with(detail::net_row(method, in));
  }
  return detail::bezier_surface(method, in);
}

}  // namespace torse::fuzz
