#include "torse/figures/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace torse::figures {
namespace {

constexpr double gap = 20;
constexpr double head = 50;
constexpr std::size_t most_columns = 3;

struct Size {
  double width;
  double height;
};

// One picture fills the page; more stand in columns.
Size panel_size(std::size_t panels) { return panels == 1 ? Size{700, 400} : Size{340, 280}; }

// Words of the caption in lines of at most `width` letters.
std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

std::string panel_svg(const Panel& panel, const Frame& frame) {
  if (const SvgPlot* plot = std::get_if<SvgPlot>(&panel.picture)) {
    return plot->text({frame.x + 50, frame.y + 30, frame.width - 70, frame.height - 80});
  }
  return fmt::format(
      " <g>\n  <text class=\"title\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n{} </g>\n", frame.x, frame.y + 12,
      svg_escaped(panel.title),
      std::get<Scene>(panel.picture).svg({frame.x + 20, frame.y + 30, frame.width - 40, frame.height - 50}));
}

}  // namespace

std::vector<PaperFigure> all_figures() {
  std::vector<PaperFigure> all;
  for (auto of_paper : {fj07_figures, zw06_figures, fj21_figures, bzz19_figures})
    std::ranges::move(of_paper(), std::back_inserter(all));
  return all;
}

std::string figure_svg(const PaperFigure& paper, const Figure& figure) {
  const std::size_t columns = std::min(most_columns, figure.panels.size());
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  const Size size = panel_size(figure.panels.size());
  const double width = static_cast<double>(columns) * (size.width + gap) + gap;
  const std::vector<std::string> caption = lines_of(figure.caption, static_cast<std::size_t>(width / 6.2));
  const double foot = head + static_cast<double>(rows) * (size.height + gap);
  const double height = foot + 16 * static_cast<double>(caption.size()) + gap;
  const std::string title = svg_escaped(paper.id + ": " + paper.title);
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
      "role=\"img\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n <title>{2}</title>\n <desc>{3}</desc>\n"
      " <style>text{{font:12px sans-serif;fill:#222}}.head{{font-weight:bold;font-size:15px}}.title{{font-weight:bold}}"
      ".grid{{stroke:#ddd}}.frame{{fill:none;stroke:#888}}.legend{{paint-order:stroke;stroke:white;stroke-width:3px}}"
      "polyline{{fill:none;stroke-width:1.5}}</style>\n"
      " <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n <text class=\"head\" x=\"{4}\" y=\"28\">{2}</text>\n",
      width, height, title, svg_escaped(figure.caption), gap);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    svg += panel_svg(figure.panels[i],
                     {gap + static_cast<double>(i % columns) * (size.width + gap),
                      head + static_cast<double>(i / columns) * (size.height + gap), size.width, size.height});
  }
  for (std::size_t i = 0; i < caption.size(); ++i) {
    svg += fmt::format(" <text x=\"{}\" y=\"{:.2f}\">{}</text>\n", gap, foot + 16 * static_cast<double>(i),
                       svg_escaped(caption[i]));
  }
  return svg + "</svg>\n";
}

}  // namespace torse::figures
