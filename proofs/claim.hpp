// A claim is one numbered statement of a paper, written once and run in every arithmetic.
//   ClaimInfo        id, source, statement, hypotheses, mutants: what a reader needs to know
//   Source<S>        where a claim's free parameters come from: an engine's generator
//   Equations<S>     what a claim asserts of one input: sides that must agree, values that must vanish or be positive
//   Size             degree n and number of pieces N
//   Mutant           0 for the claim itself, i for its i-th wrong variant
//   Takes            the inputs of a claim that shares them with others
// A claim is a struct C with
//   static const ClaimInfo& info();
//   static constexpr PointKind points; static constexpr int dimension;
//   template <class S, class P> struct In;                      free parameters only: equations hold by construction
//   template <class S, class P> static In<S, P> draw(Source<S>&, Size);
//   template <class S, class P> static NonZero<S> nonzero(const In<S, P>&);         one entry per hypothesis, in order
//   template <class S, class P> static void residual(const In<S, P>&, Mutant, Equations<S>&);
//   template <class S, class P> static std::vector<Failure<In<S, P>>> failures();   optional: hypotheses are needed
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/algebra/free_module.hpp"
#include "torse/algebra/point.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::proofs {

/// What a claim says.
enum class Kind { identity, equivalence, inequality, example };

/// How a claim touches points. `linear`: every equation is linear in the points, so it may be proved over a free module
/// whose generators are the control points, or for one coordinate. `coplanar`: it ends in the dependence of points.
/// `space`: it needs coordinates.
enum class PointKind { linear, coplanar, space };

/// The size of an instance: degree n, number of pieces N, last control index L = n + N - 1.
struct Size {
  int n;
  int pieces;

  int last() const { return n + pieces - 1; }
  friend bool operator==(const Size&, const Size&) = default;
};

/// A hypothesis "this is not zero" in words; `stated` tells whether the paper states it.
struct Hypothesis {
  std::string_view words;
  bool stated = true;
};

/// What a reader needs to know of a claim.
struct ClaimInfo {
  std::string_view id;         ///< "FJ07.16"
  std::string_view source;     ///< "equation (16)"
  std::string_view title;      ///< a few words
  std::string_view statement;  ///< LaTeX
  Kind kind = Kind::identity;
  std::vector<Hypothesis> hypotheses;     ///< in the order of nonzero()
  std::vector<std::string_view> mutants;  ///< the wrong variants 1, 2, ...
  int min_degree = 1;
  int max_degree = 64;
  int max_pieces = 64;           ///< 1 for a statement about one Bezier piece
  std::string_view remark = {};  ///< what the paper omits or gets wrong, in words

  /// "FJ07" of "FJ07.16".
  std::string_view paper() const { return id.substr(0, id.find('.')); }
};

/// Each hypothesis as a list of factors, none of which may be zero.
template <class S>
using NonZero = std::vector<std::vector<S>>;

/// 0 for the claim as it is, i >= 1 for its i-th wrong variant.
class Mutant {
 public:
  explicit Mutant(int index = 0) : index_(index) {}
  /// Whether this is wrong variant i.
  bool is(int i) const { return index_ == i; }
  int index() const { return index_; }

 private:
  int index_;
};

/// An input that violates hypothesis `hypothesis` (an index) and no other, and for which the claim fails.
template <class In>
struct Failure {
  std::size_t hypothesis;
  In in;
};

/// Where the free parameters of a claim come from.
template <class S>
class Source {
 public:
  virtual ~Source() = default;
  /// A generic element.
  virtual S scalar() = 0;
  /// A generic element that is positive in an ordered field.
  virtual S positive() = 0;
  /// The L + n knots of the papers' list for degree n and N pieces: non-decreasing in an ordered field, none more than
  /// n times.
  virtual std::vector<S> knots(Size size) = 0;

  /// A generic point: D coordinates, or the next generator of a free module.
  template <class P>
  P point() {
    if constexpr (requires { P::generator(0); }) {
      return P::generator(generators_++);
    } else {
      P x;
      for (int i = 0; i < static_cast<int>(x.size()); ++i) x[i] = scalar();
      return x;
    }
  }
  /// `count` generic points.
  template <class P>
  std::vector<P> points(int count) {
    std::vector<P> row;
    for (int i = 0; i < count; ++i) row.push_back(point<P>());
    return row;
  }

 private:
  int generators_ = 0;
};

/// One thing asserted: lhs = rhs.
template <class S>
struct Equation {
  S lhs;
  S rhs;
};

/// What a claim asserts of one input.
template <class S>
class Equations {
 public:
  void equal(const S& lhs, const S& rhs) { equations_.push_back({lhs, rhs}); }
  void zero(const S& value) { equal(value, from_int<S>(0)); }
  void zero(const std::vector<S>& values) {
    for (const S& value : values) zero(value);
  }
  void positive(const S& value) { positive_.push_back(value); }

  template <int D>
  void equal(const Vec<S, D>& lhs, const Vec<S, D>& rhs) {
    for (int i = 0; i < D; ++i) equal(lhs[i], rhs[i]);
  }
  void equal(const Form<S>& lhs, const Form<S>& rhs) {
    const Form<S> rest = difference(lhs, rhs);
    if (rest.terms().empty()) zero(from_int<S>(0));
    for (const auto& term : rest.terms()) zero(term.coefficient);
  }
  template <class P>
  void equal(const std::vector<P>& lhs, const std::vector<P>& rhs) {
    if (lhs.size() != rhs.size()) throw InvalidInput("equation", "sides of different length");
    for (std::size_t i = 0; i < lhs.size(); ++i) equal(lhs[i], rhs[i]);
  }

  const std::vector<Equation<S>>& list() const { return equations_; }
  const std::vector<S>& positives() const { return positive_; }

 private:
  std::vector<Equation<S>> equations_;
  std::vector<S> positive_;
};

/// In and draw of a claim whose free parameters are an Input<S, P>, which draws itself.
template <template <class, class> class Input>
struct Takes {
  template <class S, class P>
  using In = Input<S, P>;
  template <class S, class P>
  static In<S, P> draw(Source<S>& from, Size size) {
    return Input<S, P>::draw(from, size);
  }
};

}  // namespace torse::proofs
