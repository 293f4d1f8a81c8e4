// Figures 5 to 7 of BZZ19, on rails of our own of the kinds that the paper shows.
#include <fmt/format.h>

#include <algorithm>

#include "torse/developable/factors.hpp"
#include "torse/figures/drawing.hpp"
#include "torse/quasi/fit.hpp"
#include "torse/quasi/paper_fit.hpp"
#include "torse/quasi/surface.hpp"

namespace torse::figures {
namespace {

constexpr Eye eye{-75, 60};
constexpr std::size_t rulings_drawn = 160;
constexpr std::size_t rulings_measured = 2000;

const char* const colours[] = {"#c0392b", "#1f5fa8", "#1e7d45", "#b8860b"};

using Curve = Spline<Rational, Row>;

// Rails that are joined by an exact developable surface, and the mapping that makes it.
struct KnownRails {
  Curve c;
  Curve d;
  Mapping<Rational> sigma;
};

Curve second_rail() { return {bezier_knots<Rational>(3), rows_of({{0, 0, 0}, {2, 3, 0}, {6, 3, 2}, {8, 0, 1}})}; }

Mapping<Rational> polynomial_mapping(const std::vector<Rational>& beta) {
  return mapping_of(bezier_knots<Rational>(static_cast<int>(beta.size()) - 1), beta);
}

// d(sigma(t)) as a Bezier curve, by Algorithm 1.
std::vector<Row> composed(const Curve& d, const Mapping<Rational>& sigma) { return quasi_surface(d, d, sigma).d; }

// c(t) = a + f(t) (d(sigma(t)) - a): a cone with vertex a.
KnownRails on_a_cone(const Mapping<Rational>& sigma) {
  const Curve d = second_rail();
  const std::vector<Row> image = composed(d, sigma);
  const std::vector<Row> vertex(image.size(), rows_of({{3, -4, 5}}).front());
  const Linear<Rational> f{ratio<Rational>(3, 5), ratio<Rational>(-1, 5)};
  std::vector<Row> c = times_linear(image, f);
  const std::vector<Row> rest = times_linear(vertex, Linear<Rational>{Rational(1) - f.constant, -f.slope});
  for (std::size_t i = 0; i < c.size(); ++i) add(c[i], rest[i]);
  return {{bezier_knots<Rational>(static_cast<int>(c.size()) - 1), c}, d, sigma};
}

quasi::Rail rail(const Curve& curve) {
  std::vector<Vec<double, 4>> rows;
  for (const Row& row : curve.control) {
    rows.emplace_back(row[0].to_double(), row[1].to_double(), row[2].to_double(), row[3].to_double());
  }
  std::vector<double> knots;
  for (const Rational& u : curve.knots.list()) knots.push_back(u.to_double());
  return quasi::Rail(Spline<double, Vec<double, 4>>(KnotList<double>(curve.knots.degree(), knots), rows));
}

Mapping<double> same_parameter() { return identity_mapping(bezier_knots<double>(1)); }

KnotList<double> even_knots(int degree, int coefficients) {
  std::vector<double> breaks;
  for (int i = 0; i <= coefficients - degree; ++i) breaks.push_back(static_cast<double>(i) / (coefficients - degree));
  return quasi::mapping_knots(degree, breaks);
}

// A strip between the rails by one method.
struct Strip {
  std::string name;
  Mapping<double> sigma;
  std::vector<quasi::SampledRuling> rulings;
  quasi::WarpStatistics warp;

  Strip(std::string what, const quasi::Rails& rails, Mapping<double> mapping)
      : name(std::move(what)),
        sigma(std::move(mapping)),
        rulings(quasi::sampled_rulings(rails, sigma, rulings_drawn)),
        warp(quasi::warp_statistics(rails, sigma, rulings_measured)) {}

