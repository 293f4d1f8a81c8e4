// The functions of FJ21 at one parameter t: Lam, M, sigma of Theorem 3.1, and lambda, mu, nu of the decomposition 4.3.
//   BlossomFunctions      p[t^<n-1>, Lam] = sigma q[t^<n-1>, M]
//   FrameFunctions        p' = lambda W + mu W' + nu p,  W = q - p
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

/// lambda, mu, nu at one parameter (FJ21.4.3).
template <Field S>
struct FrameFunctions {
  S lambda;
  S mu;
  S nu;
};

/// Lam = (n (mu+1) + (lambda-nu) t) / (lambda-nu), M = (lambda t + n mu) / lambda, sigma = lambda / (lambda-nu) (FJ21.C4.1).
/// Throws DivisionByZero (exact fields) for lambda = 0, where M is at infinity, and lambda = nu, where Lam is.
template <Field S>
BlossomFunctions<S> to_blossom(int degree, const S& t, const FrameFunctions<S>& frame) {
  const S n = from_int<S>(degree);
  const S den = frame.lambda - frame.nu;
  return {(n * (frame.mu + from_int<S>(1)) + den * t) / den, (frame.lambda * t + n * frame.mu) / frame.lambda,
          frame.lambda / den};
}

/// lambda = n sigma / E, mu = sigma (M-t) / E, nu = n (sigma-1) / E with E = Lam - sigma M + t (sigma-1) (FJ21.C4.1).
/// Throws DivisionByZero (exact fields) for E = 0: W and the blossom's point are parallel, a cylinder's or cone's ruling.
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

/// The frame of f p, f q from that of p, q: lambda - mu f'/f, mu, nu + f'/f (FJ21.4.3). `f` and `df` are the values of f
/// and f' at the parameter.
template <Field S>
FrameFunctions<S> gauged(const FrameFunctions<S>& frame, const S& f, const S& df) {
  const S rate = df / f;
  return {frame.lambda - frame.mu * rate, frame.mu, frame.nu + rate};
}

}  // namespace torse
