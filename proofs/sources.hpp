// Where the engines' inputs come from.
//   FractionSource<S>    fractions for an exact ordered field: generic, or hostile (small, coinciding, repeated knots)
//   DyadicSource<S>      short dyadic numbers, the same in every arithmetic that holds 24 bits
//   FieldSource<S>       every parameter drawn by one function: prime fields, indeterminates, degrees
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "torse/proofs/claim.hpp"
#include "torse/proofs/random.hpp"

namespace torse::proofs {

/// How unkind a source is.
enum class Temper {
  generic,   ///< numerators and denominators of 30 bits, strictly increasing knots
  small,     ///< small fractions, one in six equal to an earlier one
  clamped,   ///< small, with n-fold end knots
  repeated,  ///< small, with repeated knots, one in six values equal to an earlier one or to a knot
};
inline constexpr int tempers = 4;

/// The 0-based multiplicity pattern of a knot list: steps that are positive (true) or zero, such that no knot is
/// repeated more than n times and the domain is not empty.
inline std::vector<bool> knot_steps(Rng& rng, Size size, Temper temper) {
  const int count = size.last() + size.n;
  std::vector<bool> steps(static_cast<std::size_t>(count), true);  // steps[i]: u_i > u_{i-1}
  int run = 1;
  bool domain_moved = false;
  for (int i = 1; i < count; ++i) {
    bool moves = true;
    if (temper == Temper::clamped) moves = i >= size.n && i <= size.last();
    if (temper == Temper::repeated) moves = !rng.once_in(3);
    const bool inside = i >= size.n && i <= size.last();
    if (run >= size.n || (i == size.last() && !domain_moved)) moves = true;
    run = moves ? 1 : run + 1;
    domain_moved = domain_moved || (inside && moves);
    steps[static_cast<std::size_t>(i)] = moves;
  }
  return steps;
}

/// Random fractions.
template <ExactField S>
class FractionSource : public Source<S> {
 public:
  FractionSource(std::uint64_t seed, Temper temper) : rng_(seed), temper_(temper) {}

  S scalar() override {
    if (temper_ != Temper::generic && !seen_.empty() && rng_.once_in(6)) return seen_[rng_.below(seen_.size())];
    seen_.push_back(temper_ == Temper::generic ? fraction(-(1 << 30), 1 << 30, 1 << 30) : fraction(-20, 20, 6));
    return seen_.back();
  }
  S positive() override { return temper_ == Temper::generic ? fraction(1, 1 << 30, 1 << 30) : fraction(1, 20, 6); }

  std::vector<S> knots(Size size) override {
    std::vector<S> u;
    for (const bool moves : knot_steps(rng_, size, temper_)) {
      if (u.empty()) {
        u.push_back(scalar());
      } else {
        u.push_back(moves ? u.back() + positive() : u.back());
      }
    }
    if (temper_ == Temper::repeated) seen_.insert(seen_.end(), u.begin(), u.end());
    return u;
  }

 private:
  S fraction(std::int64_t lo, std::int64_t hi, std::int64_t denominators) {
    return ratio<S>(rng_.between(lo, hi), rng_.between(1, denominators));
  }

  Rng rng_;
  Temper temper_;
  std::vector<S> seen_;
};

/// Multiples of 2^-10 below 2^6 in absolute value: 17 bits, so that knots and inputs are exact in float and the same
/// seed gives the same input in every arithmetic. Balls may be widened through `wrap`.
template <class S>
class DyadicSource : public Source<S> {
 public:
  explicit DyadicSource(std::uint64_t seed, std::function<S(S)> wrap = {}) : rng_(seed), wrap_(std::move(wrap)) {}

  S scalar() override { return make(rng_.between(-(1 << 16), 1 << 16)); }
  S positive() override { return make(rng_.between(1, 1 << 14)); }
  std::vector<S> knots(Size size) override {
    std::vector<S> u;
    std::int64_t at = rng_.between(-(1 << 12), 1 << 12);
    for (int i = 0; i < size.last() + size.n; ++i) {
      u.push_back(make(at));
      at += rng_.between(1 << 6, 1 << 13);
    }
    return u;
  }

 private:
  S make(std::int64_t k) {
    S x = from_int<S>(k) / from_int<S>(1 << 10);
    return wrap_ ? wrap_(std::move(x)) : x;
  }

  Rng rng_;
  std::function<S(S)> wrap_;
};

/// Every free parameter, knots included, comes from one function of its index.
template <class S>
class FieldSource : public Source<S> {
 public:
  explicit FieldSource(std::function<S(int)> next) : next_(std::move(next)) {}

  S scalar() override { return next_(count_++); }
  S positive() override { return scalar(); }
  std::vector<S> knots(Size size) override {
    std::vector<S> u;
    for (int i = 0; i < size.last() + size.n; ++i) u.push_back(scalar());
    return u;
  }

  /// How many parameters were drawn.
  int count() const { return count_; }

 private:
  std::function<S(int)> next_;
  int count_ = 0;
};

}  // namespace torse::proofs
