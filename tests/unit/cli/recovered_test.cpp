// The edge of a surface from those of its spans.
#include "torse/cli/recovered.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "torse/cli/function_report.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/spline/piece_polynomials.hpp"

namespace torse::cli {
namespace {

using Q = Rational;

RationalPolynomial polynomial(std::initializer_list<int> coefficients) {
  std::vector<Q> list;
  for (const int c : coefficients) list.emplace_back(c);
  return RationalPolynomial(list);
}

/// The span between z -> (t, t^2, z) and its tangents' points at length 1, as rows of degree 4 over an interval.
RecoveredSpan tangents_of(const RationalPolynomial& z, const Q& begin, const Q& end) {
  const PolynomialRow<Q, 4> r{polynomial({1}), polynomial({0, 1}), polynomial({0, 0, 1}), z};
  PolynomialRow<Q, 4> d = r;
  for (RationalPolynomial& x : d) x = x + x.derivative();
  const auto piece =
      recover_piece<Q>(bezier_knots<Q>(4, begin, end), bezier_rows(r, 4, begin, end), bezier_rows(d, 4, begin, end), 1);
  return {piece, edge_of(piece)};
}

nlohmann::ordered_json edge_of_spans(const std::vector<RecoveredSpan>& spans) {
  RecoveredFace face{.face = {}, .replay = ""};
  face.judgement = Judgement{{SurfaceClass::tangent, std::nullopt, std::nullopt}, std::nullopt};
  face.spans = spans;
  return recovered_json(face)["edge"];
}

/// t^3 and t^3 + (t-1)^4, which have all derivatives up to the third in common at t = 1.
TEST(Recovered, DegreeOfTheEdgeIsThatOfItsHighestSpan) {
  const RecoveredSpan cubic = tangents_of(polynomial({0, 0, 0, 1}), Q(0), Q(1));
  const RecoveredSpan quartic = tangents_of(polynomial({1, -4, 6, -3, 1}), Q(1), Q(2));
  const RecoveredSpan cubic_again = tangents_of(polynomial({1, -4, 6, -3}), Q(2), Q(3));
  EXPECT_EQ(edge_of_spans({cubic})["degree"], 3);
  EXPECT_EQ(edge_of_spans({cubic, quartic})["degree"], 4);
  EXPECT_EQ(edge_of_spans({quartic, cubic_again})["degree"], 4);
  EXPECT_EQ(edge_of_spans({cubic, quartic, cubic_again})["v"], edge_of_spans({cubic})["v"]);
}

/// c is the edge of the one and d that of the other: v = 0 and v = 1.
TEST(Recovered, AnEdgeWhoseSpansDifferInVHasNone) {
  const RecoveredSpan one = tangents_of(polynomial({0, 0, 0, 1}), Q(0), Q(1));
  const auto swapped = recover_piece<Q>(bezier_knots<Q>(4), bezier_rows(one.piece.q, 4, Q(0), Q(1)),
                                        bezier_rows(one.piece.p, 4, Q(0), Q(1)), 1);
  const RecoveredSpan other{swapped, edge_of(swapped)};
  EXPECT_EQ(edge_of_spans({other})["v"], nlohmann::ordered_json::parse(R"({"num": [1], "den": [1]})"));
  EXPECT_TRUE(edge_of_spans({one, other})["v"].is_null());
  EXPECT_EQ(edge_of_spans({one, other})["degree"], 3);
}

/// Two spans with the same Lambda and M: on one line if sigma is the same too.
TEST(Recovered, SpansThatDifferInSigmaHaveALineEach) {
  const auto span = [](const Q& sigma, int begin) {
    const KnotList<Q> u = bezier_knots<Q>(2, Q(begin), Q(begin + 1));
    const auto row = [](int w, int x, int y, int z) { return Vec<Q, 4>(Q(w), Q(x), Q(y), Q(z)); };
    const std::vector<Vec<Q, 4>> p{row(1, 0, 0, 0), row(1, 2, 1, 0), row(1, 3, 3, 1)};
    const auto d = rational_net<Q, Vec<Q, 4>>(u, p, Q(7), Q(-5), sigma, row(1, 0, 1, 2));
    const auto piece = recover_piece<Q>(u, p, d, 1);
    return RecoveredSpan{piece, edge_of(piece)};
  };
  const auto lines = [](const std::vector<RecoveredSpan>& spans) {
    RecoveredFace face{.face = {}, .replay = ""};
    face.judgement = Judgement{{SurfaceClass::tangent, std::nullopt, std::nullopt}, std::nullopt};
    face.spans = spans;
    const std::string text = recovered_text(face);
    std::size_t count = 0;
    for (std::size_t at = text.find("t in ["); at != std::string::npos; at = text.find("t in [", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(lines({span(Q(2), 0), span(Q(3), 1)}), 2U);
  EXPECT_EQ(lines({span(Q(2), 0), span(Q(2), 1)}), 1U);
}

}  // namespace
}  // namespace torse::cli
