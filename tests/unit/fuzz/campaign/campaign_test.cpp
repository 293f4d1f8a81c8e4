// A campaign comes out the same by any number of threads, shards and processes, resumed or in one go.
#include "torse/fuzz/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <new>
#include <thread>

#include "torse/fuzz/campaign/crash.hpp"
#include "torse/fuzz/campaign/crew.hpp"
#include "torse/fuzz/campaign/messages.hpp"
#include "torse/fuzz/campaign/workers.hpp"
#include "torse/io/document.hpp"
#include "unit/fuzz/campaign/support.hpp"

namespace torse::fuzz {
namespace {

using Open = Database::Open;
using test::Digits;
using test::equal;
using test::Hall;
using test::Numbers;
using test::plan_of;
using test::run_of;

class Campaigns : public ::testing::Test {
 protected:
  Store store(const std::string& name) const { return {(scratch_ / name).string(), Open::create}; }
  static Ran run(Store& store, const Plan& plan, unsigned jobs, Ranks* ranks = nullptr) {
    return run_campaign(store, plan, run_of(store.file() + std::to_string(++token), "b"), {jobs, {}, {}}, {}, ranks);
  }
  /// A run by several processes: `others` say what each but the first one does.
  static Ran run_by(Hall& hall, int size, Store& store, const Plan& plan, const std::string& builds = "b") {
    std::vector<std::thread> others;
    for (int rank = 1; rank < size; ++rank) {
      others.emplace_back([&hall, &plan, &builds, rank] {
        Hall::Seat seat = hall.seat(rank);
        follow(seat, plan, builds, 1);
      });
    }
    Hall::Seat seat = hall.seat(0);
    Ran ran;
    std::exception_ptr error;
    try {
      ran = run(store, plan, 1, &seat);
    } catch (...) {
      error = std::current_exception();
    }
    for (std::thread& thread : others) thread.join();
    if (error) std::rethrow_exception(error);
    return ran;
  }

