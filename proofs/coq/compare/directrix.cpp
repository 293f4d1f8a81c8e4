// The library's templates for the rulings of a directrix, ZW06.
#include "torse/developable/directrix.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using P = const Problem&;

Bernstein<Q> polynomial(const Problem& p, const char* key) { return Bernstein<Q>(p.numbers(key)); }
DirectrixEquation<Q> equation(const Problem& p) { return {polynomial(p, "a"), polynomial(p, "b")}; }

/// 0 and a combination of the equations with what it gives, where they contradict each other; 1 and the rulings; 2, the
/// rulings and the family.
Answer solution(const Problem& p) {
  const auto c = p.points<3>("c");
  const DirectrixSolution<Q, Point3> found = solve_directrix<Q, Point3>(c, equation(p));
  Answer answer;
  if (found.contradiction) {
    answer << Q(0);
    const int n = static_cast<int>(c.size()) - 1;
    for (int j = 0; j <= comparison_degree(n, equation(p)); ++j) {
      answer << found.contradiction->combination.coefficient(j);
    }
    return answer << found.contradiction->value;
  }
  answer << Q(found.family ? 2 : 1) << found.tau;
  return found.family ? answer << found.family->coefficients() : answer;
}

Answer aumann(const Problem& p) {
  const DirectrixEquation<Q> found = aumann_equation(p.integer("n"), p.number("x"), p.number("s"));
  return Answer() << found.a.coefficients() << found.b.coefficients();
}

}  // namespace

const Table& of_directrices() {
  static const Table table{
      {"is_cone_equation", [](P p) { return Answer() << Q(is_cone_equation(equation(p)) == Truth::yes ? 1 : 0); }},
      {"solve_directrix", solution},
      {"times_polynomial",
       [](P p) { return Answer() << times_polynomial<Q, Point3>(polynomial(p, "b"), p.points<3>("c")); }},
      {"directrix_edge",
       [](P p) {
         return Answer() << directrix_edge<Q, Point3>(p.points<3>("c"), p.points<3>("d"), polynomial(p, "b"));
       }},
      {"directrix_vertex",
       [](P p) { return Answer() << directrix_vertex<Q, Point3>(p.points<3>("c"), p.points<3>("d"), equation(p)); }},
      {"aumann_equation", aumann},
  };
  return table;
}

}  // namespace torse::compare
