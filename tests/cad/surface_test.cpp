// Surfaces of OpenCASCADE as strips: every strip passes through the points that OpenCASCADE computes, also for kinds
// that no reader makes today.
//   face_of          what a surface becomes
//   expect_strip     a strip against the surface over a box
#include <gtest/gtest.h>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <cmath>
#include <numbers>

#include "torse/algebra/determinant.hpp"
#include "torse/cad/read.hpp"
#include "torse/cad/strips.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::testing {
namespace {

using cad::Box;
using Q = Rational;
using Places = std::vector<gp_Pnt>;

CadFace face_of(const Handle(Geom_Surface) & surface, const std::optional<Box>& box = std::nullopt) {
  CadFace face;
  cad::add_surface(surface, box, face);
  return face;
}

gp_Pnt place(const WeightedPoints<Q, 3>& net, const KnotList<Q>& knots, double share) {
  const Q t = knots.domain_begin() + Q::from_double(share) * (knots.domain_end() - knots.domain_begin());
  const Vec<Q, 4> x = curve_point<Q, Vec<Q, 4>>(knots, homogeneous(net), piece_at(knots, t), t);
  return {(x[1] / x[0]).to_double(), (x[2] / x[0]).to_double(), (x[3] / x[0]).to_double()};
}

/// The strip's rails at the begin, the middle and the end are these points.
void expect_strip(const CadStrip& strip, const Places& c, const Places& d) {
  const RuledFile<Q> made = cli::surface_of(strip, cad_identity);
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = static_cast<double>(i) / 2;
    EXPECT_LT(place(made.c, made.knots, share).Distance(c[i]), 1e-12) << "c at " << share;
    EXPECT_LT(place(made.d, made.knots, share).Distance(d[i]), 1e-12) << "d at " << share;
  }
}

/// The points of a surface on a line u = `fixed`, or v = `fixed`, at the ends of a range and between.
Places on(const Handle(Geom_Surface) & surface, CadRange u, double v) {
  return {surface->Value(u.from, v), surface->Value((u.from + u.to) / 2, v), surface->Value(u.to, v)};
}
Places on(const Handle(Geom_Surface) & surface, double u, CadRange v) {
  return {surface->Value(u, v.from), surface->Value(u, (v.from + v.to) / 2), surface->Value(u, v.to)};
}

/// One strip with rulings along v over the box.
void expect_ruled_along_v(const Handle(Geom_Surface) & surface, const Box& box) {
  const CadFace face = face_of(surface, box);
  ASSERT_EQ(face.strips.size(), 1U) << face.reason;
  expect_strip(face.strips.front(), on(surface, box.u, box.v.from), on(surface, box.u, box.v.to));
}

/// A frame whose axes are no coordinate axes.
gp_Ax3 slanted() { return {gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2), gp_Dir(2, -2, 1)}; }

gp_Ax3 left_handed() {
  gp_Ax3 frame = slanted();
  frame.YReverse();
  return frame;
}

Handle(Geom_BSplineCurve) spline(const Places& places, const std::vector<double>& knots,
                                 const std::vector<int>& multiplicities, int degree, bool periodic = false) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) poles.SetValue(static_cast<int>(i) + 1, places[i]);
  TColStd_Array1OfReal values(1, static_cast<int>(knots.size()));
  TColStd_Array1OfInteger counts(1, static_cast<int>(knots.size()));
  for (std::size_t i = 0; i < knots.size(); ++i) {
    values.SetValue(static_cast<int>(i) + 1, knots[i]);
    counts.SetValue(static_cast<int>(i) + 1, multiplicities[i]);
  }
  return new Geom_BSplineCurve(poles, values, counts, degree, periodic);
}

Handle(Geom_BezierCurve) bezier(const Places& places) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) poles.SetValue(static_cast<int>(i) + 1, places[i]);
  return new Geom_BezierCurve(poles);
}

Handle(Geom_SurfaceOfRevolution) turned(const Handle(Geom_Curve) & meridian) {
  return new Geom_SurfaceOfRevolution(meridian, gp_Ax1(gp_Pnt(1, 0, 0), gp_Dir(0, 0, 1)));
}

TEST(CadSurfaces, APlaneIsThePartOfTheBox) {
  const CadFace face = face_of(new Geom_Plane(slanted()), Box{{2, 5}, {-1, 4}});
  EXPECT_EQ(face.type, "plane");
  expect_ruled_along_v(new Geom_Plane(slanted()), {{2, 5}, {-1, 4}});
  expect_ruled_along_v(new Geom_Plane(left_handed()), {{2, 5}, {-1, 4}});
}

