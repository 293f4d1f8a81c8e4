// torse fit, the real program: the surface is exactly on its rails and on the mapping that is reported, exit codes,
// what is refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "regress/fit_rails.hpp"
#include "torse/algebra/determinant.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

using Row = Vec<Q, 4>;

Vec<Q, 3> at(const KnotList<Q>& u, const WeightedPoints<Q, 3>& net, const Q& t) {
  const std::vector<Row> rows = homogeneous(net);
  return dehomogenize<Q, 4>({curve_point<Q, Row>(u, rows, piece_at(u, t), t)}).points.front();
}

Mapping<Q> mapping_in(const json& report) {
  const json& mapping = report.at("mapping");
  std::vector<Q> knots, beta;
  for (const std::string text : mapping.at("knots")) knots.push_back(Q::from_text(text));
  for (const std::string text : mapping.at("coefficients")) beta.push_back(Q::from_text(text));
  return mapping_of(KnotList<Q>(mapping.at("degree"), knots), beta);
}

TEST_F(Fit, RailsOfACylinderGiveTheCylinder) {
  const json report = this->report(cylinder, {"--coefficients", "3"});
  EXPECT_EQ(report.at("developable"), true);
  EXPECT_GT(report.at("before").at("mean_deg"), 10);
  EXPECT_EQ(mapping_value(mapping_in(report), ratio<Q>(1, 2)), ratio<Q>(1, 4));
  const ProgramResult check = run_program({"check", file("out.json")});
  EXPECT_EQ(check.exit, 0);
  EXPECT_THAT(check.out, HasSubstr("cylinder"));
}

TEST_F(Fit, TheSurfaceIsExactlyOnItsRailsAndItsMapping) {
  for (const char* method : {"warp", "paper", "discrete", "same"}) {
    SCOPED_TRACE(method);
    const json report = this->report(strip, {"--method", method, "--coefficients", "12"});
    const RailsFile<Q> rails = read_rails<Q>(Document("rails.json", strip));
    const RuledFile<Q> surface = written();
    const Mapping<Q> sigma = mapping_in(report);
    EXPECT_EQ(sigma.knots.domain_begin(), Q(2));
    EXPECT_EQ(mapping_value(sigma, Q(2)), Q(0));
    EXPECT_EQ(mapping_value(sigma, Q(5)), Q(1));
    for (int i = 0; i <= 60; ++i) {
      const Q t = Q(2) + ratio<Q>(i, 20);
      EXPECT_EQ(at(surface.knots, surface.c, t), at(rails.c.knots, rails.c.net, t)) << i;
      EXPECT_EQ(at(surface.knots, surface.d, t), at(rails.d.knots, rails.d.net, mapping_value(sigma, t))) << i;
    }
  }
}

TEST_F(Fit, OursIsBetterThanThePapersAndThanTheSameParameter) {
  const auto mean = [&](const char* method) -> double {
    return report(strip, {"--method", method, "--coefficients", "20"}).at("after").at("mean_deg");
  };
  const double ours = mean("warp");
  EXPECT_LT(ours, mean("paper"));
  EXPECT_LT(ours, mean("same"));
}

TEST_F(Fit, TheCertificateEnclosesWhatIsSampled) {
  for (const char* ends : {"fixed", "free"}) {
    const json report = this->report(strip, {"--ends", ends, "--coefficients", "20"});
    const double high = report.at("max_warp_deg").at("hi");
    EXPECT_LE(report.at("max_warp_deg").at("lo"), high);
    EXPECT_LE(report.at("after").at("max_deg").get<double>(), high * (1 + 1e-9));
    EXPECT_EQ(report.at("mapping").at("monotone"), "strict");
  }
}

