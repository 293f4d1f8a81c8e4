// The constructions and determinants that an autopsy can look into, in the library's own code.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "torse/developable/condition.hpp"
#include "torse/io/construct_file.hpp"
#include "torse/studies/autopsy.hpp"
#include "torse/studies/route_table.hpp"

namespace torse::studies {
namespace {

using Q = Rational;
using P = Vec<Shadow, 3>;

/// Of (points)^2 (bits)^1.5: numbers grow with every vertex, and so does the time that each operation takes.
constexpr double most_effort = 0x1p26;
const char* const axes = "xyz";

std::string entry(const std::string& row, std::size_t i) { return row + "[" + std::to_string(i) + "]"; }

/// Throws InvalidInput naming "c.points" for so many points with such numbers that exact values would take minutes.
void require_effort(std::size_t count, const std::vector<Q>& numbers) {
  std::size_t bits = 0;
  for (const Q& x : numbers) bits = std::max(bits, x.numerator_bits() + x.denominator_bits());
  const double points = static_cast<double>(count);
  const double effort = points * points * std::pow(static_cast<double>(bits), 1.5);
  if (effort <= most_effort) return;
  throw InvalidInput("c.points", "expected a row of effort 2^26 at most for an autopsy, found 2^" +
                                     std::to_string(static_cast<int>(std::ceil(std::log2(effort)))) + ": " +
                                     std::to_string(count) + " points with numbers of " + std::to_string(bits) +
                                     " bits");
}

void add_numbers(std::vector<Q>& numbers, const WeightedPoints<Q, 3>& row) {
  for (const Vec<Q, 3>& x : row.points) numbers.insert(numbers.end(), x.begin(), x.end());
  numbers.insert(numbers.end(), row.weights.begin(), row.weights.end());
}

void require_effort(const ConstructFile<Q>& input) {
  std::vector<Q> numbers = input.knots.list();
  add_numbers(numbers, input.c);
  for (const std::optional<Q>& x : {input.lambda, input.m, input.sigma, input.omega0}) {
    if (x) numbers.push_back(*x);
  }
  if (input.d0) numbers.insert(numbers.end(), input.d0->begin(), input.d0->end());
  require_effort(input.c.points.size(), numbers);
}

void require_effort(const RuledFile<Q>& surface) {
  std::vector<Q> numbers = surface.knots.list();
  add_numbers(numbers, surface.c);
  add_numbers(numbers, surface.d);
  require_effort(surface.c.points.size(), numbers);
}

Shadow number(const std::string& name, const Q& x) { return Shadow::input(name, x); }

P point(const std::string& name, const Vec<Q, 3>& x) {
  P result;
  for (int j = 0; j < 3; ++j) result[j] = number(name + "." + axes[j], x[j]);
  return result;
}

Row<Shadow> points(const std::string& name, const std::vector<Vec<Q, 3>>& row) {
  Row<Shadow> result;
  for (std::size_t i = 0; i < row.size(); ++i) result.push_back(point(entry(name, i), row[i]));
  return result;
}

std::vector<Shadow> numbers(const std::string& name, const std::vector<Q>& list) {
  std::vector<Shadow> result;
  for (std::size_t i = 0; i < list.size(); ++i) result.push_back(number(entry(name, i), list[i]));
  return result;
}

KnotList<Shadow> knots(const KnotList<Q>& u) { return {u.degree(), numbers("u", u.list())}; }

std::vector<Result> results_of(const std::vector<Shadow>& list, const std::string& row) {
  std::vector<Result> results;
  for (std::size_t i = 0; i < list.size(); ++i) {
    results.push_back({entry(row, i / 3) + "." + axes[i % 3], list[i].number()});
  }
  return results;
}

/// Weights beside points, for rational rows.
Homogeneous<Shadow> rational_row(const std::string& name, const WeightedPoints<Q, 3>& net) {
  std::vector<Shadow> weights;
  for (std::size_t i = 0; i < net.weights.size(); ++i) weights.push_back(number(entry(name, i) + ".w", net.weights[i]));
  return homogeneous<Shadow>(points(name, net.points), weights);
}

std::vector<Result> by_route(const ConstructFile<Q>& input, const std::string& name) {
  const KnotList<Shadow> u = knots(input.knots);
  const Row<Shadow> c = points("c", input.c.points);
  const P d0 = point("d[0]", *input.d0);
  const Shadow m = number("M", *input.m);
  const Shadow lambda = input.method == "cylinder" ? m : number("L", *input.lambda);
  const Inputs<Shadow> in{u, c, {}, {}, {}, lambda, m, Shadow(1), Shadow(0), {d0, d0, d0}};
  for (const Route<Shadow>& route : route_table<Shadow>()) {
    if (route.info.name == name && route.info.problem == Problem::first) return results_of(route.run(in), "d");
  }
  throw Error(
      "--route: expected a route from d_0 (FJ07.13, FJ07.13.rulings, FJ07.13.steps, FJ07.14, FJ07.15, FJ07.16 "
      "or FJ07.18), found " +
      name);
}

std::vector<Result> rational_results(const ConstructFile<Q>& input) {
  const KnotList<Shadow> u = knots(input.knots);
  const Homogeneous<Shadow> p = rational_row("c", input.c);
  const Shadow weight = number("d[0].w", *input.omega0);
  const P d0 = scaled(weight, point("d[0]", *input.d0));
  const Homogeneous<Shadow> q =
      rational_net<Shadow, Vec<Shadow, 4>>(u, p, number("L", *input.lambda), number("M", *input.m),
                                           number("sigma", *input.sigma), {weight, d0[0], d0[1], d0[2]});
  Row<Shadow> d;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const FormulaScope<Shadow> scope("projection", "d", static_cast<int>(i));
    d.push_back(P(q[i][1] / q[i][0], q[i][2] / q[i][0], q[i][3] / q[i][0]));
  }
  return results_of(flat<Shadow>(d), "d");
}

std::vector<Result> construction(const ConstructFile<Q>& input, const std::string& route) {
  const std::string& method = input.method;
  if (method == "rational") return rational_results(input);
  if (!unit_weights(input.c)) throw Error("an autopsy of weights is there for the method rational only");
  if (method == "bspline" || method == "bezier" || (method == "cylinder" && input.m)) return by_route(input, route);
  const Row<Shadow> c = points("c", input.c.points);
  if (method == "cone") {
    const Shadow alpha = number("alpha", *input.lambda);
    return results_of(flat<Shadow>(cone_net<Shadow, P>(c, alpha, point("d[0]", *input.d0))), "d");
  }
  if (method == "tangent" && input.knots.pieces() == 1) {
    return results_of(flat<Shadow>(tangent_net<Shadow, P>(c)), "d");
  }
  throw Error("there is no autopsy of the method " + method +
              "; expected bspline, bezier, rational, cone, cylinder with M, or tangent on one piece");
}

void add_coefficients(std::vector<Result>& results, const BinaryForm<Shadow>& det, int k) {
  for (int i = 0; i <= det.degree(); ++i) {
    results.push_back({"coefficient " + std::to_string(i) + " of piece " + std::to_string(k), det[i].number()});
  }
}

std::vector<Result> determinants(const RuledFile<Q>& surface) {
  std::vector<Result> results;
  const KnotList<Shadow> u = knots(surface.knots);
  if (unit_weights(surface.c) && unit_weights(surface.d)) {
    const Row<Shadow> c = points("c", surface.c.points);
    const Row<Shadow> d = points("d", surface.d.points);
    for (const int k : u.proper_pieces()) {
      add_coefficients(results, span_determinant<Shadow>(u, std::span<const P>(c), std::span<const P>(d), k), k);
    }
    return results;
  }
  const Homogeneous<Shadow> p = rational_row("c", surface.c);
  const Homogeneous<Shadow> q = rational_row("d", surface.d);
  using Span = std::span<const Vec<Shadow, 4>>;
  for (const int k : u.proper_pieces()) add_coefficients(results, span_determinant<Shadow>(u, Span(p), Span(q), k), k);
  return results;
}

}  // namespace

Autopsy autopsy_of(const Document& document, const std::string& route) {
  const RecordScope record;
  try {
    if (file_type(document) == "ruled") {
      const RuledFile<Q> surface = read_ruled<Q>(document);
      require_effort(surface);
      return examine(record, determinants(surface));
    }
    const ConstructFile<Q> input = read_construct<Q>(document);
    require_effort(input);
    return examine(record, construction(input, route));
  } catch (const InvalidInput& invalid) {
    throw document.error(invalid);
  }
}

}  // namespace torse::studies