  std::string text() const {
    return fmt::format("{}: largest warp {:.2g}, mean {:.2g} degrees", name, warp.max, warp.mean);
  }
};

Strip fitted(std::string name, const quasi::Rails& rails, int degree, int coefficients) {
  return {std::move(name), rails, quasi::fit_rails(rails, {.degree = degree, .coefficients = coefficients}).mapping};
}

Strip by_paper(const quasi::Rails& rails, int degree, int coefficients) {
  const KnotList<double> knots = even_knots(degree, coefficients);
  std::vector<double> beta = quasi::paper_fit(rails, knots).beta;
  for (double& b : beta) b = std::clamp(b, 0.0, 1.0);
  return {"BZZ19's objective", rails, mapping_of(knots, beta)};
}

SvgPlot mapping_plot(const std::vector<const Strip*>& strips) {
  SvgPlot plot("mapping");
  plot.axes("t", "T");
  for (std::size_t i = 0; i < strips.size(); ++i) {
    SvgLine line;
    for (const quasi::SampledRuling& ruling : strips[i]->rulings) line.emplace_back(ruling.t, ruling.target);
    plot.add(line, colours[i % std::size(colours)], strips[i]->name);
  }
  return plot;
}

SvgPlot warp_plot(const std::vector<const Strip*>& strips) {
  SvgPlot plot("warp along the first rail", true);
  plot.axes("t", "degrees");
  for (std::size_t i = 0; i < strips.size(); ++i) {
    SvgLine line;
    for (const quasi::SampledRuling& ruling : strips[i]->rulings) line.emplace_back(ruling.t, ruling.warp);
    plot.add(line, colours[i % std::size(colours)], strips[i]->name);
  }
  return plot;
}

Panel strip_panel(const Strip& strip, double largest) {
  return {fmt::format("{} ({:.2g}, {:.2g})", strip.name, strip.warp.max, strip.warp.mean),
          warp_scene(strip.rulings, largest, eye)};
}

std::string sentences(const std::vector<const Strip*>& strips) {
  std::string text;
  for (const Strip* strip : strips) text += strip->text() + ". ";
  return text;
}

Figure figure5() {
  const KnownRails known =
      on_a_cone(polynomial_mapping({Rational(0), ratio<Rational>(2, 3), ratio<Rational>(11, 15), Rational(1)}));
  const quasi::Rails rails{rail(known.c), rail(known.d)};
  const Strip same("T = t", rails, same_parameter());
  const Strip linear = fitted("degree 1, 100 coefficients", rails, 1, 100);
  const Strip quadratic = fitted("degree 2, 100 coefficients", rails, 2, 100);
  const Strip cubic = fitted("degree 3, 100 coefficients", rails, 3, 100);
  const Strip finer = fitted("degree 2, 200 coefficients", rails, 2, 200);
  const std::vector<const Strip*> fits{&linear, &quadratic, &cubic, &finer};
  return {"Rails that bound a cone for the mapping T = 2t - 9/5 t^2 + 4/5 t^3. " + sentences(fits),
          {strip_panel(same, same.warp.max),
           strip_panel(quadratic, same.warp.max),
           {"", mapping_plot({&same, &quadratic})},
           {"", warp_plot(fits)}},
          {{"exact surface", quasi_surface(known.c, known.d, known.sigma), SurfaceClass::cone}}};
}

Figure figure6() {
  const KnownRails known = on_a_cone(polynomial_mapping({Rational(0), Rational(0), Rational(1)}));
  const quasi::Rails rails{rail(known.c), rail(known.d)};
  const Strip same("T = t", rails, same_parameter());
  const Strip linear = fitted("degree 1, 100 coefficients", rails, 1, 100);
  const Strip quadratic = fitted("degree 2, 3 coefficients", rails, 2, 3);
  return {
      "Rails that bound a cone for T = t^2. A mapping of degree 2 with three coefficients can be t^2 itself; a "
      "polyline "
      "cannot. " +
          sentences({&linear, &quadratic}),
      {strip_panel(same, same.warp.max),
       strip_panel(linear, same.warp.max),
       strip_panel(quadratic, same.warp.max),
       {"", mapping_plot({&same, &linear, &quadratic})},
       {"", warp_plot({&same, &linear, &quadratic})}},
      {{"exact surface", quasi_surface(known.c, known.d, known.sigma), SurfaceClass::cone}}};
}

Figure figure7() {
  const KnotList<Rational> u(
      3, {Rational(0), Rational(0), Rational(0), ratio<Rational>(1, 2), Rational(1), Rational(1), Rational(1)});
  const Curve c(u, rows_of({{0, 0, 0}, {10, 4, 2}, {20, -2, 5}, {30, 3, 1}, {40, 0, 0}}));
  const Curve d(u, rows_of({{2, 15, 1}, {10, 19, 6}, {20, 13, -1}, {30, 18, 3}, {41, 14, 4}}));
  const quasi::Rails rails{rail(c), rail(d)};
  const Strip same("T = t", rails, same_parameter());
  std::vector<double> targets = quasi::discrete_fit(rails, {.samples = 50}).beta;
  for (double& target : targets) target = std::clamp(target, 0.0, 1.0);
  const Strip discrete("50 rulings, joined", rails, mapping_of(even_knots(1, 50), targets));
  const Strip paper = by_paper(rails, 2, 50);
  const Strip ours = fitted("least warp", rails, 2, 50);
  Scene curves(eye.azimuth, eye.elevation);
  std::vector<Vector> on_c;
  std::vector<Vector> on_d;
  for (const quasi::SampledRuling& ruling : same.rulings) {
    on_c.push_back(ruling.c);
    on_d.push_back(ruling.d);
  }
  curves.line(on_c, {c_colour, 2});
  curves.line(on_d, {d_colour, 2});
  const std::vector<const Strip*> strips{&same, &discrete, &paper, &ours};
  std::vector<Panel> panels{{"rails", curves}};
  for (const Strip* strip : strips) panels.push_back(strip_panel(*strip, same.warp.max));
  panels.push_back({"", mapping_plot(strips)});
  panels.push_back({"", warp_plot(strips)});
  return {
      "Two cubic splines that no developable surface joins; in brackets the largest and the mean warp in degrees. The "
      "discrete method optimises its rulings alone; between them the polyline warps. " +
          sentences(strips),
      std::move(panels),
      {{"T = t", Surface(u, c.control, d.control), SurfaceClass::none}}};
}

}  // namespace

std::vector<PaperFigure> bzz19_figures() {
  return {{"BZZ19.Fig5", "degree and number of coefficients", figure5},
          {"BZZ19.Fig6", "a mapping that can be exact", figure6},
          {"BZZ19.Fig7", "discrete and continuous mappings", figure7}};
}

}  // namespace torse::figures
