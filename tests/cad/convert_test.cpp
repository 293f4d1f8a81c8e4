// torse convert to STEP and IGES through the real program: every double comes back, the flag has its certificate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "cad/iges_text.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Rows = std::vector<std::vector<double>>;

std::string hex(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "\"%a\"", x);
  return buffer;
}

std::string list_text(const std::vector<double>& list) {
  std::string text;
  for (double x : list) text += (text.empty() ? "" : ",") + hex(x);
  return '[' + text + ']';
}

/// A surface in doubles and its file.
struct Net {
  int degree;
  std::vector<double> knots;
  Rows c, d;
  std::vector<double> c_weights, d_weights;

  std::string file() const {
    const auto row = [](const Rows& points, const std::vector<double>& weights) {
      std::string text;
      for (const std::vector<double>& x : points) text += (text.empty() ? "" : ",") + list_text(x);
      return "{\"points\": [" + text + "], \"weights\": " + list_text(weights) + "}";
    };
    return "{\"torse\": 1, \"type\": \"ruled\", \"degree\": " + std::to_string(degree) +
           ", \"knots\": " + list_text(knots) + ", \"c\": " + row(c, c_weights) + ", \"d\": " + row(d, d_weights) + "}";
  }
};

std::vector<double> doubles(const std::vector<Rational>& list) {
  std::vector<double> result;
  for (const Rational& x : list) {
    EXPECT_EQ(Rational::from_double(x.to_double()), x);
    result.push_back(x.to_double());
  }
  return result;
}

Rows doubles(const std::vector<Vec<Rational, 3>>& points) {
  Rows rows;
  for (const Vec<Rational, 3>& x : points) rows.push_back(doubles(std::vector<Rational>{x[0], x[1], x[2]}));
  return rows;
}

void expect_net(const cli::Face& face, const Net& net) {
  ASSERT_TRUE(face.surface) << face.remark;
  EXPECT_EQ(face.surface->knots.degree(), net.degree);
  EXPECT_EQ(doubles(face.surface->knots.list()), net.knots);
  EXPECT_EQ(doubles(face.surface->c.points), net.c);
  EXPECT_EQ(doubles(face.surface->d.points), net.d);
  EXPECT_EQ(doubles(face.surface->c.weights), net.c_weights);
  EXPECT_EQ(doubles(face.surface->d.weights), net.d_weights);
}

/// Numbers with all their digits, of sizes from 1e-6 to 1e6.
Net random_net(unsigned seed, bool rational) {
  std::mt19937_64 rng(seed);
  const auto draw = [&] {
    const double digits = static_cast<double>(rng() >> 11) * 0x1p-53 - 0.5;
    return digits * std::pow(10, static_cast<int>(rng() % 13) - 6);
  };
  Net net{3, {0.1, 0.1, 0.1, 1.0 / 3, 0.7, 0.7, 0.7}, {}, {}, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}};
  for (int i = 0; i < 5; ++i) {
    net.c.push_back({draw(), draw(), draw()});
    net.d.push_back({draw(), draw(), draw()});
  }
  if (rational) {
    for (double& w : net.c_weights) w = 0.5 + static_cast<double>(rng() >> 11) * 0x1p-53;
    net.d_weights[2] = 1.0 / 3;
  }
  return net;
}

/// A plane: every net in it is exactly developable.
const Net plane{1, {0, 1}, {{0, 0, 0}, {0.1, 0, 0}}, {{0, 1, 0}, {0.3, 7, 0}}, {1, 1}, {1, 1}};

/// A cone with its vertex in thirds, which doubles do not hold.
const std::string thirds = R"({"torse": 1, "type": "ruled", "degree": 2,
 "c": {"points": [[0,0,0],["5/3",1,0],[3,0,0]]}, "d": {"points": [["1/9",0,"1/3"],["2/3","1/3","1/3"],["10/9",0,"1/3"]]}})";

