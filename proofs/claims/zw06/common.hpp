// What the claims of ZW06 share: a directrix c and rulings tau of degree n on [0, 1], and polynomials a, b.
//   draw_polynomial, at_degree     a Bernstein polynomial with free coefficients; points raised to a degree
//   second_row, rulings_of         d_i = c_i + tau_i and back
//   along                          the point a tau + b tau'      applied   a linear form at points
//   JetInput                       rows with a' = a tau + b tau' at one parameter
//   RowInput                       a directrix and a parameter
#pragma once

#include <utility>
#include <vector>

#include "torse/developable/directrix.hpp"
#include "torse/proofs/claims/fj07/common.hpp"
#include "torse/proofs/claims/fj21/pair.hpp"

namespace torse::proofs::zw06 {

using fj21::degree_of;
using fj21::derivative;
using fj21::value;

template <class S>
Bernstein<S> draw_polynomial(Source<S>& from, int degree) {
  std::vector<S> b;
  for (int i = 0; i <= degree; ++i) b.push_back(from.scalar());
  return Bernstein<S>(std::move(b));
}

/// The Bezier points of the same curve with degree `degree`.
template <class S, class P>
std::vector<P> at_degree(std::vector<P> rows, int degree) {
  while (degree_of(rows) < degree) rows = times_linear(rows, Linear<S>{from_int<S>(1), from_int<S>(0)});
  return rows;
}

template <class P>
std::vector<P> second_row(const std::vector<P>& c, const std::vector<P>& tau) {
  std::vector<P> d;
  for (std::size_t i = 0; i < c.size(); ++i) d.push_back(sum(c[i], tau[i]));
  return d;
}

template <class P>
std::vector<P> rulings_of(const std::vector<P>& c, const std::vector<P>& d) {
  std::vector<P> tau;
  for (std::size_t i = 0; i < c.size(); ++i) tau.push_back(difference(d[i], c[i]));
  return tau;
}

/// a tau(u) + b tau'(u).
template <class P, class S>
P along(const S& a, const S& b, const std::vector<P>& tau, const S& u) {
  return combine(a, value(tau, u), b, derivative(tau, u));
}

/// sum_k form_k tau_k.
template <class S, class P>
P applied(const Form<S>& form, const std::vector<P>& tau) {
  P x = PointTraits<P>::zero();
  for (const auto& term : form.terms()) add_scaled(x, term.coefficient, tau[static_cast<std::size_t>(term.generator)]);
  return x;
}

/// Polynomials a, b, and rows c, tau of degree n that obey a' = a tau + b tau' at u, otherwise free. They are given by
/// their Taylor expansions at u.
template <class S, class P>
struct JetInput {
  DirectrixEquation<S> equation;
  S u;
  S v;
  P at_c;                     ///< a(u)
  std::vector<P> tau_taylor;  ///< tau(u), tau'(u), ...
  std::vector<P> c;
  std::vector<P> tau;

  std::vector<P> d() const { return second_row(c, tau); }
  /// a - b' at u.
  S speed() const { return equation.a(u) - equation.b.derivative()(u); }

  static JetInput draw(Source<S>& from, Size size);
};

template <class S, class P>
JetInput<S, P> make_jet(DirectrixEquation<S> equation, const S& u, const S& v, std::vector<P> c_taylor,
                        std::vector<P> tau_taylor) {
  c_taylor[1] = combine(equation.a(u), tau_taylor[0], equation.b(u), tau_taylor[1]);
  const KnotList<S> knots = bezier_knots<S>(degree_of(c_taylor));
  std::vector<P> c = fj07::taylor_net(knots, 1, u, c_taylor);
  std::vector<P> tau = fj07::taylor_net(knots, 1, u, tau_taylor);
  return {std::move(equation), u, v, c_taylor[0], std::move(tau_taylor), std::move(c), std::move(tau)};
}

/// The degree of b is N, that of a is N - 1.
template <class S, class P>
JetInput<S, P> JetInput<S, P>::draw(Source<S>& from, Size size) {
  Bernstein<S> a = draw_polynomial(from, size.pieces - 1);
  Bernstein<S> b = draw_polynomial(from, size.pieces);
  const S u = from.scalar();
  const S v = from.scalar();
  std::vector<P> c_taylor = from.template points<P>(size.n + 1);
  std::vector<P> tau_taylor = from.template points<P>(size.n + 1);
  return make_jet<S, P>({std::move(a), std::move(b)}, u, v, std::move(c_taylor), std::move(tau_taylor));
}

inline constexpr std::string_view degrees_remark = "N stands for the degree of b, N - 1 is that of a.";

/// A directrix and a parameter.
template <class S, class P>
struct RowInput {
  std::vector<P> c;
  S u;

  static RowInput draw(Source<S>& from, Size size);
};

template <class S, class P>
RowInput<S, P> RowInput<S, P>::draw(Source<S>& from, Size size) {
  std::vector<P> c = from.template points<P>(size.n + 1);
  return {std::move(c), from.scalar()};
}

/// Asserts a' = a tau + b tau' at u for a given equation.
template <class S, class P>
void require_equation(const RowInput<S, P>& in, const std::vector<P>& tau, const DirectrixEquation<S>& equation,
                      Equations<S>& equations) {
  equations.equal(derivative(in.c, in.u), along(equation.a(in.u), equation.b(in.u), tau, in.u));
}

}  // namespace torse::proofs::zw06
