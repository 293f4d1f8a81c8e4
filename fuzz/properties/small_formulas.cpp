#include "torse/fuzz/properties/small_formulas.hpp"

#include <algorithm>
#include <utility>

#include "torse/developable/condition.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/interpolation.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/recovery.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/developable/special.hpp"
#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/weights.hpp"
#include "torse/fuzz/plain/elimination.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

using In = SmallFormulas::In;
using Q = Rational;
using plain::Poly;

Row4 weighted(const Q& w, const Point3& x) { return {w, w * x[0], w * x[1], w * x[2]}; }

std::vector<Row4> rows_of(const In& in) {
  std::vector<Row4> rows;
  for (std::size_t i = 0; i < in.c.size(); ++i) rows.push_back(weighted(in.weights.at(i), in.c[i]));
  return rows;
}

/// The second row of the net with weights, by its cells.
std::vector<Row4> net_row(const In& in) { return cell_row(in.knots, rows_of(in), in.functions, weighted(Q(1), in.d0)); }

/// The second row of the polynomial net.
std::vector<Point3> net_points(const In& in) {
  Functions f = in.functions;
  f.sigma = Q(1);
  std::vector<Row4> p;
  for (const Point3& x : in.c) p.push_back(weighted(Q(1), x));
  std::vector<Point3> points;
  for (const Row4& x : cell_row(in.knots, p, f, weighted(Q(1), in.d0))) points.emplace_back(x[1], x[2], x[3]);
  return points;
}

void check_points(const In& in) {
  const std::vector<Row4> rows = homogeneous(WeightedPoints<Q, 3>{in.c, in.weights});
  require(rows == rows_of(in), "the rows are not w (1, c)");
  const WeightedPoints<Q, 3> back = dehomogenize(rows);
  require(back.points == in.c && back.weights == in.weights, "rows do not give points and weights back");
}

/// Both sides of a cell meet at L* and M*, and the cell knows them.
void check_cells(const In& in) {
  const std::vector<Row4> p = rows_of(in);
  const std::vector<Row4> q = net_row(in);
  const auto& [lambda, m, sigma] = in.functions;
  for (int i = 0; i < in.knots.last(); ++i) {
    const Row4 left = cell_point<Q, Row4>(in.knots, p, i, lambda);
    require((left == scaled(sigma, cell_point<Q, Row4>(in.knots, q, i, m))), "the sides of a cell do not meet");
    plain::Rows<4> cell;
    const std::size_t at = static_cast<std::size_t>(i);
    for (const Row4& x : {p[at], p[at + 1], q[at], q[at + 1]}) cell.insert(x);
    if (cell.rank() < 3) continue;
    const BlossomFunctions<Q> found = cell_functions<Q>(in.knots, p, q, i);
    require(found.lambda == lambda && found.m == m && found.sigma == sigma, "a cell gives other functions");
  }
}

void check_cone(const In& in) {
  if (in.x == Q(1)) return;
  const std::vector<Point3> d = cone_net<Q, Point3>(in.c, in.x, in.d0);
  const Point3 vertex = cone_vertex<Q, Point3>(in.c.front(), in.d0, in.x);
  for (std::size_t i = 0; i < d.size(); ++i) {
    require((difference(d[i], vertex) == scaled(in.x, difference(in.c[i], vertex))), "the vertex is off a ruling");
  }
}

/// The polynomial of the branches, at the branch of a net and elsewhere, and the lengths of the end rulings.
void check_interpolation(const In& in, Labels& labels) {
  const KnotList<Q>& u = in.knots;
  const std::vector<Point3> d = net_points(in);
  const Point3 v = scaled(in.x, difference(d.front(), in.c.front()));
  const Point3 w = scaled(in.y, difference(d.back(), in.c.back()));
  const std::vector<Q> polynomial = branch_polynomial<Q>(u, in.c, v, w);
  const auto& [lambda, m, sigma] = in.functions;
  require(plain::value(polynomial, m).sign() == 0, "M* is no root of the branches' polynomial");
  const bool knot = std::ranges::find(u.list(), in.t) != u.list().end();
  if (!knot) {
    Q product(1);
    for (int j = 0; j + 1 < u.last(); ++j) product *= in.t - u[j];
    const Point3 chord = difference(in.c.back(), eq20<Q, Point3>(u, in.c, in.t, u.last()));
    require(plain::value(polynomial, in.t) == product * det3(chord, v, w), "another polynomial of the branches");
  }
  plain::Rows<3> skew;
  skew.insert(v);
  skew.insert(w);
  labels.add("end rulings", skew.rank() == 2 ? "skew" : "parallel");
  if (skew.rank() < 2 || lambda == m) return;
  const EndRulings<Q> ends = end_rulings<Q>(u, in.c, v, w, m, lambda);
  require(ends.sigma0 * in.x == Q(1) && ends.tau0 * in.y == Q(1), "end rulings of another length");
}

