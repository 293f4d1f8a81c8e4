// What torse verify says of entries that hold, that fail and that came to nothing.
#include "torse/cli/ledger_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "torse/cli/command.hpp"
#include "torse/proofs/table.hpp"

namespace torse::cli {
namespace {

using proofs::Entry;
using proofs::Finding;
using proofs::Status;
using ::testing::HasSubstr;
using ::testing::Not;

Finding finding(const char* engine, Status status, const char* detail) {
  Finding made;
  made.claim = "FJ07.15";
  made.engine = engine;
  made.status = status;
  made.detail = detail;
  made.seconds = 0.25;
  return made;
}

Entry entry(std::vector<Finding> findings) {
  for (const proofs::ClaimInfo* info : proofs::all_claims()) {
    if (info->id == "FJ07.15") return {info, std::move(findings)};
  }
  return {nullptr, {}};
}

Entry holds() {
  return entry({finding("symbolic", Status::proved, "for all"), finding("ball", Status::bounded, "near")});
}

Entry fails() {
  return entry({finding("symbolic", Status::gave_up, "too large"), finding("rational", Status::refuted, "a witness"),
                finding("ball", Status::refuted, "far")});
}

Entry open() {
  return entry({finding("numeric", Status::not_applicable, ""), finding("ball", Status::undecided, "wide"),
                finding("symbolic", Status::gave_up, "too large")});
}

Entry surviving() {
  Finding mutation = finding("mutation", Status::supported, "1 of 3");
  mutation.mutants = {2, 1, 0};
  mutation.survivors = {"a wrong sign"};
  return entry({finding("symbolic", Status::proved, "for all"), mutation});
}

/// A corrupted operation that changes both sides of an equation alike.
Entry sharing() {
  Finding mutation = finding("mutation", Status::supported, "1 of 3");
  mutation.faults = {2, 1, 0};
  mutation.survivors = {"a product"};
  return entry({finding("symbolic", Status::proved, "for all"), mutation});
}

TEST(LedgerReport, OutcomesAndExitCodes) {
  EXPECT_EQ(ledger_outcome(holds()), Outcome::passed);
  EXPECT_EQ(ledger_outcome(fails()), Outcome::failed);
  EXPECT_EQ(ledger_outcome(open()), Outcome::undecided);
  EXPECT_EQ(ledger_outcome(surviving()), Outcome::failed);
  EXPECT_EQ(ledger_outcome(sharing()), Outcome::failed);
  EXPECT_EQ(ledger_code({holds(), holds()}, false, true), exit_code::success);
  EXPECT_EQ(ledger_code({holds(), holds()}, true, true), exit_code::refuted);
  EXPECT_EQ(ledger_code({holds(), open()}, false, true), exit_code::undecided);
  EXPECT_EQ(ledger_code({open(), fails(), holds()}, false, true), exit_code::refuted);
}

TEST(LedgerReport, AWholeRunThatJudgesNothingIsUndecided) {
  const Entry none = entry({finding("ball", Status::not_applicable, "")});
  EXPECT_EQ(ledger_outcome(none), Outcome::passed);
  EXPECT_EQ(ledger_code({none, none}, false, true), exit_code::undecided);
  EXPECT_EQ(ledger_code({none, none}, false, false), exit_code::success);
  EXPECT_EQ(ledger_code({none, holds()}, false, true), exit_code::success);
  EXPECT_EQ(ledger_code({none, none}, true, true), exit_code::refuted);
}

TEST(LedgerReport, TheCulpritIsWhatRefutesBeforeWhatGaveUp) {
  const Entry failed = fails();
  const Entry undecided = open();
  const Entry survived = surviving();
  const Entry passed = holds();
  EXPECT_EQ(culprit(failed).engine, "rational");
  EXPECT_EQ(culprit(undecided).engine, "ball");
  EXPECT_EQ(culprit(survived).engine, "mutation");
  EXPECT_EQ(culprit(passed).engine, "symbolic");
}

TEST(LedgerReport, LinesOfWhatHasNotPassedSayWhy) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  const Terminal terminal(file.get());
  const std::string good = ledger_text({holds()}, {}, terminal);
  EXPECT_THAT(good, HasSubstr("FJ07.15     Proved"));
  EXPECT_THAT(good, Not(HasSubstr("replay")));
  const std::string bad = ledger_text({fails()}, {}, terminal);
  EXPECT_THAT(bad, HasSubstr("\n            Refuted (rational): a witness\n"));
  EXPECT_THAT(bad, HasSubstr("replay: torse verify --claim FJ07.15 --engine rational"));
  const std::string survived = ledger_text({surviving()}, {}, terminal);
  EXPECT_THAT(survived, HasSubstr(" 2/3 "));
  EXPECT_THAT(survived, HasSubstr("survived: a wrong sign\n"));
}

TEST(LedgerReport, ScoresOfOneAndOfNone) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  Finding mutation = finding("mutation", Status::supported, "1 of 1");
  mutation.mutants = {1, 0, 0};
  const std::string text =
      ledger_text({entry({finding("symbolic", Status::proved, "for all"), mutation})}, {}, Terminal(file.get()));
  EXPECT_THAT(text, HasSubstr("      -    1/1           -  "));
}

TEST(LedgerReport, ErrorsAreRoundedUp) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  Finding modular = finding("modular", Status::supported, "");
  modular.error_log2 = -119.75;
  EXPECT_THAT(ledger_text({entry({modular})}, {}, Terminal(file.get())), HasSubstr(" 2^-119 "));
}

TEST(LedgerReport, TheTallyIsInTheOrderOfStrength) {
  EXPECT_THAT(tally_of({fails(), holds(), surviving(), open()}),
              ::testing::StartsWith("4 claims: 2 Proved, 1 Refuted, 1 Undecided, 1 surviving mutants"));
}

TEST(LedgerReport, CasesForOtherTools) {
  const ReportCase passed = ledger_case(holds(), {});
  EXPECT_EQ(passed.name, "FJ07.15");
  EXPECT_EQ(passed.outcome, Outcome::passed);
  EXPECT_EQ(passed.message, "Proved (symbolic): for all");
  EXPECT_EQ(passed.seconds, 0.5);
  EXPECT_EQ(passed.rule, "FJ07.15");
  EXPECT_THAT(passed.rule_text, HasSubstr("every ruling"));
  EXPECT_EQ(ledger_case(fails(), {}).message, "Refuted (rational): a witness");
}

}  // namespace
}  // namespace torse::cli