class ConvertCad : public ::testing::Test {
 public:
  ProgramResult convert(const std::string& text, const std::string& out, std::vector<std::string> options = {}) const {
    spill(scratch / "port side.json", text);
    options.insert(options.begin(), {"convert", (scratch / "port side.json").string(), "-o", path(out)});
    return run_program(options);
  }
  json report(const std::string& text, const std::string& out, std::vector<std::string> options = {}) const {
    options.insert(options.end(), {"--json", "-"});
    const ProgramResult result = convert(text, out, std::move(options));
    EXPECT_EQ(result.exit, 0) << result.err;
    return json::parse(result.out).at("surfaces").at(0);
  }
  std::vector<cli::Face> faces(const std::string& name) const { return cli::read_faces(path(name), ""); }
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  Scratch scratch;
};

TEST_F(ConvertCad, EveryDoubleComesBack) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    for (bool rational : {false, true}) {
      const Net net = random_net(seed, rational);
      for (const char* out : {"a.step", "a.igs"}) {
        SCOPED_TRACE(out);
        EXPECT_EQ(report(net.file(), out).at("rounded").at("changed"), 0);
        const std::vector<cli::Face> read = faces(out);
        ASSERT_EQ(read.size(), 1U);
        EXPECT_EQ(read[0].name, "port side");
        EXPECT_FALSE(read[0].cad->trimmed);
        expect_net(read[0], net);
      }
    }
  }
}

/// The numbers of all entities of a type of an IGES text, by columns and commas alone.
std::vector<std::vector<double>> entities_of(const std::string& text, int type) {
  std::istringstream lines(text);
  std::string parameters;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() >= 73 && line[72] == 'P') parameters += line.substr(0, 64);
  }
  std::vector<std::vector<double>> found;
  std::istringstream entities(parameters);
  for (std::string entity; std::getline(entities, entity, ';');) {
    std::istringstream fields(entity);
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::strtod(field.c_str(), nullptr));
    if (numbers[0] == type) found.push_back(std::move(numbers));
  }
  return found;
}

std::vector<std::vector<double>> curves_of(const std::string& text) { return entities_of(text, 126); }

/// Field 20 of the global section, which begins with the usual separators.
TEST_F(ConvertCad, IgesNamesItsLargestCoordinate) {
  const Net net{1, {0, 1}, {{-5, -1, 0}, {-3, -1, 0}}, {{-5, -1, 2}, {-3, -1, 2}}, {1, 1}, {1, 1}};
  report(net.file(), "a.igs");
  std::istringstream lines(slurp(path("a.igs")));
  std::string global;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() >= 73 && line[72] == 'G') global += line.substr(0, 72);
  }
  std::vector<std::string> fields;
  std::istringstream list(global);
  for (std::string field; std::getline(list, field, ',');) fields.push_back(field);
  ASSERT_GT(fields.size(), 19U);
  EXPECT_EQ(std::strtod(fields[19].c_str(), nullptr), 5) << global;
}

TEST_F(ConvertCad, IgesHoldsTwoCurvesOfEqualKnots) {
  const Net net = random_net(9, true);
  report(net.file(), "a.igs");
  const std::vector<std::vector<double>> curves = curves_of(slurp(path("a.igs")));
  ASSERT_EQ(curves.size(), 2U);
  for (const std::vector<double>& curve : curves) {
    EXPECT_EQ((std::vector<double>(curve.begin(), curve.begin() + 3)), (std::vector<double>{126, 4, 3}));
    EXPECT_EQ((std::vector<double>(curve.begin() + 7, curve.begin() + 16)),
              (std::vector<double>{0.1, 0.1, 0.1, 0.1, 1.0 / 3, 0.7, 0.7, 0.7, 0.7}));
  }
  const auto part = [&](std::size_t i, int from, int to) {
    return std::vector<double>(curves[i].begin() + from, curves[i].begin() + to);
  };
  EXPECT_EQ(part(0, 16, 21), net.c_weights);
  EXPECT_EQ(part(1, 16, 21), net.d_weights);
  EXPECT_EQ(part(0, 21, 24), net.c[0]);
  EXPECT_EQ(part(1, 33, 36), net.d[4]);
}

