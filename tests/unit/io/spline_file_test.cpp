// Splines as JSON: what is read is what stands there, writing and reading gives it back, broken members are named.
#include "torse/io/spline_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/construct_file.hpp"
#include "torse/io/limits.hpp"

namespace torse {
namespace {

using Q = Rational;

constexpr const char* ruled_text = R"({"torse": 1, "type": "ruled", "degree": 2,
 "knots": [0, 0, "2/3", 1, 1],
 "c": {"points": [[0, 0, 0], ["3/2", 1, 0], [0.5, "0x1.8p-3", 1e-30], [3, 1, 0]], "weights": [1, "3/5", -2, 1]},
 "d": {"points": [[0, 0, 1], [1, 1, 1], [2, 0, 1], [3, 1, 1]]}})";

Q q(const char* text) { return Q::from_text(text); }

/// The text with one piece of it replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// "place: reason" of the error that a reader gives.
template <class Reader>
std::string error_of(const std::string& text, Reader read) {
  try {
    read(Document("f", text));
  } catch (const FileError& error) {
    return error.place() + ": " + error.reason();
  }
  return "no error";
}

std::string ruled_error(const std::string& from, const std::string& to) {
  return error_of(with(ruled_text, from, to), [](const Document& document) { read_ruled<Q>(document); });
}

template <class T>
void expect_same_nets(const T& a, const T& b) {
  EXPECT_EQ(a.weights, b.weights);
  EXPECT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_TRUE(a.points[i] == b.points[i]) << i;
}

TEST(RuledFile, HoldsTheExactValues) {
  const Document document("f", ruled_text);
  const RuledFile<Q> ruled = read_ruled<Q>(document);
  EXPECT_EQ(ruled.knots.degree(), 2);
  EXPECT_EQ(ruled.knots.list(), (std::vector<Q>{q("0"), q("0"), q("2/3"), q("1"), q("1")}));
  EXPECT_EQ(ruled.c.points[1][0], q("3/2"));
  EXPECT_EQ(ruled.c.points[2][0], q("1/2"));
  EXPECT_EQ(ruled.c.points[2][1], q("3/16"));
  EXPECT_EQ(ruled.c.points[2][2], q("1/1000000000000000000000000000000"));
  EXPECT_EQ(ruled.c.weights, (std::vector<Q>{q("1"), q("3/5"), q("-2"), q("1")}));
  EXPECT_EQ(ruled.d.weights, std::vector<Q>(4, q("1")));
  EXPECT_FALSE(unit_weights(ruled.c));
  EXPECT_TRUE(unit_weights(ruled.d));
}

TEST(RuledFile, ComesBackFromItsText) {
  const RuledFile<Q> ruled = read_ruled<Q>(Document("f", ruled_text));
  const std::string text = write_ruled(ruled);
  const RuledFile<Q> again = read_ruled<Q>(Document("g", text));
  EXPECT_EQ(again.knots.list(), ruled.knots.list());
  EXPECT_EQ(again.knots.degree(), ruled.knots.degree());
  expect_same_nets(again.c, ruled.c);
  expect_same_nets(again.d, ruled.d);
  EXPECT_EQ(write_ruled(again), text);
}

TEST(RuledFile, TheCadListIsThePapersListWithOneMoreAtEitherEnd) {
  const RuledFile<Q> cad =
      read_ruled<Q>(Document("f", with(ruled_text, "[0, 0, \"2/3\", 1, 1]", "[-7, 0, 0, \"2/3\", 1, 1, 9]")));
  EXPECT_EQ(cad.knots.list(), read_ruled<Q>(Document("f", ruled_text)).knots.list());
}

TEST(RuledFile, NoKnotsAreOneBezierPiece) {
  EXPECT_EQ(ruled_error("\"knots\": [0, 0, \"2/3\", 1, 1],", ""),
            "c.points: expected 3 control points for degree 2 without knots, found an array of 4");
  const Document bezier(
      "f", with(with(ruled_text, "\"knots\": [0, 0, \"2/3\", 1, 1],", ""), "\"degree\": 2", "\"degree\": 3"));
  EXPECT_EQ(read_ruled<Q>(bezier).knots.list(), (std::vector<Q>{Q(0), Q(0), Q(0), Q(1), Q(1), Q(1)}));
}

TEST(RuledFile, ARailHasTwoPointsAtLeast) {
  const std::string one = R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": [[0, 0, 0]]},
 "d": {"points": [[0, 0, 1]]}})";
  EXPECT_EQ(error_of(one, [](const Document& document) { read_ruled<Q>(document); }),
            "c.points: expected 2 to " + std::to_string(limits::points) + " control points, found an array of 1");
}

