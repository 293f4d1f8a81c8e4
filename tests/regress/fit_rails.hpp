// Rails for tests of torse fit, and the real program run on them.
//   cylinder, plain, strip, skew, point     rails files
//   Fit                                     runs of the program in a folder of its own
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::testing {

using nlohmann::json;
using Q = Rational;

/// c(t) = d(t^2) + (1 + t) e: a cylinder.
inline const std::string cylinder = R"({"torse": 1, "type": "rails",
  "c": {"degree": 4, "points": [[0,0,1],[0,0,"5/4"],["1/6",0,"3/2"],["1/2",0,"7/4"],[1,1,2]]},
  "d": {"degree": 2, "points": [[0,0,0],["1/2",0,0],[1,1,0]]}})";

/// A cubic and a quadratic with knots and domains of their own; `strip` has weights too.
inline const std::string open_strip = R"({"torse": 1, "type": "rails",
  "c": {"degree": 3, "knots": [2,2,2,3,5,5,5], "points": [[0,0,0],[1,0.4,0.2],[2,-0.2,0.5],[3,0.3,0.1],[4,0,0]]},
  "d": {"degree": 2, "knots": [0,0,"1/3",1,1], "points": [[0.2,1.5,0.1],[1.5,1.9,0.6],[2.5,1.3,-0.1],[4.1,1.4,0.4]])";
inline const std::string plain = open_strip + "}}";
inline const std::string strip = open_strip + R"(, "weights": [1,2,1,1]}})";

inline const std::string skew = R"({"torse": 1, "type": "rails",
  "c": {"degree": 1, "points": [[-1,0,0],[1,0,0]]}, "d": {"degree": 1, "points": [[0,-1,1],[0,1,1]]}})";

inline const std::string point = R"({"torse": 1, "type": "rails",
  "c": {"degree": 1, "points": [[1,2,3],[1,2,3]]}, "d": {"degree": 1, "points": [[1,2,3],[1,2,3]]}})";

class Fit : public ::testing::Test {
 public:
  std::string file(const std::string& name, const std::string& text = "") const {
    if (!text.empty()) spill(scratch / name, text);
    return (scratch / name).string();
  }

  ProgramResult run(const std::string& text, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words{"fit", file("rails.json", text), "-o", file("out.json")};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words);
  }

  /// The report on the one strip.
  json report(const std::string& text, std::vector<std::string> options = {}) const {
    options.insert(options.end(), {"--json", file("report.json")});
    const ProgramResult result = run(text, options);
    EXPECT_EQ(result.exit, 0) << result.err;
    const std::string bytes = slurp(scratch / "report.json");
    EXPECT_TRUE(bytes.starts_with("{\n  \"torse\": 1,\n  \"surfaces\": [\n    {")) << bytes.substr(0, 60);
    return json::parse(bytes).at("surfaces").at(0);
  }

  RuledFile<Q> written() const { return read_ruled<Q>(Document("out.json", slurp(scratch / "out.json"))); }

  const Scratch scratch;
};

}  // namespace torse::testing
