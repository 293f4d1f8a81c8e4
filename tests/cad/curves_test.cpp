// Edges and wires of OpenCASCADE as curves: chains with parts that run backwards, chains that are broken, edges that
// cannot be used.
#include "torse/cad/curves.hpp"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Trsf.hxx>

#include <vector>

#include "torse/cli/cad_surface.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::testing {
namespace {

using Q = Rational;
using Places = std::vector<gp_Pnt>;

CadCurves curves_of(const TopoDS_Shape& shape, const cad::CurveNames& names = {}) {
  CadCurves found;
  cad::add_curves(shape, names, found);
  return found;
}

/// The one curve of a shape.
CadCurve curve_of(const TopoDS_Shape& shape) {
  const CadCurves found = curves_of(shape);
  EXPECT_EQ(found.curves.size(), 1U);
  return found.curves.empty() ? CadCurve() : found.curves.front();
}

/// A Bezier curve of degree 1 or 2 as an edge.
TopoDS_Edge edge(const Places& places) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) poles(static_cast<int>(i) + 1) = places[i];
  return BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles));
}

TopoDS_Edge backwards(const Places& places) {
  return TopoDS::Edge(edge(Places(places.rbegin(), places.rend())).Reversed());
}

/// Edges that need not be connected.
TopoDS_Wire chain(const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& part : edges) builder.Add(wire, part);
  return wire;
}

TopoDS_Wire connected(const std::vector<TopoDS_Edge>& edges) {
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Edge& part : edges) wire.Add(part);
  return wire;
}

const Places line{{0, 0, 0}, {2, 0, 0}};
const Places arc{{2, 0, 0}, {4, 0, 0}, {4, 3, 0}};
const Places up{{4, 3, 0}, {4, 3, 5}};

gp_Pnt place(const CurveFile<Q>& curve, const Q& t) {
  const Vec<Q, 4> x = curve_point<Q, Vec<Q, 4>>(curve.knots, homogeneous(curve.net), piece_at(curve.knots, t), t);
  return {(x[1] / x[0]).to_double(), (x[2] / x[0]).to_double(), (x[3] / x[0]).to_double()};
}

/// The joints of the pieces, in order.
Places joints(const CadRail& rail) {
  const CurveFile<Q> curve = cli::curve_file(rail, cad_identity);
  Places found{place(curve, curve.knots.domain_begin())};
  for (const int k : curve.knots.proper_pieces()) found.push_back(place(curve, curve.knots.piece_end(k)));
  return found;
}

void expect_joints(const CadCurve& curve, const Places& expected) {
  ASSERT_TRUE(curve.rail) << curve.reason;
  const Places found = joints(*curve.rail);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(found[i].Distance(expected[i]), 1e-12) << i;
}

TEST(CadCurves, AChainIsOneCurveWhicheverWayItsPartsRun) {
  const Places corners{line.front(), line.back(), arc.back(), up.back()};
  expect_joints(curve_of(connected({edge(line), edge(arc), edge(up)})), corners);
  expect_joints(curve_of(connected({edge(line), backwards(arc), edge(up)})), corners);
  expect_joints(curve_of(connected({backwards(line), edge(arc), backwards(up)})), corners);
}

/// Half a circle, whose parameters run to pi, as a part that runs backwards: from pi to 2 pi on the reversed circle.
TEST(CadCurves, ReversedArcsKeepTheirRange) {
  const Handle(Geom_TrimmedCurve) half = GC_MakeArcOfCircle(gp_Pnt(4, 0, 0), gp_Pnt(3, 1, 0), gp_Pnt(2, 0, 0));
  const TopoDS_Edge turned = TopoDS::Edge(TopoDS_Edge(BRepBuilderAPI_MakeEdge(half)).Reversed());
  const CadCurve curve = curve_of(connected({edge(line), turned}));
  ASSERT_TRUE(curve.rail) << curve.reason;
  const Places found = joints(*curve.rail);
  EXPECT_LT(found.front().Distance({0, 0, 0}), 1e-12);
  EXPECT_LT(found.back().Distance({4, 0, 0}), 1e-12);
  EXPECT_LT(found[1].Distance({2, 0, 0}), 1e-12);
}

