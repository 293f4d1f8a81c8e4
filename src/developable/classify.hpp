// The exact class of a developable ruled spline.
//   SurfaceClass      plane, cylinder, cone, tangent, none          name_of      the word for it
//   Classification    the class with the vertex or the direction
//   classify          the smallest class that contains every piece
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/algebra/linear_system.hpp"
#include "torse/spline/basis.hpp"

namespace torse {

/// The classes of developable surfaces, and none for a surface that is not developable.
enum class SurfaceClass { plane, cylinder, cone, tangent, none };

/// The word for a class in reports.
constexpr std::string_view name_of(SurfaceClass c) {
  constexpr std::array<std::string_view, 5> names{"plane", "cylinder", "cone", "tangent", "none"};
  return names[static_cast<std::size_t>(c)];
}

/// A class with what determines it: the vertex of a cone, or the direction of a cylinder's rulings (first nonzero
/// coordinate 1). A cylinder whose rulings all have length zero has no direction.
template <Field S>
struct Classification {
  SurfaceClass kind;
  std::optional<Vec<S, 3>> vertex{};
  std::optional<Vec<S, 3>> direction{};
};

namespace detail {

/// The equations a ^ p ^ q = 0 for the common point a of all rulings of a piece: for each triple i < j < k of
/// coordinates and each coefficient of the Pluecker coordinates l_ij = p_i q_j - p_j q_i, a_i l_jk - a_j l_ik + a_k
/// l_ij = 0.
template <Field S>
void insert_incidences(Echelon<S, 4>& system, const std::array<BinaryForm<S>, 4>& p,
                       const std::array<BinaryForm<S>, 4>& q) {
  const auto l = [&](std::size_t i, std::size_t j) { return p[i] * q[j] - p[j] * q[i]; };
  for (std::size_t skip = 0; skip < 4; ++skip) {
    std::array<std::size_t, 3> t{};
    for (std::size_t i = 0, n = 0; i < 4; ++i) {
      if (i != skip) t[n++] = i;
    }
    const std::array<BinaryForm<S>, 3> opposite{l(t[1], t[2]), l(t[2], t[0]), l(t[0], t[1])};
    for (int c = 0; c <= opposite[0].degree() && system.rank() < 4; ++c) {
      Vec<S, 4> row = PointTraits<Vec<S, 4>>::zero();
      for (std::size_t i = 0; i < 3; ++i) row[static_cast<int>(t[i])] = opposite[i][c];
      system.insert(std::move(row));
    }
  }
}

/// A short proof that the rulings of a piece pass through a point, for one piece after another: seen from it the
/// control rows that act on the piece are proportional by one ratio, l P_i = m Q_i, so that the curves are.
template <Field S>
class RowsSeenFrom {
 public:
  /// A point with a coordinate 1, and two rows; the rows have to outlive this object.
  RowsSeenFrom(const Vec<S, 4>& centre, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q)
      : centre_(centre), p_(p), q_(q) {
    while (!definitely(equal(S(centre_[unit_]), from_int<S>(1)))) ++unit_;
  }

  /// Whether the rows first, ..., last are proportional. `first` does not fall from piece to piece; rows that were seen
  /// to be for the piece before are not looked at again.
  bool proportional(std::size_t first, std::size_t last) {
    end_ = std::max(end_, first);
    if (extend(last)) return true;
    ratio_.reset();
    end_ = first;
    return extend(last);
  }

 private:
  using View = std::array<S, 3>;

  View view(const Vec<S, 4>& x) const {
    View seen;
    for (int j = 0, to = 0; j < 4; ++j) {
      if (j != unit_) seen[static_cast<std::size_t>(to++)] = x[j] - x[unit_] * centre_[j];
    }
    return seen;
  }

  bool extend(std::size_t last) {
    while (end_ <= last && holds(end_)) ++end_;
    return end_ > last;
  }

