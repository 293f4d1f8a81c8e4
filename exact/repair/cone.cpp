// The nearest cone of FJ07.6: total least squares in its ratio.
#include <array>

#include "torse/exact/repair/families.hpp"
#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// The nearest d = alpha b + t: total least squares in one slope.
struct ConeFit {
  std::size_t swapped;
  Real alpha;
  Real base_weight;
  Real squared;
};

/// t for a given slope.
Vec<Real, 3> cone_offset(const RealNet<3>& net, std::size_t swapped, const Real& alpha) {
  Vec<Real, 3> t = mean_point(net, 1 - swapped, 2);
  add_scaled(t, -alpha, mean_point(net, swapped, 2));
  return t;
}

Vec<Real, 3> cone_error(const RealNet<3>& net, std::size_t swapped, const Real& alpha, const Vec<Real, 3>& t,
                        std::size_t i) {
  Vec<Real, 3> rho = net.points[2 * i + 1 - swapped];
  add_scaled(rho, -alpha, net.points[2 * i + swapped]);
  subtract(rho, t);
  return rho;
}

ConeFit cone_fit(const RealNet<3>& net) {
  Matrix moments = zero_matrix(2);
  const std::array<Vec<Real, 3>, 2> centre{mean_point(net, 0, 2), mean_point(net, 1, 2)};
  for (std::size_t i = 0; i < net.size(); i += 2) {
    const std::array<Vec<Real, 3>, 2> x{difference(net.points[i], centre[0]), difference(net.points[i + 1], centre[1])};
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t k = 0; k < 2; ++k) moments[j][k] += inner<3>(x[j], x[k]);
    }
  }
  // The eigenvector (x, y) of the smaller eigenvalue: x c + y d is nearly constant.
  const std::vector<Real> flat = symmetric_eigen(moments).front().vector;
  ConeFit fit;
  fit.swapped = magnitude(flat[0]) > magnitude(flat[1]) ? 1 : 0;
  fit.alpha = -flat[fit.swapped] / flat[1 - fit.swapped];
  fit.base_weight = moments[fit.swapped][fit.swapped];
  const Vec<Real, 3> t = cone_offset(net, fit.swapped, fit.alpha);
  for (std::size_t i = 0; i < net.size() / 2; ++i) {
    const Vec<Real, 3> rho = cone_error(net, fit.swapped, fit.alpha, t, i);
    fit.squared += inner<3>(rho, rho);
  }
  fit.squared /= Real(1) + fit.alpha * fit.alpha;
  return fit;
}

std::optional<ExactNet<3>> realise_cone(const RealNet<3>& net, const ConeFit& fit) {
  const Accuracy accuracy(fit.squared, net.size());
  const Real scale = Real(1) + fit.alpha * fit.alpha;
  const Rational alpha = simplest_near(fit.alpha, accuracy.tolerance(fit.base_weight / scale, 1));
  if (alpha == Rational(1)) return std::nullopt;  // a cylinder
  const Real slope = Real::from_rational(alpha);
  const Vec<Real, 3> t = cone_offset(net, fit.swapped, slope);
  const Vec<Rational, 3> offset = rounded_point<3>(t, accuracy.exponent() - 1);
  ExactNet<3> result(net.size());
  for (std::size_t i = 0; i < net.size() / 2; ++i) {
    Vec<Real, 3> b = net.points[2 * i + fit.swapped];
    add_scaled(b, slope / (Real(1) + slope * slope), cone_error(net, fit.swapped, slope, t, i));
    result[2 * i + fit.swapped] = rounded_point<3>(b, accuracy.exponent());
    result[2 * i + 1 - fit.swapped] = sum(scaled(alpha, result[2 * i + fit.swapped]), offset);
  }
  return result;
}

}  // namespace

Candidate<3> cone_candidate(const RealNet<3>& net) {
  const ConeFit fit = cone_fit(net);
  return {.squared = fit.squared, .realise = [&net, fit] { return realise_cone(net, fit); }};
}

}  // namespace torse::repair