TEST(CadSurfaces, CylindersTurnTheWayOfTheirFrame) {
  const Box box{{0.5, 2}, {-1, 4}};
  const Handle(Geom_Surface) right = new Geom_CylindricalSurface(slanted(), 3);
  EXPECT_EQ(face_of(right, box).type, "cylinder");
  expect_ruled_along_v(right, box);
  const Handle(Geom_Surface) left = new Geom_CylindricalSurface(left_handed(), 3);
  const CadFace face = face_of(left, box);
  ASSERT_EQ(face.strips.size(), 1U);
  expect_strip(face.strips.front(), on(left, {2, 0.5}, -1), on(left, {2, 0.5}, 4));
}

TEST(CadSurfaces, ConesOfEitherSlopeTurnAboutTheirAxis) {
  for (const double slope : {0.4, -0.4}) {
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(slanted(), slope, 2);
    EXPECT_EQ(face_of(cone, Box{{0, 1}, {0, 1}}).type, "cone");
    expect_ruled_along_v(cone, {{0.5, 5}, {-1, 3}});
  }
}

/// The vertex is at v = -radius / sin(angle); an end is put there from nearer than the resolution of v.
TEST(CadSurfaces, AnEndNearAConesVertexIsTheVertex) {
  for (const double angle : {0.4, -0.4}) {
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(slanted(), angle, 2);
    const double vertex = -2 / std::sin(angle);
    const auto radius = [&](double distance) {
      const CadFace face = face_of(cone, Box{{0, 1}, {vertex + distance, vertex + 7}, 0, 1e-3});
      return std::get<CadRevolution>(face.strips.at(0).surface).meridian[0].radius;
    };
    EXPECT_EQ(radius(0), 0);
    EXPECT_EQ(radius(0.9e-3), 0);
    EXPECT_EQ(radius(-0.9e-3), 0);
    EXPECT_NEAR(radius(1.1e-3), 1.1e-3 * std::sin(angle), 1e-12);
    EXPECT_NEAR(radius(-1.1e-3), -1.1e-3 * std::sin(angle), 1e-12);
  }
}

TEST(CadSurfaces, ExtrusionsOfEveryKindOfCurve) {
  const gp_Dir up(2, 3, 6);
  const Box box{{0.25, 0.75}, {-1, 4}};
  const auto extruded = [&](const Handle(Geom_Curve) & curve) {
    return Handle(Geom_Surface)(new Geom_SurfaceOfLinearExtrusion(curve, up));
  };
  const Places bow{{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, 0, 0}};
  EXPECT_EQ(face_of(extruded(bezier(bow)), box).type, "extrusion");
  expect_ruled_along_v(extruded(bezier(bow)), box);
  expect_ruled_along_v(extruded(bezier(bow)), {{0, 1}, {-1, 4}});
  expect_ruled_along_v(extruded(new Geom_Line(gp_Pnt(1, 1, 0), gp_Dir(1, 0, 0))), box);
  expect_ruled_along_v(extruded(spline(bow, {0, 0.5, 1}, {3, 1, 3}, 2)), box);
  expect_ruled_along_v(extruded(new Geom_TrimmedCurve(new Geom_Circle(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1)), 2), 0, 3)),
                       box);
  expect_ruled_along_v(extruded(new Geom_Circle(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1)), 2)), {{3, 6}, {0, 1}});
}

TEST(CadSurfaces, ExtrusionsOfClosedCurvesGoOnOverTheSeam) {
  const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1)), 2);
  const Handle(Geom_Curve) loop =
      spline({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {0, 1, 2, 3, 4}, {1, 1, 1, 1, 1}, 2, true);
  for (const Handle(Geom_Curve) & curve : {circle, loop}) {
    const Handle(Geom_Surface) tube = new Geom_SurfaceOfLinearExtrusion(curve, gp_Dir(0, 0, 1));
    for (const CadRange& range : {CadRange{3, 6}, {-1, 1}, {3, 7}, {7, 9}}) expect_ruled_along_v(tube, {range, {0, 1}});
  }
  // Rounded ends of a whole turn are the whole turn.
  const Handle(Geom_Surface) tube = new Geom_SurfaceOfLinearExtrusion(loop, gp_Dir(0, 0, 1));
  for (const double off : {-1e-9, 1e-9}) {
    const CadFace face = face_of(tube, Box{{off, 4 + off}, {0, 1}, 1e-7, 1e-7});
    EXPECT_FALSE(face.strips.at(0).along);
    expect_strip(face.strips[0], on(tube, {0, 4}, 0), on(tube, {0, 4}, 1));
  }
}

