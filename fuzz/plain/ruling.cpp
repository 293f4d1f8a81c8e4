#include "torse/fuzz/plain/ruling.hpp"

#include <cstddef>
#include <vector>

#include "torse/fuzz/plain/elimination.hpp"

namespace torse::fuzz::plain {

Ruling ruling_at(const Strip& strip, int j, const Rational& t) {
  const PolyRow<4>& p = strip.p.rows[static_cast<std::size_t>(j)];
  const PolyRow<4>& q = strip.q.rows[static_cast<std::size_t>(j)];
  return {value_at<4>(p, t), value_at<4>(derivative<4>(p), t), value_at<4>(q, t), value_at<4>(derivative<4>(q), t)};
}

int rank_of(std::initializer_list<Row> rows) {
  Rows<4> span;
  for (const Row& x : rows) span.insert(x);
  return span.rank();
}

bool parallel(const Row& x, const Row& y) { return rank_of({x, y}) <= 1; }

Row sum(const Rational& a, const Row& x, const Rational& b, const Row& y) {
  Row result;
  for (int i = 0; i < 4; ++i) result[i] = a * x[i] + b * y[i];
  return result;
}

std::optional<int> edge_side(const Ruling& at) {
  // (a, b, x, y) with a p + b q + x p' + y q' = 0 in every coordinate.
  Rows<4> coordinates;
  for (int i = 0; i < 4; ++i) coordinates.insert(Row(at.p[i], at.q[i], at.dp[i], at.dq[i]));
  const std::vector<Row> dependences = coordinates.orthogonal();
  if (dependences.size() != 1) return std::nullopt;
  const Row& dependence = dependences.front();
  return Rational(dependence[2] * at.p[0] * dependence[3] * at.q[0]).sign();
}

std::string_view singular_at(const Ruling& at) {
  if (at.p[0].sign() == 0 || at.q[0].sign() == 0) return "pole";
  if (parallel(at.p, at.q)) return "vanishing";
  const std::optional<int> side = edge_side(at);
  if (!side) return "stationary";
  return *side >= 0 ? "edge" : "";
}

}  // namespace torse::fuzz::plain
