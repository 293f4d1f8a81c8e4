// torse construct, the real program: every method's net against expectations made by hand, and every refusal leaves no
// file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string>

#include "support/program.hpp"
#include "torse/developable/condition.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Q = Rational;
using Point3 = Vec<Q, 3>;

const json parabola = json::parse("[[0,0,0],[1,2,0],[3,1,1]]");
const json quartic = json::parse("[[0,0,0],[1,2,0],[3,1,1],[4,4,0],[2,7,5]]");

/// A construction's input over a quadratic Bezier curve; `more` adds or replaces members.
json input_of(const std::string& method, const json& more) {
  json input{{"torse", 1}, {"type", "construct"}, {"method", method}, {"degree", 2}, {"c", {{"points", parabola}}}};
  if (!more.is_null()) input.update(more);
  return input;
}

class Construct : public ::testing::Test {
 public:
  ProgramResult run(const json& input, const std::vector<std::string>& more = {}) {
    spill(scratch / "in.json", input.dump());
    std::vector<std::string> words{"construct", input["method"], (scratch / "in.json").string(), "-o", output()};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  std::string output() const { return (scratch / "out.json").string(); }
  json net() const { return json::parse(slurp(output())); }
  RuledFile<Q> surface() const { return read_ruled<Q>(Document("out", slurp(output()))); }
  bool written() const { return std::filesystem::exists(output()); }

  void expect_refused(const json& input, const std::string& message, int exit = 2) {
    const ProgramResult result = run(input);
    EXPECT_EQ(result.exit, exit) << result.out;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_FALSE(written());
  }

  json checked() { return json::parse(run_program({"check", output(), "--json", "-"}).out)["surfaces"][0]; }

  Scratch scratch;
};

bool parallel(const Point3& a, const Point3& b) {
  const Point3 n = cross(a, b);
  return n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
}

TEST_F(Construct, CylinderByTranslationAndByM) {
  EXPECT_EQ(run(input_of("cylinder", {{"d0", {"1/2", 0, 5}}})).exit, 0);
  EXPECT_EQ(net()["d"]["points"], json::parse(R"([["1/2","0","5"],["3/2","2","5"],["7/2","1","6"]])"));
  EXPECT_EQ(checked()["direction"], json({"1", "0", "10"}));

  // M = 3: the ruling shrinks by (M-1)/M = 2/3 from vertex to vertex.
  EXPECT_EQ(run(input_of("cylinder", {{"d0", {9, 0, 0}}, {"M", 3}, {"Lambda", "3"}})).exit, 0);
  EXPECT_EQ(net()["d"]["points"], json::parse(R"([["9","0","0"],["7","2","0"],["7","1","1"]])"));
  EXPECT_EQ(checked()["class"], "cylinder");
}

TEST_F(Construct, ConeKeepsTheWeights) {
  const json c{{"points", parabola}, {"weights", {1, "2/3", 4}}};
  EXPECT_EQ(run(input_of("cone", {{"c", c}, {"d0", {0, 0, 6}}, {"Lambda", "1/3"}})).exit, 0);
  EXPECT_EQ(net()["d"]["points"], json::parse(R"([["0","0","6"],["1/3","2/3","6"],["1","1/3","19/3"]])"));
  EXPECT_EQ(net()["d"]["weights"], json({"1", "2/3", "4"}));
  EXPECT_EQ(checked()["vertex"], json({"0", "0", "9"}));  // (c_0/3 - d_0) / (1/3 - 1)
}

TEST_F(Construct, TangentRowIsTheCurvePlusItsDerivative) {
  const json knots{0, 0, 1, 3, 4, 4};
  EXPECT_EQ(run(input_of("tangent", {{"c", {{"points", quartic}}}, {"knots", knots}})).exit, 0);
  EXPECT_EQ(net()["knots"], json::parse(R"(["0","0","1","1","3","3","4","4"])"));
  const RuledFile<Q> made = surface();
  const KnotList<Q> given(2, {Q(0), Q(0), Q(1), Q(3), Q(4), Q(4)});
  std::vector<Point3> c;
  for (const json& x : quartic) c.emplace_back(Q(x[0].get<int>()), Q(x[1].get<int>()), Q(x[2].get<int>()));
  const std::pair<int, int> pieces[] = {{1, 1}, {2, 3}, {3, 5}};  // of the given list, of the list of Bezier pieces
  for (const auto& [k, j] : pieces) {
    const Q t = (given.piece_begin(k) + given.piece_end(k)) / Q(3);
    const Point3 x = curve_point<Q, Point3>(given, c, k, t);
    EXPECT_TRUE((curve_point<Q, Point3>(made.knots, made.c.points, j, t) == x)) << k;
    EXPECT_TRUE((curve_point<Q, Point3>(made.knots, made.d.points, j, t) ==
                 sum(x, curve_derivative<Q, Point3>(given, c, k, t))))
        << k;
  }
  EXPECT_EQ(checked()["class"], "tangent");
}

TEST_F(Construct, InterpolationReachesBothRulings) {
  // v x w = (0, 0, 1) and the curve's height falls and rises, so that the polynomial in M* has two rational roots off
  // the knots: heights 0, h_1, h_2, h_3 of a cubic on [0, 1] give F = D_0 (M-1)^2 + D_1 M (M-1) + D_2 M^2.
  const json c{{"points", json::parse("[[0,0,0],[1,3,6],[2,-1,1],[5,2,2]]")}};  // D = 6, -5, 1: 2 M^2 - 7 M + 6
  const json input =
      input_of("interpolate", {{"degree", 3}, {"c", c}, {"va", {1, 0, 0}}, {"vb", {0, 1, 0}}, {"Lambda", 5}});
  json same = input;
  same["Lambda"] = "3/2";
  expect_refused(same, ": Lambda (line 1");
  EXPECT_EQ(run(same, {"--branch", "2"}).exit, 0);
  const std::pair<const char*, Q> branches[] = {{"1", ratio<Q>(3, 2)}, {"2", Q(2)}};
  for (const auto& [branch, m] : branches) {
    const ProgramResult result = run(input, {"--branch", branch});
    ASSERT_EQ(result.exit, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("branch 1: M* = 3/2 (exact)"));
    EXPECT_THAT(result.out, HasSubstr("branch 2: M* = 2 (exact)"));
    EXPECT_THAT(result.out, ::testing::Not(HasSubstr("rounded")));
    const RuledFile<Q> made = surface();
    EXPECT_TRUE(parallel(difference(made.d.points[0], made.c.points[0]), Point3(Q(1), Q(0), Q(0))));
    EXPECT_TRUE(parallel(difference(made.d.points[3], made.c.points[3]), Point3(Q(0), Q(1), Q(0))));
    for (std::size_t i = 0; i < 3; ++i) {  // FJ07.12 with Lam = 5
      const Point3 left = combine(Q(-4), made.c.points[i], Q(5), made.c.points[i + 1]);
      EXPECT_TRUE((left == combine(Q(1) - m, made.d.points[i], m, made.d.points[i + 1]))) << branch;
    }
    EXPECT_EQ(checked()["class"], "tangent");
  }
  EXPECT_EQ(run(input, {"--branch", "3"}).exit, 2);
}

/// What is printed is no less than the angle, by the arcsine in doubles.
TEST_F(Construct, TheAngleToTheLastRulingIsAtMostWhatIsSaid) {
  const std::regex said("off vb by at most ([0-9.e+-]+) degrees");
  int answers = 0;
  for (int height = 2; height < 80; ++height) {
    const json c{{"points", {{0, 0, 0}, {1, 3, height}, {2, -1, -4}, {5, 2, -3}}}};
    const ProgramResult result =
        run(input_of("interpolate", {{"degree", 3}, {"c", c}, {"va", {1, 0, 0}}, {"vb", {0, 1, 0}}, {"Lambda", 5}}));
    std::smatch found;
    if (result.exit != 0 || !std::regex_search(result.out, found, said)) continue;
    const RuledFile<Q> made = surface();
    const Point3 last = difference(made.d.points[3], made.c.points[3]);
    const Q sine2 = (last[0] * last[0] + last[2] * last[2]) / dot(last, last);
    const double angle = std::asin(std::sqrt(sine2.to_double())) * 180 / std::numbers::pi;
    EXPECT_GE(std::stod(found[1]), angle * (1 - 1e-9)) << height;
    ++answers;
  }
  EXPECT_GT(answers, 30);
}

TEST_F(Construct, AnIrrationalBranchIsExactlyDevelopable) {
  const json c{{"points", json::parse("[[0,0,0],[1,3,1],[2,-1,-4],[5,2,-3]]")}};  // D = 1, -5, 1
  const ProgramResult result =
      run(input_of("interpolate", {{"degree", 3}, {"c", c}, {"va", {1, 0, 0}}, {"vb", {0, 1, 0}}, {"Lambda", 5}}));
  ASSERT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("irrational"));
  EXPECT_THAT(result.out, HasSubstr("off vb by at most"));
  const RuledFile<Q> made = surface();
  EXPECT_FALSE((find_witness<Q, 3>(made.knots, made.c.points, made.d.points)));
  EXPECT_TRUE(parallel(difference(made.d.points[0], made.c.points[0]), Point3(Q(1), Q(0), Q(0))));
  const Point3 last = difference(made.d.points[3], made.c.points[3]);
  EXPECT_FALSE(parallel(last, Point3(Q(0), Q(1), Q(0))));
  EXPECT_LT((last[0] * last[0] + last[2] * last[2]) * Q(1'000'000'000) * Q(1'000'000'000) * Q(1'000'000'000),
            last[1] * last[1]);
}

/// On one piece the differences of the points are the coefficients of F in M^i (M-1)^(4-i). Those of z are
/// (a^2 - 5ab + b^2)(a^2 - 7ab + b^2), whose four roots M/(M-1) are irrational, those of the other coordinate
/// (a^2 - 5ab + b^2)(a^2 + b^2): it vanishes at the first and the last branch, and with it one end's ruling.
TEST_F(Construct, ARulingOfLengthZeroOfAnIrrationalBranchIsTold) {
  const std::array<int, 6> z{0, 1, -11, 26, 14, 15}, common{0, 1, -4, -2, -7, -6}, other{0, 1, 2, 5, 6, 9};
  for (const bool first : {true, false}) {
    json points = json::array();
    for (std::size_t i = 0; i < z.size(); ++i) {
      points.push_back({first ? common[i] : other[i], first ? other[i] : common[i], z[i]});
    }
    const json input =
        input_of("interpolate",
                 {{"degree", 5}, {"c", {{"points", points}}}, {"va", {1, 0, 0}}, {"vb", {0, 1, 0}}, {"Lambda", 5}});
    for (int branch = 1; branch <= 4; ++branch) {
      const ProgramResult result = run(input, {"--branch", std::to_string(branch)});
      ASSERT_EQ(result.exit, 0) << result.err;
      EXPECT_THAT(result.out, HasSubstr("branch 4: M* = 1.26376261582597"));
      const bool zero = branch == 1 || branch == 4;
      const auto told = [&](const char* words) { return result.out.find(words) != std::string::npos; };
      EXPECT_EQ(told("the first ruling has length zero, but for the rounding of M*"), zero && first) << branch;
      EXPECT_EQ(told("the last ruling has length zero, but for the rounding of M*"), zero && !first) << branch;
      EXPECT_EQ(told("the last ruling is off vb by at most"), !(zero && !first)) << branch;
    }
  }
}

/// Over the knots 0, r, 2, 3 the heights 0, D_0, D_0 + D_1, 1 with D_0 = -1/3, D_2 = 7 / (9 - 3r) and
/// D_1 = (2 - r) D_2 - 1 make the polynomial M^2 - 2: F is -2 at 0, 2 at 2 and 7 at 3. With r = p/q from
/// p^2 - 2q^2 = 1 the branch sqrt 2 is within 2^-77 of the knot r, which 64 bits do not tell from it.
TEST_F(Construct, ABranchBesideAKnotIsToldFromIt) {
  std::int64_t p = 1, q = 1;
  for (int i = 1; i < 30; ++i) {
    const std::int64_t next = p + 2 * q;
    q += p;
    p = next;
  }
  ASSERT_EQ(Q(p) * Q(p) - Q(2) * Q(q) * Q(q), Q(1));
  const Q r = ratio<Q>(p, q);
  const Q d2 = Q(7) / (Q(9) - Q(3) * r);
  const Q d0 = ratio<Q>(-1, 3);
  const Q d1 = (Q(2) - r) * d2 - Q(1);
  const json points = {
      {"0", "0", "0"}, {"1", "0", d0.text()}, {"2", "1", (d0 + d1).text()}, {"3", "0", (d0 + d1 + d2).text()}};
  const json input = input_of("interpolate", {{"degree", 1},
                                              {"knots", {"0", r.text(), "2", "3"}},
                                              {"c", {{"points", points}}},
                                              {"va", {1, 0, 0}},
                                              {"vb", {0, 1, 0}},
                                              {"Lambda", 5}});
  const ProgramResult result = run(input, {"--branch", "2"});
  ASSERT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("branch 1: M* = -1.4142135623730951 (irrational)"));
  EXPECT_THAT(result.out, HasSubstr("branch 2: M* = 1.4142135623730951 (irrational)  <- written"));
  const RuledFile<Q> made = surface();
  EXPECT_FALSE((find_witness<Q, 3>(made.knots, made.c.points, made.d.points)));
}

