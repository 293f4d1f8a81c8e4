#include "torse/fuzz/properties/curves.hpp"

#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/rewriting.hpp"
#include "torse/spline/compatible.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse::fuzz {
namespace {

using plain::Pieces;
using Curve = Spline<Rational, Row4>;

/// The blossom of t^j at the arguments is e_j / C(n, j).
Row4 blossom_of(const plain::PolyRow<4>& row, const std::vector<Rational>& arguments) {
  plain::Poly product{Rational(1)};  // of the 1 + t_i x, whose coefficients are e_0, e_1, ...
  for (const Rational& t : arguments) product = plain::times(product, {Rational(1), t});
  Row4 x = Row4::Constant(Rational());
  Rational choose(1);
  for (std::size_t j = 0; j < product.size(); ++j) {
    for (int i = 0; i < 4; ++i) {
      const plain::Poly& f = row[static_cast<std::size_t>(i)];
      if (j < f.size()) x[i] += f[j] * product[j] / choose;
    }
    choose = choose * Rational(arguments.size() - j) / Rational(j + 1);
  }
  return x;
}

/// The polynomials of a curve are those of `pieces` on every interval of its own.
void require_curve(const Curve& curve, const Pieces<4>& pieces, const char* message) {
  const Pieces<4> own = plain::pieces_of<4>(curve.knots, curve.control);
  require(own.breaks.front() == pieces.breaks.front() && own.breaks.back() == pieces.breaks.back(), message);
  for (std::size_t j = 0; j < own.rows.size(); ++j) {
    const Pieces<4> part = plain::trimmed(pieces, own.breaks[j], own.breaks[j + 1]);
    for (const plain::PolyRow<4>& row : part.rows) {
      for (std::size_t i = 0; i < 4; ++i) {
        const plain::Poly rest = plain::plus(own.rows[j][i], plain::scaled(Rational(-1), row[i]));
        require(std::ranges::all_of(rest, [](const Rational& a) { return a.sign() == 0; }), message);
      }
    }
  }
}

/// The polynomial of the drawn piece, and its number without the empty ones.
const plain::PolyRow<4>& row_of(const Curves::In& in, const Pieces<4>& pieces) {
  std::size_t j = 0;
  while (pieces.breaks[j + 1] <= in.knots.piece_begin(in.piece)) ++j;
  return pieces.rows[j];
}

void check_values(const Curves::In& in, const Pieces<4>& pieces) {
  const plain::PolyRow<4>& row = row_of(in, pieces);
  const int k = in.piece;
  const Rational& t = in.arguments.front();
  require((curve_point<Rational, Row4>(in.knots, in.rows, k, t) == plain::value_at<4>(row, t)), "another value");
  require(
      (curve_derivative<Rational, Row4>(in.knots, in.rows, k, t) == plain::value_at<4>(plain::derivative<4>(row), t)),
      "another derivative");
  std::vector<Parameter<Rational>> arguments;
  for (const Rational& x : in.arguments) arguments.push_back(at(x));
  require((blossom<Rational, Row4>(in.knots, in.rows, k, arguments) == blossom_of(row, in.arguments)),
          "another blossom");
  const auto polynomials = piece_polynomials<Rational, 4>(in.knots, in.rows, k);
  for (std::size_t i = 0; i < 4; ++i) {
    plain::Poly coefficients = polynomials[i].coefficients();
    coefficients.resize(row[i].size());
    require(polynomials[i].degree() < static_cast<int>(row[i].size()) && coefficients == row[i],
            "another polynomial of a piece");
  }
}

void check_bezier(const Curves::In& in, const Pieces<4>& pieces) {
  const KnotList<Rational>& u = in.knots;
  const plain::PolyRow<4>& row = row_of(in, pieces);
  const Rational& a = u.piece_begin(in.piece);
  const Rational& b = u.piece_end(in.piece);
  const std::vector<Row4> points = bezier_points<Rational, Row4>(u, in.rows, in.piece);
  const std::vector<Row4> expected = plain::control_row<4>({{a, b}, {row}}, bezier_knots<Rational>(u.degree(), a, b));
  require(points == expected, "another Bezier polygon");
  for (int i = in.piece - 1; i < in.piece + u.degree(); ++i) {
    require((spline_vertex<Rational, Row4>(u, points, in.piece, i) == in.rows[static_cast<std::size_t>(i)]),
            "the Bezier polygon does not give the vertices back");
  }
  const auto rows = bezier_rows(piece_polynomials<Rational, 4>(u, in.rows, in.piece), u.degree(), a, b);
  require(rows == expected, "polynomials do not give the Bezier polygon");
}

int count_of(const KnotList<Rational>& u, const Rational& t) {
  return static_cast<int>(std::count(u.list().begin(), u.list().end(), t));
}

void check_insertion(const Curves::In& in, const Curve& curve, const Pieces<4>& pieces) {
  const int n = in.knots.degree();
  Curve fine = with_multiplicity(curve, in.from, n);
  require(count_of(fine.knots, in.from) == n, "another multiplicity");
  require_curve(fine, pieces, "knot insertion changes the curve");
  if (count_of(curve.knots, in.to) < n) {
    fine = insert_knot(curve, in.to);
    require(fine.knots.size() == curve.knots.size() + 1, "another number of knots");
    require(count_of(fine.knots, in.to) == count_of(curve.knots, in.to) + 1, "another knot");
    require_curve(fine, pieces, "the insertion of a knot changes the curve");
  }
  // What was inserted is taken out again: the vertices over the old knots, from the polynomials of the finer curve.
  const Pieces<4> finer = plain::pieces_of<4>(fine.knots, fine.control);
  const Curve back(in.knots, plain::control_row<4>(finer, in.knots));
  require_curve(back, pieces, "the finer curve is no spline over the old knots");
}

void check_elevation(const Curve& curve, const Pieces<4>& pieces) {
  const Curve raised = elevate(curve);
  require(raised.knots.degree() == curve.knots.degree() + 1, "another degree");
  require_curve(raised, pieces, "degree elevation changes the curve");
  for (std::size_t j = 1; j + 1 < pieces.breaks.size(); ++j) {
    require(count_of(raised.knots, pieces.breaks[j]) == count_of(curve.knots, pieces.breaks[j]) + 1,
            "an elevated knot is not once more there");
  }
}

/// Two parts and the whole of them.
void check_parts(const Curves::In& in, const Curve& curve, const Pieces<4>& pieces) {
  if (in.from == in.to) return;
  const Curve part = restrict_spline(curve, in.from, in.to);
  require(part.knots.clamped() == Truth::yes, "a part is not clamped");
  require_curve(part, plain::trimmed(pieces, in.from, in.to), "a part of the curve is another curve");
  const Rational middle = (in.from + in.to) / Rational(2);
  const Curve left = restrict_spline(part, in.from, middle);
  const Curve right = restrict_spline(part, middle, in.to);
  require(left.control.back() == right.control.front(), "two parts do not meet");
  std::vector<Row4> rows = left.control;
  rows.insert(rows.end(), right.control.begin() + 1, right.control.end());
  require(rows == with_multiplicity(part, middle, in.knots.degree()).control, "two parts are not the whole");
}

void check_parameters(const Curves::In& in, const Curve& curve, const Pieces<4>& pieces) {
  const Rational zero;
  const Rational one(1);
  const Rational begin = in.arguments.front();
  const Curve moved = reparametrized(curve, begin, begin + Rational(2));
  const Rational scale = (in.knots.domain_end() - in.knots.domain_begin()) / Rational(2);
  const plain::Substitution by{scale, in.knots.domain_begin() - scale * begin, zero, one};
  require_curve(moved, plain::substituted(pieces, in.knots.degree(), by), "another interval, another curve");
  const plain::Substitution turn{-one, in.knots.domain_begin() + in.knots.domain_end(), zero, one};
  require_curve(reversed_spline(curve), plain::substituted(pieces, in.knots.degree(), turn), "reversed, another curve");
  const Curve twice = reversed_spline(reversed_spline(curve));
  require(twice.control == curve.control && twice.knots.list() == curve.knots.list(), "reversed twice, another net");
}

}  // namespace

