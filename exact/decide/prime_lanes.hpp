// Arithmetic modulo several word primes side by side, for multi-modular decisions.
//   Lanes          one residue for each prime of a block
//   PrimeLanes     a block of primes just above 2^62; + - * and the residues of big integers
#pragma once

#include <gmp.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "torse/scalar/int128.hpp"

namespace torse {

/// The number of primes of a block. The processor works on the lanes at the same time: one lane's multiplication waits
/// longer for its result than it occupies the multiplier.
inline constexpr std::size_t prime_lanes = 4;

/// One residue for each prime of a block, in Montgomery form: x stands for x 2^64 mod p, reduced to [0, p).
using Lanes = std::array<std::uint64_t, prime_lanes>;

/// One bit for each lane.
using LaneSet = unsigned;
inline constexpr LaneSet all_lanes = (LaneSet{1} << prime_lanes) - 1;

/// The `prime_lanes` primes of one block and arithmetic modulo each of them (P. Montgomery, Modular multiplication
/// without trial division, Math. Comp. 44 (1985), 519-521). Blocks live as long as the program and may be shared by
/// threads.
class PrimeLanes {
 public:
  /// Every prime of every block exceeds 2^62 and lies below 2^63.
  static constexpr long bits_per_prime = 62;

  /// Block i >= 0: the primes number i prime_lanes, i prime_lanes + 1, ... above 2^62. Found on first use, then kept.
  static const PrimeLanes& block(std::size_t i);

  std::uint64_t prime(std::size_t lane) const { return p_[lane]; }

  Lanes add(const Lanes& a, const Lanes& b) const {
    return each([&](std::size_t k) { return reduced(a[k] + b[k], k); });
  }
  Lanes subtract(const Lanes& a, const Lanes& b) const {
    return each([&](std::size_t k) { return a[k] < b[k] ? a[k] - b[k] + p_[k] : a[k] - b[k]; });
  }
  /// a b; a may be any word, b is reduced.
  Lanes multiply(const Lanes& a, const Lanes& b) const {
    return each([&](std::size_t k) { return product(a[k], b[k], k); });
  }
  /// y += a b.
  void add_product(Lanes& y, const Lanes& a, const Lanes& b) const {
    for (std::size_t k = 0; k < prime_lanes; ++k) y[k] = reduced(y[k] + product(a[k], b[k], k), k);
  }
  /// y -= a b.
  void subtract_product(Lanes& y, const Lanes& a, const Lanes& b) const {
    for (std::size_t k = 0; k < prime_lanes; ++k) y[k] = reduced(y[k] + (p_[k] - product(a[k], b[k], k)), k);
  }

  /// The residues of a word.
  Lanes word(std::uint64_t x) const {
    return each([&](std::size_t k) { return product(x, square_of_r_[k], k); });
  }

  /// 2^(64 (j + 1)) for j = 0 ... most: what `integer` needs for integers of up to `most` limbs.
  std::vector<Lanes> powers(std::size_t most) const;

  /// The residues of an integer, by division from its lowest limb upwards: with X_j the lowest j limbs and
  /// X_j = -carry 2^(64 j) mod p, the next carry is the high word of p times (limb - carry) / p mod 2^64.
  Lanes integer(mpz_srcptr x, const std::vector<Lanes>& powers) const {
    const std::size_t size = mpz_size(x);
    const mp_limb_t* limbs = mpz_limbs_read(x);
    Lanes carry{};
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < prime_lanes; ++k) {
        const std::uint64_t rest = limbs[j] - carry[k];
        const std::uint64_t borrow = limbs[j] < carry[k];
        carry[k] = high_word(rest * inverse_of_p_[k], p_[k]) + borrow;
      }
    }
    const Lanes opposite = multiply(carry, powers[size]);
    return mpz_sgn(x) < 0 ? opposite : subtract(Lanes{}, opposite);
  }

  /// The lanes where x is not zero.
  static LaneSet nonzero(const Lanes& x) {
    LaneSet set = 0;
    for (std::size_t k = 0; k < prime_lanes; ++k) set |= LaneSet{x[k] != 0} << k;
    return set;
  }

 private:
  explicit PrimeLanes(const Lanes& primes);

  static std::uint64_t high_word(std::uint64_t a, std::uint64_t b) {
    return static_cast<std::uint64_t>((uint128{a} * b) >> 64);
  }
  std::uint64_t reduced(std::uint64_t sum, std::size_t k) const { return sum >= p_[k] ? sum - p_[k] : sum; }
  std::uint64_t product(std::uint64_t a, std::uint64_t b, std::size_t k) const {
    const uint128 full = uint128{a} * b;
    const auto high = static_cast<std::uint64_t>(full >> 64);
    const std::uint64_t reduction = high_word(static_cast<std::uint64_t>(full) * inverse_of_p_[k], p_[k]);
    return high < reduction ? high - reduction + p_[k] : high - reduction;
  }
  template <class F>
  static Lanes each(F f) {
    Lanes r;
    for (std::size_t k = 0; k < prime_lanes; ++k) r[k] = f(k);
    return r;
  }

  Lanes p_;
  Lanes inverse_of_p_;  // p inverse_of_p_ = 1 mod 2^64
  Lanes square_of_r_;   // 2^128 mod p
};

}  // namespace torse
