// Figures 1 to 7 of ZW06: 3x1 Bezier surfaces through a directrix of our own (the paper prints the parameters, not the
// points).
#include <fmt/format.h>

#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/special.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/figures/drawing.hpp"

namespace torse::figures {
namespace {

constexpr Eye eye{-65, 48};

const std::vector<Row>& directrix() {
  static const std::vector<Row> rows = rows_of({{0, 0, 0}, {2, 3, 0}, {6, 3, 2}, {8, 0, 1}});
  return rows;
}

Surface through_directrix(std::vector<Row> d) { return Surface(bezier_knots<Rational>(3), directrix(), std::move(d)); }

// One panel: the net, and the curve or point that the rulings touch, where it is given.
struct Case {
  std::string title;
  std::vector<Row> d;
  SurfaceClass kind;
  std::vector<Vector> edge{};
};

Figure figure_of(std::string caption, const std::vector<Case>& cases) {
  Figure figure{std::move(caption), {}, {}};
  for (const Case& one : cases) {
    const Surface surface = through_directrix(one.d);
    Scene scene = net_scene(surface, DrawnSurface(surface), eye, true);
    if (one.edge.size() == 1) scene.dot(one.edge.front(), edge_colour, 3.5);
    scene.line(one.edge, {edge_colour, 2.2});
    figure.panels.push_back({one.title, scene});
    figure.surfaces.push_back({one.title, surface, one.kind});
  }
  return figure;
}

// a - b tau, the edge of regression (ZW06.8), at even parameters; b is given as a function of u.
template <class B>
std::vector<Vector> edge_of_rulings(const std::vector<Row>& d, const B& b) {
  const DrawnSurface drawn(through_directrix(d));
  std::vector<Vector> edge;
  for (int i = 0; i <= 48; ++i) {
    const double u = i / 48.0;
    edge.push_back(drawn.at(u, -b(u)));
  }
  return edge;
}

// q_i - p_i = s^i e: the sides of the net are parallel and shrink by the factor s (FJ07.4).
Case cylinder(const Rational& s) {
  std::vector<Rational> lengths{Rational(3)};
  while (lengths.size() < directrix().size()) lengths.push_back(s * lengths.back());
  Row e;
  e << Rational(0), ratio<Rational>(-1, 4), Rational(0), Rational(1);
  return {"sigma = " + short_number(s), cylinder_net<Rational, Row>(directrix(), e, lengths), SurfaceClass::cylinder};
}

Figure figure1() {
  return figure_of("Cylinders: the rulings are parallel, q_{i+1} - p_{i+1} = sigma (q_i - p_i) (ZW06.6).",
                   {cylinder(Rational(1)), cylinder(ratio<Rational>(4, 5))});
}

Figure figure2() {
  const Row q0 = rows_of({{3, -1, 4}}).front();
  const auto cone = [&](const Rational& rho) {
    return Case{"rho = " + short_number(rho),
                cone_net<Rational, Row>(directrix(), rho, q0),
                SurfaceClass::cone,
                {place(cone_vertex<Rational, Row>(directrix()[0], q0, rho))}};
  };
  return figure_of("Cones q_i = q_0 + rho (p_i - p_0) (ZW06.12); for rho = 0 the second row is the vertex.",
                   {cone(ratio<Rational>(2, 5)), cone(Rational(0))});
}

Figure figure3() {
  const auto cone = [](const Rational& s) {
    return Case{"sigma = " + short_number(s),
                start_cone_net<Rational, Row>(directrix(), s),
                SurfaceClass::cone,
                {place(directrix()[0])}};
  };
  return figure_of("Cones with a = sigma, b = sigma u (ZW06.13): the vertex is p_0.",
                   {cone(Rational(3)), cone(ratio<Rational>(4, 5))});
}

Figure figure4() {
  const std::vector<Row> d = mean_tangent_net<Rational, Row>(directrix());
  return figure_of(
      "a = 2, b = u (ZW06.16). The edge of regression a(u) - u tau(u), in red, is the curve of the running "
      "means (1/u) int_0^u a.",
      {{"a = 2, b = u", d, SurfaceClass::tangent, edge_of_rulings(d, [](double u) { return u; })}});
}

Figure figure5() {
  const std::vector<Row> d = tangent_net<Rational, Row>(directrix());
  return figure_of("a = 1, b = 0 (ZW06.17): the directrix itself, in red, is the edge of regression.",
                   {{"a = 1, b = 0", d, SurfaceClass::tangent, edge_of_rulings(d, [](double) { return 0.0; })}});
}

Figure figure6() {
  const std::vector<Row> d = mean_chord_net<Rational, Row>(directrix());
  return figure_of(
      "a = 1/u, b = 1 (ZW06.18). The edge of regression a(u) - tau(u) is that of Figure 4: both surfaces are "
      "one, the rulings of this one are u times those.",
      {{"a = 1/u, b = 1", d, SurfaceClass::tangent, edge_of_rulings(d, [](double) { return 1.0; })}});
}

Figure figure7() {
  const Row q0 = rows_of({{0, -1, 2}}).front();
  const auto aumann = [&](const Rational& rho, const Rational& s) {
    std::vector<Row> d = affine_net<Rational, Row>(directrix(), rho, s, q0);
    const double r = rho.to_double();
    const double t = s.to_double();
    std::vector<Vector> edge = edge_of_rulings(d, [&](double u) { return (1 - u + t * u) / (r - 1); });
    return Case{fmt::format("rho = {}, sigma = {}", short_number(rho), short_number(s)), std::move(d),
                SurfaceClass::tangent, std::move(edge)};
  };
  return figure_of(
      "Aumann's surfaces q_{i+1} = p_i + rho (p_{i+1} - p_i) + sigma (q_i - p_i) (ZW06.20), with their edges "
      "of regression.",
      {aumann(ratio<Rational>(9, 10), ratio<Rational>(11, 10)),
       aumann(ratio<Rational>(1, 3), ratio<Rational>(11, 10))});
}

}  // namespace

std::vector<PaperFigure> zw06_figures() {
  return {{"ZW06.Fig1", "Bezier cylinders", figure1},
          {"ZW06.Fig2", "Bezier cones with a free vertex", figure2},
          {"ZW06.Fig3", "Bezier cones with the vertex p_0", figure3},
          {"ZW06.Fig4", "a Bezier tangent surface, a = 2, b = u", figure4},
          {"ZW06.Fig5", "a Bezier tangent surface, a = 1, b = 0", figure5},
          {"ZW06.Fig6", "a Bezier tangent surface, a = 1/u, b = 1", figure6},
          {"ZW06.Fig7", "Aumann's Bezier tangent surfaces", figure7}};
}

}  // namespace torse::figures