/// Quadratic with uniform knots: at a knot it is midway between two of its control points.
TEST(CadSurfaces, APeriodicCurveIsExtrudedOnce) {
  const Places square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Handle(Geom_BSplineCurve) loop = spline(square, {0, 1, 2, 3, 4}, {1, 1, 1, 1, 1}, 2, true);
  const Handle(Geom_SurfaceOfLinearExtrusion) tube = new Geom_SurfaceOfLinearExtrusion(loop, gp_Dir(0, 0, 1));
  expect_ruled_along_v(tube, {{0, 4}, {-1, 4}});
  const RuledFile<Q> made = cli::surface_of(face_of(tube, Box{{0, 4}, {0, 1}}).strips.at(0), cad_identity);
  EXPECT_TRUE(tube->BasisCurve()->IsPeriodic()) << "the file's own curve is left alone";
  std::vector<std::array<double, 2>> corners;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const gp_Pnt x = place(made.c, made.knots, share);
    corners.push_back({x.X(), x.Y()});
  }
  const gp_Pnt first = loop->Value(0);
  ASSERT_TRUE(std::abs(first.X() - 1) + std::abs(first.Y() - 1) == 1) << "the middle of a side";
  for (std::size_t i = 0; i < 4; ++i) {  // a quarter of the loop further is a quarter of a turn about (1, 1)
    EXPECT_NEAR(corners[i + 1][0] - 1, 1 - corners[i][1], 1e-15);
    EXPECT_NEAR(corners[i + 1][1] - 1, corners[i][0] - 1, 1e-15);
  }
}

TEST(CadSurfaces, ABoxWithoutEndsIsOneOfLengthTwoAboutTheOrigin) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(slanted(), 3);
  const CadFace face = face_of(cylinder);
  ASSERT_EQ(face.strips.size(), 1U);
  const double turn = 2 * std::numbers::pi;
  expect_strip(face.strips[0], on(cylinder, {0, turn}, -1), on(cylinder, {0, turn}, 1));
  const auto ends = [](CadRange range) {
    const CadRange drawn = cad::finite(range);
    return std::vector<double>{drawn.from, drawn.to};
  };
  EXPECT_EQ(ends({-2e100, 2e100}), (std::vector<double>{-1, 1}));
  EXPECT_EQ(ends({-2e100, 5}), (std::vector<double>{4, 5}));
  EXPECT_EQ(ends({5, 2e100}), (std::vector<double>{5, 6}));
  EXPECT_EQ(ends({5, 7}), (std::vector<double>{5, 7}));
}

TEST(CadSurfaces, StraightLinesTurn) {
  const Handle(Geom_Line) line = new Geom_Line(gp_Pnt(4, 0, 0), gp_Dir(1, 2, 2));
  const Box box{{0.5, 2}, {-1, 4}};
  EXPECT_EQ(face_of(turned(line), box).type, "revolution");
  expect_ruled_along_v(turned(line), box);
  // The narrower of two trims and the box counts, and u turns by the box.
  const Handle(Geom_Curve) trimmed = new Geom_TrimmedCurve(line, 1, 3);
  const CadFace face = face_of(turned(trimmed), Box{{0.5, 2}, {-1, 4}});
  ASSERT_EQ(face.strips.size(), 1U);
  expect_strip(face.strips[0], on(turned(line), {0.5, 2}, 1), on(turned(line), {0.5, 2}, 3));
  expect_ruled_along_v(turned(trimmed), {{0.5, 2}, {1.5, 2.5}});
  const CadFace whole = face_of(turned(line), Box{{0.5, 2}, {-2e100, 2e100}});
  expect_strip(whole.strips.at(0), on(turned(line), {0.5, 2}, -1), on(turned(line), {0.5, 2}, 1));
}

