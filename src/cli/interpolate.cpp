// torse construct interpolate: all real branches, exactly.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "torse/algebra/polynomial.hpp"
#include "torse/cli/command.hpp"
#include "torse/cli/construct_methods.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/developable/interpolation.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/exact/roots/real_roots.hpp"

namespace torse::cli {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;

/// The branch polynomial has degree L - 1; isolating its roots takes minutes beyond this.
constexpr int last_index_limit = 200;
/// The relative width of the interval in which the M* of an irrational branch is rounded.
constexpr int branch_bits = 64;

bool zero(const Point3& v) { return v[0].sign() == 0 && v[1].sign() == 0 && v[2].sign() == 0; }

Q dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Construction with_points(const ConstructFile<Q>& input, std::vector<Point3> d, std::vector<std::string> notes) {
  return {{input.knots, input.c, {std::move(d), input.c.weights}}, std::move(notes)};
}

/// FJ07 section 4, parallel end rulings: c translated by va.
Construction parallel(const ConstructFile<Q>& input) {
  const std::vector<Q> lengths(input.c.points.size(), Q(1));
  return with_points(input, cylinder_net<Q, Point3>(input.c.points, *input.va, lengths),
                     {"the end rulings are parallel: the cylinder d = c + va (Lambda is not used)"});
}

/// FJ07 section 4, end rulings that meet in a point O: the cone d - O = Lambda (c - O).
Construction meeting(const ConstructFile<Q>& input, const Point3& chord, const Point3& normal) {
  const Point3& c0 = input.c.points.front();
  const Q volume = dot(normal, normal);  // det(va, vb, va x vb)
  const Q along = det3(chord, *input.vb, normal) / volume;
  Point3 vertex = c0;
  add_scaled(vertex, along, *input.va);
  if (zero(difference(vertex, c0)) || zero(difference(vertex, input.c.points.back()))) {
    throw InvalidInput("va", "the end rulings meet in an end point of the curve, where a cone has no ruling");
  }
  if (*input.lambda == Q(1)) throw InvalidInput("Lambda", "expected a ratio other than 1, which gives d = c");
  const Point3 d0 = combine(Q(1) - *input.lambda, vertex, *input.lambda, c0);
  return with_points(input, cone_net<Q, Point3>(input.c.points, *input.lambda, d0),
                     {"the end rulings meet: the cone over their common point, with the ratio Lambda"});
}

/// The roots of the branch polynomial that are not knots; no interval of an irrational one contains a knot.
std::vector<RealRoot> find_branches(const ConstructFile<Q>& input) {
  const KnotList<Q>& u = input.knots;
  const std::vector<Q> polynomial = branch_polynomial<Q>(u, input.c.points, *input.va, *input.vb);
  const auto holds_knot = [&](const RealRoot& root) {
    return std::ranges::any_of(u.list(), [&](const Q& x) { return root.lower <= x && x <= root.upper; });
  };
  for (int bits = branch_bits;; bits *= 2) {
    std::vector<RealRoot> roots = real_roots(polynomial, bits);
    std::erase_if(roots, [&](const RealRoot& root) { return root.rational() && holds_knot(root); });
    if (std::ranges::none_of(roots, holds_knot)) return roots;
  }
}

Q branch_value(const RealRoot& root) { return (root.lower + root.upper) / Q(2); }

/// Whether f vanishes at this root of a polynomial g, too. An irrational root is the only one of g in its interval, so
/// that a common divisor, its roots taken once, changes its sign there or has none.
bool also_root(const RealRoot& root, const Polynomial<Q>& g, const Polynomial<Q>& f) {
  if (root.rational()) return f(root.lower).sign() == 0;
  const Polynomial<Q> common = square_free_part(gcd(g, f));
  return common(root.lower).sign() != common(root.upper).sign();
}

/// alpha and beta of FJ07.20-21 are 0 at the branch: the ruling at the curve's begin, that at its end has length zero.
struct Collapsed {
  bool first;
  bool last;
};

Collapsed collapsed(const ConstructFile<Q>& input, const RealRoot& root) {
  const Point3 normal = cross(*input.va, *input.vb);
  const std::vector<Point3> chord = chord_polynomial<Q, Point3>(input.knots, input.c.points);
  const auto along = [&](const Point3& direction) {
    std::vector<Q> coefficients;
    for (const Point3& coefficient : chord) coefficients.push_back(dot(coefficient, direction));
    return Polynomial<Q>(std::move(coefficients));
  };
  const Polynomial<Q> branches = along(normal);
  return {also_root(root, branches, along(cross(*input.vb, normal))),
          also_root(root, branches, along(cross(normal, *input.va)))};
}

/// An upper bound, in degrees, of the angle between two lines: x <= (pi/2) sin x, every step rounded up.
double angle_bound(const Point3& a, const Point3& b) {
  const Point3 normal = cross(a, b);
  const Q sine_squared = dot(normal, normal) / (dot(a, a) * dot(b, b));
  if (sine_squared.sign() == 0) return 0;
  const auto up = [](double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); };
  return up(90.0 * up(std::sqrt(up(sine_squared.to_double()))));
}

