// Pictures against exact arithmetic: sampled rulings against blossoms over Q, warp angles against the exact sine, the
// edge of regression against FJ21.6.1 and against the vertex of a cone.
#include "torse/cli/surface_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "torse/developable/regression.hpp"
#include "torse/developable/warp.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using Q = Rational;
using Point3 = Vec<Q, 3>;

Point3 point(int x, int y, int z) { return Point3(Q(x), Q(y), Q(z)); }

/// A warped cubic with two pieces, its numbers far from the origin.
RuledFile<Q> warped() {
  const KnotList<Q> u(3, {Q(2), Q(2), Q(2), ratio<Q>(7, 3), Q(4), Q(4), Q(4)});
  const std::vector<Q> ones(5, Q(1));
  return {u,
          {{point(100, 0, 0), point(101, 2, 0), point(102, 2, 1), point(103, 0, 1), point(104, 0, 0)}, ones},
          {{point(100, 0, 3), point(101, 3, 4), point(102, 1, 3), point(103, 0, 3), point(104, 1, 5)}, ones}};
}

RuledFile<Q> section8() {
  const proofs::Section8Net<Q> net{proofs::Section8Data<Q>{}};
  return {net.u, dehomogenize<Q, 4>(net.p), dehomogenize<Q, 4>(net.q)};
}

/// The piece on which a parameter lies.
int piece_at(const KnotList<Q>& u, const Q& t) {
  for (const int k : u.proper_pieces()) {
    if (t <= u.piece_end(k)) return k;
  }
  return u.proper_pieces().back();
}

/// A point of a row over Q, by blossoms of homogeneous rows.
Point3 exact_point(const KnotList<Q>& u, const WeightedPoints<Q, 3>& row, const Q& t) {
  const std::vector<Vec<Q, 4>> rows = homogeneous(row);
  return dehomogenize<Q, 4>({curve_point<Q, Vec<Q, 4>>(u, rows, piece_at(u, t), t)}).points.front();
}

Q parameter(const KnotList<Q>& u, std::size_t i, std::size_t count) {
  return u.domain_begin() +
         (u.domain_end() - u.domain_begin()) * ratio<Q>(static_cast<int>(i), static_cast<int>(count) - 1);
}

TEST(UnitFrame, TakesTheBoxIntoTheUnitCube) {
  const std::optional<UnitFrame> frame = unit_frame(warped().c, warped().d);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->size, Q(5));  // z from 0 to 5
  EXPECT_EQ(frame->middle[0], Q(102));
  EXPECT_EQ(frame->middle[1], ratio<Q>(3, 2));
  const WeightedPoints<Q, 3> one{{point(1, 2, 3), point(1, 2, 3)}, {Q(1), Q(1)}};
  EXPECT_FALSE(unit_frame(one, one).has_value());
}

TEST(SurfacePicture, RulingsAreThoseOfTheExactSurface) {
  constexpr std::size_t count = 25;
  for (const RuledFile<Q>& surface : {warped(), section8()}) {
    const UnitFrame frame = *unit_frame(surface.c, surface.d);
    const Json picture = surface_picture("x", surface, Known{}, count);
    const Json& state = picture["states"][0];
    ASSERT_EQ(state["rulings"].size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const Q t = parameter(surface.knots, i, count);
      const Point3 c = exact_point(surface.knots, surface.c, t);
      const Point3 d = exact_point(surface.knots, surface.d, t);
      for (int j = 0; j < 3; ++j) {
        const auto at = static_cast<std::size_t>(j);
        EXPECT_NEAR(state["rulings"][i][at], Q((c[j] - frame.middle[j]) / frame.size).to_double(), 6e-7);
        EXPECT_NEAR(state["rulings"][i][at + 3], Q((d[j] - frame.middle[j]) / frame.size).to_double(), 6e-7);
      }
    }
  }
}

TEST(SurfacePicture, WarpIsThatOfTheExactSine) {
  constexpr std::size_t count = 25;
  const RuledFile<Q> surface = warped();
  const Json picture = surface_picture("x", surface, Known{}, count);
  for (std::size_t i = 0; i < count; ++i) {
    const Q t = parameter(surface.knots, i, count);
    const Q square =
        pointwise_sine_squared<Q>(surface.knots, surface.c.points, surface.d.points, piece_at(surface.knots, t), t);
    const double warp = picture["states"][0]["warp"][i];
    EXPECT_NEAR(std::sin(warp * std::numbers::pi / 180), std::sqrt(square.to_double()), 1e-7) << i;
  }
  EXPECT_FALSE(picture["states"][0].contains("edge"));
}

TEST(SurfacePicture, WhatIsDecidedToBeDevelopableHasNoWarp) {
  const Json picture = surface_picture("x", section8(), known_of(section8(), SurfaceClass::tangent), 25);
  for (const Json& warp : picture["states"][0]["warp"]) EXPECT_EQ(warp, 0);
  EXPECT_TRUE(picture["states"][0].contains("edge"));
  EXPECT_FALSE(known_of(section8(), SurfaceClass::cylinder).edge);
  EXPECT_FALSE(known_of(warped(), SurfaceClass::none).developable);
}

