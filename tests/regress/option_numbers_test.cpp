// Numbers after options are what they say, or refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

/// A limit of 64 bits, of 32 bits, none at all: below, above, octal, with letters, with a fraction.
TEST(OptionNumbers, WhatIsNoneIsRefused) {
  const std::string whole = ": expected a whole number from 0 to 18446744073709551615, found ";
  const std::string integer = ": expected a whole number from -2147483648 to 2147483647, found ";
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"verify", "--seed", "-1"}, "--seed" + whole + "-1\n"},
      {{"verify", "--seed", "99999999999999999999"}, "--seed" + whole + "99999999999999999999\n"},
      {{"verify", "--seed", "18446744073709551616"}, "--seed" + whole + "18446744073709551616\n"},
      {{"verify", "--seed", "010"}, "--seed" + whole + "010\n"},
      {{"verify", "--seed", "0x10"}, "--seed" + whole + "0x10\n"},
      {{"verify", "--seed", "+1"}, "--seed" + whole + "+1\n"},
      {{"verify", "--seed", "1.5"}, "--seed" + whole + "1.5\n"},
      {{"verify", "--seed", "1e3"}, "--seed" + whole + "1e3\n"},
      {{"verify", "--seed", " 1"}, "--seed" + whole},
      {{"verify", "--threads", "010"}, "--threads" + whole + "010\n"},
      {{"study", "gap", "--seed", "-1"}, "--seed" + whole + "-1\n"},
      {{"study", "gap", "--threads", "x"}, "--threads" + whole + "x\n"},
      {{"campaign", "run", "--db", "/nowhere/x", "--jobs", "010"}, "--jobs" + whole + "010\n"},
      {{"campaign", "run", "--db", "/nowhere/x", "--minutes", "x"}, "--minutes: expected a number, found x\n"},
      {{"campaign", "run", "--db", "/nowhere/x", "--minutes", "nan"}, "--minutes: expected a number, found nan\n"},
      {{"construct", "interpolate", "x", "-o", "-", "--branch", "x"}, "--branch" + integer + "x\n"},
      {{"construct", "interpolate", "x", "-o", "-", "--branch", "2147483648"}, "--branch" + integer + "2147483648\n"},
      {{"fit", "x", "-o", "-", "--degree", "02"}, "--degree" + integer + "02\n"},
      {{"fit", "x", "-o", "-", "--coefficients", "1e2"}, "--coefficients" + integer + "1e2\n"},
      {{"unroll", "x", "-o", "-", "--rulings", "5.5"}, "--rulings" + integer + "5.5\n"}};
  for (const auto& [words, message] : wrong) {
    const ProgramResult run = run_program(words);
    EXPECT_EQ(run.exit, 2) << message;
    EXPECT_THAT(run.err, HasSubstr("torse: error: " + message));
    EXPECT_THAT(run.err, HasSubstr("\ntry: torse "));
    EXPECT_EQ(run.out, "");
  }
}

TEST(OptionNumbers, AsLargeAsTheyMayBe) {
  for (const char* seed : {"0", "7", "18446744073709551615"}) {
    const ProgramResult run =
        run_program({"verify", "--claim", "FJ07.16", "--engine", "rational", "--effort", "quick", "--seed", seed});
    EXPECT_THAT(run.out, HasSubstr(std::string(", seed ") + seed + ", ")) << run.err;
  }
}

}  // namespace
}  // namespace torse::testing
