// Figures 1 to 8 of FJ07, drawn from nets of our own (the paper prints no numbers of its figures).
#include <fmt/format.h>

#include <Eigen/Geometry>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/piece_functions.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/singularities.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/figures/drawing.hpp"
#include "torse/figures/sampled.hpp"

namespace torse::figures {
namespace {

Rational fraction(int p, int q = 1) { return ratio<Rational>(p, q); }

const std::vector<Row>& directrix() {
  static const std::vector<Row> rows = rows_of({{0, 0, 0}, {2, 3, 0}, {6, 3, 2}, {8, 0, 1}});
  return rows;
}

Surface bezier(std::vector<Row> c, std::vector<Row> d) {
  const int degree = static_cast<int>(c.size()) - 1;
  return Surface(bezier_knots<Rational>(degree), std::move(c), std::move(d));
}

// FJ07.13 on one Bezier piece.
struct Developable {
  Rational lambda = fraction(-6);
  Rational m = fraction(-4);
  Surface surface = bezier(directrix(), linear_net<Rational, Row>(bezier_knots<Rational>(3), directrix(), lambda, m,
                                                                  rows_of({{-1, 1, 4}}).front()));
};

Figure figure1() {
  const Developable patch;
  const DrawnSurface drawn(patch.surface);
  const double t = 0.6;
  Scene scene = net_scene(patch.surface, drawn, {-60, 25}, false);
  const Vector c = drawn.c(t);
  const Vector d = drawn.d(t);
  const Vector at_c = 0.22 * drawn.c_speed(t);
  const Vector at_d = 0.22 * drawn.d_speed(t);
  scene.plane({c - at_c, c + at_c, d + at_d, d - at_d}, tangent_colour);
  scene.line({c - at_c, c + at_c}, {tangent_colour, 2});
  scene.line({d - at_d, d + at_d}, {tangent_colour, 2});
  scene.line({c, d}, {ruling_colour, 2});
  scene.dot(c, c_colour);
  scene.dot(d, d_colour);
  scene.word(c, "c(u)", 4, 16);
  scene.word(d, "d(u)", 4, -8);
  const double volume = drawn.d_speed(t).dot(drawn.c_speed(t).cross(d - c));
  return {fmt::format("The tangents c'(u), d'(u) and the ruling d(u) - c(u) lie in one plane: at u = {} their "
                      "determinant (FJ07.3) is {:.1g} in doubles, and the exact one is 0 for every u.",
                      t, volume),
          {{"net with L* = " + short_number(patch.lambda) + ", M* = " + short_number(patch.m), scene}},
          {{"patch", patch.surface, SurfaceClass::tangent}}};
}

Figure figure2() {
  const std::vector<Rational> lengths{fraction(3), fraction(4), fraction(4), fraction(5)};
  Row direction;
  direction << fraction(0), fraction(1, 4), fraction(0), fraction(1);
  const Surface surface = bezier(directrix(), cylinder_net<Rational, Row>(directrix(), direction, lengths));
  return {"All sides c_i d_i of the net are parallel to (1/4, 0, 1) (FJ07.4); their lengths are free.",
          {{"cylinder", net_scene(surface, DrawnSurface(surface), {-60, 25}, true)}},
          {{"cylinder", surface, SurfaceClass::cylinder}}};
}

Figure figure3() {
  const Rational alpha = fraction(2, 5);
  const Row d0 = rows_of({{2, 1, 3}}).front();
  const Surface surface = bezier(directrix(), cone_net<Rational, Row>(directrix(), alpha, d0));
  const Row vertex = cone_vertex<Rational, Row>(directrix()[0], d0, alpha);
  Scene scene = net_scene(surface, DrawnSurface(surface), {-60, 20}, true);
  for (const Row& row : surface.c) scene.line({place(row), place(vertex)}, {help_colour, 0.8, true});
  scene.dot(place(vertex), edge_colour, 3.5);
  scene.word(place(vertex), "vertex");
  return {fmt::format("The sides of both control polygons are parallel, those of d are {} of those of c (FJ07.6); the "
                      "vertex is ({}, {}, {}) (FJ07.5).",
                      short_number(alpha), short_number(vertex[1]), short_number(vertex[2]), short_number(vertex[3])),
          {{"cone", scene}},
          {{"cone", surface, SurfaceClass::cone}}};
}

Figure figure4() {
  const std::vector<Row> d = tangent_net<Rational, Row>(directrix());
  const Surface surface = bezier(directrix(), restrict_rulings<Rational, Row>(directrix(), d, fraction(1, 2)));
  Scene scene = net_scene(surface, DrawnSurface(surface), {-75, 30}, true);
  scene.line(curve_points(surface.c), {edge_colour, 2.5});
  return {"The ruling at c(u) is the tangent c'(u)/2 of c, which is the edge of regression (FJ07.7).",
          {{"tangent surface", scene}},
          {{"tangent surface", surface, SurfaceClass::tangent}}};
}

// De Boor's triangle of a Bezier polygon at t, drawn down to its last pair.
std::pair<Vector, Vector> draw_triangle(Scene& scene, std::span<const Row> control, const Rational& t,
                                        const std::string& colour) {
  std::vector<Row> row(control.begin(), control.end());
  while (row.size() > 2) {
    scene.polygon(places(row), {colour, row.size() == control.size() ? 1.2 : 0.8, row.size() != control.size()});
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      row[i] = combine(fraction(1) - t, row[i], t, row[i + 1]);
    }
    row.pop_back();
  }
  const std::vector<Vector> pair = places(row);
  scene.polygon(pair, {colour, 2});
  return {pair[0], pair[1]};
}

Figure figure5() {
  const Developable patch;
  Scene scene(-60, 25);
  scene.line(curve_points(patch.surface.c), {c_colour, 1.8});
  scene.line(curve_points(patch.surface.d), {d_colour, 1.8});
  const Rational t = fraction(3, 5);
  const auto c = draw_triangle(scene, patch.surface.c, t, c_colour);
  const auto d = draw_triangle(scene, patch.surface.d, t, d_colour);
  scene.plane({c.first, c.second, d.second, d.first}, tangent_colour);
  const std::array<std::pair<const Vector*, const char*>, 4> names{{{&c.first, "c\u2080\u00b2"},
                                                                    {&c.second, "c\u2081\u00b2"},
                                                                    {&d.first, "d\u2080\u00b2"},
                                                                    {&d.second, "d\u2081\u00b2"}}};
  for (const auto& [at, name] : names) scene.word(*at, name, 4, 14);
  return {
      "The last pairs of points of de Casteljau's triangles of c and d, at u = 3/5, lie in one plane: the tangent "
      "plane.",
      {{"de Casteljau's triangles", scene}},
      {{"patch", patch.surface, SurfaceClass::tangent}}};
}

Figure figure6() {
  const Developable patch;
  const DrawnSurface drawn(patch.surface);
  Scene scene = net_scene(patch.surface, drawn, {-60, 25}, false);
  const KnotList<Rational>& u = patch.surface.knots;
  std::vector<Vector> meetings;
  for (int i = 0; i <= 48; ++i) {
    const Rational t = fraction(i, 48);
    const Vector meeting = place(tangent_point<Rational, Row>(u, patch.surface.c, 1, t, at(patch.lambda)));
    meetings.push_back(meeting);
    if (i % 24 != 12) continue;
    const double at_t = t.to_double();
    scene.line({drawn.c(at_t), meeting}, {c_colour, 1, true});
    scene.line({drawn.d(at_t), meeting}, {d_colour, 1, true});
    scene.line({drawn.c(at_t), drawn.d(at_t)}, {ruling_colour, 1.6});
    scene.dot(meeting, edge_colour, 3);
  }
  scene.line(meetings, {edge_colour, 1.6});
  return {
      "The tangents at both ends of a ruling meet, at the parameter L* of the one and M* of the other: "
      "c[u, u, L*] = d[u, u, M*] (FJ07.9). The points where they meet are a curve of degree n - 1.",
      {{"L* = " + short_number(patch.lambda) + ", M* = " + short_number(patch.m), scene}},
      {{"patch", patch.surface, SurfaceClass::tangent}}};
}

std::vector<Rational> knots(std::initializer_list<int> list) {
  std::vector<Rational> result;
  for (int x : list) result.push_back(fraction(x));
  return result;
}

// "Lam_1 = -6, M_1 = -4, ..." of all pieces (FJ07.10).
std::string local_parameters(const KnotList<Rational>& u, const Rational& lambda, const Rational& m) {
  std::string text;
  for (int k : u.proper_pieces()) {
    text += fmt::format("{}Lam_{} = {}, M_{} = {}", text.empty() ? "" : "; ", k,
                        short_number(local_parameter(u, lambda, k)), k, short_number(local_parameter(u, m, k)));
  }
  return text;
}

Figure figure7() {
  const KnotList<Rational> u(3, knots({0, 0, 0, 1, 2, 3, 3, 3}));
  const std::vector<Row> c = rows_of({{0, 0, 0}, {2, 3, 0}, {5, 4, 1}, {9, 3, 1}, {11, 0, 3}, {12, -2, 3}});
  const Rational lambda = fraction(-9);
  const Rational m = fraction(-7);
  const Surface surface(u, c, linear_net<Rational, Row>(u, c, lambda, m, rows_of({{-1, 1, 4}}).front()));
  const std::size_t singular = find_singularities(recover_pieces<Rational>(u, surface.c_row(), surface.d_row())).size();
  return {fmt::format("Three pieces of degree 3: {}. All are negative, so Corollary 3 promises a surface without "
                      "singular points; {} are found.",
                      local_parameters(u, lambda, m), singular == 0 ? "none" : std::to_string(singular)),
          {{"L* = " + short_number(lambda) + ", M* = " + short_number(m),
            net_scene(surface, DrawnSurface(surface), {-70, 30}, true)}},
          {{"patch", surface, SurfaceClass::tangent}}};
}

Figure figure8() {
  const KnotList<Rational> u(2, knots({0, 0, 1, 2, 2}));
  const std::vector<Row> c = rows_of({{0, 0, 0}, {2, 3, 0}, {6, 3, 2}, {8, 0, 2}});
  const Rational lambda = fraction(17, 10);
  const Rational m = fraction(13, 10);
  const Surface surface(u, c, linear_net<Rational, Row>(u, c, lambda, m, rows_of({{-1, 2, 3}}).front()));
  const DrawnSurface drawn(surface);
  Scene scene = net_scene(surface, drawn, {-100, 35}, true);
  // v(t) = (t-M*)/(L*-M*) (FJ21.6.1 with sigma = 1) is within the patch between M* and L*.
  std::vector<Vector> edge;
  for (int i = -2; i <= 18; ++i) {
    const double v = i / 16.0;
    edge.push_back(drawn.at(m.to_double() + v * (lambda - m).to_double(), v));
  }
  scene.line(edge, {edge_colour, 2.5});
  std::string found;
  for (const SingularSet& set : find_singularities(recover_pieces<Rational>(u, surface.c_row(), surface.d_row()))) {
    found += fmt::format("{}{} to {}", found.empty() ? "" : ", ", short_number(set.from.root.lower),
                         short_number(set.to.root.upper));
  }
  return {
      fmt::format("Two pieces of degree 2: {}. The first is regular; the edge of regression runs through the second, "
                  "where the parameters with a singular point are found to be {}.",
                  local_parameters(u, lambda, m), found),
      {{"L* = " + short_number(lambda) + ", M* = " + short_number(m), scene}},
      {{"patch", surface, SurfaceClass::tangent}}};
}

}  // namespace

std::vector<PaperFigure> fj07_figures() {
  return {{"FJ07.Fig1", "a developable surface", figure1},
          {"FJ07.Fig2", "a cylindrical Bezier surface", figure2},
          {"FJ07.Fig3", "a conical Bezier surface", figure3},
          {"FJ07.Fig4", "a Bezier tangent surface", figure4},
          {"FJ07.Fig5", "the coplanarity condition", figure5},
          {"FJ07.Fig6", "the meaning of L* and M*", figure6},
          {"FJ07.Fig7", "a regular developable B-spline surface", figure7},
          {"FJ07.Fig8", "one regular and one singular piece", figure8}};
}

}  // namespace torse::figures
