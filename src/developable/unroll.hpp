// The development of a ruled strip into the plane: the rates that carry its rulings there,
// docs/decisions/0008-unroll.md.
//   Strip<T>                       what one piece needs, as polynomials of the piece or as their values
//   StripForms<S>, strip_forms     the polynomials, without the common factors that would hide a normal
//   oriented                       signs of the factors made positive
//   StripRates<T>, strip_rates     how fast the ruling moves and turns in the plane
//   speed_c, speed_d, ruling_length, planar_density
//
// With C, D the rails, W = D - C, e = W/|W| and x = C' x e, y = D' x e:
//   P' = (C'.e) u + |x| u_,  Q' = (D'.e) u + |y| u_,  u' = (|y| - |x|)/|W| u_,  u_ = u turned by -90 degrees,
// keeps the lengths of both rails and of every ruling and their angles. On a developable strip whose edge of regression
// is not between the rails it is the isometry (do Carmo, Differential Geometry of Curves and Surfaces, 5-8).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "torse/algebra/triple.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse {

/// With tau from 0 to 1 on the piece, derivatives by tau, and the rails p = w (1, C), q = omega (1, D):
///   w omega (D - C) = gap W,  w^2 C' = A,  omega^2 D' = B,  A x W = across X,  B x W = across Y,
///   X = across_c X_,  Y = across_d Y_,  A = speed_c A_,  B = speed_d B_,
/// where W, A_, B_, X_, Y_ are vectors that vanish nowhere, and across_c and across_d have no common zero.
template <class T>
struct Strip {
  T w;          ///< weight of C
  T omega;      ///< weight of D
  T gap;        ///< vanishes with the ruling
  T ruling2;    ///< W.W
  T speed_c;    ///< vanishes with C'
  T speed_c2;   ///< A_.A_, 1 for C' = 0 everywhere
  T speed_d;    ///< the same of D
  T speed_d2;   ///< B_.B_
  T along;      ///< A.W
  T across;     ///< vanishes where both rails run along the ruling
  T across_c;   ///< vanishes where only C does
  T across_c2;  ///< X_.X_, 1 for X = 0 everywhere
  T across_d;   ///< vanishes where only D does
  T across_d2;  ///< Y_.Y_
  T turn_c;     ///< (W' x W).X
  T turn_d;     ///< (W' x W).Y
  T spin2;      ///< |W' x W|^2
  T fold;       ///< X.Y, negative where the edge of regression lies between the rails

  /// f of each member.
  template <class F>
  auto transformed(F&& f) const {
    using U = decltype(f(w));
    return Strip<U>{f(w),        f(omega),     f(gap),    f(ruling2), f(speed_c),  f(speed_c2),
                    f(speed_d),  f(speed_d2),  f(along),  f(across),  f(across_c), f(across_c2),
                    f(across_d), f(across_d2), f(turn_c), f(turn_d),  f(spin2),    f(fold)};
  }
};

/// The polynomials of a piece in tau.
template <ExactField S>
struct StripForms {
  Strip<Polynomial<S>> terms;
  std::array<Polynomial<S>, 3> ruling;  ///< W
  std::array<Polynomial<S>, 3> normal;  ///< omega^2 X + w^2 Y, along the surface's normal at some point of the ruling
};

namespace detail {

template <ExactField S>
using PolynomialVector = std::array<Polynomial<S>, 3>;

/// Divides a vector by a polynomial that divides it; zero stays.
template <ExactField S>
PolynomialVector<S> quotient(PolynomialVector<S> a, const Polynomial<S>& factor) {
  if (factor.zero()) return a;
  for (Polynomial<S>& x : a) x = exact_quotient(x, factor);
  return a;
}

/// The square of what is left of a vector without the factor, 1 for the zero vector.
template <ExactField S>
Polynomial<S> square_without(const PolynomialVector<S>& a, const Polynomial<S>& factor) {
  if (factor.zero()) return Polynomial<S>(1);
  const PolynomialVector<S> rest = quotient<S>(a, factor);
  return dot(rest, rest);
}

/// w^2 times the derivative of the curve with the homogeneous row p = w (1, c).
template <ExactField S>
PolynomialVector<S> affine_speed(const PolynomialRow<S, 4>& p) {
  PolynomialVector<S> a;
  const Polynomial<S> slope = p[0].derivative();
  for (std::size_t j = 0; j < 3; ++j) a[j] = p[j + 1].derivative() * p[0] - p[j + 1] * slope;
  return a;
}

template <ExactField S>
PolynomialRow<S, 4> local_row(const std::vector<BinaryForm<S>>& basis, std::span<const Vec<S, 4>> p, int k) {
  const std::array<BinaryForm<S>, 4> forms = piece_forms<S, 4>(basis, p, k);
  PolynomialRow<S, 4> row;
  for (std::size_t j = 0; j < 4; ++j) row[j] = in_parameter(forms[j], from_int<S>(0), from_int<S>(1));
  return row;
}

}  // namespace detail

