// The picture of a fit: the strip before and after with its warp in colours, the mapping, the warp and the convergence.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "torse/cli/fit_report.hpp"
#include "torse/figures/svg.hpp"

namespace torse::cli {
namespace {

using quasi::SampledRuling;
using quasi::Vector;

constexpr double page_width = 960;
constexpr double page_height = 760;

constexpr const char* old_colour = "#c0392b";
constexpr const char* new_colour = "#1f5fa8";

/// A view in which the strip is seen about as broad as it is: along its least principal axis, tilted by some 25
/// degrees.
struct View {
  Vector middle;
  Vector right;
  Vector up;

  explicit View(const std::vector<SampledRuling>& rulings) : middle(Vector::Zero()) {
    for (const SampledRuling& ruling : rulings) middle += ruling.c + ruling.d;
    middle /= 2 * static_cast<double>(rulings.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const SampledRuling& ruling : rulings) {
      for (const Vector& x : {ruling.c, ruling.d}) spread += (x - middle) * (x - middle).transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(spread);
    right = solver.eigenvectors().col(2);
    right *= std::copysign(1.0, right[0]);
    up = 0.9 * solver.eigenvectors().col(1) + 0.43 * solver.eigenvectors().col(0);
  }

  std::array<double, 2> of(const Vector& x) const { return {right.dot(x - middle), up.dot(x - middle)}; }
};

/// The strip as quadrangles between neighbouring rulings, coloured by their warp.
std::string strip_picture(const std::vector<SampledRuling>& rulings, const View& view, double largest, double x,
                          double y, double width, double height) {
  std::vector<std::array<std::array<double, 2>, 2>> lines;
  std::array<double, 2> reach{1e-9, 1e-9};
  for (const SampledRuling& ruling : rulings) {
    lines.push_back({view.of(ruling.c), view.of(ruling.d)});
    for (const auto& end : lines.back()) {
      for (std::size_t k = 0; k < 2; ++k) reach[k] = std::max(reach[k], std::abs(end[k]));
    }
  }
  const double scale = 0.5 * std::min(width / reach[0], height / reach[1]);
  const auto at = [&](const std::array<double, 2>& end) {
    return fmt::format("{:.2f},{:.2f}", x + width / 2 + scale * end[0], y + height / 2 - scale * end[1]);
  };
  std::string svg;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double warp = (rulings[i].warp + rulings[i + 1].warp) / 2;
    const std::string colour = figures::warp_colour(largest > 0 ? warp / largest : 0);
    svg += fmt::format("  <path fill=\"{0}\" stroke=\"{0}\" d=\"M{1} {2} {3} {4}Z\"/>\n", colour, at(lines[i][0]),
                       at(lines[i][1]), at(lines[i + 1][1]), at(lines[i + 1][0]));
  }
  for (std::size_t i = 0; i < lines.size(); i += 8) {
    svg += fmt::format("  <path class=\"ruling\" d=\"M{} {}\"/>\n", at(lines[i][0]), at(lines[i][1]));
  }
  return svg;
}

std::string colour_bar(double largest, double x, double y, double width) {
  std::string svg;
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    svg += fmt::format("  <rect fill=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"10\"/>\n",
                       figures::warp_colour((i + 0.5) / steps), x + i * width / steps, y, width / steps + 0.5);
  }
  return svg + fmt::format(
                   "  <text x=\"{:.2f}\" y=\"{:.2f}\">0</text>\n  <text x=\"{:.2f}\" y=\"{:.2f}\" "
                   "text-anchor=\"end\">warp {:.4g} degrees</text>\n",
                   x, y + 24, x + width, y + 24, largest);
}

figures::SvgLine line_of(const std::vector<SampledRuling>& rulings, double SampledRuling::*value) {
  figures::SvgLine line;
  for (const SampledRuling& ruling : rulings) line.emplace_back(ruling.t, ruling.*value);
  return line;
}

std::string diagrams(const FittedStrip& strip) {
  figures::SvgPlot mapping("mapping");
  mapping.axes("t", "T");
  mapping.add(line_of(strip.old_rulings, &SampledRuling::target), old_colour, "T = t");
  mapping.add(line_of(strip.rulings, &SampledRuling::target), new_colour, "fitted");
  figures::SvgPlot warp("warp along the first rail", true);
  warp.axes("t", "degrees");
  warp.add(line_of(strip.old_rulings, &SampledRuling::warp), old_colour, "T = t");
  warp.add(line_of(strip.rulings, &SampledRuling::warp), new_colour, "fitted");
  figures::SvgPlot convergence("convergence", true);
  convergence.axes("milliseconds", strip.method.paper ? "objective" : "degrees");
  figures::SvgLine curve;
  if (strip.method.fit) {
    for (const quasi::FitStep& step : strip.method.fit->curve) curve.emplace_back(1000 * step.seconds, step.value);
  }
  if (strip.method.paper) {
    for (const quasi::PaperStep& step : strip.method.paper->curve)
      curve.emplace_back(1000 * step.seconds, step.objective);
  }
  convergence.add(curve, new_colour, "least so far");
  return mapping.text({60, 460, 230, 230}) + warp.text({370, 460, 230, 230}) + convergence.text({690, 460, 230, 230});
}

}  // namespace

std::string fit_svg(const FitTitle& title, const FittedStrip& strip) {
  const View view(strip.old_rulings);
  double largest = 0;
  for (const SampledRuling& ruling : strip.old_rulings) largest = std::max(largest, ruling.warp);
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
      "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      page_width, page_height);
  svg += fmt::format(" <title>{}</title>\n", figures::svg_escaped(title.name));
  svg +=
      " <style>text{font:11px sans-serif;fill:#333}.title{font-weight:bold;font-size:13px}.grid{stroke:#ddd}"
      ".frame{fill:none;stroke:#888}.legend{paint-order:stroke;stroke:white;stroke-width:3px}polyline{fill:none;stroke-"
      "width:1.5}.ruling{stroke:#0004;fill:none}"
      "path{stroke-width:0.5}</style>\n <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  const auto panel = [&](const char* name, const quasi::WarpStatistics& warp, const std::vector<SampledRuling>& rulings,
                         double x) {
    return fmt::format(
        " <g>\n  <text class=\"title\" x=\"{:.2f}\" y=\"30\">{}: mean warp {:.4g}, largest {:.4g} degrees"
        "</text>\n{} </g>\n",
        x, name, warp.mean, warp.max, strip_picture(rulings, view, largest, x, 50, 430, 310));
  };
  svg += panel("T = t", strip.before, strip.old_rulings, 30) + panel("fitted", strip.after, strip.rulings, 500);
  return svg + " <g>\n" + colour_bar(largest, 330, 385, 300) + " </g>\n" + diagrams(strip) + "</svg>\n";
}

}  // namespace torse::cli
