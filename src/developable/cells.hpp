// The cells of a developable net as barycentric combinations, FJ07.8 and FJ07.18:
//   d_i = (1 - l_i - m_i) c_{i-1} + l_i c_i + m_i d_{i-1},  i = 1..L.
//   first_cell     (l_1, m_1) from L*, M*       next_cell    (l_i, m_i) from (l_{i-1}, m_{i-1})
//   cell_net       the row d from (l_1, m_1) and d_0; valid for cones (m_1 = 1) too
#pragma once

#include <span>
#include <vector>

#include "torse/developable/linear_net.hpp"

namespace torse {

/// The coefficients of one cell.
template <Field S>
struct Cell {
  S l;
  S m;
};

/// The first cell of the net of FJ07.13: l_1 = (L*-u_0)/(M*-u_0), m_1 = (M*-u_n)/(M*-u_0). Throws InvalidInput naming
/// "M" if M* is a knot.
template <Field S>
Cell<S> first_cell(const KnotList<S>& u, const S& lambda, const S& m) {
  require_off_knots(u, m);
  return {(lambda - u[0]) / (m - u[0]), (m - u[u.degree()]) / (m - u[0])};
}

/// (l_i, m_i) from (l_{i-1}, m_{i-1}), 2 <= i <= L (FJ07.18; FJ07.8 for n = 2). Throws InvalidInput naming "cell" where
/// the denominator vanishes, which happens iff M* = u_{i-1}.
template <Field S>
Cell<S> next_cell(const KnotList<S>& u, const Cell<S>& cell, int i) {
  const int n = u.degree();
  const S den = u[i + n - 2] - u[i - 1] + cell.m * (u[i - 1] - u[i - 2]);
  if (definitely(is_zero(den))) {
    throw InvalidInput("cell[" + std::to_string(i) + "]",
                       "the denominator of FJ07.18 vanishes: M* is the knot u_" + std::to_string(i - 1));
  }
  const S l = (cell.m * (u[i - 1] - u[i - 2]) + cell.l * (u[i + n - 2] - u[i - 2]) - u[i - 1] + u[i - 2]) / den;
  const S m = (u[i + n - 2] - u[i + n - 1] + cell.m * (u[i + n - 1] - u[i - 2])) / den;
  return {l, m};
}

/// The row d from the first cell and d_0. Throws InvalidInput naming "points" or "cell[i]".
template <Field S, class P>
std::vector<P> cell_net(const KnotList<S>& u, std::span<const P> c, Cell<S> cell, const P& d0) {
  if (static_cast<int>(c.size()) != u.last() + 1) {
    throw InvalidInput(
        "points", "expected " + std::to_string(u.last() + 1) + " control points, found " + std::to_string(c.size()));
  }
  std::vector<P> d{d0};
  for (int i = 1; i <= u.last(); ++i) {
    const FormulaScope<S> scope("FJ07.18", "d", i);
    const std::size_t at_i = static_cast<std::size_t>(i);
    if (i > 1) cell = next_cell(u, cell, i);
    P next = combine(from_int<S>(1) - cell.l - cell.m, c[at_i - 1], cell.l, c[at_i]);
    add_scaled(next, cell.m, d[at_i - 1]);
    d.push_back(std::move(next));
  }
  return d;
}

}  // namespace torse
