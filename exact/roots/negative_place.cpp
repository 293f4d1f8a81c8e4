#include "torse/exact/roots/negative_place.hpp"

#include <algorithm>
#include <vector>

#include "torse/exact/roots/real_roots.hpp"

namespace torse {
namespace {

using Q = Rational;

/// Roots cost more than some halvings, but tell a double zero from two.
constexpr int most_halvings = 12;

struct Halved {
  bool decided;
  std::optional<Q> place{};
};

/// By halvings of [begin, begin + width], on which f has these coefficients.
Halved by_halvings(const Bernstein<Q>& f, const Q& begin, const Q& width, int halvings) {
  const auto negative = [](const Q& b) { return b.sign() < 0; };
  if (std::ranges::none_of(f.coefficients(), negative)) return {true};
  if (negative(f[0])) return {true, begin};
  if (negative(f[f.degree()])) return {true, begin + width};
  if (halvings == most_halvings) return {false};
  const Q half = width / Q(2);
  const auto [left, right] = f.subdivide(ratio<Q>(1, 2));
  const Halved first = by_halvings(left, begin, half, halvings + 1);
  if (first.place) return first;
  Halved second = by_halvings(right, begin + half, half, halvings + 1);
  second.decided = second.place || (first.decided && second.decided);
  return second;
}

/// f has the signs of F(x) = sum_i f_i x^i with x = t / (1 - t), f_i being the coefficients of its form.
std::optional<Q> between_roots(const Bernstein<Q>& f) {
  const BinaryForm<Q> form = f.form();
  std::vector<Q> coefficients;
  for (int i = 0; i <= form.degree(); ++i) coefficients.push_back(form[i]);
  std::vector<Q> places;
  Q left(0);
  for (const RealRoot& root : real_roots(coefficients, 1)) {
    if (root.upper.sign() <= 0) continue;
    places.push_back((left + root.lower) / Q(2));
    left = root.upper;
  }
  places.push_back(left + Q(1));
  for (const Q& x : places) {
    const Q t = x / (Q(1) + x);
    if (f(t).sign() < 0) return t;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Q> negative_place(const Bernstein<Q>& f) {
  const Halved halved = by_halvings(f, Q(0), Q(1), 0);
  return halved.decided ? halved.place : between_roots(f);
}

}  // namespace torse
