// Pieces of SVG 1.1.
//   svg_escaped       text for an element or an attribute
//   SvgPlot           a diagram with two axes
//   warp_colour       blue for 0, red for the largest warp
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace torse::figures {

/// The text with &, <, > and " as entities.
std::string svg_escaped(std::string_view text);

/// "hsl(h,s%,l%)" for a share of the largest warp, 0 to 1.
std::string warp_colour(double share);

/// The points of a line, in the units of the axes.
using SvgLine = std::vector<std::pair<double, double>>;

/// A diagram whose axes span what is drawn in it.
class SvgPlot {
 public:
  /// Its frame has the upper left corner (x, y); y is drawn by its logarithm if `logarithmic`, and values not above 0
  /// are left out then.
  SvgPlot(std::string title, double x, double y, double width, double height, bool logarithmic = false);

  /// Names both axes.
  void axes(std::string horizontal, std::string vertical);
  /// Adds a line. Values that are not finite are left out.
  void add(const SvgLine& line, std::string colour, std::string name);
  /// The elements. A diagram without a finite point is a frame with its title.
  std::string text() const;

 private:
  struct Named {
    SvgLine points;
    std::string colour;
    std::string name;
  };
  struct Span {
    double low;
    double high;
    double place(double value) const { return (value - low) / (high - low); }
  };

  Span span(bool vertical) const;
  std::string ticks(const Span& across, const Span& up) const;

  std::string title_;
  std::string horizontal_;
  std::string vertical_;
  double x_;
  double y_;
  double width_;
  double height_;
  bool logarithmic_;
  std::vector<Named> lines_;
};

}  // namespace torse::figures
