// Records that are kept while a study runs: they belong to one run.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "torse/io/document.hpp"
#include "torse/studies/run.hpp"

namespace torse::studies {
namespace {

Task small_task() {
  Task task;
  task.design = built_in_design("routes");
  return task;
}

TEST(Journal, GoesOnWithTheRecordsOfItsRunOnly) {
  const testing::Scratch scratch;
  const std::string file = (scratch / "k.part").string();
  {
    Journal journal(file, small_task(), "build", false);
    journal.store({{3, "three"}});
  }
  EXPECT_EQ(Journal(file, small_task(), "build", true).record(3), "three");
  Task other = small_task();
  other.seed = 2;
  EXPECT_THROW(Journal(file, other, "build", true), FileError);
  other = small_task();
  other.shards = 2;
  EXPECT_THROW(Journal(file, other, "build", true), FileError);
  other = small_task();
  other.effort = proofs::Effort::deep;
  EXPECT_THROW(Journal(file, other, "build", true), FileError);
  other = small_task();
  other.design = built_in_design("near-knot");
  EXPECT_THROW(Journal(file, other, "build", true), FileError);
  EXPECT_THROW(Journal(file, small_task(), "another build", true), FileError);
  EXPECT_EQ(Journal(file, small_task(), "build", true).record(3), "three");
  EXPECT_EQ(Journal(file, small_task(), "build", false).record(3), "");
}

}  // namespace
}  // namespace torse::studies
