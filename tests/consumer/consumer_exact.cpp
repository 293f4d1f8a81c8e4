// A developable surface through a cubic spline with two pieces, in exact arithmetic.
#include <iostream>

#include "torse/developable/condition.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/rational/rational.hpp"

int main() {
  using Q = torse::Rational;
  using Point = torse::Vec<Q, 3>;
  const auto point = [](int x, int y, int z) { return Point(Q(x), Q(y), Q(z)); };

  const torse::KnotList<Q> u(3, {Q(0), Q(0), Q(0), torse::ratio<Q>(2, 3), Q(1), Q(1), Q(1)});
  const std::vector<Point> c{point(0, 0, 0), point(1, 2, 0), point(2, 2, 1), point(3, 0, 1), point(4, 0, 0)};
  const Q lambda(-2);  // Lambda*, M* and d_0 are the free parameters of FJ07.13
  const Q m(-1);
  std::vector<Point> d = torse::linear_net<Q, Point>(u, c, lambda, m, point(0, 0, 2));
  std::cout << "d_4 = " << d[4][0].text() << ", " << d[4][1].text() << ", " << d[4][2].text() << '\n';

  std::cout << "developable: " << !torse::find_witness<Q, 3>(u, c, d) << '\n';
  d[4][2] += Q::from_text("1/1000000000000000000000000000000");
  const auto witness = torse::find_witness<Q, 3>(u, c, d);
  std::cout << "moved by 1e-30: piece " << witness->piece << ", coefficient " << witness->coefficient << '\n';
}
