// Running properties: a false one is found, shrunk, saved and replayed; a vacuous run is told.
#include <gtest/gtest.h>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/rapidcheck.hpp"
#include "torse/fuzz/run.hpp"

namespace torse::fuzz {
namespace {

/// False: "the sum of a list of numbers is below 1000". Lists of two or more are discarded with a tenth's chance.
struct SmallSums {
  struct In {
    std::vector<Rational> list;
    Bytes note;
    std::optional<int> count;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("list", in.list);
      visit("note", in.note);
      visit("count", in.count);
    }
  };
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.sums", "false", 50, {"size=1", "size=99"}};
    return info;
  }
  static In draw(Choices& choices, const Scale& scale, Labels& labels) {
    In in;
    const int size = choices.between(0, 8);
    for (int i = 0; i < size; ++i) in.list.push_back(draw_integer(choices, scale.bits));
    if (size > 1 && choices.once_in(10)) throw Discard("long");
    in.note.text = "a\"\x80\n";
    if (size > 0) in.count = size;
    labels.add("size", size);
    return in;
  }
  static void check(const In& in, Labels&) {
    Rational sum;
    for (const Rational& x : in.list) sum += x;
    require(sum < Rational(1000), "the sum is too large");
  }
};

const Property& sums() { return property<SmallSums>(); }

TEST(Run, AFalsePropertyIsFoundAndShrunkToItsSimplestCase) {
  const Tally tally = run_seed(sums(), proofs::Effort::quick, 1);
  ASSERT_EQ(tally.failures.size(), 1U);
  EXPECT_EQ(tally.cases, 50U);
  EXPECT_GT(tally.failed, 0U);
  EXPECT_GT(tally.discarded, 0U);
  const SavedCase& saved = tally.failures.front();
  EXPECT_EQ(saved.message, "the sum is too large");
  const Document document("saved", saved.text);
  const auto in = read_input<SmallSums::In>(document.root().at("input"));
  ASSERT_EQ(in.list.size(), 1U);
  EXPECT_EQ(in.list.front(), Rational(1000));
  EXPECT_EQ(in.note.text, "a\"\x80\n");
  EXPECT_EQ(in.count, 1);
}

TEST(Run, ASeedIsTheSameEveryTimeAndAnotherSeedIsAnotherRun) {
  EXPECT_EQ(run_seed(sums(), proofs::Effort::quick, 5), run_seed(sums(), proofs::Effort::quick, 5));
  EXPECT_NE(run_seed(sums(), proofs::Effort::quick, 5).labels, run_seed(sums(), proofs::Effort::quick, 6).labels);
}

TEST(Run, ALabelThatWasNeverMetMakesTheRunVacuous) {
  Tally tally;
  EXPECT_EQ(vacuity(sums(), tally), "");
  for (std::uint64_t seed = 0; seed < 20; ++seed) tally.add(run_seed(sums(), proofs::Effort::quick, seed));
  EXPECT_EQ(vacuity(sums(), tally), "never met: size=99");
  tally.discarded = tally.cases / 2 + 1;
  EXPECT_NE(vacuity(sums(), tally).find("were discarded"), std::string::npos);
}

/// Every third case has a label that most should have.
struct Coins {
  struct In {
    int x = 0;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("x", in.x);
    }
  };
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.coins", "true", 50, {"coin=heads"}, {"coin=heads", "side=one"}};
    return info;
  }
  static In draw(Choices& choices, const Scale&, Labels& labels) {
    labels.add("coin", choices.once_in(3) ? "heads" : "tails");
    labels.add("side", "one");
    return {};
  }
  static void check(const In&, Labels&) {}
};

TEST(Run, ALabelThatMostCasesShouldHaveMustNotBeRare) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 20; ++seed) tally.add(run_seed(property<Coins>(), proofs::Effort::quick, seed));
  EXPECT_EQ(vacuity(property<Coins>(), tally), "in fewer than half of the cases: coin=heads");
  tally.labels.add("coin", "heads", tally.cases);
  EXPECT_EQ(vacuity(property<Coins>(), tally), "");
}

TEST(Run, ASavedCaseOfAnUnknownPropertyOrWithAnotherInputIsAnError) {
  const std::string number = case_file(*find_property("text.number"), R"({"x": "2/3"})");
  EXPECT_EQ(replay_case(Document("f", number)).result, CaseResult::held);
  EXPECT_THROW(replay_case(Document("f", case_file(sums(), "{}"))), FileError);
  EXPECT_THROW(replay_case(Document("f", case_file(*find_property("text.number"), R"({"x": 1, "y": 2})"))), FileError);
  EXPECT_THROW(replay_case(Document("f", case_file(*find_property("text.number"), "{}"))), FileError);
}

TEST(RapidCheck, ValuesShrinkToSimplerOnesThatCouldHaveBeenDrawn) {
  const auto even = [](Choices& choices, const Scale&) {
    const int x = 2 * choices.between(0, 500);
    if (x == 66) throw Discard("66");
    return x;
  };
  rc::Shrinkable<int> drawn = gen(even)(rc::Random(0), 100);
  for (std::uint64_t seed = 1; drawn.value() < 40; ++seed) drawn = gen(even)(rc::Random(seed), 100);
  rc::Shrinkable<int> smallest = drawn;
  for (bool smaller = true; smaller;) {
    smaller = false;
    auto shrinks = smallest.shrinks();
    while (auto next = shrinks.next()) {
      ASSERT_EQ(next->value() % 2, 0);
      ASSERT_NE(next->value(), 66);
      if (next->value() < 40) continue;
      smallest = *next;
      smaller = true;
      break;
    }
  }
  EXPECT_EQ(smallest.value(), 40);
}

}  // namespace
}  // namespace torse::fuzz
