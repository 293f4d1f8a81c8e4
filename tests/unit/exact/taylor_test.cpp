// Single steps of the development against closed forms, to all their digits: a plate is rounded, so that it would not
// tell of an enclosure that is too narrow.
#include "torse/exact/unroll/taylor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "torse/exact/unroll/arb_types.hpp"
#include "torse/spline/blossom.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse {
namespace {

using Q = Rational;
using Rows = std::vector<Vec<Q, 4>>;
constexpr slong bits = 512;

/// A step and the exact differences that it has to enclose.
struct Exact {
  Q length_c;
  Q length_d;
  Q area;
};

bool contains(const arb::Real& x, const Q& value) {
  const arb::Real exact = arb::real(value, bits);
  return arb_contains(x.get(), exact.get()) != 0;
}

bool overlap(const arb::Real& x, const arb::Real& y) { return arb_overlaps(x.get(), y.get()) != 0; }

/// Whether the radius is at most 2^-least_bits of the middle.
bool narrow(const arb::Real& x, slong least_bits) { return arb_rel_accuracy_bits(x.get()) >= least_bits; }

StripForms<Q> forms_of(const KnotList<Q>& u, const Rows& p, const Rows& q) {
  return piece_strips(u, p, q).front().forms;
}

/// C = (3/w, 0), D = (3/w, 4/w) with w = t + delta, in the plane: a pole at t = -delta. Both rails are straight lines,
/// and all measures are rational.
struct Hyperbola {
  Q delta;

  StripForms<Q> forms() const {
    const Q first = delta;
    const Q last = delta + Q(1);
    return forms_of(bezier_knots<Q>(1), {{first, Q(3), Q(0), Q(0)}, {last, Q(3), Q(0), Q(0)}},
                    {{first, Q(3), Q(4), Q(0)}, {last, Q(3), Q(4), Q(0)}});
  }
  /// What the ruling from (x, 0) to (x, 4/3 x), x = 3/w, sweeps between two parameters.
  Exact between(const Q& from, const Q& to) const {
    const Q x = Q(3) / (from + delta);
    const Q y = Q(3) / (to + delta);
    return {x - y, (x - y) * Q(5) / Q(3), (x * x - y * y) * Q(2) / Q(3)};
  }
};

TEST(TaylorStep, EnclosesLengthsAndAreaNearAPole) {
  for (const int denominator : {2, 5, 40}) {
    const Hyperbola strip{Q(1) / Q(denominator)};
    const Stretch stretch(strip.forms(), Q(0), Q(1), false);
    int steps = 0;
    for (Q width(1); width > Q(1) / Q(4096); width /= Q(2)) {
      for (const Q& from : {Q(0), width, Q(1) - width}) {
        const Q to = std::min(Q(from + width), Q(1));
        const std::optional<Step> step = taylor_step(stretch, from, to);
        if (!step || !(from < to)) continue;
        ++steps;
        const Exact exact = strip.between(from, to);
        EXPECT_TRUE(contains(step->length_c, exact.length_c)) << from.text() << ", " << width.text();
        EXPECT_TRUE(contains(step->length_d, exact.length_d)) << from.text() << ", " << width.text();
        EXPECT_TRUE(contains(step->area, exact.area)) << from.text() << ", " << width.text();
        EXPECT_TRUE(contains(step->turn, Q(0)));
        EXPECT_TRUE(narrow(step->length_c, 60));
      }
    }
    EXPECT_GE(steps, 6);
  }
}

/// A cylinder over y = s^2/2, s = t - 1/2: the speed sqrt(1 + s^2) has its singular points at distance 1, close to the
/// disc of radius 16 eta = 49/50, so that its Taylor coefficients are as large as they may be.
TEST(TaylorStep, EnclosesTheLengthOfAParabola) {
  const Q half = Q(1) / Q(2);
  const Rows p{{Q(1), -half, half / Q(4), Q(0)}, {Q(1), Q(0), -half / Q(4), Q(0)}, {Q(1), half, half / Q(4), Q(0)}};
  Rows q = p;
  for (auto& x : q) x[3] = Q(1);
  const Stretch stretch(forms_of(bezier_knots<Q>(2), p, q), Q(0), Q(1), false);
  const auto primitive = [](const Q& s) {  // s sqrt(1 + s^2) + arsinh s = 2 int sqrt(1 + s^2)
    arb::Real x = arb::real(s, bits);
    arb::Real root = arb::real(Q(1) + s * s, bits);
    arb_sqrt(root.get(), root.get(), bits);
    arb_mul(root.get(), root.get(), x.get(), bits);
    arb_asinh(x.get(), x.get(), bits);
    arb_add(x.get(), x.get(), root.get(), bits);
    return x;
  };
  for (const Q& eta : {Q(49) / Q(800), Q(1) / Q(32), Q(1) / Q(100)}) {
    const std::optional<Step> step = taylor_step(stretch, half - eta, half + eta);
    ASSERT_TRUE(step.has_value());
    EXPECT_TRUE(overlap(step->length_c, primitive(eta)));  // odd, so this is the difference of the ends
    EXPECT_TRUE(narrow(step->length_c, 60));
  }
}

/// C = 0 and D = (Re, Im) of (1 + i s)^n with s = t - 1/2, in the plane: D turns by n atan(s) and does not turn back.
struct Fan {
  int n;