/// With a mapping of degree 2 the surface has twice the degree of the rails.
TEST_F(Fit, CertifiesRailsOfHighDegree) {
  for (const int degree : {5, 6, 7, 8}) {
    SCOPED_TRACE(degree);
    json rails{{"torse", 1}, {"type", "rails"}};
    for (const char* rail : {"c", "d"}) {
      const double phase = rail[0] - 'c';
      rails[rail] = {{"degree", degree}, {"points", json::array()}};
      for (int i = 0; i <= degree; ++i) {
        const double z = std::round(50 * std::cos(i + phase / 2)) / 100;
        rails[rail]["points"].push_back({i * 4.0 / degree, 1.5 * phase, z});
      }
    }
    const json report = this->report(rails.dump(), {"--coefficients", "6"});
    EXPECT_EQ(report.at("surface").at("degree"), 2 * degree);
    const double low = report.at("max_warp_deg").at("lo");
    const double high = report.at("max_warp_deg").at("hi");
    EXPECT_LT(high, 60);
    EXPECT_LE(high - low, 2e-3 * high);
    EXPECT_LE(report.at("after").at("max_deg").get<double>(), high * (1 + 1e-9));
  }
}

/// Every rails file of examples/ gives a surface that is better than T = t and certified.
TEST_F(Fit, TheExamplesAreFitted) {
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TORSE_SOURCE_PATH "/examples")) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename());
    const bool known = entry.path().filename().string().starts_with("known");
    const json report =
        this->report(slurp(entry.path()), {"--degree", known ? "3" : "2", "--coefficients", known ? "4" : "20"});
    const double after = report.at("after").at("mean_deg");
    EXPECT_LT(after, known ? 1e-9 : report.at("before").at("mean_deg").get<double>());
    EXPECT_LT(report.at("max_warp_deg").at("hi").get<double>(), known ? 1e-9 : 90);
    EXPECT_EQ(report.at("mapping").at("monotone"), "strict");
    ++examples;
  }
  EXPECT_EQ(examples, 9);
}

TEST_F(Fit, ExtendedRailsCoverTheOldOnes) {
  const json report = this->report(strip, {"--ends", "extended", "--extend", "1/5"});
  const RailsFile<Q> rails = read_rails<Q>(Document("rails.json", strip));
  const RuledFile<Q> surface = written();
  const Mapping<Q> sigma = mapping_in(report);
  const json& trim = report.at("trim");
  const Q c_begin = Q::from_text(trim.at("begin").at("c").get<std::string>());
  const Q d_begin = Q::from_text(trim.at("begin").at("d").get<std::string>());
  const Q d_end = Q::from_text(trim.at("end").at("d").get<std::string>());
  EXPECT_EQ(c_begin, Q(2));
  EXPECT_EQ(sigma.knots.domain_begin(), std::min(c_begin, d_begin));
  EXPECT_EQ(at(surface.knots, surface.d, d_begin), rails.d.net.points.front());
  EXPECT_EQ(at(surface.knots, surface.d, d_end), rails.d.net.points.back());
  for (int i = 0; i <= 30; ++i) {
    const Q t = Q(2) + ratio<Q>(i, 10);
    EXPECT_EQ(at(surface.knots, surface.c, t), at(rails.c.knots, rails.c.net, t)) << i;
  }
}

/// The exact surface is known: c(t) and d(sigma(t)) by the rails of the file and the mapping of the report.
TEST_F(Fit, SimplerSurfacesAreWithinTheDistance) {
  const RailsFile<Q> rails = read_rails<Q>(Document("rails.json", plain));
  const json exact = this->report(plain, {"--coefficients", "12"}).at("surface");
  const Q within = ratio<Q>(1, 5);
  const double far = 0.2;
  for (const char* simplest : {"points", "degree", "knots"}) {
    SCOPED_TRACE(simplest);
    const json report = this->report(plain, {"--coefficients", "12", "--within", "1/5", "--simplest", simplest});
    const json& simplified = report.at("simplified");
    EXPECT_EQ(report.at("exact"), false);
    EXPECT_EQ(simplified.at("exact"), exact);
    EXPECT_LT(report.at("surface").at("points"), exact.at("points"));
    const int degree = report.at("surface").at("degree");
    EXPECT_LE(degree, simplest == std::string("degree") ? 3 : 4);
    EXPECT_GE(degree, simplest == std::string("knots") ? 4 : 1);
    EXPECT_LE(simplified.at("distance"), far);
    const RuledFile<Q> surface = written();
    const Mapping<Q> sigma = mapping_in(report);
    Q largest(0);
    for (int i = 0; i <= 90; ++i) {
      const Q t = Q(2) + ratio<Q>(i, 30);
      const Vec<Q, 3> of_c = difference(at(surface.knots, surface.c, t), at(rails.c.knots, rails.c.net, t));
      const Vec<Q, 3> of_d =
          difference(at(surface.knots, surface.d, t), at(rails.d.knots, rails.d.net, mapping_value(sigma, t)));
      largest = std::max({largest, dot(of_c, of_c), dot(of_d, of_d)});
    }
    EXPECT_LE(largest, within * within);
    EXPECT_LE(largest.to_double(), std::pow(simplified.at("distance").get<double>(), 2));
    EXPECT_GT(largest, within * within / Q(10000)) << "the distance is hardly used";
  }
}

