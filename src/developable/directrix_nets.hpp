// The special constructions of ZW06 through a Bezier curve of degree n on [0, 1]: second rows d_0..d_n in closed form.
// ZW06.12 (a = 0, b = 1/(rho-1)) is cone_net and ZW06.17 (a = 1, b = 0) is tangent_net of special.hpp.
//   start_cone_net        ZW06.13, a = s, b = s u: the cone over the curve with vertex c_0
//   mean_tangent_net      ZW06.16, a = 2, b = u      mean_chord_net    ZW06.18, a = 1/u, b = 1
//   affine_net, aumann_equation                      ZW06.19-20, a = n (1-s)/(rho-1), b = (1-u+s u)/(rho-1)
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "torse/developable/directrix.hpp"

namespace torse {

/// d_i = c_i + ((n-i) c_{i+1} + (i+1) c_i - (n+1) c_0) / ((i+1) s) (ZW06.13): s u (d - c) = c - c_0, a cone with vertex
/// c_0. Throws InvalidInput naming "s" for s = 0.
template <Field S, Point<S> P>
std::vector<P> start_cone_net(std::span<const P> c, const S& s) {
  if (definitely(is_zero(s))) throw InvalidInput("s", "expected a value other than 0");
  const int n = static_cast<int>(c.size()) - 1;
  std::vector<P> d;
  for (int i = 0; i <= n; ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    P ruling = combine(from_int<S>(i + 1), c[at_i], from_int<S>(-(n + 1)), c[0]);
    if (i < n) add_scaled(ruling, from_int<S>(n - i), c[at_i + 1]);
    divide(ruling, from_int<S>(i + 1) * s);
    d.push_back(sum(c[at_i], ruling));
  }
  return d;
}

/// d_i = c_i + (n-i) A_i + i A_{i-1}, A_i = (sum_{j<=i} (j+1) (c_{j+1} - c_j)) / ((i+1)(i+2)) (ZW06.16). With
/// m_i = (c_0 + ... + c_i)/(i+1) this is A_i = m_{i+1} - m_i and d = c + m': the edge of regression is the curve
/// m(u) = (1/u) int_0^u c of the running means.
template <Field S, Point<S> P>
std::vector<P> mean_tangent_net(std::span<const P> c) {
  const int n = static_cast<int>(c.size()) - 1;
  std::vector<P> d(c.begin(), c.end());
  P total = PointTraits<P>::zero();
  for (int i = 0; i < n; ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    add_scaled(total, from_int<S>(i + 1), difference(c[at_i + 1], c[at_i]));
    P step = total;
    divide(step, from_int<S>((i + 1) * (i + 2)));
    add_scaled(d[at_i], from_int<S>(n - i), step);
    add_scaled(d[at_i + 1], from_int<S>(i + 1), step);
  }
  return d;
}

/// d_0 = c_0, d_i = c_i + i/(i+1) (c_i + d_{i-1} - 2 c_{i-1}) (ZW06.18). This is d_i = 2 c_i - m_i with the running
/// means of mean_tangent_net: the same surface, its rulings multiplied by u.
template <Field S, Point<S> P>
std::vector<P> mean_chord_net(std::span<const P> c) {
  std::vector<P> d{c[0]};
  for (std::size_t i = 1; i < c.size(); ++i) {
    P step = sum(c[i], d.back());
    add_scaled(step, from_int<S>(-2), c[i - 1]);
    const int index = static_cast<int>(i);
    d.push_back(combine(from_int<S>(1), c[i], ratio<S>(index, index + 1), step));
  }
  return d;
}

/// d_{i+1} = c_i + rho (c_{i+1} - c_i) + s (d_i - c_i) (ZW06.20, Aumann's surfaces): FJ07.12 with M = 1/(1-s) and
/// Lam = rho M for s != 1, ZW06.12 for s = 1.
template <Field S, Point<S> P>
std::vector<P> affine_net(std::span<const P> c, const S& rho, const S& s, const P& d0) {
  std::vector<P> d{d0};
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    P next = combine(from_int<S>(1) - rho - s, c[i], rho, c[i + 1]);
    add_scaled(next, s, d.back());
    d.push_back(std::move(next));
  }
  return d;
}

/// a = n (1-s)/(rho-1), b = (1-u+s u)/(rho-1) (ZW06.19) for a directrix of degree n. Throws InvalidInput naming "rho"
/// for rho = 1, where affine_net is a cylinder.
template <Field S>
DirectrixEquation<S> aumann_equation(int n, const S& rho, const S& s) {
  const S one = from_int<S>(1);
  if (definitely(equal(rho, one))) throw InvalidInput("rho", "1 gives a cylinder, which has no such equation");
  const S over = one / (rho - one);
  return {Bernstein<S>({from_int<S>(n) * (one - s) * over}), Bernstein<S>({over, s * over})};
}

}  // namespace torse
