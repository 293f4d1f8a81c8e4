// From stations to polylines.
#include "torse/exact/unroll/plate.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>

#include "torse/algebra/triple.hpp"
#include "torse/exact/unroll/development.hpp"

namespace torse {
namespace {

using arb::Complex;
using arb::Real;

constexpr slong bits = 256;

/// Points of the plate where the outline's winding is looked at.
constexpr std::size_t most_probes = 256;

/// The part of the tolerance that the arcs may use; the rest is for rounding the vertices.
constexpr double arc_share = 0.9;

Complex difference(const Complex& x, const Complex& y) {
  Complex z;
  acb_sub(z.get(), x.get(), y.get(), bits);
  return z;
}

Real length_between(const Real& from, const Real& to) {
  Real x;
  arb_sub(x.get(), to.get(), from.get(), bits);
  return x;
}

double upper_sum(double a, double b) { return -lower_sum(-a, -b); }

Interval chord_length(const PlatePoint& a, const PlatePoint& b) {
  const Interval x = Interval::point(b.x) - Interval::point(a.x);
  const Interval y = Interval::point(b.y) - Interval::point(a.y);
  // A square is not negative, which the product of intervals does not know.
  const Interval square = x * x + y * y;
  return ScalarTraits<Interval>::sqrt(Interval::hull(std::max(square.lower(), 0.0), square.upper()));
}

/// An upper bound of |x - y|.
double largest_difference(const Interval& x, const Interval& y) {
  const Interval z = x - y;
  return std::max({0.0, -z.lower(), z.upper()});
}

/// Of a number that is known not to be negative.
Interval at_least_zero(const Real& x) {
  const Interval y = arb::enclosure(x);
  return Interval::hull(std::max(y.lower(), 0.0), y.upper());
}

/// The stations that are kept: all marks, and so many that each rail is within the tolerance of its chords.
std::vector<std::size_t> thinned(const std::vector<Station>& stations, const std::vector<Rational>& marks,
                                 double tolerance) {
  const auto close = [&](std::size_t i, std::size_t j) {
    const Station& a = stations[i];
    const Station& b = stations[j];
    return sagitta(length_between(a.length_c, b.length_c), difference(b.p, a.p)) <= tolerance &&
           sagitta(length_between(a.length_d, b.length_d), difference(b.q, a.q)) <= tolerance;
  };
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const bool marked = std::ranges::binary_search(marks, stations[i - 1].t);
    if (i - 1 != kept.back() && (marked || !close(kept.back(), i))) kept.push_back(i - 1);
  }
  kept.push_back(stations.size() - 1);
  return kept;
}

/// A rigid motion of enclosures: turned, mirrored, then moved by doubles.
class Placement {
 public:
  explicit Placement(const std::vector<Station>& stations, bool mirrored) : mirrored_(mirrored) {
    const auto doubled_middle = [](const Station& s) {
      Complex z;
      acb_add(z.get(), s.p.get(), s.q.get(), bits);
      return z;
    };
    const Complex chord = difference(doubled_middle(stations.back()), doubled_middle(stations.front()));
    const double angle = -std::atan2(arf_get_d(arb_midref(acb_imagref(chord.get())), ARF_RND_NEAR),
                                     arf_get_d(arb_midref(acb_realref(chord.get())), ARF_RND_NEAR));
    Real phase;
    arb_set_d(phase.get(), angle);
    arb_sin_cos(acb_imagref(turn_.get()), acb_realref(turn_.get()), phase.get(), bits);
  }

  void move_to(double x, double y) { corner_ = {x, y}; }

  std::array<Real, 2> place(const Complex& z) const {
    Complex w;
    acb_mul(w.get(), z.get(), turn_.get(), bits);
    std::array<Real, 2> result;
    arb_set(result[0].get(), acb_realref(w.get()));
    arb_set(result[1].get(), acb_imagref(w.get()));
    if (mirrored_) arb_neg(result[1].get(), result[1].get());
    for (std::size_t j = 0; j < 2; ++j) {
      Real offset;
      arb_set_d(offset.get(), corner_[j]);
      arb_sub(result[j].get(), result[j].get(), offset.get(), bits);
    }
    return result;
  }

