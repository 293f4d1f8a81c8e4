// Knot lists in the papers' convention: degree n, control vertices 0..L, knots u_0..u_{L+n-1}, pieces k = 1..N with
// N = L-n+1 and piece k on [u_{n+k-2}, u_{n+k-1}]. CAD systems carry one superfluous knot more at either end.
//   KnotList<S>            the checked list
//   bezier_knots           n knots a, n knots b: one Bezier piece on [a, b]
//   KnotList::from_list    a list of either convention, told apart by its length
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torse/scalar/concepts.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// A knot list of degree n >= 1 in the papers' convention. Invariants: L + n knots with L >= n; no knot is decidedly
/// smaller than its predecessor (ordered fields); u_i and u_{i+n} are not decidedly equal, so a knot is repeated at
/// most n times; the domain [u_{n-1}, u_L] is not decidedly empty.
template <Field S>
class KnotList {
 public:
  /// Takes the papers' list u_0..u_{L+n-1}. Throws InvalidInput naming "degree" or "knots[i]".
  KnotList(int degree, std::vector<S> knots) : KnotList(degree, std::move(knots), 0) {}

  /// Takes a list for control vertices 0..last in the papers' convention (last + degree knots) or the CAD one (two
  /// more, the first and the last of which are dropped), told apart by its length. Throws InvalidInput, which counts
  /// the knots of the list as it was given.
  static KnotList from_list(int degree, int last, std::vector<S> knots) {
    const std::size_t papers = static_cast<std::size_t>(last + degree);
    if (knots.size() != papers && knots.size() != papers + 2) {
      throw InvalidInput("knots", "expected " + std::to_string(papers) + " (papers' list) or " +
                                      std::to_string(papers + 2) + " (CAD list) for degree " + std::to_string(degree) +
                                      " and " + std::to_string(last + 1) + " control points, found " +
                                      std::to_string(knots.size()));
    }
    const int outer = knots.size() == papers ? 0 : 1;
    return KnotList(degree, std::move(knots), outer);
  }

  /// The CAD list: the first and the last knot once more.
  std::vector<S> cad_list() const {
    std::vector<S> list;
    list.reserve(u_.size() + 2);
    list.push_back(u_.front());
    list.insert(list.end(), u_.begin(), u_.end());
    list.push_back(u_.back());
    return list;
  }

  /// The degree n.
  int degree() const { return degree_; }
  /// The index L of the last control vertex.
  int last() const { return static_cast<int>(u_.size()) - degree_; }
  /// The number N of pieces, empty ones included.
  int pieces() const { return last() - degree_ + 1; }
  /// The number of knots, L + n.
  int size() const { return static_cast<int>(u_.size()); }

  /// u_i, 0 <= i < L + n.
  const S& operator[](int i) const { return u_[static_cast<std::size_t>(i)]; }
  /// The whole list.
  const std::vector<S>& list() const { return u_; }

  /// The ends of piece k, 1 <= k <= N.
  const S& piece_begin(int k) const { return (*this)[degree_ + k - 2]; }
  const S& piece_end(int k) const { return (*this)[degree_ + k - 1]; }
  /// Whether piece k has length zero.
  Truth piece_empty(int k) const { return equal(piece_begin(k), piece_end(k)); }
  /// The pieces that are not decidedly empty, in order.
  std::vector<int> proper_pieces() const {
    std::vector<int> result;
    for (int k = 1; k <= pieces(); ++k) {
      if (!definitely(piece_empty(k))) result.push_back(k);
    }
    return result;
  }

  /// The ends of the domain, u_{n-1} and u_L.
  const S& domain_begin() const { return (*this)[degree_ - 1]; }
  const S& domain_end() const { return (*this)[last()]; }

  /// Whether both ends are n-fold: u_0 = u_{n-1} and u_L = u_{L+n-1}.
  Truth clamped() const { return equal(u_.front(), domain_begin()) & equal(u_.back(), domain_end()); }

 private:
  /// `outer` more knots at either end, which have their place in the order and are dropped.
  KnotList(int degree, std::vector<S> knots, int outer) : degree_(degree), u_(std::move(knots)) {
    if (degree < 1) throw InvalidInput("degree", "expected at least 1, found " + std::to_string(degree));
    const std::size_t least = 2 * (static_cast<std::size_t>(degree) + static_cast<std::size_t>(outer));
    if (u_.size() < least) {
      throw InvalidInput("knots", "expected at least " + std::to_string(least) + " for degree " +
                                      std::to_string(degree) + ", found " + std::to_string(u_.size()));
    }
    check_order();
    u_.erase(u_.begin(), u_.begin() + outer);
    u_.erase(u_.end() - outer, u_.end());
    check_multiplicity(outer);
  }

  void check_order() const {
    if constexpr (OrderedField<S>) {
      for (int i = 1; i < size(); ++i) {
        if (definitely(less((*this)[i], (*this)[i - 1]))) {
          throw InvalidInput(
              "knots[" + std::to_string(i) + "]",
              "expected a non-decreasing list, found " + as_text((*this)[i]) + " after " + as_text((*this)[i - 1]));
        }
      }
    }
  }

  /// After `outer` knots that were dropped.
  void check_multiplicity(int outer) const {
    for (int i = 0; i < last(); ++i) {
      if (definitely(equal((*this)[i], (*this)[i + degree_]))) {
        throw InvalidInput("knots[" + std::to_string(outer + i + degree_) + "]",
                           "expected a knot at most " + std::to_string(degree_) + " times, found " +
                               as_text((*this)[i]) + " more often");
      }
    }
    if (definitely(equal(domain_begin(), domain_end()))) {
      throw InvalidInput("knots", "expected a domain of positive length, found [" + as_text(domain_begin()) + ", " +
                                      as_text(domain_end()) + "]");
    }
  }

  int degree_;
  std::vector<S> u_;
};

/// The knot list of one Bezier piece of degree n on [a, b].
template <Field S>
KnotList<S> bezier_knots(int degree, const S& a, const S& b) {
  std::vector<S> u(static_cast<std::size_t>(degree), a);
  u.insert(u.end(), static_cast<std::size_t>(degree), b);
  return KnotList<S>(degree, std::move(u));
}

/// The knot list of one Bezier piece of degree n on [0, 1].
template <Field S>
KnotList<S> bezier_knots(int degree) {
  return bezier_knots(degree, from_int<S>(0), from_int<S>(1));
}

}  // namespace torse
