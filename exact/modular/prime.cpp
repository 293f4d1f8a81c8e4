// Primality, and the set-up and inversion of a modulus.
#include "torse/exact/modular/prime.hpp"

#include <bit>
#include <string>

namespace torse {
namespace {

std::uint64_t multiply_mod(std::uint64_t a, std::uint64_t b, std::uint64_t n) {
  return static_cast<std::uint64_t>(uint128{a} * b % n);
}

std::uint64_t power_mod(std::uint64_t a, std::uint64_t e, std::uint64_t n) {
  std::uint64_t result = 1;
  for (a %= n; e != 0; e >>= 1) {
    if (e & 1) result = multiply_mod(result, a, n);
    a = multiply_mod(a, a, n);
  }
  return result;
}

/// Whether odd n > base passes the strong probable-prime test to the base.
bool is_strong_probable_prime(std::uint64_t n, std::uint64_t base) {
  const int twos = std::countr_zero(n - 1);
  std::uint64_t x = power_mod(base, (n - 1) >> twos, n);
  if (x == 1 || x == n - 1) return true;
  for (int i = 1; i < twos; ++i) {
    x = multiply_mod(x, x, n);
    if (x == n - 1) return true;
  }
  return false;
}

/// 1/p mod 2^64 for odd p by Newton's iteration: p itself is right to three bits, each step doubles them.
std::uint64_t inverse_mod_word(std::uint64_t p) {
  std::uint64_t x = p;
  for (int bits = 3; bits < 64; bits *= 2) x *= 2 - p * x;
  return x;
}

}  // namespace

bool is_prime(std::uint64_t n) {
  constexpr std::uint64_t bases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  if (n < 2) return false;
  for (const std::uint64_t q : bases) {
    if (n % q == 0) return n == q;
  }
  for (const std::uint64_t base : bases) {
    if (!is_strong_probable_prime(n, base)) return false;
  }
  return true;
}

Modulus::Modulus(std::uint64_t p) : p_(p) {
  if (p >> 61 == 0 || p >> 63 != 0 || !is_prime(p)) {
    throw InvalidInput("modulus", std::to_string(p) + " is not a prime between 2^61 and 2^63");
  }
  inverse_of_p_ = inverse_mod_word(p);
  one_ = static_cast<std::uint64_t>((uint128{1} << 64) % p);
  square_of_r_ = multiply_mod(one_, one_, p);
}

std::uint64_t Modulus::inverse(std::uint64_t a) const {
  if (a == 0) throw DivisionByZero();
  std::uint64_t result = one_;
  for (std::uint64_t e = p_ - 2; e != 0; e >>= 1) {
    if (e & 1) result = multiply(result, a);
    a = multiply(a, a);
  }
  return result;
}

std::uint64_t Modulus::encode(Constant c) const {
  const auto word = static_cast<std::uint64_t>(c.num);  // modulo 2^64
  const std::uint64_t num = c.num < 0 ? negate(encode(0 - word)) : encode(word);
  return c.den == 1 ? num : multiply(num, inverse(encode(static_cast<std::uint64_t>(c.den))));
}

}  // namespace torse
