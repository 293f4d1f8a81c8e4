// Integer coefficients by GMP.
#include "torse/cli/function_report.hpp"
#include "torse/exact/decide/words.hpp"

#include <gmp.h>

#include <algorithm>
#include <cstdint>

#include "torse/cli/terminal.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Longer texts of functions are not for a terminal.
constexpr std::size_t longest_text = 80;
/// Up to 2^53 every reader of JSON keeps an integer.
constexpr std::size_t longest_bits = 53;

/// The number p/q with q the greatest common divisor of all numerators and p the least common multiple of all
/// denominators; 1 where all coefficients are zero.
Rational clearing_factor(const std::vector<RationalPolynomial>& polynomials) {
  mpq_t factor;
  mpq_init(factor);
  mpz_set_ui(mpq_numref(factor), 1);
  mpz_set_ui(mpq_denref(factor), 0);
  for (const RationalPolynomial& f : polynomials) {
    for (const Rational& x : f.coefficients()) {
      mpz_lcm(mpq_numref(factor), mpq_numref(factor), mpq_denref(x.mpq()));
      mpz_gcd(mpq_denref(factor), mpq_denref(factor), mpq_numref(x.mpq()));
    }
  }
  if (mpz_sgn(mpq_denref(factor)) == 0) mpz_set_ui(mpq_denref(factor), 1);
  const Rational result = Rational::from_mpq(factor);
  mpq_clear(factor);
  return result;
}

Json integer_json(const Rational& x) {
  if (x.numerator_bits() > longest_bits) return x.text();
  return static_cast<std::int64_t>(x.to_double());
}

std::string polynomial_words(const RationalPolynomial& f) {
  std::string text = as_text(f);
  for (std::size_t at = text.find(" t"); at != std::string::npos; at = text.find(" t", at + 1)) {
    if (at > 0 && text[at - 1] >= '0' && text[at - 1] <= '9') text.erase(at, 1);
  }
  return text;
}

}  // namespace

std::vector<RationalPolynomial> integer_coefficients(const std::vector<RationalPolynomial>& polynomials) {
  const Rational factor = clearing_factor(polynomials);
  std::vector<RationalPolynomial> result = polynomials;
  for (RationalPolynomial& f : result) f.scale(factor);
  return result;
}

Json coefficients_json(const RationalPolynomial& f) {
  if (f.zero()) return Json::array({0});
  Json list = Json::array();
  for (const Rational& x : f.coefficients()) list.push_back(integer_json(x));
  return list;
}

Json function_json(const std::optional<RationalFunctionOfT>& f) {
  if (!f) return nullptr;
  const std::vector<RationalPolynomial> parts = integer_coefficients({f->numerator(), f->denominator()});
  return {{"num", coefficients_json(parts[0])}, {"den", coefficients_json(parts[1])}};
}

std::string function_text(const RationalFunctionOfT& f) {
  if (const std::optional<Rational> value = f.constant_value()) return short_number(*value);
  const std::vector<RationalPolynomial> parts = integer_coefficients({f.numerator(), f.denominator()});
  const auto in_brackets = [](const std::string& text) {
    return text.find(' ') == std::string::npos ? text : '(' + text + ')';
  };
  const std::string below = polynomial_words(parts[1]);
  std::string text = polynomial_words(parts[0]);
  if (below != "1") text = in_brackets(text) + '/' + in_brackets(below);
  if (text.size() <= longest_text) return text;
  return "[degree " + std::to_string(f.numerator().degree()) + '/' + std::to_string(f.denominator().degree()) + ']';
}

}  // namespace torse::cli
