// The library's templates for one Bezier piece and for one parameter: FJ07.12 and 17, FJ21, ZW06, BZZ19.
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/regression.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/developable/special.hpp"
#include "torse/proofs/coq/compare/tables.hpp"
#include "torse/quasi/surface.hpp"

namespace torse::compare {
namespace {

using Q = Rational;
using Point3 = Vec<Q, 3>;
using P = const Problem&;

Answer affine_cell(const Problem& p) {
  const AffineCell<Q> cell = affine_from_local(p.number("L"), p.number("M"));
  return Answer() << cell.lam << cell.mu;
}

Answer blossom_functions(const BlossomFunctions<Q>& f) { return Answer() << f.lambda << f.m << f.sigma; }
Answer frame_functions(const FrameFunctions<Q>& f) { return Answer() << f.lambda << f.mu << f.nu; }

/// The three numbers x as one of the structs of three functions.
template <class Functions>
Functions triple(const Problem& p) {
  const std::vector<Q> x = p.numbers("x");
  return {x.at(0), x.at(1), x.at(2)};
}

Answer edge(const Problem& p) {
  const auto f = triple<BlossomFunctions<Q>>(p);
  const EdgeSpeed<Q> speed = edge_speed(p.integer("n"), p.number("t"), f);
  return Answer() << edge_parameter(p.number("t"), f) << speed.alpha << speed.beta;
}

Answer standard(const Problem& p) {
  const std::vector<Q> x = p.numbers("x");
  return Answer() << standard_parameter(x.at(0), x.at(1), x.at(2));
}

Answer elevation(const Problem& p) {
  const std::vector<Point3> c = p.points<3>("c");
  return Answer() << elevated_points<Q, Point3>(c, static_cast<int>(c.size()) - 1 + p.integer("i"));
}

}  // namespace

const Table& of_one_piece() {
  static const Table table{
      {"affine_from_local", affine_cell},
      {"aumann_net",
       [](P p) {
         return Answer() << aumann_net<Q, Point3>(p.points<3>("c"), p.number("L"), p.number("M"), p.point<3>("d"));
       }},
      {"restrict_rulings",
       [](P p) { return Answer() << restrict_rulings<Q, Point3>(p.points<3>("c"), p.points<3>("d"), p.number("x")); }},
      {"to_blossom",
       [](P p) { return blossom_functions(to_blossom(p.integer("n"), p.number("t"), triple<FrameFunctions<Q>>(p))); }},
      {"to_frame",
       [](P p) { return frame_functions(to_frame(p.integer("n"), p.number("t"), triple<BlossomFunctions<Q>>(p))); }},
      {"standard_parameter", standard},
      {"gauged",
       [](P p) { return frame_functions(gauged(triple<FrameFunctions<Q>>(p), p.number("a"), p.number("b"))); }},
      {"scaled_weights",
       [](P p) {
         return blossom_functions(scaled_weights(triple<BlossomFunctions<Q>>(p), p.number("a"), p.number("b")));
       }},
      {"edge", edge},
      {"cylinder_net",
       [](P p) { return Answer() << cylinder_net<Q, Point3>(p.points<3>("c"), p.point<3>("v"), p.numbers("h")); }},
      {"cone_vertex", [](P p) { return Answer() << cone_vertex<Q>(p.point<3>("v"), p.point<3>("d"), p.number("x")); }},
      {"restricted_lambda",
       [](P p) { return Answer() << restricted_lambda(p.number("L"), p.number("M"), p.number("x")); }},
      {"coefficients_from_steps", [](P p) { return Answer() << coefficients_from_steps<Q>(p.numbers("e")); }},
      {"elevated_points", elevation},
      {"cone_net",
       [](P p) { return Answer() << cone_net<Q, Point3>(p.points<3>("c"), p.number("x"), p.point<3>("d")); }},
      {"start_cone_net", [](P p) { return Answer() << start_cone_net<Q, Point3>(p.points<3>("c"), p.number("s")); }},
      {"mean_tangent_net", [](P p) { return Answer() << mean_tangent_net<Q, Point3>(p.points<3>("c")); }},
      {"tangent_net", [](P p) { return Answer() << tangent_net<Q, Point3>(p.points<3>("c")); }},
      {"mean_chord_net", [](P p) { return Answer() << mean_chord_net<Q, Point3>(p.points<3>("c")); }},
      {"affine_net",
       [](P p) {
         return Answer() << affine_net<Q, Point3>(p.points<3>("c"), p.number("x"), p.number("s"), p.point<3>("d"));
       }},
  };
  return table;
}

}  // namespace torse::compare
