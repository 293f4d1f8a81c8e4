// Reads a problem a line and prints the answer of the library's templates with exact rationals: the other side of
// main.ml.
#include <iostream>

#include "torse/developable/closed_forms.hpp"
#include "torse/proofs/coq/compare/problem.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Function = Answer (*)(const Problem&);

Answer blossom_value(const Problem& p) {
  const auto c = p.spline<3>();
  std::vector<Parameter<Q>> v;
  for (const Vec<Q, 2>& x : p.points<2>("v")) v.push_back({x[0], x[1]});
  return Answer() << blossom<Q, Point3>(c.knots, c.points(), p.integer("k"), v);
}

/// The row d of FJ07.13 by one of the library's routes from d_i.
template <class Net>
Answer row(const Problem& p, Net net) {
  const auto c = p.spline<3>();
  return Answer() << net(c.knots, c.points(), p.number("L"), p.number("M"), p.integer("i"), p.point<3>("d"));
}

/// One vertex of FJ07.13 by a closed form.
template <class Form>
Answer vertex(const Problem& p, Form form) {
  const auto c = p.spline<3>();
  return Answer() << form(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"), p.integer("i"));
}

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> table{
      {"knots", [](const Problem& p) { return p.knots(), Answer(); }},
      {"blossom", blossom_value},
      {"point",
       [](const Problem& p) {
         const auto c = p.spline<3>();
         return Answer() << curve_point(c.knots, c.points(), p.integer("k"), p.number("t"));
       }},
      {"derivative",
       [](const Problem& p) {
         const auto c = p.spline<3>();
         return Answer() << curve_derivative(c.knots, c.points(), p.integer("k"), p.number("t"));
       }},
      {"net",
       [](const Problem& p) {
         const auto c = p.spline<3>();
         return Answer() << linear_net<Q, Point3>(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"));
       }},
      {"net_from", [](const Problem& p) { return row(p, net_from<Q, Point3>); }},
      {"printed_net", [](const Problem& p) { return row(p, printed_net<Q, Point3>); }},
      {"eq14", [](const Problem& p) { return vertex(p, eq14<Q, Point3>); }},
      {"eq15", [](const Problem& p) { return vertex(p, eq15<Q, Point3>); }},
      {"eq16", [](const Problem& p) { return vertex(p, eq16<Q, Point3>); }},
  };
  return table;
}

std::string solve(const std::string& line) {
  const Problem problem(line);
  try {
    return functions().at(problem.name())(problem).text();
  } catch (const InvalidInput& e) {
    return "error " + e.place();
  } catch (const DivisionByZero&) {
    return "error division";
  }
}

}  // namespace
}  // namespace torse::compare

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << torse::compare::solve(line) << '\n';
}
