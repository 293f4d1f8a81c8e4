// Determinants by minors against the sum over all permutations.
#include "torse/algebra/determinant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/symbolic/rational_function.hpp"

namespace torse {
namespace {

template <class Row>
ScalarOf<Row> permutation_sum(const std::vector<Row>& rows) {
  using S = ScalarOf<Row>;
  std::vector<int> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  S sum = from_int<S>(0);
  do {
    int inversions = 0;
    S product = from_int<S>(1);
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) inversions += order[i] > order[j] ? 1 : 0;
      product *= rows[i][order[i]];
    }
    sum += inversions % 2 == 0 ? product : -product;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum;
}

template <class S, int D, class Entry>
std::vector<Vec<S, D>> matrix(Entry entry) {
  std::vector<Vec<S, D>> rows(D);
  for (Vec<S, D>& row : rows) {
    for (int j = 0; j < D; ++j) row[j] = entry();
  }
  return rows;
}

TEST(Determinant, OfIndeterminatesIsThePermutationSum) {
  std::vector<std::string> names;
  for (int i = 0; i < 16; ++i) names.push_back("x" + std::to_string(i));
  const SymbolicContext context(names);
  int next = 0;
  const auto entry = [&] { return context.variable(next++); };
  const auto a = matrix<RationalFunction, 4>(entry);
  EXPECT_EQ(det4<RationalFunction>(a[0], a[1], a[2], a[3]), permutation_sum(a));
  EXPECT_EQ(det4<RationalFunction>(a[0], a[1], a[2], a[3]).length(), 25);
  next = 0;
  const auto b = matrix<RationalFunction, 3>(entry);
  EXPECT_EQ(det3<RationalFunction>(b[0], b[1], b[2]), permutation_sum(b));
  next = 0;
  const auto c = matrix<RationalFunction, 2>(entry);
  EXPECT_EQ(det2<RationalFunction>(c[0][0], c[0][1], c[1][0], c[1][1]), permutation_sum(c));
}

TEST(Determinant, OfRandomRationals) {
  std::mt19937_64 random(6);
  std::uniform_int_distribution<int> value(-9, 9);
  for (int trial = 0; trial < 100; ++trial) {
    const auto a = matrix<Rational, 4>([&] { return ratio<Rational>(value(random), 7); });
    EXPECT_EQ(det4<Rational>(a[0], a[1], a[2], a[3]), permutation_sum(a));
  }
}

}  // namespace
}  // namespace torse