/// The polynomials of piece k of a ruled spline with homogeneous rows p, q. The piece is not empty. Where p and q are
/// proportional everywhere, `gap` is zero; where the rulings sweep a line only, `across` is.
template <ExactField S>
StripForms<S> strip_forms(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q, int k) {
  using detail::affine_speed, detail::local_row, detail::PolynomialVector, detail::quotient, detail::square_without;
  const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
  const PolynomialRow<S, 4> c = local_row<S>(basis, p, k);
  const PolynomialRow<S, 4> d = local_row<S>(basis, q, k);
  const PolynomialVector<S> a = affine_speed<S>(c);
  const PolynomialVector<S> b = affine_speed<S>(d);
  PolynomialVector<S> w;
  for (std::size_t j = 0; j < 3; ++j) w[j] = c[0] * d[j + 1] - d[0] * c[j + 1];
  const Polynomial<S> gap = common_divisor(w);
  w = quotient<S>(w, gap);
  PolynomialVector<S> x = cross(a, w);
  PolynomialVector<S> y = cross(b, w);
  const Polynomial<S> across = gcd(common_divisor(x), common_divisor(y));
  x = quotient<S>(x, across);
  y = quotient<S>(y, across);
  PolynomialVector<S> slope = w;
  for (Polynomial<S>& f : slope) f = f.derivative();
  const PolynomialVector<S> spin = cross(slope, w);
  const std::array<Polynomial<S>, 4> factors{common_divisor(a), common_divisor(b), common_divisor(x),
                                             common_divisor(y)};
  const Polynomial<S> w2 = c[0] * c[0];
  const Polynomial<S> omega2 = d[0] * d[0];
  PolynomialVector<S> normal;
  for (std::size_t j = 0; j < 3; ++j) normal[j] = omega2 * x[j] + w2 * y[j];
  return {Strip<Polynomial<S>>{.w = c[0],
                               .omega = d[0],
                               .gap = gap,
                               .ruling2 = dot(w, w),
                               .speed_c = factors[0],
                               .speed_c2 = square_without<S>(a, factors[0]),
                               .speed_d = factors[1],
                               .speed_d2 = square_without<S>(b, factors[1]),
                               .along = dot(a, w),
                               .across = across,
                               .across_c = factors[2],
                               .across_c2 = square_without<S>(x, factors[2]),
                               .across_d = factors[3],
                               .across_d2 = square_without<S>(y, factors[3]),
                               .turn_c = dot(spin, x),
                               .turn_d = dot(spin, y),
                               .spin2 = dot(spin, spin),
                               .fold = dot(x, y)},
          std::move(w), std::move(normal)};
}

/// The same strip with every factor positive at tau, and so on every interval around it without a zero of theirs: W
/// along D - C, X and Y along the normal.
template <ExactField S>
requires OrderedField<S> StripForms<S> oriented(StripForms<S> forms, const S& tau) {
  Strip<Polynomial<S>>& f = forms.terms;
  const auto negative = [&](const Polynomial<S>& g) { return definitely(less(g(tau), from_int<S>(0))); };
  const auto flip = [](Polynomial<S>& g) { g = -std::move(g); };
  const auto flip_normals = [&] {
    flip(f.turn_c);
    flip(f.turn_d);
    std::ranges::for_each(forms.normal, flip);
  };
  if (negative(f.gap * f.w * f.omega)) {
    flip(f.gap);
    flip(f.along);
    std::ranges::for_each(forms.ruling, flip);
    flip_normals();
  }
  if (negative(f.across)) {
    flip(f.across);
    flip_normals();
  }
  for (Polynomial<S>* g : {&f.speed_c, &f.speed_d, &f.across_c, &f.across_d}) {
    if (negative(*g)) flip(*g);
  }
  return forms;
}

/// What moves in the plane: P' = along u + across_c u_, u' = turn u_, and the rails' speeds.
template <class T>
struct StripRates {
  T speed_c;   ///< |C'| = |P'|
  T speed_d;   ///< |D'| = |Q'|
  T along;     ///< C'.e
  T across_c;  ///< |C' x e|
  T across_d;  ///< |D' x e|
  T turn;      ///< (|D' x e| - |C' x e|)/|D - C|: how fast u turns towards u_
  T swept;     ///< the area that the ruling sweeps in the plane, planar_density
};

namespace detail {

/// |X|/w^2 and |Y|/omega^2.
template <class T>
std::array<T, 2> normal_lengths(const Strip<T>& f, const T& w2, const T& omega2) {
  return {f.across_c * ScalarTraits<T>::sqrt(f.across_c2) / w2,
          f.across_d * ScalarTraits<T>::sqrt(f.across_d2) / omega2};
}

}  // namespace detail

/// |C'| and |D'|.
template <class T>
T speed_c(const Strip<T>& f) {
  return f.speed_c * ScalarTraits<T>::sqrt(f.speed_c2) / (f.w * f.w);
}
template <class T>
T speed_d(const Strip<T>& f) {
  return f.speed_d * ScalarTraits<T>::sqrt(f.speed_d2) / (f.omega * f.omega);
}

/// The area that the ruling sweeps in the plane: |D - C| (|x| + |y|)/2. On the surface it sweeps at most that, and at
/// least cos(omega/2) of it where the normals along it are at most omega <= 90 degrees apart.
template <class T>
T planar_density(const Strip<T>& f) {
  const auto [x, y] = detail::normal_lengths(f, f.w * f.w, f.omega * f.omega);
  return f.gap * f.across * (x + y) / ((f.w * f.omega) + (f.w * f.omega));
}

/// The rates from values of an oriented strip. The turn is taken as e'.(x + y)/(|x| + |y|), which is the same without a
/// division by the ruling's length. T is a field with ScalarTraits<T>::sqrt; its elements may be power series.
template <class T>
StripRates<T> strip_rates(const Strip<T>& f) {
  const T root = ScalarTraits<T>::sqrt(f.ruling2);
  const T w2 = f.w * f.w;
  const T omega2 = f.omega * f.omega;
  const auto [x, y] = detail::normal_lengths(f, w2, omega2);
  return {speed_c(f),          speed_d(f),          f.along / (root * w2),
          f.across * x / root, f.across * y / root, (f.turn_c / w2 + f.turn_d / omega2) / (f.ruling2 * (x + y)),
          planar_density(f)};
}

/// |D - C|.
template <class T>
T ruling_length(const Strip<T>& f) {
  return f.gap * ScalarTraits<T>::sqrt(f.ruling2) / (f.w * f.omega);
}

}  // namespace torse
