// Three-valued logic: the tables of Kleene's strong logic, written out, and its laws over all arguments.
#include "torse/scalar/truth.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace torse {
namespace {

constexpr Truth N = Truth::no;
constexpr Truth U = Truth::unknown;
constexpr Truth Y = Truth::yes;
constexpr std::array<Truth, 3> all{N, U, Y};

// A truth table in the order no, unknown, yes of both arguments.
using Table = std::array<std::array<Truth, 3>, 3>;

TEST(Truth, AndIsKleenes) {
  constexpr Table expected{{{N, N, N}, {N, U, U}, {N, U, Y}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(all[i] & all[j], expected[i][j]) << i << " & " << j;
}

TEST(Truth, OrIsKleenes) {
  constexpr Table expected{{{N, U, Y}, {U, U, Y}, {Y, Y, Y}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(all[i] | all[j], expected[i][j]) << i << " | " << j;
}

TEST(Truth, NotKeepsUnknown) {
  EXPECT_EQ(!N, Y);
  EXPECT_EQ(!U, U);
  EXPECT_EQ(!Y, N);
}

// An unknown stands for either answer: a result is decided exactly when both answers give the same one.
TEST(Truth, DecidedExactlyWhenEveryCompletionAgrees) {
  auto completions = [](Truth t) { return t == U ? std::array{false, true} : std::array{t == Y, t == Y}; };
  auto agreed = [&](Truth a, Truth b, auto op) {
    bool some_yes = false, some_no = false;
    for (bool x : completions(a))
      for (bool y : completions(b)) (op(x, y) ? some_yes : some_no) = true;
    return some_yes && some_no ? U : truth(some_yes);
  };
  for (Truth a : all)
    for (Truth b : all) {
      EXPECT_EQ(a & b, agreed(a, b, [](bool x, bool y) { return x && y; }));
      EXPECT_EQ(a | b, agreed(a, b, [](bool x, bool y) { return x || y; }));
      EXPECT_EQ(!(a & b), (!a) | (!b));
    }
}

TEST(Truth, DefinitelyAndPossiblySayWhatUnknownMeans) {
  EXPECT_TRUE(definitely(Y) && possibly(Y));
  EXPECT_TRUE(!definitely(U) && possibly(U));
  EXPECT_TRUE(!definitely(N) && !possibly(N));
  for (Truth a : all) EXPECT_EQ(definitely(a), !possibly(!a));
  EXPECT_EQ(truth(true), Y);
  EXPECT_EQ(truth(false), N);
}

TEST(Truth, DoesNotConvertToBool) {
  EXPECT_FALSE((std::is_convertible_v<Truth, bool>));
  EXPECT_FALSE((std::is_convertible_v<bool, Truth>));
}

}  // namespace
}  // namespace torse