/// The second of a curve's four flags; the first rail comes back to its beginning, the second one does not.
TEST_F(ConvertCad, IgesTellsWhichCurvesAreClosed) {
  Net net = random_net(9, true);
  net.c.back() = net.c.front();
  report(net.file(), "a.igs");
  const std::vector<std::vector<double>> curves = curves_of(slurp(path("a.igs")));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0][4], 1);
  EXPECT_EQ(curves[1][4], 0);
}

TEST_F(ConvertCad, AFileThatStatesNoToleranceGetsOne) {
  for (const auto& [stated, kept] : {std::pair("1.E-05", 1e-5), std::pair("0.0000", 1e-7)}) {
    IgesText iges;
    iges.ruled(iges.line("0.,0.,0.", "1.,0.,0."), iges.line("0.,1.,0.", "1.,1.,0."), 0, 1, {.form = 1});
    std::string text = iges.file();
    text.replace(text.find("1.E-05"), 6, stated);
    spill(path("part.igs"), text);
    ASSERT_EQ(run_program({"convert", path("part.igs"), "-o", path("a.igs")}).exit, 0);
    EXPECT_EQ(faces("a.igs")[0].cad->tolerance, kept);
  }
}

TEST_F(ConvertCad, TheFlagNeedsACertificate) {
  const json exact = report(plane.file(), "a.igs");
  EXPECT_EQ(exact.at("developable"), true);
  EXPECT_EQ(exact.at("developable_flag"), true);
  EXPECT_EQ(faces("a.igs")[0].cad->claimed_developable, true);
  // Two curves, the second in the first one's direction, then the flag.
  const auto flags = [&](const char* file) {
    const std::vector<double> ruled = entities_of(slurp(path(file)), 118).at(0);
    return std::vector<double>(ruled.begin() + 3, ruled.begin() + 5);
  };
  EXPECT_EQ(flags("a.igs"), (std::vector<double>{0, 1}));

  const json rounded = report(thirds, "b.igs");
  EXPECT_GT(rounded.at("rounded").at("changed"), 0);
  EXPECT_EQ(rounded.at("developable"), false);
  EXPECT_EQ(rounded.at("developable_flag"), false);
  EXPECT_GT(rounded.at("max_warp_deg").at("lo"), 0.0);
  EXPECT_LT(rounded.at("max_warp_deg").at("hi"), 1e-12);
  EXPECT_EQ(faces("b.igs")[0].cad->claimed_developable, false);
  EXPECT_EQ(flags("b.igs"), (std::vector<double>{0, 0}));

  EXPECT_EQ(report(thirds, "c.igs", {"--max-warp", "1e-9"}).at("developable_flag"), true);
  EXPECT_EQ(report(thirds, "d.igs", {"--max-warp", "1e-30"}).at("developable_flag"), false);
  EXPECT_EQ(faces("c.igs")[0].cad->claimed_developable, true);
  EXPECT_EQ(faces("d.igs")[0].cad->claimed_developable, false);

  const auto claim = [&](const char* file, const std::vector<std::string>& limit) {
    std::vector<std::string> words{"check", path(file), "--json", "-"};
    words.insert(words.end(), limit.begin(), limit.end());
    return json::parse(run_program(words).out).at("surfaces").at(0).at("claim");
  };
  EXPECT_EQ(claim("c.igs", {}), "false");  // exactly it is not
  EXPECT_EQ(claim("c.igs", {"--max-warp", "1e-9"}), "true");
  EXPECT_EQ(claim("d.igs", {}), "none");
  EXPECT_EQ(claim("d.igs", {"--max-warp", "1e-9"}), "unclaimed");
}

