// The order of the proofs, and the exact witness.
#include "torse/exact/decide/decide.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "torse/exact/decide/evaluation.hpp"
#include "torse/exact/decide/relation.hpp"

namespace torse {
namespace {

/// The coefficients of s^{d-i} t^i for i <= limit of every entry.
template <int D>
FormMatrix<Rational, D> leading_parts(FormMatrix<Rational, D> m, int limit) {
  for (auto& row : m) {
    for (BinaryForm<Rational>& f : row) {
      BinaryForm<Rational> leading(std::min(limit, f.degree()));
      for (int i = 0; i <= leading.degree(); ++i) leading[i] = f[i];
      f = std::move(leading);
    }
  }
  return m;
}

/// The first nonzero coefficient of the determinant of piece k, which has one. Powers of t beyond a limit do not
/// contribute to the coefficients up to it.
template <int D>
DevelopabilityWitness<Rational> exact_witness(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                              std::span<const Vec<Rational, D>> d, int k) {
  const FormMatrix<Rational, D> m = span_matrix<Rational>(u, c, d, k);
  const int degree = D * (u.degree() - 1);
  for (int limit = 0;; limit = 2 * limit + 1) {
    const BinaryForm<Rational> det = form_determinant<Rational>(leading_parts<D>(m, limit));
    const std::optional<int> i = det.first_nonzero();
    if (i && *i <= limit) return {k, *i, det[*i] / binomial<Rational>(degree, *i)};
  }
}

}  // namespace

template <int D>
std::optional<DevelopabilityWitness<Rational>> find_witness_over_q(const KnotList<Rational>& u,
                                                                   std::span<const Vec<Rational, D>> c,
                                                                   std::span<const Vec<Rational, D>> d) {
  const std::size_t size = static_cast<std::size_t>(u.last()) + 1;
  if (c.size() != size || d.size() != size) {
    throw InvalidInput("points", "expected two rows of " + std::to_string(size) + " control points, found " +
                                     std::to_string(c.size()) + " and " + std::to_string(d.size()));
  }
  const std::vector<Integer> knots = integer_knots(u.list());
  RelationProver<D> relations(u.degree(), knots, c, d);
  for (const int k : u.proper_pieces()) {
    if (relations.prove(k) || PieceEvaluator<D>(u.degree(), knots, c, d, k).vanishes()) continue;
    return exact_witness<D>(u, c, d, k);
  }
  return std::nullopt;
}

template std::optional<DevelopabilityWitness<Rational>> find_witness_over_q<3>(const KnotList<Rational>&,
                                                                               std::span<const Vec<Rational, 3>>,
                                                                               std::span<const Vec<Rational, 3>>);
template std::optional<DevelopabilityWitness<Rational>> find_witness_over_q<4>(const KnotList<Rational>&,
                                                                               std::span<const Vec<Rational, 4>>,
                                                                               std::span<const Vec<Rational, 4>>);

}  // namespace torse
