// Many elements of a prime field at once: one computation evaluates a formula at 64 random points.
//   LaneMask               one bit per lane
//   Batch                  64 residues over one modulus, some of them perhaps undefined
//   ScalarTraits<Batch>
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/exact/modular/prime.hpp"
#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// Bit i belongs to lane i.
using LaneMask = std::uint64_t;

/// 64 elements of Z/p, the lanes, in one scalar; every operation works lane by lane. A division inverts all lanes with
/// one inversion (a product tree, P. Montgomery, Math. Comp. 48 (1987), 243-264) and does not throw: a lane whose
/// divisor is zero becomes undefined and stays so in everything computed from it. Integers, and fractions of them, are
/// constants without lanes until they meet a Batch that has a modulus, and cost little. An operation between two
/// different moduli throws InvalidInput. The Modulus has to outlive its batches.
class Batch {
 public:
  static constexpr int lanes = 64;

  /// Zero.
  Batch() {}

  /// The integer `i`, of any modulus. Throws Error for i >= 2^63.
  template <std::integral T>
  explicit Batch(T i) : constant_(Constant::integer(i)) {}

  /// The batch whose lane i is the class of the integer value(i), i = 0 ... 63.
  template <std::invocable<int> Value>
  Batch(const Modulus& modulus, Value value) : modulus_(&modulus) {
    for (int i = 0; i < lanes; ++i) lane_[i] = modulus.encode(std::uint64_t{value(i)});
  }

  /// 64 uniformly random elements.
  template <WordGenerator Generator>
  static Batch draw(const Modulus& modulus, Generator& rng) {
    Batch r;
    r.modulus_ = &modulus;
    for (std::uint64_t& x : r.lane_) x = modulus.draw(rng);
    return r;
  }

  Batch(const Batch& other) { *this = other; }
  Batch& operator=(const Batch& other) {
    if (this == &other) return *this;
    modulus_ = other.modulus_;
    undefined_ = other.undefined_;
    constant_ = other.constant_;
    if (modulus_ != nullptr) std::copy_n(other.lane_, lanes, lane_);
    return *this;
  }

  /// The modulus, null for a constant that has met none.
  const Modulus* modulus() const { return modulus_; }

  /// The lanes in which a division by zero happened.
  LaneMask undefined() const { return undefined_; }

  /// The lanes that are defined and not zero.
  LaneMask nonzero() const {
    if (modulus_ == nullptr) return constant_.num != 0 ? ~undefined_ : 0;
    LaneMask mask = 0;
    for (int i = 0; i < lanes; ++i) mask |= LaneMask{lane_[i] != 0} << i;
    return mask & ~undefined_;
  }

  /// The integer in [0, p) of lane i; for batches that have a modulus, and meaningless for an undefined lane.
  std::uint64_t value(int i) const { return modulus_->decode(lane_[i]); }

  /// Yes if every defined lane is zero, no if none is; unknown otherwise, and where no lane is defined.
  Truth is_zero() const {
    const LaneMask defined = ~undefined_;
    const LaneMask others = nonzero();
    if (defined == 0 || (others != 0 && others != defined)) return Truth::unknown;
    return truth(others == 0);
  }

  /// A constant's fraction, or the first lanes, with "?" for an undefined one.
  std::string text() const;

  friend Batch operator+(const Batch& a, const Batch& b) { return combined<Plus>(a, b); }
  friend Batch operator-(const Batch& a, const Batch& b) { return combined<Minus>(a, b); }
  friend Batch operator*(const Batch& a, const Batch& b) { return combined<Times>(a, b); }
  friend Batch operator/(const Batch& a, const Batch& b) { return combined<Times>(a, b.reciprocal()); }
  friend Batch operator-(const Batch& a) { return combined<Minus>(Batch(), a); }

