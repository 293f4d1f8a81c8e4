// The library's templates for splines over more knots and of a higher degree, and for the surface of BZZ19.16.
#include "torse/proofs/coq/compare/tables.hpp"
#include "torse/quasi/condition.hpp"
#include "torse/quasi/surface.hpp"
#include "torse/spline/elevation.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using P = const Problem&;

Answer finer(const Problem& p) {
  const auto c = p.spline<3>();
  return Answer() << refined(c, KnotList<Q>(p.integer("n"), p.numbers("v"))).control;
}

Answer raised(const Problem& p) {
  const auto found = elevate(p.spline<3>());
  return Answer() << found.knots.list() << found.control;
}

Answer surface(const Problem& p) {
  const auto c1 = p.spline<3>();
  const Spline<Q, Point3> c2(KnotList<Q>(p.integer("p"), p.numbers("v")), p.points<3>("e"));
  const Mapping<Q> sigma = mapping_of(KnotList<Q>(p.integer("d"), p.numbers("w")), p.numbers("b"));
  const auto kind = p.integer("s") == 1 ? SurfaceKnots::uniform : SurfaceKnots::of_mapping;
  const RuledSpline<Q, Point3> found = quasi_surface(c1, c2, sigma, kind);
  return Answer() << found.knots.list() << found.c << found.d;
}

Answer products(const Problem& p) {
  const auto found = normal_products<Q>(p.point<3>("v"), p.point<3>("d"), p.point<3>("a"), p.point<3>("b"));
  return Answer() << found.with_a << found.with_b << found.with_w;
}

}  // namespace

const Table& of_surfaces() {
  static const Table table{
      {"refined", finer},
      {"elevate", raised},
      {"breakpoints",
       [](P p) { return Answer() << breakpoints(p.knots(), KnotList<Q>(p.integer("n"), p.numbers("v"))); }},
      {"quasi_surface", surface},
      {"ruling_determinant",
       [](P p) { return Answer() << ruling_determinant<Q>(p.point<3>("d"), p.point<3>("a"), p.point<3>("b")); }},
      {"normal_products", products},
      {"normal_residual",
       [](P p) {
         return Answer() << normal_residual<Q>(p.point<3>("v"), p.point<3>("d"), p.point<3>("a"), p.point<3>("b"));
       }},
      {"unit_penalty", [](P p) { return Answer() << unit_penalty<Q>(p.point<3>("v")); }},
  };
  return table;
}

}  // namespace torse::compare
