// Developable Bezier surfaces through a directrix, ZW06: given the curve a(u) (its Bezier points c) and polynomials
// a(u), b(u), the rulings tau(u) = sum_i B_i^n (d_i - c_i) with a' = a tau + b tau'.
//   DirectrixEquation             a and b            is_cone_equation     a = b' (ZW06.9)
//   directrix_rows, directrix_right_sides            the linear system for tau_0..tau_n (ZW06.G)
//   DirectrixSolution, solve_directrix               no solution with a certificate, one, or a family
//   times_polynomial              the Bezier rows of a polynomial times a curve
//   directrix_edge                a1 = a(u) - b tau: edge of regression (ZW06.8, 15)
//   directrix_vertex              the vertex of the cone (ZW06.11)
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/point_system.hpp"
#include "torse/developable/factors.hpp"

namespace torse {

/// The functions of a' = a tau + b tau' (ZW06, case 2), polynomials on [0, 1].
template <Field S>
struct DirectrixEquation {
  Bernstein<S> a;
  Bernstein<S> b;
};

/// Whether a = b', so that a1 = a(u) - b tau, which has the derivative (a - b') tau, is a point (ZW06.9).
template <Field S>
Truth is_cone_equation(const DirectrixEquation<S>& equation) {
  return (equation.a - equation.b.derivative()).zero();
}

/// The degree n + max(deg a, deg b - 1) on which the coefficients are compared, for a directrix of degree n >= 1.
template <Field S>
int comparison_degree(int n, const DirectrixEquation<S>& equation) {
  return n + std::max(equation.a.degree(), equation.b.degree() - 1);
}

/// The left sides: the Bernstein coefficients of a tau + b tau' as linear forms in tau_0, ..., tau_n (ZW06.G).
template <Field S>
std::vector<Form<S>> directrix_rows(int n, const DirectrixEquation<S>& equation) {
  const int degree = comparison_degree(n, equation);
  const BinaryForm<S> a = equation.a.elevated(degree - n).form();
  const BinaryForm<S> b = from_int<S>(n) * equation.b.elevated(degree - n + 1).form();
  const std::vector<S> of_curve = binomials<S>(n);
  const std::vector<S> of_derivative = binomials<S>(n - 1);
  std::vector<Form<S>> rows(static_cast<std::size_t>(degree) + 1);
  for (int k = 0; k <= n; ++k) {
    const Form<S> tau = Form<S>::generator(k);
    const std::size_t at_k = static_cast<std::size_t>(k);
    for (int i = 0; i <= a.degree(); ++i)
      add_scaled(rows[at_k + static_cast<std::size_t>(i)], a[i] * of_curve[at_k], tau);
    if (k == n) break;
    const Form<S> step = difference(Form<S>::generator(k + 1), tau);
    for (int i = 0; i <= b.degree(); ++i) {
      add_scaled(rows[at_k + static_cast<std::size_t>(i)], b[i] * of_derivative[at_k], step);
    }
  }
  const std::vector<S> weights = binomials<S>(degree);
  for (std::size_t j = 0; j < rows.size(); ++j) divide(rows[j], weights[j]);
  return rows;
}

/// The right sides: the Bezier points of a' raised to `degree` >= n - 1 (ZW06.G).
template <Field S, Point<S> P>
std::vector<P> directrix_right_sides(std::span<const P> c, int degree) {
  std::vector<P> points;
  const int n = static_cast<int>(c.size()) - 1;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) points.push_back(scaled(from_int<S>(n), difference(c[i + 1], c[i])));
  const Linear<S> one{from_int<S>(1), from_int<S>(0)};
  for (int d = n; d <= degree; ++d) points = times_linear(points, one);
  return points;
}

/// The rulings of a directrix. Without a contradiction the solutions are tau + kappa v for every vector v if there is a
/// family, else tau alone. kappa spans the polynomials of degree n with a kappa + b kappa' = 0, its first coefficient
/// that is not zero is 1, and tau is zero there. Two such polynomials have a constant quotient, so one spans them all.
template <Field S, Point<S> P>
struct DirectrixSolution {
  std::optional<Contradiction<S, P>> contradiction{};
  std::vector<P> tau{};
  std::optional<Bernstein<S>> family{};
};

