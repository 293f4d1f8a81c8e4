// torse recover, the real program: the printed functions of FJ21's example from its printed nets, the excluded cases,
// exit codes, and the constant patch through the program again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using Q = Rational;
using Rows = std::vector<Vec<Q, 4>>;

/// FJ21 section 8: the points as printed.
const std::string cubic_points =
    R"("c": {"points": [[0,0,0],[3,3,0],[4,3,0],[5,0,0]], "weights": C},
       "d": {"points": [[0,0,2],[2,2,3],["3/2","21/22","135/22"],["293/172","-189/172","1215/172"]], "weights": D}})";
const std::string quartic =
    R"({"torse": 1, "type": "ruled", "degree": 4,
 "c": {"points": [[0,0,0],["9/4","9/4",0],["27/8",3,0],["341/79","162/79",0],[5,0,0]], "weights": [1,1,"4/5","79/120","5/6"]},
 "d": {"points": [[0,0,2],["3/2","3/2","11/4"],["93/52","81/52","225/52"],["887/568","189/568","3645/568"],
                  ["293/172","-189/172","1215/172"]], "weights": [1,1,"13/15","71/90","43/45"]}})";

std::string cubic(const std::string& c_weights, const std::string& d_weights) {
  std::string text = R"({"torse": 1, "type": "ruled", "degree": 3, )" + cubic_points;
  text.replace(text.find("\"weights\": C") + 11, 1, c_weights);
  text.replace(text.find("\"weights\": D") + 11, 1, d_weights);
  return text;
}

const std::string printed = cubic(R"([1,1,"3/5","5/6"])", R"([1,1,"11/15","43/45"])");

json function(const json& numerator, const json& denominator) { return {{"num", numerator}, {"den", denominator}}; }

class Recover : public ::testing::Test {
 public:
  std::string file(const std::string& name, const std::string& text = "") const {
    if (!text.empty()) spill(scratch / name, text);
    return (scratch / name).string();
  }

  json surface(const std::string& text, int exit = 0) const {
    const ProgramResult result = run_program({"recover", file("net.json", text), "--json", "-"});
    EXPECT_EQ(result.exit, exit) << result.err;
    const json report = json::parse(result.out);
    EXPECT_EQ(report["torse"], 1);
    EXPECT_EQ(report["surfaces"].size(), 1U);
    return report["surfaces"][0];
  }

  static void expect_span(const json& span, const json& lambda, const json& m, const json& sigma) {
    EXPECT_EQ(span["Lambda"], lambda);
    EXPECT_EQ(span["M"], m);
    EXPECT_EQ(span["sigma"], sigma);
  }

  Scratch scratch;
};

const json one = function({1}, {1});

TEST_F(Recover, Section8) {
  const json net = surface(printed);
  EXPECT_EQ(net["class"], "tangent");
  ASSERT_EQ(net["spans"].size(), 1U);
  EXPECT_EQ(net["spans"][0]["from"], "0");
  EXPECT_EQ(net["spans"][0]["to"], "1");
  expect_span(net["spans"][0], function({-4}, {3}), function({-2}, {1}), one);
  EXPECT_EQ(net["spans"][0]["constant"], true);
  EXPECT_TRUE(net["spans"][0]["excluded"].is_null());
  EXPECT_EQ(net["edge"], json({{"degree", 4}, {"v", function({6, 3}, {2})}}));
  EXPECT_EQ(net["spans"][0]["edge"]["degree"], 4);
  EXPECT_EQ(net["spans"][0]["edge"]["v"], function({6, 3}, {2}));
  EXPECT_EQ(net["spans"][0]["edge"]["row"].size(), 4U);
  EXPECT_EQ(net["singular"], json::array());
  // By hand from C4.1 with E = Lam - M = 2/3: lambda = 3/E, mu = (M-t)/E, nu = 0.
  EXPECT_EQ(net["spans"][0]["lambda"], function({9}, {2}));
  EXPECT_EQ(net["spans"][0]["mu"], function({-6, -3}, {2}));
  EXPECT_EQ(net["spans"][0]["nu"], function({0}, {1}));
}

