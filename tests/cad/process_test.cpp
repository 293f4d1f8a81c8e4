// The plugin in its child process: answers come back, whatever goes wrong there is one error here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "torse/cli/cad_process.hpp"

namespace torse::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string error_of(const std::function<std::string(CadFormats&)>& task) {
  try {
    run_cad("part.step", 0, task);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CadProcess, AnswersOfAnyLengthComeBack) {
  EXPECT_THAT(run_cad("part.step", 0, [](CadFormats& formats) { return formats.version(); }),
              StartsWith("OpenCASCADE 7."));
  const std::string bytes(3'000'000, '\0');
  EXPECT_EQ(run_cad("part.step", 0, [&](CadFormats&) { return bytes; }), bytes);
  EXPECT_EQ(run_cad("part.step", 0, [](CadFormats&) { return std::string(); }), "");
}

TEST(CadProcess, FailuresOfTheChildAreErrorsOfTheFile) {
  EXPECT_EQ(error_of([](CadFormats&) -> std::string { throw Error("no faces"); }), "part.step: no faces");
  EXPECT_THAT(error_of([](CadFormats&) -> std::string { std::abort(); }), HasSubstr("it crashed"));
  EXPECT_THAT(error_of([](CadFormats&) -> std::string { std::_Exit(3); }), HasSubstr("it crashed"));
}

TEST(CadProcess, TheChildWritesNothingOnStandardOutput) {
  ::testing::internal::CaptureStdout();
  run_cad("part.step", 0, [](CadFormats&) {
    std::printf("noise");
    std::fflush(stdout);
    return std::string();
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace torse::cli
