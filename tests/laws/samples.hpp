// Samples of a scalar for the laws.
//   Samples<S>            what the laws draw; specialise it where the default is too tame for an arithmetic
//   DyadicSamples<S>      the default: small k/8 and powers of two, with which no floating-point operation rounds
//   FractionSamples<S>    fractions of small and large integers, for exact fields
#pragma once

#include <cstdint>
#include <random>

#include "torse/scalar/concepts.hpp"

namespace torse::laws {

using Rng = std::mt19937_64;

/// A uniform integer in [low, high].
inline std::int64_t integer(Rng& rng, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(rng() % static_cast<std::uint64_t>(high - low + 1));
}

template <class S>
struct DyadicSamples {
  /// How often a law is tried.
  static constexpr int rounds = 200;
  /// Equality of equal elements is a decided yes.
  static constexpr bool decided = true;
  /// Dividing by zero throws DivisionByZero.
  static constexpr bool throws_on_zero = ScalarTraits<S>::exact;

  /// Any element; zero and one are not rare.
  static S any(Rng& rng) { return ratio<S>(integer(rng, -16, 16), 8); }

  /// An invertible element, such that dividing by it does not round.
  static S unit(Rng& rng) { return ratio<S>((rng() % 2 == 0 ? 1 : -1) * (std::int64_t{1} << integer(rng, 0, 5)), 8); }
};

template <class S>
struct FractionSamples : DyadicSamples<S> {
  static S any(Rng& rng) {
    const std::int64_t size = rng() % 2 == 0 ? 3 : std::int64_t{1} << 40;
    const S small = ratio<S>(integer(rng, -size, size), integer(rng, 1, size));
    return rng() % 4 == 0 ? small * small * ratio<S>(integer(rng, 1, 1 << 20), 3) * small : small;
  }

  static S unit(Rng& rng) {
    const S x = any(rng);
    return definitely(is_zero(x)) ? from_int<S>(1) : x;
  }
};

template <class S>
struct Samples : DyadicSamples<S> {};

}  // namespace torse::laws
