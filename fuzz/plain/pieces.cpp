#include "torse/fuzz/plain/pieces.hpp"

#include <algorithm>
#include <utility>

namespace torse::fuzz::plain {
namespace {

/// The basis functions of degree n that belong to the knots u_i..u_{i+n}, i = m-n..m, on [u_m, u_{m+1}] of the list
/// with one knot more at either end, by N_i^r = (t-u_i)/(u_{i+r}-u_i) N_i^{r-1} + (u_{i+r+1}-t)/(u_{i+r+1}-u_{i+1})
/// N_{i+1}^{r-1}. Those two knots have no effect inside the domain.
std::vector<Poly> basis(const std::vector<Rational>& u, int n, int m) {
  const auto knot = [&](int i) -> const Rational& { return u[static_cast<std::size_t>(i)]; };
  std::vector<Poly> row{Poly{Rational(1)}};  // N_{m-r}^r, ..., N_m^r
  for (int r = 1; r <= n; ++r) {
    std::vector<Poly> next(static_cast<std::size_t>(r) + 1);
    for (int i = m - r; i <= m; ++i) {
      const int at = i - (m - r);
      Poly& f = next[static_cast<std::size_t>(at)];
      if (at > 0) {
        const Rational width = knot(i + r) - knot(i);
        f = plus(f, times({-knot(i) / width, Rational(1) / width}, row[static_cast<std::size_t>(at) - 1]));
      }
      if (at < r) {
        const Rational width = knot(i + r + 1) - knot(i + 1);
        f = plus(f, times({knot(i + r + 1) / width, Rational(-1) / width}, row[static_cast<std::size_t>(at)]));
      }
    }
    row = std::move(next);
  }
  return row;
}

/// e_0, ..., e_n of the knots u_i..u_{i+n-1}.
Poly symmetric_functions(const KnotList<Rational>& u, int i) {
  Poly e{Rational(1)};
  for (int j = i; j < i + u.degree(); ++j) {
    e.emplace_back();
    for (std::size_t k = e.size() - 1; k > 0; --k) e[k] += u[j] * e[k - 1];
  }
  return e;
}

/// The piece of the breaks that a control point is taken from.
template <int D>
const PolyRow<D>& row_under(const Pieces<D>& curve, const KnotList<Rational>& u, int i) {
  const int n = u.degree();
  const int first = std::clamp(i, n - 1, u.last() - 1);
  int m = first;
  while (m < std::min(i + n, u.last()) && u[m] == u[m + 1]) ++m;
  if (m == u.last() || u[m] == u[m + 1]) {
    m = first;
    while (m > n - 1 && u[m] == u[m + 1]) --m;
  }
  if (u[m] == u[m + 1]) {
    while (u[m] == u[m + 1]) ++m;
  }
  std::size_t j = 0;
  while (j + 1 < curve.rows.size() && curve.breaks[j + 1] <= u[m]) ++j;
  return curve.rows[j];
}

}  // namespace

std::vector<Rational> breaks_of(const KnotList<Rational>& u) {
  std::vector<Rational> breaks{u.domain_begin()};
  for (int i = u.degree(); i <= u.last(); ++i) {
    if (u[i] != breaks.back()) breaks.push_back(u[i]);
  }
  return breaks;
}

template <int D>
Pieces<D> pieces_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, D>>& control) {
  const int n = u.degree();
  const std::vector<Rational> cad = u.cad_list();
  Pieces<D> curve{breaks_of(u), {}};
  for (int k = 1; k <= u.pieces(); ++k) {
    if (u.piece_begin(k) == u.piece_end(k)) continue;
    const std::vector<Poly> functions = basis(cad, n, n + k - 1);
    PolyRow<D> row;
    for (int i = 0; i <= n; ++i) {
      const Vec<Rational, D>& point = control[static_cast<std::size_t>(k - 1 + i)];
      for (int j = 0; j < D; ++j) {
        Poly& f = row[static_cast<std::size_t>(j)];
        f = plus(f, scaled(point[j], functions[static_cast<std::size_t>(i)]));
      }
    }
    curve.rows.push_back(std::move(row));
  }
  return curve;
}

template <int D>
std::vector<Vec<Rational, D>> control_row(const Pieces<D>& curve, const KnotList<Rational>& u) {
  std::vector<Vec<Rational, D>> control;
  for (int i = 0; i <= u.last(); ++i) {
    Poly e = symmetric_functions(u, i);
    Rational choose(1);  // C(n, j)
    for (int j = 0; j <= u.degree(); ++j) {
      e[static_cast<std::size_t>(j)] /= choose;
      choose = choose * Rational(u.degree() - j) / Rational(j + 1);
    }
    const PolyRow<D>& row = row_under(curve, u, i);
    Vec<Rational, D> point;
    for (int coordinate = 0; coordinate < D; ++coordinate) {
      const Poly& f = row[static_cast<std::size_t>(coordinate)];
      point[coordinate] = Rational();
      for (std::size_t j = 0; j < std::min(f.size(), e.size()); ++j) point[coordinate] += f[j] * e[j];
    }
    control.push_back(std::move(point));
  }
  return control;
}

template Pieces<1> pieces_of<1>(const KnotList<Rational>&, const std::vector<Vec<Rational, 1>>&);
template Pieces<3> pieces_of<3>(const KnotList<Rational>&, const std::vector<Vec<Rational, 3>>&);
template Pieces<4> pieces_of<4>(const KnotList<Rational>&, const std::vector<Vec<Rational, 4>>&);
template std::vector<Vec<Rational, 1>> control_row<1>(const Pieces<1>&, const KnotList<Rational>&);
template std::vector<Vec<Rational, 3>> control_row<3>(const Pieces<3>&, const KnotList<Rational>&);
template std::vector<Vec<Rational, 4>> control_row<4>(const Pieces<4>&, const KnotList<Rational>&);

}  // namespace torse::fuzz::plain