/// The plate's rails have the lengths of the rails of the file, found here by long chains of chords.
TEST_F(Fit, UnrollsWhatItFits) {
  const json report =
      this->report(cylinder, {"--coefficients", "3", "--unroll", file("plate.svg"), "--unroll", file("plate.json")});
  const RailsFile<Q> rails = read_rails<Q>(Document("rails.json", cylinder));
  const json& plate = report.at("plate");
  EXPECT_EQ(plate.at("unrolled"), true);
  EXPECT_EQ(plate.at("overlap"), false);
  EXPECT_EQ(plate.at("error").at("inside"), 0);
  for (const auto& [name, rail] : {std::pair{"c", &rails.c}, std::pair{"d", &rails.d}}) {
    double chain = 0;
    Vec<Q, 3> last = at(rail->knots, rail->net, Q(0));
    for (int i = 1; i <= 400; ++i) {
      const Vec<Q, 3> next = at(rail->knots, rail->net, ratio<Q>(i, 400));
      const Vec<Q, 3> step = difference(next, last);
      chain += std::sqrt(dot(step, step).to_double());
      last = next;
    }
    EXPECT_NEAR(plate.at("length").at(name).at("lo"), chain, 1e-5 * chain);
  }
  EXPECT_THAT(slurp(scratch / "plate.svg"), HasSubstr("</svg>"));
  EXPECT_EQ(json::parse(slurp(scratch / "plate.json")).at("type"), "plate");
}

TEST_F(Fit, NamesOfPlatesThatAreNoUtf8AreWrittenWithEscapes) {
  const json report = this->report(cylinder, {"--coefficients", "3", "--unroll", file("plate\xFF.svg")});
  EXPECT_EQ(report.at("plate").at("files"), json::array({file("plate\\xff.svg")}));
  EXPECT_THAT(slurp(scratch / "plate\xFF.svg"), HasSubstr("</svg>"));
}

TEST_F(Fit, TellsWhyThereIsNoPlate) {
  const ProgramResult result = run(skew, {"--unroll", file("plate.dxf"), "--json", file("report.json")});
  EXPECT_EQ(result.exit, 1);
  EXPECT_THAT(result.out, HasSubstr("no plate: not developable: the largest warp angle lies in [89.9999, 90] degrees"));
  const json plate = json::parse(slurp(scratch / "report.json")).at("surfaces").at(0).at("plate");
  EXPECT_EQ(plate.at("unrolled"), false);
  EXPECT_THAT(plate.at("reason").get<std::string>(), HasSubstr("more than 45deg"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "out.json"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "plate.dxf"));
}

/// A warp of some degrees is unrolled with the bound of docs/decisions/0008-unroll.md: 1 / cos(warp / 2) - 1.
TEST_F(Fit, PlatesOfWarpedStripsSayHowMuchTheyStretch) {
  const json report = this->report(strip, {"--coefficients", "6", "--unroll", file("plate.svg")});
  const double warp = report.at("max_warp_deg").at("hi");
  EXPECT_GT(warp, 0.1);
  const double stretch = 1 / std::cos(warp * std::numbers::pi / 360) - 1;
  EXPECT_NEAR(report.at("plate").at("error").at("inside"), stretch, 0.05 * stretch);
}

TEST_F(Fit, TellsWhyAndBy90Degrees) {
  const json report = this->report(skew);
  ASSERT_FALSE(report.at("findings").empty());
  for (const json& finding : report.at("findings")) EXPECT_EQ(finding.at("obstacle"), "tangents");
  EXPECT_THAT(run(skew).out, HasSubstr("no ruling from there is developable"));
}

