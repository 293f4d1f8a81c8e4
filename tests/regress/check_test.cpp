// torse check, the real program: exit codes, reports, hostile files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string flat = R"({"torse": 1, "type": "ruled", "degree": 1,
 "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,0]]}})";
const std::string twisted = R"({"torse": 1, "type": "ruled", "degree": 1, "knots": ["1/3", 2],
 "c": {"points": [[0,0,0],[1,0,0]]}, "d": {"points": [[0,1,0],[1,1,"1/7"]]}})";

class Check : public ::testing::Test {
 public:
  std::string file(const std::string& name, const std::string& text) const {
    spill(scratch / name, text);
    return (scratch / name).string();
  }
  Scratch scratch;
};

TEST_F(Check, ExitCodesOfOneFile) {
  EXPECT_EQ(run_program({"check", file("flat", flat)}).exit, 0);
  EXPECT_EQ(run_program({"check", file("twisted", twisted)}).exit, 1);
  EXPECT_EQ(run_program({"check", file("broken", "{")}).exit, 2);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), "--max-warp", "5"}).exit, 1);  // atan(1/7) is 8.13 degrees
  EXPECT_EQ(run_program({"check", file("twisted", twisted), "--max-warp", "8.14deg"}).exit, 0);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), "--max-warp", "0.1418rad"}).exit, 1);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), "--max-warp", "0.1419rad"}).exit, 0);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), "--max-warp", "90"}).exit, 0);
  EXPECT_EQ(run_program({"check", file("flat", flat), "--max-warp", "0"}).exit, 0);
}

TEST_F(Check, AnUnreadableFileWinsAndTheOthersAreReported) {
  const ProgramResult result =
      run_program({"check", file("flat", flat), file("broken", "{"), file("twisted", twisted), "--json", "-"});
  EXPECT_EQ(result.exit, 2);
  const json report = json::parse(result.out);
  ASSERT_EQ(report["surfaces"].size(), 2U);
  EXPECT_EQ(report["surfaces"][0]["name"], "flat");
  EXPECT_EQ(report["errors"].size(), 1U);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), file("flat", flat)}).exit, 1);
  EXPECT_EQ(run_program({"check", file("twisted", twisted), file("flat", flat), "--max-warp", "1/2"}).exit, 1);
}

/// Numbers that differ by thousands of orders of magnitude: the roots of the singular parameters do, too.
TEST_F(Check, CoordinatesOfAllSizesTogether) {
  const std::string cylinder = R"({"torse": 1, "type": "ruled", "degree": 2,
   "c": {"points": [["8e-1000", "9e1500", 0], ["-5e300", "-5e-1000", 0], ["-1e1500", "-5e0", 0]]},
   "d": {"points": [["8e-1000", "9e1500", "-5e300"], ["-5e300", "-5e-1000", "2e-300"], ["-1e1500", "-5e0", "-8e-300"]]}})";
  const ProgramResult result = run_program({"check", file("cylinder", cylinder), "--json", "-"});
  EXPECT_EQ(result.exit, 0);
  const json surface = json::parse(result.out)["surfaces"][0];
  EXPECT_EQ(surface["class"], "cylinder");
  // z = d - c has the Bezier coefficients -5e300, 2e-300, -8e-300: it vanishes nowhere.
  EXPECT_EQ(surface["singular"], json::array());
  const std::string crossing = R"({"torse": 1, "type": "ruled", "degree": 2,
   "c": {"points": [[0, 0, 0], ["1e-1500", "3e1500", 0], ["1e1500", 1, 0]]},
   "d": {"points": [[0, 0, "-1e-1500"], ["1e-1500", "3e1500", "1e300"], ["1e1500", 1, "1e1500"]]}})";
  const json other = json::parse(run_program({"check", file("crossing", crossing), "--json", "-"}).out)["surfaces"][0];
  EXPECT_EQ(other["class"], "cylinder");
  ASSERT_EQ(other["singular"].size(), 1U);  // z is increasing from below 0 to above
  EXPECT_EQ(other["singular"][0]["reason"], "vanishing");
}

