// Pieces of SVG 1.1.
//   svg_escaped       text for an element or an attribute
//   Frame             a rectangle of a page
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

/// A rectangle of a page, in user units, y downwards.
struct Frame {
  double x;
  double y;
  double width;
  double height;
};

/// The points of a line, in the units of the axes.
using SvgLine = std::vector<std::pair<double, double>>;

/// A diagram whose axes span what is drawn in it.
class SvgPlot {
 public:
  /// y is drawn by its logarithm if `logarithmic`, and values not above 0 are left out then.
  explicit SvgPlot(std::string title, bool logarithmic = false);

  /// Names both axes.
  void axes(std::string horizontal, std::string vertical);
  /// Adds a line. Values that are not finite are left out.
  void add(const SvgLine& line, std::string colour, std::string name);
  /// The elements; the axes are the sides of the frame, their words stand around it. A diagram without a finite point
  /// is a frame with its title.
  std::string text(const Frame& frame) const;

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
  std::string ticks(const Frame& frame, const Span& across, const Span& up) const;

  std::string title_;
  std::string horizontal_;
  std::string vertical_;
  bool logarithmic_;
  std::vector<Named> lines_;
};

}  // namespace torse::figures
