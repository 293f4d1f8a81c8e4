#include "torse/cad/step_net.hpp"

#include <StepGeom_BSplineSurfaceWithKnots.hxx>
#include <StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface.hxx>
#include <StepGeom_BezierSurface.hxx>
#include <StepGeom_BezierSurfaceAndRationalBSplineSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_QuasiUniformSurface.hxx>
#include <StepGeom_QuasiUniformSurfaceAndRationalBSplineSurface.hxx>
#include <StepGeom_RationalBSplineSurface.hxx>
#include <StepGeom_UniformSurface.hxx>
#include <StepGeom_UniformSurfaceAndRationalBSplineSurface.hxx>

#include "torse/cad/read.hpp"

namespace torse::cad {
namespace {

using Surface = Handle(StepGeom_BSplineSurface);

/// Beyond this no list of knots is long.
constexpr std::size_t most_knots = 1'000'000;

std::vector<double> repeated(const Handle(TColStd_HArray1OfReal) & knots,
                             const Handle(TColStd_HArray1OfInteger) & times) {
  if (knots.IsNull() || times.IsNull() || knots->Length() != times->Length()) {
    throw Unreadable("expected a multiplicity for each knot");
  }
  std::vector<double> list;
  for (int i = 0; i < knots->Length(); ++i) {
    const int count = times->Value(times->Lower() + i);
    if (count < 1 || list.size() + static_cast<std::size_t>(count) > most_knots) {
      throw Unreadable("expected multiplicities of knots that are positive and small");
    }
    list.insert(list.end(), static_cast<std::size_t>(count), knots->Value(knots->Lower() + i));
  }
  return list;
}

/// Knots 0, 1, ... of a uniform curve, as OpenCASCADE counts them; 0, ..., 0, 1, ..., m, ..., m for a quasi-uniform
/// one.
std::vector<double> uniform(int degree, std::size_t points, bool clamped) {
  std::vector<double> list;
  const int last = static_cast<int>(points) - degree;
  for (int i = -degree; i <= last + degree; ++i) list.push_back(clamped ? std::min(std::max(i, 0), last) : i + degree);
  return list;
}

/// Bezier pieces: inner knots of the degree's multiplicity.
std::vector<double> bezier(int degree, std::size_t points) {
  std::vector<double> list{0};
  double knot = 0;
  for (std::size_t i = 0; degree > 0 && i + 1 < points; i += static_cast<std::size_t>(degree)) {
    list.insert(list.end(), static_cast<std::size_t>(degree), knot);
    knot += 1;
  }
  const double end = list.back() + 1;
  list.insert(list.end(), static_cast<std::size_t>(degree) + 1, end);
  return list;
}

template <class T>
bool set_knots(const Surface& surface, Net& net) {
  const Handle(T) with_knots = Handle(T)::DownCast(surface);
  if (with_knots.IsNull()) return false;
  net.knots_u = repeated(with_knots->UKnots(), with_knots->UMultiplicities());
  net.knots_v = repeated(with_knots->VKnots(), with_knots->VMultiplicities());
  return true;
}

void set_implied_knots(const Surface& surface, Net& net) {
  const auto is = [&](const Handle(Standard_Type) & type) { return surface->IsKind(type); };
  const auto list = [&](int degree, std::size_t points) {
    if (is(STANDARD_TYPE(StepGeom_BezierSurface)) ||
        is(STANDARD_TYPE(StepGeom_BezierSurfaceAndRationalBSplineSurface))) {
      return bezier(degree, points);
    }
    const bool uniform_kind = is(STANDARD_TYPE(StepGeom_UniformSurface)) ||
                              is(STANDARD_TYPE(StepGeom_UniformSurfaceAndRationalBSplineSurface));
    const bool quasi = is(STANDARD_TYPE(StepGeom_QuasiUniformSurface)) ||
                       is(STANDARD_TYPE(StepGeom_QuasiUniformSurfaceAndRationalBSplineSurface));
    if (!uniform_kind && !quasi) throw Unreadable("expected a B-spline surface with knots");
    return uniform(degree, points, quasi);
  };
  net.knots_u = list(net.degree_u, net.points.size() / net.columns);
  net.knots_v = list(net.degree_v, net.columns);
}

template <class T>
bool set_weights(const Surface& surface, Net& net) {
  const Handle(T) rational = Handle(T)::DownCast(surface);
  if (rational.IsNull()) return false;
  const Handle(TColStd_HArray2OfReal) weights = rational->WeightsData();
  if (weights.IsNull()) throw Unreadable("expected weights of the control points");
  for (int i = weights->LowerRow(); i <= weights->UpperRow(); ++i) {
    for (int j = weights->LowerCol(); j <= weights->UpperCol(); ++j) net.weights.push_back(weights->Value(i, j));
  }
  return true;
}

void set_points(const Surface& surface, Net& net) {
  const Handle(StepGeom_HArray2OfCartesianPoint) points = surface->ControlPointsList();
  if (points.IsNull()) throw Unreadable("expected control points");
  net.columns = static_cast<std::size_t>(points->RowLength());
  for (int i = points->LowerRow(); i <= points->UpperRow(); ++i) {
    for (int j = points->LowerCol(); j <= points->UpperCol(); ++j) {
      const Handle(StepGeom_CartesianPoint) point = points->Value(i, j);
      if (point.IsNull() || point->NbCoordinates() != 3)
        throw Unreadable("expected control points of three coordinates");
      net.points.push_back({point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3)});
    }
  }
}

}  // namespace

Net net_of_step(const Surface& surface) {
  Net net{.degree_u = surface->UDegree(), .degree_v = surface->VDegree()};
  set_points(surface, net);
  if (net.degree_u < 1 || net.degree_v < 1 || net.columns == 0) throw Unreadable("expected degrees of at least 1");
  if (!set_knots<StepGeom_BSplineSurfaceWithKnots>(surface, net) &&
      !set_knots<StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface>(surface, net)) {
    set_implied_knots(surface, net);
  }
  if (!set_weights<StepGeom_RationalBSplineSurface>(surface, net) &&
      !set_weights<StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface>(surface, net) &&
      !set_weights<StepGeom_BezierSurfaceAndRationalBSplineSurface>(surface, net) &&
      !set_weights<StepGeom_QuasiUniformSurfaceAndRationalBSplineSurface>(surface, net) &&
      !set_weights<StepGeom_UniformSurfaceAndRationalBSplineSurface>(surface, net)) {
    net.weights.assign(net.points.size(), 1);
  }
  return net;
}

}  // namespace torse::cad
