// Deterministic random numbers: the same seed gives the same cases on every machine and compiler.
//   Bounded       bounded integers and chances out of an engine's 64 random bits
//   Rng           Bounded on std::mt19937_64: long runs from one seed
//   SplitMix      an engine that costs nothing to seed: short runs from many seeds
//   seed_of       the seed of one task from the run's seed and the task's name
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

#include "torse/scalar/int128.hpp"

namespace torse::proofs {

/// The engine without the library's distributions, whose results differ between implementations.
template <class Engine>
class Bounded {
 public:
  using result_type = std::uint64_t;

  explicit Bounded(std::uint64_t seed) : engine_(seed) {}

  static constexpr std::uint64_t min() { return 0; }
  static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }
  std::uint64_t operator()() { return engine_(); }

  /// Uniform in [0, bound) up to a bias of bound / 2^64.
  std::uint64_t below(std::uint64_t bound) {
    return static_cast<std::uint64_t>((static_cast<uint128>(engine_()) * bound) >> 64);
  }
  /// Uniform in [lo, hi].
  std::int64_t between(std::int64_t lo, std::int64_t hi) {
    return lo + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(hi - lo) + 1));
  }
  /// True once in `times`.
  bool once_in(std::uint64_t times) { return below(times) == 0; }

 private:
  Engine engine_;
};

using Rng = Bounded<std::mt19937_64>;

/// SplitMix64: a counter in steps of the golden ratio, its bits mixed (Steele, Lea and Flood 2014; the constants are
/// those of Stafford's variant 13).
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  std::uint64_t operator()() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

 private:
  std::uint64_t state_;
};

/// A seed for the task `name` and index `i` of a run: FNV-1a over the name, then a finaliser.
inline std::uint64_t seed_of(std::uint64_t run_seed, std::string_view name, std::uint64_t i = 0) {
  std::uint64_t h = 0xcbf29ce484222325U ^ run_seed;
  for (const char ch : name) h = (h ^ static_cast<unsigned char>(ch)) * 0x100000001b3U;
  h ^= i * 0x9e3779b97f4a7c15U;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
  return h ^ (h >> 31);
}

}  // namespace torse::proofs