TEST_F(Recover, Section8AfterMoebius) {
  const json net = surface(cubic(R"([8,4,"6/5","5/6"])", R"([8,4,"22/15","43/45"])"));
  expect_span(net["spans"][0], function({8}, {1}), function({4}, {1}), function({3}, {1}));
  EXPECT_EQ(net["edge"]["degree"], 4);
}

TEST_F(Recover, Section8Elevated) {
  const json net = surface(quartic);
  expect_span(net["spans"][0], function({-16, -3}, {9}), function({-8, -1}, {3}), one);
  EXPECT_EQ(net["spans"][0]["constant"], false);
  EXPECT_EQ(net["edge"], json({{"degree", 4}, {"v", function({6, 3}, {2})}}));
}

TEST_F(Recover, Section8TrimmedAndWithAKnot) {
  const proofs::Section8Data<Q> data;
  const proofs::Section8Net<Q> net(data);
  const Rows p = times_linear(net.p, Linear<Q>{Q(1), Q(0)});
  Rows w = net.q;
  for (std::size_t i = 0; i < w.size(); ++i) subtract(w[i], net.p[i]);
  w = times_linear(w, data.g);
  for (std::size_t i = 0; i < w.size(); ++i) add(w[i], p[i]);
  const json trimmed =
      surface(write_ruled(RuledFile<Q>{bezier_knots<Q>(4), dehomogenize<Q, 4>(p), dehomogenize<Q, 4>(w)}));
  // (9t^2 - 3t - 32)/(9 (1-2t)), (7t - 16)/(3 (1-2t)) with a positive leading coefficient below.
  expect_span(trimmed["spans"][0], function({32, 3, -9}, {-9, 18}), function({16, -7}, {-3, 6}), one);

  const auto c = insert_knot(Spline<Q, Vec<Q, 4>>(net.u, net.p), data.knot, 2);
  const auto d = insert_knot(Spline<Q, Vec<Q, 4>>(net.u, net.q), data.knot, 2);
  const json inserted =
      surface(write_ruled(RuledFile<Q>{c.knots, dehomogenize<Q, 4>(c.control), dehomogenize<Q, 4>(d.control)}));
  ASSERT_EQ(inserted["spans"].size(), 2U);
  EXPECT_EQ(inserted["spans"][0]["to"], "2/3");
  EXPECT_EQ(inserted["spans"][1]["from"], "2/3");
  for (const json& span : inserted["spans"]) expect_span(span, function({-4}, {3}), function({-2}, {1}), one);
  EXPECT_EQ(inserted["edge"], json({{"degree", 4}, {"v", function({6, 3}, {2})}}));
}

TEST_F(Recover, FunctionsInWords) {
  EXPECT_EQ(run_program({"recover", file("quartic.json", quartic)}).out,
            file("quartic.json") +
                ": tangent\n"
                "  t in [0, 1]:  Lambda = (-3t - 16)/9  M = (-t - 8)/3  sigma = 1\n"
                "  edge of regression (1-v) p + v q of degree 4: v = (3t + 6)/2\n"
                "  regular: no singular point on the patch\n");
}

/// Planes through (0, 0, 1), whose rulings are 2, 3, ... times as long as from there to c, so that each has functions
/// of its own: twelve are shown.
TEST_F(Recover, ManySpansAreNotAllShown) {
  const auto shown = [&](int pieces) {
    json net{{"torse", 1}, {"type", "ruled"}, {"degree", 1}, {"knots", json::array()}};
    for (int i = 0; i <= pieces; ++i) {
      net["knots"].push_back(i);
      net["c"]["points"].push_back({i, i * i, 0});
      net["d"]["points"].push_back({i * (i + 2), i * i * (i + 2), -i - 1});
    }
    const std::string text = run_program({"recover", file("fan.json", net.dump())}).out;
    std::size_t spans = 0;
    for (std::size_t at = text.find("  t in ["); at != std::string::npos; at = text.find("  t in [", at + 1)) ++spans;
    return std::pair(spans, text.find("... and further spans") != std::string::npos);
  };
  EXPECT_EQ(shown(12), std::pair(std::size_t{12}, false));
  EXPECT_EQ(shown(13), std::pair(std::size_t{12}, true));
}

