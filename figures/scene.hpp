// Pictures of curves and surfaces in space, as SVG.
//   Vector, Ink    a place in space, how a line is drawn
//   Scene          what is to be seen, from where
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "torse/figures/svg.hpp"

namespace torse::figures {

using Vector = Eigen::Vector3d;

/// How a line is drawn: a colour of SVG, a width in user units.
struct Ink {
  std::string colour;
  double width = 1;
  bool dashed = false;
};

/// Surfaces, lines, dots and words in space in parallel projection, z upwards. What is nearer hides what is behind it
/// (by the painter's algorithm); dots and words are never hidden.
class Scene {
 public:
  /// Seen from azimuth (from the x axis towards the y axis) and elevation, in degrees.
  Scene(double azimuth, double elevation);

  /// Quadrangles between neighbouring rows of points, all rows of equal length, shaded by their inclination to the
  /// light. `hue` in degrees as in hsl().
  void surface(const std::vector<std::vector<Vector>>& rows, double hue);
  /// A quadrangle of one colour of SVG, such as a ruling's share of a strip.
  void facet(const std::vector<Vector>& corners, const std::string& colour);
  /// A transparent polygon.
  void plane(const std::vector<Vector>& corners, const std::string& colour);
  /// A line through the points.
  void line(const std::vector<Vector>& points, const Ink& ink);
  /// A polygon with a dot at each vertex.
  void polygon(const std::vector<Vector>& points, const Ink& ink);
  void dot(const Vector& at, const std::string& colour, double radius = 2.6);
  /// A word beside a place, moved by so many user units to the right and downwards.
  void word(const Vector& at, const std::string& text, double right = 5, double down = -5);

  /// The elements of the picture, as large as fits into the frame. Throws InvalidInput naming "scene" for places that
  /// are not finite.
  std::string svg(const Frame& frame) const;

 private:
  struct Shape {
    std::vector<Vector> points;
    std::string style;
    bool closed;
    double nearer;  ///< by which lines are drawn over the surfaces that they lie in, as a share of the scene
  };
  struct Mark {
    Vector at;
    std::string text;
    std::string colour;
    double radius;
    double right;
    double down;
  };

  Vector seen(const Vector& x) const { return view_ * x; }
  double shade(const std::vector<Vector>& corners) const;

  Eigen::Matrix3d view_;  // rows: right, up, towards the eye
  std::vector<Shape> shapes_;
  std::vector<Mark> marks_;
};

}  // namespace torse::figures
