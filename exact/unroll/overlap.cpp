// Edges in order of their left ends; what is near is looked at in interval arithmetic.
#include "torse/exact/unroll/overlap.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "torse/scalar/interval.hpp"

namespace torse {
namespace {

using Vector = std::array<Interval, 2>;

Interval product(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
Interval inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }
Vector from_to(const PlatePoint& a, const PlatePoint& b) {
  return {Interval::point(b.x) - Interval::point(a.x), Interval::point(b.y) - Interval::point(a.y)};
}

Interval sum(double a, double b) { return Interval::point(a) + Interval::point(b); }

/// Whether a distance, given by its square, is larger than r.
Truth farther(const Interval& square, const Interval& r) { return ScalarTraits<Interval>::less(r * r, square); }

/// An edge with its slack.
struct Edge {
  PlatePoint a;
  PlatePoint b;
  double slack;
  std::size_t index;

  double left() const { return lower_sum(std::min(a.x, b.x), -slack); }
  double right() const { return -lower_sum(-std::max(a.x, b.x), -slack); }
  double bottom() const { return lower_sum(std::min(a.y, b.y), -slack); }
  double top() const { return -lower_sum(-std::max(a.y, b.y), -slack); }
};

/// The square of the distance between a point and an edge, or less: that from the edge's line, where the point is
/// beside the edge or rounding hides that it is not. Nothing is known of it beside an edge whose length has a square
/// that a double cannot tell from 0.
Interval distance2(const PlatePoint& p, const Edge& e) {
  const Vector along = from_to(e.a, e.b);
  const Vector to = from_to(e.a, p);
  const Vector back = from_to(e.b, p);
  const Interval length2 = inner(along, along);
  const Interval foot = inner(along, to);
  const Interval at_a = inner(to, to);
  const Interval at_b = inner(back, back);
  if (foot.upper() <= 0) return at_a;
  if (foot.lower() >= length2.upper()) return at_b;
  const Interval area = product(along, to);
  return area * area / length2;
}

/// Which side of an edge a point is on: yes for left, no for right.
Truth left_of(const PlatePoint& p, const Edge& e) {
  return ScalarTraits<Interval>::less(Interval(), product(from_to(e.a, e.b), from_to(e.a, p)));
}

bool certainly_apart_sides(const Edge& e, const Edge& f) {
  const Truth a = left_of(e.a, f);
  const Truth b = left_of(e.b, f);
  return a != Truth::unknown && b != Truth::unknown && a != b;
}

PlatePoint crossing_point(const Edge& e, const Edge& f) {
  const double dx = e.b.x - e.a.x;
  const double dy = e.b.y - e.a.y;
  const double fx = f.b.x - f.a.x;
  const double fy = f.b.y - f.a.y;
  const double s = ((f.a.x - e.a.x) * fy - (f.a.y - e.a.y) * fx) / (dx * fy - dy * fx);
  return {e.a.x + s * dx, e.a.y + s * dy};
}

/// What two edges do: nothing, cross (with all four ends clear of the other's tube, so that their arcs cross too), or
/// come too near to tell.
std::pair<Truth, PlatePoint> meeting(const Edge& e, const Edge& f) {
  const Interval reach = sum(e.slack, f.slack);
  const std::array<std::pair<const PlatePoint*, const Edge*>, 4> ends{std::pair{&e.a, &f}, std::pair{&e.b, &f},
                                                                      std::pair{&f.a, &e}, std::pair{&f.b, &e}};
  const bool cross = certainly_apart_sides(e, f) && certainly_apart_sides(f, e);
  for (const auto& [point, edge] : ends) {
    if (!definitely(farther(distance2(*point, *edge), reach))) return {Truth::unknown, *point};
  }
  if (cross) return {Truth::yes, crossing_point(e, f)};
  // Segments that do not cross are nearest at one of the ends. All ends being clear, only crossings are left, and those
  // need ends on different sides.
  const bool possible = (possibly(left_of(e.a, f)) || possibly(left_of(e.b, f))) &&
                        (possibly(!left_of(e.a, f)) || possibly(!left_of(e.b, f))) &&
                        (possibly(left_of(f.a, e)) || possibly(left_of(f.b, e))) &&
                        (possibly(!left_of(f.a, e)) || possibly(!left_of(f.b, e)));
  return {possible ? Truth::unknown : Truth::no, e.a};
}

std::vector<Edge> edges_of(const Outline& outline) {
  std::vector<Edge> edges;
  const std::size_t n = outline.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Edge e{outline.points[i], outline.points[(i + 1) % n], outline.slack[i], i};
    if (!(e.a == e.b)) edges.push_back(e);
  }
  return edges;
}

/// Whether edges i and j of n share an end.
bool neighbours(std::size_t i, std::size_t j, std::size_t n) { return (i + 1) % n == j || (j + 1) % n == i; }

Overlap meetings_of(const std::vector<Edge>& edges) {
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return edges[i].left(); });
  Overlap result;
  std::vector<std::size_t> active;
  for (std::size_t i : order) {
    const Edge& e = edges[i];
    std::erase_if(active, [&](std::size_t j) { return edges[j].right() < e.left(); });
    for (std::size_t j : active) {
      const Edge& f = edges[j];
      if (f.top() < e.bottom() || e.top() < f.bottom() || neighbours(i, j, edges.size())) continue;
      const auto [truth, at] = meeting(e, f);
      result.verdict = result.verdict | truth;
      if (possibly(truth) && result.meetings.size() < most_meetings) {
        result.meetings.push_back({std::min(e.index, f.index), std::max(e.index, f.index), at, definitely(truth)});
      }
    }
    active.push_back(i);
  }
  return result;
}

/// How often the outline winds around a point, where every edge is farther from it than its slack; else 0.
int certain_winding(const std::vector<Edge>& edges, const PlatePoint& p) {
  int winding = 0;
  for (const Edge& e : edges) {
    if (!definitely(farther(distance2(p, e), Interval::point(e.slack)))) return 0;
    if ((e.a.y <= p.y) == (e.b.y <= p.y)) continue;
    const Truth left = left_of(p, e);
    if (left == Truth::unknown) return 0;
    const bool up = e.a.y <= p.y;
    if (up && definitely(left)) ++winding;
    if (!up && !definitely(left)) --winding;
  }
  return winding;
}

}  // namespace

Overlap find_overlap(const Outline& outline, const std::vector<PlatePoint>& inside) {
  const std::vector<Edge> edges = edges_of(outline);
  Overlap overlap = meetings_of(edges);
  if (overlap.verdict != Truth::unknown) return overlap;
  const auto twice = [&](const PlatePoint& p) { return std::abs(certain_winding(edges, p)) > 1; };
  if (std::ranges::any_of(inside, twice)) overlap.verdict = Truth::yes;
  return overlap;
}

}  // namespace torse
