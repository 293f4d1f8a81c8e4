// A point of a parabola with doubles: torse::torse alone.
#include <cstdio>

#include "torse/scalar/builtin.hpp"
#include "torse/spline/curve.hpp"

int main() {
  using Point = torse::Vec<double, 2>;
  const torse::Spline<double, Point> c(torse::bezier_knots<double>(2), {Point(0, 0), Point(1, 2), Point(3, 0)});
  const Point p = torse::curve_point(c.knots, c.points(), 1, 0.25);
  std::printf("%.17g %.17g\n", p[0], p[1]);
}