  StripForms<Q> forms() const {
    std::vector<Q> re{Q(1)}, im{Q(0)};  // coefficients of s
    for (int k = 0; k < n; ++k) {
      re.push_back(Q(0));
      im.push_back(Q(0));
      for (std::size_t i = re.size() - 1; i > 0; --i) {
        const Q before = re[i - 1];
        re[i] -= im[i - 1];
        im[i] += before;
      }
    }
    const Polynomial<Q> shift(std::vector<Q>{Q(-1) / Q(2), Q(1)});
    const std::array<Polynomial<Q>, 4> row{Polynomial<Q>(1), Polynomial<Q>(re).compose(shift),
                                           Polynomial<Q>(im).compose(shift), Polynomial<Q>()};
    const Rows d = bezier_rows(row, n, Q(0), Q(1));
    Rows c = d;
    for (auto& x : c) x = {Q(1), Q(0), Q(0), Q(0)};
    return forms_of(bezier_knots<Q>(n), c, d);
  }

  arb::Real turn(const Q& from, const Q& to) const {
    arb::Real a = arb::real(to - Q(1) / Q(2), bits);
    arb::Real b = arb::real(from - Q(1) / Q(2), bits);
    arb_atan(a.get(), a.get(), bits);
    arb_atan(b.get(), b.get(), bits);
    arb_sub(a.get(), a.get(), b.get(), bits);
    arb_mul_si(a.get(), a.get(), n, bits);
    return a;
  }
};

TEST(TaylorStep, EnclosesTheAngleOfAFan) {
  for (const int n : {1, 3, 8}) {
    const Fan fan{n};
    const Stretch stretch(fan.forms(), Q(0), Q(1), false);
    int steps = 0;
    for (Q width = Q(1) / Q(2); width > Q(1) / Q(1024); width /= Q(2)) {
      for (const Q& from : {Q(0), Q(1) / Q(4), Q(1) - width}) {
        const std::optional<Step> step = taylor_step(stretch, from, from + width);
        if (!step) continue;
        ++steps;
        arb::Real turned = step->turn;
        arb_abs(turned.get(), turned.get());
        EXPECT_TRUE(overlap(turned, fan.turn(from, from + width))) << n << ", " << from.text() << ", " << width.text();
        EXPECT_TRUE(narrow(turned, 60));
      }
    }
    EXPECT_GE(steps, 5);
  }
}

/// At the middle the fan of degree 8 turns by 8 in a unit; on the disc of radius 1/4 that is more than 1, though all
/// rates are finite there, on that of radius 1/16 it is less.
TEST(TaylorStep, IsTooLongWhereTheDiscTurnsByMoreThanOne) {
  const Stretch stretch(Fan{8}.forms(), Q(0), Q(1), false);
  const auto around = [&](int denominator) {
    const Q eta = Q(1) / Q(denominator);
    return taylor_step(stretch, Q(1) / Q(2) - eta, Q(1) / Q(2) + eta);
  };
  EXPECT_FALSE(around(64).has_value());
  EXPECT_TRUE(around(256).has_value());
}

/// The chord of P over a step: as long as the exact one where the strip lies in the plane.
TEST(TaylorStep, EnclosesTheChordOfATurningRail) {
  const Rows p{{Q(1), Q(0), Q(0), Q(0)}, {Q(1), Q(1), Q(-1), Q(0)}, {Q(1), Q(2), Q(1), Q(0)}};
  const Rows q{{Q(1), Q(0), Q(2), Q(0)}, {Q(1), Q(2), Q(2), Q(0)}, {Q(1), Q(4), Q(3), Q(0)}};
  const Stretch stretch(forms_of(bezier_knots<Q>(2), p, q), Q(0), Q(1), false);
  int steps = 0;
  for (Q width = Q(1) / Q(2); width > Q(1) / Q(512); width /= Q(2)) {
    for (const Q& from : {Q(0), Q(1) / Q(2)}) {
      const std::optional<Step> step = taylor_step(stretch, from, from + width);
      if (!step) continue;
      ++steps;
      const KnotList<Q> u = bezier_knots<Q>(2);
      const Vec<Q, 4> move =
          difference(curve_point<Q, Vec<Q, 4>>(u, p, 1, from + width), curve_point<Q, Vec<Q, 4>>(u, p, 1, from));
      arb::Real square;
      acb_abs(square.get(), step->chord.get(), bits);
      arb_mul(square.get(), square.get(), square.get(), bits);
      EXPECT_TRUE(contains(square, move[1] * move[1] + move[2] * move[2])) << from.text() << ", " << width.text();
      EXPECT_TRUE(narrow(square, 50));
    }
  }
  EXPECT_GE(steps, 5);
}

/// Only bounds: what changes at all is enclosed on both sides of 0.
TEST(BreakingStep, EnclosesWhatChanges) {
  const Hyperbola strip{Q(2)};
  const Exact exact = strip.between(Q(0), Q(1) / Q(4));
  const Step step = breaking_step(Stretch(strip.forms(), Q(0), Q(1) / Q(4), true));
  for (const auto& [ball, value] :
       {std::pair{&step.length_c, exact.length_c}, {&step.length_d, exact.length_d}, {&step.area, exact.area}}) {
    EXPECT_TRUE(contains(*ball, value));
    EXPECT_TRUE(contains(*ball, -value));
    EXPECT_FALSE(contains(*ball, Q(4) * value));
  }
  EXPECT_NE(arb_contains(step.length_c.get(), acb_realref(step.chord.get())), 0);
  for (const int angle : {0, 1, 2, 3}) {  // the direction of the chord is not known
    arb::Complex chord;
    acb_set_arb(chord.get(), arb::real(exact.length_c, bits).get());
    for (int i = 0; i < angle; ++i) acb_mul_onei(chord.get(), chord.get());
    EXPECT_NE(acb_contains(step.chord.get(), chord.get()), 0) << angle;
  }
  const Fan fan{3};
  const Q half = Q(1) / Q(2), end = half + Q(1) / Q(64);
  const Step turning = breaking_step(Stretch(fan.forms(), half, end, true));
  EXPECT_NE(arb_contains(turning.turn.get(), fan.turn(half, end).get()), 0);
}

}  // namespace
}  // namespace torse