TEST_F(Construct, ParallelAndMeetingEndRulings) {
  EXPECT_EQ(run(input_of("interpolate", {{"va", {1, 0, 2}}, {"vb", {-2, 0, -4}}, {"Lambda", 7}})).exit, 0);
  EXPECT_EQ(checked()["direction"], json({"1", "0", "2"}));
  // Both rulings pass through (1, 2, 3).
  EXPECT_EQ(run(input_of("interpolate", {{"va", {1, 2, 3}}, {"vb", {-2, 1, 2}}, {"Lambda", "2/3"}})).exit, 0);
  EXPECT_EQ(checked()["vertex"], json({"1", "2", "3"}));
}

TEST_F(Construct, WrongInputsAreNamedAndLeaveNoFile) {
  const json free{{"Lambda", 7}, {"M", 5}, {"d0", {1, 2, 3}}};
  const auto changed = [&](const std::string& method, const json& more) {
    json members = free;
    if (!more.is_null()) members.update(more);
    return input_of(method, members);
  };
  expect_refused(changed("bspline", {{"M", 1}}), ": M (line 1, column ");
  expect_refused(changed("bspline", {{"M", 0}}), "expected a value that is not a knot");
  expect_refused(changed("bspline", {{"degree", 3}}), "c.points (line 1, column ");
  expect_refused(changed("bspline", {{"knots", {0, 1, "1/2", 2}}}), "knots[2] (line 1, column ");
  expect_refused(changed("bspline", {{"sigma", 2}}), "found \"sigma\"");
  expect_refused(changed("bezier", {{"knots", {0, 0, 1, 1}}}), "found \"knots\"");
  expect_refused(changed("rational", {{"omega0", 1}}), "expected the key \"sigma\"");
  expect_refused(changed("rational", {{"omega0", 1}, {"sigma", 0}}), ": sigma (line 1");
  expect_refused(changed("rational", {{"omega0", 0}, {"sigma", 1}}), ": omega0 (line 1");
  expect_refused(changed("rational", {{"omega0", "-1/4"}, {"sigma", 1}}),
                 "d.weights[1]: the result has a control point at infinity");
  expect_refused(changed("cylinder", {}), ": Lambda (line 1");
  expect_refused(input_of("cylinder", {{"d0", {1, 2, 3}}, {"Lambda", 3}}), "expected M beside it, found no M");
  expect_refused(input_of("cone", {{"d0", {1, 2, 3}}, {"Lambda", 1}}), ": Lambda (line 1");
  expect_refused(input_of("cone", {{"d0", {1, 2}}, {"Lambda", 2}}), ": d0 (line 1");
  expect_refused(input_of("tangent", {{"c", {{"points", quartic}}}, {"knots", {0, 0, 1, 1, 2, 2}}}),
                 "a jump of it at u = 1");
  expect_refused(input_of("interpolate", {{"va", {0, 0, 0}}, {"vb", {1, 0, 0}}, {"Lambda", 1}}), ": va (line 1");
  expect_refused(input_of("interpolate", {{"va", {1, 0, 0}}, {"vb", {0, 0, 0}}, {"Lambda", 2}}), ": vb (line 1");
  expect_refused(input_of("interpolate", {{"va", {1, 2, 3}}, {"vb", {-2, 1, 2}}, {"Lambda", 1}}), ": Lambda (line 1");
  expect_refused(input_of("interpolate", {{"va", {1, 2, 3}}, {"vb", {-3, -1, -1}}, {"Lambda", 2}}),
                 "meet in an end point");
  expect_refused(
      input_of("interpolate", {{"va", {1, 0, 2}}, {"vb", {0, 1, -1}}, {"Lambda", 2}, {"knots", {0, 1, 2, 3}}}),
      ": knots (line 1");
}

