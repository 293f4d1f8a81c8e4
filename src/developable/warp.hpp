// The warp angle of a ruled surface: the angle between the tangent planes at the two ends of a ruling (BZZ19).
//   RulingForms, ruling_forms     directions of c', of the ruling and of d' on a piece, as forms
//   SineForms, sine_forms         sin^2 of the warp angle as a quotient of two forms of equal degree
//   normal_forms                  the surface normals at the two ends
//   pointwise_sine_squared        sin^2 of the warp angle at one parameter
#pragma once

#include <array>
#include <span>

#include "torse/algebra/determinant.hpp"
#include "torse/algebra/triple.hpp"
#include "torse/spline/basis.hpp"
#include "torse/spline/blossom.hpp"

namespace torse {

/// Three coordinates as forms of equal degree.
template <Ring S>
using FormVector = std::array<BinaryForm<S>, 3>;

/// Multiples of c', d - c and d' on a piece; the factors are positive constants, or polynomials for rational surfaces.
template <Ring S>
struct RulingForms {
  FormVector<S> a;  ///< along c'
  FormVector<S> w;  ///< along d - c
  FormVector<S> b;  ///< along d'
};

/// The directions on piece k of a polynomial surface: of degree n-1, n, n-1.
template <Field S>
RulingForms<S> ruling_forms(const KnotList<S>& u, std::span<const Vec<S, 3>> c, std::span<const Vec<S, 3>> d, int k) {
  const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
  const auto cf = piece_forms<S, 3>(basis, c, k);
  const auto df = piece_forms<S, 3>(basis, d, k);
  RulingForms<S> forms;
  for (std::size_t j = 0; j < 3; ++j) {
    forms.a[j] = cf[j].derivative_t() - cf[j].derivative_s();
    forms.w[j] = df[j] - cf[j];
    forms.b[j] = df[j].derivative_t() - df[j].derivative_s();
  }
  return forms;
}

/// The directions on piece k of a rational surface with homogeneous rows p = w (1, c), q = omega (1, d): w^2 c' =
/// dp/ds_0 dp/dt - dp/dt_0 dp/ds up to a constant, and w omega (d - c); of degree 2n-2, 2n, 2n-2.
template <Field S>
RulingForms<S> ruling_forms(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q, int k) {
  const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
  const auto pf = piece_forms<S, 4>(basis, p, k);
  const auto qf = piece_forms<S, 4>(basis, q, k);
  const auto speed = [](const std::array<BinaryForm<S>, 4>& x, std::size_t j) {
    return x[0].derivative_s() * x[j].derivative_t() - x[0].derivative_t() * x[j].derivative_s();
  };
  RulingForms<S> forms;
  for (std::size_t j = 0; j < 3; ++j) {
    forms.a[j] = speed(pf, j + 1);
    forms.w[j] = pf[0] * qf[j + 1] - qf[0] * pf[j + 1];
    forms.b[j] = speed(qf, j + 1);
  }
  return forms;
}

/// sin^2 of the warp angle: numerator / denominator, both not negative. Where the denominator vanishes a normal does,
/// and the angle is not defined.
template <Ring S>
struct SineForms {
  BinaryForm<S> numerator;
  BinaryForm<S> denominator;
};

/// From the directions: with the normals m = a x w and n = b x w,
///   |m x n|^2 = |w|^2 [a, w, b]^2,   m . n = (a.b)(w.w) - (a.w)(b.w),   |m|^2 |n|^2 = (m . n)^2 + |m x n|^2.
template <Ring S>
SineForms<S> sine_forms(const RulingForms<S>& f) {
  const BinaryForm<S> w2 = dot(f.w, f.w);
  const BinaryForm<S> det = dot(cross(f.a, f.b), f.w);
  const BinaryForm<S> cosine = dot(f.a, f.b) * w2 - dot(f.a, f.w) * dot(f.b, f.w);
  BinaryForm<S> numerator = w2 * (det * det);
  BinaryForm<S> denominator = cosine * cosine + numerator;
  return {std::move(numerator), std::move(denominator)};
}

/// c' x (d - c) and d' x (d - c), up to positive factors.
template <Ring S>
std::array<FormVector<S>, 2> normal_forms(const RulingForms<S>& f) {
  return {cross(f.a, f.w), cross(f.b, f.w)};
}

/// From the normals m and n, or any multiples of them: |m x n|^2 / (|m|^2 |n|^2).
template <Ring S>
SineForms<S> sine_forms(const FormVector<S>& m, const FormVector<S>& n) {
  const FormVector<S> product = cross(m, n);
  return {dot(product, product), dot(m, m) * dot(n, n)};
}

/// sin^2 of the warp angle at the parameter t of piece k from points and derivatives of the curves: BZZ19's |w|^2 [a,
/// w, b]^2 / (|a x w|^2 |b x w|^2). Throws DivisionByZero (exact fields) where a normal vanishes.
template <Field S>
S pointwise_sine_squared(const KnotList<S>& u, std::span<const Vec<S, 3>> c, std::span<const Vec<S, 3>> d, int k,
                         const S& t) {
  const Vec<S, 3> a = curve_derivative(u, c, k, t);
  const Vec<S, 3> b = curve_derivative(u, d, k, t);
  const Vec<S, 3> w = difference(curve_point(u, d, k, t), curve_point(u, c, k, t));
  const Vec<S, 3> m = cross(a, w);
  const Vec<S, 3> n = cross(b, w);
  const S det = det3(a, w, b);
  return dot(w, w) * (det * det) / (dot(m, m) * dot(n, n));
}

}  // namespace torse
