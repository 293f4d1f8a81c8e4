#include "torse/exact/quasi/ruling_order.hpp"

#include <algorithm>

#include "torse/algebra/determinant.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {
namespace {

/// Gilbert's algorithm comes near soon and then hardly nearer.
constexpr int most_steps = 200;

/// A direction is good enough when its least product is this share of the largest there can be.
constexpr double good = 0.25;

}  // namespace

Vec<double, 3> common_side(std::span<const RulingTangents<double>> parts) {
  std::vector<Vec<double, 3>> normals;
  Vec<double, 3> e(0, 0, 0);
  for (const RulingTangents<double>& of : parts) {
    for (const Vec<double, 3>& w : of.w) {
      for (const RulingTangents<double>& other : parts) {
        for (const Vec<double, 3>& tangent : other.rails) {
          const Vec<double, 3> normal = cross(w, tangent).normalized();
          if (!normal.allFinite() || normal.isZero(0)) continue;
          normals.push_back(normal);
          e += normal;
        }
      }
    }
  }
  e /= static_cast<double>(normals.size());
  for (int step = 0; step < most_steps && !normals.empty(); ++step) {
    const auto product = [&](const Vec<double, 3>& normal) { return e.dot(normal); };
    const Vec<double, 3>& worst = *std::ranges::min_element(normals, {}, product);
    if (product(worst) > good * e.squaredNorm()) break;
    const Vec<double, 3> way = worst - e;
    e += std::clamp(-e.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  return e.normalized();
}

template <Field S>
Truth on_one_side(std::span<const RulingTangents<S>> parts, const Vec<S, 3>& e) {
  Truth all = Truth::yes;
  for (const RulingTangents<S>& of : parts) {
    Truth still = Truth::yes;  // the part's own products are all 0
    for (const Vec<S, 3>& w : of.w) {
      const Vec<S, 3> side = cross(e, w);
      for (const RulingTangents<S>& other : parts) {
        for (const Vec<S, 3>& tangent : other.rails) {
          const S product = dot(side, tangent);
          all = all & !less(product, from_int<S>(0));
          if (&of == &other) still = still & is_zero(product);
          if (all == Truth::no) return all;
        }
      }
    }
    all = all & !still;
  }
  return all;
}

template Truth on_one_side<Interval>(std::span<const RulingTangents<Interval>>, const Vec<Interval, 3>&);
template Truth on_one_side<Rational>(std::span<const RulingTangents<Rational>>, const Vec<Rational, 3>&);

}  // namespace torse