const json cubic = json::parse("[[0,0,0],[1,3,6],[2,-1,1],[5,2,2]]");

json directrix_of(const json& a, const json& b, const json& more = {}) {
  json members{{"degree", 3}, {"c", {{"points", cubic}}}, {"a", a}, {"b", b}};
  if (!more.is_null()) members.update(more);
  return input_of("directrix", members);
}

/// A curve over uniform knots.
json long_input(const std::string& method, int degree, int count, const json& more) {
  json input = input_of(method, more);
  input["degree"] = degree;
  input["c"]["points"] = input["knots"] = json::array();
  for (long i = 0; i < count; ++i) input["c"]["points"].push_back({i, i * i % 7, i % 11 * i % 11 * i % 11});
  for (int i = 0; i < count + degree - 1; ++i) input["knots"].push_back(i);
  return input;
}

TEST_F(Construct, RowsThatGrowBeyondWhatAFileHoldsAreRefused) {
  const json free{{"Lambda", -1}, {"M", "1e-100"}, {"d0", {0, 0, 1}}};
  expect_refused(long_input("bspline", 3, 2000, free), "c.points");
  expect_refused(long_input("bspline", 3, 2000, free), "a second row of at most 134217728 bits, found numbers");
  expect_refused(long_input("tangent", 100, 1101, nullptr),
                 "at most 100000 control points, found Bezier pieces with 100101");
}

