// Rails over Q from what the plugin sends.
#include "torse/cli/cad_surface.hpp"

#include <algorithm>
#include <cmath>

#include "torse/algebra/determinant.hpp"
#include "torse/spline/compatible.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse::cli {
namespace {

using Q = Rational;
using Point = Vec<Q, 3>;
using Row = Vec<Q, 4>;
using Curve = Spline<Q, Row>;

Q exact(double x) { return Q::from_double(x); }

Point exact(const CadPoint& x) { return Point(exact(x[0]), exact(x[1]), exact(x[2])); }

Row weighted(const Q& weight, const Point& x) { return Row(weight, weight * x[0], weight * x[1], weight * x[2]); }

Curve curve_of(const CadRail& rail) {
  const std::size_t count = rail.points.size();
  if (rail.degree > limits::degree || count > static_cast<std::size_t>(limits::points)) {
    throw InvalidInput("degree", "expected at most " + std::to_string(limits::degree) + " with " +
                                     std::to_string(limits::points) + " control points, found " +
                                     std::to_string(rail.degree) + " with " + std::to_string(count));
  }
  if (count < 2 || rail.weights.size() != count) throw InvalidInput("weights", "expected one for each control point");
  std::vector<Q> knots;
  for (double t : rail.knots) knots.push_back(exact(t));
  std::vector<Row> rows;
  for (std::size_t i = 0; i < count; ++i) rows.push_back(weighted(exact(rail.weights[i]), exact(rail.points[i])));
  Curve curve(KnotList<Q>::from_list(rail.degree, static_cast<int>(count) - 1, std::move(knots)), std::move(rows));
  if (rail.part) curve = restrict_spline(curve, exact(rail.part->from), exact(rail.part->to));
  return rail.reversed ? reversed_spline(curve) : curve;
}

/// Two rails over one knot list.
using Rails = std::pair<Curve, Curve>;

/// About how many affine combinations it takes to raise curves of these degrees with so many points and pieces to the
/// degree n, and to insert the knots of both: m^2/2 for a blossom of degree m, and m + 1 blossoms for each point of a
/// curve that is raised to the degree m.
double joining_effort(int low, int n, std::size_t points, std::size_t pieces) {
  double effort = 0;
  double count = static_cast<double>(points);
  for (int m = low + 1; m <= n; ++m) {
    count += static_cast<double>(pieces);
    effort += count * std::pow(m, 3) / 2;
  }
  return effort + count * n * n;
}

/// Two rails over one knot list, if that does not take long.
Rails rails_of(const CadRails& rails) {
  constexpr double most_effort = 0x1p23;
  const Curve c = curve_of(rails.c);
  const Curve d = curve_of(rails.d);
  const int low = std::min(c.knots.degree(), d.knots.degree());
  const int high = std::max(c.knots.degree(), d.knots.degree());
  const double effort = joining_effort(low, high, c.control.size() + d.control.size(),
                                       c.knots.proper_pieces().size() + d.knots.proper_pieces().size());
  if (effort > most_effort) {
    throw InvalidInput("degree",
                       "expected rails that come to one degree and one knot list with 2^23 steps at most, "
                       "found some of degrees " +
                           std::to_string(low) + " and " + std::to_string(high) + " with " +
                           std::to_string(c.control.size() + d.control.size()) + " control points");
  }
  return make_compatible(c, d);
}

Point begin_of(const Curve& curve) {
  const Row p =
      curve_point<Q, Row>(curve.knots, curve.points(), curve.knots.proper_pieces().front(), curve.knots.domain_begin());
  if (p[0].sign() == 0) throw InvalidInput("weights", "expected a curve that begins at a finite point");
  return Point(p[1] / p[0], p[2] / p[0], p[3] / p[0]);
}

Rails rails_of(const CadExtrusion& extrusion) {
  Curve c = curve_of(extrusion.c);
  const Point v = extrusion.end ? Point(exact(*extrusion.end) - begin_of(c)) : exact(extrusion.vector);
  std::vector<Row> moved;
  for (const Row& p : c.control) moved.push_back(Row(p[0], p[1] + p[0] * v[0], p[2] + p[0] * v[1], p[3] + p[0] * v[2]));
  Curve d(c.knots, std::move(moved));
  return {std::move(c), std::move(d)};
}

/// A rotation about an axis a of any length: the quaternion s + k a, up to a factor.
struct Turn {
  Q s;
  Q k;
};

/// The polar form of q -> (|q|^2, |q|^2 o + q x q*) at two turns: the homogeneous control point of the arc between them
/// through which the point o + x moves (o on the axis). For g = h it is the rotated point itself, with the weight
/// |g|^2.
Row turned(const Turn& g, const Turn& h, const Point& a, const Point& o, const Point& x) {
  const Q square = g.k * h.k * dot(a, a);
  const Q weight = g.s * h.s + square;
  const Point moved =
      (g.s * h.s - square) * x + (g.k * h.s + g.s * h.k) * cross(a, x) + (Q(2) * g.k * h.k * dot(a, x)) * a;
  return Row(weight, weight * o[0] + moved[0], weight * o[1] + moved[1], weight * o[2] + moved[2]);
}

/// The turns that cut the whole one into arcs of at most about a right angle. Cosine and sine may be rounded: every
/// pair (s, k) is a rotation.
std::vector<Turn> turns_of(const CadRange& turn, double axis_length) {
  constexpr double largest_arc = 1.5708;
  const double angle = turn.to - turn.from;
  if (!(angle > 0 && angle < 7 && axis_length > 0)) {
    throw InvalidInput("turn", "expected an angle of up to a full turn about an axis, found " + std::to_string(angle));
  }
  const int arcs = static_cast<int>(std::ceil(angle / largest_arc));
  std::vector<Turn> turns;
  for (int i = 0; i <= arcs; ++i) {
    const double half = (turn.from + angle * i / arcs) / 2;
    turns.push_back({exact(std::cos(half)), exact(std::sin(half) / axis_length)});
  }
  return turns;
}

Curve circle_of(const std::vector<Turn>& turns, const Point& axis, const Point& origin, const Point& x) {
  std::vector<Row> rows;
  std::vector<Q> knots;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (i > 0) rows.push_back(turned(turns[i - 1], turns[i], axis, origin, x));
    rows.push_back(turned(turns[i], turns[i], axis, origin, x));
    knots.insert(knots.end(), 2, Q(static_cast<long>(i)));
  }
  return Curve(KnotList<Q>(2, std::move(knots)), std::move(rows));
}