std::string branch_note(std::size_t number, const RealRoot& root, bool chosen) {
  const std::string value = root.rational() ? short_number(root.lower) + " (exact)"
                                            : fmt::format("{:.17g} (irrational)", branch_value(root).to_double());
  return fmt::format("branch {}: M* = {}{}", number, value, chosen ? "  <- written" : "");
}

void require_branch(int branch, int count) {
  if (branch >= 1 && branch <= count) return;
  throw UsageError("--branch: expected " + (count == 1 ? "1" : fmt::format("a number from 1 to {}", count)) +
                   fmt::format(", found {}", branch));
}

/// Skew end rulings, FJ07.20-21.
Construction skew(const ConstructFile<Q>& input, int branch) {
  if (input.knots.last() > last_index_limit) {
    throw InvalidInput("c.points", fmt::format("expected at most {} control points to interpolate, found {}",
                                               last_index_limit + 1, input.c.points.size()));
  }
  require_branches(input);
  const std::vector<RealRoot> roots = find_branches(input);
  if (roots.empty()) throw NoSolution("no branch: every real root of the polynomial in M* is a knot, or there is none");
  require_branch(branch, static_cast<int>(roots.size()));
  const std::size_t chosen = static_cast<std::size_t>(branch) - 1;
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < roots.size(); ++i) notes.push_back(branch_note(i + 1, roots[i], i == chosen));

  const Q m = branch_value(roots[chosen]);
  if (m == *input.lambda) throw InvalidInput("Lambda", "expected a value other than the branch M*, which gives d = c");
  std::vector<Point3> d = interpolating_net<Q>(input.knots, input.c.points, *input.va, *input.vb, m, *input.lambda);
  const Point3 last = difference(d.back(), input.c.points.back());
  const Collapsed none = collapsed(input, roots[chosen]);
  const std::string rounded = roots[chosen].rational() ? "" : ", but for the rounding of M*";
  if (none.first) notes.push_back("the first ruling has length zero" + rounded);
  if (none.last) {
    notes.push_back("the last ruling has length zero" + rounded);
  } else if (const double angle = angle_bound(last, *input.vb); angle > 0) {
    notes.push_back(
        fmt::format("M* is rounded to a rational number: the surface is exactly developable with the first "
                    "ruling along va;\nthe last ruling is off vb by at most {} degrees",
                    decimal_above(angle, 3)));
  }
  return with_points(input, std::move(d), std::move(notes));
}

}  // namespace

Construction interpolate(const ConstructFile<Q>& input, int branch) {
  if (zero(*input.va)) throw InvalidInput("va", "expected a direction, found the zero vector");
  if (zero(*input.vb)) throw InvalidInput("vb", "expected a direction, found the zero vector");
  if (!definitely(input.knots.clamped())) {
    throw InvalidInput("knots", fmt::format("expected end knots of multiplicity {}, so that the curve ends in its end "
                                            "points",
                                            input.knots.degree()));
  }
  const Point3 normal = cross(*input.va, *input.vb);
  const Point3 chord = difference(input.c.points.back(), input.c.points.front());
  if (dot(chord, normal).sign() != 0) return skew(input, branch);
  require_branch(branch, 1);
  return zero(normal) ? parallel(input) : meeting(input, chord, normal);
}

}  // namespace torse::cli
