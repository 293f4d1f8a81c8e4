// ZW06, section 2 and case 1: linear dependence and cylinders, equations (5) and (6).
//   Eq5, Eq6
#pragma once

#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/claims/zw06/common.hpp"

namespace torse::proofs::zw06 {

/// ZW06.5: developable iff a', tau, tau' are dependent.
struct Eq5 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.5",
        .source = "equation (5)",
        .title = "developable iff a', tau, tau' are dependent",
        .statement = R"([d',c',d-c]=[a',\tau,\tau']=:\Delta;\ x=\lambda a'+\mu\tau+\gamma\tau'\Rightarrow
\lambda\Delta=[x,\tau,\tau'],\ \mu\Delta=[a',x,\tau'],\ \gamma\Delta=[a',\tau,x];\quad
[\tau,\tau',w]a'+[\tau',a',w]\tau+[a',\tau,w]\tau'=\Delta w\ \text{for every }w)",
        .kind = Kind::equivalence,
        .hypotheses = {},
        .mutants = {"a in the place of a'", "the sign of [tau', a', w]", "lambda and mu exchanged"},
        .max_pieces = 1,
        .remark =
            "x = 0 with lambda, mu, gamma not all zero gives Delta = 0; Delta = 0 gives the coefficients [tau,tau',w], "
            "[tau',a',w], [a',tau,w], not all zero for some w unless the three vectors are parallel, where there is a "
            "dependence anyway."};
    return info;
  }

  template <class S, class P>
  struct In {
    S u;
    S lambda, mu, gamma;
    P w;
    std::vector<P> c_taylor;
    std::vector<P> tau_taylor;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    S u = from.scalar();
    S lambda = from.scalar();
    S mu = from.scalar();
    S gamma = from.scalar();
    P w = from.template point<P>();
    std::vector<P> c = from.template points<P>(size.n + 1);
    return {std::move(u),
            std::move(lambda),
            std::move(mu),
            std::move(gamma),
            std::move(w),
            std::move(c),
            from.template points<P>(size.n + 1)};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    const KnotList<S> knots = bezier_knots<S>(degree_of(in.c_taylor));
    const std::vector<P> c = fj07::taylor_net(knots, 1, in.u, in.c_taylor);
    const std::vector<P> d = second_row(c, fj07::taylor_net(knots, 1, in.u, in.tau_taylor));
    const P& speed = in.c_taylor[mutant.is(1) ? 0 : 1];
    const P& tau = in.tau_taylor[0];
    const P& turn = in.tau_taylor[1];
    const S det = pointwise_determinant<S>(knots, c, d, 1, in.u);
    equations.equal(det, det3<S>(speed, tau, turn));

    P x = combine(mutant.is(3) ? in.mu : in.lambda, speed, mutant.is(3) ? in.lambda : in.mu, tau);
    add_scaled(x, in.gamma, turn);
    equations.equal(in.lambda * det, det3<S>(x, tau, turn));
    equations.equal(in.mu * det, det3<S>(speed, x, turn));
    equations.equal(in.gamma * det, det3<S>(speed, tau, x));

    const S middle = det3<S>(turn, speed, in.w);
    P dependence = combine(det3<S>(tau, turn, in.w), speed, mutant.is(2) ? -middle : middle, tau);
    add_scaled(dependence, det3<S>(speed, tau, in.w), turn);
    equations.equal(dependence, scaled(det, in.w));
  }
};

/// ZW06.6: parallel rulings are the case mu tau + gamma tau' = 0.
struct Eq6 {
  static constexpr PointKind points = PointKind::coplanar;
  static constexpr int dimension = 3;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "ZW06.6",
        .source = "case 1, equation (6)",
        .title = "cylinders",
        .statement = R"(q_i-p_i=h_ie\Rightarrow h\tau'-h'\tau=0,\ h=\sum_iB_i^nh_i,\ \tau=he,
\text{ and the surface is developable; with }h_{i+1}=\sigma h_i:\ \tau(u)=(1-u+\sigma u)^n(q_0-p_0).)",
        .kind = Kind::identity,
        .hypotheses = {},
        .mutants = {"the last ruling along another direction", "h tau' + h' tau", "the lengths in reverse order"},
        .max_pieces = 1,
        .remark =
            "The paper divides by |tau| and by |q_0 - p_0|, which may vanish; its conclusion holds all the same: for "
            "polynomials, "
            "tau x tau' = 0 makes the quotient of any two coordinates of tau constant. Splines may turn where tau "
            "vanishes, see FJ07.4."};
    return info;
  }

  template <class S, class P>
  struct In {
    std::vector<P> c;
    P e;
    std::vector<S> lengths;
    S sigma;
    S u;
  };

  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    std::vector<P> c = from.template points<P>(size.n + 1);
    P e = from.template point<P>();
    std::vector<S> lengths;
    for (int i = 0; i <= size.n; ++i) lengths.push_back(from.scalar());
    S sigma = from.scalar();
    return {std::move(c), std::move(e), std::move(lengths), std::move(sigma), from.scalar()};
  }
  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>& in, Mutant mutant, Equations<S>& equations) {
    std::vector<P> d = cylinder_net<S, P>(in.c, in.e, in.lengths);
    if (mutant.is(1)) add(d.back(), in.c.front());
    const std::vector<S> reversed(in.lengths.rbegin(), in.lengths.rend());
    const Bernstein<S> h(mutant.is(3) ? reversed : in.lengths);
    const std::vector<P> tau = rulings_of(in.c, d);
    equations.equal(value(tau, in.u), scaled(h(in.u), in.e));
    const S slope = h.derivative()(in.u);
    equations.equal(along(mutant.is(2) ? slope : -slope, h(in.u), tau, in.u), PointTraits<P>::zero());
    fj07::require_coplanar<S, P>(bezier_knots<S>(degree_of(in.c)), in.c, d, in.u, equations);

    const S one = from_int<S>(1);
    std::vector<S> geometric{one};
    S power = one;
    for (std::size_t i = 1; i < in.c.size(); ++i) {
      geometric.push_back(geometric.back() * in.sigma);
      power *= one - in.u + in.sigma * in.u;
    }
    const std::vector<P> row = cylinder_net<S, P>(in.c, in.e, geometric);
    equations.equal(value(rulings_of(in.c, row), in.u), scaled(power, in.e));
  }
};

}  // namespace torse::proofs::zw06