void check_parameters(const In& in) {
  const Q below = (Q(1) - in.x) * in.t + in.x;
  if (below.sign() != 0) {
    require(moebius_parameter(in.x, in.t) * below == in.t, "another Moebius parameter");
  }
  // A point of a ruling between rows of weights y and x.
  const Row4 p = weighted(in.y, in.c.front());
  const Row4 q = weighted(in.x, in.d0);
  const Row4 point = blend(Q(1) - in.t, p, in.t, q);
  if (point[0].sign() == 0) return;
  const Q v = standard_parameter(in.t, in.y, in.x);
  for (int j = 0; j < 3; ++j) {
    require(point[j + 1] == point[0] * ((Q(1) - v) * in.c.front()[j] + v * in.d0[j]), "another standard parameter");
  }
}

/// The determinants at a parameter of a net that is no more developable than its rows happen to be.
void check_determinants(const In& in) {
  std::vector<Point3> d = in.c;
  std::reverse(d.begin(), d.end());
  d.front() = in.d0;
  const plain::Strip strip = plain::strip_of(in.knots, in.c, d);
  std::vector<Row4> q;
  for (std::size_t i = 0; i < d.size(); ++i) q.push_back(weighted(in.weights[d.size() - 1 - i], d[i]));
  const plain::Strip rational = plain::strip_of(in.knots, rows_of(in), q);
  int j = 0;
  while (strip.p.breaks[static_cast<std::size_t>(j) + 1] <= in.knots.piece_begin(in.piece)) ++j;
  require(pointwise_determinant<Q>(in.knots, in.c, d, in.piece, in.t) == plain::twist(strip, j, in.t),
          "another determinant of a polynomial surface at a parameter");
  const std::size_t at = static_cast<std::size_t>(j);
  const Q w = plain::value(rational.p.rows[at][0], in.t) * plain::value(rational.q.rows[at][0], in.t);
  require(
      pointwise_determinant<Q>(in.knots, rows_of(in), q, in.piece, in.t) == -(w * w) * plain::twist(rational, j, in.t),
      "another determinant of a rational surface at a parameter");
}

Poly polynomial_of(const Bernstein<Q>& f) {
  std::vector<Vec<Q, 1>> control;
  for (const Q& b : f.coefficients()) control.push_back(Vec<Q, 1>::Constant(b));
  if (f.degree() == 0) return {f[0]};
  return plain::pieces_of<1>(bezier_knots<Q>(f.degree()), control).rows[0][0];
}

bool is_zero_row(const plain::PolyRow<4>& row) {
  return std::ranges::all_of(
      row, [](const Poly& f) { return std::ranges::all_of(f, [](const Q& a) { return a.sign() == 0; }); });
}

plain::PolyRow<4> bezier_row(const std::vector<Row4>& rows) {
  return plain::pieces_of<4>(bezier_knots<Q>(static_cast<int>(rows.size()) - 1), rows).rows[0];
}

plain::PolyRow<4> minus(plain::PolyRow<4> x, const Poly& factor, const plain::PolyRow<4>& y) {
  for (std::size_t i = 0; i < 4; ++i) x[i] = plain::plus(x[i], plain::scaled(Q(-1), plain::times(factor, y[i])));
  return x;
}

/// a = b' is a cone; a that differs from b' at all but one end of [0, 1] is none.
void check_cone_equation(const Bernstein<Q>& b, const Q& difference) {
  if (b.degree() == 0) return;
  const std::vector<Q> a = b.derivative().elevated(1).coefficients();
  const Poly rest =
      plain::plus(polynomial_of(Bernstein<Q>(a)), plain::scaled(Q(-1), plain::derivative(polynomial_of(b))));
  require(std::ranges::all_of(rest, [](const Q& x) { return x.sign() == 0; }), "a derivative is another one");
  require(definitely(is_cone_equation<Q>({Bernstein<Q>(a), b})), "a cone's equation is not known as such");
  if (difference.sign() == 0) return;
  for (const std::size_t end : {std::size_t{0}, a.size() - 1}) {
    std::vector<Q> moved = a;
    moved[end] += difference;
    require(!possibly(is_cone_equation<Q>({Bernstein<Q>(moved), b})), "an equation that is no cone's is taken for one");
  }
}