/// Solves a' = a tau + b tau' for tau_0, ..., tau_n by comparing Bernstein coefficients (ZW06.G); equation j of a
/// contradiction is that of coefficient j. Throws InvalidInput naming "c.points" for fewer than two points and "a"
/// where a and b vanish identically, Undecided where the field cannot decide a zero.
///
/// For constant a and b of degree at most one there are n + 1 equations for n + 1 unknowns, and their determinant is
/// the product of the a + k b', k = 0..n: (u - r)^k with b(r) = 0 is mapped to (a + k b') (u - r)^k, and for constant b
/// the monomials to a triangular matrix. If no factor vanishes, every directrix has exactly one tau, of degree n - 1.
/// If the last one does (ZW06.20, and ZW06.12 for b' = 0), every directrix has a family. If another one does, only
/// those directrices have one whose derivative of order k + 1 vanishes at r. For other a and b the equations outnumber
/// the unknowns.
template <Field S, Point<S> P>
DirectrixSolution<S, P> solve_directrix(std::span<const P> c, const DirectrixEquation<S>& equation) {
  if (c.size() < 2) throw InvalidInput("c.points", "expected at least two control points");
  if (definitely(equation.a.zero() & equation.b.zero())) {
    throw InvalidInput("a", "expected a or b to be other than zero: a' = 0 is no equation for the rulings");
  }
  const int n = static_cast<int>(c.size()) - 1;
  const std::vector<Form<S>> left = directrix_rows(n, equation);
  const std::vector<P> right = directrix_right_sides<S, P>(c, comparison_degree(n, equation));
  PointSystem<S, P> system(n + 1);
  for (std::size_t j = 0; j < left.size() && !system.contradiction(); ++j) system.insert(left[j], right[j]);
  if (system.contradiction()) return {.contradiction = system.contradiction()};
  DirectrixSolution<S, P> solution{.tau = system.solution()};
  for (std::vector<S>& kappa : system.kernel()) solution.family = Bernstein<S>(std::move(kappa));
  return solution;
}

/// The Bezier rows of f(u) x(u), of degree deg f + n.
template <Field S, Point<S> P>
std::vector<P> times_polynomial(const Bernstein<S>& f, std::span<const P> rows) {
  const int n = static_cast<int>(rows.size()) - 1;
  const int d = f.degree();
  const BinaryForm<S> factor = f.form();
  const std::vector<S> of_rows = binomials<S>(n);
  const std::vector<S> of_product = binomials<S>(n + d);
  std::vector<P> product(of_product.size(), PointTraits<P>::zero());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const P weighted = scaled(of_rows[j], rows[j]);
    for (int i = 0; i <= d; ++i) add_scaled(product[j + static_cast<std::size_t>(i)], factor[i], weighted);
  }
  for (std::size_t k = 0; k < product.size(); ++k) divide(product[k], of_product[k]);
  return product;
}

/// The Bezier points of a1 = a(u) - b tau, of degree n + deg b (ZW06.8). For a != b' the surface is the tangent surface
/// of this curve (ZW06.15), for a = b' all these points are the vertex of a cone.
template <Field S, Point<S> P>
std::vector<P> directrix_edge(std::span<const P> c, std::span<const P> tau, const Bernstein<S>& b) {
  const Bernstein<S> one(std::vector<S>(static_cast<std::size_t>(b.degree()) + 1, from_int<S>(1)));
  std::vector<P> edge = times_polynomial<S, P>(one, c);
  const std::vector<P> along = times_polynomial<S, P>(b, tau);
  for (std::size_t i = 0; i < edge.size(); ++i) subtract(edge[i], along[i]);
  return edge;
}

/// The vertex a(0) - b(0) tau(0) of the cone that tau makes where a = b' (ZW06.11). Throws InvalidInput naming "a" for
/// a != b', a tangent surface.
template <Field S, Point<S> P>
P directrix_vertex(std::span<const P> c, std::span<const P> tau, const DirectrixEquation<S>& equation) {
  if (!possibly(is_cone_equation(equation))) throw InvalidInput("a", "differs from b': the surface is no cone");
  return combine(from_int<S>(1), c.front(), -equation.b[0], tau.front());
}

}  // namespace torse
