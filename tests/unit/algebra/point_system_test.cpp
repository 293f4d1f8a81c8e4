// Systems with points on the right: solutions, kernels and certificates, each checked against the given equations.
#include "torse/algebra/point_system.hpp"

#include <gtest/gtest.h>

#include "torse/exact/ball/ball.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {
namespace {

using Q = Rational;
using Pair = Vec<Q, 2>;

struct Given {
  std::vector<std::vector<int>> left;
  std::vector<std::pair<int, int>> right;
};

Form<Q> form(const std::vector<int>& coefficients) {
  Form<Q> f;
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    add_scaled(f, Q(coefficients[j]), Form<Q>::generator(static_cast<int>(j)));
  }
  return f;
}

PointSystem<Q, Pair> system_of(const Given& given) {
  PointSystem<Q, Pair> system(static_cast<int>(given.left.front().size()));
  for (std::size_t i = 0; i < given.left.size(); ++i) {
    system.insert(form(given.left[i]), Pair(Q(given.right[i].first), Q(given.right[i].second)));
  }
  return system;
}

TEST(PointSystem, OneSolution) {
  const Given given{{{2, 1}, {1, 1}, {3, 2}}, {{5, 0}, {3, 1}, {8, 1}}};
  const PointSystem<Q, Pair> system = system_of(given);
  EXPECT_FALSE(system.contradiction());
  EXPECT_TRUE(system.kernel().empty());
  EXPECT_EQ(system.solution(), (std::vector<Pair>{Pair(Q(2), Q(-1)), Pair(Q(1), Q(2))}));
}

TEST(PointSystem, AFamilyLeavesTheFirstUnknownFree) {
  const Given given{{{1, 2, -1}, {0, 1, 3}, {1, 3, 2}}, {{1, 4}, {2, 0}, {3, 4}}};
  const PointSystem<Q, Pair> system = system_of(given);
  ASSERT_FALSE(system.contradiction());
  const std::vector<std::vector<Q>> kernel = system.kernel();
  ASSERT_EQ(kernel.size(), 1U);
  EXPECT_EQ(kernel[0][0], Q(1));
  const std::vector<Pair> x = system.solution();
  EXPECT_EQ(x[0], Pair(Q(0), Q(0)));
  for (std::size_t i = 0; i < given.left.size(); ++i) {
    Pair left(Q(0), Q(0));
    Q homogeneous(0);
    for (std::size_t j = 0; j < 3; ++j) {
      add_scaled(left, Q(given.left[i][j]), x[j]);
      homogeneous += Q(given.left[i][j]) * kernel[0][j];
    }
    EXPECT_EQ(left, Pair(Q(given.right[i].first), Q(given.right[i].second)));
    EXPECT_EQ(homogeneous, Q(0));
  }
}

TEST(PointSystem, AContradictionIsACombinationOfTheEquations) {
  const Given given{{{1, 2}, {2, 4}, {0, 1}, {3, 7}, {1, 1}}, {{1, 1}, {2, 2}, {5, 5}, {8, 9}, {0, 0}}};
  const PointSystem<Q, Pair> system = system_of(given);
  ASSERT_TRUE(system.contradiction());
  std::vector<Q> left(2, Q(0));
  Pair right(Q(0), Q(0));
  for (const auto& term : system.contradiction()->combination.terms()) {
    const std::size_t i = static_cast<std::size_t>(term.generator);
    EXPECT_LT(i, 4U) << "the first contradiction is kept";
    for (std::size_t j = 0; j < 2; ++j) left[j] += term.coefficient * Q(given.left[i][j]);
    add_scaled(right, term.coefficient, Pair(Q(given.right[i].first), Q(given.right[i].second)));
  }
  EXPECT_EQ(left, (std::vector<Q>{Q(0), Q(0)}));
  EXPECT_EQ(right, system.contradiction()->value);
  EXPECT_EQ(right, Pair(Q(0), Q(1)));
}

std::vector<Q> coefficients(const Form<Q>& f) { return {f.coefficient(0), f.coefficient(1)}; }

/// The right sides are the unknown points e_0 and e_1, of which nothing is known but that they differ.
TEST(PointSystem, RightSidesThatAreForms) {
  PointSystem<Q, Form<Q>> system(1);
  system.insert(form({2}), form({4, 6}));
  system.insert(form({3}), form({6, 9}));  // 0 x_0 = 0
  EXPECT_FALSE(system.contradiction());
  EXPECT_EQ(coefficients(system.solution().front()), (std::vector<Q>{Q(2), Q(3)}));
  system.insert(form({1}), form({2, 5}));
  ASSERT_TRUE(system.contradiction());
  EXPECT_EQ(coefficients(system.contradiction()->value), (std::vector<Q>{Q(0), Q(2)}));
}

TEST(PointSystem, BallsDoNotGuess) {
  using Box = Ball<128>;
  const Box third = Box(1) / Box(3);
  Form<Box> left;
  add_scaled(left, third, Form<Box>::generator(0));
  PointSystem<Box, Vec<Box, 1>> system(1);
  system.insert(left, Vec<Box, 1>(third));
  scale(left, third);
  EXPECT_THROW(system.insert(left, Vec<Box, 1>(Box(1))), Undecided);
}

TEST(PointSystem, BallsDoNotGuessAContradiction) {  // 0 x_0 = 1/3 - 1/3
  using Box = Ball<128>;
  const Vec<Box, 1> third(Box(1) / Box(3));
  PointSystem<Box, Vec<Box, 1>> system(1);
  system.insert(Form<Box>::generator(0), third);
  EXPECT_THROW(system.insert(Form<Box>::generator(0), third), Undecided);
}

}  // namespace
}  // namespace torse
