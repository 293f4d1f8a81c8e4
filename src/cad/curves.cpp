#include "torse/cad/curves.hpp"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <iterator>
#include <vector>

#include "torse/cad/face.hpp"
#include "torse/cad/read.hpp"
#include "torse/cad/strips.hpp"

namespace torse::cad {
namespace {

/// An edge, or those of a wire one after the other. Edges that the explorer does not get to from the first one would be
/// left out without a word.
std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_EDGE) return {TopoDS::Edge(shape)};
  std::vector<TopoDS_Edge> edges;
  for (BRepTools_WireExplorer walk(TopoDS::Wire(shape)); walk.More(); walk.Next()) edges.push_back(walk.Current());
  if (std::ssize(edges) != shape.NbChildren()) throw Unreadable("its parts do not follow each other");
  return edges;
}

/// The curve of an edge and the range of its parameters.
Handle(Geom_Curve) curve_of(const TopoDS_Edge& edge, CadRange& range) {
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  if (curve.IsNull()) throw Unreadable("it has no curve in space");
  return curve;
}

/// Number for number, as far as it is a line or a B-spline.
CadRail rail_of_edge(const TopoDS_Edge& edge) {
  CadRange range{};
  const Handle(Geom_Curve) curve = curve_of(edge, range);
  auto [rail, part] = rail_of(curve, range);
  rail.part = part;
  rail.reversed = edge.Orientation() == TopAbs_REVERSED;
  return rail;
}

CadRail rail_of_chain(const std::vector<TopoDS_Edge>& edges) {
  GeomConvert_CompCurveToBSplineCurve chain;
  for (const TopoDS_Edge& edge : edges) {
    CadRange range{};
    Handle(Geom_Curve) curve = curve_of(edge, range);
    if (edge.Orientation() == TopAbs_REVERSED) {
      const CadRange back{curve->ReversedParameter(range.to), curve->ReversedParameter(range.from)};
      curve = curve->Reversed();
      range = back;
    }
    const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(curve, range.from, range.to);
    const double tolerance = std::max(BRep_Tool::Tolerance(edge), Precision::Confusion());
    if (!chain.Add(part, tolerance, true)) throw Unreadable("its parts do not follow each other");
  }
  const Handle(Geom_BSplineCurve) joined = chain.BSplineCurve();
  if (joined.IsNull()) throw Unreadable("it has no parts");
  return rail_of(joined, {joined->FirstParameter(), joined->LastParameter()}).first;
}

CadRail rail_of_shape(const TopoDS_Shape& shape) {
  const std::vector<TopoDS_Edge> edges = edges_of(shape);
  return edges.size() == 1 ? rail_of_edge(edges.front()) : rail_of_chain(edges);
}

}  // namespace

void add_curves(const TopoDS_Shape& shape, const CurveNames& names, CadCurves& found) {
  const TopAbs_ShapeEnum type = shape.ShapeType();
  if (type == TopAbs_COMPOUND) {
    for (TopoDS_Iterator parts(shape); parts.More(); parts.Next()) add_curves(parts.Value(), names, found);
  }
  if (type != TopAbs_EDGE && type != TopAbs_WIRE) return;
  CadCurve curve{.number = static_cast<int>(found.curves.size()) + 1};
  if (const auto name = names.find(shape.TShape().get()); name != names.end()) curve.name = name->second;
  curve.placement = placement_of(shape.Location().Transformation(), 1);
  try {
    curve.rail = rail_of_shape(shape.Located(TopLoc_Location()));
  } catch (const Unreadable& error) {
    curve.reason = error.what();
  } catch (const Standard_Failure& failure) {
    curve.reason = std::string("OpenCASCADE cannot use it: ") + failure.GetMessageString();
  }
  found.curves.push_back(std::move(curve));
}

}  // namespace torse::cad
