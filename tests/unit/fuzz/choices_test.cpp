// Choices: the same numbers everywhere, bounds, records that give the case back, edits that make it simpler.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "torse/fuzz/choices.hpp"

namespace torse::fuzz {
namespace {

TEST(Choices, GiveTheSameNumbersOnEveryMachine) {
  // The second output of std::mt19937_64 seeded with 5489 is fixed by the C++ standard only through the 10000th,
  // 9981545732273789042; scaled to 1000 by the upper bits that is 541.
  Choices choices = Choices::from_seed(5489);
  std::uint64_t last = 0;
  for (int i = 0; i < 10000; ++i) last = choices.below(1000);
  EXPECT_EQ(last, 541U);
}

TEST(Choices, StayBelowTheirBound) {
  Choices choices = Choices::from_seed(3);
  std::vector<int> seen(7);
  for (int i = 0; i < 700; ++i) ++seen.at(choices.below(7));
  for (const int count : seen) EXPECT_GT(count, 50);
}

TEST(Choices, ARecordGivesTheSameChoicesAgainAndThenZeros) {
  Choices first = Choices::from_seed(11);
  for (std::uint64_t bound = 1; bound < 50; ++bound) first.below(bound);
  Choices again = Choices::from_record(first.record());
  for (std::uint64_t bound = 1; bound < 50; ++bound) again.below(bound);
  EXPECT_EQ(again.record(), first.record());
  EXPECT_EQ(again.below(9), 0U);
  EXPECT_FALSE(again.once_in(2));
}

TEST(Choices, NumbersOfARecordAreCutToTheBound) {
  Choices choices = Choices::from_record({100, 3});
  EXPECT_EQ(choices.below(10), 9U);
  EXPECT_EQ(choices.between(-4, 4), -1);
}

TEST(Choices, BytesAreTakenAsManyAsTheBoundNeeds) {
  const std::vector<std::uint8_t> bytes{7, 1, 2, 255};
  Choices choices = Choices::from_bytes(bytes);
  EXPECT_EQ(choices.below(256), 7U);
  EXPECT_EQ(choices.below(65536), 258U);
  EXPECT_EQ(choices.below(10), 5U);
  EXPECT_EQ(choices.below(1000), 0U);
}

TEST(Choices, EditsAreShorterOrSmallerAndNoneIsTheRecordItself) {
  const Record record{5, 0, 2, 9};
  bool shorter = false;
  for (const Edit& edit : edits(record)) {
    const Record next = edited(record, edit);
    EXPECT_TRUE(next.size() < record.size() || next < record);
    shorter = shorter || next == Record{5, 0, 2};
  }
  EXPECT_TRUE(shorter);
  EXPECT_TRUE(edits({}).empty());
}

}  // namespace
}  // namespace torse::fuzz