TEST_F(ConvertCad, WhatIsReportedIsWhatCheckFinds) {
  for (const char* out : {"a.step", "a.igs"}) {
    const json written = report(thirds, out);
    const json checked = json::parse(run_program({"check", path(out), "--json", "-"}).out).at("surfaces").at(0);
    EXPECT_EQ(written.at("developable"), checked.at("developable"));
    EXPECT_EQ(written.at("max_warp_deg"), checked.at("max_warp_deg"));
  }
}

TEST_F(ConvertCad, UnitsAreWrittenAndConvertedExactly) {
  for (const char* out : {"a.step", "a.igs"}) {
    SCOPED_TRACE(out);
    report(plane.file(), out, {"--unit", "in"});
    const cli::Face inches = faces(out)[0];
    EXPECT_EQ(inches.cad->unit, "inch");
    expect_net(inches, plane);
    const std::string second = std::string("mm-") + out;
    ASSERT_EQ(run_program({"convert", path(out), "-o", path(second), "--unit", "mm"}).exit, 0);
    const cli::Face millimetres = faces(second)[0];
    EXPECT_EQ(millimetres.cad->unit, "mm");
    // 25.4 times the double 0.1, rounded once.
    const Rational exact = Rational::from_text("127/5") * Rational::from_double(0.1);
    EXPECT_EQ(millimetres.surface->c.points[1][0], Rational::from_double(exact.to_double()));
  }
}

TEST_F(ConvertCad, EveryUnitComesBack) {
  for (const char* unit : {"mm", "cm", "m", "km", "um", "ft", "mil", "uin"}) {
    for (const char* out : {"a.step", "a.igs"}) {
      SCOPED_TRACE(std::string(unit) + ' ' + out);
      report(plane.file(), out, {"--unit", unit});
      const cli::Face face = faces(out)[0];
      EXPECT_EQ(face.cad->unit, unit);
      expect_net(face, plane);
    }
  }
}

TEST_F(ConvertCad, SeveralFacesKeepNamesAndTolerance) {
  IgesText iges(6);
  for (const char* name : {"port", "a face's \"name\""}) {
    const int c = iges.bezier(1, "1.,1.", "0.1,0.,0.,1.,0.,0.");
    const int d = iges.bezier(1, "1.,1.", "0.,1.,0.,1.,1.,0.25");
    iges.ruled(c, d, 0, 0, {.form = 1, .label = std::string(name).substr(0, 8)});
  }
  const int uneven = iges.bezier(2, "1.,1.,1.", "0.,0.,9.,1.,0.,9.,9.,0.,9.");
  const int even = iges.bezier(1, "1.,1.", "0.,1.,9.,1.,1.,9.");
  iges.ruled(uneven, even, 0, 0, {.form = 0, .label = "BY ARCS"});
  spill(scratch / "in.igs", iges.file());
  const std::vector<cli::Face> before = faces("in.igs");
  for (const char* out : {"a.step", "a.igs"}) {
    SCOPED_TRACE(out);
    const ProgramResult result = run_program({"convert", path("in.igs"), "-o", path(out)});
    ASSERT_EQ(result.exit, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("BY ARCS: not ruled, left out: "));
    const std::vector<cli::Face> after = faces(out);
    ASSERT_EQ(after.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(after[i].name, before[i].name);
      EXPECT_EQ(after[i].cad->unit, "m");
      EXPECT_DOUBLE_EQ(after[i].cad->tolerance, before[i].cad->tolerance);
      EXPECT_EQ(doubles(after[i].surface->c.points), doubles(before[i].surface->c.points));
    }
  }
  EXPECT_THAT(run_program({"convert", path("in.igs"), "-o", path("a.json")}).err, HasSubstr("choose it by --face"));
  EXPECT_EQ(run_program({"convert", path("in.igs"), "-o", path("a.json"), "--face", "port"}).exit, 0);
}

