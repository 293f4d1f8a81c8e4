// What is told of a repair, from nets made by hand: every member of the JSON, the sentence.
#include "torse/cli/repair.hpp"

#include <gtest/gtest.h>

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using Q = Rational;

RepairedSurface repaired(NetFamily family, std::vector<repair::RelationConstants> constants) {
  RepairedSurface result{"out.json", {}, {SurfaceClass::tangent}};
  result.net.family = family;
  result.net.constants = std::move(constants);
  result.net.distance = {.largest = 0.5,
                         .root_mean_square = 0.25,
                         .relative = 0.125,
                         .weights = 0.0625,
                         .ulps = 12,
                         .ulps_of_largest = 3,
                         .surfaces = 0.75};
  result.net.families = {{family, 4, 0.25, true}, {NetFamily::edge, 5, 0.375, false}};
  return result;
}

const repair::RelationConstants one{Q(0), Q(1), ratio<Q>(-4, 3), Q(-2), Q(1)};
const repair::RelationConstants other{Q(1), Q(3), Q(5), Q(7), ratio<Q>(2, 3)};

TEST(RepairReport, EveryMemberOfTheJson) {
  EXPECT_EQ(repair_json(repaired(NetFamily::constant, {one})), Json::parse(R"({"file": "out.json", "class": "tangent",
    "family": "constant", "Lambda": "-4/3", "M": "-2", "sigma": "1", "max_distance": 0.5, "rms_distance": 0.25,
    "relative": 0.125, "surface_distance": 0.75, "max_weight_change": 0.0625, "ulps": 12.0, "ulps_of_largest": 3.0,
    "families": [{"family": "constant", "rms_distance": 0.25, "converged": true},
                 {"family": "edge", "degree": 5, "rms_distance": 0.375, "converged": false}]})"));
}

TEST(RepairReport, ConstantsOfSegments) {
  const Json json = repair_json(repaired(NetFamily::segments, {one, other}));
  EXPECT_TRUE(json["Lambda"].is_null());
  EXPECT_TRUE(json["M"].is_null());
  EXPECT_TRUE(json["sigma"].is_null());
  EXPECT_EQ(json["segments"], Json::parse(R"([{"from": "0", "to": "1", "Lambda": "-4/3", "M": "-2", "sigma": "1"},
                            {"from": "1", "to": "3", "Lambda": "5", "M": "7", "sigma": "2/3"}])"));
}

TEST(RepairReport, ClassesWithTheirPointOrDirection) {
  RepairedSurface cylinder = repaired(NetFamily::cylinder, {});
  cylinder.classification = {SurfaceClass::cylinder, std::nullopt, Vec<Q, 3>(Q(1), Q(2), Q(3))};
  EXPECT_EQ(repair_json(cylinder)["direction"], Json::parse(R"(["1", "2", "3"])"));
  EXPECT_FALSE(repair_json(cylinder).contains("vertex"));
  RepairedSurface cone = repaired(NetFamily::cone, {});
  cone.classification = {SurfaceClass::cone, Vec<Q, 3>(Q(4), Q(5), Q(6)), std::nullopt};
  EXPECT_EQ(repair_json(cone)["vertex"], Json::parse(R"(["4", "5", "6"])"));
  EXPECT_FALSE(repair_json(cone).contains("direction"));
  cone.net.distance.surfaces = cone.net.distance.ulps = std::nullopt;
  EXPECT_TRUE(repair_json(cone)["ulps"].is_null());
  EXPECT_TRUE(repair_json(cone)["surface_distance"].is_null());
  cone.net.family = NetFamily::edge;
  cone.net.degree = 4;
  EXPECT_EQ(repair_json(cone)["degree"], 4);
}

TEST(RepairReport, InWords) {
  const std::string moves = "; control points move by at most 0.5, 0.125 of the surface's size, coordinates by 12 ulps";
  EXPECT_EQ(repair_text(repaired(NetFamily::constant, {one})), "tangent, Lambda -4/3, M -2" + moves);
  EXPECT_EQ(repair_text(repaired(NetFamily::constant, {other})), "tangent, Lambda 5, M 7, sigma 2/3" + moves);
  EXPECT_EQ(repair_text(repaired(NetFamily::segments, {one, other})), "tangent" + moves);
  RepairedSurface plain = repaired(NetFamily::cone, {});
  plain.net.distance.ulps = std::nullopt;
  EXPECT_EQ(repair_text(plain), "tangent; control points move by at most 0.5, 0.125 of the surface's size");
  EXPECT_EQ(repair_text(repaired(NetFamily::unchanged, {})), "tangent; unchanged");
}

}  // namespace
}  // namespace torse::cli