/// The first quarter of a parabola, from (2, 0, 0) to (23/8, 3/16, 0), as a part that runs backwards.
TEST(CadCurves, ReversedPartsOfSplinesKeepTheirRange) {
  const gp_Pnt joint(2.875, 0.1875, 0);
  TColgp_Array1OfPnt poles(1, 3);
  for (std::size_t i = 0; i < 3; ++i) poles(static_cast<int>(i) + 1) = arc[i];
  const TopoDS_Edge quarter = BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), 0, 0.25);
  const Places down{{2.875, 4, 0}, joint};
  expect_joints(curve_of(connected({edge(down), TopoDS::Edge(quarter.Reversed())})),
                {down.front(), joint, arc.front()});
}

/// One edge is number for number what it was, and says that it runs backwards.
TEST(CadCurves, AReversedEdgeIsReversed) {
  EXPECT_FALSE(curve_of(edge(arc)).rail.value().reversed);
  const CadRail rail = curve_of(edge(arc).Reversed()).rail.value();
  EXPECT_TRUE(rail.reversed);
  EXPECT_EQ(rail.points[1], (CadPoint{4, 0, 0}));
  const CadRail alone = curve_of(chain({TopoDS::Edge(edge(arc).Reversed())})).rail.value();
  EXPECT_TRUE(alone.reversed);
}

/// Nothing is left out without a word: the explorer of wires stops before a part that does not follow.
TEST(CadCurves, BrokenChainsAreNone) {
  const BRep_Builder builder;
  for (const Places& beyond : {Places{{9, 9, 9}, {8, 8, 8}}, Places{{4.5, 3, 0}, {4.5, 3, 5}}, up}) {
    TopoDS_Wire wire = connected({edge(line), edge(arc)});
    builder.Add(wire, edge(beyond));  // without a vertex of the chain, be it at its end
    const CadCurve curve = curve_of(wire);
    EXPECT_FALSE(curve.rail);
    EXPECT_EQ(curve.reason, "its parts do not follow each other");
  }
}

TEST(CadCurves, WhatHasNoCurveIsToldWhy) {
  const BRep_Builder builder;
  TopoDS_Edge bare;
  builder.MakeEdge(bare);
  EXPECT_EQ(curve_of(bare).reason, "it has no curve in space");
  EXPECT_EQ(curve_of(chain({})).reason, "it has no parts");
  // A part with a range that its curve does not have.
  const TopoDS_Wire wire = connected({edge(line), edge(arc)});
  TopoDS_Iterator last(wire);
  last.Next();
  builder.Range(TopoDS::Edge(last.Value()), -1, 2);
  const CadCurve curve = curve_of(wire);
  EXPECT_FALSE(curve.rail);
  EXPECT_EQ(curve.reason.rfind("OpenCASCADE cannot use it: ", 0), 0U) << curve.reason;
}

/// In the order of the shapes, under their own names and where they stand; points and shells are no curves.
TEST(CadCurves, OfACompoundAreNumbered) {
  const BRep_Builder builder;
  TopoDS_Compound inner, outer;
  builder.MakeCompound(inner);
  builder.MakeCompound(outer);
  TopoDS_Vertex vertex;
  builder.MakeVertex(vertex, gp_Pnt(1, 1, 1), 1e-7);
  const TopoDS_Edge first = edge(line);
  const TopoDS_Wire second = connected({edge(line), edge(arc)});
  gp_Trsf moved;
  moved.SetTranslation(gp_Vec(0, 0, 7));
  builder.Add(inner, second.Moved(TopLoc_Location(moved)));
  builder.Add(outer, vertex);
  builder.Add(outer, first);
  builder.Add(outer, inner);
  const CadCurves found = curves_of(outer, {{first.TShape().get(), "keel"}});
  ASSERT_EQ(found.curves.size(), 2U);
  EXPECT_EQ(found.curves[0].number, 1);
  EXPECT_EQ(found.curves[0].name, "keel");
  EXPECT_EQ(found.curves[0].placement, cad_identity);
  EXPECT_EQ(found.curves[1].number, 2);
  EXPECT_EQ(found.curves[1].name, "");
  EXPECT_EQ(found.curves[1].placement[2][3], 7);
  expect_joints(found.curves[1], {line.front(), line.back(), arc.back()});
}

}  // namespace
}  // namespace torse::testing