const PropertyInfo& Curves::info() {
  static const PropertyInfo info{"curves",
                                 "values, blossoms, Bezier polygons, knots, degrees, parts and parameters of a spline "
                                 "are those of its polynomials",
                                 8,
                                 {"knots=bezier", "knots=clamped", "knots=unclamped", "knots=mixed", "knots=full",
                                  "knots=repeated", "knots=extreme", "from=knot", "from=inside", "empty pieces=yes"}};
  return info;
}

Curves::In Curves::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{.knots = draw_knots(choices, scale)};
  const KnotList<Rational>& u = in.knots;
  in.rows = draw_rows(choices, scale, u.last() + 1, Weights::any);
  const std::vector<int> pieces = u.proper_pieces();
  in.piece = pieces[choices.below(pieces.size())];
  for (int i = 0; i < u.degree(); ++i) {
    in.arguments.push_back(choices.once_in(2) ? draw_number(choices, scale) : draw_inside(choices, u, in.piece));
  }
  in.from = draw_inside(choices, u, choices.between(1, u.pieces()));
  in.to = draw_inside(choices, u, choices.between(1, u.pieces()));
  if (in.to < in.from) std::swap(in.from, in.to);
  labels.add("degree", u.degree());
  labels.add("knots", std::string(knot_kind(u)));
  labels.add("from", count_of(u, in.from) > 0 ? "knot" : "inside");
  labels.add("empty pieces", static_cast<int>(pieces.size()) < u.pieces() ? "yes" : "no");
  return in;
}

void Curves::check(const In& in, Labels&) {
  const Curve curve(in.knots, in.rows);
  const Pieces<4> pieces = plain::pieces_of<4>(in.knots, in.rows);
  check_values(in, pieces);
  check_bezier(in, pieces);
  check_insertion(in, curve, pieces);
  check_elevation(curve, pieces);
  check_parts(in, curve, pieces);
  check_parameters(in, curve, pieces);
}

}  // namespace torse::fuzz
