// Degree elevation by factors and the change of the rulings' length, FJ21.5.3-4.
//   Linear               a factor f(t) = f_0 + f_1 t of degree one
//   times_linear         the Bezier rows of f p
//   unelevated           5.3 as printed: Lam, M, sigma of p, q from those of f p, g q
//   elevated_functions   its inverse
//   unshortened          5.4 as printed: Lam, M, sigma of p, q from those of f p, f p + g (q-p)
//   shortened_functions  its inverse
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/developable/functions.hpp"

namespace torse {

/// f(t) = constant + slope t.
template <Field S>
struct Linear {
  S constant;
  S slope;

  S operator()(const S& t) const { return constant + slope * t; }
};

/// The n + 2 Bezier rows on [0, 1] of f(t) p(t): ((n+1-i) f(0) p_i + i f(1) p_{i-1}) / (n+1).
template <Field S, Point<S> P>
std::vector<P> times_linear(const std::vector<P>& rows, const Linear<S>& f) {
  const int n = static_cast<int>(rows.size()) - 1;
  const S at0 = f.constant;
  const S at1 = f.constant + f.slope;
  std::vector<P> result;
  for (int i = 0; i <= n + 1; ++i) {
    P row = PointTraits<P>::zero();
    if (i <= n) add_scaled(row, from_int<S>(n + 1 - i) * at0, rows[static_cast<std::size_t>(i)]);
    if (i > 0) add_scaled(row, from_int<S>(i) * at1, rows[static_cast<std::size_t>(i) - 1]);
    divide(row, from_int<S>(n + 1));
    result.push_back(std::move(row));
  }
  return result;
}

/// FJ21.5.3: Lam = (n f(t) Lam~ + f(Lam~) t) / (n f(t) + f(Lam~)), M likewise with g, and
/// sigma = (n g(t) + g(M~)) / (n f(t) + f(Lam~)) sigma~. n is the degree before elevation.
template <Field S>
BlossomFunctions<S> unelevated(int degree, const S& t, const BlossomFunctions<S>& e, const Linear<S>& f,
                               const Linear<S>& g) {
  const S n = from_int<S>(degree);
  const S at_lambda = n * f(t) + f(e.lambda);
  const S at_m = n * g(t) + g(e.m);
  return {(n * f(t) * e.lambda + f(e.lambda) * t) / at_lambda, (n * g(t) * e.m + g(e.m) * t) / at_m,
          at_m / at_lambda * e.sigma};
}

/// The inverse of FJ21.5.3, which is linear in Lam~ because f is: with f = f_0 + f_1 t,
/// Lam~ = (Lam (n f(t) + f_0) - f_0 t) / (n f(t) + f_1 (t - Lam)); M~ likewise. For f = g = 1: ((n+1) Lam - t)/n.
template <Field S>
BlossomFunctions<S> elevated_functions(int degree, const S& t, const BlossomFunctions<S>& b, const Linear<S>& f,
                                       const Linear<S>& g) {
  const S n = from_int<S>(degree);
  const auto invert = [&](const S& x, const Linear<S>& h) {
    return (x * (n * h(t) + h.constant) - h.constant * t) / (n * h(t) + h.slope * (t - x));
  };
  const S lambda = invert(b.lambda, f);
  const S m = invert(b.m, g);
  return {lambda, m, b.sigma * (n * f(t) + f(lambda)) / (n * g(t) + g(m))};
}

/// FJ21.5.4 for p~ = f p, q~ = f p + g (q-p): with G = n g(t) + g(M~) and
/// H = f(Lam~) + n f(t) + sigma~ (g(M~) - f(M~) + n (g(t)-f(t))),
/// Lam = (f(Lam~) t + n f(t) Lam~ + sigma~ (n M~ (g(t)-f(t)) + t (g(M~)-f(M~)))) / H, M = (g(M~) t + n g(t) M~) / G,
/// sigma = sigma~ G / H. n is the degree of p and q.
template <Field S>
BlossomFunctions<S> unshortened(int degree, const S& t, const BlossomFunctions<S>& e, const Linear<S>& f,
                                const Linear<S>& g) {
  const S n = from_int<S>(degree);
  const S at_m = n * g(t) + g(e.m);
  const S h = f(e.lambda) + n * f(t) + e.sigma * (g(e.m) - f(e.m) + n * (g(t) - f(t)));
  const S numerator =
      f(e.lambda) * t + n * f(t) * e.lambda + e.sigma * (n * e.m * (g(t) - f(t)) + t * (g(e.m) - f(e.m)));
  return {numerator / h, (g(e.m) * t + n * g(t) * e.m) / at_m, e.sigma * at_m / h};
}

/// The inverse of FJ21.5.4. With F = f(t), G = g(t), the slopes f_1, g_1, L = Lam - t, K = M - t and
/// Q = G^2 (n F - f_1 L) + sigma (F^2 (n G - g_1 K) - G^2 (n F - f_1 K)):
/// Lam~ = t + (n+1) F G (G L + sigma K (F-G)) / Q, M~ = t + (n+1) G K / (n G - g_1 K), sigma~ = sigma F^2 (n G - g_1 K)
/// / Q. Throws DivisionByZero (exact fields) where Lam~ or M~ is at infinity.
template <Field S>
BlossomFunctions<S> shortened_functions(int degree, const S& t, const BlossomFunctions<S>& b, const Linear<S>& f,
                                        const Linear<S>& g) {
  const S n = from_int<S>(degree);
  const S over = from_int<S>(degree + 1);
  const S left = b.lambda - t;
  const S right = b.m - t;
  const S ft = f(t);
  const S gt = g(t);
  const S at_m = n * gt - g.slope * right;
  const S q = gt * gt * (n * ft - f.slope * left) + b.sigma * (ft * ft * at_m - gt * gt * (n * ft - f.slope * right));
  return {t + over * ft * gt * (gt * left + b.sigma * right * (ft - gt)) / q, t + over * gt * right / at_m,
          b.sigma * ft * ft * at_m / q};
}

}  // namespace torse
