// The cases that once failed, each saved by a fuzzing run or written by hand: all of them hold now.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "torse/fuzz/run.hpp"
#include "torse/io/file.hpp"

namespace torse::fuzz {
namespace {

const std::filesystem::path folder = std::filesystem::path(TORSE_SOURCE_PATH) / "tests/regress/cases";

std::vector<std::filesystem::path> saved_cases() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class SavedCases : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(SavedCases, Hold) {
  const std::string file = GetParam().string();
  const CaseReport report = replay_case(Document(file, read_file(file)));
  EXPECT_EQ(report.result, CaseResult::held) << report.message;
}

INSTANTIATE_TEST_SUITE_P(Regress, SavedCases, ::testing::ValuesIn(saved_cases()),
                         [](const auto& param) { return param.param.stem().string(); });

}  // namespace
}  // namespace torse::fuzz
