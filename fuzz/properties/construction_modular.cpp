#include "torse/exact/modular/batch.hpp"
#include "torse/exact/modular/zp.hpp"
#include "torse/fuzz/properties/agreement.hpp"
#include "torse/proofs/random.hpp"

namespace torse::fuzz {
namespace {

Modulus modulus_of(const Construction::In& in) {
  proofs::Rng rng(static_cast<std::uint64_t>(in.prime));
  return random_prime(rng);
}

template <class S>
S residue(const Modulus& modulus, std::uint64_t x) {
  if constexpr (std::same_as<S, Zp>) {
    return Zp(modulus, x);
  } else {
    return Batch(modulus, [x](int) { return x; });
  }
}

/// x modulo the prime, in every lane of a batch. Throws Discard where the prime divides the denominator.
template <class S>
S lifted(const Modulus& modulus, std::uint64_t prime, const Rational& x) {
  const std::uint64_t below = mpz_fdiv_ui(mpq_denref(x.mpq()), prime);
  if (below == 0) throw Discard("the prime divides a denominator");
  return residue<S>(modulus, mpz_fdiv_ui(mpq_numref(x.mpq()), prime)) / residue<S>(modulus, below);
}

/// The ingredients in Z/p or in a batch.
template <class S>
Ingredients<S> in_field(const Construction::In& in, const Modulus& modulus) {
  const std::uint64_t prime = modulus.prime();
  return ingredients<S>(in.input, [&](const Rational& x) { return lifted<S>(modulus, prime, x); });
}

}  // namespace

void require_in_prime_field(const Construction::In& in, const SurfaceOver<Rational>& exact) {
  const Modulus modulus = modulus_of(in);
  const auto surface = construct<Zp>(in.input.method, in_field<Zp>(in, modulus));
  const auto agrees = [&](const Zp& x, const Rational& y) {
    return definitely(equal(x, lifted<Zp>(modulus, modulus.prime(), y)));
  };
  require_same_numbers(surface, exact, agrees);
  require_no_witness(surface);
}

/// Lane i has Lambda + i, and lane prime % 64 is compared with the same in Z/p.
void require_in_batch(const Construction::In& in, const SurfaceOver<Rational>& exact) {
  const Modulus modulus = modulus_of(in);
  Ingredients<Batch> all = in_field<Batch>(in, modulus);
  Ingredients<Zp> one = in_field<Zp>(in, modulus);
  const int lane = in.prime % Batch::lanes;
  all.lambda += Batch(modulus, [](int i) { return static_cast<std::uint64_t>(i); });
  one.lambda += Zp(modulus, static_cast<std::uint64_t>(lane));
  const auto surface = construct<Batch>(in.input.method, all);
  const auto single = construct<Zp>(in.input.method, one);
  // Constants have no modulus of their own.
  const Batch zeros = residue<Batch>(modulus, 0);
  const Zp zero(modulus, 0);
  for (std::size_t i = 0; i < single.d.size(); ++i) {
    for (int j = 0; j < 4; ++j) {
      const Batch x = surface.d[i][j] + zeros;
      require(x.value(lane) == (single.d[i][j] + zero).value(), "a lane that is not what Z/p computes");
      require(x.value(0) == lifted<Zp>(modulus, modulus.prime(), exact.d[i][j]).value(), "lane 0 is not the fraction");
    }
  }
  require_no_witness(surface);
}

}  // namespace torse::fuzz
