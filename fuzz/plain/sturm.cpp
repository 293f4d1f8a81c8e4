#include "torse/fuzz/plain/sturm.hpp"

namespace torse::fuzz::plain {
namespace {

Poly trimmed(Poly f) {
  while (!f.empty() && f.back().sign() == 0) f.pop_back();
  return f;
}

/// f = quotient g + rest.
struct Division {
  Poly quotient;
  Poly rest;
};

Division divided(Poly f, const Poly& g) {
  Division result;
  if (f.size() >= g.size()) result.quotient.resize(f.size() - g.size() + 1);
  while (f.size() >= g.size()) {
    const Rational factor = f.back() / g.back();
    const std::size_t shift = f.size() - g.size();
    result.quotient[shift] = factor;
    for (std::size_t i = 0; i < g.size(); ++i) f[shift + i] -= factor * g[i];
    f.pop_back();
    f = trimmed(std::move(f));
  }
  result.rest = std::move(f);
  return result;
}

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

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

/// Sturm's sequence of f without its repeated roots, where the sequence of f itself would vanish as a whole: divided by
/// its last member, the greatest common divisor.
std::vector<Poly> sturm_sequence(const Poly& f) {
  std::vector<Poly> sequence{trimmed(f), trimmed(derivative(trimmed(f)))};
  while (!sequence.back().empty()) {
    // Signs are all that counts; a leading coefficient of -1 or 1 keeps the numbers short.
    const Poly rest = divided(sequence[sequence.size() - 2], sequence.back()).rest;
    const Rational factor = rest.empty() ? Rational(1) : Rational(1) / magnitude(rest.back());
    sequence.push_back(scaled(-factor, rest));
  }
  sequence.pop_back();
  const Poly divisor = sequence.back();
  for (Poly& g : sequence) g = divided(std::move(g), divisor).quotient;
  return sequence;
}

int roots_between(const std::vector<Poly>& sequence, const Rational& a, const Rational& b) {
  return variations(sequence, a) - variations(sequence, b);
}

/// By halving until an interval has no root inside, or one between two positive ends.
std::optional<Rational> negative_inside(const Poly& f, const std::vector<Poly>& sequence, const Rational& a,
                                        const Rational& b) {
  const Rational middle = (a + b) / Rational(2);
  if (value(f, middle).sign() < 0) return middle;
  const int at_b = value(f, b).sign();
  const int inside = roots_between(sequence, a, b) - (at_b == 0 ? 1 : 0);
  if (inside == 0 || (inside == 1 && value(f, a).sign() > 0 && at_b > 0)) return std::nullopt;
  if (const std::optional<Rational> x = negative_inside(f, sequence, a, middle)) return x;
  return negative_inside(f, sequence, middle, b);
}

}  // namespace

int roots_between(const Poly& f, const Rational& a, const Rational& b) {
  return roots_between(sturm_sequence(f), a, b);
}

std::optional<Rational> negative_inside(const Poly& f, const Rational& a, const Rational& b) {
  if (trimmed(f).empty()) return std::nullopt;
  return negative_inside(f, sturm_sequence(f), a, b);
}

}  // namespace torse::fuzz::plain
