// The autopsy names the operation whose operands were made to cancel.
#include "torse/studies/autopsy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "torse/developable/linear_net.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::studies {
namespace {

using ::testing::HasSubstr;
using Q = Rational;

TEST(Shadow, IsTheDoubleAndTheExactValue) {
  const RecordScope record;
  const Shadow third = Shadow::input("x", ratio<Q>(1, 3));
  const Shadow y = (third + Shadow(1)) * third - Shadow(2) / third;
  const double x = 1.0 / 3;
  EXPECT_EQ(y.value(), (x + 1) * x - 2 / x);
  EXPECT_EQ(y.exact(), ratio<Q>(4, 9) - Q(6));
  EXPECT_EQ(record.operations().back().kind, '-');
  EXPECT_EQ(record.operations().front().name, "x");
  const Shadow minus = -third;
  EXPECT_EQ(minus.value(), -x);
  EXPECT_EQ(record.operations().back().kind, 'n');
  EXPECT_EQ(record.operations().back().value, -x);
  EXPECT_EQ(record.operations().back().exact, ratio<Q>(-1, 3));
}

TEST(Shadow, AnOperationBelongsToTheInnermostFormulaThatIsNotOver) {
  const RecordScope record;
  const auto place = [&] {
    static_cast<void>(Shadow(1));
    return record.operations().back().place;
  };
  EXPECT_EQ(place(), -1);
  {
    const FormulaScope<Shadow> outer("outer", "c", 0);
    EXPECT_EQ(place(), 0);
    {
      const FormulaScope<Shadow> inner("inner", "d", 2);
      EXPECT_EQ(place(), 1);
    }
    EXPECT_EQ(place(), 0);
  }
  EXPECT_EQ(place(), -1);
  ASSERT_EQ(record.places().size(), 2U);
  EXPECT_EQ(record.places()[1].formula, "inner");
}

TEST(Shadow, ShippingCodeComputesTheSameDoubles) {
  const RecordScope record;
  const auto run = [](auto make) {
    using S = decltype(make(0.0));
    using P = Vec<S, 3>;
    std::vector<P> c;
    for (int i = 0; i < 5; ++i) c.push_back(P(make(0.1 * i), make(std::sqrt(i + 0.5)), make(1.0 / (i + 3))));
    const KnotList<S> u(2, {make(0), make(0), make(0.3), make(0.7), make(1), make(1)});
    return linear_net<S, P>(u, c, make(1.7), make(-0.4), P(make(0.3), make(0.2), make(0.9)));
  };
  const auto plain = run([](double x) { return x; });
  const auto shadow = run([](double x) { return Shadow::input("x", Q::from_double(x)); });
  for (std::size_t i = 0; i < plain.size(); ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(plain[i][j], shadow[i][j].value());
  }
}

/// A quadratic spline whose second ruling cancels to `rest` in y. Knots 0 0 1 2 3 3, M* = 4 and L* = 5:
///   r_{i+1} = ((4 - u_{i+2}) r_i + (c_{i+1} - c_i)) / (4 - u_i).
/// In y, r_0 = 7/10 and c_1 - c_0 = 3/10 give r_1 = (21/10 + 3/10) / 4 = 3/5; then 2 r_1 = 6/5 meets c_2 - c_1 = -6/5 +
/// rest.
std::string planted(double rest) {
  const Q y = ratio<Q>(-9, 10) + Q::from_double(rest);
  return R"({"torse":1,"type":"construct","method":"bspline","degree":2,"knots":[0,0,1,2,3,3],"c":{"points":[[0,0,0],
    [1,0.3,1],[2,")" +
         y.text() + R"(",2],[3,5,4],[5,8,4]]},"Lambda":5,"M":4,"d0":[1,0.7,1]})";
}

TEST(Autopsy, NamesThePlantedCancellation) {
  const Document document("planted.json", planted(0x1p-40));
  const Autopsy autopsy = autopsy_of(document, "FJ07.13.rulings");
  ASSERT_FALSE(autopsy.lost.empty());
  const Loss& loss = autopsy.lost.front();
  EXPECT_EQ(loss.place.formula, "FJ07.13.rulings");
  EXPECT_EQ(loss.place.row, "d");
  EXPECT_EQ(loss.place.index, 2);
  EXPECT_EQ(loss.coordinate, "y");
  EXPECT_EQ(loss.kind, '+');
  EXPECT_GT(loss.digits, 10);
  EXPECT_NEAR(loss.cancelled, 40.3, 0.1);
  EXPECT_THAT(loss.expression, HasSubstr("c[2].y - c[1].y"));
  EXPECT_THAT(loss.expression, HasSubstr("M - u[3]"));
}

