// error: (no matching function|constraint)
// A ring is no field: an algorithm that divides says so in its concept.
#include <cstdint>
#include <string>
#include <string_view>

#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/concepts.hpp"

struct Integer {
  std::int64_t value = 0;

  friend Integer operator+(Integer a, Integer b) { return {a.value + b.value}; }
  friend Integer operator-(Integer a, Integer b) { return {a.value - b.value}; }
  friend Integer operator*(Integer a, Integer b) { return {a.value * b.value}; }
  friend Integer operator-(Integer a) { return {-a.value}; }
  Integer& operator+=(Integer b) { return *this = *this + b; }
  Integer& operator-=(Integer b) { return *this = *this - b; }
  Integer& operator*=(Integer b) { return *this = *this * b; }
};

template <>
struct torse::ScalarTraits<Integer> {
  static constexpr std::string_view name = "Z";
  static constexpr bool exact = true;
  static constexpr bool decided = true;
  static constexpr bool ordered = true;
  static constexpr bool prefers_reciprocal = false;
  static Integer from_int(std::int64_t i) { return {i}; }
  static Truth is_zero(const Integer& x) { return truth(x.value == 0); }
  static Truth less(const Integer& x, const Integer& y) { return truth(x.value < y.value); }
  static std::string text(const Integer& x) { return std::to_string(x.value); }
};

static_assert(torse::Ring<Integer> && !torse::Field<Integer>);

template <torse::Field S>
S half(const S& x) {
  return x / torse::from_int<S>(2);
}

#ifdef TORSE_MISUSE
const Integer x = half(Integer{4});  // misuse
#else
const torse::Rational x = half(torse::Rational(4));
#endif