 private:
  bool mirrored_;
  Complex turn_;
  std::array<double, 2> corner_{};
};

/// The double nearest to the number with so many decimals.
double rounded(double x, int decimals) {
  char buffer[512];
  const int size = std::snprintf(buffer, sizeof buffer, "%.*f", decimals, x);
  double result = 0;
  std::from_chars(buffer, buffer + size, result);
  return result == 0 ? 0 : result;
}

/// Vertices with so many decimals, and how far they are from where they belong.
struct Vertex {
  PlatePoint point;
  double error;
};

Vertex vertex_at(const std::array<Real, 2>& place, int decimals) {
  const Interval x = arb::enclosure(place[0]);
  const Interval y = arb::enclosure(place[1]);
  const PlatePoint point{rounded(x.lower(), decimals), rounded(y.lower(), decimals)};
  const double dx = largest_difference(x, Interval::point(point.x));
  const double dy = largest_difference(y, Interval::point(point.y));
  return {point, upper_sum(dx, dy)};
}

/// So many decimals that rounding takes at most a thousandth of the tolerance, x and y together.
int decimals_for(double tolerance) {
  return std::clamp(static_cast<int>(std::ceil(3 - std::log10(tolerance))), 0, 300);
}

/// The error of the edges of one rail.
void measure_rail(PlateRail& rail, const std::vector<Station>& kept, Real Station::*length, Complex Station::*end,
                  double vertex_error) {
  rail.after = Interval();
  for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
    const Real arc = length_between(kept[i].*length, kept[i + 1].*length);
    const Interval chord = chord_length(rail.points[i], rail.points[i + 1]);
    rail.after += chord;
    rail.error = upper_sum(rail.error, largest_difference(arb::enclosure(arc), chord));
    rail.deviation.push_back(upper_sum(sagitta(arc, difference(kept[i + 1].*end, kept[i].*end)), vertex_error));
  }
}

/// The shoelace formula.
Interval polygon_area(const std::vector<PlatePoint>& points) {
  Interval twice;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlatePoint& a = points[i];
    const PlatePoint& b = points[(i + 1) % points.size()];
    twice += Interval::point(a.x) * Interval::point(b.y) - Interval::point(b.x) * Interval::point(a.y);
  }
  const Interval area = twice / Interval(2);
  return area.lower() + area.upper() < 0 ? -area : area;
}

/// cos(w/2) >= 1 - w^2/8, w being the angle in degrees.
Interval least_cosine(double degrees) {
  const Interval radians = Interval::point(degrees) * Interval::hull(3.14, 3.15) / Interval(180);
  return Interval(1) - radians * radians / Interval(8);
}

std::vector<PlatePoint> probes_of(const Plate& plate) {
  std::vector<PlatePoint> probes;
  const std::size_t n = plate.parameters.size() - 1;
  const std::size_t step = n / most_probes + 1;
  for (std::size_t i = 0; i < n; i += step) {
    probes.push_back(
        {(plate.c.points[i].x + plate.c.points[i + 1].x + plate.d.points[i].x + plate.d.points[i + 1].x) / 4,
         (plate.c.points[i].y + plate.c.points[i + 1].y + plate.d.points[i].y + plate.d.points[i + 1].y) / 4});
  }
  return probes;
}

/// A knot where two strips meet at an angle, in degrees: positive where the sheet bends towards the side of its normal.
struct Bend {
  Rational t;
  double degrees;
};

std::vector<Bend> bends_of(const std::vector<PieceStrip>& strips) {
  std::vector<Bend> bends;
  for (std::size_t i = 0; i + 1 < strips.size(); ++i) {
    const Joint joint = joint_of(strips[i], strips[i + 1]);
    const auto axis = cross(joint.before, joint.after);
    const double cosine = dot(joint.before, joint.after).to_double();
    const double sine = std::sqrt(dot(axis, axis).to_double());
    if (dot(axis, axis).sign() == 0) continue;
    const int side = dot(axis, joint.ruling).sign();
    const double degrees = std::atan2(sine, cosine) * 180 / std::numbers::pi;
    bends.push_back({strips[i].end, side > 0 ? -degrees : degrees});
  }
  return bends;
}

/// The true length of the ruling of a station.
Interval true_length(const Station& station) {
  Real length;
  acb_abs(length.get(), difference(station.q, station.p).get(), bits);
  return at_least_zero(length);
}

