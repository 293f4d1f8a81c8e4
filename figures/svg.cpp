#include "torse/figures/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torse::figures {
namespace {

constexpr int tick_count = 4;

}  // namespace

std::string svg_escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string warp_colour(double share) {
  const double hue = 240 * (1 - std::clamp(share, 0.0, 1.0));
  return fmt::format("hsl({:.0f},85%,{:.0f}%)", hue, 45.0);
}

SvgPlot::SvgPlot(std::string title, bool logarithmic) : title_(std::move(title)), logarithmic_(logarithmic) {}

void SvgPlot::axes(std::string horizontal, std::string vertical) {
  horizontal_ = std::move(horizontal);
  vertical_ = std::move(vertical);
}

void SvgPlot::add(const SvgLine& line, std::string colour, std::string name) {
  Named named{{}, std::move(colour), std::move(name)};
  for (const auto& [x, y] : line) {
    if (!std::isfinite(x) || !std::isfinite(y) || (logarithmic_ && !(y > 0))) continue;
    named.points.emplace_back(x, logarithmic_ ? std::log10(y) : y);
  }
  lines_.push_back(std::move(named));
}

SvgPlot::Span SvgPlot::span(bool vertical) const {
  Span span{0, 0};
  bool first = true;
  for (const Named& line : lines_) {
    for (const auto& point : line.points) {
      const double value = vertical ? point.second : point.first;
      span.low = first ? value : std::min(span.low, value);
      span.high = first ? value : std::max(span.high, value);
      first = false;
    }
  }
  if (vertical && !logarithmic_ && span.low > 0) span.low = 0;
  if (!(span.high > span.low)) span.high = span.low + 1;
  return span;
}

std::string SvgPlot::ticks(const Frame& frame, const Span& across, const Span& up) const {
  std::string text;
  for (int i = 0; i <= tick_count; ++i) {
    const double share = static_cast<double>(i) / tick_count;
    const double value = up.low + share * (up.high - up.low);
    const double y = frame.y + frame.height * (1 - share);
    text += fmt::format("  <line class=\"grid\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n", frame.x,
                        y, frame.x + frame.width, y);
    text += fmt::format("  <text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\">{:.3g}</text>\n", frame.x - 5, y + 4,
                        logarithmic_ ? std::pow(10, value) : value);
    text += fmt::format("  <text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{:.3g}</text>\n",
                        frame.x + share * frame.width, frame.y + frame.height + 15,
                        across.low + share * (across.high - across.low));
  }
  return text;
}

std::string SvgPlot::text(const Frame& frame) const {
  const Span across = span(false);
  const Span up = span(true);
  std::string svg = fmt::format(" <g>\n  <text class=\"title\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", frame.x,
                                frame.y - 10, svg_escaped(title_));
  svg += ticks(frame, across, up);
  svg += fmt::format("  <rect class=\"frame\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                     frame.x, frame.y, frame.width, frame.height);
  double legend = frame.y + 14;
  for (const Named& line : lines_) {
    std::string points;
    for (const auto& [x, y] : line.points) {
      points += fmt::format("{:.2f},{:.2f} ", frame.x + frame.width * across.place(x),
                            frame.y + frame.height * (1 - up.place(y)));
    }
    svg += fmt::format("  <polyline stroke=\"{}\" points=\"{}\"/>\n", line.colour, points);
    svg += fmt::format("  <text class=\"legend\" x=\"{:.2f}\" y=\"{:.2f}\" style=\"fill:{}\">{}</text>\n", frame.x + 8,
                       legend, line.colour, svg_escaped(line.name));
    legend += 14;
  }
  svg += fmt::format("  <text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{}</text>\n", frame.x + frame.width / 2,
                     frame.y + frame.height + 30, svg_escaped(horizontal_));
  return svg + fmt::format("  <text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\">{}</text>\n </g>\n",
                           frame.x + frame.width, frame.y - 10, svg_escaped(vertical_));
}

}  // namespace torse::figures
