// Plates against developments found on other ways: distances in planes, Boost's quadrature on cylinders and cones,
// chains of triangles, and sums over fine meshes.
#include "torse/exact/unroll/plate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "unit/exact/unroll_surfaces.hpp"

namespace torse::test {
namespace {

using ::testing::SizeIs;

/// The integral of f over [a, b] by Boost's adaptive quadrature, in parts of a piece.
template <class F>
double integral(F f, double a, double b) {
  double sum = 0;
  constexpr int parts = 4;
  for (int i = 0; i < parts; ++i) {
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, a + (b - a) * i / parts,
                                                                         a + (b - a) * (i + 1) / parts, 8, 1e-11);
  }
  return sum;
}

/// What every plate promises, from its own points and the surface's: ruling lengths, and rails by inscribed polygons,
/// whose lengths grow to the curve's.
void expect_sound(const Surface& surface, const Plate& plate) {
  ASSERT_EQ(plate.c.points.size(), plate.parameters.size());
  ASSERT_EQ(plate.d.points.size(), plate.parameters.size());
  for (std::size_t i = 0; i < plate.parameters.size(); ++i) {
    const Q& t = plate.parameters[i];
    EXPECT_NEAR(distance(plate.c.points[i], plate.d.points[i]), distance(surface.c(t), surface.d(t)),
                plate.ruling_error + 1e-12 * plate.width);
  }
  for (const auto& [rail, row] : {std::pair{&plate.c, &surface.p}, std::pair{&plate.d, &surface.q}}) {
    constexpr int steps = 600;
    double length = 0;
    const Q from = surface.u.domain_begin();
    const Q range = surface.u.domain_end() - from;
    Point last = surface.point(*row, from.to_double());
    for (int i = 1; i <= steps; ++i) {
      const Point next = surface.point(*row, (from + ratio<Q>(i, steps) * range).to_double());
      length += distance(last, next);
      last = next;
    }
    EXPECT_LE(length, rail->before.upper() * (1 + 1e-12));
    EXPECT_GE(length, rail->before.lower() * (1 - 1e-4));
    EXPECT_LE(std::abs(rail->before.lower() - rail->after.lower()), rail->error * (1 + 1e-9) + 1e-13 * length);
    for (const PlatePoint& point : rail->points) {
      EXPECT_GE(point.x, 0);
      EXPECT_GE(point.y, 0);
    }
  }
}

/// In a plane the development is the plane itself: all distances are kept.
void expect_same_distances(const Surface& surface, const Plate& plate) {
  for (std::size_t i = 0; i < plate.parameters.size(); i += 3) {
    for (std::size_t j = 0; j < plate.parameters.size(); j += 5) {
      const Q& s = plate.parameters[i];
      const Q& t = plate.parameters[j];
      const double slack = 2 * plate.vertex_error + 1e-12 * plate.width;
      EXPECT_NEAR(distance(plate.c.points[i], plate.d.points[j]), distance(surface.c(s), surface.d(t)), slack);
      EXPECT_NEAR(distance(plate.c.points[i], plate.c.points[j]), distance(surface.c(s), surface.c(t)), slack);
    }
  }
}

TEST(Plate, APlaneStaysAsItIs) {
  // In the plane spanned by (2, 2, 1)/3 and (1, -2, 2)/3; the rulings turn by more than a right angle.
  const auto in_plane = [](double x, double y) { return std::array<double, 3>{2 * x + y, 2 * x - 2 * y, x + 2 * y}; };
  const Surface surface = bezier(rows({in_plane(0, 0), in_plane(1, 2), in_plane(3, 1), in_plane(4, 0)}, {1, 2, 1, 3}),
                                 rows({in_plane(-3, 1), in_plane(0, 5), in_plane(4, 6), in_plane(8, 2)}, {2, 1, 1, 1}));
  const Plate plate = surface.plate(1e-3);
  expect_sound(surface, plate);
  expect_same_distances(surface, plate);
  EXPECT_LE(plate.deviation, 1e-3);
  EXPECT_LE(plate.vertex_error, 1e-6);
  EXPECT_EQ(plate.overlap.verdict, Truth::no);
}

/// One rail straight, the other one not: each is drawn as finely as it needs.
TEST(Plate, ToleranceOfEitherRail) {
  const Rows line = rows({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  const Rows wave = rows({{0, 2, 0}, {1, 4, 0}, {2, 1, 0}, {3, 3, 0}});
  for (const Surface& surface : {bezier(line, wave), bezier(wave, line)}) {
    const Plate plate = surface.plate(1e-4);
    expect_sound(surface, plate);
    EXPECT_LE(plate.deviation, 1e-4);
  }
}

/// x' = (2t^2 - 1)^2: both rails run along their ruling at the irrational t = 1/sqrt(2).
TEST(Plate, ARulingWhereBothRailsRunAlongIt) {
  Rows exact(6);
  // 4/5 t^5 - 4/3 t^3 + t by its Bezier points.
  const std::array<Q, 6> x{Q(0), ratio<Q>(1, 5), ratio<Q>(2, 5), ratio<Q>(7, 15), ratio<Q>(4, 15), ratio<Q>(7, 15)};
  for (std::size_t i = 0; i < 6; ++i) exact[i] = {Q(1), x[i], ratio<Q>(static_cast<int>(i * i), 25), Q(0)};
  Rows other = exact;
  for (auto& row : other) row[2] += Q(1);
  const Surface surface = bezier(exact, other);
  ASSERT_THAT(surface.strips().front().breaks, SizeIs(1));
  EXPECT_FALSE(surface.strips().front().breaks.front().rational());
  const Plate plate = surface.plate(1e-4);
  expect_sound(surface, plate);
  expect_same_distances(surface, plate);
}

TEST(Plate, ATriangleWithItsTipAtEitherEnd) {
  const Rows p = rows({{0, 0, 0}, {2, 1, 0}, {4, 0, 0}});
  const Rows q = rows({{0, 0, 0}, {2, 2, 0}, {5, 5, 0}});
  const Surface surface = bezier(p, q);
  const Plate plate = surface.plate(1e-4);
  expect_sound(surface, plate);
  expect_same_distances(surface, plate);
  const Surface turned = bezier(Rows(p.rbegin(), p.rend()), Rows(q.rbegin(), q.rend()));
  expect_same_distances(turned, turned.plate(1e-4));
}

/// Along the axis (1, 2, 2)/3: what is along the axis stays, what is across is the arc length of the section.
TEST(Plate, ACylinderUnrollsByTheArcLengthOfItsSection) {
  const Point axis{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const Rows p = rows({{0, 0, 0}, {3, 0, 1}, {5, 4, -1}, {2, 6, 0}, {0, 9, 3}}, {1, 2, 1, 1, 2});
  Rows q = p;
  for (auto& row : q) {
    for (int j = 0; j < 3; ++j) row[j + 1] += row[0] * Q(j == 0 ? 1 : 2);
  }
  const Surface surface{KnotList<Q>(2, {Q(0), Q(0), Q(1), Q(3), Q(4), Q(4)}), p, q};
  const Plate plate = surface.plate(1e-4);
  expect_sound(surface, plate);
  const auto section_speed = [&](double t) {
    const double h = 1e-5;
    const double a = std::max(t - h, 0.0);
    const double b = std::min(t + h, 4.0);
    Point v = minus(surface.c(b), surface.c(a));
    const double along = dot(v, axis);
    return std::sqrt(std::max(dot(v, v) - along * along, 0.0)) / (b - a);
  };
  const double length = integral(section_speed, 0, 1) + integral(section_speed, 1, 3) + integral(section_speed, 3, 4);
  EXPECT_NEAR(plate.area_before.lower(), 3 * length, 1e-5);
  EXPECT_NEAR(plate.area_after.lower(), 3 * length, 1e-3);
  // Along and across from the plate: rulings are parallel.
  const PlatePoint& c0 = plate.c.points.front();
  const PlatePoint& cn = plate.c.points.back();
  const PlatePoint& d0 = plate.d.points.front();
  const double ux = (d0.x - c0.x) / 3;
  const double uy = (d0.y - c0.y) / 3;
  EXPECT_NEAR((cn.x - c0.x) * ux + (cn.y - c0.y) * uy, dot(minus(surface.c(4.0), surface.c(0.0)), axis), 1e-5);
  EXPECT_NEAR(std::abs((cn.x - c0.x) * uy - (cn.y - c0.y) * ux), length, 1e-5);
}

/// About its vertex a cone unrolls to polar coordinates: the radius stays, the angle is the arc on the unit sphere.
TEST(Plate, AConeUnrollsToASector) {
  const std::vector<std::array<double, 3>> base{{4, 0, 0}, {4, 5, 1}, {-3, 6, 2}, {-6, -1, 0}};
  const std::vector<double> weights{1, 2, 1, 1};
  const Point vertex{0, 0, 5};
  std::vector<std::array<double, 3>> upper = base;
  for (auto& x : upper) x = {x[0] / 4, x[1] / 4, 5 + (x[2] - 5) / 4};
  const Surface surface = bezier(rows(base, weights), rows(upper, weights));
  const Plate plate = surface.plate(1e-4);
  expect_sound(surface, plate);
  const auto direction = [&](double t) {
    Point v = minus(surface.c(t), vertex);
    const double r = std::sqrt(dot(v, v));
    for (double& x : v) x /= r;
    return v;
  };
  const auto turn = [&](double t) {
    const double h = 1e-5;
    return distance(direction(std::min(t + h, 1.0)), direction(std::max(t - h, 0.0))) /
           (std::min(t + h, 1.0) - std::max(t - h, 0.0));
  };
  const double angle = integral(turn, 0, 1);
  const double a = distance(surface.c(0.0), vertex);
  const double b = distance(surface.c(1.0), vertex);
  EXPECT_NEAR(distance(plate.c.points.front(), plate.c.points.back()),
              std::sqrt(a * a + b * b - 2 * a * b * std::cos(angle)), 1e-6);
  EXPECT_NEAR(distance(plate.c.points.front(), plate.d.points.back()),
              std::sqrt(a * a + b * b / 16 - a * b / 2 * std::cos(angle)), 1e-6);
  const double area = integral(
      [&](double t) { return turn(t) * dot(minus(surface.c(t), vertex), minus(surface.c(t), vertex)) / 2; }, 0, 1);
  EXPECT_NEAR(plate.area_before.lower(), area * 15 / 16, 1e-5);
}

/// The image of the last ruling by a chain of triangles between the rulings, whose sides are straight in space: an
/// error of second order in their number, removed by Richardson's extrapolation.
std::array<double, 4> by_triangles(const Surface& surface, int steps) {
  const auto apex = [](const PlatePoint& a, const PlatePoint& b, double from_a, double from_b) {
    const double base = distance(a, b);
    const double x = (base * base + from_a * from_a - from_b * from_b) / (2 * base);
    const double y = std::sqrt(from_a * from_a - x * x);
    const double ux = (b.x - a.x) / base;
    const double uy = (b.y - a.y) / base;
    return PlatePoint{a.x + x * ux + y * uy, a.y + x * uy - y * ux};  // to the right of a -> b
  };
  Point c = surface.c(0.0);
  Point d = surface.d(0.0);
  PlatePoint p{0, 0};
  PlatePoint q{0, distance(c, d)};
  for (int i = 1; i <= steps; ++i) {
    const Point next_c = surface.c(static_cast<double>(i) / steps);
    const Point next_d = surface.d(static_cast<double>(i) / steps);
    const PlatePoint new_p = apex(p, q, distance(c, next_c), distance(d, next_c));
    q = apex(new_p, q, distance(next_c, next_d), distance(d, next_d));
    p = new_p;
    c = next_c;
    d = next_d;
  }
  return {p.x, p.y, q.x, q.y};
}

TEST(Plate, ATangentSurfaceAsAChainOfTriangles) {
  const Surface surface = tangent_surface();
  const Plate plate = surface.plate(1e-5);
  expect_sound(surface, plate);
  const auto coarse = by_triangles(surface, 400);
  const auto fine = by_triangles(surface, 800);
  const auto last = [&](std::size_t j) { return fine[j] + (fine[j] - coarse[j]) / 3; };
  const PlatePoint first_c{0, 0};
  const PlatePoint first_d{0, distance(surface.c(0.0), surface.d(0.0))};
  const PlatePoint last_c{last(0), last(1)};
  const PlatePoint last_d{last(2), last(3)};
  EXPECT_NEAR(distance(plate.c.points.front(), plate.c.points.back()), distance(first_c, last_c), 1e-6);
  EXPECT_NEAR(distance(plate.c.points.front(), plate.d.points.back()), distance(first_c, last_d), 1e-6);
  EXPECT_NEAR(distance(plate.d.points.front(), plate.c.points.back()), distance(first_d, last_c), 1e-6);
  EXPECT_NEAR(distance(plate.d.points.front(), plate.d.points.back()), distance(first_d, last_d), 1e-6);
  // On the same side too: C runs to the right while the rulings run up.
  const auto side = [](const PlatePoint& a, const PlatePoint& b, const PlatePoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
  };
  EXPECT_EQ(side(plate.c.points.front(), plate.d.points.front(), plate.c.points.back()),
            side(first_c, first_d, last_c));
}

TEST(Plate, AreaBeforeIsThatOfAFineMesh) {
  const Surface surface = tangent_surface();
  const Plate plate = surface.plate(1e-4);
  constexpr int steps = 600;
  double area = 0;
  const auto triangle = [](const Point& a, const Point& b, const Point& c) {
    const Point x = minus(b, a);
    const Point y = minus(c, a);
    return std::sqrt(std::max(dot(x, x) * dot(y, y) - dot(x, y) * dot(x, y), 0.0)) / 2;
  };
  for (int i = 0; i < steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    const double t = static_cast<double>(i + 1) / steps;
    area += triangle(surface.c(s), surface.d(s), surface.c(t)) + triangle(surface.d(s), surface.c(t), surface.d(t));
  }
  EXPECT_NEAR(plate.area_before.lower(), area, 1e-5 * area);
  EXPECT_LE(plate.area_before.upper() - plate.area_before.lower(), 1e-12 * area);
  EXPECT_NEAR(plate.area_after.lower(), area, 1e-4 * area);
}

TEST(Plate, MirroredIsTheSameWithTheOtherSideUp) {
  const Surface surface = tangent_surface();
  const Plate plate = surface.plate(1e-3);
  const Plate mirrored = surface.plate(1e-3, 0, true);
  ASSERT_EQ(plate.parameters, mirrored.parameters);
  for (std::size_t i = 0; i < plate.parameters.size(); ++i) {
    EXPECT_NEAR(plate.c.points[i].x, mirrored.c.points[i].x, 1e-5);
    EXPECT_NEAR(plate.c.points[i].y, plate.height - mirrored.c.points[i].y, 1e-5);
  }
}

/// (t, 0, 0) and (t, 1, h t): a hyperbolic paraboloid, warped by up to atan(h). Curves inside are shorter on the
/// surface than in the plane, by no more than `stretch` says, and so is the area.
TEST(Plate, NearlyDevelopable) {
  const double h = 0.25;
  const Surface surface = bezier(rows({{0, 0, 0}, {2, 0, 0}}), rows({{0, 1, 0}, {2, 1, 2 * h}}));
  const double warp = std::atan(h) * 180 / std::numbers::pi * (1 + 1e-9);
  const Plate plate = surface.plate(1e-6, warp);
  expect_sound(surface, plate);
  double true_length = 0;
  double planar = 0;
  const auto middle = [](const Point& a, const Point& b) {
    return Point{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  for (std::size_t i = 0; i + 1 < plate.parameters.size(); ++i) {
    const Q& s = plate.parameters[i];
    const Q& t = plate.parameters[i + 1];
    true_length += distance(middle(surface.c(s), surface.d(s)), middle(surface.c(t), surface.d(t)));
    const auto at = [&](std::size_t j) {
      return PlatePoint{(plate.c.points[j].x + plate.d.points[j].x) / 2,
                        (plate.c.points[j].y + plate.d.points[j].y) / 2};
    };
    planar += distance(at(i), at(i + 1));
  }
  EXPECT_GT(planar, true_length * (1 + 1e-4));
  EXPECT_LT(planar, true_length * (1 + plate.stretch));
  EXPECT_LT(plate.stretch, 0.0077);
  const double area = integral(
      [&](double t) { return integral([&](double v) { return std::sqrt(1 + h * h * (t * t + v * v)); }, 0, 1); }, 0, 2);
  EXPECT_LT(area, plate.area_before.upper());
  EXPECT_GT(area, plate.area_before.lower());
}

TEST(Plate, PiecesThatMeetAtAnAngle) {
  // Two planes, 60 degrees apart, bent towards the side of the normal (0, 0, 1); in the plane the rails go straight on.
  const double root = std::sqrt(3.0);
  const Surface surface{KnotList<Q>(1, {Q(0), Q(1), Q(2)}), rows({{0, 0, 0}, {2, 0, 0}, {3, 0, root}}),
                        rows({{0, 1, 0}, {2, 1, 0}, {3, 1, root}})};
  const Plate plate = surface.plate(1e-4);
  EXPECT_NEAR(plate.width, 4, 1e-6);
  EXPECT_NEAR(plate.height, 1, 1e-6);
  ASSERT_THAT(plate.rulings, SizeIs(7));
  EXPECT_EQ(plate.rulings[3].t, Q(1));
  EXPECT_NEAR(plate.rulings[3].bend, 60, 1e-9);
  EXPECT_EQ(plate.rulings[2].bend, 0);
  EXPECT_NEAR(surface.plate(1e-4, 0, true).rulings[3].bend, -60, 1e-9);
}

TEST(Plate, MeasuresTheRulingsOfBothEndsUnasked) {
  const Surface surface = tangent_surface();
  const Plate plate = unroll_plate(surface.strips(), {1e-4, {}});
  ASSERT_THAT(plate.rulings, SizeIs(2));
  EXPECT_EQ(plate.rulings[0].t, surface.u.domain_begin());
  EXPECT_EQ(plate.rulings[1].t, surface.u.domain_end());
  EXPECT_EQ(plate.rulings[1].vertex, plate.parameters.size() - 1);
}

TEST(Plate, HugeTinyAndFarAway) {
  for (const double scale : {1e-60, 1.0, 1e60}) {
    std::vector<std::array<double, 3>> c{{0, 0, 0}, {1, 2, 0}, {3, 1, 0}};
    std::vector<std::array<double, 3>> d{{0, 2, 0}, {1, 4, 0}, {4, 3, 0}};
    for (auto* list : {&c, &d}) {
      for (auto& x : *list) x = {x[0] * scale, (x[1] + 1e6) * scale, x[2] * scale};
    }
    const Surface surface = bezier(rows(c), rows(d));
    const Plate plate = surface.plate(1e-4 * scale);
    for (std::size_t i = 0; i < plate.parameters.size(); ++i) {
      const Q& t = plate.parameters[i];
      EXPECT_NEAR(distance(plate.c.points[i], plate.d.points[i]) / scale, distance(surface.c(t), surface.d(t)) / scale,
                  1e-6);
    }
  }
}

/// A frame around a square, one and a half times: its edges lie upon each other, so that points between them have to
/// tell. Half of it lies nowhere twice.
TEST(Plate, AFrameThatGoesRoundTwiceLiesOnItself) {
  constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const auto frame = [&](std::size_t sides) {
    std::vector<std::array<double, 3>> inner;
    std::vector<std::array<double, 3>> outer;
    std::vector<Q> knots;
    for (std::size_t i = 0; i <= sides; ++i) {
      const auto& [x, y] = corners[i % 4];
      inner.push_back({x, y, 0});
      outer.push_back({2 * x, 2 * y, 0});
      knots.push_back(Q(static_cast<int>(i)));
    }
    return Surface{KnotList<Q>(1, knots), rows(inner), rows(outer)};
  };
  EXPECT_EQ(frame(6).plate(1e-3).overlap.verdict, Truth::yes);
  EXPECT_EQ(frame(3).plate(1e-3).overlap.verdict, Truth::no);
}

TEST(Plate, AToleranceOutOfReachIsAnError) {
  const Surface surface = tangent_surface();
  EXPECT_THROW(unroll_plate(surface.strips(), {1e-40, {}}), InvalidInput);
}

}  // namespace
}  // namespace torse::test
