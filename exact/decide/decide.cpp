// The loop over blocks of primes, and the exact witness.
#include "torse/exact/decide/decide.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "torse/exact/decide/bound.hpp"
#include "torse/exact/decide/lane_surface.hpp"
#include "torse/exact/decide/relation.hpp"

namespace torse {
namespace {

/// A piece whose determinant vanished modulo all primes so far, and the bits that these primes still have to supply.
struct OpenPiece {
  int piece;
  long bits;
};

/// The first coefficient that does not vanish modulo some prime, be it a valid lane or not.
std::optional<int> first_nonzero(const std::vector<Lanes>& coefficients) {
  const auto at = std::ranges::find_if(coefficients, [](const Lanes& x) { return PrimeLanes::nonzero(x) != 0; });
  if (at == coefficients.end()) return std::nullopt;
  return static_cast<int>(at - coefficients.begin());
}

/// The first nonzero coefficient of the determinant of piece k, which is not later than `limit`: higher powers of t do
/// not contribute to it.
template <int D>
DevelopabilityWitness<Rational> exact_witness(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                              std::span<const Vec<Rational, D>> d, int k, int limit) {
  FormMatrix<Rational, D> m = span_matrix<Rational>(u, c, d, k);
  for (auto& row : m) {
    for (BinaryForm<Rational>& f : row) {
      BinaryForm<Rational> leading(std::min(limit, f.degree()));
      for (int i = 0; i <= leading.degree(); ++i) leading[i] = f[i];
      f = std::move(leading);
    }
  }
  const BinaryForm<Rational> det = form_determinant<Rational>(m);
  int i = 0;
  while (det[i].sign() == 0) ++i;
  return {k, i, det[i] / binomial<Rational>(D * (u.degree() - 1), i)};
}

}  // namespace

template <int D>
std::optional<DevelopabilityWitness<Rational>> find_witness_modular(const KnotList<Rational>& u,
                                                                    std::span<const Vec<Rational, D>> c,
                                                                    std::span<const Vec<Rational, D>> d) {
  const std::size_t size = static_cast<std::size_t>(u.last()) + 1;
  if (c.size() != size || d.size() != size) {
    throw InvalidInput("points", "expected two rows of " + std::to_string(size) + " control points, found " +
                                     std::to_string(c.size()) + " and " + std::to_string(d.size()));
  }
  const std::vector<Integer> knots = integer_knots(u.list());
  std::vector<OpenPiece> open;
  RelationProver<D> relations(u.degree(), knots, c, d);
  for (const int k : u.proper_pieces()) {
    if (relations.prove(k)) continue;
    const long bits = determinant_bits<D>(u, knots, c, d, k);
    if (bits > 0) open.push_back({k, bits});
  }

  // Only pieces before the first refuted one stay open.
  int refuted = 0;
  int coefficient = 0;
  for (std::size_t block = 0; !open.empty(); ++block) {
    const LaneSurface<D> surface(PrimeLanes::block(block), u.degree(), knots, c, d);
    for (std::size_t i = 0; i < open.size(); ++i) {
      const auto det = surface.determinant(open[i].piece);
      if (const std::optional<int> nonzero = first_nonzero(det.coefficients)) {
        refuted = open[i].piece;
        coefficient = *nonzero;
        open.resize(i);
      } else {
        open[i].bits -= PrimeLanes::bits_per_prime * std::popcount(det.valid);
      }
    }
    std::erase_if(open, [](const OpenPiece& piece) { return piece.bits <= 0; });
  }
  if (refuted == 0) return std::nullopt;
  return exact_witness<D>(u, c, d, refuted, coefficient);
}

template std::optional<DevelopabilityWitness<Rational>> find_witness_modular<3>(const KnotList<Rational>&,
                                                                                std::span<const Vec<Rational, 3>>,
                                                                                std::span<const Vec<Rational, 3>>);
template std::optional<DevelopabilityWitness<Rational>> find_witness_modular<4>(const KnotList<Rational>&,
                                                                                std::span<const Vec<Rational, 4>>,
                                                                                std::span<const Vec<Rational, 4>>);

}  // namespace torse
