// The nearest nets with rulings through one point: an eigenvector, and for homogeneous rows a search in one variable
// around it.
#include <algorithm>
#include <utility>

#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// Rulings through the point V: derived = alpha base + beta V, where base is c and derived d unless they are swapped.
/// V has zeros in front of coordinate `first`.
template <int D>
struct Pencil {
  std::size_t swapped;
  Real alpha;
  int first;
};

template <int D>
struct PencilView {
  const RealNet<D>& net;
  const Pencil<D>& pencil;

  std::size_t count() const { return net.size() / 2; }
  std::size_t base(std::size_t i) const { return 2 * i + pencil.swapped; }
  std::size_t derived(std::size_t i) const { return 2 * i + 1 - pencil.swapped; }
  Real scale(std::size_t i) const { return net.scale[derived(i)] + pencil.alpha * pencil.alpha * net.scale[base(i)]; }
  /// derived - alpha base.
  Vec<Real, D> ruling(std::size_t i) const {
    Vec<Real, D> s = net.points[derived(i)];
    add_scaled(s, -pencil.alpha, net.points[base(i)]);
    return s;
  }
};

template <int D>
Vec<Real, D> best_point(const PencilView<D>& view, std::size_t stride) {
  const int first = view.pencil.first;
  Matrix moments = zero_matrix(static_cast<std::size_t>(D - first));
  for (std::size_t i = 0; i < view.count(); i += stride) {
    const Vec<Real, D> s = view.ruling(i);
    const Real scale = view.scale(i);
    for (std::size_t j = 0; j < moments.size(); ++j) {
      for (std::size_t k = 0; k < moments.size(); ++k) {
        moments[j][k] += s[first + static_cast<int>(j)] * s[first + static_cast<int>(k)] / scale;
      }
    }
  }
  const std::vector<Real> top = symmetric_eigen(std::move(moments)).back().vector;
  Vec<Real, D> v = PointTraits<Vec<Real, D>>::zero();
  for (std::size_t j = 0; j < top.size(); ++j) v[first + static_cast<int>(j)] = top[j];
  return v;
}

/// The part of the ruling across v.
template <int D>
Vec<Real, D> across(Vec<Real, D> ruling, const Vec<Real, D>& v) {
  add_scaled(ruling, -(inner<D>(ruling, v) / inner<D>(v, v)), v);
  return ruling;
}

/// The squared distance, of every stride-th ruling.
template <int D>
Real pencil_distance(const RealNet<D>& net, const Pencil<D>& pencil, std::size_t stride = 1) {
  const PencilView<D> view{net, pencil};
  const Vec<Real, D> v = best_point(view, stride);
  Real sum;
  for (std::size_t i = 0; i < view.count(); i += stride) {
    const Vec<Real, D> rho = across<D>(view.ruling(i), v);
    sum += inner<D>(rho, rho) / view.scale(i);
  }
  return sum;
}

template <int D>
ExactNet<D> realise_pencil(const RealNet<D>& net, Pencil<D> pencil, const Real& squared, bool keep_alpha) {
  const PencilView<D> view{net, pencil};
  const Accuracy accuracy(squared, net.size());
  Real base_weight, ruling_weight;
  for (std::size_t i = 0; i < view.count(); ++i) {
    const Vec<Real, D> s = view.ruling(i);
    const Vec<Real, D>& b = net.points[view.base(i)];
    base_weight += inner<D>(b, b) / view.scale(i);
    ruling_weight += inner<D>(s, s) / view.scale(i);
  }
  const Rational alpha = keep_alpha ? Rational(1) : simplest_near(pencil.alpha, accuracy.tolerance(base_weight, D));
  const Vec<Rational, D> v = simple_direction<D>(best_point(view, 1), accuracy.tolerance(ruling_weight, D));
  pencil.alpha = Real::from_rational(alpha);

  const Vec<Real, D> direction = real_point<D>(v);
  ExactNet<D> result(net.size());
  for (std::size_t i = 0; i < view.count(); ++i) {
    const Vec<Real, D> s = view.ruling(i);
    const Real& base_scale = net.scale[view.base(i)];
    Vec<Real, D> b = net.points[view.base(i)];
    add_scaled(b, pencil.alpha * base_scale / view.scale(i), across<D>(s, direction));
    const Rational beta = rounded(inner<D>(s, direction) / inner<D>(direction, direction),
                                  accuracy.exponent(net.scale[view.derived(i)]) - 1);
    result[view.base(i)] = rounded_point<D>(b, accuracy.exponent(base_scale));
    result[view.derived(i)] = combine(alpha, result[view.base(i)], beta, v);
  }
  return result;
}

/// The best alpha for homogeneous rows: samples, Newton's method on differences.
Pencil<4> best_pencil(const RealNet<4>& net, int first) {
  constexpr int samples = 32;
  const std::size_t stride = std::max<std::size_t>(1, net.size() / 128);
  Pencil<4> best{0, Real(0), first};
  Real least = pencil_distance(net, best, stride);
  const auto improves = [&](const Pencil<4>& pencil) {
    const Real distance = pencil_distance(net, pencil, stride);
    if (!(distance < least)) return false;
    least = distance;
    best = pencil;
    return true;
  };
  const auto at = [&](const Real& alpha) { return Pencil<4>{best.swapped, alpha, first}; };

  for (std::size_t swapped = 0; swapped < 2; ++swapped) {
    for (int k = -samples; k <= samples; ++k) improves({swapped, Real(k) / Real(samples), first});
  }
  const Real step = Real::from_rational(power_of_two(-60));
  for (int round = 0; round < 6; ++round) {
    const Real above = pencil_distance(net, at(best.alpha + step), stride);
    const Real below = pencil_distance(net, at(best.alpha - step), stride);
    const Real bend = above - Real(2) * least + below;
    if (!(bend > Real(0)) || !improves(at(best.alpha - step * (above - below) / (Real(2) * bend)))) break;
  }
  return best;
}

Candidate<4> searched_candidate(const RealNet<4>& net, int first) {
  const Pencil<4> pencil = best_pencil(net, first);
  const Real squared = pencil_distance(net, pencil);
  return {.squared = squared,
          .realise = [&net, pencil, squared] { return realise_pencil(net, pencil, squared, false); }};
}

}  // namespace

template <>
Candidate<3> cylinder_candidate<3>(const RealNet<3>& net) {
  const Pencil<3> pencil{0, Real(1), 0};
  const Real squared = pencil_distance(net, pencil);
  return {.squared = squared,
          .realise = [&net, pencil, squared] { return realise_pencil(net, pencil, squared, true); }};
}

template <>
Candidate<4> cylinder_candidate<4>(const RealNet<4>& net) {
  return searched_candidate(net, 1);
}

Candidate<4> pencil_candidate(const RealNet<4>& net) { return searched_candidate(net, 0); }

}  // namespace torse::repair