/// A near miss of 1e-300 in one of 40 pieces is seen, and how much it is.
TEST_F(Check, NearMissesOfAnySize) {
  json net{{"torse", 1}, {"type", "ruled"}, {"degree", 3}};
  for (int i = 0; i <= 40; ++i) {
    for (int times = i == 0 || i == 40 ? 3 : 1; times > 0; --times) net["knots"].push_back(i);
  }
  for (int i = 0; i < 43; ++i) {
    net["c"]["points"].push_back({i, std::to_string(i * i) + "/7", i * 5 % 9});
    net["d"]["points"].push_back({2 * i, std::to_string(2 * i * i) + "/7", 2 * (i * 5 % 9) + 5});
  }
  EXPECT_EQ(run_program({"check", file("cone", net.dump())}).exit, 0);
  net["d"]["points"][20][0] = "40." + std::string(299, '0') + "1";
  const ProgramResult result = run_program({"check", file("near", net.dump()), "--max-warp", "1e-200", "--json", "-"});
  EXPECT_EQ(result.exit, 0);
  const json surface = json::parse(result.out)["surfaces"][0];
  EXPECT_EQ(surface["developable"], false);
  const double lower = surface["max_warp_deg"]["lo"], upper = surface["max_warp_deg"]["hi"];
  EXPECT_GT(lower, 1e-303);
  EXPECT_LT(upper, 1e-296);
  EXPECT_LE(upper - lower, 1e-3 * upper);
}

TEST_F(Check, TheWitnessIsExact) {
  const json surface = json::parse(run_program({"check", file("twisted", twisted), "--json", "-"}).out)["surfaces"][0];
  EXPECT_EQ(surface["developable"], false);
  EXPECT_EQ(surface["class"], "none");
  const double lower = surface["max_warp_deg"]["lo"], upper = surface["max_warp_deg"]["hi"];
  EXPECT_LE(lower, 8.1301023541559787);  // atan(1/7)
  EXPECT_GE(upper, 8.1301023541559787);
  EXPECT_LE(upper - lower, 1e-3 * lower);
  EXPECT_EQ(surface["warp_excluded"], json::array());
  EXPECT_EQ(surface["witness"]["span"], json({"1/3", "2"}));
  EXPECT_EQ(surface["witness"]["piece"], 1);
  EXPECT_EQ(surface["witness"]["coefficient"], 0);
  EXPECT_EQ(surface["witness"]["value"], "1/7");  // the volume of the three edges at c_0
}

TEST_F(Check, WeightsOfOneRowCount) {
  // The second row is the first one moved, a cylinder but for its weights, which bend the rulings.
  const std::string rows = R"({"torse": 1, "type": "ruled", "degree": 2, "c": {"points": [[0,0,0],[1,0,0],[1,1,0]]},
   "d": {"points": [[0,0,1],[1,0,1],[1,1,1]], "weights": )";
  EXPECT_EQ(run_program({"check", file("moved", rows + "[1, 1, 1]}}")}).exit, 0);
  EXPECT_EQ(run_program({"check", file("bent", rows + "[1, 2, 1]}}")}).exit, 1);
}

TEST_F(Check, TheVertexIsExact) {
  const std::string cone = R"({"torse": 1, "type": "ruled", "degree": 2,
   "c": {"points": [[0,0,0],[1,0,0],[1,"1/3",0]]}, "d": {"points": [[0,0,"1/7"],["1/2",0,"1/7"],["1/2","1/6","1/7"]]}})";
  const json surface = json::parse(run_program({"check", file("cone", cone), "--json", "-"}).out)["surfaces"][0];
  EXPECT_EQ(surface["class"], "cone");
  EXPECT_EQ(surface["vertex"], json({"0", "0", "2/7"}));
  EXPECT_EQ(surface["max_warp_deg"], json({{"lo", 0}, {"hi", 0}}));
}

