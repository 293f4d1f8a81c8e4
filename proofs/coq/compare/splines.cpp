// The library's templates over a knot list: FJ07, the rational net of FJ21, knot insertion.
#include "torse/developable/cells.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/recovery.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using Point4 = Vec<Q, 4>;
using P = const Problem&;

Answer knots(const Problem& p) { return p.knots(), Answer(); }

Answer blossom_value(const Problem& p) {
  const auto c = p.spline<3>();
  std::vector<Parameter<Q>> v;
  for (const Vec<Q, 2>& x : p.points<2>("v")) v.push_back({x[0], x[1]});
  return Answer() << blossom<Q, Point3>(c.knots, c.points(), p.integer("k"), v);
}

Answer point(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << curve_point(c.knots, c.points(), p.integer("k"), p.number("t"));
}

Answer derivative(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << curve_derivative(c.knots, c.points(), p.integer("k"), p.number("t"));
}

Answer net(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << linear_net<Q, Point3>(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"));
}

/// The row d of FJ07.13 by one of the library's routes from d_i.
template <class Net>
Answer row(const Problem& p, Net net) {
  const auto c = p.spline<3>();
  return Answer() << net(c.knots, c.points(), p.number("L"), p.number("M"), p.integer("i"), p.point<3>("d"));
}

/// One vertex of FJ07.13 by a closed form.
template <class Form>
Answer vertex(const Problem& p, Form form) {
  const auto c = p.spline<3>();
  return Answer() << form(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"), p.integer("i"));
}

Answer next_affine_cell(const Problem& p) {
  const AffineCell<Q> next = next_affine<Q>(p.knots(), {p.number("l"), p.number("m")}, p.integer("k"));
  return Answer() << next.lam << next.mu;
}

Answer cell(const Cell<Q>& cell) { return Answer() << cell.l << cell.m; }

Answer cell_row(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << cell_net<Q, Point3>(c.knots, c.points(), {p.number("l"), p.number("m")}, p.point<3>("d"));
}

template <int D>
RuledSpline<Q, Vec<Q, D>> ruled(const Problem& p) {
  const auto c = p.spline<D>();
  const auto d = p.spline<D>("d");
  return {c.knots, c.control, d.control};
}

/// The form of the determinant at (1-t, t). Throws DivisionByZero for an empty piece, which has no form.
template <int D>
Answer determinant(const Problem& p) {
  const auto s = ruled<D>(p);
  const int k = p.integer("k");
  if (definitely(s.knots.piece_empty(k))) throw DivisionByZero();
  const Q t = p.number("t");
  return Answer() << span_determinant(s.knots, s.c_row(), s.d_row(), k)(Q(1) - t, t);
}

/// The piece that refutes, 0 where there is none.
template <int D>
Answer witness(const Problem& p) {
  const auto s = ruled<D>(p);
  const auto found = find_witness<Q, D>(s.knots, s.c_row(), s.d_row());
  return Answer() << Q(found ? found->piece : 0);
}

/// The point with a homogeneous parameter (a : w) on the tangent at t. Throws DivisionByZero for an empty piece.
Answer on_tangent(const Problem& p) {
  const auto c = p.spline<3>();
  const Parameter<Q> x{p.number("a"), p.number("w")};
  return Answer() << tangent_point(c.knots, c.points(), p.integer("k"), p.number("t"), x);
}

Answer pair(const Problem& p) {
  const auto c = p.spline<3>();
  const int k = p.integer("k");
  if (definitely(c.knots.piece_empty(k))) throw DivisionByZero();
  const auto [first, second] = last_pair(c.knots, c.points(), k, p.number("t"));
  return Answer() << first << second;
}

Answer recovered(const Problem& p) {
  const auto c = p.spline<4>();
  const auto d = p.spline<4>("d");
  const BlossomFunctions<Q> f = cell_functions<Q>(c.knots, c.points(), d.points(), p.integer("i"));
  return Answer() << f.lambda << f.m << f.sigma;
}

Answer rational_row(const Problem& p) {
  const auto c = p.spline<4>();
  return Answer() << rational_net<Q, Point4>(c.knots, c.points(), p.number("L"), p.number("M"), p.number("s"),
                                             p.point<4>("d"));
}

Answer products(const Problem& p) {
  const KnotList<Q> u = p.knots();
  const Q m = p.number("M");
  require_off_knots(u, m);
  const int a = p.integer("a");
  const int b = p.integer("b");
  return Answer() << product_p(u, m, a, b) << product_q(u, m, a, b);
}

Answer pieces(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << restricted_points(c.knots, c.points(), p.integer("k"), p.number("a"), p.number("b"));
}

Answer bezier(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << bezier_points(c.knots, c.points(), p.integer("k"));
}

/// The side of cell i at any parameter.
Answer side(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << cell_point(c.knots, c.points(), p.integer("i"), p.number("t"));
}

/// c_i from the Bezier points c of piece k.
Answer vertex_of_piece(const Problem& p) {
  const KnotList<Q> u = p.knots();
  return Answer() << spline_vertex<Q, Point3>(u, p.points<3>("c"), p.integer("k"), p.integer("i"));
}

Answer rulings(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << eq16_rulings<Q, Point3>(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"));
}

Answer insertion(const Problem& p) {
  const auto finer = insert_knot(p.spline<3>(), p.number("t"));
  return Answer() << finer.knots.list() << finer.control;
}

}  // namespace

const Table& over_knots() {
  static const Table table{
      {"knots", knots},
      {"blossom", blossom_value},
      {"point", point},
      {"derivative", derivative},
      {"net", net},
      {"net_from", [](P p) { return row(p, net_from<Q, Point3>); }},
      {"printed_net", [](P p) { return row(p, printed_net<Q, Point3>); }},
      {"products", products},
      {"eq14", [](P p) { return vertex(p, eq14<Q, Point3>); }},
      {"eq15", [](P p) { return vertex(p, eq15<Q, Point3>); }},
      {"eq16", [](P p) { return vertex(p, eq16<Q, Point3>); }},
      {"local_parameter", [](P p) { return Answer() << local_parameter(p.knots(), p.number("t"), p.integer("k")); }},
      {"next_local", [](P p) { return Answer() << next_local(p.knots(), p.number("t"), p.integer("k")); }},
      {"next_affine", next_affine_cell},
      {"first_cell", [](P p) { return cell(first_cell(p.knots(), p.number("L"), p.number("M"))); }},
      {"next_cell",
       [](P p) {
         return cell(next_cell<Q>(p.knots(), {p.number("l"), p.number("m")}, p.integer("i")));
       }},
      {"cell_net", cell_row},
      {"determinant", determinant<3>},
      {"find_witness", witness<3>},
      {"determinant4", determinant<4>},
      {"find_witness4", witness<4>},
      {"tangent_point", on_tangent},
      {"last_pair", pair},
      {"cell_functions", recovered},
      {"rational_net", rational_row},
      {"restricted_points", pieces},
      {"bezier_points", bezier},
      {"insert_knot", insertion},
      {"cell_point", side},
      {"spline_vertex", vertex_of_piece},
      {"eq16_rulings", rulings},
  };
  return table;
}

}  // namespace torse::compare
