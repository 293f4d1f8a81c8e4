// One ruling by its definition: the four rows at a parameter, and whether the patch is singular there.
//   Ruling, ruling_at     p, p', q, q' of a piece at t             rank_of, parallel, sum    of rows
//   edge_side             where the edge of regression meets a ruling
//   singular_at           why the closed ruling between c(t) and d(t) has a singular point
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz::plain {

using Row = Vec<Rational, 4>;

/// p, p', q, q' at a parameter.
struct Ruling {
  Row p;
  Row dp;
  Row q;
  Row dq;
};

Ruling ruling_at(const Strip& strip, int j, const Rational& t);

int rank_of(std::initializer_list<Row> rows);
/// Whether the rank is at most 1.
bool parallel(const Row& x, const Row& y);
/// a x + b y.
Row sum(const Rational& a, const Row& x, const Rational& b, const Row& y);

/// On a developable piece: 1 if the one point x p + y q whose derivative x p' + y q' lies in the ruling is between c(t)
/// and d(t), 0 if it is one of them, -1 if neither; none where there is no such point or more than one. The weights are
/// not 0.
std::optional<int> edge_side(const Ruling& at);

/// On a developable piece that is a surface: "pole" where a weight is 0, "vanishing" for c(t) = d(t), "stationary"
/// where the four rows have rank 2 and every point of the ruling is singular, "edge" if the one point x p + y q whose
/// derivative x p' + y q' lies in the ruling is between c(t) and d(t) or at one of them; empty if the ruling is
/// regular.
std::string_view singular_at(const Ruling& at);

}  // namespace torse::fuzz::plain
