// What the claims of FJ21 share: two Bezier rows p, q of degree n on [0, 1] and functions at a parameter. Most
// statements of the paper say how the blossom relation changes under an operation. They are claimed in a stronger form,
// for any two rows: the defect p[t^<n-1>, Lam] - sigma q[t^<n-1>, M] after the operation is a multiple of the defect
// before it.
//   degree_of, tangent      the degree of a Bezier row; rows[t^<n-1>, x]
//   defect, frame_defect    of T3.1 and of 4.3: zero iff the relation holds at t
//   bernstein_sum           sum_i C(n,i) (1-t)^{n-i} t^i p_i     hodograph    n (p_{i+1} - p_i)
//   PairInput, WeightedInput, LocalInput, draw_functions
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/developable/functions.hpp"
#include "torse/proofs/claim.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::proofs::fj21 {

template <class P>
int degree_of(const std::vector<P>& rows) {
  return static_cast<int>(rows.size()) - 1;
}

/// rows[t^<n-1>, x] on [0, 1].
template <class P, class S>
P tangent(const std::vector<P>& rows, const S& t, const S& x) {
  return tangent_point<S, P>(bezier_knots<S>(degree_of(rows)), rows, 1, t, at(x));
}

/// The curve and its derivative at t.
template <class P, class S>
P value(const std::vector<P>& rows, const S& t) {
  return curve_point<S, P>(bezier_knots<S>(degree_of(rows)), rows, 1, t);
}
template <class P, class S>
P derivative(const std::vector<P>& rows, const S& t) {
  return curve_derivative<S, P>(bezier_knots<S>(degree_of(rows)), rows, 1, t);
}

/// p[t^<n-1>, Lam] - sigma q[t^<n-1>, M].
template <class P, class S>
P defect(const std::vector<P>& p, const std::vector<P>& q, const S& t, const BlossomFunctions<S>& f) {
  P x = tangent(p, t, f.lambda);
  add_scaled(x, -f.sigma, tangent(q, t, f.m));
  return x;
}

/// p' - lambda (q-p) - mu (q'-p') - nu p at t.
template <class P, class S>
P frame_defect(const std::vector<P>& p, const std::vector<P>& q, const S& t, const FrameFunctions<S>& f) {
  P x = scaled(from_int<S>(1) + f.mu, derivative(p, t));
  add_scaled(x, -f.mu, derivative(q, t));
  add_scaled(x, f.lambda - f.nu, value(p, t));
  add_scaled(x, -f.lambda, value(q, t));
  return x;
}

/// sum_i C(n,i) (1-t)^{n-i} t^i p_i: the curve without de Boor's algorithm.
template <class P, class S>
P bernstein_sum(const std::vector<P>& rows, const S& t) {
  const int n = degree_of(rows);
  const S s = from_int<S>(1) - t;
  P total = PointTraits<P>::zero();
  for (int i = 0; i <= n; ++i) {
    S weight = binomial<S>(n, i);
    for (int j = 0; j < n; ++j) weight *= j < i ? t : s;
    add_scaled(total, weight, rows[static_cast<std::size_t>(i)]);
  }
  return total;
}

/// The Bezier rows of the derivative, n (p_{i+1} - p_i).
template <class S, class P>
std::vector<P> hodograph(const std::vector<P>& rows) {
  std::vector<P> result;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    result.push_back(scaled(from_int<S>(degree_of(rows)), difference(rows[i + 1], rows[i])));
  }
  return result;
}

/// Lam, M, sigma at one parameter: any values.
template <class S>
BlossomFunctions<S> draw_functions(Source<S>& from) {
  S lambda = from.scalar();
  S m = from.scalar();
  return {std::move(lambda), std::move(m), from.scalar()};
}

/// Two rows of degree n, a parameter t, and Lam, M, sigma there.
template <class S, class P>
struct PairInput {
  std::vector<P> p;
  std::vector<P> q;
  S t;
  BlossomFunctions<S> f;

  static PairInput draw(Source<S>& from, Size size);
};

template <class S, class P>
PairInput<S, P> PairInput<S, P>::draw(Source<S>& from, Size size) {
  std::vector<P> p = from.template points<P>(size.n + 1);
  std::vector<P> q = from.template points<P>(size.n + 1);
  S t = from.scalar();
  return {std::move(p), std::move(q), std::move(t), draw_functions(from)};
}

/// The pair of degree one with the given Lam, M, sigma at t and rows from the integers of `entries`: for stored
/// failures.
template <class S, class P>
PairInput<S, P> line_pair(const S& t, const BlossomFunctions<S>& f) {
  PairInput<S, P> in{{}, {}, t, f};
  for (int i = 0; i < 2; ++i) {
    P x = PointTraits<P>::zero();
    P y = PointTraits<P>::zero();
    if constexpr (requires { P::generator(0); }) {
      x = P::generator(i);
      y = P::generator(i + 2);
    } else {
      for (int j = 0; j < static_cast<int>(x.size()); ++j) {
        x[j] = from_int<S>(1 + i * (j + 2));
        y[j] = from_int<S>(2 + j + 3 * i * i - i * j * j);
      }
    }
    in.p.push_back(std::move(x));
    in.q.push_back(std::move(y));
  }
  return in;
}

/// A rational curve by its affine points c_i and weights w_i.
template <class S, class P>
struct WeightedInput {
  std::vector<S> w;
  std::vector<P> c;

  /// The spatial part w_i c_i of the homogeneous rows.
  std::vector<P> rows() const {
    std::vector<P> result;
    for (std::size_t i = 0; i < c.size(); ++i) result.push_back(scaled(w[i], c[i]));
    return result;
  }
  /// Their weights.
  std::vector<Vec<S, 1>> weights() const {
    std::vector<Vec<S, 1>> result;
    for (const S& weight : w) result.push_back(Vec<S, 1>::Constant(weight));
    return result;
  }
};

template <class S, class P>
WeightedInput<S, P> draw_weighted(Source<S>& from, Size size) {
  WeightedInput<S, P> curve;
  for (int i = 0; i <= size.n; ++i) curve.w.push_back(from.scalar());
  curve.c = from.template points<P>(size.n + 1);
  return curve;
}

/// The rows on [0, 1] of the curve whose Bezier rows on [t, t+1] are given. Every curve comes from some `local` rows,
/// and those at 0 and 1 alone decide its point and tangent at t: what is claimed at t stays small for symbolic
/// arithmetic.
template <class S, class P>
std::vector<P> from_local(const std::vector<P>& local, const S& t) {
  const KnotList<S> u = bezier_knots(degree_of(local), t, t + from_int<S>(1));
  return restricted_points<S, P>(u, local, 1, from_int<S>(0), from_int<S>(1));
}

/// Two rows of degree n drawn by their local rows at t.
template <class S, class P>
struct LocalInput {
  std::vector<P> p;
  std::vector<P> q;
  S t;

  static LocalInput draw(Source<S>& from, Size size);
};

template <class S, class P>
LocalInput<S, P> LocalInput<S, P>::draw(Source<S>& from, Size size) {
  const std::vector<P> p = from.template points<P>(size.n + 1);
  const std::vector<P> q = from.template points<P>(size.n + 1);
  S t = from.scalar();
  std::vector<P> p_rows = from_local(p, t);
  return {std::move(p_rows), from_local(q, t), std::move(t)};
}

}  // namespace torse::proofs::fj21
