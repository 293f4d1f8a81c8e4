// The functions of FJ21 at one parameter t: Lam, M, sigma of Theorem 3.1, and lambda, mu, nu of the decomposition 4.3.
//   BlossomFunctions      p[t^<n-1>, Lam] = sigma q[t^<n-1>, M]
//   FrameFunctions        p' = lambda W + mu W' + nu p,  W = q - p
//   from_dependence       3.3, Lam, M, sigma from the coefficients of a linear dependence
//   to_blossom, to_frame  Corollary 4.1 in both directions
//   scaled_weights        FJ21.W      gauged    4.3 under a common factor f
#pragma once

#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// Lam, M, sigma at one parameter (FJ21.T3.1).
template <Field S>
struct BlossomFunctions {
  S lambda;
  S m;
  S sigma;
};

/// Lam = l_1/(l_0+l_1), M = m_1/(m_0+m_1), sigma = (m_0+m_1)/(l_0+l_1) from l_0 p_0 + l_1 p_1 = m_0 q_0 + m_1 q_1
/// (FJ21.3.3). Throws InvalidInput naming "Lambda" for l_0 + l_1 = 0 and "M" for m_0 + m_1 = 0: there the point of
/// dependence is the derivative p' or q', at the infinite parameter, and no Lam or M exists.
template <Field S>
BlossomFunctions<S> from_dependence(const S& l0, const S& l1, const S& m0, const S& m1) {
  const S l = l0 + l1;
  const S m = m0 + m1;
  if (definitely(is_zero(l))) throw InvalidInput("Lambda", "is infinite: the dependence has lambda_0 + lambda_1 = 0");
  if (definitely(is_zero(m))) throw InvalidInput("M", "is infinite: the dependence has mu_0 + mu_1 = 0");
  return {l1 / l, m1 / m, m / l};
}

/// lambda, mu, nu at one parameter (FJ21.4.3).
template <Field S>
struct FrameFunctions {
  S lambda;
  S mu;
  S nu;
};

/// Lam = (n (mu+1) + (lambda-nu) t) / (lambda-nu), M = (lambda t + n mu) / lambda, sigma = lambda / (lambda-nu)
/// (FJ21.C4.1). Throws DivisionByZero (exact fields) for lambda = 0, where M is at infinity, and lambda = nu, where Lam
/// is.
template <Field S>
BlossomFunctions<S> to_blossom(int degree, const S& t, const FrameFunctions<S>& frame) {
  const S n = from_int<S>(degree);
  const S den = frame.lambda - frame.nu;
  return {(n * (frame.mu + from_int<S>(1)) + den * t) / den, (frame.lambda * t + n * frame.mu) / frame.lambda,
          frame.lambda / den};
}

/// lambda = n sigma / E, mu = sigma (M-t) / E, nu = n (sigma-1) / E with E = Lam - sigma M + t (sigma-1) (FJ21.C4.1).
/// Throws DivisionByZero (exact fields) for E = 0: W and the blossom's point are parallel, a cylinder's or cone's
/// ruling.
template <Field S>
FrameFunctions<S> to_frame(int degree, const S& t, const BlossomFunctions<S>& blossom) {
  const S n = from_int<S>(degree);
  const S one = from_int<S>(1);
  const S e = blossom.lambda - blossom.sigma * blossom.m + t * (blossom.sigma - one);
  return {n * blossom.sigma / e, blossom.sigma * (blossom.m - t) / e, n * (blossom.sigma - one) / e};
}

/// Weights of p times alpha, of q times beta: Lam and M stay, sigma becomes alpha sigma / beta (FJ21.W).
template <Field S>
BlossomFunctions<S> scaled_weights(const BlossomFunctions<S>& f, const S& alpha, const S& beta) {
  return {f.lambda, f.m, alpha * f.sigma / beta};
}

/// The frame of f p, f q from that of p, q: lambda - mu f'/f, mu, nu + f'/f (FJ21.4.3). `f` and `df` are the values of
/// f and f' at the parameter.
template <Field S>
FrameFunctions<S> gauged(const FrameFunctions<S>& frame, const S& f, const S& df) {
  const S rate = df / f;
  return {frame.lambda - frame.mu * rate, frame.mu, frame.nu + rate};
}

}  // namespace torse
