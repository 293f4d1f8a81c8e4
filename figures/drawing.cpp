#include "torse/figures/drawing.hpp"

namespace torse::figures {

Scene net_scene(const Surface& surface, const DrawnSurface& drawn, const Eye& eye, bool net) {
  Scene scene(eye.azimuth, eye.elevation);
  constexpr std::size_t count = 48;
  const std::vector<std::vector<Vector>> rows = drawn.rulings(count);
  scene.surface(rows, 205);
  std::vector<Vector> c;
  std::vector<Vector> d;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % 4 == 0) scene.line(rows[i], {ruling_colour, 0.5});
    c.push_back(rows[i].front());
    d.push_back(rows[i].back());
  }
  scene.line(c, {c_colour, 1.8});
  scene.line(d, {d_colour, 1.8});
  if (net) {
    const std::vector<Vector> first = places(surface.c);
    const std::vector<Vector> second = places(surface.d);
    for (std::size_t i = 0; i < first.size(); ++i) scene.line({first[i], second[i]}, {help_colour, 0.8, true});
    scene.polygon(first, {c_colour, 1});
    scene.polygon(second, {d_colour, 1});
  }
  return scene;
}

Scene warp_scene(const std::vector<quasi::SampledRuling>& rulings, double largest, const Eye& eye) {
  Scene scene(eye.azimuth, eye.elevation);
  for (std::size_t i = 0; i + 1 < rulings.size(); ++i) {
    const quasi::SampledRuling& a = rulings[i];
    const quasi::SampledRuling& b = rulings[i + 1];
    scene.facet({a.c, a.d, b.d, b.c}, warp_colour(largest > 0 ? (a.warp + b.warp) / 2 / largest : 0));
    if (i % 6 == 0) scene.line({a.c, a.d}, {"#0006", 0.5});
  }
  return scene;
}

}  // namespace torse::figures
