// A short proof that a piece is developable: a constant relation between its two rows.
//   RelationProver<D>     finds and checks such relations, D = 3: points, D = 4: homogeneous rows
//
// Let (a : w) and (a' : w') be homogeneous parameters, not both zero, with
//   (w v_{i+n} - a) c_i + (a - w v_i) c_{i+1} = (w' v_{i+n} - a') d_i + (a' - w' v_i) d_{i+1}
// for the n cells i = k-1 ... k+n-2 of piece k: the blossoms c[.., (a : w)] and d[.., (a' : w')] of degree n-1 agree
// at the knots that determine them, so they agree everywhere (FJ07.13 and FJ21.7.1 with L* = a/w, M* = a'/w', sigma =
// w'/w). On the diagonal this is a relation between c_0^{n-1}, c_1^{n-1}, d_0^{n-1} and d_1^{n-1} that is not trivial,
// so the determinant of the piece vanishes. Cones and most developable nets in use have one; cylinders and nets of
// raised degree need not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/decide/integer.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// Proves pieces of one surface. A candidate comes from the residues modulo one prime, by rational reconstruction: it
/// is found where its numbers have up to 31 bits. The proof is its exact check in every cell.
template <int D>
class RelationProver {
 public:
  /// The prime of the candidates.
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 63) - 25;

  /// The degree n, the knots as integers and the control points; all of them have to outlive this object.
  RelationProver(int degree, const std::vector<Integer>& knots, std::span<const Vec<Rational, D>> c,
                 std::span<const Vec<Rational, D>> d)
      : degree_(static_cast<std::size_t>(degree)), knots_(knots), c_(c), d_(d) {}

  /// Whether a relation for piece k was found and holds. Cheapest for one piece after another: neighbours tend to share
  /// their relation, and cells that it was checked for are not checked again.
  bool prove(int k);

 private:
  /// a, w, a', w'.
  using Relation = std::array<Integer, 4>;

  std::optional<Relation> candidate(std::size_t first) const;
  bool holds(std::size_t cell);

  std::size_t degree_;
  const std::vector<Integer>& knots_;
  std::span<const Vec<Rational, D>> c_;
  std::span<const Vec<Rational, D>> d_;
  std::optional<Relation> relation_;  // checked in the cells from begin_ to before end_
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

extern template class RelationProver<3>;
extern template class RelationProver<4>;

}  // namespace torse