// a = 2, b = u (ZW06.16): the edge of regression is the curve of the running means (c_0 + ... + c_i)/(i+1).
TEST_F(Construct, DirectrixWithOneSolution) {
  const ProgramResult result = run(directrix_of({"2"}, {0, 1}));
  ASSERT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("one solution"));
  EXPECT_THAT(result.out, HasSubstr("edge of regression c - b tau, of degree 4"));
  EXPECT_EQ(net()["c"]["points"].size(), 4U);
  // tau = m' with m = (0,0,0), (1/2,3/2,3), (1,2/3,7/3), (2,1,9/4): 3 (m_1 - m_0) and 3 (m_3 - m_2) at the ends.
  EXPECT_EQ(net()["d"]["points"][0], json({"3/2", "9/2", "9"}));
  EXPECT_EQ(net()["d"]["points"][3], json({"8", "3", "7/4"}));
  EXPECT_EQ(checked()["class"], "tangent");
}

TEST_F(Construct, DirectrixWithAConeSaysItsVertex) {
  const ProgramResult result = run(directrix_of({1, 1}, {"0", "1/2", 1}));  // a = b' = 1, b = u: vertex c_0
  ASSERT_EQ(result.exit, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("a = b': a cone with vertex (0, 0, 0)"));
  EXPECT_EQ(checked()["vertex"], json({"0", "0", "0"}));
}