  testing::Scratch scratch_;
  static inline int token = 0;
};

/// A property that cannot be run: its input cannot be written.
struct Broken : Digits {
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.broken", "false", 20, {}};
    return info;
  }
  static inline std::atomic<bool> began = false;
  static In draw(Choices&, const Scale&, Labels&) {
    began = true;
    throw std::bad_alloc();
  }
};

/// Waits until it is released.
struct Endless : Digits {
  static inline std::atomic<bool> released = false;
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.endless", "true", 1, {}};
    return info;
  }
  static void check(const In&, Labels&) {
    while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
};

/// Ends the process by one of the signals, or by an overflow of the stack.
struct Crash : Digits {
  static const PropertyInfo& info() {
    static const PropertyInfo info{"test.crash", "false", 1, {}};
    return info;
  }
  static inline int signal = 0;
  static int deep(const volatile char* above) {
    volatile char here[1024] = {};
    here[0] = above == nullptr ? 0 : *above;
    return here[0] == 1 ? 0 : deep(here) + here[1];
  }
  static void check(const In& in, Labels&) {
    if (signal != 0) std::raise(signal);
    std::exit(deep(nullptr) + in.x);
  }
};

TEST_F(Campaigns, HoldWhatRunSeedSays) {
  Store a = store("a");
  const Plan plan = plan_of({5, 24});
  const Ran ran = run(a, plan, 1);
  EXPECT_TRUE(ran.complete);
  EXPECT_EQ(ran.advance.units, 40U);
  EXPECT_EQ(ran.advance.left, 40U);
  for (std::size_t p = 0; p < 2; ++p) {
    Tally sum;
    for (std::uint64_t seed = 5; seed <= 24; ++seed) sum.add(run_seed(*plan.properties[p], plan.effort, seed));
    Tally stored = a.total(plan.series(p), all_seeds).tally;
    for (const Failure& failure : a.failures(plan.series(p), all_seeds)) stored.failures.push_back(failure.saved);
    EXPECT_EQ(stored, sum);
    EXPECT_EQ(a.unit_count(plan.series(p), all_seeds), 20U);
  }
  EXPECT_FALSE(a.failures(plan.series(0), all_seeds).empty());
  EXPECT_TRUE(a.failures(plan.series(1), all_seeds).empty());
}

TEST_F(Campaigns, AreTheSameByAnyNumberOfThreadsShardsAndProcesses) {
  const Plan plan = plan_of({1, 60});
  Store one = store("one");
  run(one, plan, 1);
  Store threads = store("threads");
  run(threads, plan, 5);
  EXPECT_TRUE(equal(one, threads));

  std::vector<std::string> parts;
  Store shards = store("shards");
  for (std::uint64_t index : {2U, 0U, 1U}) {
    Plan part = plan;
    part.shard = {index, 3};
    run(shards, part, 2);
    Store own = store("shard" + std::to_string(index));
    EXPECT_EQ(run(own, part, 1).advance.units, 40U);
    parts.push_back(own.file());
  }
  EXPECT_TRUE(equal(one, shards));
  Store merged = store("merged");
  merge(merged, parts);
  EXPECT_TRUE(equal(one, merged));

  for (int size = 1; size <= 4; ++size) {
    Store processes = store("processes" + std::to_string(size));
    Hall hall(size);
    EXPECT_TRUE(run_by(hall, size, processes, plan).complete);
    EXPECT_TRUE(hall.in_order());
    EXPECT_TRUE(equal(one, processes)) << size;
  }
}

TEST_F(Campaigns, GoOnWhereTheyWereStopped) {
  const Plan plan = plan_of({1, 40});
  Store parts = store("parts");
  const Ran none = run_campaign(parts, plan, run_of("t", "b"), {2, std::chrono::duration<double>(0), {}}, {}, nullptr);
  EXPECT_FALSE(none.complete);
  EXPECT_EQ(none.advance.units, 0U);
  EXPECT_EQ(none.advance.left, 80U);
  run(parts, plan_of({30, 35}), 1);
  Plan digits = plan_of({1, 7});
  digits.properties.pop_back();
  run(parts, digits, 1);
  const Ran rest = run(parts, plan, 2);
  EXPECT_EQ(rest.advance.left, 80U - 12U - 7U);
  EXPECT_EQ(rest.advance.units, rest.advance.left);
  EXPECT_EQ(run(parts, plan, 2).advance.units, 0U);
  Store one = store("one");
  run(one, plan, 1);
  EXPECT_TRUE(equal(one, parts));
}

TEST_F(Campaigns, AUnitThatCameOutOtherwiseIsAnError) {
  Store a = store("a");
  Plan plan = plan_of({1, 3});
  const UnitResult wrong = test::unit_of("test.digits", 2, 0);
  {
    // Two processes on one database: the other one stores its unit after this one has begun.
    Hall hall(2);
    Hall::Seat seat = hall.seat(1);
    seat.send(0, to_bytes(Report{plan_number(plan, "b"), 0, true, "", {wrong}}, plan));
    Hall::Seat leader = hall.seat(0);
    EXPECT_THROW(run(a, plan, 1, &leader), FileError);
  }
  EXPECT_EQ(a.unit_count(plan.series(0), all_seeds), 0U);
}

TEST_F(Campaigns, AFailureOfAnotherBuildIsRunOnceMoreAndIsThenThatOfThisOne) {
  Store a = store("a");
  Plan plan = plan_of({1, 40});
  plan.properties = {&property<Digits>()};
  run_campaign(a, plan, run_of("t", "old"), {1, {}, {}}, {}, nullptr);
  const std::uint64_t settled = a.settled(plan.series(0), all_seeds, "b").count();
  ASSERT_LT(settled, 40U);
  const Ran again = run(a, plan, 1);
  EXPECT_EQ(again.advance.left, 40 - settled);
  EXPECT_EQ(again.advance.units, 40 - settled);
  for (const Failure& failure : a.failures(plan.series(0), all_seeds)) EXPECT_EQ(failure.build, "b");
  EXPECT_EQ(run(a, plan, 1).advance.left, 0U);
  Store one = store("one");
  run(one, plan, 1);
  EXPECT_TRUE(equal(one, a));
}

TEST_F(Campaigns, AFailureThatCameOutOtherwiseUnderTheSameBuildIsAnError) {
  Store a = store("a");
  Plan plan = plan_of({1, 1});
  const UnitResult fails = test::unit_of("test.digits", 50, 1);
  test::put_all(a, run_of("t", "old"), {fails});
  const auto report = [&](const UnitResult& result) {
    Hall hall(2);
    Hall::Seat seat = hall.seat(1);
    seat.send(0, to_bytes(Report{plan_number(plan, "b"), 0, true, "", {result}}, plan));
    Hall::Seat leader = hall.seat(0);
    run(a, plan, 1, &leader);
  };
  report(fails);
  EXPECT_THROW(report(test::unit_of("test.digits", 50, 2)), FileError);
  EXPECT_EQ(a.total(plan.series(0), {50, 50}).tally.failed, 1U);
}

/// Two builds at once on one database: the other one stores what held there after this one has begun.
TEST_F(Campaigns, AUnitThatCameOutOtherwiseUnderAnotherBuildTellsOfIt) {
  Store a = store("a");
  const Plan plan = plan_of({1, 1});
  const auto error = [&](const std::string& build, std::uint64_t seed) {
    test::put_all(a, run_of("t" + build, build), {test::unit_of("test.digits", seed, 0)});
    Hall hall(2);
    Hall::Seat seat = hall.seat(1);
    const UnitResult fails = test::unit_of("test.digits", seed, 1);
    seat.send(0, to_bytes(Report{plan_number(plan, "b"), 0, true, "", {fails}}, plan));
    Hall::Seat leader = hall.seat(0);
    try {
      run(a, plan, 1, &leader);
    } catch (const FileError& caught) {
      EXPECT_EQ(caught.file(), a.file());
      return caught.reason();
    }
    return std::string("none");
  };
  const std::string unit = "test.digits, seed 50, quick effort";
  EXPECT_EQ(error("other", 50),
            unit + " has come out otherwise under another build of torse meanwhile: give each its own database");
  EXPECT_EQ(a.total(plan.series(0), {50, 50}).tally.failed, 0U);
  EXPECT_NE(error("b", 51).find("has come out otherwise before: its property"), std::string::npos);
}

TEST_F(Campaigns, AUnitThatCannotBeRunIsNamedAndTheOthersAreStored) {
  for (int size = 1; size <= 3; ++size) {
    Store a = store("a" + std::to_string(size));
    Plan plan = plan_of({1, 400});
    plan.properties.push_back(&property<Broken>());
    Hall hall(size);
    try {
      run_by(hall, size, a, plan);
      FAIL();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("test.broken, seed "), std::string::npos) << error.what();
    }
    EXPECT_TRUE(hall.in_order());
  }
}