TEST_F(Fit, TheLimitDecidesTheExitCode) {
  EXPECT_EQ(run(strip, {"--max-warp", "90", "--coefficients", "8"}).exit, 0);
  EXPECT_EQ(run(strip, {"--max-warp", "1e-3", "--coefficients", "8"}).exit, 1);
  EXPECT_EQ(run(cylinder, {"--max-warp", "0", "--coefficients", "3"}).exit, 0);
}

TEST_F(Fit, ReportsTheStopAndTheGradientOfTheBaseline) {
  const json report = this->report(strip, {"--method", "paper", "--coefficients", "12"});
  EXPECT_LT(report.at("fit").at("gradient_error"), 1e-5);
  EXPECT_FALSE(report.at("fit").at("stop").get<std::string>().empty());
  EXPECT_GT(report.at("fit").at("evaluations"), 0);
}

TEST_F(Fit, SaysWhereRailsRunInOppositeDirections) {
  const std::string crossed = R"({"torse": 1, "type": "rails",
    "c": {"degree": 1, "points": [[0,0,0],[3,0,0]]}, "d": {"degree": 1, "points": [[3,1,0],[0,1,0]]}})";
  EXPECT_THAT(run(crossed).out, HasSubstr("--reverse"));
  EXPECT_EQ(run(crossed, {"--reverse"}).out.find("--reverse"), std::string::npos);
}

TEST_F(Fit, WritesWhatItsNameSays) {
  const ProgramResult result =
      run_program({"fit", file("rails.json", strip), "-o", file("a.obj"), "-o", file("b.glb"), "--coefficients", "10"});
  EXPECT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(slurp(scratch / "a.obj"), HasSubstr("\nv "));
  EXPECT_EQ(slurp(scratch / "b.glb").substr(0, 4), "glTF");
}

/// Two rails with a loop, one above the other: a monotone mapping does not keep the strip from crossing itself.
TEST_F(Fit, FindsCrossingsAndFolds) {
  const std::string loop = R"({"torse": 1, "type": "rails",
    "c": {"degree": 3, "points": [[0,0,0],[3,2,0],[-2,2,0],[1,0,0]]}, "d": {"degree": 3, "points": [[0,0,1],[3,2,1],[-2,2,1],[1,0,1]]}})";
  const json report = this->report(loop, {"--method", "same"});
  EXPECT_EQ(report.at("mapping").at("monotone"), "strict");
  EXPECT_EQ(report.at("self_intersection").at("crosses"), true);
  EXPECT_EQ(report.at("folds").at("folded"), false);
  EXPECT_THAT(run(loop, {"--method", "same"}).out, HasSubstr("crosses itself"));
  const json simple = this->report(strip);
  EXPECT_EQ(simple.at("self_intersection").at("crosses"), false);
  EXPECT_EQ(simple.at("folds").at("folded"), false);
}

/// Of the strips with fixed ends the least maximum is that of the end rulings here; the mean is low all the same.
TEST_F(Fit, TheLeastMaximumLeavesNoHighMean) {
  const std::string cubics = slurp(TORSE_SOURCE_PATH "/examples/cubics.json");
  const json by_mean = this->report(cubics, {"--coefficients", "20"});
  const json by_max = this->report(cubics, {"--coefficients", "20", "--measure", "max"});
  EXPECT_LE(by_max.at("max_warp_deg").at("lo"), by_mean.at("max_warp_deg").at("hi"));
  EXPECT_LE(by_max.at("after").at("mean_deg").get<double>(), 1.05 * by_mean.at("after").at("mean_deg").get<double>());
  const json free = this->report(cubics, {"--coefficients", "20", "--measure", "max", "--ends", "free"});
  EXPECT_LT(free.at("max_warp_deg").at("hi").get<double>(), 0.6 * by_max.at("max_warp_deg").at("hi").get<double>());
}

