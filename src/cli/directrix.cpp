// torse construct directrix: rulings through a Bezier curve, ZW06.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "torse/cli/construct_methods.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/developable/directrix.hpp"
#include "torse/exact/decide/words.hpp"

namespace torse::cli {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;

/// Longer lists end in "..." on the terminal.
constexpr std::size_t shown = 12;

std::string point_text(const Point3& x) {
  return fmt::format("({}, {}, {})", short_number(x[0]), short_number(x[1]), short_number(x[2]));
}

template <class T, class Text>
std::string list_text(const std::vector<T>& items, Text text) {
  std::string list;
  for (std::size_t i = 0; i < items.size() && i < shown; ++i) list += (i == 0 ? "" : ", ") + text(items[i]);
  return items.size() > shown ? fmt::format("{}, ... ({} in all)", list, items.size()) : list;
}

std::string polynomial_text(const Bernstein<Q>& f) { return '[' + list_text(f.coefficients(), short_number) + ']'; }

/// "0 = (1, 2, 3) is 2 times equation 0 plus -1 times equation 3".
std::string contradiction_text(const Contradiction<Q, Point3>& contradiction, int degree) {
  const auto term_text = [](const Form<Q>::Term& term) {
    return fmt::format("{} times equation {}", short_number(term.coefficient), term.generator);
  };
  return fmt::format(
      "no rulings: equation j compares the coefficients of B_j of degree {} in c' = a tau + b tau', and\n"
      "{}\nadd up to 0 = {}",
      degree, list_text(contradiction.combination.terms(), term_text), point_text(contradiction.value));
}

/// The vector v that the file picks from the family tau + kappa v.
Point3 pick(const ConstructFile<Q>& input, const std::vector<Point3>& tau, const Bernstein<Q>& kappa) {
  if (input.v) return *input.v;
  const std::string family =
      "the solutions are tau + kappa v for any vector v, kappa with the Bernstein coefficients " +
      polynomial_text(kappa);
  if (!input.d0) {
    throw InvalidInput("a", fmt::format("{}: expected \"v\"{}, found neither", family,
                                        kappa[0].sign() == 0 ? "" : " or \"d0\" = c_0 + v"));
  }
  const Point3 first = sum(input.c.points.front(), tau.front());
  if (kappa[0].sign() == 0) {
    throw InvalidInput("d0", fmt::format("{}: none of them moves d_0 = {}; expected \"v\"", family, point_text(first)));
  }
  Point3 v = difference(*input.d0, first);
  divide(v, kappa[0]);
  return v;
}

/// The class by a - b', with its vertex or its edge of regression.
std::string class_note(const ConstructFile<Q>& input, const std::vector<Point3>& tau,
                       const DirectrixEquation<Q>& equation) {
  if (definitely(is_cone_equation(equation))) {
    return "a = b': a cone with vertex " + point_text(directrix_vertex<Q, Point3>(input.c.points, tau, equation));
  }
  const std::vector<Point3> edge = directrix_edge<Q, Point3>(input.c.points, tau, equation.b);
  return fmt::format("a != b': tangents of the edge of regression c - b tau, of degree {}, with the Bezier points\n{}",
                     edge.size() - 1, list_text(edge, point_text));
}

}  // namespace

Construction directrix(const ConstructFile<Rational>& input) {
  const DirectrixEquation<Q> equation{Bernstein<Q>(input.a), Bernstein<Q>(input.b)};
  if (input.d0 && input.v) throw InvalidInput("v", "expected \"d0\" or \"v\", found both");
  require_directrix(input);
  DirectrixSolution<Q, Point3> solution = solve_directrix<Q, Point3>(input.c.points, equation);
  if (solution.contradiction) {
    throw NoSolution(contradiction_text(*solution.contradiction, comparison_degree(input.knots.degree(), equation)));
  }
  std::vector<std::string> notes;
  if (solution.family) {
    const Point3 v = pick(input, solution.tau, *solution.family);
    for (std::size_t i = 0; i < solution.tau.size(); ++i) {
      add_scaled(solution.tau[i], (*solution.family)[static_cast<int>(i)], v);
    }
    notes.push_back("a family of rulings tau + kappa v, kappa with the Bernstein coefficients " +
                    polynomial_text(*solution.family) + "; v = " + point_text(v));
  } else {
    const char* given = input.d0 ? "d0" : "v";
    if (input.d0 || input.v) throw InvalidInput(given, "the equation has one solution, there is nothing to choose");
    notes.push_back("one solution");
  }
  notes.push_back(class_note(input, solution.tau, equation));
  WeightedPoints<Q, 3> d = input.c;
  for (std::size_t i = 0; i < d.points.size(); ++i) add(d.points[i], solution.tau[i]);
  return {{input.knots, input.c, std::move(d)}, std::move(notes)};
}

}  // namespace torse::cli
