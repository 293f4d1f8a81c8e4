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
    run_cad("part.step", task);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CadProcess, AnswersOfAnyLengthComeBack) {
  EXPECT_THAT(run_cad("part.step", [](CadFormats& formats) { return formats.version(); }),
              StartsWith("OpenCASCADE 7."));
  const std::string bytes(3'000'000, '\0');
  EXPECT_EQ(run_cad("part.step", [&](CadFormats&) { return bytes; }), bytes);
  EXPECT_EQ(run_cad("part.step", [](CadFormats&) { return std::string(); }), "");
}

TEST(CadProcess, FailuresOfTheChildAreErrorsOfTheFile) {
  EXPECT_EQ(error_of([](CadFormats&) -> std::string { throw Error("no faces"); }), "part.step: no faces");
  EXPECT_THAT(error_of([](CadFormats&) -> std::string { std::abort(); }), HasSubstr("it crashed"));
  EXPECT_THAT(error_of([](CadFormats&) -> std::string { std::_Exit(3); }), HasSubstr("it crashed"));
}

TEST(CadProcess, AChildThatTakesLongerThanItMayIsAnError) {
  volatile unsigned turns = 0;
  const auto forever = [&](CadFormats&) -> std::string {
    while (turns + 1 != 0) turns = turns + 2;
    return "";
  };
  try {
    run_cad("part.step", forever, 1);
    ADD_FAILURE() << "it ended";
  } catch (const CadCrash& crash) {
    EXPECT_THAT(crash.reason(), HasSubstr("it did not end in 1 seconds"));
    EXPECT_EQ(crash.seconds_left(), 0U);
  }
}

// The memory of sanitized programs has no limit, so they have no such test.
#if defined(__SANITIZE_ADDRESS__)
#define TORSE_UNLIMITED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TORSE_UNLIMITED
#endif
#endif
#ifndef TORSE_UNLIMITED
TEST(CadProcess, AChildThatNeedsMoreMemoryThanItMayIsAnError) {
  EXPECT_THAT(error_of([](CadFormats&) -> std::string { return std::string(limits::cad_memory, 'x'); }),
              HasSubstr("needs more than 768 MiB"));
}
#endif

TEST(CadProcess, ACrashLeavesTheRestOfTheTime) {
  try {
    run_cad("part.step", [](CadFormats&) -> std::string { std::abort(); });
    ADD_FAILURE() << "it did not crash";
  } catch (const CadCrash& crash) {
    EXPECT_GT(crash.seconds_left(), 0U);
    EXPECT_LT(crash.seconds_left(), limits::cad_seconds);
  }
}

TEST(CadProcess, TheChildWritesNothingOnStandardOutput) {
  ::testing::internal::CaptureStdout();
  run_cad("part.step", [](CadFormats&) {
    std::printf("noise");
    std::fflush(stdout);
    return std::string();
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace torse::cli
