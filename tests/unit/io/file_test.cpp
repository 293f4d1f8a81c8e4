// Files are written all or nothing.
#include "torse/io/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "support/program.hpp"

namespace torse {
namespace {

using testing::Scratch;
using testing::slurp;
using testing::spill;

std::size_t entries(const Scratch& scratch) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(scratch.path()), {}));
}

TEST(File, ReplacesTheOldOneAndLeavesNothingElse) {
  const Scratch scratch;
  const std::string path = (scratch / "a b.json").string();
  write_file(path, "one");
  write_file(path, std::string("t\0wo", 4));
  EXPECT_EQ(read_file(path), std::string("t\0wo", 4));
  EXPECT_EQ(entries(scratch), 1U);
}

TEST(File, MayHaveTheLongestNameThereIs) {
  const Scratch scratch;
  const std::string path = (scratch / std::string(255, 'x')).string();
  write_file(path, "one");
  write_file(path, "two");
  EXPECT_EQ(slurp(path), "two");
  EXPECT_EQ(entries(scratch), 1U);
}

/// Numbers of files that this process has open.
std::size_t open_files() {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

TEST(File, NoneStaysOpen) {
  const Scratch scratch;
  const std::string path = (scratch / "a.json").string();
  const std::size_t before = open_files();
  write_file(path, "one");
  read_file(path);
  EXPECT_THROW(write_file("/dev/full", "one"), FileError);
  EXPECT_EQ(open_files(), before);
}

TEST(File, FollowsLinksAndKeepsPermissions) {
  namespace fs = std::filesystem;
  const Scratch scratch;
  spill(scratch / "target", "old");
  fs::permissions(scratch / "target", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(scratch / "target", scratch / "link");
  write_file((scratch / "link").string(), "new");
  EXPECT_TRUE(fs::is_symlink(scratch / "link"));
  EXPECT_EQ(slurp(scratch / "target"), "new");
  EXPECT_EQ(fs::status(scratch / "target").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(File, AFailureLeavesTheFolderAsItWas) {
  const Scratch scratch;
  EXPECT_THROW(write_file((scratch / "no/such.json").string(), "x"), FileError);
  EXPECT_THROW(write_file(scratch.path().string(), "x"), FileError);
  EXPECT_THROW(write_file("/dev/full", "x"), FileError);
  EXPECT_EQ(entries(scratch), 0U);
  EXPECT_TRUE(std::filesystem::exists("/dev/full"));
}

TEST(File, ADiskThatFillsUpLeavesTheOldFile) {
  const Scratch scratch;
  const std::string path = (scratch / "file").string();
  write_file(path, "old");
  // A limit on the size of files stands for a full disk.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit tight{100, before.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::string message;
  try {
    write_file(path, std::string(100'000, 'x'));
  } catch (const FileError& error) {
    message = error.reason();
  }
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(message.substr(0, 18), "cannot be written:");
  EXPECT_EQ(slurp(path), "old");
  EXPECT_EQ(entries(scratch), 1U);
}

/// The reason that a folder cannot be made.
std::string refusal(const std::string& folder) {
  try {
    make_folder(folder);
  } catch (const FileError& error) {
    EXPECT_EQ(error.file(), folder);
    return error.reason();
  }
  return "made";
}

TEST(File, AFolderThatCannotBeMadeIsNamed) {
  const Scratch scratch;
  const std::string folder = (scratch / "a/b").string();
  EXPECT_EQ(refusal(folder), "made");
  EXPECT_EQ(refusal(folder), "made");
  EXPECT_EQ(refusal(folder + "/" + std::string(300, 'x')), "cannot be made: File name too long");
  spill(scratch / "file", "");
  EXPECT_EQ(refusal((scratch / "file").string()), "cannot be made: Not a directory");
  EXPECT_EQ(refusal((scratch / "file/c").string()), "cannot be made: Not a directory");
}

TEST(File, WhatCannotBeReadIsNamed) {
  const Scratch scratch;
  for (const std::string& path : {(scratch / "none").string(), scratch.path().string(), std::string("/dev/zero")}) {
    try {
      read_file(path);
      FAIL() << path;
    } catch (const FileError& error) {
      EXPECT_EQ(error.file(), path);
    }
  }
}

}  // namespace
}  // namespace torse
