#include "torse/exact/quasi/ruling_order.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/exact/quasi/nearest_in_hull.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {
namespace {

using Direction = Vec<double, 3>;

/// A direction is good enough when its least product is this share of the largest there can be.
constexpr double good = 0.25;

/// The share of the size of its terms that rounding may have made of a normal: some bits more than it does.
constexpr double rounding = 0x1p-40;

/// A product of a coefficient of w and one of a rail, and how often it is taken.
template <class S>
struct Term {
  int of_w;
  int of_rail;
  S weight;
};

/// What each coefficient of w(s) x a(t) is the sum of, but for positive factors.
template <class S>
using Sums = std::vector<std::vector<Term<S>>>;

/// For all s and t of two parts.
template <class S>
Sums<S> each_product(int p, int q) {
  Sums<S> sums;
  for (int j = 0; j <= p; ++j) {
    for (int i = 0; i <= q; ++i) sums.push_back({{j, i, from_int<S>(1)}});
  }
  return sums;
}

/// For s <= t of one part: coefficient j of w(r t) by Bernstein polynomials of r is sum_k B_k^j(t) w_k, so that
/// coefficient m in t of its product with a is the sum of C(j, k) C(q, m - k) w_k x a_{m-k}, divided by C(j + q, m).
template <class S>
Sums<S> ordered_products(int p, int q) {
  Sums<S> sums;
  const std::vector<S> of_rail = binomials<S>(q);
  for (int j = 0; j <= p; ++j) {
    const std::vector<S> of_w = binomials<S>(j);
    for (int m = 0; m <= j + q; ++m) {
      sums.emplace_back();
      for (int k = std::max(0, m - q); k <= std::min(j, m); ++k) {
        sums.back().push_back({k, m - k, of_w[static_cast<std::size_t>(k)] * of_rail[static_cast<std::size_t>(m - k)]});
      }
    }
  }
  return sums;
}

/// Calls visit(w, rail, sums, number of the part of w, whether the rail is of it) for the rulings of each part and the
/// rails of it and those behind.
template <class S, class Visit>
void for_each_pair(std::span<const RulingTangents<S>> parts, const Visit& visit) {
  const auto degree = [](const std::vector<Vec<S, 3>>& row) { return static_cast<int>(row.size()) - 1; };
  for (std::size_t first = 0; first < parts.size(); ++first) {
    const std::vector<Vec<S, 3>>& w = parts[first].w;
    for (std::size_t second = first; second < parts.size(); ++second) {
      for (const auto* rail : {&parts[second].a, &parts[second].b}) {
        const auto sums =
            first == second ? ordered_products<S>(degree(w), degree(*rail)) : each_product<S>(degree(w), degree(*rail));
        visit(w, *rail, sums, first, first == second);
      }
    }
  }
}

}  // namespace

Direction common_side(std::span<const RulingTangents<double>> parts) {
  std::vector<Direction> normals;
  for_each_pair(parts, [&](const auto& w, const auto& rail, const Sums<double>& sums, std::size_t, bool) {
    for (const std::vector<Term<double>>& sum : sums) {
      Direction normal(0, 0, 0);
      double size = 0;
      for (const Term<double>& term : sum) {
        const Direction& x = w[static_cast<std::size_t>(term.of_w)];
        const Direction& y = rail[static_cast<std::size_t>(term.of_rail)];
        normal += term.weight * cross(x, y);
        size += term.weight * x.norm() * y.norm();
      }
      if (normal.norm() > rounding * size) normals.push_back(normal.normalized());
    }
  });
  if (normals.empty()) return Direction::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto lowest = [&](const Direction& e) {
    return *std::ranges::min_element(normals, {}, [&](const Direction& normal) { return e.dot(normal); });
  };
  return nearest_in_hull(lowest, good).normalized();
}

template <Field S>
Truth on_one_side(std::span<const RulingTangents<S>> parts, const Vec<S, 3>& e) {
  Truth all = Truth::yes;
  std::vector<Truth> still(parts.size(), Truth::yes);  // a part's own products are all 0
  for_each_pair(parts, [&](const auto& w, const auto& rail, const Sums<S>& sums, std::size_t part, bool own) {
    for (const std::vector<Term<S>>& sum : sums) {
      if (all == Truth::no) return;
      S total = from_int<S>(0);
      for (const Term<S>& term : sum) {
        const Vec<S, 3>& x = w[static_cast<std::size_t>(term.of_w)];
        total += term.weight * dot(cross(e, x), rail[static_cast<std::size_t>(term.of_rail)]);
      }
      all = all & !less(total, from_int<S>(0));
      if (own) still[part] = still[part] & is_zero(total);
    }
  });
  for (const Truth& part : still) all = all & !part;
  return all;
}

template Truth on_one_side<Interval>(std::span<const RulingTangents<Interval>>, const Vec<Interval, 3>&);
template Truth on_one_side<Rational>(std::span<const RulingTangents<Rational>>, const Vec<Rational, 3>&);

}  // namespace torse
