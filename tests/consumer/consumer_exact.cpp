// A point of a parabola over the rationals: torse::exact.
#include <cstdio>

#include "torse/exact/rational/rational.hpp"
#include "torse/spline/curve.hpp"

int main() {
  using Q = torse::Rational;
  using Point = torse::Vec<Q, 2>;
  const torse::Spline<Q, Point> c(torse::bezier_knots<Q>(2), {Point(Q(0), Q(0)), Point(Q(1), Q(2)), Point(Q(3), Q(0))});
  const Point p = torse::curve_point(c.knots, c.points(), 1, torse::ratio<Q>(1, 3));
  std::printf("%s %s\n", torse::as_text(p[0]).c_str(), torse::as_text(p[1]).c_str());
}
