// The one place where the program asks the oracle.
#include "torse/cli/judge.hpp"

#include "torse/exact/decide/decide.hpp"

namespace torse::cli {
namespace {

std::string point_text(const Vec<Rational, 3>& x) {
  return '(' + short_number(x[0]) + ", " + short_number(x[1]) + ", " + short_number(x[2]) + ')';
}

}  // namespace

Judgement judge(const RuledFile<Rational>& surface) {
  using Row = Vec<Rational, 4>;
  const std::vector<Row> p = homogeneous(surface.c);
  const std::vector<Row> q = homogeneous(surface.d);
  const bool polynomial = unit_weights(surface.c) && unit_weights(surface.d);
  std::optional<DevelopabilityWitness<Rational>> witness =
      polynomial ? find_witness_over_q<3>(surface.knots, surface.c.points, surface.d.points)
                 : find_witness_over_q<4>(surface.knots, p, q);
  if (witness) return {{SurfaceClass::none}, std::move(witness)};
  return {classify<Rational>(surface.knots, p, q), std::nullopt};
}

std::string describe(const Classification<Rational>& classification) {
  std::string text(name_of(classification.kind));
  if (classification.vertex) text += ", vertex " + point_text(*classification.vertex);
  if (classification.direction) text += ", direction " + point_text(*classification.direction);
  return text;
}

}  // namespace torse::cli