TEST(CadSurfaces, PolygonsTurnSideBySide) {
  const Places corners{{3, 0, 0}, {4, 0, 1}, {4, 0, 1}, {2, 0, 5}};
  const Handle(Geom_Surface) lathe = turned(spline(corners, {0, 1, 2, 5}, {2, 1, 1, 2}, 1));
  const CadFace face = face_of(lathe, Box{{0.5, 2}, {0, 5}});
  EXPECT_EQ(face.remark, "the whole meridian");
  EXPECT_EQ(face.reason, "");
  ASSERT_EQ(face.strips.size(), 2U);
  expect_strip(face.strips[0], on(lathe, {0.5, 2}, 0), on(lathe, {0.5, 2}, 1));
  expect_strip(face.strips[1], on(lathe, {0.5, 2}, 2), on(lathe, {0.5, 2}, 5));
  const Handle(Geom_Surface) funnel = turned(bezier({{3, 0, 0}, {4, 0, 1}}));
  const CadFace side = face_of(funnel, Box{{0.5, 2}, {0, 1}});
  ASSERT_EQ(side.strips.size(), 1U);
  expect_strip(side.strips[0], on(funnel, {0.5, 2}, 0), on(funnel, {0.5, 2}, 1));
}

TEST(CadSurfaces, MeridiansThatAreNoPolygon) {
  const Box box{{0, 1}, {0, 1}};
  for (const Handle(Geom_Curve) & curve :
       {Handle(Geom_Curve)(bezier({{3, 0, 0}, {4, 0, 1}, {3, 0, 2}})),
        Handle(Geom_Curve)(spline({{3, 0, 0}, {4, 0, 1}, {3, 0, 2}}, {0, 1}, {3, 3}, 2))}) {
    const CadFace face = face_of(turned(curve), box);
    EXPECT_TRUE(face.strips.empty());
    EXPECT_EQ(face.reason, "its meridian is curved");
  }
  const CadFace spot = face_of(turned(spline({{3, 0, 0}, {3, 0, 0}}, {0, 1}, {2, 2}, 1)), box);
  EXPECT_TRUE(spot.strips.empty());
  EXPECT_EQ(spot.reason, "its meridian is a point");
}

/// A net of 3 x 2 control points, quadratic along u.
Handle(Geom_BezierSurface) arch(const std::vector<double>& weights) {
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  TColStd_Array2OfReal list(1, 3, 1, 2);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 2; ++j) {
      poles.SetValue(i, j, gp_Pnt(i, i == 2 ? 3 + j : 0, 5 * j));
      list.SetValue(i, j, weights[static_cast<std::size_t>(2 * (i - 1) + j - 1)]);
    }
  }
  return new Geom_BezierSurface(poles, list);
}