  bool holds(std::size_t i) {
    const View p = view(p_[i]);
    const View q = view(q_[i]);
    for (std::size_t j = 0; j < 3 && !ratio_; ++j) {
      if (!definitely(is_zero(p[j])) || !definitely(is_zero(q[j]))) ratio_ = {q[j], p[j]};
    }
    for (std::size_t j = 0; j < 3 && ratio_; ++j) {
      if (!definitely(equal(ratio_->first * p[j], ratio_->second * q[j]))) return false;
    }
    return true;
  }

  Vec<S, 4> centre_;
  std::span<const Vec<S, 4>> p_, q_;
  int unit_ = 0;
  std::optional<std::pair<S, S>> ratio_{};  // l, m; they hold for the piece's rows before end_
  std::size_t end_ = 0;
};

}  // namespace detail

/// The class of a ruled spline with homogeneous rows p, q that is known to be developable (condition.hpp decides that;
/// for one that is not, the answer means nothing). Only control rows that act on a piece of positive length count.
///   plane      they span a space of dimension at most 3: all points lie in one plane (a line, a point)
///   cylinder   all rulings pass through one point at infinity
///   cone       all rulings pass through one finite point
///   tangent    neither: a tangent surface on some piece, or pieces of different planes, cylinders or cones
/// Where p and q are proportional for every parameter the rulings have length zero and there is no surface; such a
/// piece belongs to every class, and a spline that consists of such pieces only and is not planar counts as a cylinder
/// without a direction. If it has other rulings too and all of those lie on one line, it is a cylinder along that line.
/// Throws Undecided where the field cannot decide a zero.
template <Field S>
Classification<S> classify(const KnotList<S>& u, std::span<const Vec<S, 4>> p, std::span<const Vec<S, 4>> q) {
  const std::vector<int> pieces = u.proper_pieces();
  Echelon<S, 4> span;
  for (int k : pieces) {
    for (int i = k - 1; i < k + u.degree() && span.rank() < 4; ++i) {
      span.insert(p[static_cast<std::size_t>(i)]);
      span.insert(q[static_cast<std::size_t>(i)]);
    }
  }
  if (span.rank() < 4) return {SurfaceClass::plane};

  Echelon<S, 4> incidence;
  std::optional<detail::RowsSeenFrom<S>> centre;
  for (int k : pieces) {
    if (incidence.rank() == 4) break;
    if (incidence.rank() == 3) {
      if (!centre) centre.emplace(incidence.kernel().front(), p, q);
      const std::size_t first = static_cast<std::size_t>(k - 1);
      if (centre->proportional(first, first + static_cast<std::size_t>(u.degree()))) continue;
    }
    const std::vector<BinaryForm<S>> basis = basis_forms(u, k);
    detail::insert_incidences(incidence, piece_forms<S, 4>(basis, p, k), piece_forms<S, 4>(basis, q, k));
  }
  if (incidence.rank() == 4) return {SurfaceClass::tangent};
  if (incidence.rank() == 0) return {SurfaceClass::cylinder};

  // Two common points put all rulings that have a length on one line. The surface is not planar only if it has curves
  // of rulings without length besides; it is a cylinder along that line.
  const std::vector<Vec<S, 4>> kernel = incidence.kernel();
  Vec<S, 4> common = kernel.front();
  if (kernel.size() == 2 && !definitely(is_zero(kernel[0][0]))) {
    common = combine(S(kernel[1][0]), kernel[0], -kernel[0][0], kernel[1]);
  }
  Vec<S, 3> finite(common[1], common[2], common[3]);
  if (!definitely(is_zero(common[0]))) {
    divide(finite, S(common[0]));
    return {.kind = SurfaceClass::cone, .vertex = finite};
  }
  int first = 0;
  while (definitely(is_zero(finite[first]))) ++first;
  divide(finite, S(finite[first]));
  return {.kind = SurfaceClass::cylinder, .direction = finite};
}

}  // namespace torse
