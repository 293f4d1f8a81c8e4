// The library's templates for mappings and for the warp of a ruling, BZZ19.
#include "torse/developable/warp.hpp"
#include "torse/proofs/coq/compare/tables.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using P = const Problem&;

/// sin^2 of the warp angle. Throws DivisionByZero for an empty piece, which has no points.
Answer sine(const Problem& p) {
  const auto c = p.spline<3>();
  const auto d = p.spline<3>("d");
  const int k = p.integer("k");
  if (definitely(c.knots.piece_empty(k))) throw DivisionByZero();
  return Answer() << pointwise_sine_squared<Q>(c.knots, c.points(), d.points(), k, p.number("t"));
}

Answer slope(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << derivative_sum(c.knots, c.points(), p.integer("k"), p.number("t"));
}

}  // namespace

const Table& of_mappings() {
  static const Table table{
      {"mapping_value", [](P p) { return Answer() << mapping_value(p.spline<1>(), p.number("t")); }},
      {"mapping_slope", [](P p) { return Answer() << mapping_slope(p.spline<1>(), p.number("t")); }},
      {"identity_mapping", [](P p) { return Answer() << identity_mapping(p.knots()).control; }},
      {"derivative_sum", slope},
      {"pointwise_sine_squared", sine},
  };
  return table;
}

}  // namespace torse::compare