TEST(CadSurfaces, BezierSurfacesKeepPointsAndWeights) {
  const Handle(Geom_BezierSurface) given = arch({1, 0.5, 2, 3, 0.25, 1});
  const CadFace face = face_of(given);
  EXPECT_EQ(face.type, "B-spline surface");
  EXPECT_FALSE(face.trimmed);
  ASSERT_EQ(face.strips.size(), 1U);
  const auto& rails = std::get<CadRails>(face.strips[0].surface);
  EXPECT_EQ(rails.c.degree, 2);
  EXPECT_EQ(rails.c.knots, (std::vector<double>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(rails.c.points, (std::vector<CadPoint>{{1, 0, 5}, {2, 4, 5}, {3, 0, 5}}));
  EXPECT_EQ(rails.d.points, (std::vector<CadPoint>{{1, 0, 10}, {2, 5, 10}, {3, 0, 10}}));
  EXPECT_EQ(rails.c.weights, (std::vector<double>{1, 2, 0.25}));
  EXPECT_EQ(rails.d.weights, (std::vector<double>{0.5, 3, 1}));
}

TEST(CadSurfaces, WeightsThatChangeInOneDirectionAreKept) {
  const CadFace along_u = face_of(arch({1, 1, 2, 2, 1, 1}));
  EXPECT_EQ(std::get<CadRails>(along_u.strips.at(0).surface).c.weights, (std::vector<double>{1, 2, 1}));
  EXPECT_EQ(std::get<CadRails>(along_u.strips.at(0).surface).d.weights, (std::vector<double>{1, 2, 1}));
  const CadFace along_v = face_of(arch({1, 3, 1, 3, 1, 3}));
  EXPECT_EQ(std::get<CadRails>(along_v.strips.at(0).surface).c.weights, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(std::get<CadRails>(along_v.strips.at(0).surface).d.weights, (std::vector<double>{3, 3, 3}));
}

TEST(CadSurfaces, ATrimmedSurfaceIsThePartOfIt) {
  const Handle(Geom_Surface) whole = arch({1, 1, 1, 1, 1, 1});
  const Handle(Geom_Surface) once = new Geom_RectangularTrimmedSurface(whole, 0.25, 1., 0., 1.);
  const Handle(Geom_Surface) twice = new Geom_RectangularTrimmedSurface(once, 0.25, 0.75, 0.25, 0.5);
  const CadFace face = face_of(twice);
  EXPECT_EQ(face.type, "B-spline surface");
  EXPECT_TRUE(face.trimmed);
  ASSERT_EQ(face.strips.size(), 1U);
  expect_strip(face.strips[0], on(whole, {0.25, 0.75}, 0.25), on(whole, {0.25, 0.75}, 0.5));
}

TEST(CadSurfaces, TrimmedAtOneEndOnly) {
  const Handle(Geom_Surface) whole = arch({1, 1, 1, 1, 1, 1});
  const CadRange all{0, 1};
  for (const CadRange part : {CadRange{0.25, 1}, CadRange{0, 0.75}}) {
    for (const bool along_u : {true, false}) {
      const CadRange u = along_u ? part : all;
      const CadRange v = along_u ? all : part;
      const CadFace face = face_of(whole, Box{u, v});
      EXPECT_TRUE(face.trimmed);
      ASSERT_EQ(face.strips.size(), 1U);
      expect_strip(face.strips[0], on(whole, u, v.from), on(whole, u, v.to));
    }
  }
  EXPECT_FALSE(face_of(whole, Box{all, all}).trimmed);
}

/// A tube around z and one around x: closed along u, or along v, where the other direction has degree 1.
TEST(CadSurfaces, PeriodicSurfacesAreOpened) {
  for (const bool along_u : {true, false}) {
    TColgp_Array2OfPnt poles(1, along_u ? 4 : 2, 1, along_u ? 2 : 4);
    const Places square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (int i = 1; i <= 4; ++i) {
      for (int j = 1; j <= 2; ++j) {
        const gp_Pnt x = square[static_cast<std::size_t>(i - 1)].Translated(gp_Vec(j, 0, 3 * j));
        along_u ? poles.SetValue(i, j, x) : poles.SetValue(j, i, x);
      }
    }
    TColStd_Array1OfReal closed(1, 5);
    TColStd_Array1OfInteger single(1, 5);
    for (int i = 1; i <= 5; ++i) {
      closed.SetValue(i, i);
      single.SetValue(i, 1);
    }
    TColStd_Array1OfReal open(1, 2);
    TColStd_Array1OfInteger twice(1, 2);
    for (int i = 1; i <= 2; ++i) {
      open.SetValue(i, i);
      twice.SetValue(i, 2);
    }
    const Handle(Geom_BSplineSurface) tube =
        along_u ? new Geom_BSplineSurface(poles, closed, open, single, twice, 2, 1, true, false)
                : new Geom_BSplineSurface(poles, open, closed, twice, single, 1, 2, false, true);
    const CadFace face = face_of(tube);
    EXPECT_TRUE(along_u ? tube->IsUPeriodic() : tube->IsVPeriodic()) << "the file's own surface is left alone";
    EXPECT_FALSE(face.trimmed);
    ASSERT_EQ(face.strips.size(), 1U);
    const CadRange turn{1, 5};
    if (along_u) expect_strip(face.strips[0], on(tube, turn, 1), on(tube, turn, 2));
    if (!along_u) expect_strip(face.strips[0], on(tube, 1, turn), on(tube, 2, turn));
  }
}

TEST(CadSurfaces, OthersHaveANameAndAReason) {
  const std::vector<std::pair<std::string, Handle(Geom_Surface)>> others{
      {"sphere", new Geom_SphericalSurface(slanted(), 2)},
      {"torus", new Geom_ToroidalSurface(slanted(), 5, 2)},
      {"offset surface", new Geom_OffsetSurface(arch({1, 1, 1, 1, 1, 1}), 0.5)}};
  for (const auto& [name, surface] : others) {
    const CadFace face = face_of(surface);
    EXPECT_EQ(face.type, name);
    EXPECT_TRUE(face.strips.empty());
    EXPECT_EQ(face.reason, "no straight lines sweep it");
  }
  CadFace named{.type = "as the file says"};
  cad::add_surface(others[0].second, std::nullopt, named);
  EXPECT_EQ(named.type, "as the file says");
  EXPECT_THROW(face_of({}), cad::Unreadable);
}

}  // namespace
}  // namespace torse::testing