TEST_F(Check, ReportsHoldEveryCaseAndAReplay) {
  const std::string awkward = file("a <&'\"b.json", twisted);
  const std::string junit = (scratch / "r.xml").string(), sarif = (scratch / "r.sarif").string();
  EXPECT_EQ(
      run_program({"check", awkward, file("flat", flat), file("broken", "["), "--junit", junit, "--sarif", sarif}).exit,
      2);
  const std::string xml = slurp(junit);
  EXPECT_THAT(xml, HasSubstr("tests=\"3\" failures=\"1\" errors=\"1\""));
  EXPECT_THAT(xml, HasSubstr("name=\"a &lt;&amp;'&quot;b\""));
  EXPECT_THAT(xml, HasSubstr("replay: torse check"));
  EXPECT_THAT(xml, HasSubstr("name=\"flat\""));
  EXPECT_THAT(xml, ContainsRegex("name=\"broken\"[^>]* time=\"0\\."));
  const json report = json::parse(slurp(sarif));
  EXPECT_EQ(report["version"], "2.1.0");
  const json& results = report["runs"][0]["results"];
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0]["ruleId"], "developable");
  EXPECT_THAT(results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].get<std::string>(),
              HasSubstr("a%20%3C%26%27%22b.json"));
  EXPECT_EQ(results[1]["locations"][0]["physicalLocation"]["region"]["startLine"], 1);
}

/// The value is the twelfth byte and the tenth character of its line.
TEST_F(Check, SarifCountsColumnsInCharacters) {
  const ProgramResult run =
      run_program({"check", file("odd.json", "{\"torse\": 1, \"type\": \"ruled\",\n\"größe\": 0}"), "--sarif", "-"});
  EXPECT_THAT(run.err, HasSubstr("(line 2, column 12)"));
  const json report = json::parse(run.out)["runs"][0];
  EXPECT_EQ(report["columnKind"], "unicodeCodePoints");
  EXPECT_EQ(report["results"][0]["locations"][0]["physicalLocation"]["region"],
            json({{"startLine", 2}, {"startColumn", 10}}));
}

TEST_F(Check, ALimitIsARuleOfItsOwn) {
  const std::string sarif = (scratch / "r.sarif").string(), junit = (scratch / "r.xml").string();
  EXPECT_EQ(run_program({"check", file("twisted", twisted), file("flat", flat), "--max-warp", "5deg", "--sarif", sarif,
                         "--junit", junit})
                .exit,
            1);
  const json results = json::parse(slurp(sarif))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0]["ruleId"], "max-warp");
  const std::string message = results[0]["message"]["text"];
  for (const char* part :
       {"twisted: not developable", "piece 1, u from 1/3 to 2", "is 1/7", "between 8.1", "degrees"}) {
    EXPECT_THAT(message, HasSubstr(part));
    EXPECT_THAT(slurp(junit), HasSubstr(part == std::string("twisted: not developable") ? "name=\"twisted\"" : part));
  }
  EXPECT_THAT(message, HasSubstr("replay: torse check --max-warp 5deg "));
}

TEST_F(Check, AFaceIsChosenByNameOrNumber) {
  EXPECT_EQ(run_program({"check", file("flat", flat), "--face", "1"}).exit, 0);
  EXPECT_EQ(run_program({"check", file("flat", flat), "--face", "flat"}).exit, 0);
  const ProgramResult none = run_program({"check", file("flat", flat), "--face", "2"});
  EXPECT_EQ(none.exit, 2);
  EXPECT_THAT(none.err, HasSubstr("expected a face \"2\", found one face: 1 \"flat\""));
  EXPECT_THAT(none.err, HasSubstr("replay: torse check --face 2 "));
  EXPECT_EQ(run_program({"recover", file("flat", flat), "--face", "flat"}).exit, 0);
  EXPECT_EQ(run_program({"recover", file("flat", flat), "--face", "other"}).exit, 2);
}

