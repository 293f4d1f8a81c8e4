// ZW06: the linear system of a directrix, checked as an identity of polynomials, and what its solutions make.
#include "torse/developable/directrix.hpp"

#include <gtest/gtest.h>

#include "nets.hpp"
#include "torse/developable/classify.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/special.hpp"

namespace torse::test {
namespace {

using Equation = DirectrixEquation<Q>;

Bernstein<Q> bernstein(const std::vector<int>& b) {
  std::vector<Q> coefficients;
  for (int x : b) coefficients.push_back(Q(x));
  return Bernstein<Q>(std::move(coefficients));
}

Bernstein<Q> coordinate(const std::vector<Point3>& row, int j) {
  std::vector<Q> b;
  for (const Point3& x : row) b.push_back(x[j]);
  return Bernstein<Q>(std::move(b));
}

std::vector<Point3> second_row(const std::vector<Point3>& c, const std::vector<Point3>& tau) {
  std::vector<Point3> d;
  for (std::size_t i = 0; i < c.size(); ++i) d.push_back(sum(c[i], tau[i]));
  return d;
}

std::vector<Point3> ruling_row(const std::vector<Point3>& c, const std::vector<Point3>& d) {
  std::vector<Point3> tau;
  for (std::size_t i = 0; i < c.size(); ++i) tau.push_back(difference(d[i], c[i]));
  return tau;
}

/// a' = a tau + b tau' as polynomials, coordinate by coordinate.
void expect_solves(const std::vector<Point3>& c, const std::vector<Point3>& tau, const Equation& e) {
  for (int j = 0; j < 3; ++j) {
    const Bernstein<Q> t = coordinate(tau, j);
    EXPECT_TRUE(definitely((coordinate(c, j).derivative() - e.a * t - e.b * t.derivative()).zero())) << j;
  }
  EXPECT_TRUE(developable(bezier_knots<Q>(static_cast<int>(c.size()) - 1), c, second_row(c, tau)));
}

DirectrixSolution<Q, Point3> solve(const std::vector<Point3>& c, const Equation& e) {
  return solve_directrix<Q, Point3>(c, e);
}

SurfaceClass class_of(const std::vector<Point3>& c, const std::vector<Point3>& tau) {
  const std::vector<Q> weights(c.size(), Q(1));
  const auto p = homogeneous(WeightedPoints<Q, 3>{c, weights});
  const auto q = homogeneous(WeightedPoints<Q, 3>{second_row(c, tau), weights});
  return classify<Q>(bezier_knots<Q>(static_cast<int>(c.size()) - 1), p, q).kind;
}

// The determinant of the square system is the product of a + k b', k = 0..n: no family unless one of them vanishes.
TEST(Directrix, SquareSystemsHaveOneSolutionUnlessAPlusKBPrimeVanishes) {
  for (int n : {1, 2, 3, 5}) {
    const std::vector<Point3> c = points(n + 1);
    for (const auto& [a, b0, b1] : {std::tuple{3, 2, 7}, {-1, 1, 3}, {2, 0, 1}, {1, 0, 0}, {5, -4, -4}}) {
      const Equation e{bernstein({a}), bernstein({b0, b1})};
      const DirectrixSolution<Q, Point3> solution = solve(c, e);
      ASSERT_FALSE(solution.contradiction);
      EXPECT_FALSE(solution.family);
      expect_solves(c, solution.tau, e);
      Point3 leading = point(0, 0, 0);  // tau has degree n - 1: its n-th difference vanishes
      for (int i = 0; i <= n; ++i) {
        const Q sign((n - i) % 2 == 0 ? 1 : -1);
        add_scaled(leading, sign * binomial<Q>(n, i), solution.tau[static_cast<std::size_t>(i)]);
      }
      EXPECT_EQ(leading, point(0, 0, 0));
    }
  }
}

TEST(Directrix, TheLastFactorGivesAFamilyForEveryDirectrix) {
  const std::vector<Point3> c = points(4);
  const Equation e{bernstein({-6}), bernstein({-2, 0})};  // b = 2 (u - 1), a + 3 b' = 0
  const DirectrixSolution<Q, Point3> solution = solve(c, e);
  ASSERT_FALSE(solution.contradiction);
  ASSERT_TRUE(solution.family);
  EXPECT_EQ(solution.family->coefficients(), bernstein({1, 0, 0, 0}).coefficients());  // (1-u)^3
  for (const Point3& v : {point(0, 0, 0), point(1, -2, 5)}) {
    std::vector<Point3> tau = solution.tau;
    for (int i = 0; i <= 3; ++i) add_scaled(tau[static_cast<std::size_t>(i)], (*solution.family)[i], v);
    EXPECT_EQ(tau[0], v);
    expect_solves(c, tau, e);
  }
}

TEST(Directrix, AnotherFactorAsksForAVanishingDerivative) {
  const Equation e{bernstein({-1}), bernstein({0, 1})};  // a + b' = 0 and b(0) = 0: a''(0) must vanish
  std::vector<Point3> c = points(4);
  const DirectrixSolution<Q, Point3> none = solve(c, e);
  ASSERT_TRUE(none.contradiction);
  EXPECT_TRUE(none.tau.empty());
  const Point3 bend = combine(Q(1), sum(c[0], c[2]), Q(-2), c[1]);
  EXPECT_EQ(cross(none.contradiction->value, bend), point(0, 0, 0));
  subtract(c[2], bend);
  const DirectrixSolution<Q, Point3> some = solve(c, e);
  ASSERT_FALSE(some.contradiction);
  ASSERT_TRUE(some.family);
  EXPECT_EQ((*some.family)[0], Q(0));  // kappa = 3 u
  EXPECT_EQ((*some.family)[1], Q(1));
  expect_solves(c, some.tau, e);
}

// Equations of any degree outnumber the unknowns; a directrix made from its rulings is solved, and its certificate of
// insolubility is a combination of the system's equations.
TEST(Directrix, OverdeterminedSystems) {
  const Equation e{bernstein({1, -2, 4}), bernstein({2, 0, 1, 5})};
  const std::vector<Point3> c = points(5);
  const DirectrixSolution<Q, Point3> none = solve(c, e);
  ASSERT_TRUE(none.contradiction);
  const std::vector<Form<Q>> rows = directrix_rows(4, e);
  ASSERT_EQ(rows.size(), 7U);
  const std::vector<Point3> right = directrix_right_sides<Q, Point3>(c, 6);
  Form<Q> left;
  Point3 value = point(0, 0, 0);
  for (const auto& term : none.contradiction->combination.terms()) {
    add_scaled(left, term.coefficient, rows[static_cast<std::size_t>(term.generator)]);
    add_scaled(value, term.coefficient, right[static_cast<std::size_t>(term.generator)]);
  }
  EXPECT_TRUE(left.terms().empty());
  EXPECT_EQ(value, none.contradiction->value);
  EXPECT_NE(value, point(0, 0, 0));

  // b tau' = (1 + u^3) tau' is tau' in all Bernstein coefficients but the last.
  const std::vector<Point3> line{point(0, 0, 0), point(1, 2, 3)};
  EXPECT_TRUE(solve(line, {bernstein({0}), bernstein({1, 1, 1, 2})}).contradiction);
  EXPECT_FALSE(solve(line, {bernstein({0}), bernstein({1, 1, 1, 1})}).contradiction);

  // tau = u v + w with a = 1 + u, b = u^2 - u: a tau + b tau' = 2 u^2 v + (1 + u) w, the derivative of a cubic.
  const Equation quadratic{bernstein({1, 2}), Bernstein<Q>({Q(0), ratio<Q>(-1, 2), Q(0)})};
  const Point3 v = point(1, 2, -1);
  const Point3 w = point(0, 3, 1);
  std::vector<Point3> cubic{point(7, 7, 7)};
  const std::vector<Point3> speed{w, combine(ratio<Q>(3, 2), w, Q(0), v), combine(Q(2), w, Q(2), v)};
  for (const Point3& x : speed) cubic.push_back(combine(Q(1), cubic.back(), ratio<Q>(1, 3), x));
  const DirectrixSolution<Q, Point3> one = solve(cubic, quadratic);
  ASSERT_FALSE(one.contradiction);
  EXPECT_FALSE(one.family);
  expect_solves(cubic, one.tau, quadratic);
  for (int i = 0; i <= 3; ++i) EXPECT_EQ(one.tau[static_cast<std::size_t>(i)], combine(ratio<Q>(i, 3), v, Q(1), w));
}

TEST(Directrix, VertexAndEdge) {
  const std::vector<Point3> c = points(4);
  const Equation cone{bernstein({3}), bernstein({2, 5})};
  EXPECT_EQ(is_cone_equation(cone), Truth::yes);
  // b tau = c - V is divisible by b = 3 u + 2 for the point V = c(-2/3) only.
  const std::vector<Point3> tau = solve(c, cone).tau;
  const Point3 vertex = directrix_vertex<Q, Point3>(c, tau, cone);
  EXPECT_EQ(vertex, (curve_point<Q, Point3>(bezier_knots<Q>(3), c, 1, ratio<Q>(-2, 3))));
  for (const Point3& x : directrix_edge<Q, Point3>(c, tau, cone.b)) EXPECT_EQ(x, vertex);
  EXPECT_EQ(class_of(c, tau), SurfaceClass::cone);

  // a = b' = 2 + 4u at u = 0 only.
  EXPECT_EQ(is_cone_equation(Equation{bernstein({2}), bernstein({0, 1, 4})}), Truth::no);
  const Equation tangent{bernstein({4}), bernstein({2, 5})};
  EXPECT_EQ(is_cone_equation(tangent), Truth::no);
  const std::vector<Point3> along = solve(c, tangent).tau;
  const std::vector<Point3> edge = directrix_edge<Q, Point3>(c, along, tangent.b);
  ASSERT_EQ(edge.size(), 5U);
  for (int j = 0; j < 3; ++j) {  // a1' = (a - b') tau
    EXPECT_TRUE(definitely((coordinate(edge, j).derivative() - coordinate(along, j)).zero()));
  }
  EXPECT_EQ(class_of(c, along), SurfaceClass::tangent);
  EXPECT_EQ(place_of([&] { return directrix_vertex<Q, Point3>(c, along, tangent); }), "a");
}

TEST(Directrix, ErrorsNameTheMember) {
  const std::vector<Point3> c = points(2);
  EXPECT_EQ(place_of([&] { return solve(c, {bernstein({0, 0}), bernstein({0})}); }), "a");
  EXPECT_EQ(place_of([&] { return solve({c[0]}, {bernstein({1}), bernstein({1})}); }), "c.points");
  EXPECT_TRUE(solve(c, {bernstein({0}), bernstein({1})}).family);
}

TEST(Directrix, TheLargestDegreeOfAFile) {
  const std::vector<Point3> c = points(101);
  const Equation e{bernstein({3}), bernstein({2, 7})};
  const DirectrixSolution<Q, Point3> solution = solve(c, e);
  ASSERT_FALSE(solution.contradiction);
  const std::vector<Point3> edge = directrix_edge<Q, Point3>(c, solution.tau, e.b);
  const Bernstein<Q> rest = coordinate(edge, 0).derivative() + coordinate(solution.tau, 0) * bernstein({2});
  EXPECT_TRUE(definitely(rest.zero()));
}

TEST(DirectrixNets, AreTheSolutionsOfTheirEquations) {
  for (int n : {1, 2, 3, 6}) {
    const std::vector<Point3> c = points(n + 1);
    const Equation cone{bernstein({3}), bernstein({0, 3})};
    EXPECT_EQ((start_cone_net<Q, Point3>(c, Q(3))), second_row(c, solve(c, cone).tau));
    const Equation mean{bernstein({2}), bernstein({0, 1})};
    EXPECT_EQ((mean_tangent_net<Q, Point3>(c)), second_row(c, solve(c, mean).tau));
    const Equation tangent{bernstein({1}), bernstein({0})};
    EXPECT_EQ((tangent_net<Q, Point3>(c)), second_row(c, solve(c, tangent).tau));

    const Equation aumann = aumann_equation<Q>(n, Q(5), ratio<Q>(1, 3));
    const std::vector<Point3> d = affine_net<Q, Point3>(c, Q(5), ratio<Q>(1, 3), point(4, -7, 1));
    const DirectrixSolution<Q, Point3> family = solve(c, aumann);
    ASSERT_TRUE(family.family);
    std::vector<Point3> tau = family.tau;
    const Point3 v = difference(d[0], c[0]);
    for (int i = 0; i <= n; ++i) add_scaled(tau[static_cast<std::size_t>(i)], (*family.family)[i], v);
    EXPECT_EQ(d, second_row(c, tau));
  }
  // Aumann's surfaces are those of FJ07.12 with M = 1/(1-s), Lam = rho M.
  const std::vector<Point3> c = points(4);
  const Q m = ratio<Q>(3, 2);
  EXPECT_EQ((affine_net<Q, Point3>(c, Q(5), ratio<Q>(1, 3), point(4, -7, 1))),
            (linear_net<Q, Point3>(bezier_knots<Q>(3), c, Q(5) * m, m, point(4, -7, 1))));
  EXPECT_EQ(place_of([&] { return start_cone_net<Q, Point3>(points(3), Q(0)); }), "s");
  EXPECT_EQ(place_of([&] { return aumann_equation<Q>(3, Q(1), Q(2)); }), "rho");
}

// 16 and 18 by hand for the running means m_i = (c_0 + ... + c_i)/(i+1): c + m' and 2 c - m.
TEST(DirectrixNets, RunningMeans) {
  const std::vector<Point3> c = points(4);
  std::vector<Point3> m;
  Point3 total = point(0, 0, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    add(total, c[i]);
    m.push_back(scaled(ratio<Q>(1, static_cast<int>(i) + 1), total));
  }
  const std::vector<Point3> chord = mean_chord_net<Q, Point3>(c);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(chord[i], combine(Q(2), c[i], Q(-1), m[i]));
  EXPECT_EQ(ruling_row(c, mean_tangent_net<Q, Point3>(c)), ruling_row(m, tangent_net<Q, Point3>(m)));
  const std::vector<Point3> tau = ruling_row(c, chord);
  EXPECT_TRUE(developable(bezier_knots<Q>(3), c, chord));
  EXPECT_EQ((directrix_edge<Q, Point3>(c, tau, bernstein({1}))), m);
}

}  // namespace
}  // namespace torse::test
