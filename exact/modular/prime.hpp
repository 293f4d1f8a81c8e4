// Word-size primes and arithmetic modulo one of them in Montgomery form.
//   is_prime                  deterministic for every 64-bit integer
//   Modulus                   an odd prime between 2^61 and 2^63 and the operations on its residues
//   common_modulus            of two operands
//   random_prime              uniform among the primes in [2^61, 2^62)
//   prime_count_lower_bound   how many those are, at least
#pragma once

#include <concepts>
#include <cstdint>
#include <random>

#include "torse/exact/modular/constant.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// Whether n is prime: Miller-Rabin to the first twelve prime bases, which is a proof below 3.18e23 (J. Sorenson and
/// J. Webster, Strong pseudoprimes to twelve prime bases, Math. Comp. 86 (2017), 985-1003).
bool is_prime(std::uint64_t n);

/// A prime p, 2^61 < p < 2^63, and arithmetic on residues in Montgomery form: x stands for x 2^64 mod p, always reduced
/// to [0, p). Immutable; elements point to their modulus, which has to outlive them.
class Modulus {
 public:
  /// Throws InvalidInput unless p is a prime between 2^61 and 2^63.
  explicit Modulus(std::uint64_t p);

  /// The prime.
  std::uint64_t prime() const { return p_; }

  /// The residue that stands for 1.
  std::uint64_t one() const { return one_; }

  /// a b / 2^64 mod p (P. Montgomery, Modular multiplication without trial division, Math. Comp. 44 (1985), 519-521):
  /// ab - p (ab/p mod 2^64) is a multiple of 2^64 and its high word lies in (-p, p).
  std::uint64_t multiply(std::uint64_t a, std::uint64_t b) const {
    const uint128 product = uint128{a} * b;
    const std::uint64_t quotient = static_cast<std::uint64_t>(product) * inverse_of_p_;
    const auto high = static_cast<std::uint64_t>(product >> 64);
    const auto reduction = static_cast<std::uint64_t>((uint128{quotient} * p_) >> 64);
    const std::uint64_t difference = high - reduction;
    return high < reduction ? difference + p_ : difference;
  }

  std::uint64_t add(std::uint64_t a, std::uint64_t b) const {
    const std::uint64_t sum = a + b;
    return sum >= p_ ? sum - p_ : sum;
  }

  std::uint64_t subtract(std::uint64_t a, std::uint64_t b) const { return a < b ? a - b + p_ : a - b; }

  std::uint64_t negate(std::uint64_t a) const { return a == 0 ? 0 : p_ - a; }

  /// 1/a as a^(p-2). Throws DivisionByZero for a = 0.
  std::uint64_t inverse(std::uint64_t a) const;

  /// The residue of an integer below 2^64.
  std::uint64_t encode(std::uint64_t x) const { return multiply(x % p_, square_of_r_); }

  /// The residue of a fraction. Throws DivisionByZero where p divides its denominator.
  std::uint64_t encode(Constant c) const;

  /// The integer in [0, p) that a residue stands for.
  std::uint64_t decode(std::uint64_t a) const { return multiply(a, 1); }

  /// A residue drawn uniformly from all p of them.
  template <class Generator>
  std::uint64_t draw(Generator& rng) const;

  friend bool operator==(const Modulus& a, const Modulus& b) { return a.p_ == b.p_; }

 private:
  std::uint64_t p_;
  std::uint64_t inverse_of_p_;  // p * inverse_of_p_ = 1 mod 2^64
  std::uint64_t one_;           // 2^64 mod p
  std::uint64_t square_of_r_;   // 2^128 mod p
};

/// The modulus of an operation between elements of Z/a and Z/b, where null stands for a constant without a modulus.
/// Throws InvalidInput for two different moduli.
inline const Modulus* common_modulus(const Modulus* a, const Modulus* b) {
  if (a == nullptr || a == b) return b;
  if (b != nullptr && !(*a == *b)) throw InvalidInput("modulus", "operands belong to different prime fields");
  return a;
}

/// A generator of all 64-bit words, such as std::mt19937_64. The distributions of the standard library are not used:
/// their results differ between implementations.
template <class G>
concept WordGenerator = std::uniform_random_bit_generator<G> && G::min()
== 0 && G::max() == ~std::uint64_t{0};

template <class Generator>
std::uint64_t Modulus::draw(Generator& rng) const {
  static_assert(WordGenerator<Generator>);
  constexpr std::uint64_t mask = (std::uint64_t{1} << 63) - 1;
  std::uint64_t x = rng() & mask;
  while (x >= p_) x = rng() & mask;
  return x;
}

/// A prime drawn uniformly from those in [2^61, 2^62).
template <WordGenerator Generator>
Modulus random_prime(Generator& rng) {
  constexpr std::uint64_t least = std::uint64_t{1} << 61;
  std::uint64_t p = 0;
  while (!is_prime(p)) p = least | (rng() & (least - 1));
  return Modulus(p);
}

/// A lower bound on the number of primes in [2^61, 2^62). By J. B. Rosser and L. Schoenfeld, Approximate formulas for
/// some functions of prime numbers, Illinois J. Math. 6 (1962), Theorem 2,
///   pi(2^62) - pi(2^61) > 2^62/(62 log 2 - 1/2) - 2^61/(61 log 2 - 3/2) > 5.2e16.
/// (The number itself, by computer, is 54042323540385838.) An integer of b bits has at most b/61 prime factors in this
/// interval, so a random prime of it divides a given nonzero one with probability at most (b/61) / this bound.
constexpr std::uint64_t prime_count_lower_bound = 52'000'000'000'000'000;

}  // namespace torse
