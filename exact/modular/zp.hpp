// One element of a prime field.
//   Zp                  a residue and its modulus, or a constant that adopts the modulus of what it meets
//   ScalarTraits<Zp>
#pragma once

#include <concepts>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "torse/exact/modular/prime.hpp"
#include "torse/scalar/errors.hpp"
#include "torse/scalar/traits.hpp"

namespace torse {

/// An element of Z/p. Integers, and fractions of them, are built without a modulus and kept exactly (as a Constant);
/// the first operation with an element of some Z/p takes them there. Until then they are compared as rational numbers.
/// An operation between two different moduli throws InvalidInput. The Modulus has to outlive its elements.
class Zp {
 public:
  /// Zero.
  Zp() = default;

  /// The integer `i`, of any modulus. Throws Error for i >= 2^63.
  template <std::integral T>
  explicit Zp(T i) : constant_(Constant::integer(i)) {}

  /// The class of the integer x modulo the prime.
  Zp(const Modulus& modulus, std::uint64_t x) : modulus_(&modulus), residue_(modulus.encode(x)) {}

  /// A uniformly random element.
  template <WordGenerator Generator>
  static Zp draw(const Modulus& modulus, Generator& rng) {
    Zp r;
    r.modulus_ = &modulus;
    r.residue_ = modulus.draw(rng);
    return r;
  }

  /// The modulus, null for a constant that has met none.
  const Modulus* modulus() const { return modulus_; }

  /// The integer in [0, p) of this class; for elements that have a modulus.
  std::uint64_t value() const { return modulus_->decode(residue_); }

  /// Whether this is zero, in Z/p or, for a constant, in Q.
  bool is_zero() const { return modulus_ != nullptr ? residue_ == 0 : constant_.num == 0; }

  /// The integer in [0, p), or the fraction a constant is.
  std::string text() const { return modulus_ != nullptr ? std::to_string(value()) : constant_.text(); }

  friend Zp operator+(const Zp& a, const Zp& b) {
    const Modulus* m = common_modulus(a.modulus_, b.modulus_);
    return m != nullptr ? Zp(m, m->add(a.in(*m), b.in(*m))) : Zp(a.constant_ + b.constant_);
  }
  friend Zp operator-(const Zp& a, const Zp& b) {
    const Modulus* m = common_modulus(a.modulus_, b.modulus_);
    return m != nullptr ? Zp(m, m->subtract(a.in(*m), b.in(*m))) : Zp(a.constant_ - b.constant_);
  }
  friend Zp operator*(const Zp& a, const Zp& b) {
    const Modulus* m = common_modulus(a.modulus_, b.modulus_);
    return m != nullptr ? Zp(m, m->multiply(a.in(*m), b.in(*m))) : Zp(a.constant_ * b.constant_);
  }
  /// Throws DivisionByZero for b = 0.
  friend Zp operator/(const Zp& a, const Zp& b) {
    const Modulus* m = common_modulus(a.modulus_, b.modulus_);
    return m != nullptr ? Zp(m, m->multiply(a.in(*m), m->inverse(b.in(*m)))) : Zp(a.constant_ / b.constant_);
  }
  friend Zp operator-(const Zp& a) {
    return a.modulus_ != nullptr ? Zp(a.modulus_, a.modulus_->negate(a.residue_)) : Zp(-a.constant_);
  }

  Zp& operator+=(const Zp& b) { return *this = *this + b; }
  Zp& operator-=(const Zp& b) { return *this = *this - b; }
  Zp& operator*=(const Zp& b) { return *this = *this * b; }
  Zp& operator/=(const Zp& b) { return *this = *this / b; }

 private:
  explicit Zp(Constant c) : constant_(c) {}
  Zp(const Modulus* modulus, std::uint64_t residue) : modulus_(modulus), residue_(residue) {}

  /// The residue modulo the common modulus m.
  std::uint64_t in(const Modulus& m) const { return modulus_ != nullptr ? residue_ : m.encode(constant_); }

  const Modulus* modulus_ = nullptr;
  std::uint64_t residue_ = 0;
  Constant constant_;
};

template <>
struct ScalarTraits<Zp> {
  static constexpr std::string_view name = "Z/p";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = false;
  static constexpr bool prefers_reciprocal = true;

  static Zp from_int(std::int64_t i) { return Zp(i); }
  static Truth is_zero(const Zp& x) { return truth(x.is_zero()); }
  static std::string text(const Zp& x) { return x.text(); }
};

}  // namespace torse