TEST_F(Recover, TheConstantPatchIsAFileWithThoseConstants) {
  const json patch = surface(quartic)["spans"][0]["constant_patch"];
  EXPECT_EQ(patch["surface"]["degree"], 3);
  const json back = surface(patch["surface"].dump());
  const auto integer = [](const json& number) { return json::array({std::stoi(number.get<std::string>())}); };
  expect_span(back["spans"][0], function(integer(patch["Lambda"]), {1}), function(integer(patch["M"]), {1}), one);
  // Of the printed patch it is the patch itself.
  const json self = surface(printed)["spans"][0]["constant_patch"];
  EXPECT_EQ(self["Lambda"], "-4/3");
  EXPECT_EQ(self["M"], "-2");
  EXPECT_EQ(self["surface"]["d"]["points"][3], json({"293/172", "-189/172", "1215/172"}));
  EXPECT_EQ(self["surface"]["d"]["weights"], json({"1", "1", "11/15", "43/45"}));
}

TEST_F(Recover, BeyondTheBudgetTheClassIsDecidedAllTheSame) {
  const std::string zeros(320'000, '0');  // two coordinates of more than 2^20 bits
  const auto net = [](const std::string& height, const std::string& higher) {
    return R"({"torse": 1, "type": "ruled", "degree": 2, "c": {"points": [[0,0,0],[1,2,0],[3,1,")" + height +
           R"("]]}, "d": {"points": [[0,0,1],[1,2,1],[3,1,")" + higher + R"("]]}})";
  };
  const json far = surface(net("1" + zeros, "1" + zeros.substr(1) + "1"), 3);
  EXPECT_EQ(far["class"], "cylinder");
  EXPECT_EQ(far["direction"], json({"0", "0", "1"}));
  for (const char* key : {"spans", "edge", "singular"}) EXPECT_TRUE(far.at(key).is_null()) << key;
  const std::string fewer = zeros.substr(0, 310'000);
  EXPECT_EQ(surface(net("1" + fewer, "1" + fewer.substr(1) + "1"))["spans"].size(), 1U);
  const ProgramResult shown = run_program({"recover", file("far.json", net("1" + zeros, "1" + zeros.substr(1) + "1"))});
  EXPECT_EQ(shown.exit, 3);
  EXPECT_THAT(shown.out, HasSubstr("too long to recover"));
}

TEST_F(Recover, TheExcludedCasesAreNamed) {
  const std::string cylinder = R"({"torse": 1, "type": "ruled", "degree": 2, "knots": [0, 0, "1/3", 1, 1],
   "c": {"points": [[0,0,0],[1,0,0],[1,1,0],[0,2,0]]}, "d": {"points": [[0,0,2],[1,0,2],[1,1,2],[0,2,2]]}})";
  const json net = surface(cylinder);
  EXPECT_EQ(net["class"], "cylinder");
  EXPECT_EQ(net["direction"], json({"0", "0", "1"}));
  EXPECT_TRUE(net["edge"].is_null());
  ASSERT_EQ(net["spans"].size(), 2U);
  for (const json& span : net["spans"]) {
    for (const char* key : {"Lambda", "M", "sigma"}) EXPECT_TRUE(span[key].is_null()) << key;
    EXPECT_THAT(span["excluded"].get<std::string>(), HasSubstr("lambda_0 + lambda_1 = 0"));
  }
  EXPECT_EQ(net["singular"], json::array());
  EXPECT_THAT(run_program({"recover", file("cylinder", cylinder)}).out, HasSubstr("lambda_0 + lambda_1 = 0"));

  const std::string curve = R"({"torse": 1, "type": "ruled", "degree": 1,
   "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,0,0],[1,0,0]]}})";
  const json none = surface(curve);
  EXPECT_THAT(none["spans"][0]["excluded"].get<std::string>(), HasSubstr("c = d"));
  EXPECT_EQ(none["singular"], json::parse(R"([{"reason": "no surface", "from": "0", "to": "1"}])"));
}

TEST_F(Recover, AConeHasItsVertexAndCheckItsSingularities) {
  const std::string cone = R"({"torse": 1, "type": "ruled", "degree": 2,
   "c": {"points": [[0,0,0],[1,0,0],[1,"1/3",0]]}, "d": {"points": [[0,0,"4/7"],[-1,0,"4/7"],[-1,"-1/3","4/7"]]}})";
  const json net = surface(cone);
  EXPECT_EQ(net["class"], "cone");
  EXPECT_EQ(net["vertex"], json({"0", "0", "2/7"}));
  EXPECT_EQ(net["edge"]["degree"], 0);
  EXPECT_EQ(net["singular"], json::parse(R"([{"reason": "edge", "from": "0", "to": "1"}])"));
  const ProgramResult check = run_program({"check", file("cone", cone), "--json", "-"});
  EXPECT_EQ(json::parse(check.out)["surfaces"][0]["singular"], net["singular"]);
}

