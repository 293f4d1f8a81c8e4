// From the input of `torse construct` to the library's constructions.
#include "torse/cli/construct_methods.hpp"

#include <span>
#include <string>
#include <utility>

#include "torse/cli/command.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::cli {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Row = Vec<Q, 4>;

const Q one(1);

/// w (1, x).
Row row_of(const Q& weight, const Point3& x) { return Row(weight, weight * x[0], weight * x[1], weight * x[2]); }

/// The surface with the homogeneous row q. Throws InvalidInput naming "d.weights[i]" for a point at infinity.
Construction with_row(const ConstructFile<Q>& input, const std::vector<Row>& q) {
  try {
    return {{input.knots, input.c, dehomogenize<Q, 4>(q)}};
  } catch (const InvalidInput& invalid) {
    throw InvalidInput("d." + invalid.place(), "the result has a control point at infinity, which no file can hold");
  }
}

std::size_t bits_of(const Row& x) {
  std::size_t bits = 0;
  for (int j = 0; j < 4; ++j) bits += x[j].numerator_bits() + x[j].denominator_bits();
  return bits;
}

/// The work that a row may take, so that its file can be read again: one for each bit of its numerators and
/// denominators, more for control points of very many bits, where products and common divisors take longer.
constexpr std::size_t most_work = std::size_t{1} << 27;

std::size_t work_of(const Row& x) {
  const std::size_t bits = bits_of(x);
  return bits + bits / 2048 * (bits / 2048);
}

/// FJ07.13 and FJ21.7.1. Numbers may grow with each vertex, so the row is made cell by cell until it is too long: cell
/// i is a net of degree 1 over the knots u_i and u_{i+n}.
Construction linear(const ConstructFile<Q>& input, const Q& lambda, const Q& m, const Q& sigma, const Q& omega0) {
  const KnotList<Q>& u = input.knots;
  const std::vector<Row> p = homogeneous(input.c);
  require_off_knots(u, m);
  std::vector<Row> q{row_of(omega0, *input.d0)};
  std::size_t work = 0;
  for (int i = 0; i < u.last(); ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    const KnotList<Q> cell(1, {u[i], u[i + u.degree()]});
    q.push_back(rational_net<Q, Row>(cell, std::span(p).subspan(at_i, 2), lambda, m, sigma, q.back()).back());
    work += work_of(q.back());
    if (work > most_work) {
      throw InvalidInput("c.points", "expected a second row of at most " + std::to_string(most_work) +
                                         " bits, found numbers that grow beyond them at control point " +
                                         std::to_string(i + 1) + " of " + std::to_string(u.last()));
    }
  }
  return with_row(input, q);
}

/// FJ07.13 with L* = M*, or a translation of c where no M* is given; the weights of c stay.
Construction cylinder(const ConstructFile<Q>& input) {
  if (input.lambda && !input.m) throw InvalidInput("Lambda", "expected M beside it, found no M");
  if (input.lambda && *input.lambda != *input.m) {
    throw InvalidInput("Lambda", "expected the value of M (a cylinder), found " + short_number(*input.lambda));
  }
  if (input.m) return linear(input, *input.m, *input.m, one, input.c.weights.front());
  WeightedPoints<Q, 3> d = input.c;
  const Point3 step = difference(*input.d0, input.c.points.front());
  for (Point3& x : d.points) add(x, step);
  return {{input.knots, input.c, std::move(d)}};
}

/// FJ07.6 with alpha = Lambda; the weights of c stay.
Construction cone(const ConstructFile<Q>& input) {
  if (*input.lambda == one) throw InvalidInput("Lambda", "expected a ratio other than 1, which gives a cylinder");
  WeightedPoints<Q, 3> d{cone_net<Q, Point3>(input.c.points, *input.lambda, *input.d0), input.c.weights};
  return {{input.knots, input.c, std::move(d)}};
}

/// FJ07.7 piece by piece: the row c + c'(u), over knots of multiplicity n.
Construction tangent(const ConstructFile<Q>& input) {
  const KnotList<Q>& u = input.knots;
  const int n = u.degree();
  std::vector<Q> knots(static_cast<std::size_t>(n), u.domain_begin());
  std::vector<Point3> c, d;
  const std::vector<int> pieces = u.proper_pieces();
  if (const std::size_t count = pieces.size() * static_cast<std::size_t>(n) + 1; count > limits::points) {
    throw InvalidInput("c.points", "expected a result of at most " + std::to_string(limits::points) +
                                       " control points, found Bezier pieces with " + std::to_string(count));
  }
  for (int k : pieces) {
    const std::vector<Point3> bezier = bezier_points<Q, Point3>(u, input.c.points, k);
    const Q speed = one / (u.piece_end(k) - u.piece_begin(k));
    const std::vector<Point3> row = restrict_rulings<Q, Point3>(bezier, tangent_net<Q, Point3>(bezier), speed);
    if (!d.empty() && d.back() != row.front()) {
      throw InvalidInput("knots", "expected a curve with a continuous derivative, found a jump of it at u = " +
                                      short_number(u.piece_begin(k)));
    }
    const std::ptrdiff_t shared = d.empty() ? 0 : 1;
    c.insert(c.end(), bezier.begin() + shared, bezier.end());
    d.insert(d.end(), row.begin() + shared, row.end());
    knots.insert(knots.end(), static_cast<std::size_t>(n), u.piece_end(k));
  }
  const std::vector<Q> weights(c.size(), one);
  return {{KnotList<Q>(n, std::move(knots)), {std::move(c), weights}, {std::move(d), weights}}};
}

}  // namespace

Construction construct_surface(const ConstructFile<Q>& input, int branch) {
  if (branch != 1 && input.method != "interpolate") throw UsageError("--branch is for the method interpolate");
  if (input.method == "rational") return linear(input, *input.lambda, *input.m, *input.sigma, *input.omega0);
  if (input.method == "cylinder") return cylinder(input);
  if (input.method == "cone") return cone(input);
  if (input.method == "tangent") return tangent(input);
  if (input.method == "interpolate") return interpolate(input, branch);
  if (input.method == "directrix") return directrix(input);
  return linear(input, *input.lambda, *input.m, one, one);
}

}  // namespace torse::cli
