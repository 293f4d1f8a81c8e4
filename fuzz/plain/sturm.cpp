#include "torse/fuzz/plain/sturm.hpp"

namespace torse::fuzz::plain {
namespace {

Poly trimmed(Poly f) {
  while (!f.empty() && f.back().sign() == 0) f.pop_back();
  return f;
}

/// -(f mod g).
Poly negative_rest(Poly f, const Poly& g) {
  while (f.size() >= g.size()) {
    const Rational factor = f.back() / g.back();
    const std::size_t shift = f.size() - g.size();
    for (std::size_t i = 0; i < g.size(); ++i) f[shift + i] -= factor * g[i];
    f.pop_back();
    f = trimmed(std::move(f));
  }
  return scaled(Rational(-1), std::move(f));
}

int variations(const std::vector<Poly>& sequence, const Rational& x) {
  int count = 0;
  int before = 0;
  for (const Poly& f : sequence) {
    const int sign = value(f, x).sign();
    if (sign == 0) continue;
    if (sign == -before) ++count;
    before = sign;
  }
  return count;
}

}  // namespace

int roots_between(const Poly& f, const Rational& a, const Rational& b) {
  std::vector<Poly> sequence{trimmed(f), trimmed(derivative(trimmed(f)))};
  while (!sequence.back().empty()) {
    sequence.push_back(negative_rest(sequence[sequence.size() - 2], sequence.back()));
  }
  return variations(sequence, a) - variations(sequence, b);
}

}  // namespace torse::fuzz::plain
