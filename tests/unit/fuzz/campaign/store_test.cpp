// The database: every unit once, whole or not at all; what is no such database is refused.
#include "torse/fuzz/campaign/store.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "torse/io/document.hpp"
#include "unit/fuzz/campaign/support.hpp"

namespace torse::fuzz {
namespace {

using Open = Database::Open;
using test::equal;
using test::put_all;
using test::run_of;
using test::unit_of;

class Databases : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  /// Opening it says this.
  void expect_refused(const std::string& name, const std::string& words) const {
    for (const Open how : {Open::existing, Open::create}) {
      try {
        Store store(file(name), how);
        FAIL() << name << " was opened";
      } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      }
    }
  }

  testing::Scratch scratch_;
};

TEST_F(Databases, GiveBackWhatWasStored) {
  UnitResult unit = unit_of("p", 7, 2);
  unit.tally.labels.add("Schl\xC3\xBCssel", std::string("a\0b", 3), 5);
  {
    Store store(file("a"), Open::create);
    put_all(store, run_of("t", "b"), {unit, unit_of("p", 3, 0), unit_of("q", 7, 0)});
  }
  Store store(file("a"), Open::existing);
  EXPECT_EQ(store.series(), (std::vector<Series>{{"p", "quick"}, {"q", "quick"}}));
  Units units(store, {"p", "quick"}, all_seeds);
  const auto first = units.next();
  const auto second = units.next();
  EXPECT_FALSE(units.next());
  EXPECT_EQ(first->result.seed, 3U);
  EXPECT_EQ(second->result.seed, 7U);
  EXPECT_EQ(second->result.tally, unit.tally);
  EXPECT_EQ(second->result.microseconds, 1000);
  EXPECT_EQ(store.unit_count({"p", "quick"}, {3, 6}), 1U);
  EXPECT_EQ(store.unit_count({"p", "deep"}, all_seeds), 0U);
}

TEST_F(Databases, SumWhatTheyHold) {
  Store store(file("a"), Open::create);
  std::vector<UnitResult> units;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) units.push_back(unit_of("p", seed, seed == 4 ? 2 : 0));
  put_all(store, run_of("t", "b"), units);
  const UnitResult total = store.total({"p", "quick"}, {2, 5});
  EXPECT_EQ(total.tally.cases, 40U);
  EXPECT_EQ(total.tally.failed, 2U);
  EXPECT_EQ(total.tally.discarded, 4U);
  EXPECT_EQ(total.tally.labels.count("key", "value"), 36U);
  EXPECT_EQ(total.tally.discards.count("reason", "none"), 4U);
  EXPECT_EQ(total.microseconds, 4000);
  const auto failures = store.failures({"p", "quick"}, all_seeds);
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures.front().saved, (SavedCase{4, 3, "message", "{\"torse\": 1}\n"}));
  EXPECT_EQ(failures.front().build, "b");
}

TEST_F(Databases, StoreAUnitOnce) {
  Store store(file("a"), Open::create);
  Transaction transaction(store.database());
  const std::int64_t run = store.put_run(run_of("t", "b"));
  EXPECT_EQ(store.put_run(run_of("t", "b")), run);
  EXPECT_EQ(store.put(unit_of("p", 1, 0), run), Put::added);
  EXPECT_EQ(store.put(unit_of("p", 1, 0), run), Put::known);
  EXPECT_EQ(store.put(unit_of("p", 1, 1), run), Put::contradiction);
  UnitResult other = unit_of("p", 1, 0);
  other.tally.labels.add("key", "other", 1);
  EXPECT_EQ(store.put(other, run), Put::contradiction);
  transaction.commit();
  EXPECT_EQ(store.total({"p", "quick"}, all_seeds).tally, unit_of("p", 1, 0).tally);
}