// a + 3 b' = 0 (ZW06.20 with rho = 2, sigma = 1/2): kappa = (1 - u/2)^3.
TEST_F(Construct, DirectrixWithAFamily) {
  const json a{"3/2"};
  const json b{1, "1/2"};
  expect_refused(directrix_of(a, b), "kappa with the Bernstein coefficients [1, 1/2, 1/4, 1/8]");
  expect_refused(directrix_of(a, b, {{"d0", {1, 2, 3}}, {"v", {1, 2, 3}}}), ": v (line 1");
  for (const char* key : {"d0", "v"}) {  // c_0 = 0, so that both mean the same
    ASSERT_EQ(run(directrix_of(a, b, {{key, {1, 2, 3}}})).exit, 0);
    // d_{i+1} = 2 c_{i+1} - c_i + (d_i - c_i) / 2
    EXPECT_EQ(net()["d"]["points"][0], json({"1", "2", "3"}));
    EXPECT_EQ(net()["d"]["points"][1], json({"5/2", "7", "27/2"}));
    EXPECT_EQ(net()["d"]["points"][2], json({"15/4", "-3", "-1/4"}));
  }
}

TEST_F(Construct, DirectrixWhoseFamilyKeepsTheFirstRuling) {
  // a = -1, b = u needs c''(0) = 0; kappa = u.
  const json c{{"points", json::parse("[[1,1,1],[2,2,3],[3,3,5],[7,0,1]]")}};
  const json more{{"c", c}};
  expect_refused(directrix_of({-1}, {0, 1}, {{"c", c}, {"d0", {5, 5, 5}}}), ": d0 (line 1");
  expect_refused(directrix_of({-1}, {0, 1}, more), "expected \"v\", found neither");
  ASSERT_EQ(run(directrix_of({-1}, {0, 1}, {{"c", c}, {"v", {6, 0, -3}}})).exit, 0);
  EXPECT_EQ(net()["d"]["points"][0], json({"-2", "-2", "-5"}));  // c_0 - c'(0)
  EXPECT_TRUE(checked()["developable"]);
}

