// Short numbers and witnesses as text.
#include "torse/exact/decide/words.hpp"

#include <cmath>
#include <cstdio>

namespace torse {

std::string short_number(const Rational& x) {
  constexpr std::size_t longest_bits = 80;
  if (x.numerator_bits() + x.denominator_bits() <= longest_bits) return x.text();
  const double value = x.to_double();
  if (!std::isnormal(value)) {
    const long exponent = static_cast<long>(x.numerator_bits()) - static_cast<long>(x.denominator_bits());
    return std::string("about ") + (x.sign() < 0 ? "-" : "") + "2^" + std::to_string(exponent);
  }
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "about %.6g", value);
  return buffer;
}

std::string describe(const DevelopabilityWitness<Rational>& witness, const KnotList<Rational>& knots) {
  return "piece " + std::to_string(witness.piece) + ", u from " + short_number(knots.piece_begin(witness.piece)) +
         " to " + short_number(knots.piece_end(witness.piece)) + ": coefficient " +
         std::to_string(witness.coefficient) + " of the determinant is " + short_number(witness.value);
}

}  // namespace torse
