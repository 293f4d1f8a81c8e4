// Surfaces that would take long: one clear error or an open answer, within seconds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// So many digits without a pattern, by a linear congruence; the same for the same seed.
std::string digits(int count, unsigned seed) {
  std::string text = "1";
  unsigned state = seed;
  while (static_cast<int>(text.size()) < count) {
    state = state * 1103515245U + 12345U;
    text += static_cast<char>('0' + (state >> 16) % 10);
  }
  return text;
}

/// A Bezier patch; x(row, i, j) is coordinate j of point i of c (row 0) or d.
template <class F>
json patch(int degree, F x) {
  json net{{"torse", 1}, {"type", "ruled"}, {"degree", degree}};
  for (int row = 0; row < 2; ++row) {
    json points = json::array();
    for (int i = 0; i <= degree; ++i) points.push_back({x(row, i, 0), x(row, i, 1), x(row, i, 2)});
    net[row == 0 ? "c" : "d"] = {{"points", points}};
  }
  return net;
}

/// Rows of fractions of so many digits, symmetric about the origin: a cone.
json cone_of_fractions(int degree, int length) {
  return patch(degree, [&](int row, int i, int j) {
    const unsigned seed = static_cast<unsigned>(6 * i + 2 * j + 1);
    return (row == 0 ? "" : "-") + digits(length, seed) + "/" + digits(length, seed + 1);
  });
}

/// A cone over the points (i, i^2 mod 97, i^3 mod 89) with uniform integer knots.
json long_cone(int degree, int count) {
  json net = patch(count - 1, [](int row, int i, int j) {
    const int x = j == 0 ? i : j == 1 ? i * i % 97 : i * i % 89 * i % 89;
    return row == 0 ? x : 2 * x;
  });
  net["degree"] = degree;
  for (int i = 0; i < count + degree - 1; ++i) net["knots"].push_back(i);
  return net;
}

class Effort : public ::testing::Test {
 public:
  ProgramResult run(const json& net, const std::string& word, const std::vector<std::string>& options) const {
    spill(scratch / "net.json", net.dump());
    std::vector<std::string> words{word, (scratch / "net.json").string()};
    words.insert(words.end(), options.begin(), options.end());
    return run_program(words);
  }

  ProgramResult run_construct(const std::string& method, const json& input) const {
    spill(scratch / "input.json", input.dump());
    return run_program({"construct", method, (scratch / "input.json").string(), "-o", out("made.json")});
  }

  std::string out(const std::string& name) const { return (scratch / name).string(); }

  Scratch scratch;
};

TEST_F(Effort, LongFractionsOfAHighDegreeAreRefused) {
  const ProgramResult result = run(cone_of_fractions(60, 400), "check", {});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("net.json: expected a surface of effort 2^40 at most, found 2^41."));
  EXPECT_THAT(result.err, HasSubstr("122 control points of degree 60"));
  EXPECT_EQ(run(cone_of_fractions(60, 40), "check", {}).exit, 0);
}

/// A warp angle that neither doubles nor balls tell from 0, with numbers too long for rationals.
TEST_F(Effort, ATinyWarpOfLongNumbersStaysOpen) {
  json net = cone_of_fractions(3, 3000);
  std::string& x = net["d"]["points"][1][0].get_ref<std::string&>();
  x.back() = x.back() == '1' ? '2' : '1';
  const ProgramResult result = run(net, "check", {"--max-warp", "0", "--json", out("r.json")});
  EXPECT_EQ(result.exit, 3);
  const json surface = json::parse(slurp(out("r.json")))["surfaces"][0];
  EXPECT_EQ(surface["developable"], false);
  EXPECT_GT(surface["max_warp_deg"]["hi"], 0);
  EXPECT_LT(surface["max_warp_deg"]["hi"], 1e-60);
}

TEST_F(Effort, UnrollingAHighDegreeIsRefusedBeforeAnyWork) {
  const ProgramResult result = run(long_cone(100, 101), "unroll", {"-o", out("plate.svg")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("expected a surface of effort 2^40 at most to unroll, found 2^4"));
  EXPECT_FALSE(std::filesystem::exists(out("plate.svg")));
}

TEST_F(Effort, ThereAreFewerRulingsForHighDegrees) {
  const ProgramResult result = run(long_cone(20, 21), "unroll", {"-o", out("plate.svg"), "--rulings", "2000"});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("--rulings: expected at most 1125 for degree 20, found 2000"));
}

TEST_F(Effort, MeshesOfTooManyPiecesAreRefused) {
  const ProgramResult many = run(long_cone(3, 40000), "convert", {"-o", out("net.obj")});
  EXPECT_EQ(many.exit, 2);
  EXPECT_THAT(many.err, HasSubstr("needs more than 32768 strips, one for each of 39997 pieces at least"));
  const ProgramResult high = run(long_cone(30, 130), "convert", {"-o", out("net.obj")});
  EXPECT_EQ(high.exit, 2);
  EXPECT_THAT(high.err, HasSubstr("make 100 pieces: too many of degree 30 for a mesh"));
  EXPECT_EQ(run(long_cone(30, 40), "convert", {"-o", out("net.obj")}).exit, 0);
}

