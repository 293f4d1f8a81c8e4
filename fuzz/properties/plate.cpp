#include "torse/fuzz/properties/plate.hpp"

#include <algorithm>
#include <cmath>

#include "torse/exact/unroll/plate.hpp"
#include "torse/fuzz/plain/length.hpp"

namespace torse::fuzz {
namespace {

using plain::Point;
using plain::root_above;
using plain::root_below;
using plain::squared_distance;

Rational exact(double x) { return Rational::from_double(x); }
Point exact(const PlatePoint& x) { return {exact(x.x), exact(x.y), Rational()}; }

/// The surface at the plate's parameters.
class Model {
 public:
  explicit Model(const Net<4>& net) : strip_(plain::strip_of(net.knots, net.c, net.d)) {}

  Point c(const Rational& t) const { return at(strip_.p, t); }
  Point d(const Rational& t) const { return at(strip_.q, t); }

 private:
  static Point at(const plain::Pieces<4>& curve, const Rational& t) {
    std::size_t j = 0;
    while (j + 1 < curve.rows.size() && curve.breaks[j + 1] < t) ++j;
    return plain::point_of(plain::value_at<4>(curve.rows[j], t));
  }

  plain::Strip strip_;
};

/// Whether the numbers are short and the weights alike: lengths on wild surfaces take seconds.
bool tame(const Net<4>& net) {
  constexpr std::size_t bits = 16;
  const auto is_short = [](const Rational& x) { return x.numerator_bits() + x.denominator_bits() <= bits; };
  for (const auto* row : {&net.c, &net.d}) {
    for (const Row4& x : *row) {
      const bool weight = Rational(1) / Rational(8) <= x[0] && x[0] <= Rational(8);
      if (!weight || !is_short(x[1]) || !is_short(x[2]) || !is_short(x[3])) return false;
    }
  }
  return std::all_of(net.knots.list().begin(), net.knots.list().end(), is_short);
}

/// The largest extent in a coordinate, over the rails at a few parameters.
double size_of(const Model& model, const KnotList<Rational>& u) {
  constexpr int count = 8;
  double size = 0;
  const Point origin = model.c(u.domain_begin());
  for (int i = 0; i <= count; ++i) {
    const Rational t = u.domain_begin() + Rational(i) / Rational(count) * (u.domain_end() - u.domain_begin());
    for (const Point& x : {model.c(t), model.d(t)}) {
      for (int j = 0; j < 3; ++j) size = std::max(size, std::abs(Rational(x[j] - origin[j]).to_double()));
    }
  }
  return size;
}

/// A length in the plane is that in space, both with their bounds, up to `error`.
void require_near(const Rational& squared_drawn, const Rational& lower, const Rational& upper, double error,
                  const char* message) {
  require(root_below(squared_drawn) <= upper + exact(error) && root_above(squared_drawn) >= lower - exact(error),
          message);
}

void check_rulings(const Plate& plate, const Model& model) {
  for (const PlateRuling& ruling : plate.rulings) {
    require(plate.parameters[ruling.vertex] == ruling.t, "a marked ruling is at another vertex");
    const Rational square = squared_distance(model.c(ruling.t), model.d(ruling.t));
    require(exact(ruling.before.lower()) <= root_above(square) && root_below(square) <= exact(ruling.before.upper()),
            "the length of a ruling is outside its bounds");
    const Rational drawn = squared_distance(exact(plate.c.points[ruling.vertex]), exact(plate.d.points[ruling.vertex]));
    require_near(drawn, root_below(square), root_above(square), ruling.error, "a ruling is drawn longer or shorter");
  }
  for (std::size_t i = 0; i < plate.parameters.size(); ++i) {
    const Rational square = squared_distance(model.c(plate.parameters[i]), model.d(plate.parameters[i]));
    require_near(squared_distance(exact(plate.c.points[i]), exact(plate.d.points[i])), root_below(square),
                 root_above(square), plate.ruling_error, "the ruling at a vertex is drawn longer or shorter");
  }
}

/// Chords are no longer than arcs: in space between the vertices and halfway, in the plane between the vertices.
template <class Curve>
void check_rail(const PlateRail& rail, const std::vector<Rational>& parameters, const Curve& curve) {
  require(rail.points.size() == parameters.size(), "a rail with another number of vertices");
  Rational chords;
  Rational drawn_below;
  Rational drawn_above;
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
    const Rational& from = parameters[i];
    const Rational& to = parameters[i + 1];
    require(from < to, "parameters that do not increase");
    const Point middle = curve((from + to) / Rational(2));
    chords += root_below(squared_distance(curve(from), middle)) + root_below(squared_distance(middle, curve(to)));
    const Rational square = squared_distance(exact(rail.points[i]), exact(rail.points[i + 1]));
    drawn_below += root_below(square);
    drawn_above += root_above(square);
  }
  require(chords <= exact(rail.before.upper()), "a rail is longer than its upper bound");
  require(exact(rail.after.lower()) <= drawn_above && drawn_below <= exact(rail.after.upper()),
          "the drawn length of a rail is outside its bounds");
  require(exact(rail.before.lower()) <= drawn_above + exact(rail.error) && chords <= drawn_above + exact(rail.error),
          "a rail's length differs from the drawn one by more than its error");
}

/// A straight segment of the plate is a curve on the surface: it is no shorter than the chord in space.
void check_diagonals(const Plate& plate, const Model& model) {
  const Rational error = Rational(2) * exact(plate.vertex_error + plate.deviation);
  for (std::size_t i = 0; i + 1 < plate.parameters.size(); ++i) {
    for (const bool up : {true, false}) {
      const auto& first = up ? plate.c.points : plate.d.points;
      const auto& second = up ? plate.d.points : plate.c.points;
      const Rational& from = plate.parameters[i];
      const Rational& to = plate.parameters[i + 1];
      const Rational space =
          up ? squared_distance(model.c(from), model.d(to)) : squared_distance(model.d(from), model.c(to));
      const Rational drawn = squared_distance(exact(first[i]), exact(second[i + 1]));
      require(root_above(drawn) + error >= root_below(space), "a diagonal of the plate is shorter than in space");
    }
  }
}

/// Twice the signed area of the drawn polygon.
Rational shoelace(const Plate& plate) {
  const Outline outline = outline_of(plate);
  Rational sum;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const Point a = exact(outline.points[i]);
    const Point b = exact(outline.points[(i + 1) % outline.points.size()]);
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

void check_area(const Plate& plate) {
  Rational area = shoelace(plate) / Rational(2);
  if (area.sign() < 0) area = -area;
  require(exact(plate.area_after.lower()) <= area && area <= exact(plate.area_after.upper()),
          "the area of the drawn polygon is outside its bounds");
  require(plate.area_before.lower() <= plate.area_before.upper(), "bounds of the area in the wrong order");
}

/// The edge of regression lies between the rails nowhere: the sheet would fold over itself.
void check_folds(const Net<4>& net) {
  constexpr int count = 8;
  const plain::Strip strip = plain::strip_of(net.knots, net.c, net.d);
  for (int j = 0; j < strip.p.count(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Rational& begin = strip.p.breaks[at];
    for (int i = 1; i < count; ++i) {
      const Rational t = begin + Rational(i) / Rational(count) * (strip.p.breaks[at + 1] - begin);
      const plain::Ruling ruling = plain::ruling_at(strip, j, t);
      require(plain::parallel(ruling.p, ruling.q) || plain::edge_side(ruling) != 1, "a plate that folds over itself");
    }
  }
}

void check_box(const Plate& plate) {
  for (const auto* rail : {&plate.c, &plate.d}) {
    for (const PlatePoint& x : rail->points) {
      require(x.x >= 0 && x.y >= 0 && x.x <= plate.width && x.y <= plate.height, "a vertex outside the plate's box");
    }
  }
}

}  // namespace

const PropertyInfo& PlateBounds::info() {
  static const PropertyInfo info{
      "enclosure.plate",
      "lengths of rulings and rails of a flat plate are those of the surface within the stated errors, its diagonals "
      "are not shorter than in space, its areas are within their bounds",
      1,
      {"plate=drawn", "plate=obstacle"}};
  return info;
}

PlateBounds::In PlateBounds::draw(Choices& choices, const Scale& scale, Labels& labels) {
  constexpr int tries = 20;
  In in;
  const Scale small{std::min(scale.degree, 2), std::min(scale.pieces, 2), std::min(scale.bits, 4)};
  for (int i = 0; i < tries; ++i) {
    in.net = choices.once_in(3) ? draw_developable_rational_net(choices, small)
                                : with_weights(draw_developable_net(choices, small));
    if (!tame(in.net)) continue;
    if (find_obstacles(piece_strips(in.net.knots, in.net.c, in.net.d)).empty()) break;
  }
  if (!tame(in.net)) throw Discard("a wild surface");
  add_net_labels(labels, in.net);
  in.digits = choices.between(1, 2);
  in.marks = choices.between(1, 4);
  in.mirrored = choices.once_in(2);
  return in;
}

void PlateBounds::check(const In& in, Labels& labels) {
  const std::vector<PieceStrip> strips = piece_strips(in.net.knots, in.net.c, in.net.d);
  if (!find_obstacles(strips).empty()) return labels.add("plate", "obstacle");
  const Model model(in.net);
  const double tolerance = std::pow(10.0, -in.digits) * size_of(model, in.net.knots);
  try {
    const Plate plate = unroll_plate(strips, {tolerance, ruling_marks(in.net.knots, strips, in.marks), 0, in.mirrored});
    check_rulings(plate, model);
    check_rail(plate.c, plate.parameters, [&](const Rational& t) { return model.c(t); });
    check_rail(plate.d, plate.parameters, [&](const Rational& t) { return model.d(t); });
    check_diagonals(plate, model);
    check_area(plate);
    check_box(plate);
    check_folds(in.net);
    require(plate.deviation <= tolerance, "the outline is farther off than the tolerance");
    labels.add("plate", "drawn");
  } catch (const InvalidInput& invalid) {
    labels.add("plate", invalid.place());
  }
}

}  // namespace torse::fuzz
