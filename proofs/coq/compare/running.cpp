// The library's running error analysis, bit for bit: the other side of doubles.ml.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "torse/exact/instrumented/running_error.hpp"
#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

using P = const Problem&;

/// The class has no way to set a bound, as a program has no use for one.
RunningError running(P p, const char* key) {
  const std::vector<std::string> bits = p.words(key);
  return std::bit_cast<RunningError>(std::array<std::uint64_t, 2>{std::stoull(bits.at(0)), std::stoull(bits.at(1))});
}

std::string text(double x) { return std::isnan(x) ? "nan" : std::to_string(std::bit_cast<std::uint64_t>(x)); }

Answer answer(const RunningError& x) {
  Answer result;
  if (!std::isfinite(x.bound())) result << "error";
  return result << text(x.value()) << text(x.bound());
}

Answer decided(Truth t) { return Answer() << (t == Truth::yes ? "yes" : t == Truth::no ? "no" : "error unknown"); }

using Scalar = ScalarTraits<RunningError>;

}  // namespace

const Table& of_running() {
  static const Table table{
      {"running_sum", [](P p) { return answer(running(p, "x") + running(p, "y")); }},
      {"running_difference", [](P p) { return answer(running(p, "x") - running(p, "y")); }},
      {"running_product", [](P p) { return answer(running(p, "x") * running(p, "y")); }},
      {"running_quotient", [](P p) { return answer(running(p, "x") / running(p, "y")); }},
      {"running_opposite", [](P p) { return answer(-running(p, "x")); }},
      {"running_root", [](P p) { return answer(Scalar::sqrt(running(p, "x"))); }},
      {"running_number",
       [](P p) {
         return answer(
             RunningError::from_double(std::bit_cast<double>(std::uint64_t{std::stoull(p.words("x").at(0))})));
       }},
      {"running_integer", [](P p) { return answer(Scalar::from_int(std::stoll(p.words("x").at(0)))); }},
      {"running_is_zero", [](P p) { return decided(Scalar::is_zero(running(p, "x"))); }},
      {"running_less", [](P p) { return decided(Scalar::less(running(p, "x"), running(p, "y"))); }},
  };
  return table;
}

}  // namespace torse::compare
