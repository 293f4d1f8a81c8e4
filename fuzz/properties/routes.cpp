#include "torse/fuzz/properties/routes.hpp"

#include <algorithm>
#include <span>

#include "torse/developable/cells.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/special.hpp"
#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/knots.hpp"

namespace torse::fuzz {
namespace {

using Row = std::vector<Point3>;

Row net_of(const Routes::In& in) {
  return linear_net<Rational, Point3>(in.knots, in.c, in.functions.lambda, in.functions.m, in.d0);
}

std::vector<Row4> weighted(const Row& points) {
  std::vector<Row4> rows;
  for (const Point3& x : points) rows.emplace_back(Rational(1), x[0], x[1], x[2]);
  return rows;
}

/// The row by the equation of the cells in plain fractions, and by the rational construction with weights 1.
void check_rows(const Routes::In& in, const Row& d) {
  Functions f = in.functions;
  const Row4 q0 = weighted({in.d0}).front();
  require(weighted(d) == cell_row(in.knots, weighted(in.c), f, q0), "FJ07.13 is not the equation of its cells");
  const std::vector<Row4> q = rational_net<Rational, Row4>(in.knots, weighted(in.c), f.lambda, f.m, Rational(1), q0);
  require(q == weighted(d), "FJ21.7.1 with weights 1 differs from FJ07.13");
  const Row cells = cell_net<Rational, Point3>(in.knots, in.c, first_cell(in.knots, f.lambda, f.m), in.d0);
  require(cells == d, "FJ07.18 differs from FJ07.13");
}

void check_closed_forms(const Routes::In& in, const Row& d) {
  const auto& [lambda, m, sigma] = in.functions;
  const Row rulings = eq16_rulings<Rational, Point3>(in.knots, in.c, lambda, m, in.d0);
  for (int i = 1; i <= in.knots.last(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const Point3 ruling = difference(d[at], in.c[at]);
    require((eq14<Rational, Point3>(in.knots, in.c, lambda, m, in.d0, i) == d[at]), "FJ07.14 differs from FJ07.13");
    require((eq15<Rational, Point3>(in.knots, in.c, lambda, m, in.d0, i) == ruling), "FJ07.15 differs from FJ07.13");
    require((eq16<Rational, Point3>(in.knots, in.c, lambda, m, in.d0, i) == ruling), "FJ07.16 differs from FJ07.13");
    require(rulings[at - 1] == ruling, "FJ07.16 for all vertices differs from FJ07.13");
  }
}

/// Segment by segment: Bezier rows, and the affine cells of FJ07.11 carried from segment to segment.
void check_segments(const Routes::In& in, const Row& d) {
  const auto& [lambda, m, sigma] = in.functions;
  const KnotList<Rational>& u = in.knots;
  const std::vector<int> pieces = u.proper_pieces();
  const Row start = bezier_points<Rational, Point3>(u, d, pieces.front());
  const std::vector<Row> rows = piecewise_net<Rational, Point3>(u, in.c, lambda, m, start.front());
  require(rows.size() == pieces.size(), "another number of segments");
  for (std::size_t j = 0; j < pieces.size(); ++j) {
    const int k = pieces[j];
    const Row polygon = bezier_points<Rational, Point3>(u, d, k);
    require(rows[j] == polygon, "FJ07.12 on a segment differs from FJ07.13");
    const Rational local_m = local_parameter(u, m, k);
    const AffineCell<Rational> cell = affine_from_local(local_parameter(u, lambda, k), local_m);
    const Row c = bezier_points<Rational, Point3>(u, in.c, k);
    for (std::size_t i = 0; i + 1 < c.size(); ++i) {
      Point3 next = combine(Rational(1) - cell.lam - cell.mu, c[i], cell.lam, c[i + 1]);
      add_scaled(next, cell.mu, polygon[i]);
      require(next == polygon[i + 1], "the affine cell of a segment does not belong to it");
    }
    const bool follows = j > 0 && pieces[j - 1] == k - 1;
    if (!follows) continue;
    const Rational before = local_parameter(u, m, k - 1);
    require(next_local(u, before, k) == local_m, "FJ07.10 differs from its definition");
    const AffineCell<Rational> last = affine_from_local(local_parameter(u, lambda, k - 1), before);
    if (last.mu.sign() == 0) continue;
    const AffineCell<Rational> carried = next_affine(u, last, k);
    require(carried.lam == cell.lam && carried.mu == cell.mu, "FJ07.11 differs from its definition");
  }
}

/// From the other end: the reversed net is the net of the reversed curve.
void check_backward(const Routes::In& in, const Row& d) {
  const KnotList<Rational>& u = in.knots;
  std::vector<Rational> list;
  for (int i = u.size() - 1; i >= 0; --i) list.push_back(-u[i]);
  const Row c(in.c.rbegin(), in.c.rend());
  const Row backward =
      linear_net<Rational, Point3>({u.degree(), list}, c, -in.functions.lambda, -in.functions.m, d.back());
  require(Row(backward.rbegin(), backward.rend()) == d, "from the last vertex back, another net");
}

/// c from d: the roles exchanged (FJ07.17). The parameter that was L* must be off the knots.
void check_roles(const Routes::In& in, const Row& d, Labels& labels) {
  const auto& [lambda, m, sigma] = in.functions;
  const bool knot = parameter_kind(in.knots, lambda) == "knot";
  labels.add("roles", knot ? "L* is a knot" : "exchanged");
  if (knot) return;
  require((linear_net<Rational, Point3>(in.knots, d, m, lambda, in.c.front()) == in.c),
          "with c and d exchanged L* and M* are not");
}

/// Part of the rulings and back (FJ07.17).
void check_part(const Routes::In& in, const Row& d) {
  const auto& [lambda, m, beta] = in.functions;
  const Row part = restrict_rulings<Rational, Point3>(in.c, d, beta);
  const Rational over = Rational(1) / beta;
  require((restrict_rulings<Rational, Point3>(in.c, part, over) == d), "beta and then 1/beta do not give the net back");
  const Rational part_lambda = restricted_lambda(lambda, m, beta);
  require(restricted_lambda(part_lambda, m, over) == lambda, "beta and then 1/beta do not give L* back");
  require((linear_net<Rational, Point3>(in.knots, in.c, part_lambda, m, part.front()) == part),
          "FJ07.17 has another L*");
}

}  // namespace

const PropertyInfo& Routes::info() {
  static const PropertyInfo info{
      "routes",
      "FJ07.10 to 18 and FJ21.7.1 with weights 1 give one net, forward, backward, with the rows exchanged and in part",
      30,
      {"knots=bezier", "knots=clamped", "knots=unclamped", "knots=mixed", "knots=full", "knots=repeated",
       "knots=extreme", "roles=exchanged", "roles=L* is a knot", "M=near", "M=huge", "M=inside", "class=cylinder",
       "class=other"}};
  return info;
}

Routes::In Routes::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{.knots = draw_knots(choices, scale)};
  in.c = draw_polygon(choices, scale, in.knots.last() + 1);
  in.d0 = draw_vector(choices, scale);
  in.functions = draw_functions(choices, scale, in.knots, true);
  labels.add("degree", in.knots.degree());
  labels.add("knots", std::string(knot_kind(in.knots)));
  labels.add("polygon", std::string(polygon_kind(in.c)));
  labels.add("M", std::string(parameter_kind(in.knots, in.functions.m)));
  labels.add("class", in.functions.lambda == in.functions.m ? "cylinder" : "other");
  return in;
}

void Routes::check(const In& in, Labels& labels) {
  Routes::In plain = in;
  plain.functions.sigma = Rational(1);
  const Row d = net_of(in);
  check_rows(plain, d);
  check_closed_forms(in, d);
  check_segments(in, d);
  check_backward(in, d);
  check_roles(in, d, labels);
  check_part(in, d);
}

}  // namespace torse::fuzz