/// The equation of the affine net, its edge and, where it is a cone, its vertex.
void check_directrix(const In& in, Labels& labels) {
  const int n = in.knots.degree();
  const std::vector<Row4> all = rows_of(in);
  const std::vector<Row4> p(all.begin(), all.begin() + n + 1);
  const Bernstein<Q> f(in.polynomial);
  require(is_zero_row(minus(bezier_row(times_polynomial<Q, Row4>(f, p)), polynomial_of(f), bezier_row(p))),
          "the rows of a product are others");
  check_cone_equation(f, in.x);
  if (in.x == Q(1)) return;
  const DirectrixEquation<Q> equation = aumann_equation(n, in.x, in.y);
  const std::vector<Row4> d = affine_net<Q, Row4>(p, in.x, in.y, weighted(Q(1), in.d0));
  std::vector<Row4> tau;
  for (std::size_t i = 0; i < p.size(); ++i) tau.push_back(blend(Q(1), d[i], Q(-1), p[i]));
  const plain::PolyRow<4> t = bezier_row(tau);
  const Poly a = polynomial_of(equation.a);
  const Poly b = polynomial_of(equation.b);
  const plain::PolyRow<4> rest = minus(minus(plain::derivative<4>(bezier_row(p)), a, t), b, plain::derivative<4>(t));
  require(is_zero_row(rest), "the affine net does not solve its equation");
  const std::vector<Row4> edge = directrix_edge<Q, Row4>(p, tau, equation.b);
  require(is_zero_row(minus(minus(bezier_row(edge), {Q(1)}, bezier_row(p)), plain::scaled(Q(-1), b), t)),
          "the edge is not c - b tau");
  Poly slope = plain::derivative(b);
  slope.resize(std::max(slope.size(), a.size()));
  const bool cone = std::equal(a.begin(), a.end(), slope.begin());
  labels.add("affine net", cone ? "cone" : "other");
  require(is_cone_equation(equation) == truth(cone), "a cone's equation is not known as such, or another one is");
  if (!cone) return;
  const Row4 vertex = directrix_vertex<Q, Row4>(p, tau, equation);
  require(std::ranges::all_of(edge, [&](const Row4& x) { return x == vertex; }),
          "the edge of a cone is not its vertex");
}

}  // namespace

const PropertyInfo& SmallFormulas::info() {
  static const PropertyInfo info{
      "formulas",
      "weights, cells, vertices, branches, end rulings, parameters, determinants and directrix equations are as "
      "defined",
      10,
      {"knots=bezier", "knots=clamped", "knots=unclamped", "end rulings=skew", "affine net=cone", "affine net=other"}};
  return info;
}

SmallFormulas::In SmallFormulas::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{.knots = draw_knots(choices, scale)};
  const int count = in.knots.last() + 1;
  in.c = draw_polygon(choices, scale, count);
  in.weights = draw_weights(choices, scale, count);
  in.d0 = draw_vector(choices, scale);
  in.functions = draw_functions(choices, scale, in.knots, true);
  const std::vector<int> pieces = in.knots.proper_pieces();
  in.piece = pieces[choices.below(pieces.size())];
  in.t = draw_parameter(choices, scale, in.knots);
  in.x = draw_nonzero(choices, scale);
  in.y = choices.once_in(4) ? Q(1) : draw_nonzero(choices, scale);
  const int degree = choices.between(0, 2);
  for (int i = 0; i <= degree; ++i) in.polynomial.push_back(draw_number(choices, scale));
  labels.add("degree", in.knots.degree());
  labels.add("knots", std::string(knot_kind(in.knots)));
  return in;
}

void SmallFormulas::check(const In& in, Labels& labels) {
  check_points(in);
  check_cells(in);
  check_cone(in);
  check_interpolation(in, labels);
  check_parameters(in);
  check_determinants(in);
  check_directrix(in, labels);
}

}  // namespace torse::fuzz
