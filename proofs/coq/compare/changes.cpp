// The library's templates for the functions of FJ21 under changes of the curves, 3.3 and section 5, and for the edge of
// regression, section 6.
#include "torse/developable/factors.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/regression.hpp"
#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using P = const Problem&;

Answer answer(const BlossomFunctions<Q>& f) { return Answer() << f.lambda << f.m << f.sigma; }

BlossomFunctions<Q> functions(const Problem& p) {
  const std::vector<Q> x = p.numbers("x");
  return {x.at(0), x.at(1), x.at(2)};
}

Linear<Q> factor(const Problem& p, const char* key) {
  const std::vector<Q> x = p.numbers(key);
  return {x.at(0), x.at(1)};
}

Answer dependence(const Problem& p) {
  const std::vector<Q> x = p.numbers("x");
  return answer(from_dependence(x.at(0), x.at(1), x.at(2), x.at(3)));
}

/// 5.3, 5.4 or the inverse of one.
template <class Map>
Answer factors(const Problem& p, Map map) {
  return answer(map(p.integer("n"), p.number("t"), functions(p), factor(p, "f"), factor(p, "g")));
}

}  // namespace

const Table& of_changes() {
  static const Table table{
      {"from_dependence", dependence},
      {"moebius_parameter", [](P p) { return Answer() << moebius_parameter(p.number("a"), p.number("t")); }},
      {"moebius_rows", [](P p) { return Answer() << moebius_rows(p.points<3>("c"), p.number("a")); }},
      {"moebius_functions", [](P p) { return answer(moebius_functions(functions(p), p.number("a"))); }},
      {"unelevated", [](P p) { return factors(p, unelevated<Q>); }},
      {"elevated_functions", [](P p) { return factors(p, elevated_functions<Q>); }},
      {"unshortened", [](P p) { return factors(p, unshortened<Q>); }},
      {"shortened_functions", [](P p) { return factors(p, shortened_functions<Q>); }},
      {"times_linear", [](P p) { return Answer() << times_linear(p.points<3>("c"), factor(p, "f")); }},
      {"edge_curve", [](P p) { return Answer() << edge_curve(p.points<3>("c"), p.points<3>("d"), functions(p)); }},
      {"edge_patch", [](P p) { return Answer() << edge_patch(p.points<3>("c"), p.number("x")); }},
  };
  return table;
}

}  // namespace torse::compare
