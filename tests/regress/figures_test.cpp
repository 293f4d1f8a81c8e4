// torse figures through the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

TEST(Figures, WritesThoseOfAPaper) {
  const Scratch scratch;
  const ProgramResult result = run_program({"figures", "ZW06", "-o", (scratch / "new/folder").string()});
  EXPECT_EQ(result.exit, 0) << result.err;
  EXPECT_EQ(files_in(scratch / "new/folder"), 7U);
  EXPECT_THAT(slurp(scratch / "new/folder/ZW06.Fig7.svg"), HasSubstr("rho = 9/10, sigma = 11/10"));
}

TEST(Figures, ListsAllWithoutAFolder) {
  const ProgramResult result = run_program({"figures"});
  EXPECT_EQ(result.exit, 0);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 22);
}

TEST(Figures, KnowsNoOther) {
  const ProgramResult result = run_program({"figures", "FJ07.Fig9"});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("did you mean FJ07.Fig"));
}

TEST(Figures, SaysWhereItCannotWrite) {
  const Scratch scratch;
  spill(scratch / "file", "");
  const ProgramResult result = run_program({"figures", "FJ07.Fig1", "-o", (scratch / "file").string()});
  EXPECT_EQ(result.exit, 2);
  EXPECT_THAT(result.err, HasSubstr("cannot be made"));
}

}  // namespace
}  // namespace torse::testing