TEST_F(Check, StandardOutputIsForOneReader) {
  const ProgramResult json_only = run_program({"check", file("twisted", twisted), "--json", "-"});
  EXPECT_TRUE(json::accept(json_only.out));
  const ProgramResult text = run_program({"check", file("twisted", twisted)});
  EXPECT_THAT(text.out, HasSubstr("not developable"));
  EXPECT_THAT(text.out, HasSubstr("replay: torse check"));
  EXPECT_THAT(text.out, Not(HasSubstr("\x1b")));
  const ProgramResult both = run_program({"check", file("flat", flat), "--json", "-", "--junit", "-"});
  EXPECT_EQ(both.exit, 2);
  EXPECT_EQ(both.out, "");
}

TEST_F(Check, HostileFilesEndWithOneClearError) {
  const std::string point = "[0,1,0]";
  const auto with = [&](const std::string& other) {
    std::string text = flat;
    return text.replace(text.find(point), point.size(), other);
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty file"},
      {std::string("\x7f"
                   "ELF\0\1",
                   6),
       "line 1, column 5: expected JSON, found a null byte"},
      {"\x7f"
       "ELF",
       "invalid literal"},
      {std::string(1'000'000, '['), "at most 32 deep"},
      {with("[1e1000000000,1,0]"), "below 1e4932"},
      {with("[\"1e1000000000\",1,0]"), "d.points[0][0] (line 2, column 56): expected an exponent from -4000 to 4000"},
      {with("[\"1/0\",1,0]"), "denominator that is not zero"},
      {with("[NaN,1,0]"), "line 2, column 56"},
      {with("[0,1]"), "d.points[0] (line 2, column 55): expected three coordinates"},
      {flat + "}", "expected end of input"},
  };
  for (const auto& [text, message] : cases) {
    const ProgramResult result = run_program({"check", file("hostile", text)});
    EXPECT_EQ(result.exit, 2) << message;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_THAT(result.err, HasSubstr("replay: torse check"));
  }
  EXPECT_EQ(run_program({"check", scratch.path().string()}).exit, 2);
  EXPECT_EQ(run_program({"check", "/dev/zero"}).exit, 2);
  EXPECT_EQ(run_program({"check", (scratch / "none").string()}).exit, 2);
}

TEST_F(Check, ReportsThatCannotBeWrittenAreErrors) {
  EXPECT_EQ(run_program({"check", file("flat", flat), "--json", "/dev/full"}).exit, 2);
  EXPECT_EQ(run_program({"check", file("flat", flat), "--junit", (scratch / "no/r.xml").string()}).exit, 2);
}

TEST_F(Check, MistypedWordsGetASuggestion) {
  const ProgramResult command = run_program({"chekc", "x"});
  EXPECT_EQ(command.exit, 2);
  EXPECT_THAT(command.err, HasSubstr("did you mean check?"));
  const ProgramResult option = run_program({"check", file("flat", flat), "--jsn", "x"});
  EXPECT_EQ(option.exit, 2);
  EXPECT_THAT(option.err, HasSubstr("did you mean --json?"));
  for (const char* angle : {"-1", "x", "1/0", "nan", "deg", "1 deg", "1grad", "-1rad"}) {
    const ProgramResult wrong = run_program({"check", file("flat", flat), "--max-warp", angle});
    EXPECT_EQ(wrong.exit, 2) << angle;
    EXPECT_THAT(wrong.err, HasSubstr("--max-warp"));
  }
  EXPECT_EQ(run_program({"check"}).exit, 2);
  EXPECT_EQ(run_program({}).exit, 2);
  EXPECT_EQ(run_program({"--help"}).exit, 0);
  EXPECT_EQ(run_program({"check", "--help"}).exit, 0);
  EXPECT_THAT(run_program({"--version"}).out, HasSubstr("torse 0."));
}

}  // namespace
}  // namespace torse::testing
