// Short numbers and witnesses as text.
#include "torse/exact/decide/words.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace torse {
namespace {

std::string formatted(const char* format, int digits, double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, digits, x);
  return buffer;
}

double read(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// The nearest decimal number with so many digits, one unit of its last digit further.
std::string next_decimal(double x, int digits, int direction) {
  const std::string scientific = formatted("%.*e", 16, x);
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  return formatted("%.*g", digits,
                   read(formatted("%.*g", digits, x)) + direction * std::pow(10.0, exponent + 1 - digits));
}

}  // namespace

std::string decimal_above(double x, int digits) {
  const std::string nearest = formatted("%.*g", digits, x);
  return read(nearest) >= x ? nearest : next_decimal(x, digits, 1);
}

std::string decimal_below(double x, int digits) {
  const std::string nearest = formatted("%.*g", digits, x);
  return read(nearest) <= x ? nearest : next_decimal(x, digits, -1);
}

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
