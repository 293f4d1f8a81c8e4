// Knot lists: counting in the papers' convention, the CAD convention, and every rejected list with the place named.
#include "torse/spline/knots.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "splines.hpp"
#include "support/refusal.hpp"

namespace torse::test {
namespace {

TEST(KnotList, CountsVerticesAndPieces) {
  const KnotList<Q> u = knots(3, {0, 0, 0, 2, 3, 5, 5, 5});
  EXPECT_EQ(u.degree(), 3);
  EXPECT_EQ(u.size(), 8);
  EXPECT_EQ(u.last(), 5);
  EXPECT_EQ(u.pieces(), 3);
  EXPECT_EQ(u.piece_begin(1), Q(0));
  EXPECT_EQ(u.piece_end(1), Q(2));
  EXPECT_EQ(u.piece_begin(3), Q(3));
  EXPECT_EQ(u.piece_end(3), Q(5));
  EXPECT_EQ(u.domain_begin(), Q(0));
  EXPECT_EQ(u.domain_end(), Q(5));
  EXPECT_EQ(u.clamped(), Truth::yes);
  EXPECT_EQ(knots(3, {0, 0, 1, 2, 2, 2, 3, 4, 4}).clamped(), Truth::no);
  EXPECT_EQ(knots(3, {0, 0, 0, 2, 3, 4, 4}).clamped(), Truth::no);
  EXPECT_EQ(knots(3, {0, 0, 1, 2, 4, 4, 4}).clamped(), Truth::no);
}

TEST(KnotList, KnowsItsEmptyPieces) {
  EXPECT_EQ(knots(3, {0, 0, 0, 2, 2, 3, 3, 3}).proper_pieces(), (std::vector<int>{1, 3}));
  EXPECT_EQ(knots(2, {0, 1, 1, 2, 3}).proper_pieces(), (std::vector<int>{2}));
  EXPECT_EQ(knots(2, {0, 1, 1, 2, 3}).piece_empty(1), Truth::yes);
}

TEST(KnotList, TakesAndGivesTheCadList) {
  const std::vector<Q> cad{Q(-1), Q(0), Q(0), Q(1), Q(2), Q(2), Q(7)};
  const KnotList<Q> u = KnotList<Q>::from_list(2, 3, cad);
  EXPECT_EQ(u.list(), (std::vector<Q>{Q(0), Q(0), Q(1), Q(2), Q(2)}));
  EXPECT_EQ(u.cad_list(), (std::vector<Q>{Q(0), Q(0), Q(0), Q(1), Q(2), Q(2), Q(2)}));
  EXPECT_EQ(KnotList<Q>::from_list(2, 3, u.list()).list(), u.list());
}

TEST(KnotList, BezierLists) {
  EXPECT_EQ(bezier_knots(2, Q(3), Q(7)).list(), (std::vector<Q>{Q(3), Q(3), Q(7), Q(7)}));
  EXPECT_EQ(bezier_knots<Q>(1).list(), (std::vector<Q>{Q(0), Q(1)}));
}

TEST(KnotList, RejectsBadListsAndNamesThePlace) {
  EXPECT_EQ(place_of([] { return knots(0, {0, 1}); }), "degree");
  EXPECT_EQ(place_of([] { return knots(3, {0, 0, 0, 1, 1}); }), "knots");
  EXPECT_EQ(place_of([] { return knots(2, {0, 2, 1, 3}); }), "knots[2]");
  EXPECT_EQ(place_of([] { return knots(2, {0, 1, 1, 1, 2}); }), "knots[3]");
  EXPECT_EQ(place_of([] { return knots(2, {0, 0, 0, 1}); }), "knots[2]");
  EXPECT_EQ(place_of([] { return knots(2, {0, 0, 1, 2, 2, 2}); }), "knots[5]");
  EXPECT_EQ(place_of([] { return knots(3, {0, 0, 1, 1, 2, 2}); }), "knots");  // the domain [1, 1]
  EXPECT_EQ(place_of([] { return KnotList<Q>::from_list(2, 3, {Q(0), Q(1)}); }), "knots");
  EXPECT_EQ(place_of([] { return KnotList<Q>::from_list(2, 2, {Q(5), Q(0), Q(1), Q(2), Q(3), Q(4)}); }), "knots[1]");
  EXPECT_EQ(place_of([] { return KnotList<Q>::from_list(2, 2, {Q(0), Q(0), Q(1), Q(2), Q(3), Q(1)}); }), "knots[5]");
  // Out of order with its neighbour, though not with the next one.
  EXPECT_EQ(place_of([] { return KnotList<Q>::from_list(2, 2, {Q(1), Q(0), Q(2), Q(3), Q(4), Q(5)}); }), "knots[1]");
  EXPECT_EQ(place_of([] { return KnotList<Q>::from_list(2, 2, {Q(0), Q(0), Q(1), Q(2), Q(4), Q(3)}); }), "knots[5]");
  EXPECT_EQ(place_of([] { return knots(2, {0, 0, 1, 1}); }), "");
}

/// A list as it is given to from_list, for degree 2 and control vertices 0..last.
KnotList<Q> given(int last, const std::vector<int>& list) {
  return KnotList<Q>::from_list(2, last, std::vector<Q>(list.begin(), list.end()));
}

TEST(KnotList, TellsWhichKnotsAreOutOfOrder) {
  const std::string rule = "expected a non-decreasing list, found ";
  EXPECT_EQ(told([] { return knots(2, {0, 2, 1, 3}); }), "knots[2]: " + rule + "1 after 2");
  EXPECT_EQ(told([] { return given(2, {5, 0, 1, 2, 3, 4}); }), "knots[1]: " + rule + "0 after 5");
  EXPECT_EQ(told([] { return given(2, {0, 0, 1, 2, 3, 1}); }), "knots[5]: " + rule + "1 after 3");
}

/// The first and the last knot of a CAD list are dropped, but they count in what is said of the others.
TEST(KnotList, CountsTheKnotsOfTheListThatWasGiven) {
  const std::string order = "expected a non-decreasing list, found ";
  const std::string often = "expected a knot at most 2 times, found ";
  EXPECT_EQ(told([] { return given(3, {0, 0, 0, 3, 2, 4, 5}); }), "knots[4]: " + order + "2 after 3");
  EXPECT_EQ(told([] { return given(3, {0, 0, 3, 2, 4}); }), "knots[3]: " + order + "2 after 3");
  EXPECT_EQ(told([] { return given(3, {0, 1, 2, 2, 2, 4, 5}); }), "knots[4]: " + often + "2 more often");
  EXPECT_EQ(told([] { return given(3, {1, 2, 2, 2, 5}); }), "knots[3]: " + often + "2 more often");
  EXPECT_EQ(told([] { return given(3, {0, 0, 0, 1, 2, 2, 2}); }), "") << "the dropped knots do not count";
}

TEST(KnotList, TellsHowManyKnotsThereAreToBe) {
  EXPECT_EQ(told([] { return knots(3, {0, 0, 0, 1}); }), "knots: expected at least 6 for degree 3, found 4");
  EXPECT_EQ(told([] { return knots(3, {0, 0, 0, 1, 1}); }), "knots: expected at least 6 for degree 3, found 5");
  EXPECT_EQ(told([] { return knots(3, {0, 1, 2}); }), "knots: expected at least 6 for degree 3, found 3");
  EXPECT_EQ(told([] { return given(1, {0, 1, 2}); }), "knots: expected at least 4 for degree 2, found 3");
  EXPECT_EQ(told([] { return given(1, {0, 1, 2, 3, 4}); }), "knots: expected at least 6 for degree 2, found 5");
  EXPECT_EQ(told([] {
              return given(3, {0, 0, 1, 2, 3, 4});
            }),
            "knots: expected 5 (papers' list) or 7 (CAD list) for degree 2 and 4 control points, found 6");
  EXPECT_EQ(told([] {
              return knots(std::numeric_limits<int>::max(), {0, 1});
            }),
            "knots: expected at least 4294967294 for degree 2147483647, found 2");
  EXPECT_EQ(told([] { return knots(0, {0, 1}); }), "degree: expected at least 1, found 0");
  EXPECT_EQ(told([] {
              return knots(3, {0, 0, 1, 1, 2, 2});
            }),
            "knots: expected a domain of positive length, found [1, 1]");
}

TEST(Spline, TellsHowManyControlPointsThereAreToBe) {
  using Points = std::vector<Vec<Q, 1>>;
  EXPECT_EQ(told([] {
              return Spline<Q, Vec<Q, 1>>(knots(2, {0, 0, 1, 1}), Points(2, Vec<Q, 1>(Q(0))));
            }),
            "points: expected 3 control points, found 2");
}

}  // namespace
}  // namespace torse::test