Rails rails_of(const CadRevolution& revolution) {
  const Point origin = exact(revolution.origin);
  const Point axis = exact(revolution.axis);
  const Point radial = exact(revolution.radial);
  const std::vector<Turn> turns =
      turns_of(revolution.turn, std::hypot(revolution.axis[0], revolution.axis[1], revolution.axis[2]));
  const auto rail = [&](const CadMeridianEnd& end) {
    const Point x = exact(end.base) + exact(end.radius) * radial + exact(end.height) * axis - origin;
    return circle_of(turns, axis, origin, x);
  };
  return {rail(revolution.meridian[0]), rail(revolution.meridian[1])};
}

/// Rows at two places of each ruling, 0 being p and 1 being q.
void cut_across(const CadRange& range, std::vector<Row>& p, std::vector<Row>& q) {
  const Q from = exact(range.from);
  const Q to = exact(range.to);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Row along = q[i] - p[i];
    q[i] = p[i] + to * along;
    p[i] += from * along;
  }
}

WeightedPoints<Q, 3> placed(const std::vector<Row>& rows, const CadPlacement& placement) {
  std::vector<Row> moved;
  for (const Row& p : rows) {
    Row image;
    image[0] = p[0];
    for (int i = 0; i < 3; ++i) {
      const auto& a = placement[static_cast<std::size_t>(i)];
      image[i + 1] = exact(a[0]) * p[1] + exact(a[1]) * p[2] + exact(a[2]) * p[3] + exact(a[3]) * p[0];
    }
    moved.push_back(std::move(image));
  }
  return dehomogenize<Q, 4>(moved);
}

/// |x'|^2 of the curve x = (p_1, p_2, p_3) / p_0, times p_0^4.
Polynomial<Q> square_of_speed(const PolynomialRow<Q, 4>& p) {
  Polynomial<Q> sum;
  for (std::size_t i = 1; i < 4; ++i) {
    const Polynomial<Q> f = p[i].derivative() * p[0] - p[i] * p[0].derivative();
    sum += f * f;
  }
  return sum;
}

}  // namespace

RuledFile<Rational> surface_of(const CadStrip& strip, const CadPlacement& placement) {
  auto [c, d] = std::visit([](const auto& surface) { return rails_of(surface); }, strip.surface);
  if (strip.along) {
    const Q from = exact(strip.along->from);
    const Q to = exact(strip.along->to);
    c = restrict_spline(c, from, to);
    d = restrict_spline(d, from, to);
  }
  if (strip.across) cut_across(*strip.across, c.control, d.control);
  return {c.knots, placed(c.control, placement), placed(d.control, placement)};
}

CurveFile<Rational> curve_file(const CadRail& rail, const CadPlacement& placement) {
  const Curve curve = curve_of(rail);
  return {curve.knots, placed(curve.control, placement)};
}

bool speeds_are_proportional(const RuledFile<Rational>& surface) {
  const std::vector<Row> p = homogeneous(surface.c);
  const std::vector<Row> q = homogeneous(surface.d);
  std::optional<Q> ratio;
  for (int k : surface.knots.proper_pieces()) {
    const PolynomialRow<Q, 4> c = piece_polynomials<Q, 4>(surface.knots, p, k);
    const PolynomialRow<Q, 4> d = piece_polynomials<Q, 4>(surface.knots, q, k);
    const Polynomial<Q> c2 = c[0] * c[0];
    const Polynomial<Q> d2 = d[0] * d[0];
    Polynomial<Q> f = square_of_speed(c) * d2 * d2;
    Polynomial<Q> g = square_of_speed(d) * c2 * c2;
    if (f.zero() || g.zero()) {
      if (f.zero() != g.zero()) return false;
      continue;
    }
    if (!ratio) ratio = f.leading() / g.leading();
    if (!(f - g.scale(*ratio)).zero()) return false;
  }
  return true;
}

}  // namespace torse::cli
