// B-spline curves of IGES: any numbers and lists give a rail or an error, the rail has the file's numbers bit for bit,
// and becomes a curve or an error.
#include <IGESData_IGESModel.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_Line.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_HArray1OfXYZ.hxx>
#include <gp_Pnt.hxx>

#include "torse/cad/iges_curve.hpp"
#include "torse/cad/read.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/fuzz/targets/cad/numbers.hpp"
#include "torse/fuzz/targets/target.hpp"

namespace torse::targets {
namespace {

using fuzz::Choices;

gp_XYZ draw_point(Choices& choices) {
  const double x = draw_real(choices);
  const double y = draw_real(choices);
  return {x, y, draw_real(choices)};
}

Handle(IGESGeom_BSplineCurve) draw_spline(Choices& choices) {
  const int upper = choices.between(0, 8);
  const int degree = choices.once_in(32) ? choices.between(-2, 40) : choices.between(1, std::max(1, upper));
  const int lists = std::max(1, upper + degree + 2 + (choices.once_in(32) ? choices.between(-1, 1) : 0));
  const Handle(TColStd_HArray1OfReal) knots = draw_knots(choices, -degree, lists, 0);
  const Handle(TColStd_HArray1OfReal) weights =
      draw_reals(0, upper + 1 + (choices.once_in(32) ? 1 : 0), [&](double) { return draw_real(choices); });
  Handle(TColgp_HArray1OfXYZ) poles = new TColgp_HArray1OfXYZ(0, upper);
  for (int i = 0; i <= upper; ++i) poles->SetValue(i, draw_point(choices));
  const bool natural = !choices.once_in(3);
  const double from = natural ? knots->Value(knots->Lower()) : draw_real(choices);
  const double to = natural ? knots->Value(knots->Upper()) : draw_real(choices);
  Handle(IGESGeom_BSplineCurve) curve = new IGESGeom_BSplineCurve;
  curve->Init(upper, degree, false, false, choices.once_in(2), false, knots, weights, poles, from, to, gp_XYZ(0, 0, 1));
  return curve;
}

Handle(IGESData_IGESEntity) draw_curve(Choices& choices) {
  if (!choices.once_in(16)) return draw_spline(choices);
  Handle(IGESGeom_Line) line = new IGESGeom_Line;
  const gp_XYZ begin = draw_point(choices);
  line->Init(begin, draw_point(choices));
  return line;
}

void check_numbers(const IGESGeom_BSplineCurve& spline, const CadRail& rail) {
  require(rail.degree == spline.Degree(), "the degree of the file");
  require(rail.points.size() == static_cast<std::size_t>(spline.NbPoles()), "as many points as the file has");
  require(rail.weights.size() == rail.points.size(), "a weight for each point");
  for (int i = 0; i <= spline.UpperIndex(); ++i) {
    for (int k = 1; k <= 3; ++k) {
      const double x = rail.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(k - 1)];
      require(std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(spline.Pole(i).Coord(k)),
              "points bit for bit");
    }
  }
}

void check(Choices choices) {
  CadRail rail;
  try {
    const Handle(IGESData_IGESEntity) curve = draw_curve(choices);
    Handle(IGESData_IGESModel) model = new IGESData_IGESModel;
    model->AddEntity(curve);
    rail = cad::IgesCurves(model, {}).rail(curve);
    if (const auto spline = Handle(IGESGeom_BSplineCurve)::DownCast(curve); !spline.IsNull()) {
      check_numbers(*spline, rail);
    }
  } catch (const cad::Unreadable&) {
    return;
  } catch (const Standard_Failure&) {
    return;
  }
  try {
    const CurveFile<Rational> curve = cli::curve_file(rail, cad_identity);
    require(curve.net.points.size() == static_cast<std::size_t>(curve.knots.last()) + 1, "the points fit the knots");
  } catch (const InvalidInput&) {
  }
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check(torse::fuzz::Choices::from_bytes({data, size}));
  return 0;
}