TEST_F(Construct, DirectrixWithoutSolutionOrChoice) {
  expect_refused(directrix_of({1, 4}, {1, 0, 3}), "add up to 0 = (", 1);
  expect_refused(directrix_of({-1}, {0, 1}), "no rulings: equation j compares the coefficients of B_j of degree 3", 1);
  // With a = -1, b = u only c''(0) = 0 has solutions; here 6 (c_0 - 2 c_1 + c_2) = (0, -42, -66), a third of which is
  // what the first two coefficients of degree 3 differ by.
  expect_refused(directrix_of({-1}, {0, 1}), "-1 times equation 0, 1 times equation 1\nadd up to 0 = (0, -14, -22)\n",
                 1);
  expect_refused(directrix_of({2}, {0, 1}, {{"d0", {1, 2, 3}}}), "there is nothing to choose");
  expect_refused(directrix_of({0, 0}, {0}), ": a (line 1");
  expect_refused(directrix_of(json::array(), {1}), "expected 1 to 101 Bernstein coefficients");
  expect_refused(directrix_of({1}, {1}, {{"knots", {0, 0, 0, 1, 1, 1}}}), "found \"knots\"");
}

TEST_F(Construct, NoBranchIsNoSolution) {
  // The only root of the polynomial of this curve is the knot 1, since c_0 c_1 is in the plane of the end directions.
  expect_refused(input_of("interpolate", {{"va", {1, 0, 2}}, {"vb", {0, 1, -1}}, {"Lambda", 2}}), "no branch", 1);
}

TEST_F(Construct, MethodsAgreeWithTheFile) {
  spill(scratch / "in.json", input_of("tangent", {}).dump());
  const std::string in = (scratch / "in.json").string();
  EXPECT_EQ(run_program({"construct", "bspline", in, "-o", output()}).exit, 2);
  const ProgramResult typo = run_program({"construct", "tangnet", in, "-o", output()});
  EXPECT_EQ(typo.exit, 2);
  EXPECT_THAT(typo.err, HasSubstr("did you mean tangent?"));
  EXPECT_EQ(run_program({"construct", "directrix", in, "-o", output()}).exit, 2);  // the file's method is another
  EXPECT_EQ(run_program({"construct", "tangent", in}).exit, 2);
  EXPECT_FALSE(written());
}

TEST_F(Construct, OutputsThatCannotBeWritten) {
  spill(scratch / "in.json", input_of("tangent", {}).dump());
  const std::string in = (scratch / "in.json").string();
  for (const std::string& out : {scratch.path().string(), std::string("/dev/full"), (scratch / "no/out").string()}) {
    EXPECT_EQ(run_program({"construct", "tangent", in, "-o", out}).exit, 2) << out;
  }
  const ProgramResult result = run_program({"construct", "tangent", in, "-o", "-"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(json::parse(result.out)["type"], "ruled");
}

}  // namespace
}  // namespace torse::testing
