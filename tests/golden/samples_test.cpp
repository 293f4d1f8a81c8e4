// Every case of the samples' manifest through the real program: verdicts, classes, exit codes, nets fraction for
// fraction.
#include <gtest/gtest.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;

const std::filesystem::path samples = std::filesystem::path(TORSE_SOURCE_PATH) / "tests/golden/samples";

json manifest() { return json::parse(slurp(samples / "manifest.json")); }

class Sample : public ::testing::TestWithParam<json> {
 public:
  std::string input() const { return (samples / GetParam()["file"].get<std::string>()).string(); }
};

void expect_check(const json& expected, const std::string& input) {
  const ProgramResult result = run_program({"check", input, "--json", "-"});
  EXPECT_EQ(result.exit, expected["exit"]) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["torse"], 1);
  if (!expected.contains("class")) {
    EXPECT_TRUE(report["surfaces"].empty());
    EXPECT_NE(result.err.find(input + ": "), std::string::npos) << result.err;
    return;
  }
  ASSERT_EQ(report["surfaces"].size(), 1U);
  const json& surface = report["surfaces"][0];
  for (const char* key : {"developable", "exact", "class"}) EXPECT_EQ(surface[key], expected[key]) << key;
  EXPECT_EQ(surface["file"], input);
  EXPECT_EQ(surface["witness"].is_null(), expected["developable"].get<bool>());
}

void expect_construct(const json& expected, const std::string& input) {
  const std::string command = expected["command"];
  const Scratch scratch;
  const std::string output = (scratch / "net.json").string();
  const ProgramResult result = run_program({"construct", command.substr(command.find(' ') + 1), input, "-o", output});
  EXPECT_EQ(result.exit, expected["exit"]) << result.err;
  const json net = json::parse(slurp(output));
  const json given = json::parse(slurp(input));
  EXPECT_EQ(net["d"]["points"], expected["d_points"]);
  EXPECT_EQ(net["d"]["weights"], expected["d_weights"]);
  for (const char* key : {"degree", "knots"}) EXPECT_EQ(net[key], given[key]) << key;
  EXPECT_EQ(net["c"]["points"], given["c"]["points"]);
  EXPECT_EQ(run_program({"check", output}).exit, 0);
}

TEST_P(Sample, GivesTheTrueAnswer) {
  if (GetParam()["command"] == "check") {
    expect_check(GetParam(), input());
  } else {
    expect_construct(GetParam(), input());
  }
}

std::string test_name(const ::testing::TestParamInfo<json>& sample) {
  std::string name = sample.param["file"].get<std::string>();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Manifest, Sample, ::testing::ValuesIn(manifest().get<std::vector<json>>()), test_name);

}  // namespace
}  // namespace torse::testing
