// torse campaign run under mpirun: the same results by any number of ranks, whoever is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "mpi/variables.hpp"
#include "support/process.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

class Mpi : public ::testing::Test {
 protected:
  std::unique_ptr<Process> start(const std::string& ranks, std::vector<std::string> words) const {
    words.insert(words.begin(), {"mpirun", "-n", ranks});
    return std::make_unique<Process>(words, mpi_variables, runs_.scratch() / "output");
  }
  /// Kills a process of a running job once the job has stored something.
  void kill_in_the_middle(const std::string& ranks, const std::string& victim) const {
    const std::uint64_t before = runs_.units("killed");
    const auto job = start(ranks, runs_.run("killed", "1..1000000", "1"));
    ASSERT_TRUE(wait_for([&] { return runs_.units("killed") > before; })) << job->output();
    if (victim == "mpirun") {
      job->send(SIGKILL);
    } else {
      const auto ids = processes_with(runs_.file("killed"), "OMPI_COMM_WORLD_RANK=" + victim);
      ASSERT_EQ(ids.size(), 1U);
      kill(ids.front(), SIGKILL);
    }
    EXPECT_NE(job->wait(), 0);
    // No rank stays behind.
    EXPECT_TRUE(wait_for([&] { return processes_with(runs_.file("killed"), "").empty(); }));
  }
  void expect_like_one_process(const std::string& name) const {
    const std::string seeds = "1.." + std::to_string(runs_.last_seed(name));
    ASSERT_TRUE(runs_.sound(name));
    const auto rest = start("2", runs_.run(name, seeds, "1"));
    ASSERT_EQ(rest->wait(), 0) << rest->output();
    EXPECT_EQ(runs_.units(name), runs_.last_seed(name));
    Process alone(runs_.run("alone", seeds, "1"), {}, runs_.scratch() / "alone-output");
    ASSERT_EQ(alone.wait(), 0) << alone.output();
    const ProgramResult diff = run_program({"campaign", "diff", runs_.file("alone"), runs_.file(name)});
    EXPECT_EQ(diff.exit, 0) << diff.out;
  }

  CampaignRuns runs_;
};

TEST_F(Mpi, TwoAndFourRanksComeToTheSameAsOneProcess) {
  for (const std::string ranks : {"2", "4"}) {
    const auto job = start(ranks, runs_.run("ranks" + ranks, "1..300", "1"));
    ASSERT_EQ(job->wait(), 0) << job->output();
    EXPECT_THAT(job->output(), HasSubstr("300 units, 150000 cases: 0 failed"));
    expect_like_one_process("ranks" + ranks);
  }
}

TEST_F(Mpi, AKilledRankLosesNothingStored) {
  kill_in_the_middle("4", "2");
  kill_in_the_middle("2", "1");
  expect_like_one_process("killed");
}

TEST_F(Mpi, AKilledLeaderLosesNothingStored) {
  kill_in_the_middle("4", "0");
  kill_in_the_middle("2", "0");
  expect_like_one_process("killed");
}

TEST_F(Mpi, AKilledMpirunLosesNothingStored) {
  kill_in_the_middle("4", "mpirun");
  expect_like_one_process("killed");
}

TEST_F(Mpi, RanksOfAnotherPlanAreAnError) {
  std::vector<std::string> words = runs_.run("a", "1..1000", "1");
  words.insert(words.end(), {":", "-n", "1"});
  for (const std::string& word : runs_.run("a", "1..1000", "1")) words.push_back(word == "quick" ? "deep" : word);
  const auto job = start("1", words);
  EXPECT_EQ(job->wait(), 2);
  EXPECT_THAT(job->output(), HasSubstr("process 1 is another build of torse or has another command line"));
}

TEST_F(Mpi, AnErrorOfTheLeaderEndsTheJob) {
  const auto job = start("3", runs_.run("none/a", "1..1000", "1"));
  EXPECT_EQ(job->wait(), 2);
  EXPECT_THAT(job->output(), HasSubstr("unable to open database file"));
}

}  // namespace
}  // namespace torse::testing