TEST_F(Effort, OnlySmallSurfacesAreRepaired) {
  json net = long_cone(3, 10001);
  net["d"]["points"][5000][0] = 1;
  const ProgramResult result = run(net, "check", {"--repair", out("repaired.json")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("--repair: expected at most 10000 control points for degree 3, found 10001"));
  EXPECT_FALSE(std::filesystem::exists(out("repaired.json")));
  EXPECT_EQ(run(long_cone(3, 10001), "check", {"--repair", out("repaired.json")}).exit, 0);  // developable as it is
}

/// The fitted surface is a file that torse check would refuse.
TEST_F(Effort, RailsOfLongNumbersAreNotFitted) {
  json rails{{"torse", 1}, {"type", "rails"}};
  unsigned seed = 0;
  for (const char* name : {"c", "d"}) {
    rails[name]["degree"] = 3;
    for (int i = 0; i < 4; ++i) {
      const auto near = [&](int x) { return std::to_string(x) + "." + digits(13000, ++seed); };
      rails[name]["points"].push_back({near(i), near(i * i % 3), near(name[0] == 'c' ? 0 : 4)});
    }
  }
  const ProgramResult result = run(rails, "fit", {"--coefficients", "10", "-o", out("strip.json")});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("net.json: expected a fitted surface of effort 2^38 at most, found 2^40."));
  EXPECT_FALSE(std::filesystem::exists(out("strip.json")));
}

/// A clamped curve of so many points (i, i^2 mod 97, i^3 mod 89) between skew end rulings.
json interpolation(int degree, int count) {
  json input{{"torse", 1}, {"type", "construct"}, {"method", "interpolate"}, {"degree", degree}, {"Lambda", "-1/3"}};
  input["va"] = {1, 2, 5};
  input["vb"] = {3, -1, 2};
  input["c"] = long_cone(degree, count)["c"];
  for (int i = -degree + 1; i <= count - 1; ++i) input["knots"].push_back(std::clamp(i, 0, count - degree));
  return input;
}

TEST_F(Effort, AConstructionMakesNothingThatTorseDoesNotRead) {
  const ProgramResult result = run_construct("interpolate", interpolation(100, 201));
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("expected a result of effort 2^40 at most, found 2^5"));
  EXPECT_THAT(result.err, HasSubstr("402 control points of degree 100"));
  EXPECT_FALSE(std::filesystem::exists(out("made.json")));
  EXPECT_EQ(run_construct("interpolate", interpolation(3, 30)).exit, 0);
}

/// One coordinate of so many digits, all of them 9: rulings fold in a part of the strip that is as short as it is long.
TEST_F(Effort, AFitOfLongNumbers) {
  const auto fitted = [&](std::size_t count) {
    const json rails{{"torse", 1},
                     {"type", "rails"},
                     {"c", {{"degree", 1}, {"points", {{1, 2, 3}, {4, 5, 6}}}}},
                     {"d", {{"degree", 2}, {"points", {{std::string(count, '9'), 2, 3}, {4, 5, 6}, {7, 8, 1}}}}}};
    spill(out("rails.json"), rails.dump());
    return run_program({"fit", out("rails.json"), "-o", out("made.json")});
  };
  EXPECT_EQ(fitted(5000).exit, 0);
  std::filesystem::remove(out("made.json"));
  const ProgramResult result = fitted(60000);
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("expected a fitted surface of effort 2^38 at most, found 2^39."));
  EXPECT_FALSE(std::filesystem::exists(out("made.json")));
}

TEST_F(Effort, BranchesOfLongNumbersAreNotSearched) {
  json input = interpolation(3, 201);
  unsigned seed = 0;
  for (json& point : input["c"]["points"]) {
    for (json& x : point) x = "1/" + digits(40, ++seed);
  }
  const ProgramResult fractions = run_construct("interpolate", input);
  EXPECT_EQ(fractions.exit, 2);
  EXPECT_THAT(fractions.err, HasSubstr("expected a polynomial in M of effort 2^31 at most, found 2^31."));
  EXPECT_THAT(run_construct("interpolate", interpolation(3, 202)).err,
              HasSubstr("expected at most 201 control points to interpolate, found 202"));
  input = interpolation(3, 201);
  input["Lambda"] = digits(1000, 1);
  EXPECT_THAT(run_construct("interpolate", input).err, HasSubstr("effort 2^31 at most, found 2^34."));
}

/// c' = a tau + b tau' for a, b of degree n and all numbers of one length.
json directrix(int degree, int length) {
  unsigned seed = 0;
  const auto number = [&] { return digits(length, ++seed); };
  json input{{"torse", 1}, {"type", "construct"}, {"method", "directrix"}, {"degree", degree}};
  for (int i = 0; i <= degree; ++i) {
    input["c"]["points"].push_back({number(), number(), number()});
    input["a"].push_back(number());
    input["b"].push_back(number());
  }
  return input;
}

TEST_F(Effort, LinearSystemsOfLongNumbersAreNotSolved) {
  const ProgramResult high = run_construct("directrix", directrix(100, 1000));
  EXPECT_EQ(high.exit, 2);
  EXPECT_THAT(high.err, HasSubstr("expected a linear system of effort 2^38 at most, found 2^47."));
  EXPECT_THAT(high.err, HasSubstr("101 points"));
  EXPECT_FALSE(std::filesystem::exists(out("made.json")));
  const ProgramResult small = run_construct("directrix", directrix(10, 10));
  EXPECT_EQ(small.exit, 1);
  EXPECT_THAT(small.err, HasSubstr("no rulings"));
}

}  // namespace
}  // namespace torse::testing
