// B-spline surfaces of STEP: any numbers, lists and kinds give a net or an error, the net has the file's numbers bit
// for bit, and its strips become surfaces or an error.
#include <Standard_Failure.hxx>
#include <StepGeom_BSplineSurfaceWithKnots.hxx>
#include <StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface.hxx>
#include <StepGeom_BezierSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_QuasiUniformSurface.hxx>
#include <StepGeom_RationalBSplineSurface.hxx>
#include <StepGeom_UniformSurface.hxx>
#include <TCollection_HAsciiString.hxx>

#include "torse/cad/read.hpp"
#include "torse/cad/step_net.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/fuzz/targets/cad/numbers.hpp"
#include "torse/fuzz/targets/target.hpp"

namespace torse::targets {
namespace {

using fuzz::Choices;
using Surface = Handle(StepGeom_BSplineSurface);

Handle(StepGeom_HArray2OfCartesianPoint) draw_points(Choices& choices, int rows, int columns) {
  if (choices.once_in(64)) return {};
  Handle(StepGeom_HArray2OfCartesianPoint) points = new StepGeom_HArray2OfCartesianPoint(1, rows, 1, columns);
  const Handle(TCollection_HAsciiString) name = new TCollection_HAsciiString("");
  for (int i = 1; i <= rows; ++i) {
    for (int j = 1; j <= columns; ++j) {
      if (choices.once_in(256)) continue;
      Handle(StepGeom_CartesianPoint) point = new StepGeom_CartesianPoint;
      const double x = draw_real(choices);
      const double y = draw_real(choices);
      if (choices.once_in(256)) {
        point->Init2D(name, x, y);
      } else {
        point->Init3D(name, x, y, draw_real(choices));
      }
      points->SetValue(i, j, point);
    }
  }
  return points;
}

/// Multiplicities whose sum is `total` as often as not.
Handle(TColStd_HArray1OfInteger) draw_times(Choices& choices, int degree, int total) {
  std::vector<int> times;
  for (int left = total; left > 0;) {
    const int most = times.empty() || left <= degree + 1 ? degree + 1 : degree;
    times.push_back(std::min(left, choices.between(times.empty() ? most : 1, std::max(1, most))));
    left -= times.back();
  }
  if (times.empty() || choices.once_in(8)) {
    times.push_back(choices.once_in(4) ? static_cast<int>(choices.below(~std::uint64_t{0})) : choices.between(-1, 9));
  }
  Handle(TColStd_HArray1OfInteger) list = new TColStd_HArray1OfInteger(1, static_cast<int>(times.size()));
  for (std::size_t i = 0; i < times.size(); ++i) list->SetValue(static_cast<int>(i) + 1, times[i]);
  return list;
}

/// What the kinds of surfaces have in common.
struct Parts {
  int degree_u;
  int degree_v;
  Handle(StepGeom_HArray2OfCartesianPoint) points;
};

template <class T>
void set_common(const Handle(T) & surface, const Parts& parts) {
  surface->SetUDegree(parts.degree_u);
  surface->SetVDegree(parts.degree_v);
  surface->SetControlPointsList(parts.points);
}

Handle(TColStd_HArray1OfReal) knots_for(Choices& choices, const Handle(TColStd_HArray1OfInteger) & times) {
  return draw_knots(choices, 1, times->Length() + (choices.once_in(32) ? 1 : 0), 1);
}

Surface draw_with_knots(Choices& choices, const Parts& parts, int rows, int columns) {
  Handle(StepGeom_BSplineSurfaceWithKnots) surface = new StepGeom_BSplineSurfaceWithKnots;
  set_common(surface, parts);
  const auto times_u = draw_times(choices, parts.degree_u, rows + parts.degree_u + 1);
  const auto times_v = draw_times(choices, parts.degree_v, columns + parts.degree_v + 1);
  surface->SetUMultiplicities(times_u);
  surface->SetVMultiplicities(times_v);
  surface->SetUKnots(knots_for(choices, times_u));
  surface->SetVKnots(knots_for(choices, times_v));
  return surface;
}

Surface draw_rational(Choices& choices, const Parts& parts, int rows, int columns) {
  Handle(StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface) surface =
      new StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface;
  Handle(StepGeom_BSplineSurfaceWithKnots) knots =
      Handle(StepGeom_BSplineSurfaceWithKnots)::DownCast(draw_with_knots(choices, parts, rows, columns));
  Handle(StepGeom_RationalBSplineSurface) rational = new StepGeom_RationalBSplineSurface;
  Handle(TColStd_HArray2OfReal) weights = new TColStd_HArray2OfReal(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i) {
    for (int j = 1; j <= columns; ++j) weights->SetValue(i, j, draw_real(choices));
  }
  rational->SetWeightsData(choices.once_in(64) ? Handle(TColStd_HArray2OfReal)() : weights);
  const Handle(TCollection_HAsciiString) name = new TCollection_HAsciiString("");
  surface->Init(name, parts.degree_u, parts.degree_v, parts.points, StepGeom_bssfUnspecified, StepData_LFalse,
                StepData_LFalse, StepData_LFalse, knots, rational);
  return surface;
}

template <class T>
Surface plain(const Parts& parts) {
  Handle(T) surface = new T;
  set_common(surface, parts);
  return surface;
}

Surface draw_surface(Choices& choices) {
  const int rows = choices.between(1, 6);
  const int columns = choices.once_in(2) ? 2 : choices.between(1, 6);
  const auto degree = [&](int points) {
    return choices.once_in(32) ? choices.between(-1, 40) : choices.between(1, std::max(1, points - 1));
  };
  const int degree_u = degree(rows);
  const Parts parts{degree_u, degree(columns), draw_points(choices, rows, columns)};
  switch (choices.below(6)) {
    case 0:
      return plain<StepGeom_BezierSurface>(parts);
    case 1:
      return plain<StepGeom_UniformSurface>(parts);
    case 2:
      return plain<StepGeom_QuasiUniformSurface>(parts);
    case 3:
      return draw_rational(choices, parts, rows, columns);
    default:
      return draw_with_knots(choices, parts, rows, columns);
  }
}

void check_numbers(const Surface& surface, const cad::Net& net) {
  const auto points = surface->ControlPointsList();
  require(net.columns == static_cast<std::size_t>(points->RowLength()), "as many columns as the file has");
  require(net.points.size() == static_cast<std::size_t>(points->Length()), "as many points as the file has");
  require(net.weights.size() == net.points.size(), "a weight for each point");
  for (int i = 1; i <= points->UpperRow(); ++i) {
    for (int j = 1; j <= points->UpperCol(); ++j) {
      const CadPoint& x = net.points[static_cast<std::size_t>((i - 1) * points->RowLength() + j - 1)];
      for (int k = 1; k <= 3; ++k) {
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(points->Value(i, j)->CoordinatesValue(k));
        require(std::bit_cast<std::uint64_t>(x[static_cast<std::size_t>(k - 1)]) == bits, "points bit for bit");
      }
    }
  }
}

void check(Choices choices) {
  const Surface surface = draw_surface(choices);
  CadFace face;
  try {
    const cad::Net net = cad::net_of_step(surface);
    check_numbers(surface, net);
    std::optional<cad::Box> box;
    if (choices.once_in(4)) {
      box = cad::Box{{draw_real(choices), draw_real(choices)}, {draw_real(choices), draw_real(choices)}};
    }
    cad::add_net(net, box, face);
  } catch (const cad::Unreadable&) {
    return;
  } catch (const Standard_Failure&) {
    return;
  }
  for (const CadStrip& strip : face.strips) {
    try {
      const RuledFile<Rational> ruled = cli::surface_of(strip, face.placement);
      const std::size_t count = static_cast<std::size_t>(ruled.knots.last()) + 1;
      require(ruled.c.points.size() == count && ruled.d.points.size() == count, "both rows fit the knots");
    } catch (const InvalidInput&) {
    }
  }
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check(torse::fuzz::Choices::from_bytes({data, size}));
  return 0;
}
