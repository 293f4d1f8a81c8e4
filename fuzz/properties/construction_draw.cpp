#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"
#include "torse/fuzz/properties/construction.hpp"

namespace torse::fuzz {
namespace {

/// The Bernstein coefficients on [0, 1] of a polynomial: the control points over the Bezier knots of that degree.
plain::Poly bernstein(const plain::Poly& f, int degree) {
  const plain::Pieces<1> curve{{Rational(0), Rational(1)}, {{f}}};
  plain::Poly coefficients;
  for (const auto& x : plain::control_row<1>(curve, bezier_knots<Rational>(degree))) coefficients.push_back(x[0]);
  return coefficients;
}

plain::Poly integral(const plain::Poly& f, const Rational& start) {
  plain::Poly g{start};
  for (std::size_t i = 0; i < f.size(); ++i) g.push_back(f[i] / Rational(i + 1));
  return g;
}

plain::Poly draw_polynomial(Choices& choices, const Scale& scale, int degree) {
  plain::Poly f;
  for (int i = 0; i <= degree; ++i) f.push_back(draw_number(choices, scale));
  return f;
}

/// A curve with c' = a tau + b tau' for polynomials that are drawn: the directrix of a surface that exists.
void draw_directrix(Choices& choices, const Scale& scale, ConstructionInput& in) {
  const plain::Poly a = draw_polynomial(choices, scale, choices.between(0, 1));
  plain::Poly b = draw_polynomial(choices, scale, choices.between(1, 2));
  b.front() = draw_nonzero(choices, scale);
  const int tau_degree = choices.between(1, std::max(1, scale.degree - 1));
  plain::PolyRow<4> c;
  for (plain::Poly& f : c) {
    const plain::Poly tau = draw_polynomial(choices, scale, tau_degree);
    f = integral(plain::plus(plain::times(a, tau), plain::times(b, plain::derivative(tau))),
                 draw_number(choices, scale));
  }
  std::size_t size = 2;
  for (const plain::Poly& f : c) size = std::max(size, f.size());
  in.knots = bezier_knots<Rational>(static_cast<int>(size) - 1);
  in.p = plain::control_row<4>({{Rational(0), Rational(1)}, {c}}, in.knots);
  in.polynomial_a = bernstein(a, std::max(1, static_cast<int>(a.size()) - 1));
  in.polynomial_b = bernstein(b, static_cast<int>(b.size()) - 1);
}

/// A clamped curve and the end rulings of a net through it, each times a number.
void draw_ends(Choices& choices, const Scale& scale, ConstructionInput& in) {
  if (in.knots.clamped() != Truth::yes) in.knots = bezier_knots<Rational>(in.knots.degree());
  const KnotList<Rational>& u = in.knots;
  in.p = draw_rows(choices, scale, u.last() + 1, Weights::one);
  in.functions.m = draw_off_knots(choices, scale, u);
  in.functions.lambda = draw_parameter(choices, scale, u);
  if (in.functions.lambda == in.functions.m) in.functions.lambda += Rational(1);
  in.functions.sigma = Rational(1);
  const std::vector<Row4> q = cell_row(u, in.p, in.functions, draw_rows(choices, scale, 1, Weights::one).front());
  in.q0 = blend(in.a, q.front(), -in.a, in.p.front());
  in.end = blend(in.b, q.back(), -in.b, in.p.back());
  const auto minor = [&](int i, int j) { return in.q0[i] * in.end[j] - in.q0[j] * in.end[i]; };
  if (minor(1, 2).sign() == 0 && minor(1, 3).sign() == 0 && minor(2, 3).sign() == 0) {
    throw Discard("the end rulings are parallel");
  }
}

}  // namespace

ConstructionInput draw_construction(Choices& choices, const Scale& scale, std::string_view method) {
  ConstructionInput in{.method = std::string(method), .knots = draw_knots(choices, scale)};
  in.a = draw_nonzero(choices, scale);
  if (in.a == Rational(1)) in.a = Rational(2);
  in.b = draw_nonzero(choices, scale);
  if (method == "directrix") {
    draw_directrix(choices, scale, in);
    return in;
  }
  if (method == "interpolate") {
    draw_ends(choices, scale, in);
    return in;
  }
  in.functions = draw_functions(choices, scale, in.knots, true);
  const bool on_unit_interval = method == "moebius" || method == "factors";
  if (on_unit_interval && (in.functions.m.sign() == 0 || in.functions.m == Rational(1))) in.functions.m = Rational(-2);
  const Weights weights = choices.once_in(2) ? Weights::any : Weights::one;
  in.p = draw_rows(choices, scale, in.knots.last() + 1, weights);
  in.q0 = draw_rows(choices, scale, 1, weights).front();
  for (std::size_t i = 0; i < in.p.size(); ++i) in.lengths.push_back(draw_number(choices, scale));
  return in;
}

}  // namespace torse::fuzz
