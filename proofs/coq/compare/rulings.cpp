// The library's templates for interpolation between rulings, FJ07.20 and 21, and for the rows of all pieces, FJ07.19.
#include "torse/developable/interpolation.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;

/// a(M) as the interpolation takes it, for an M that is no knot.
Answer aim(const Problem& p) {
  const auto c = p.spline<3>();
  require_off_knots(c.knots, p.number("M"));
  return Answer() << eq20(c.knots, c.points(), p.number("M"), p.integer("i"));
}

Answer branches(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << branch_polynomial<Q>(c.knots, c.points(), p.point<3>("v"), p.point<3>("w"));
}

Answer coordinates(const Problem& p) {
  const auto found = chord_coordinates<Q>(p.point<3>("d"), p.point<3>("v"), p.point<3>("w"));
  return Answer() << found.alpha << found.beta;
}

Answer ends(const Problem& p) {
  const auto c = p.spline<3>();
  const EndRulings<Q> found =
      end_rulings<Q>(c.knots, c.points(), p.point<3>("v"), p.point<3>("w"), p.number("M"), p.number("L"));
  return Answer() << found.sigma0 << found.tau0;
}

Answer interpolation(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << interpolating_net<Q>(c.knots, c.points(), p.point<3>("v"), p.point<3>("w"), p.number("M"),
                                          p.number("L"));
}

Answer piecewise(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << piecewise_net<Q, Point3>(c.knots, c.points(), p.number("L"), p.number("M"), p.point<3>("d"));
}

}  // namespace

const Table& of_rulings() {
  static const Table table{
      {"eq20", aim},         {"branch_polynomial", branches},      {"chord_coordinates", coordinates},
      {"end_rulings", ends}, {"interpolating_net", interpolation}, {"piecewise_net", piecewise},
  };
  return table;
}

}  // namespace torse::compare
