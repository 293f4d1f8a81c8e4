// Figures 8.1 to 8.4 of FJ21: the patch of the worked example.
#include <fmt/format.h>

#include "torse/developable/regression.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/figures/drawing.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::figures {
namespace {

using Net = proofs::Section8Net<Rational>;

constexpr Eye eye{-125, 22};

const proofs::Section8Data<Rational>& data() {
  static const proofs::Section8Data<Rational> values;
  return values;
}

const Linear<Rational>& unit() {
  static const Linear<Rational> one{Rational(1), Rational(0)};
  return one;
}

Surface bezier(std::vector<Row> p, std::vector<Row> q) {
  const int degree = static_cast<int>(p.size()) - 1;
  return Surface(bezier_knots<Rational>(degree), std::move(p), std::move(q));
}

std::string list(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) text += (text.empty() ? "" : ", ") + short_number(row[0]);
  return "{" + text + "}";
}

Figure one_panel(std::string caption, std::string title, Scene scene, Surface surface) {
  return {std::move(caption), {{title, std::move(scene)}}, {{title, std::move(surface), SurfaceClass::tangent}}};
}

Figure figure1() {
  const Net net(data());
  const Surface surface = bezier(net.p, net.q);
  Scene scene = net_scene(surface, DrawnSurface(surface), eye, true);
  const Rational v0 = edge_parameter(Rational(0), net.f);
  const Rational v1 = edge_parameter(Rational(1), net.f);
  return one_panel(
      fmt::format(
          "Weights {} and {}, Lam = {}, M = {}, sigma = {}. The edge of regression has v(t) = {} t + {}: it is far "
          "from the patch.",
          list(net.p), list(net.q), short_number(net.f.lambda), short_number(net.f.m), short_number(net.f.sigma),
          short_number(v1 - v0), short_number(v0)),
      "rational cubics", std::move(scene), surface);
}

Figure figure2() {
  const Net net(data());
  const Surface surface = bezier(times_linear(net.p, unit()), times_linear(net.q, unit()));
  return one_panel(
      fmt::format("The same patch with both curves of degree 4; weights {} and {}.", list(surface.c), list(surface.d)),
      "degree 4", net_scene(surface, DrawnSurface(surface), eye, true), surface);
}

Figure figure3() {
  const Net net(data());
  const Linear<Rational>& g = data().g;
  std::vector<Row> q = times_linear(net.p, Linear<Rational>{unit().constant - g.constant, unit().slope - g.slope});
  const std::vector<Row> part = times_linear(net.q, g);
  for (std::size_t i = 0; i < q.size(); ++i) add(q[i], part[i]);
  const Surface surface = bezier(times_linear(net.p, unit()), std::move(q));
  return one_panel(
      "The rulings W = q - p multiplied by g = 1 - 3t/4 (FJ21.5.4): the last one is a quarter of what it was.",
      "trimmed", net_scene(surface, DrawnSurface(surface), eye, true), surface);
}

Figure figure4() {
  const Net net(data());
  const auto inserted = [&](const std::vector<Row>& rows) {
    return insert_knot(Spline<Rational, Row>(net.u, rows), data().knot, 2);
  };
  const Spline<Rational, Row> p = inserted(net.p);
  const Surface surface(p.knots, p.control, inserted(net.q).control);
  return one_panel(fmt::format("The knot {} inserted: five points a row, the same surface, Lam, M and sigma.",
                               short_number(data().knot)),
                   "knot " + short_number(data().knot), net_scene(surface, DrawnSurface(surface), eye, true), surface);
}

}  // namespace

std::vector<PaperFigure> fj21_figures() {
  return {{"FJ21.Fig8.1", "a developable surface between rational cubics", figure1},
          {"FJ21.Fig8.2", "the patch with its degree raised", figure2},
          {"FJ21.Fig8.3", "the trimmed patch", figure3},
          {"FJ21.Fig8.4", "the patch with a knot inserted", figure4}};
}

}  // namespace torse::figures
