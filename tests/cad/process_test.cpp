// The plugin in its child process: answers come back, whatever goes wrong there is one error here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "torse/cli/cad_process.hpp"

namespace torse::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::exception_ptr failure_of(const std::function<std::string(CadFormats&)>& task) {
  try {
    run_cad("part.step", task);
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

std::string message_of(const std::exception_ptr& failure) {
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of(const std::function<std::string(CadFormats&)>& task) { return message_of(failure_of(task)); }

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

/// The child holds an end of a pipe, which closes when it ends.
TEST(CadProcess, TheChildEndsWithItsParent) {
  int held[2];
  ASSERT_EQ(pipe(held), 0);
  const pid_t parent = fork();
  ASSERT_GE(parent, 0);
  if (parent == 0) {
    close(held[0]);
    error_of([&](CadFormats&) -> std::string {
      const pid_t child = getpid();
      while (write(held[1], &child, sizeof child) == sizeof child) pause();
      return "";
    });
    std::_Exit(1);
  }
  close(held[1]);
  pid_t child = 0;
  ASSERT_EQ(read(held[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  kill(parent, SIGKILL);
  EXPECT_EQ(waitpid(parent, nullptr, 0), parent);
  pollfd end{held[0], POLLIN, 0};
  EXPECT_EQ(poll(&end, 1, 5000), 1) << "it goes on";
  close(held[0]);
  kill(child, SIGKILL);
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

/// A child that waits uses no processor time: four times as many seconds later it is ended.
TEST(CadProcess, AChildThatWaitsIsEnded) {
  const auto asleep = [](CadFormats&) -> std::string {
    for (;;) pause();
  };
  try {
    run_cad("part.step", asleep, 1);
    ADD_FAILURE() << "it ended";
  } catch (const CadCrash& crash) {
    EXPECT_EQ(crash.reason(), "OpenCASCADE fails on it: it did not end in 1 seconds");
    EXPECT_EQ(crash.seconds_left(), 0U);
  }
}

/// A lower limit of this process, and of its children, while it lives.
class Limit {
 public:
  Limit(__rlimit_resource resource, rlim_t most) : resource_(resource) {
    getrlimit(resource, &old_);
    const rlimit limit{most, old_.rlim_max};
    setrlimit(resource, &limit);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  ~Limit() { setrlimit(resource_, &old_); }

 private:
  __rlimit_resource resource_;
  rlimit old_{};
};

std::string reason(int error) { return std::string("part.step: cannot be read: ") + std::strerror(error); }

TEST(CadProcess, WithoutAPipeThereIsAnError) {
  const int first_free = dup(STDERR_FILENO);
  close(first_free);
  const auto failure = [&] {
    const Limit files(RLIMIT_NOFILE, static_cast<rlim_t>(first_free));  // sanitizers need files to look at an object
    return failure_of([](CadFormats&) { return std::string(); });
  }();
  EXPECT_EQ(message_of(failure), reason(EMFILE));
}

/// In a process of its own: root has no limit of processes, and who has given up being root cannot go back.
TEST(CadProcess, WithoutAChildThereIsAnError) {
  const auto without = [] {
    if (getuid() == 0 && setuid(65534) != 0) std::_Exit(2);
    const Limit processes(RLIMIT_NPROC, 0);
    std::_Exit(error_of([](CadFormats&) { return std::string(); }) == reason(EAGAIN) ? 0 : 1);
  };
  EXPECT_EXIT(without(), ::testing::ExitedWithCode(0), "");
}

/// The system takes the part of the file for which there is room, and tells why no more only when asked again.
TEST(CadProcess, AFileWithoutRoomInMemoryIsAnError) {
  const auto old = signal(SIGXFSZ, SIG_IGN);
  {
    const Limit size(RLIMIT_FSIZE, 4096);
    try {
      errno = 0;
      read_cad("part.step", CadFormat::step, std::string(8192, ' '));
      ADD_FAILURE() << "it was read";
    } catch (const FileError& error) {
      EXPECT_STREQ(error.what(),
                   (std::string("part.step: cannot be copied to memory: ") + std::strerror(EFBIG)).c_str());
    }
  }
  signal(SIGXFSZ, old);
}

}  // namespace
}  // namespace torse::cli