TEST_F(ConvertCad, AConeToItsVertexIsAFace) {
  const std::string cone = R"({"torse": 1, "type": "ruled", "degree": 2,
 "c": {"points": [[0,0,0],[2,3,0],[4,0,0]]}, "d": {"points": [[1,1,8],[1,1,8],[1,1,8]]}})";
  for (const char* out : {"a.step", "a.igs"}) {
    EXPECT_EQ(report(cone, out).at("developable"), true);
    const json checked = json::parse(run_program({"check", path(out), "--json", "-"}).out).at("surfaces").at(0);
    EXPECT_EQ(checked.at("class"), "cone");
  }
}

TEST_F(ConvertCad, LooseKnotsAreClampedExactly) {
  // The uniform quadratic c_0, c_1, c_2 on knots 0..3 is, on [1, 2], the Bezier curve (c_0+c_1)/2, c_1, (c_1+c_2)/2.
  const Net loose{2,         {0, 1, 2, 3}, {{0, 0, 0}, {2, 4, 0}, {8, 0, 0}}, {{0, 0, 1}, {2, 4, 1}, {8, 0, 1}},
                  {1, 1, 1}, {1, 1, 1}};
  const Net clamped{2,         {1, 1, 2, 2}, {{1, 2, 0}, {2, 4, 0}, {5, 2, 0}}, {{1, 2, 1}, {2, 4, 1}, {5, 2, 1}},
                    {1, 1, 1}, {1, 1, 1}};
  for (const char* out : {"a.step", "a.igs"}) {
    EXPECT_EQ(report(loose.file(), out).at("rounded").at("changed"), 0);
    expect_net(faces(out)[0], clamped);
  }
}

TEST_F(ConvertCad, ErrorsLeaveTheOldFile) {
  const auto error = [&](const Net& bad, const std::string& out) {
    spill(scratch / out, "old");
    const ProgramResult result = convert(bad.file(), out);
    EXPECT_EQ(result.exit, 2);
    EXPECT_EQ(slurp(scratch / out).substr(0, 12), "old");
    EXPECT_THAT(result.err, HasSubstr("replay: torse convert"));
    return result.err;
  };
  Net net = random_net(1, true);
  net.c_weights[1] = -1;
  EXPECT_THAT(error(net, "a.step"), HasSubstr("c.weights: have both signs"));
  for (double& w : net.c_weights) w = -1;
  EXPECT_EQ(report(net.file(), "b.step").at("rounded").at("changed"), 0);

  net = plane;
  net.d_weights[1] = std::nextafter(1, 2);
  EXPECT_THAT(error(net, "a.step"), HasSubstr("differ in their last digits"));

  net = {26,
         std::vector<double>(52, 0),
         Rows(27, {0, 0, 0}),
         Rows(27, {0, 1, 0}),
         std::vector<double>(27, 1),
         std::vector<double>(27, 1)};
  for (std::size_t i = 0; i < 27; ++i) net.c[i][0] = net.d[i][0] = static_cast<double>(i);
  for (std::size_t i = 26; i < 52; ++i) net.knots[i] = 1;
  EXPECT_THAT(error(net, "a.step"), HasSubstr("its degree is 26; OpenCASCADE has 25 at most"));
  EXPECT_EQ(report(net.file(), "b.igs").at("developable"), true);

  const std::string far = R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[0,0,0],["1e400",0,0]]},
    "d": {"points": [[0,1,0],[1,1,0]]}})";
  EXPECT_THAT(convert(far, "a.step").err, HasSubstr("points: are beyond the range of double"));
  const std::string close = R"({"torse": 1, "type": "ruled", "degree": 1, "knots": [0, 1, "1.00000000000000000001", 2],
    "c": {"points": [[0,0,0],[1,0,0],[2,0,0],[3,0,0]]}, "d": {"points": [[0,1,0],[1,1,0],[2,1,0],[3,1,0]]}})";
  EXPECT_THAT(convert(close, "a.igs").err, HasSubstr("knots[2]: expected a knot at most 1 times"));
}

}  // namespace
}  // namespace torse::testing
