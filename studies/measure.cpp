#include "torse/studies/measure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "torse/developable/warp.hpp"
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/studies/bound.hpp"

namespace torse::studies {
namespace {

using Q = Rational;

Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

/// The exponent e of 2^e <= |x| < 2^(e+1), x not zero.
int exponent_of(const Q& x) {
  const int guess = static_cast<int>(x.numerator_bits()) - static_cast<int>(x.denominator_bits());
  Q power(1);
  for (int i = 0; i < std::abs(guess); ++i) power *= Q(2);
  if (guess < 0) power = Q(1) / power;
  return magnitude(x) < power ? guess - 1 : guess;
}

/// x 2^k as a double.
double shifted(const Q& x, int k) { return std::ldexp(x.to_double(), k); }

/// What all routes of a problem share.
struct Exact {
  std::vector<Q> values;
  std::vector<Q> moved;                      ///< sum_k |t_k dx_i/dt_k|
  std::vector<std::vector<double>> weighed;  ///< t_k dx_i/dt_k
  Q largest;
  double condition = 0;
};

Exact exact_of(std::size_t route, const Case& in) {
  const Sensitivities s = sensitivities(route, in);
  const std::vector<float> t = numbers_of(in);
  Exact exact;
  exact.values = s.values;
  Q most;
  for (std::size_t i = 0; i < s.values.size(); ++i) {
    exact.largest = std::max(exact.largest, magnitude(s.values[i]));
    Q sum;
    std::vector<double> row;
    for (std::size_t k = 0; k < t.size(); ++k) {
      const Q part = s.derivatives[i][k] * Q::from_double(t[k]);
      sum += magnitude(part);
      row.push_back(part.to_double());
    }
    most = std::max(most, sum);
    exact.moved.push_back(std::move(sum));
    exact.weighed.push_back(std::move(row));
  }
  exact.condition = exact.largest.sign() == 0 ? 0 : (most / exact.largest).to_double();
  return exact;
}

/// The largest warp angle in the middle of the pieces, in degrees; the computed points are exact numbers here.
double warp_of(const Case& in, const std::vector<Q>& values) {
  using Wide = BigFloat<640>;
  const Inputs<Wide> inputs = lift<Wide>(in, [](float x, std::size_t) { return Wide::from_double(x); });
  std::vector<Vec<Wide, 3>> d;
  for (std::size_t i = 0; i < inputs.c.size(); ++i) {
    Vec<Wide, 3> x;
    for (std::size_t j = 0; j < 3; ++j) x[static_cast<int>(j)] = Wide::from_rational(values[3 * i + j]);
    d.push_back(x);
  }
  double most = 0;
  for (int k = 1; k <= inputs.u.pieces(); ++k) {
    const Wide t = (inputs.u.piece_begin(k) + inputs.u.piece_end(k)) / Wide(2);
    const double sine2 = pointwise_sine_squared<Wide>(inputs.u, inputs.c, d, k, t).to_double();
    if (std::isfinite(sine2)) most = std::max(most, std::asin(std::sqrt(std::min(sine2, 1.0))) * 180 / std::acos(-1.0));
  }
  return most;
}

bool has_bound(const RouteInfo& info) { return info.name.starts_with("FJ07.13.rulings"); }

/// max |x^-x| / bound.
double share_of_bound(const RouteInfo& info, const Case& in, const Exact& exact, const std::vector<Q>& errors,
                      int precision) {
  const Inputs<Q> inputs = lift<Q>(in, [](float x, std::size_t) { return Q::from_double(x); });
  const int k = inputs.u.last() * info.anchor / 2;
  const std::vector<Q> bounds =
      rulings_bound(inputs, exact.values, k, inputs.anchors[static_cast<std::size_t>(info.anchor)], precision);
  double most = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i].sign() != 0) most = std::max(most, (errors[i] / bounds[i]).to_double());
  }
  return most;
}

Measurement measured(const RouteInfo& info, const Arithmetic& scalar, std::size_t route, const Case& in,
                     const Exact& exact) {
  Measurement m;
  m.route = info.name;
  m.scalar = scalar.name;
  m.condition = exact.condition;
  const Computed computed = scalar.run(route, in);
  m.finite = computed.finite;
  if (!m.finite) return m;
  const int p = scalar.precision;
  std::vector<Q> errors;
  std::vector<double> in_units;
  Q most;
  for (std::size_t i = 0; i < exact.values.size(); ++i) {
    const Q signed_error = computed.values[i] - exact.values[i];
    in_units.push_back(shifted(signed_error, p));
    errors.push_back(magnitude(signed_error));
    const Q& error = errors.back();
    most = std::max(most, error);
    if (error.sign() == 0) continue;
    const Q& x = exact.values[i].sign() == 0 ? exact.largest : exact.values[i];
    m.ulps = std::max(m.ulps, shifted(error, p - 1 - exponent_of(x)));
    if (exact.moved[i].sign() != 0) m.conditioned = std::max(m.conditioned, shifted(error / exact.moved[i], p));
  }
  if (exact.largest.sign() != 0) m.units = shifted(most / exact.largest, p);
  m.backward = least_perturbation(exact.weighed, in_units);
  if (info.net) m.warp = warp_of(in, computed.values);
  if (has_bound(info)) m.bound = share_of_bound(info, in, exact, errors, p);
  return m;
}

}  // namespace

std::vector<Measurement> measure_case(const Case& in, const std::vector<std::string>& routes,
                                      const std::vector<std::string>& scalars) {
  std::vector<Measurement> list;
  std::map<std::pair<Problem, std::size_t>, Exact> known;
  const std::vector<RouteInfo>& infos = route_infos();
  const bool one_piece = in.last() == in.degree;
  for (const std::string& name : routes) {
    const auto info = std::ranges::find(infos, name, &RouteInfo::name);
    const std::size_t route = static_cast<std::size_t>(info - infos.begin());
    if (info->one_piece && !one_piece) continue;
    const std::pair key(info->problem, info->problem == Problem::other ? route : 0);
    const auto exact = known.contains(key) ? known.find(key) : known.emplace(key, exact_of(route, in)).first;
    for (const std::string& scalar : scalars) {
      list.push_back(measured(*info, arithmetic(scalar), route, in, exact->second));
    }
  }
  return list;
}

}  // namespace torse::studies
