// Choices: the same numbers everywhere, bounds, records that give the case back, edits that make it simpler.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "torse/fuzz/choices.hpp"

namespace torse::fuzz {
namespace {

TEST(Choices, GiveTheSameNumbersOnEveryMachine) {
  // The first numbers of SplitMix64 from 1234567, as its authors print them: 6457827717110365317, 3203168211198807973,
  // 9817491932198370423. Their upper bits, scaled to 2^32 and to 10.
  Choices choices = Choices::from_seed(1234567);
  EXPECT_EQ(choices.below(std::uint64_t{1} << 32U), 6457827717110365317U >> 32U);
  EXPECT_EQ(choices.below(10), 1U);
  EXPECT_EQ(choices.below(10), 5U);
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