TEST_F(Fit, ExtendedEndsAreNeverWorseThanFixedOnes) {
  int longer = 0;
  for (const char* name : {"cubics", "hull-bottom", "hull-side", "shoe-strap"}) {
    SCOPED_TRACE(name);
    const std::string rails = slurp(std::string(TORSE_SOURCE_PATH "/examples/") + name + ".json");
    const json fixed = this->report(rails, {"--coefficients", "20"});
    const json extended = this->report(rails, {"--coefficients", "20", "--ends", "extended"});
    EXPECT_LE(extended.at("after").at("mean_deg"), fixed.at("after").at("mean_deg"));
    const json& begin = extended.at("trim").at("begin");
    if (begin.at("c") != begin.at("d")) ++longer;
  }
  EXPECT_GT(longer, 0) << "no strip is extended";
}

/// The mapping has a piece of length 2e-8, whose rulings come nearer to each other than any tolerance tells, but do not
/// cross.
TEST_F(Fit, NeighboursInATinyPieceDoNotCross) {
  const ProgramResult result = run_program({"fit", TORSE_SOURCE_PATH "/examples/twisted.json", "-o", file("out.json"),
                                            "--coefficients", "8", "--regular", "--json", file("report.json")});
  EXPECT_EQ(result.exit, 0) << result.err;
  const json report = json::parse(slurp(scratch / "report.json")).at("surfaces").at(0);
  EXPECT_EQ(report.at("self_intersection").at("crosses"), false);
}

/// The rail of these points turns back twice; with little weight in the middle it does not.
TEST_F(Fit, FoldsAndCrossingsAreThoseOfTheWeightedRails) {
  const json line{{"degree", 3}, {"points", {{0, 0, 0}, {"1/3", 0, 0}, {"2/3", 0, 0}, {1, 0, 0}}}};
  json back{{"degree", 3}, {"points", {{0, 0, 1}, {2, 0, 1}, {-1, 0, 1}, {1, 0, 1}}}};
  for (const bool weighted : {false, true}) {
    if (weighted) back["weights"] = {1, "1/20", "1/20", 1};
    for (const auto& [c, d] : {std::pair{line, back}, std::pair{back, line}}) {
      const json rails{{"torse", 1}, {"type", "rails"}, {"c", c}, {"d", d}};
      const json report = this->report(rails.dump(), {"--method", "same"});
      EXPECT_EQ(report["folds"]["folded"], !weighted);
      EXPECT_EQ(report["self_intersection"]["crosses"], !weighted);
    }
  }
}

TEST_F(Fit, RefusesAndWritesNothing) {
  const auto refused = [&](const std::string& text, const std::vector<std::string>& options, const std::string& words) {
    const ProgramResult result = run(text, options);
    EXPECT_EQ(result.exit, 2);
    EXPECT_THAT(result.err, HasSubstr(words));
    EXPECT_FALSE(std::filesystem::exists(scratch / "out.json"));
  };
  refused(point, {}, "expected rails, found one point");
  refused(strip, {"--method", "best"}, "--method: expected warp, paper, discrete, same, found \"best\"");
  refused(strip, {"--degree", "4", "--coefficients", "4"}, "--coefficients: expected at least 5 for degree 4, found 4");
  json high{{"torse", 1}, {"type", "rails"}};
  for (const char* rail : {"c", "d"}) {
    high[rail] = {{"degree", 21}, {"points", json::array()}};
    for (int i = 0; i <= 21; ++i) high[rail]["points"].push_back({i, i * i, rail[0] - 'c'});
  }
  refused(high.dump(), {}, "a mapping of degree 2 gives a surface of degree 42, expected at most 40");
  refused(R"({"torse": 1, "type": "ruled"})", {}, "\"rails\"");
  refused(strip, {"--ends", "extended", "--extend", "0"}, "--extend: expected a share above 0 and at most 1, found 0");
  refused(strip, {"--within", "0"}, "--within: expected a length above 0, found 0");
  refused(strip, {"--within", "1", "--simplest", "point"}, "did you mean points?");
  refused(strip, {"--within", "1"}, "d.weights: expected a rail without weights for a simpler surface");
  refused(strip, {"-o", file("out.xyz")}, "--output: expected an extension among .json, ");
  refused(strip, {"--unroll", file("out.obj")}, "--unroll: expected a name that ends in .svg, .dxf or .json");
  refused(strip, {"-o", "-", "--json", "-"}, "standard output");
}

}  // namespace
}  // namespace torse::testing