/// Not that the other row has more.
TEST(RuledFile, ARowWithoutPointsIsTheFault) {
  const std::string none = R"({"torse": 1, "type": "ruled", "degree": 1, "c": {"points": []},
 "d": {"points": [[0, 0, 1], [1, 0, 1]]}})";
  EXPECT_EQ(error_of(none, [](const Document& document) { read_ruled<Q>(document); }),
            "c.points: expected 2 to " + std::to_string(limits::points) + " control points, found an array of 0");
}

TEST(RuledFile, BrokenMembersAreNamed) {
  EXPECT_EQ(ruled_error("\"torse\": 1", "\"torse\": 2"), "torse: expected 1, found 2");
  EXPECT_EQ(ruled_error("\"torse\": 1, ", ""), ": expected the key \"torse\", found none");
  EXPECT_EQ(ruled_error("\"ruled\"", "\"curve\""), "type: expected \"ruled\", found \"curve\"");
  EXPECT_EQ(ruled_error("\"degree\": 2", "\"degree\": 1000000000"),
            "degree: expected an integer from 1 to 100, found 1000000000");
  EXPECT_EQ(ruled_error("\"degree\": 2", "\"degree\": 0"), "degree: expected an integer from 1 to 100, found 0");
  EXPECT_EQ(ruled_error("\"degree\": 2", "\"degree\": 2, \"colour\": 1"),
            "colour: expected one of the keys torse, type, degree, knots, c, d, found \"colour\"");
  EXPECT_EQ(ruled_error("\"weights\"", "\"wieghts\""),
            "c.wieghts: expected one of the keys points, weights, found \"wieghts\"");
  EXPECT_EQ(ruled_error("[0, 0, 1], ", ""),
            "d.points: expected 4 control points, as many as in c, found an array of 3");
  EXPECT_EQ(ruled_error("[0, 0, 1]", "[0, 0]"), "d.points[0]: expected three coordinates, found an array of 2");
  EXPECT_EQ(ruled_error("[0, 0, 1]", "[0, 0, \"1/0\"]"),
            "d.points[0][2]: expected a denominator that is not zero, found \"1/0\"");
  EXPECT_EQ(ruled_error("[0, 0, 1]", "[0, 0, null]"), "d.points[0][2]: expected a number, found null");
  EXPECT_EQ(ruled_error("\"3/5\", ", ""), "c.weights: expected 4 weights, one for each point, found an array of 3");
  EXPECT_EQ(ruled_error("\"3/5\"", "\"0/5\""), "c.weights[1]: expected a weight that is not zero, found \"0/5\"");
  EXPECT_EQ(ruled_error("\"points\": [[0, 0, 0]", "\"points\": 7, \"weights\": [[0, 0, 0]"),
            ": expected each key once, found \"weights\" again");
}

TEST(RuledFile, BrokenKnotsAreNamedByTheirIndexInTheFile) {
  const auto knots = [](const std::string& list) { return ruled_error("[0, 0, \"2/3\", 1, 1]", list); };
  EXPECT_EQ(
      knots("[0, 0, 1]"),
      "knots: expected 5 (papers' list) or 7 (CAD list) knots for degree 2 and 4 control points, found an array of 3");
  EXPECT_EQ(knots("[0, 0, 2, 1, 2]"), "knots[3]: expected a knot not below the one before it, found 1");
  EXPECT_EQ(knots("[0, 0, 0, 1, 1]"), "knots[2]: expected a knot at most 2 times (the degree), found it more often");
  EXPECT_EQ(knots("[0, 0, 0, 1, 1, 1, 1]"),
            "knots[5]: expected a knot at most 2 times (the degree), found it more often");
  EXPECT_EQ(knots("[1, 0, 0, 1, 2, 2, 2]"), "knots[1]: expected a knot not below the one before it, found 0");
  EXPECT_EQ(knots("[0, 0, 0, 1, 2, 2, 2]"), "no error");
}

TEST(CurveFile, ComesBackFromItsText) {
  const char* text =
      R"({"torse": 1, "type": "curve", "degree": 1, "knots": [0, 3], "points": [[1, 2, 3], [4, 5, "6/7"]], "weights": [1, 2]})";
  const CurveFile<Q> curve = read_curve<Q>(Document("f", text));
  const CurveFile<Q> again = read_curve<Q>(Document("g", write_curve(curve)));
  EXPECT_EQ(again.knots.list(), (std::vector<Q>{Q(0), Q(3)}));
  expect_same_nets(again.net, curve.net);
  EXPECT_EQ(curve.net.points[1][2], q("6/7"));
}

