// The library's templates for composition and for polynomials in Bernstein and power form, BZZ19, section 4.
#include "torse/proofs/coq/compare/tables.hpp"
#include "torse/quasi/surface.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using P = const Problem&;

Answer composed(const Problem& p) {
  const auto c = p.points<3>("c");
  const auto e = p.numbers("e");
  return Answer() << composed_points<Q, Point3>(c, e);
}

Answer rows(const Problem& p) {
  const std::array<Polynomial<Q>, 1> row{Polynomial<Q>(p.numbers("f"))};
  return Answer() << bezier_rows(row, p.integer("n"), p.number("a"), p.number("b"));
}

/// All n + 1 coefficients. Throws DivisionByZero for an empty piece, which has no polynomial.
Answer piece(const Problem& p) {
  const KnotList<Q> u = p.knots();
  std::vector<Vec<Q, 1>> c;
  for (const Q& x : p.numbers("f")) c.push_back(Vec<Q, 1>::Constant(x));
  const Spline<Q, Vec<Q, 1>> f(u, c);
  const int k = p.integer("k");
  if (definitely(u.piece_empty(k))) throw DivisionByZero();
  std::vector<Q> coefficients = piece_polynomials<Q, 1>(u, f.points(), k)[0].coefficients();
  coefficients.resize(static_cast<std::size_t>(u.degree()) + 1, Q(0));
  return Answer() << coefficients;
}

}  // namespace

const Table& of_polynomials() {
  static const Table table{
      {"composed_points", composed},
      {"bezier_rows", rows},
      {"piece_polynomials", piece},
  };
  return table;
}

}  // namespace torse::compare
