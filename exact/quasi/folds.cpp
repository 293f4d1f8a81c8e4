#include "torse/exact/quasi/folds.hpp"

#include <algorithm>
#include <utility>

#include "torse/algebra/bernstein.hpp"
#include "torse/developable/warp.hpp"

namespace torse {
namespace {

using Q = Rational;

/// Halvings after which a polynomial that is not certified counts as undecided.
constexpr int most_halvings = 40;

/// The sign of a polynomial over [0, 1]: `yes` for f >= 0, `no` with a parameter where f < 0.
struct SignVerdict {
  Truth nonnegative;
  Q at{};
};

SignVerdict sign_of(const Bernstein<Q>& f, const Q& begin, const Q& width, int halvings) {
  const auto negative = [](const Q& b) { return b.sign() < 0; };
  if (std::ranges::none_of(f.coefficients(), negative)) return {Truth::yes};
  if (negative(f[0])) return {Truth::no, begin};
  if (negative(f[f.degree()])) return {Truth::no, begin + width};
  if (halvings == most_halvings) return {Truth::unknown};
  const Q half = width / Q(2);
  const auto [left, right] = f.subdivide(ratio<Q>(1, 2));
  const SignVerdict first = sign_of(left, begin, half, halvings + 1);
  if (first.nonnegative == Truth::no) return first;
  SignVerdict second = sign_of(right, begin + half, half, halvings + 1);
  if (second.nonnegative == Truth::yes) return first;
  return second;
}

}  // namespace

template <int D>
FoldVerdict decide_folds(const KnotList<Q>& u, std::span<const Vec<Q, D>> c, std::span<const Vec<Q, D>> d) {
  FoldVerdict verdict;
  for (const int k : u.proper_pieces()) {
    const auto [m, n] = normal_forms(ruling_forms(u, c, d, k));
    const SignVerdict sign = sign_of(Bernstein<Q>::from_form(dot(m, n)), Q(0), Q(1), 0);
    if (sign.nonnegative == Truth::no) {
      const Q& a = u.piece_begin(k);
      return {Truth::yes, RulingPlace{k, a + sign.at * (u.piece_end(k) - a)}};
    }
    if (sign.nonnegative == Truth::unknown) verdict.folded = Truth::unknown;
  }
  return verdict;
}

template FoldVerdict decide_folds<3>(const KnotList<Q>&, std::span<const Vec<Q, 3>>, std::span<const Vec<Q, 3>>);
template FoldVerdict decide_folds<4>(const KnotList<Q>&, std::span<const Vec<Q, 4>>, std::span<const Vec<Q, 4>>);

}  // namespace torse