TEST(Autopsy, FindsNothingWhereNothingCancels) {
  const Document document("planted.json", planted(1));
  EXPECT_TRUE(autopsy_of(document, "FJ07.13.rulings").lost.empty());
}

/// Digits that a far origin costs are lost by the formula as printed, and not by the rulings.
TEST(Autopsy, TellsTheRoutesApart) {
  const Document document("far.json", R"({"torse":1,"type":"construct","method":"bezier","degree":2,"c":{"points":
    [["1000000.25",0,0],["1000000.5",1,0],["1000001",1,2]]},"Lambda":"2.0000001","M":"2.0000002","d0":["1000000.2500003",4,4]})");
  const double printed = autopsy_of(document, "FJ07.13").worst.digits;
  const Autopsy shipped = autopsy_of(document, "FJ07.13.rulings");
  EXPECT_GE(shipped.worst.digits, printed);
  EXPECT_THROW(autopsy_of(document, "FJ07.10"), Error);
}

TEST(Autopsy, SharesMakeUpTheWholeError) {
  const Document document("planted.json", planted(0x1p-20));
  const Autopsy autopsy = autopsy_of(document, "FJ07.13");
  double sum = 0;
  for (const Loss& loss : autopsy.made) sum += loss.share;
  ASSERT_LT(autopsy.made.size(), 10);
  EXPECT_NEAR(sum, 1, 1e-3);
}

TEST(Autopsy, ASurfaceIsJudgedByItsDeterminants) {
  const Document document("plane.json",
                          R"({"torse":1,"type":"ruled","degree":2,"c":{"points":[[0,0,0],["1/3",1,0],[1,2,1]]},
    "d":{"points":[[0,1,"1/7"],["1/3",2,"1/7"],[1,3,"8/7"]]}})");
  const Autopsy autopsy = autopsy_of(document, "FJ07.13.rulings");
  ASSERT_FALSE(autopsy.lost.empty());
  EXPECT_EQ(autopsy.lost.front().place.formula, "FJ07.3");
  EXPECT_EQ(autopsy.worst.exact, 0);
}

TEST(Autopsy, WhatLeavesTheRangeOfDoubleIsNoNumber) {
  const Document document("huge.json", R"({"torse":1,"type":"construct","method":"bezier","degree":2,"c":{"points":
    [[0,0,0],["1e400",1,0],[1,1,2]]},"Lambda":3,"M":2,"d0":["1/3",4,4]})");
  const Autopsy autopsy = autopsy_of(document, "FJ07.13.rulings");
  EXPECT_TRUE(std::isinf(autopsy.worst.value));
  EXPECT_EQ(autopsy.worst.digits, 0);
  EXPECT_TRUE(autopsy.made.empty());
}

/// Exact values of a long row of long numbers would take minutes.
TEST(Autopsy, RefusesWhatTakesTooLong) {
  std::string points = "[0,0,0]";
  for (int i = 1; i <= 40; ++i) points += ",[" + std::to_string(i) + ",\"1/" + std::string(1000, '7') + "\",0]";
  const Document document("long.json",
                          R"({"torse":1,"type":"construct","method":"bezier","degree":40,"c":{"points":[)" + points +
                              R"(]},"Lambda":3,"M":2,"d0":[1,1,1]})");
  try {
    autopsy_of(document, "FJ07.13.rulings");
    FAIL() << "expected a refusal";
  } catch (const FileError& error) {
    EXPECT_EQ(error.place(), "c.points");
  }
}

TEST(Autopsy, SaysWhatItCannotLookInto) {
  const Document document("x.json", R"({"torse":1,"type":"construct","method":"directrix","degree":1,"c":{"points":
    [[0,0,0],[1,0,0]]},"a":[1],"b":[0]})");
  EXPECT_THROW(autopsy_of(document, "FJ07.13"), Error);
}

}  // namespace
}  // namespace torse::studies