  Batch& operator+=(const Batch& b) { return combine<Plus>(*this, *this, b); }
  Batch& operator-=(const Batch& b) { return combine<Minus>(*this, *this, b); }
  Batch& operator*=(const Batch& b) { return combine<Times>(*this, *this, b); }
  Batch& operator/=(const Batch& b) { return combine<Times>(*this, *this, b.reciprocal()); }

  /// 1/x in every lane, undefined where x is zero.
  Batch reciprocal() const;

  /// y += a b in one pass over the lanes.
  static void add_product(Batch& y, const Batch& a, const Batch& b) {
    const Modulus* modulus = common_modulus(a.modulus_, b.modulus_);
    if (modulus == nullptr || modulus != a.modulus_ || modulus != b.modulus_ || modulus != y.modulus_) {
      y += a * b;
      return;
    }
    const Modulus m = *modulus;
    for (int i = 0; i < lanes; ++i) y.lane_[i] = m.add(y.lane_[i], m.multiply(a.lane_[i], b.lane_[i]));
    y.undefined_ |= a.undefined_ | b.undefined_;
  }

 private:
  struct Plus {
    static std::uint64_t of(const Modulus& m, std::uint64_t x, std::uint64_t y) { return m.add(x, y); }
    static Constant of(Constant x, Constant y) { return x + y; }
  };
  struct Minus {
    static std::uint64_t of(const Modulus& m, std::uint64_t x, std::uint64_t y) { return m.subtract(x, y); }
    static Constant of(Constant x, Constant y) { return x - y; }
  };
  struct Times {
    static std::uint64_t of(const Modulus& m, std::uint64_t x, std::uint64_t y) { return m.multiply(x, y); }
    static Constant of(Constant x, Constant y) { return x * y; }
  };

  /// The residue of a constant in Z/p; where p divides its denominator, every lane of `undefined` is marked.
  static std::uint64_t broadcast(const Modulus& m, Constant c, LaneMask& undefined);

  /// r = a op b; r may be a or b. The modulus is copied so that the loops keep it in registers.
  template <class Op>
  static Batch& combine(Batch& r, const Batch& a, const Batch& b) {
    const Modulus* modulus = common_modulus(a.modulus_, b.modulus_);
    LaneMask undefined = a.undefined_ | b.undefined_;
    if (modulus == nullptr) {
      r.constant_ = Op::of(a.constant_, b.constant_);
    } else if (a.modulus_ == nullptr) {
      const Modulus m = *modulus;
      const std::uint64_t x = broadcast(m, a.constant_, undefined);
      for (int i = 0; i < lanes; ++i) r.lane_[i] = Op::of(m, x, b.lane_[i]);
    } else if (b.modulus_ == nullptr) {
      const Modulus m = *modulus;
      const std::uint64_t y = broadcast(m, b.constant_, undefined);
      for (int i = 0; i < lanes; ++i) r.lane_[i] = Op::of(m, a.lane_[i], y);
    } else {
      const Modulus m = *modulus;
      for (int i = 0; i < lanes; ++i) r.lane_[i] = Op::of(m, a.lane_[i], b.lane_[i]);
    }
    r.modulus_ = modulus;
    r.undefined_ = undefined;
    return r;
  }

  template <class Op>
  static Batch combined(const Batch& a, const Batch& b) {
    Batch r;
    combine<Op>(r, a, b);
    return r;
  }

  const Modulus* modulus_ = nullptr;
  LaneMask undefined_ = 0;
  Constant constant_;
  std::uint64_t lane_[lanes];  // set once there is a modulus
};

template <>
struct ScalarTraits<Batch> {
  static constexpr std::string_view name = "(Z/p)^64";
  static constexpr bool exact = true;
  static constexpr bool decided = false;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = true;

  static Batch from_int(std::int64_t i) { return Batch(i); }
  static Truth is_zero(const Batch& x) { return x.is_zero(); }
  static std::string text(const Batch& x) { return x.text(); }
  static void add_product(Batch& y, const Batch& a, const Batch& b) { Batch::add_product(y, a, b); }
};

}  // namespace torse