TEST_F(Recover, CheckLeavesSingularitiesOfHugeNumbersToRecover) {
  // 24 numbers of 13288 bits each.
  std::string row = "[";
  for (int i = 0; i < 4; ++i) row += std::string(i == 0 ? "" : ",") + "[1e3999,1e3999,1e3999]";
  const std::string huge = R"({"torse": 1, "type": "ruled", "degree": 3, "c": {"points": )" + row + R"(]},
   "d": {"points": )" + row +
                           "]}}";
  const json check = json::parse(run_program({"check", file("huge", huge), "--json", "-"}).out)["surfaces"][0];
  EXPECT_EQ(check["developable"], true);
  EXPECT_TRUE(check["singular"].is_null());
  EXPECT_EQ(surface(huge)["singular"].size(), 1U);
}

TEST_F(Recover, AnIrrationalParameterIsIsolated) {
  // A cylinder with rulings of length 2 t^2 - 1.
  const json net = surface(R"({"torse": 1, "type": "ruled", "degree": 2,
   "c": {"points": [[0,0,0],[1,0,0],[1,1,0]]}, "d": {"points": [[0,0,-1],[1,0,-1],[1,1,1]]}})");
  ASSERT_EQ(net["singular"].size(), 1U);
  const json& at = net["singular"][0];
  EXPECT_EQ(at["reason"], "vanishing");
  EXPECT_EQ(at["from"], at["to"]);
  EXPECT_EQ(at["from"]["zero_of"], json({-1, 0, 2}));
  const Q lower = Q::from_text(at["from"]["lo"].get<std::string>()),
          upper = Q::from_text(at["from"]["hi"].get<std::string>());
  EXPECT_LT(lower * lower, ratio<Q>(1, 2));
  EXPECT_GT(upper * upper, ratio<Q>(1, 2));
}

TEST_F(Recover, LargeIntegersAreStrings) {
  const std::string end = "3000000000000000000000";
  std::string text = printed;
  text.insert(text.find("\"c\""), "\"knots\": [0, 0, 0, " + end + ", " + end + ", " + end + "], ");
  const json net = surface(text);
  expect_span(net["spans"][0], function({"-4000000000000000000000"}, {1}), function({"-6000000000000000000000"}, {1}),
              one);
  EXPECT_EQ(net["spans"][0]["to"], end);
}

TEST_F(Recover, ExitCodes) {
  const std::string twisted = R"({"torse": 1, "type": "ruled", "degree": 1, "knots": ["1/3", 2],
   "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,"1/7"]]}})";
  const json net = surface(twisted, 1);
  EXPECT_EQ(net["class"], "none");
  EXPECT_EQ(net["witness"]["value"], "1/7");
  EXPECT_FALSE(net.contains("spans"));
  const ProgramResult both = run_program({"recover", file("a", twisted), file("b", printed)});
  EXPECT_EQ(both.exit, 1);
  EXPECT_THAT(both.out, HasSubstr("not developable"));
  EXPECT_THAT(both.out, HasSubstr("Lambda = -4/3  M = -2  sigma = 1"));
  EXPECT_THAT(both.out, Not(HasSubstr("\x1b")));
  const ProgramResult broken = run_program({"recover", file("x", "{"), file("b", printed), "--json", "-"});
  EXPECT_EQ(broken.exit, 2);
  EXPECT_EQ(json::parse(broken.out)["surfaces"].size(), 1U);
  EXPECT_EQ(json::parse(broken.out)["errors"].size(), 1U);
  EXPECT_THAT(broken.err, HasSubstr("replay: torse recover"));
  EXPECT_EQ(run_program({"recover"}).exit, 2);
  EXPECT_EQ(run_program({"recover", file("b", printed), "--json", "/dev/full"}).exit, 2);
}

}  // namespace
}  // namespace torse::testing