/// Both at once: what came out first is given first.
TEST(Workers, ResultsBesideADefectAreGiven) {
  Plan plan = plan_of({1, 1});
  plan.properties.push_back(&property<Broken>());
  Broken::began = false;
  Workers workers(plan, 1);
  workers.give({{0, 1}, {2, 1}});
  while (!Broken::began || !workers.at_work().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::vector<UnitResult> results = workers.take(std::chrono::milliseconds(0));
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].series.property, "test.digits");
  EXPECT_THROW(workers.take(std::chrono::milliseconds(0)), Error);
}

TEST_F(Campaigns, AUnitThatDoesNotEndIsNamed) {
  Store a = store("a");
  Plan plan = plan_of({7, 9});
  plan.properties = {&property<Numbers>(), &property<Endless>()};
  std::string names;
  const auto overdue = [&](const std::string& named) {
    EXPECT_EQ(names, "");
    names = named;
    EXPECT_GT(a.unit_count(plan.series(0), all_seeds), 0U);  // what is finished is stored by then
    Endless::released = true;
  };
  const Work work{1, std::chrono::duration<double>(0.3), overdue, std::chrono::duration<double>(0.3)};
  run_campaign(a, plan, run_of("t", "b"), work, {}, nullptr);
  EXPECT_EQ(names.substr(0, 19), "test.endless, seed ");
}

/// Of two units the first one takes longer than there is time, while the second one waits for it.
TEST_F(Campaigns, AreNotCompleteWhereUnitsWereDropped) {
  Store a = store("a");
  Plan plan = plan_of({1, 2});
  plan.properties = {&property<Endless>()};
  Endless::released = false;
  const Work work{1, std::chrono::duration<double>(0.1), [](const std::string&) { Endless::released = true; },
                  std::chrono::duration<double>(0.1)};
  const Ran ran = run_campaign(a, plan, run_of("t", "b"), work, {}, nullptr);
  EXPECT_EQ(ran.advance.units, 1U);
  EXPECT_FALSE(ran.complete);
}

