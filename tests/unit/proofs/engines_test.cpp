// The engines themselves: every engine that may refute must refute wrong claims, and the findings must not depend on
// threads, shards or the order of work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/file.hpp"
#include "torse/proofs/engines/engine.hpp"
#include "torse/proofs/report.hpp"
#include "torse/proofs/runner.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {
namespace {

Plan quick(int mutant = 0) {
  Plan plan;
  plan.effort = Effort::quick;
  plan.mutant = mutant;
  return plan;
}

std::size_t index_of(std::string_view id) {
  const auto& claims = all_claims();
  const auto found = std::ranges::find(claims, id, [](const ClaimInfo* info) { return info->id; });
  EXPECT_NE(found, claims.end()) << id;
  return static_cast<std::size_t>(found - claims.begin());
}

std::string shape(const Finding& f) {
  return f.claim + " " + f.engine + " " + std::string(status_name(f.status)) + " " + sizes_text(f.sizes) + " " +
         std::to_string(f.trials) + " " + std::to_string(f.discards) + " " + f.detail;
}

TEST(Claims, EveryIdOnceWithPaperAndMutants) {
  std::set<std::string> ids;
  for (const ClaimInfo* info : all_claims()) {
    EXPECT_TRUE(ids.insert(std::string(info->id)).second) << info->id;
    EXPECT_FALSE(info->statement.empty()) << info->id;
    EXPECT_GE(info->mutants.size(), 3U) << info->id;
  }
  for (const char* id : {"FJ07.1",        "FJ07.2",    "FJ07.3",    "FJ07.4",    "FJ07.5",    "FJ07.6",
                         "FJ07.7",        "FJ07.8",    "FJ07.9",    "FJ07.T1",   "FJ07.10",   "FJ07.11",
                         "FJ07.12",       "FJ07.C1",   "FJ07.13",   "FJ07.C2",   "FJ07.14",   "FJ07.15",
                         "FJ07.16",       "FJ07.17",   "FJ07.18",   "FJ07.19",   "FJ07.C3",   "FJ07.20",
                         "FJ07.21",       "ZW06.5",    "ZW06.6",    "ZW06.7",    "ZW06.8",    "ZW06.9",
                         "ZW06.10",       "ZW06.11",   "ZW06.12",   "ZW06.13",   "ZW06.14",   "ZW06.15",
                         "ZW06.16",       "ZW06.17",   "ZW06.18",   "ZW06.19",   "ZW06.20",   "ZW06.G",
                         "ZW06.G.unique", "FJ21.2.1",  "FJ21.3.1",  "FJ21.3.2",  "FJ21.P3.1", "FJ21.C3.1",
                         "FJ21.3.3",      "FJ21.3.5",  "FJ21.T3.1", "FJ21.T3.2", "FJ21.4.1",  "FJ21.4.3",
                         "FJ21.4.4",      "FJ21.C4.1", "FJ21.W",    "FJ21.5.1",  "FJ21.5.2",  "FJ21.5.3",
                         "FJ21.5.4",      "FJ21.K",    "FJ21.6",    "FJ21.6.1",  "FJ21.C6.1", "FJ21.T6.1",
                         "FJ21.7.1",      "FJ21.E8",   "BZZ19.3",   "BZZ19.4",   "BZZ19.5",   "BZZ19.5.witnesses",
                         "BZZ19.6",       "BZZ19.7",   "BZZ19.8",   "BZZ19.10",  "BZZ19.11",  "BZZ19.12",
                         "BZZ19.13",      "BZZ19.14",  "BZZ19.15",  "BZZ19.16",  "BZZ19.W"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(Claims, SameOrderInEveryTable) {
  const auto& cases = claim_cases<Rational>();
  ASSERT_EQ(cases.size(), all_claims().size());
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(cases[i].info, all_claims()[i]);
}

TEST(Claims, EveryHypothesisHasAFailure) {
  for (const auto& claim : claim_cases<Rational>()) {
    std::set<std::size_t> shown;
    for (const auto& failure : claim.failures()) shown.insert(failure.hypothesis);
    EXPECT_EQ(shown.size(), claim.info->hypotheses.size()) << claim.info->id;
  }
}

/// Each engine that may refute, on each wrong variant of each claim.
class WrongClaims : public testing::TestWithParam<Finding (*)(std::size_t, const Plan&)> {};

TEST_P(WrongClaims, AreRefuted) {
  for (std::size_t i = 0; i < all_claims().size(); ++i) {
    const ClaimInfo& info = *all_claims()[i];
    for (int mutant = 1; mutant <= static_cast<int>(info.mutants.size()); ++mutant) {
      const Finding finding = GetParam()(i, quick(mutant));
      if (finding.status == Status::not_applicable) continue;
      EXPECT_EQ(finding.status, Status::refuted)
          << info.id << " mutant " << mutant << " (" << info.mutants[static_cast<std::size_t>(mutant - 1)]
          << "): " << finding.detail;
    }
  }
}

std::string engine_of(const testing::TestParamInfo<Finding (*)(std::size_t, const Plan&)>& test) {
  constexpr std::array<const char*, 3> names{"Rational", "Modular", "Symbolic"};
  return names.at(test.index);
}

INSTANTIATE_TEST_SUITE_P(Engines, WrongClaims, testing::Values(&run_rational, &run_modular, &run_symbolic), engine_of);

TEST(Runner, FindingsDoNotDependOnThreads) {
  Selection selection;
  selection.claims = {"FJ07.13", "FJ07.16", "FJ21.5.2"};
  std::string one;
  std::string two;
  for (const Entry& entry : run_all(selection, quick(), 1, {})) {
    for (const Finding& f : entry.findings) one += shape(f) + "\n";
  }
  for (const Entry& entry : run_all(selection, quick(), 3, {})) {
    for (const Finding& f : entry.findings) two += shape(f) + "\n";
  }
  EXPECT_EQ(one, two);
  EXPECT_EQ(std::ranges::count(one, '\n'), 18);
}

TEST(Runner, ShardsMakeUpTheWhole) {
  Selection selection;
  selection.claims = {"FJ07.14", "FJ07.16"};
  std::multiset<std::string> whole;
  std::multiset<std::string> parts;
  for (const Entry& entry : run_all(selection, quick(), 2, {})) {
    for (const Finding& f : entry.findings) whole.insert(shape(f));
  }
  selection.shards = 5;
  for (selection.shard = 0; selection.shard < selection.shards; ++selection.shard) {
    for (const Entry& entry : run_all(selection, quick(), 2, {})) {
      for (const Finding& f : entry.findings) parts.insert(shape(f));
    }
  }
  EXPECT_EQ(whole, parts);
  EXPECT_EQ(whole.size(), 12U);
}

TEST(Runner, SeedsGiveOtherInputsAndTheSameStatus) {
  Plan other = quick();
  other.seed = 99;
  const std::size_t i = index_of("FJ07.15");
  EXPECT_EQ(run_modular(i, quick()).status, Status::supported);
  EXPECT_EQ(run_modular(i, other).status, Status::supported);
  EXPECT_NE(run_numeric(i, quick()).detail, run_numeric(i, other).detail);
}

TEST(Modular, ErrorBoundReachesItsTarget) {
  for (const Finding& finding :
       {run_modular(index_of("FJ07.16"), quick()), run_modular(index_of("FJ07.13"), quick())}) {
    ASSERT_TRUE(finding.error_log2.has_value());
    EXPECT_LT(*finding.error_log2, -50);
    EXPECT_GT(*finding.error_log2, -2000);
  }
}

TEST(Ledger, NothingGotWorseSinceItWasWritten) {
  const std::string stored = read_file(TORSE_SOURCE_PATH "/proofs/ledger.json");
  const std::vector<Entry> entries = run_all({}, quick(), 2, {});
  EXPECT_THAT(regressions(stored, entries, Extent::whole), testing::IsEmpty());
  for (const Entry& entry : entries) {
    EXPECT_EQ(entry.mutants().survived + entry.faults().survived, 0) << entry.info->id;
    EXPECT_NE(stored.find("{\"id\":\"" + std::string(entry.info->id) + "\""), std::string::npos) << entry.info->id;
  }
}

TEST(Report, BaselineNamesWhatGotWorse) {
  Selection selection;
  selection.claims = {"FJ07.16"};
  selection.engines = {"symbolic"};
  const std::vector<Entry> proved = run_all(selection, quick(), 1, {});
  const std::vector<Entry> refuted = run_all(selection, quick(1), 1, {});
  const std::string before = json_report(proved, quick());
  EXPECT_TRUE(regressions(before, proved, Extent::selected).empty());
  ASSERT_EQ(regressions(before, refuted, Extent::selected).size(), 1U);
  EXPECT_EQ(regressions(before, refuted, Extent::selected).front(), "FJ07.16 was Proved and is Refuted");
  EXPECT_EQ(regressions(before, {}, Extent::whole).front(), "FJ07.16 was Proved and is gone");
  EXPECT_TRUE(regressions(before, {}, Extent::selected).empty());
  EXPECT_THROW(regressions("[]", proved, Extent::selected), Error);
  EXPECT_THROW(regressions("{\"claims\": [{}]}", proved, Extent::selected), Error);
}

TEST(Report, SizesInWords) {
  EXPECT_EQ(sizes_text(grid(4, 4)), "n<=4 N<=4");
  EXPECT_EQ(sizes_text(grid(3, 1)), "n<=3 N=1");
  EXPECT_EQ(sizes_text({{2, 1}, {3, 1}}), "2<=n<=3 N=1");
  EXPECT_EQ(sizes_text({{1, 1}, {8, 64}}), "n<=8 N<=64 (2 sizes)");
}

}  // namespace
}  // namespace torse::proofs
