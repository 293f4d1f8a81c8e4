// The notes of a program, written byte by byte.
#include "torse/cli/build_id.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace torse::cli {
namespace {

std::string padded(std::string bytes) {
  bytes.resize((bytes.size() + 3) / 4 * 4);
  return bytes;
}

std::string note(std::uint32_t type, const std::string& owner, const std::string& description) {
  const std::uint32_t head[]{static_cast<std::uint32_t>(owner.size()), static_cast<std::uint32_t>(description.size()),
                             type};
  std::string bytes(sizeof head, 0);
  std::memcpy(bytes.data(), head, sizeof head);
  return bytes + padded(owner) + padded(description);
}

const std::string gnu("GNU", 4);
const std::string id = note(3, gnu, "\x01\xAB\x7f");

TEST(BuildId, IsTheNoteOfThisTypeAndOwner) {
  EXPECT_EQ(id_among(id), "01ab7f");
  // The system that is asked for, another program's note of the same number, and of a longer name.
  const std::string others = note(1, gnu, "abcd") + note(3, std::string("go\0", 3), "xy") + note(3, "GNU-like", "z");
  EXPECT_EQ(id_among(others + id + note(3, gnu, "later")), "01ab7f");
  EXPECT_EQ(id_among(others), "");
}

TEST(BuildId, NotesThatEndTooSoonAreNone) {
  EXPECT_EQ(id_among(""), "");
  for (std::size_t size = 0; size < id.size(); ++size) EXPECT_EQ(id_among(id.substr(0, size)), "") << size;
}

TEST(BuildId, OfThisProgram) {
  EXPECT_EQ(build_id().find_first_not_of("0123456789abcdef"), std::string::npos) << build_id();
  EXPECT_GE(build_id().size(), 16U);
}

}  // namespace
}  // namespace torse::cli
