// Step 1 of Algorithm 1 of BZZ19 in rounded arithmetic: the parameters at which a mapping passes the knots of C2.
//   inner_values          the knots of C2 that sigma passes
//   with_preimages        sigma with a knot at each of those parameters
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "torse/quasi/surface.hpp"

namespace torse {

/// The different knots of C2 strictly between the values of sigma at the ends of its domain, in order.
template <OrderedField S>
std::vector<S> inner_values(const Mapping<S>& sigma, const KnotList<S>& of_c2) {
  const S low = mapping_value(sigma, sigma.knots.domain_begin());
  const S high = mapping_value(sigma, sigma.knots.domain_end());
  std::vector<S> list;
  for (const S& value : of_c2.list()) {
    if (!definitely(less(low, value)) || !definitely(less(value, high))) continue;
    if (list.empty() || definitely(less(list.back(), value))) list.push_back(value);
  }
  return list;
}

namespace detail {

/// One of the parameters where sigma has this value but for rounding.
template <std::floating_point S>
std::optional<S> parameter_of_value(const Mapping<S>& sigma, const std::vector<S>& list, S value) {
  const S rounding = value_rounding(sigma);
  for (const S& t : list) {
    const S missing = mapping_value(sigma, t) - value;
    if (-rounding <= missing && missing <= rounding) return t;
  }
  return std::nullopt;
}

/// Where the increasing sigma passes the value, by bisection down to neighbouring numbers.
template <std::floating_point S>
S bisected(const Mapping<S>& sigma, S value) {
  S a = sigma.knots.domain_begin();
  S b = sigma.knots.domain_end();
  for (S t = a + (b - a) / 2; a < t && t < b; t = a + (b - a) / 2) (mapping_value(sigma, t) < value ? a : b) = t;
  return b;
}

}  // namespace detail

/// The increasing mapping with a knot wherever it passes a knot of C2. Where a knot of sigma or of C1 has that value
/// but for the rounding of sigma's values it is taken, so that no piece is as short as a rounding error. In exact
/// arithmetic these parameters are irrational in general: see `snapped` (exact/quasi/snap.hpp).
template <std::floating_point S>
Mapping<S> with_preimages(const Mapping<S>& sigma, const KnotList<S>& of_c1, const KnotList<S>& of_c2) {
  const std::vector<S> old = breakpoints(sigma.knots, of_c1);
  Mapping<S> fine = sigma;
  for (const S& value : inner_values(sigma, of_c2)) {
    const std::optional<S> known = detail::parameter_of_value(sigma, old, value);
    const S t = known ? *known : detail::bisected(sigma, value);
    if (std::ranges::find(fine.knots.list(), t) == fine.knots.list().end()) fine = insert_knot(fine, t);
  }
  return fine;
}

}  // namespace torse
