#include "torse/fuzz/properties/verdict_invariance.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "torse/developable/classify.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/spline/compatible.hpp"

namespace torse::fuzz {
namespace {

template <int D>
using Row = std::vector<Vec<Rational, D>>;

template <int D>
using Curve = Spline<Rational, Vec<Rational, D>>;

/// Knots as often as the degree allows, the higher degree, the new domain, its direction.
template <int D>
Curve<D> rewritten(const typename VerdictInvariance<D>::In& in, const Row<D>& row) {
  Curve<D> curve(in.net.knots, row);
  for (const Rational& t : in.knots) {
    if (multiplicity(curve.knots, t) < curve.knots.degree()) curve = insert_knot(curve, t);
  }
  if (in.elevated) curve = elevate(curve);
  curve = reparametrized(curve, in.begin, in.end);
  return in.reversed ? reversed_spline(curve) : curve;
}

template <int D>
Row<D> mapped_row(const SpaceMap& map, const Rational& factor, const Row<D>& row) {
  Row<D> result;
  for (const Vec<Rational, D>& x : row) {
    result.push_back(map(x));
    for (int j = 0; D == 4 && j < D; ++j) result.back()[j] *= factor;
  }
  return result;
}

Row<4> in_rows(const Row<4>& row) { return row; }
Row<4> in_rows(const Row<3>& row) {
  Row<4> rows;
  for (const Point3& x : row) rows.emplace_back(Rational(1), x[0], x[1], x[2]);
  return rows;
}

bool parallel(const Row4& x, const Row4& y) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (x[i] * y[j] != x[j] * y[i]) return false;
    }
  }
  return true;
}

/// A cone or cylinder goes to the one with the image of the common point.
void check_class(const KnotList<Rational>& u, const Row<4>& p, const Row<4>& q, const SpaceMap& map,
                 const std::string& before, const std::optional<Row4>& common) {
  const Classification<Rational> found = classify<Rational>(u, p, q);
  if (!common) return require(name_of(found.kind) == before, "another class");
  const Row4 image = map(*common);
  require(name_of(found.kind) == (image[0].sign() == 0 ? "cylinder" : "cone"), "not the class of the common point");
  const bool cone = found.kind == SurfaceClass::cone;
  const Point3& x = cone ? *found.vertex : *found.direction;
  require(parallel(image, Row4(Rational(cone ? 1 : 0), x[0], x[1], x[2])), "not the image of vertex or direction");
}

template <int D>
void check_transformed(const typename VerdictInvariance<D>::In& in) {
  const Net<D>& net = in.net;
  const Curve<D> c = rewritten<D>(in, mapped_row<D>(in.map, in.c_factor, net.c));
  const Curve<D> d = rewritten<D>(in, mapped_row<D>(in.map, in.d_factor, net.d));
  const Row<D>& first = in.swapped ? d.control : c.control;
  const Row<D>& second = in.swapped ? c.control : d.control;
  const auto witness = find_witness_over_q<D>(c.knots, first, second);
  require(witness.has_value() != net.developable, "another verdict");
  if (net.developable) {
    return check_class(c.knots, in_rows(first), in_rows(second), in.map, net.klass, net.common);
  }
  if (in.reversed || in.elevated || !in.knots.empty()) return;
  const auto before = find_witness_over_q<D>(net.knots, net.c, net.d);
  const Rational factor = in.c_factor * in.d_factor;
  require(witness->piece == before->piece && witness->coefficient == before->coefficient, "the witness is elsewhere");
  require(witness->value == before->value * determinant(in.map) * factor * factor,
          "the witness's value is not multiplied by the determinant");
}

}  // namespace

template <>
const PropertyInfo& VerdictInvariance<3>::info() {
  static const PropertyInfo info{
      "verdict.affine",
      "polynomial nets: verdict and class stay under affine maps, knot insertion, degree elevation, another domain, "
      "reversal and exchange of the rows; vertex, direction and the witness's value change as they must",
      15,
      {"map=rotation", "map=reflection", "map=similarity", "map=affine", "reversed=1", "swapped=1", "elevated=1",
       "inserted=0", "inserted=2", "class=cone", "class=cylinder", "class=tangent", "class=none"}};
  return info;
}

template <>
const PropertyInfo& VerdictInvariance<4>::info() {
  static const PropertyInfo info{
      "verdict.projective",
      "the same of homogeneous rows under projective maps too, which may make a cone of a cylinder, and under factors "
      "of the rows",
      20,
      {"map=rotation", "map=similarity", "map=affine", "map=projective", "reversed=1", "swapped=1", "elevated=1",
       "inserted=0", "inserted=2", "class=cone", "class=cylinder", "class=tangent", "class=none"}};
  return info;
}

template <int D>
typename VerdictInvariance<D>::In VerdictInvariance<D>::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in;
  if constexpr (D == 3) {
    in.net = draw_net(choices, scale);
  } else {
    in.net = draw_row_net(choices, scale);
    in.c_factor = draw_nonzero(choices, scale);
    in.d_factor = draw_nonzero(choices, scale);
  }
  in.map = draw_space_map(choices, scale, D == 4);
  in.begin = draw_number(choices, scale);
  in.end = in.begin + draw_positive(choices, scale);
  in.reversed = choices.once_in(3);
  in.swapped = choices.once_in(2);
  in.elevated = choices.once_in(3);
  const int count = choices.pick({0, 0, 1, 2});
  for (int i = 0; i < count; ++i) {
    const Rational t = draw_inside(choices, in.net.knots, choices.between(1, in.net.knots.pieces()));
    if (in.net.knots.domain_begin() < t && t < in.net.knots.domain_end()) in.knots.push_back(t);
  }
  add_net_labels(labels, in.net);
  labels.add("map", in.map.kind);
  labels.add("reversed", in.reversed);
  labels.add("swapped", in.swapped);
  labels.add("elevated", in.elevated);
  labels.add("inserted", static_cast<int>(in.knots.size()));
  return in;
}

template <int D>
void VerdictInvariance<D>::check(const In& in, Labels&) {
  check_transformed<D>(in);
}

template struct VerdictInvariance<3>;
template struct VerdictInvariance<4>;

}  // namespace torse::fuzz
