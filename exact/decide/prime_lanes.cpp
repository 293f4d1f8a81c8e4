// The table of primes, and what depends on a block alone.
#include "torse/exact/decide/prime_lanes.hpp"

#include <flint/flint.h>
#include <flint/ulong_extras.h>

#include <deque>
#include <mutex>

namespace torse {

const PrimeLanes& PrimeLanes::block(std::size_t i) {
  static std::mutex mutex;
  static std::deque<PrimeLanes> blocks;  // a deque: references to its elements last
  static std::uint64_t last = std::uint64_t{1} << bits_per_prime;
  const std::lock_guard lock(mutex);
  while (blocks.size() <= i) {
    blocks.push_back(PrimeLanes(each([](std::size_t) { return last = n_nextprime(last, 1); })));
  }
  return blocks[i];
}

PrimeLanes::PrimeLanes(const Lanes& primes) : p_(primes) {
  for (std::size_t k = 0; k < prime_lanes; ++k) {
    std::uint64_t inverse = p_[k];  // right to three bits for every odd p; each step of Newton's iteration doubles them
    for (int bits = 3; bits < 64; bits *= 2) inverse *= 2 - p_[k] * inverse;
    inverse_of_p_[k] = inverse;
    const auto r = static_cast<std::uint64_t>((uint128{1} << 64) % p_[k]);
    square_of_r_[k] = static_cast<std::uint64_t>(uint128{r} * r % p_[k]);
  }
}

std::vector<Lanes> PrimeLanes::powers(std::size_t most) const {
  std::vector<Lanes> list{square_of_r_};
  while (list.size() <= most) list.push_back(multiply(list.back(), square_of_r_));
  return list;
}

}  // namespace torse