TEST_F(Campaigns, ACrashNamesItsUnit) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {0, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    Crash::signal = signal;
    const auto seed = static_cast<std::uint64_t>(signal) + 1;
    Plan plan = plan_of({seed, seed});
    plan.properties = {&property<Crash>()};
    const std::string words = "crashed in test.crash, seed " + std::to_string(seed) + ", quick effort";
    EXPECT_DEATH(
        {
          report_crashes();
          Store a = store("a");
          run(a, plan, 1);
        },
        words);
  }
}

TEST_F(Campaigns, AnotherProgramIsNoHelp) {
  Store a = store("a");
  const Plan plan = plan_of({1, 3});
  Hall hall(2);
  Hall::Seat seat = hall.seat(1);
  seat.send(0, to_bytes(Report{plan_number(plan, "another build"), 1, false, "", {}}, plan));
  Hall::Seat leader = hall.seat(0);
  EXPECT_THROW(run(a, plan, 1, &leader), Error);
  EXPECT_NE(plan_number(plan, "b"), plan_number(plan_of({1, 3}), "c"));
  Plan deep = plan;
  deep.effort = proofs::Effort::deep;
  EXPECT_NE(plan_number(plan, "b"), plan_number(deep, "b"));
}

/// What a process has done before it gives up is kept.
TEST_F(Campaigns, ResultsOfAProcessThatFailsAreStored) {
  const Plan plan = plan_of({1, 3});
  Hall hall(2);
  Hall::Seat seat = hall.seat(1);
  Hall::Seat leader = hall.seat(0);
  Crew crew(&leader, plan, "build");
  Report report{plan_number(plan, "build"), 0, true, "went wrong", {}};
  report.results.push_back({plan.series(1), 2, run_seed(*plan.properties[1], plan.effort, 2), 1000});
  seat.send(0, to_bytes(report, plan));
  Schedule schedule(plan, std::vector<SeedSet>(plan.properties.size(), SeedSet(all_seeds)));
  std::vector<UnitResult> results;
  EXPECT_THROW(crew.serve(schedule, false, results), Error);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].seed, 2U);
}

TEST(Messages, AreReadAsTheyWereWritten) {
  const Plan plan = plan_of({1, 3});
  Report report{~std::uint64_t{0}, 300, true, "an error\n", {}};
  for (std::uint64_t seed = 1; seed < 200; ++seed) {
    report.results.push_back({plan.series(seed % 2), seed << 40U,
                              run_seed(*plan.properties[seed % 2], plan.effort, seed),
                              static_cast<std::int64_t>(seed * 1000)});
    for (SavedCase& saved : report.results.back().tally.failures) saved.seed = seed << 40U;
  }
  const std::string bytes = to_bytes(report, plan);
  const Report read = report_from(bytes, plan);
  EXPECT_EQ(report_plan(bytes), report.plan);
  EXPECT_EQ(read.plan, report.plan);
  EXPECT_EQ(read.wanted, 300U);
  EXPECT_TRUE(read.last);
  EXPECT_EQ(read.error, report.error);
  ASSERT_EQ(read.results.size(), report.results.size());
  for (std::size_t i = 0; i < read.results.size(); ++i) {
    EXPECT_EQ(read.results[i].series, report.results[i].series);
    EXPECT_EQ(read.results[i].seed, report.results[i].seed);
    EXPECT_EQ(read.results[i].microseconds, report.results[i].microseconds);
    EXPECT_EQ(read.results[i].tally, report.results[i].tally);
  }
  const std::vector<Unit> units{{0, 5}, {1, Seeds::most}};
  EXPECT_EQ(orders_from(to_bytes(units), plan), units);
}

TEST(Messages, OfOtherBytesAreErrors) {
  const Plan plan = plan_of({1, 3});
  const Report report{1, 2, false, "", {test::unit_of("test.digits", 7, 1)}};
  const std::string bytes = to_bytes(report, plan);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(report_from(bytes.substr(0, size), plan), Error) << size;
  }
  EXPECT_THROW(report_from(bytes + "x", plan), Error);
  EXPECT_THROW(orders_from(to_bytes(std::vector<Unit>{{2, 1}}), plan), Error);
  EXPECT_THROW(orders_from(std::string(12, '\xFF'), plan), Error);
}

}  // namespace
}  // namespace torse::fuzz