TEST(RailsFile, EachRailHasItsOwnDegreeAndKnots) {
  const char* text = R"({"torse": 1, "type": "rails", "c": {"degree": 1, "points": [[1, 2, 3], [4, 5, 6]]},
                         "d": {"degree": 2, "knots": [0, 0, 5, 5], "points": [[1, 2, 3], [4, 5, 6], [7, 8, 8]], "weights": [1, 2, 1]}})";
  const RailsFile<Q> rails = read_rails<Q>(Document("f", text));
  EXPECT_EQ(rails.c.knots.degree(), 1);
  EXPECT_EQ(rails.d.knots.list(), (std::vector<Q>{Q(0), Q(0), Q(5), Q(5)}));
  const RailsFile<Q> again = read_rails<Q>(Document("g", write_rails(rails)));
  expect_same_nets(again.d.net, rails.d.net);
  expect_same_nets(again.c.net, rails.c.net);
  const auto error = [&](const std::string& from, const std::string& to) {
    return error_of(with(text, from, to), [](const Document& document) { read_rails<Q>(document); });
  };
  EXPECT_EQ(error("\"degree\": 2, ", ""), "d: expected the key \"degree\", found none");
  EXPECT_EQ(error("[0, 0, 5, 5]", "[0, 0, 5, \"x\"]").substr(0, 11), "d.knots[3]:");
}

constexpr const char* construct_text = R"({"torse": 1, "type": "construct", "method": "rational", "degree": 1,
 "c": {"points": [[1, 2, 3], [4, 5, 6]], "weights": [2, 3]}, "Lambda": "1/2", "M": "-7/3", "sigma": 4, "d0": [7, 8, 9], "omega0": "5/6"})";

std::string construct_error(const std::string& from, const std::string& to) {
  return error_of(with(construct_text, from, to), [](const Document& document) { read_construct<Q>(document); });
}

TEST(ConstructFile, HoldsTheParameters) {
  const ConstructFile<Q> input = read_construct<Q>(Document("f", construct_text));
  EXPECT_EQ(input.method, "rational");
  EXPECT_EQ(input.lambda, q("1/2"));
  EXPECT_EQ(input.m, q("-7/3"));
  EXPECT_EQ(input.sigma, q("4"));
  EXPECT_EQ(input.omega0, q("5/6"));
  EXPECT_EQ((*input.d0)[2], q("9"));
  EXPECT_FALSE(input.va.has_value());
}

TEST(ConstructFile, EachMethodHasItsOwnKeys) {
  EXPECT_EQ(construct_error("\"sigma\": 4, ", ""), ": expected the key \"sigma\", found none");
  EXPECT_EQ(construct_error("\"sigma\": 4", "\"sigma\": 0"), "sigma: expected a value that is not zero, found 0");
  EXPECT_EQ(construct_error("\"rational\"", "\"bspline\""),
            "sigma: expected one of the keys torse, type, method, degree, c, Lambda, M, d0, knots, found \"sigma\"");
  EXPECT_EQ(construct_error("\"rational\"", "\"spline\""),
            "method: expected one of the methods bspline, bezier, rational, cylinder, cone, tangent, interpolate, "
            "directrix, found \"spline\"");
  EXPECT_EQ(construct_error("\"rational\"", "7"), "method: expected a string, found 7");
  const std::string tangent =
      R"({"torse": 1, "type": "construct", "method": "tangent", "degree": 1, "c": {"points": [[1, 2, 3], [4, 5, 6]], "weights": [1, 2]}})";
  EXPECT_EQ(error_of(tangent, [](const Document& document) { read_construct<Q>(document); }),
            "c.weights: expected weights 1 for the method tangent, found others");
}

TEST(ConstructFile, ReadsPolynomials) {
  const std::string text =
      R"({"torse": 1, "type": "construct", "method": "directrix", "degree": 1, "c": {"points": [[1, 2, 3], [4, 5, 6]]}, "a": [1, "2/3"], "b": [7], "v": [1, 0, 2]})";
  const ConstructFile<Q> input = read_construct<Q>(Document("f", text));
  EXPECT_EQ(input.a, (std::vector<Q>{q("1"), q("2/3")}));
  EXPECT_EQ(input.b, std::vector<Q>{q("7")});
  EXPECT_EQ((*input.v)[2], q("2"));
  EXPECT_FALSE(input.d0.has_value());
}

}  // namespace
}  // namespace torse
