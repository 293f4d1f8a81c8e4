// Seeds as text and as sets; a schedule hands out each missing unit once, and shards share them.
#include "torse/fuzz/campaign/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "unit/fuzz/campaign/support.hpp"

namespace torse::fuzz {
namespace {

using test::plan_of;

using Pairs = std::set<std::pair<std::size_t, std::uint64_t>>;

/// All units of a schedule, `step` at a time; a unit that comes twice is a failure.
Pairs all_of(Schedule schedule, std::size_t step) {
  Pairs pairs;
  for (auto units = schedule.take(step); !units.empty(); units = schedule.take(step)) {
    EXPECT_LE(units.size(), step);
    for (const Unit& unit : units) EXPECT_TRUE(pairs.emplace(unit.property, unit.seed).second) << unit.seed;
  }
  EXPECT_TRUE(schedule.empty());
  return pairs;
}

SeedSet set_of(const std::vector<std::uint64_t>& seeds) {
  SeedSet set;
  for (const std::uint64_t seed : seeds) set.add(seed);
  return set;
}

TEST(Seeds, AreReadAndWritten) {
  EXPECT_EQ(Seeds::from_text("3..17"), (Seeds{3, 17}));
  EXPECT_EQ(Seeds::from_text("8"), (Seeds{8, 8}));
  EXPECT_EQ(Seeds::from_text("0.."), (Seeds{0, Seeds::most}));
  EXPECT_TRUE(Seeds::from_text("9223372036854775807").endless());
  for (const std::string text : {"3..17", "8", "5.."}) EXPECT_EQ(Seeds::from_text(text).text(), text);
}

TEST(Seeds, OfOtherTextsAreErrors) {
  for (const std::string text : {"", "..", "..5", "5..3", "a", "1..b", "-1..3", "1.5", "1...3", " 1", "1..2..3", "+1",
                                 "9223372036854775808", "1..99999999999999999999"}) {
    EXPECT_THROW(Seeds::from_text(text), Error) << text;
  }
}

TEST(SeedSet, JoinsNeighbours) {
  const SeedSet set = set_of({1, 2, 3, 5, 9, 10});
  EXPECT_EQ(set.intervals(), (std::vector<Seeds>{{1, 3}, {5, 5}, {9, 10}}));
  EXPECT_EQ(set.count(), 6U);
  EXPECT_EQ(set.text(), "1..3, 5, 9..10");
  EXPECT_EQ(SeedSet().text(), "");
}

TEST(SeedSet, TenIntervalsAreNamed) {
  SeedSet set;
  for (std::uint64_t seed = 1; seed <= 19; seed += 2) set.add(seed);
  EXPECT_EQ(set.text(), "1, 3, 5, 7, 9, 11, 13, 15, 17, 19");
  set.add(21);
  EXPECT_EQ(set.text(), "1, 3, 5, 7, 9, 11, 13, 15, 17, 19, ...");
}

TEST(Schedule, HandsOutEveryUnitOnceInTurns) {
  Schedule schedule(plan_of({4, 7}), {SeedSet(), SeedSet()});
  EXPECT_EQ(schedule.left(), 8U);
  EXPECT_EQ(schedule.take(3), (std::vector<Unit>{{0, 4}, {1, 4}, {0, 5}}));
  EXPECT_EQ(schedule.take(100), (std::vector<Unit>{{1, 5}, {0, 6}, {1, 6}, {0, 7}, {1, 7}}));
  EXPECT_TRUE(schedule.empty());
  EXPECT_TRUE(schedule.take(1).empty());
}

TEST(Schedule, SharesTheTime) {
  Schedule schedule(plan_of({1, 1000}), {SeedSet(), SeedSet()});
  const std::vector<std::int64_t> microseconds{100, 3000};
  std::vector<std::int64_t> sums{0, 0};
  for (int i = 0; i < 310; ++i) {
    for (const Unit& unit : schedule.take(2)) {
      schedule.spent(unit.property, microseconds[unit.property]);
      sums[unit.property] += microseconds[unit.property];
    }
  }
  EXPECT_NEAR(static_cast<double>(sums[0]), static_cast<double>(sums[1]), 6000);
  EXPECT_GT(sums[0], 50000);
  EXPECT_EQ(schedule.left(), 2000U - 620U);
}

TEST(Schedule, LeavesOutWhatIsSettled) {
  const Pairs pairs = all_of(Schedule(plan_of({1, 6}), {set_of({1, 2, 5}), set_of({1, 2, 3, 4, 6})}), 2);
  EXPECT_EQ(pairs, (Pairs{{0, 3}, {0, 4}, {0, 6}, {1, 5}}));
  EXPECT_TRUE(Schedule(plan_of({1, 6}), {SeedSet({1, 6}), SeedSet({1, 6})}).empty());
}

TEST(Schedule, ShardsAreAPartition) {
  const std::vector<SeedSet> settled{set_of({5, 6, 20}), set_of({3})};
  Plan plan = plan_of({0, 40});
  const Pairs whole = all_of(Schedule(plan, settled), 7);
  EXPECT_EQ(whole.size(), 2U * 41U - 4U);
  for (const std::uint64_t total : {1U, 2U, 3U, 5U, 100U}) {
    Pairs together;
    std::uint64_t left = 0;
    for (std::uint64_t index = 0; index < total; ++index) {
      plan.shard = {index, total};
      const Pairs part = all_of(Schedule(plan, settled), 5);
      left += Schedule(plan, settled).left();
      EXPECT_EQ(part.size(), Schedule(plan, settled).left());
      EXPECT_GE(part.size() + 2, whole.size() / total) << index << " of " << total;
      together.insert(part.begin(), part.end());
    }
    EXPECT_EQ(together, whole);
    EXPECT_EQ(left, whole.size());
  }
}

TEST(Schedule, HasNoEndWhereTheSeedsHaveNone) {
  Plan plan = plan_of({0, Seeds::most});
  plan.properties.push_back(plan.properties.front());
  plan.properties.push_back(plan.properties.front());
  Schedule schedule(plan, std::vector<SeedSet>(4));
  EXPECT_EQ(schedule.left(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(schedule.take(5).back(), (Unit{0, 1}));
  plan.seeds.first = Seeds::most - 1;
  EXPECT_EQ(all_of(Schedule(plan, std::vector<SeedSet>(4)), 3).size(), 8U);
}

class ShardVariables : public ::testing::Test {
 protected:
  void SetUp() override { TearDown(); }
  void TearDown() override {
    for (const char* name : {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX", "GTEST_SHARD_STATUS_FILE"}) unsetenv(name);
  }
  static Shard shard(const char* total, const char* index) {
    if (total != nullptr) setenv("GTEST_TOTAL_SHARDS", total, 1);
    if (index != nullptr) setenv("GTEST_SHARD_INDEX", index, 1);
    return shard_of_environment();
  }
};

TEST_F(ShardVariables, NameAPart) {
  EXPECT_EQ(shard_of_environment().total, 1U);
  const Shard part = shard("4", "3");
  EXPECT_EQ(part.total, 4U);
  EXPECT_EQ(part.index, 3U);
}

TEST_F(ShardVariables, ThatMakeNoSenseAreErrors) {
  for (const auto& [total, index] : std::vector<std::pair<const char*, const char*>>{
           {"4", "4"}, {"0", "0"}, {"4", ""}, {"", "0"}, {"x", "0"}, {"4", "-1"}, {"4 ", "1"}}) {
    EXPECT_THROW(shard(total, index), Error) << total << " " << index;
  }
  TearDown();
  EXPECT_THROW(shard("4", nullptr), Error);
  TearDown();
  EXPECT_THROW(shard(nullptr, "0"), Error);
}

TEST_F(ShardVariables, TheStatusFileIsTouched) {
  const testing::Scratch scratch;
  setenv("GTEST_SHARD_STATUS_FILE", (scratch / "status").c_str(), 1);
  shard_of_environment();
  EXPECT_TRUE(std::filesystem::exists(scratch / "status"));
}

}  // namespace
}  // namespace torse::fuzz