TEST(SurfacePicture, EdgeIsThatOfFJ21) {
  // v of homogeneous rows is 3/2 t + 3 there; of points it is v omega / ((1-v) w + v omega).
  constexpr std::size_t count = 11;
  const RuledFile<Q> surface = section8();
  const Json picture = surface_picture("x", surface, Known{.edge = true}, count);
  const std::vector<Vec<Q, 4>> p = homogeneous(surface.c);
  const std::vector<Vec<Q, 4>> q = homogeneous(surface.d);
  for (std::size_t i = 0; i < count; ++i) {
    const Q t = parameter(surface.knots, i, count);
    const Q v = ratio<Q>(3, 2) * t + Q(3);
    const Q w = curve_point<Q, Vec<Q, 4>>(surface.knots, p, 1, t)[0];
    const Q omega = curve_point<Q, Vec<Q, 4>>(surface.knots, q, 1, t)[0];
    EXPECT_NEAR(picture["states"][0]["edge"][i], standard_parameter(v, w, omega).to_double(), 1e-6);
  }
}

TEST(SurfacePicture, EdgeOfAConeIsItsVertex) {
  // d = 2 c with the vertex at the origin, which is v = -1 on every ruling.
  const std::vector<Q> ones(3, Q(1));
  const RuledFile<Q> cone{bezier_knots<Q>(2),
                          {{point(1, 0, 1), point(1, 1, 1), point(0, 1, 2)}, ones},
                          {{point(2, 0, 2), point(2, 2, 2), point(0, 2, 4)}, ones}};
  const Json picture = surface_picture("x", cone, Known{.edge = true}, 9);
  for (const Json& v : picture["states"][0]["edge"]) EXPECT_NEAR(v, -1, 1e-6);
}

TEST(SurfacePicture, ACylinderHasNoEdge) {
  const std::vector<Q> ones(2, Q(1));
  const RuledFile<Q> plane{
      bezier_knots<Q>(1), {{point(0, 0, 0), point(1, 0, 0)}, ones}, {{point(0, 1, 0), point(1, 1, 0)}, ones}};
  const Json picture = surface_picture("x", plane, Known{.edge = true}, 3);
  for (const Json& v : picture["states"][0]["edge"]) EXPECT_TRUE(v.is_null());
}

TEST(SurfacePicture, NumbersOfAnySizeAreDrawn) {
  const RuledFile<Q> surface = warped();
  const Json usual = surface_picture("x", surface, Known{}, 9);
  Q huge(1);
  for (int i = 0; i < 400; ++i) huge *= Q(10);
  for (const Q& factor : {huge, Q(Q(1) / huge), Q(-7)}) {
    RuledFile<Q> other = surface;
    for (auto* row : {&other.c, &other.d}) {
      for (Point3& x : row->points) {
        for (int j = 0; j < 3; ++j) x[j] = factor * x[j];
      }
    }
    const Json picture = surface_picture("x", other, Known{}, 9);
    EXPECT_EQ(picture["states"][0]["warp"], usual["states"][0]["warp"]);
  }
}

TEST(SurfacePicture, RulingsAtInfinityAreLeftOut) {
  RuledFile<Q> surface = warped();
  surface.c.weights = {Q(1), Q(-3), Q(-3), Q(-3), Q(1)};
  const Json picture = surface_picture("x", surface, Known{}, 101);
  std::size_t gaps = 0;
  for (const Json& ruling : picture["states"][0]["rulings"]) gaps += ruling.is_null() ? 1U : 0U;
  EXPECT_GT(gaps, 0U);
  EXPECT_LT(gaps, 101U);
}

TEST(SurfacePicture, OnePointIsNotDrawn) {
  const WeightedPoints<Q, 3> one{{point(1, 2, 3), point(1, 2, 3)}, {Q(1), Q(1)}};
  EXPECT_TRUE(surface_picture("x", {bezier_knots<Q>(1), one, one}, Known{}, 9).is_null());
}

TEST(SurfacePicture, SingularPlacesAreSharesOfTheDomain) {
  // From 2 to 6, singular from 3 to 4.
  const std::vector<Q> ones(2, Q(1));
  const RuledFile<Q> surface{
      KnotList<Q>(1, {Q(2), Q(6)}), {{point(0, 0, 0), point(1, 0, 0)}, ones}, {{point(0, 1, 0), point(1, 1, 0)}, ones}};
  SingularSet set{Singularity::edge, {}, {}};
  set.from.root = {Q(3), Q(3)};
  set.to.root = {Q(4), Q(4)};
  const Json picture = surface_picture("x", surface, {.singular = std::vector<SingularSet>{set}}, 9);
  EXPECT_EQ(picture["singular"][0], (Json{{"reason", "edge"}, {"from", 0.25}, {"to", 0.5}}));
}

}  // namespace
}  // namespace torse::cli
