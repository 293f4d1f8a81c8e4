// FJ07, section 4: interpolation between a clamped curve and two skew end rulings, equations (20) and (21).
//   Eq20, Eq21
#pragma once

#include <vector>

#include "torse/developable/interpolation.hpp"
#include "torse/proofs/claims/fj07/common.hpp"
#include "torse/proofs/claims/fj07/linear_net.hpp"

namespace torse::proofs::fj07 {

/// FJ07.20: the last ruling by a(M*), and the polynomial whose roots are the branches.
struct Eq20 : ClosedForm {
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.20",
        .source = "equation (20)",
        .title = "the last ruling by a(M*)",
        .statement = R"($d_L-c_L=P(0,L)(d_0-c_0)+\frac{\Lambda^*-M^*}{M^*-u_{L-1}}(c_L-a(M^*))$, and
$(c_L-a(M))\prod_{j<L-1}(M-u_j)=\sum_{i=0}^{L-1}(c_{i+1}-c_i)\prod_{j<i}(M-u_j)\prod_{i<j<L}(M-u_{j+n})$ is a polynomial
of degree $L-1$ in $M$.)",
        .kind = Kind::identity,
        .hypotheses = {off_before_last, off_from_last},
        .mutants = {"M*-L* in the place of L*-M*", "c_0 without (M-u_{L-1})/(M-u_0)", "a for the vertex before"}};
    return value;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, d0, lambda, m] = in;
    const int last = u.last();
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m, d0);
    P a = eq20<S, P>(u, c, m, mutant.is(3) && last > 1 ? last - 1 : last);
    if (mutant.is(2)) {
      const S missing = from_int<S>(1) - (m - u[last - 1]) / (m - u[0]);
      add_scaled(a, missing * product_p(u, m, 1, last), c.front());
    }
    const P chord = difference(c.back(), a);
    const S factor = (mutant.is(1) ? m - lambda : lambda - m) / (m - u[last - 1]);
    equations.equal(difference(d.back(), c.back()),
                    combine(product_p(u, m, 0, last), difference(d0, c.front()), factor, chord));

    P value = PointTraits<P>::zero();
    const std::vector<P> coefficients = chord_polynomial<S, P>(u, c);
    for (auto coefficient = coefficients.rbegin(); coefficient != coefficients.rend(); ++coefficient) {
      value = combine(m, value, from_int<S>(1), *coefficient);
    }
    S cleared = from_int<S>(1);
    for (int j = 0; j < last - 1; ++j) cleared *= m - u[j];
    equations.equal(value, scaled(cleared, chord));
  }
};