TEST_F(Databases, AFailureOfAnotherBuildIsNotSettledAndGivesWay) {
  Store store(file("a"), Open::create);
  put_all(store, run_of("t", "old"), {unit_of("p", 1, 0), unit_of("p", 2, 1), unit_of("p", 3, 0)});
  EXPECT_EQ(store.settled({"p", "quick"}, all_seeds, "old").text(), "1..3");
  EXPECT_EQ(store.settled({"p", "quick"}, all_seeds, "new").text(), "1, 3");
  EXPECT_EQ(store.settled({"p", "quick"}, {2, 9}, "old").text(), "2..3");
  Transaction transaction(store.database());
  const std::int64_t run = store.put_run(run_of("u", "new"));
  EXPECT_EQ(store.put_anew(unit_of("p", 1, 1), run), Put::contradiction);
  EXPECT_EQ(store.put_anew(unit_of("p", 2, 0), run), Put::added);
  EXPECT_EQ(store.put_anew(unit_of("p", 2, 0), run), Put::known);
  EXPECT_EQ(store.put_anew(unit_of("p", 2, 1), run), Put::contradiction);
  transaction.commit();
  EXPECT_TRUE(store.failures({"p", "quick"}, all_seeds).empty());
  EXPECT_EQ(store.total({"p", "quick"}, all_seeds).tally.failed, 0U);
  EXPECT_EQ(store.total({"p", "quick"}, all_seeds).tally.labels.count("key", "value"), 27U);
  EXPECT_EQ(store.settled({"p", "quick"}, all_seeds, "new").text(), "1..3");
}

TEST_F(Databases, HoldNothingOfATransactionThatDidNotEnd) {
  {
    Store store(file("a"), Open::create);
    put_all(store, run_of("t", "b"), {unit_of("p", 1, 0)});
    const Transaction transaction(store.database());
    store.put(unit_of("p", 2, 1), store.put_run(run_of("u", "b")));
  }
  Store store(file("a"), Open::existing);
  EXPECT_EQ(store.unit_count({"p", "quick"}, all_seeds), 1U);
  EXPECT_EQ(store.runs().size(), 1U);
  EXPECT_EQ(store.database().number("SELECT count(*) FROM failure"), 0);
}

TEST_F(Databases, AreNotFoundInOtherFiles) {
  testing::spill(scratch_ / "text", std::string(2000, 'x'));
  expect_refused("text", "expected a database of torse campaign, found another file");
  testing::spill(scratch_ / "short", "SQLite format 3");
  expect_refused("short", "expected a database of torse campaign, found another file");
  Database(file("other"), Open::create).run("CREATE TABLE t (x)");
  expect_refused("other", "expected a database of torse campaign, found another database");
  { Store(file("new"), Open::create).database().run("PRAGMA user_version = 2"); }
  expect_refused("new", "in format 1, found format 2");
  std::filesystem::create_directory(scratch_ / "folder");
  expect_refused("folder", "found a folder");
  EXPECT_THROW(Store(file("none"), Open::existing), FileError);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "none"));
  EXPECT_THROW(Store(file("none/a"), Open::create), FileError);
}

