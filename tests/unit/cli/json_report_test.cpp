// JSON reports as they are written.
#include "torse/cli/json_report.hpp"

#include <gtest/gtest.h>

#include "support/program.hpp"

namespace torse::cli {
namespace {

TEST(JsonReport, KeepsItsOrderAndHasTwoBlanksALevel) {
  EXPECT_EQ(json_text({{"torse", 1}, {"a", {1, "2/3"}}}),
            "{\n  \"torse\": 1,\n  \"a\": [\n    1,\n    \"2/3\"\n  ]\n}\n");
}

TEST(JsonReport, IsWrittenWhereItHasAName) {
  const testing::Scratch scratch;
  write_json("", {{"torse", 1}});
  write_json((scratch / "a.json").string(), {{"torse", 1}});
  EXPECT_EQ(testing::slurp(scratch / "a.json"), "{\n  \"torse\": 1\n}\n");
}

}  // namespace
}  // namespace torse::cli