/// FJ07.21: the ends of the rulings of a branch.
struct Eq21 {
  static constexpr PointKind points = PointKind::linear;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo value{
        .id = "FJ07.21",
        .source = "equation (21) and the system before it",
        .title = "interpolation between two skew end rulings",
        .statement = R"(Let $c$ be clamped on $[a,b]$ and $a(M_0)-c_L=\alpha v+\beta w$. With
$\sigma_0=\alpha\frac{\Lambda^*-M_0}{M_0-u_{L-1}}\prod\frac{M_0-u_i}{M_0-u_{i+n}}$,
$\tau_0=\beta\frac{M_0-\Lambda^*}{M_0-u_{L-1}}$ the net of (13) from $d_0=c_0+\sigma_0v$ has $d(a)-c(a)=\sigma_0v$ and
$d(b)-c(b)=\tau_0w$, so its end rulings lie along $v$ and $w$; and $\alpha,\beta$ are the quotients of determinants with
$n=v\times w$.)",
        .kind = Kind::identity,
        .hypotheses = {{"M_0 is none of the knots: the formulas divide by M_0-u_i and M_0-u_{i+n}", false},
                       {"v and w are not parallel", true},
                       {"alpha is not 0: else the first ruling shrinks to c_0", false},
                       {"beta is not 0: else the last ruling shrinks to c_L", false},
                       {"L* is not M_0: else both rulings shrink", false}},
        .mutants = {"sigma_0 and tau_0 exchanged", "the sign of tau_0", "alpha and beta exchanged",
                    "the product inverted"},
        .remark =
            "M_0 is a root of a polynomial of degree L-1, so there may be no real branch or several; a root at a "
            "knot is none. The line of a ruling that has shrunk to a point is lost."};
    return value;
  }

  template <class S, class P>
  struct In {
    KnotList<S> u;
    std::vector<P> c;
    P v;
    P w;
    ChordCoordinates<S> chord;
    S m0;
    S lambda;
    Vec<S, 3> first;  ///< v and w again, by coordinates
    Vec<S, 3> second;
    Vec<S, 3> along;  ///< alpha v + beta w
  };

  /// c_L completed such that a(M_0) - c_L = alpha v + beta w. A knot M_0, which the hypotheses exclude, leaves c_L =
  /// c_0.
  template <class S, class P>
  static In<S, P> make(KnotList<S> u, std::vector<P> c, P v, P w, ChordCoordinates<S> chord, S m0, S lambda,
                       Vec<S, 3> first, Vec<S, 3> second) {
    bool off = true;
    for (const S& x : off_knots(u, m0)) off = off && !definitely(is_zero(x));
    P last = off ? eq20<S, P>(u, c, m0, u.last()) : c.front();
    add_scaled(last, -chord.alpha, v);
    add_scaled(last, -chord.beta, w);
    c.push_back(std::move(last));
    Vec<S, 3> along = combine(chord.alpha, first, chord.beta, second);
    return {std::move(u),  std::move(c),      std::move(v),     std::move(w),      std::move(chord),
            std::move(m0), std::move(lambda), std::move(first), std::move(second), std::move(along)};
  }

  /// n-fold ends around the inner knots of a drawn list.
  template <class S>
  static KnotList<S> draw_clamped(Source<S>& from, Size size) {
    const std::vector<S> inner = from.knots(size);
    const std::size_t n = static_cast<std::size_t>(size.n);
    const std::size_t last = static_cast<std::size_t>(size.last());
    std::vector<S> u(n, inner[n - 1] - from.positive());
    u.insert(u.end(), inner.begin() + size.n, inner.begin() + size.last());
    u.insert(u.end(), n, inner[last] + from.positive());
    return KnotList<S>(size.n, std::move(u));
  }

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    KnotList<S> u = draw_clamped(from, size);
    std::vector<P> c = from.template points<P>(size.last());
    P v = from.template point<P>();
    P w = from.template point<P>();
    S alpha = from.scalar();
    S beta = from.scalar();
    S m0 = from.scalar();
    S lambda = from.scalar();
    Vec<S, 3> first = from.template point<Vec<S, 3>>();
    Vec<S, 3> second = from.template point<Vec<S, 3>>();
    return make<S, P>(std::move(u), std::move(c), std::move(v), std::move(w), {std::move(alpha), std::move(beta)},
                      std::move(m0), std::move(lambda), std::move(first), std::move(second));
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>& in) {
    const Vec<S, 3> normal = cross<S>(in.first, in.second);
    return {off_knots(in.u, in.m0), {dot<S>(normal, normal)}, {in.chord.alpha}, {in.chord.beta}, {in.lambda - in.m0}};
  }

  template <class S, class P>
  static std::vector<Failure<In<S, P>>> failures() {
    std::vector<Failure<In<S, P>>> list;
    const std::vector<Vec<S, 3>> frame = example_points<S, Vec<S, 3>>(2, 1);
    const auto with = [&](std::size_t hypothesis, int alpha, int beta, int m0, const Vec<S, 3>& second) {
      const std::vector<P> points = example_points<S, P>(4);
      list.push_back({hypothesis, make<S, P>(example_knots<S>(2, {0, 0, 1, 1}), {points[0], points[1]}, points[2],
                                             points[3], {from_int<S>(alpha), from_int<S>(beta)}, from_int<S>(m0),
                                             from_int<S>(7), frame[0], second)});
    };
    with(0, 2, 3, 1, frame[1]);
    with(1, 2, 3, 5, frame[0]);
    with(2, 0, 3, 5, frame[1]);
    with(3, 2, 0, 5, frame[1]);
    with(4, 2, 3, 7, frame[1]);
    return list;
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const auto& [u, c, v, w, chord, m0, lambda, first, second, along] = in;
    ChordCoordinates<S> found = chord_coordinates<S>(along, first, second);
    if (mutant.is(3)) std::swap(found.alpha, found.beta);
    equations.equal(found.alpha, chord.alpha);
    equations.equal(found.beta, chord.beta);

    EndRulings<S> ends = end_rulings<S>(u, chord, m0, lambda);
    if (mutant.is(1)) std::swap(ends.sigma0, ends.tau0);
    if (mutant.is(2)) ends.tau0 = -ends.tau0;
    if (mutant.is(4)) {
      const S product = product_p(u, m0, 0, u.last());
      ends.sigma0 *= product * product;
    }
    const std::vector<P> d = linear_net<S, P>(u, c, lambda, m0, combine(from_int<S>(1), c.front(), ends.sigma0, v));
    const auto ruling = [&in, &d](int k, const S& t) {
      return difference(curve_point<S, P>(in.u, d, k, t), curve_point<S, P>(in.u, in.c, k, t));
    };
    P at_begin = ruling(1, u.domain_begin());
    P at_end = ruling(u.pieces(), u.domain_end());
    divide(at_begin, ends.sigma0);
    divide(at_end, ends.tau0);
    equations.equal(at_begin, v);
    equations.equal(at_end, w);
  }
};

}  // namespace torse::proofs::fj07