TEST_F(Databases, ThatAreDamagedAreErrorsAndNoCrash) {
  {
    Store store(file("a"), Open::create);
    std::vector<UnitResult> units;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) units.push_back(unit_of("p", seed, 0));
    put_all(store, run_of("t", "b"), units);
  }
  const std::string whole = testing::slurp(scratch_ / "a");
  int refused = 0;
  for (std::size_t at = 100; at < whole.size(); at += 997) {
    std::string bytes = whole;
    for (std::size_t i = at; i < std::min(at + 40, bytes.size()); ++i) bytes[i] = static_cast<char>(0xA5);
    testing::spill(scratch_ / "b", bytes);
    try {
      Store store(file("b"), Open::existing);
      for (const Series& series : store.series()) {
        Units units(store, series, all_seeds);
        while (units.next()) {
        }
      }
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_F(Databases, AreMergedWithEqualUnitsOnce) {
  Store a(file("a"), Open::create);
  Store b(file("b"), Open::create);
  put_all(a, run_of("t", "b"), {unit_of("p", 1, 0), unit_of("p", 2, 1)});
  put_all(b, run_of("u", "b"), {unit_of("p", 2, 1), unit_of("q", 1, 0)});
  Store both(file("c"), Open::create);
  const Merged merged = merge(both, {file("a"), file("b"), file("a")});
  EXPECT_EQ(merged.added, 3U);
  EXPECT_EQ(merged.known, 3U);
  EXPECT_EQ(both.runs().size(), 2U);
  EXPECT_EQ(both.failures({"p", "quick"}, all_seeds).size(), 1U);
  Store other_order(file("d"), Open::create);
  merge(other_order, {file("b"), file("a")});
  EXPECT_TRUE(equal(both, other_order));
  EXPECT_FALSE(equal(both, a));
  EXPECT_THROW(merge(a, {file("a")}), FileError);
}

/// A run goes on after a copy was made.
TEST_F(Databases, RunsKeepTheLongerTimeInEitherOrder) {
  Store older(file("older"), Open::create);
  Store later(file("later"), Open::create);
  RunInfo run = run_of("t", "b");
  run.seconds = 3;
  older.put_run(run);
  run.seconds = 5;
  later.put_run(run);
  for (const auto& order : {std::vector{file("older"), file("later")}, {file("later"), file("older")}}) {
    Store both(file(order[0] == file("older") ? "c" : "d"), Open::create);
    merge(both, order);
    ASSERT_EQ(both.runs().size(), 1U);
    EXPECT_EQ(both.runs().begin()->second.seconds, 5);
  }
}

TEST_F(Databases, ThatContradictEachOtherAreNotMerged) {
  Store a(file("a"), Open::create);
  Store b(file("b"), Open::create);
  put_all(a, run_of("t", "b"), {unit_of("p", 1, 0), unit_of("p", 2, 0)});
  put_all(b, run_of("u", "b"), {unit_of("p", 2, 1), unit_of("p", 3, 0)});
  Store both(file("c"), Open::create);
  try {
    merge(both, {file("a"), file("b")});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.file(), file("b"));
    EXPECT_NE(std::string(error.what()).find("p, seed 2, quick effort"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(both.series().empty());
}

/// The message of a merge that fails.
std::string refusal(Store& into, const std::vector<std::string>& from) {
  try {
    merge(into, from);
  } catch (const FileError& error) {
    return error.what();
  }
  return "merged";
}

TEST_F(Databases, OfTwoBuildsContradictEachOtherInEitherOrder) {
  const UnitResult fails = unit_of("p", 7, 1);
  const UnitResult holds = unit_of("p", 7, 0);
  const UnitResult fails_otherwise = unit_of("p", 7, 2);
  {
    Store older(file("older"), Open::create);
    Store newer(file("newer"), Open::create);
    Store worse(file("worse"), Open::create);
    put_all(older, run_of("t", "old"), {holds});
    put_all(newer, run_of("u", "new"), {fails});
    put_all(worse, run_of("v", "newest"), {fails_otherwise});
  }
  const std::vector<std::string> names{"older", "newer", "worse"};
  for (const std::string& first : names) {
    for (const std::string& second : names) {
      if (first == second) continue;
      Store into(file(first + second), Open::create);
      merge(into, {file(first)});
      const UnitResult before = Units(into, {"p", "quick"}, all_seeds).next()->result;
      EXPECT_NE(refusal(into, {file(second)}).find("p, seed 7, quick effort"), std::string::npos) << first << second;
      EXPECT_EQ(Units(into, {"p", "quick"}, all_seeds).next()->result.tally, before.tally) << first << second;
      EXPECT_EQ(into.runs().size(), 1U);
    }
  }
}

TEST_F(Databases, KeepTheLaterOfEqualResultsInEitherOrder) {
  UnitResult slower = unit_of("p", 7, 1);
  slower.microseconds = 2000;
  RunInfo later = run_of("a", "new");
  later.started = "2026-01-02T03:04:06Z";
  {
    Store a(file("a"), Open::create);
    Store b(file("b"), Open::create);
    put_all(a, run_of("t", "old"), {unit_of("p", 7, 1)});
    put_all(b, later, {slower});
  }
  for (const std::vector<std::string>& order : {std::vector{file("a"), file("b")}, std::vector{file("b"), file("a")}}) {
    Store into(order.front() + "+", Open::create);
    const Merged merged = merge(into, order);
    EXPECT_EQ(merged.added, 1U);
    EXPECT_EQ(merged.known, 1U);
    const std::vector<Failure> failures = into.failures({"p", "quick"}, all_seeds);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.front().build, "new");
    EXPECT_EQ(into.total({"p", "quick"}, all_seeds).microseconds, 2000);
    EXPECT_EQ(into.total({"p", "quick"}, all_seeds).tally.labels.count("key", "value"), 9U);
  }
}

/// The tokens of runs of the same second decide, so that either order comes to the same.
TEST_F(Databases, KeepTheSameOfEqualResultsOfOneSecondInEitherOrder) {
  UnitResult slower = unit_of("p", 7, 0);
  slower.microseconds = 2000;
  {
    Store a(file("a"), Open::create);
    Store b(file("b"), Open::create);
    put_all(a, run_of("t", "build"), {unit_of("p", 7, 0)});
    put_all(b, run_of("u", "build"), {slower});
  }
  for (const std::vector<std::string>& order : {std::vector{file("a"), file("b")}, std::vector{file("b"), file("a")}}) {
    Store into(order.front() + "+", Open::create);
    merge(into, order);
    EXPECT_EQ(into.total({"p", "quick"}, all_seeds).microseconds, 2000);
  }
}

TEST_F(Databases, AreAsTheyWereAfterAMergeThatFails) {
  {
    Store into(file("a"), Open::create);
    Store more(file("b"), Open::create);
    Store wrong(file("c"), Open::create);
    put_all(into, run_of("t", "b"), {unit_of("p", 1, 0), unit_of("p", 2, 1)});
    put_all(more, run_of("u", "b"), {unit_of("p", 3, 0), unit_of("q", 1, 1)});
    put_all(wrong, run_of("v", "b"), {unit_of("p", 4, 0), unit_of("p", 1, 1)});
  }
  const std::string before = testing::slurp(scratch_ / "a");
  std::filesystem::create_hard_link(scratch_ / "a", scratch_ / "link");
  const std::vector<std::pair<std::string, std::string>> last{
      {"c", "p, seed 1, quick effort"},
      {"a", "expected another database than the one to merge into"},
      {"link", "expected another database than the one to merge into"},
      {"none", "unable to open database file"}};
  for (const auto& [name, words] : last) {
    Store into(file("a"), Open::existing);
    EXPECT_NE(refusal(into, {file("b"), file(name)}).find(words), std::string::npos) << name;
    EXPECT_TRUE(testing::slurp(scratch_ / "a") == before) << name;
  }
}

TEST_F(Databases, AreComparedUnitByUnit) {
  Store a(file("a"), Open::create);
  Store b(file("b"), Open::create);
  UnitResult other = unit_of("p", 5, 0);
  other.tally.labels.add("key", "other", 1);
  UnitResult slower = unit_of("p", 6, 0);
  slower.microseconds = 5;
  put_all(a, run_of("t", "b"),
          {unit_of("p", 1, 0), unit_of("p", 2, 0), unit_of("p", 3, 1), unit_of("p", 5, 0), unit_of("p", 6, 0)});
  put_all(b, run_of("t", "c"), {unit_of("p", 2, 1), unit_of("p", 3, 0), unit_of("p", 4, 0), other, slower});
  const std::vector<Difference> differences = compare(a, b);
  ASSERT_EQ(differences.size(), 1U);
  const Difference& difference = differences.front();
  EXPECT_EQ(difference.only_in_a.text(), "1");
  EXPECT_EQ(difference.only_in_b.text(), "4");
  EXPECT_EQ(difference.broken.text(), "2");
  EXPECT_EQ(difference.fixed.text(), "3");
  EXPECT_EQ(difference.changed.text(), "5");
  EXPECT_EQ(difference.same, 1U);
  EXPECT_EQ(difference.b.labels.count("key", "other"), 1U);
  EXPECT_TRUE(difference.verdicts_differ());
}

}  // namespace
}  // namespace torse::fuzz