void measure_rulings(Plate& plate, const std::vector<Station>& kept, const std::vector<Rational>& marks,
                     const std::vector<Bend>& bends, bool mirrored) {
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Interval before = true_length(kept[i]);
    const double error = largest_difference(before, chord_length(plate.c.points[i], plate.d.points[i]));
    plate.ruling_error = std::max(plate.ruling_error, error);
    const bool at_end = i == 0 || i + 1 == kept.size();
    if (!at_end && !std::ranges::binary_search(marks, kept[i].t)) continue;
    const auto bend = std::ranges::find(bends, kept[i].t, &Bend::t);
    const double degrees = bend == bends.end() ? 0 : bend->degrees;
    // 0 - x, as -x is a negative zero where nothing is bent.
    plate.rulings.push_back({kept[i].t, i, before, error, mirrored ? 0 - degrees : degrees});
  }
}

/// Puts the corner of the bounding box at the origin and rounds all vertices.
void place_vertices(Plate& plate, const std::vector<Station>& kept, bool mirrored, double tolerance) {
  Placement placement(kept, mirrored);
  std::array<double, 2> low{detail::infinity, detail::infinity};
  for (const Station& station : kept) {
    for (const Complex* z : {&station.p, &station.q}) {
      const std::array<Real, 2> place = placement.place(*z);
      for (std::size_t j = 0; j < 2; ++j) low[j] = std::min(low[j], arb::enclosure(place[j]).lower());
    }
  }
  placement.move_to(low[0], low[1]);
  const int decimals = decimals_for(tolerance);
  const auto add = [&](PlateRail& rail, const Complex& z) {
    const Vertex vertex = vertex_at(placement.place(z), decimals);
    rail.points.push_back(vertex.point);
    plate.vertex_error = std::max(plate.vertex_error, vertex.error);
    plate.width = std::max(plate.width, vertex.point.x);
    plate.height = std::max(plate.height, vertex.point.y);
  };
  for (const Station& station : kept) {
    plate.parameters.push_back(station.t);
    add(plate.c, station.p);
    add(plate.d, station.q);
  }
}

}  // namespace

Outline outline_of(const Plate& plate) {
  Outline outline{plate.c.points, plate.c.deviation};
  outline.points.insert(outline.points.end(), plate.d.points.rbegin(), plate.d.points.rend());
  outline.slack.push_back(plate.vertex_error);
  outline.slack.insert(outline.slack.end(), plate.d.deviation.rbegin(), plate.d.deviation.rend());
  outline.slack.push_back(plate.vertex_error);
  return outline;
}

std::vector<Rational> ruling_marks(const KnotList<Rational>& u, const std::vector<PieceStrip>& strips, int count) {
  std::vector<Rational> marks;
  for (int i = 0; i <= count; ++i) {
    marks.push_back(u.domain_begin() + ratio<Rational>(i, count) * (u.domain_end() - u.domain_begin()));
  }
  for (const Bend& bend : bends_of(strips)) marks.push_back(bend.t);
  std::ranges::sort(marks);
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

Plate unroll_plate(const std::vector<PieceStrip>& strips, const PlateOptions& options) {
  std::vector<Rational> marks = options.marks;
  std::ranges::sort(marks);
  const double arc_tolerance = arc_share * options.tolerance;
  const std::vector<Station> stations = develop(strips, marks, arc_tolerance, options.stations);
  std::vector<Station> kept;
  for (std::size_t i : thinned(stations, marks, arc_tolerance)) kept.push_back(stations[i]);

  Plate plate{};
  place_vertices(plate, kept, options.mirrored, options.tolerance);
  measure_rail(plate.c, kept, &Station::length_c, &Station::p, plate.vertex_error);
  measure_rail(plate.d, kept, &Station::length_d, &Station::q, plate.vertex_error);
  measure_rulings(plate, kept, marks, bends_of(strips), options.mirrored);
  for (const PlateRail* rail : {&plate.c, &plate.d}) {
    for (double x : rail->deviation) plate.deviation = std::max(plate.deviation, x);
  }
  plate.c.before = at_least_zero(kept.back().length_c);
  plate.d.before = at_least_zero(kept.back().length_d);
  const Interval planar_area = at_least_zero(kept.back().area);
  const Interval cosine = options.warp_degrees > 0 ? least_cosine(options.warp_degrees) : Interval(1);
  plate.stretch = (Interval(1) / cosine - Interval(1)).upper();
  plate.area_before = Interval::hull((planar_area * cosine).lower(), planar_area.upper());
  const Outline outline = outline_of(plate);
  plate.area_after = polygon_area(outline.points);
  plate.overlap = find_overlap(outline, probes_of(plate));
  return plate;
}

}  // namespace torse
