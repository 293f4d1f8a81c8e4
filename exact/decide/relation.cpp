// The candidate modulo a prime, its reconstruction, and the exact check.
#include "torse/exact/decide/relation.hpp"

#include <flint/flint.h>
#include <flint/nmod_vec.h>
#include <flint/ulong_extras.h>

#include <cstdint>
#include <utility>

namespace torse {
namespace {

using Word = std::uint64_t;

constexpr Word prime = RelationProver<3>::prime;

const nmod_t& field() {
  static const nmod_t value = [] {
    nmod_t mod;
    nmod_init(&mod, prime);
    return mod;
  }();
  return value;
}

Word times(Word a, Word b) { return nmod_mul(a, b, field()); }
Word minus(Word a, Word b) { return nmod_sub(a, b, field()); }
Word residue(mpz_srcptr x) { return mpz_fdiv_ui(x, prime); }

/// The residues of four numbers times the product of their denominators.
std::array<Word, 4> residues(const std::array<const Rational*, 4>& x) {
  std::array<Word, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = residue(mpq_numref(x[i]->mpq()));
  for (std::size_t i = 0; i < 4; ++i) {
    const mpz_srcptr denominator = mpq_denref(x[i]->mpq());
    if (mpz_cmp_ui(denominator, 1) == 0) continue;
    const Word factor = residue(denominator);
    for (std::size_t other = 0; other < 4; ++other) {
      if (other != i) result[other] = times(result[other], factor);
    }
  }
  return result;
}

/// Homogeneous linear equations in `size` unknowns modulo the prime, kept in echelon form without divisions.
template <std::size_t size>
class Equations {
 public:
  using Row = std::array<Word, size>;

  void add(Row row) {
    for (std::size_t j = 0; j < size; ++j) {
      if (row[j] == 0) continue;
      if (!pivot_[j]) {
        pivot_[j] = row;
        return;
      }
      const Word mine = row[j];
      for (std::size_t i = j; i < size; ++i)
        row[i] = minus(times(row[i], (*pivot_[j])[j]), times(mine, (*pivot_[j])[i]));
    }
  }

  /// A solution with one unknown equal to 1, if there is one that is not zero.
  std::optional<Row> solution() const {
    std::size_t free = 0;
    while (free < size && pivot_[free]) ++free;
    if (free == size) return std::nullopt;
    Row x{};
    x[free] = 1;
    for (std::size_t j = free; j-- > 0;) {  // unknowns beyond the first free one are zero
      Word sum = 0;
      for (std::size_t i = j + 1; i <= free; ++i) sum = nmod_add(sum, times((*pivot_[j])[i], x[i]), field());
      for (std::size_t i = j + 1; i <= free; ++i) x[i] = times(x[i], (*pivot_[j])[j]);
      x[j] = nmod_neg(sum, field());
    }
    const Word inverse = n_invmod(x[free], prime);
    for (Word& value : x) value = times(value, inverse);
    return x;
  }

 private:
  std::array<std::optional<Row>, size> pivot_;
};

/// A fraction of two 31-bit numbers.
struct Fraction {
  std::int64_t num;
  Word den;
};

/// The fraction with |num|, den < 2^31 that is x modulo the prime, if there is one (P. Wang, A p-adic algorithm for
/// univariate partial fractions, SYMSAC 1981): there is at most one, since 2 (2^31)^2 <= prime + 25.
std::optional<Fraction> reconstructed(Word x) {
  constexpr std::int64_t bound = std::int64_t{1} << 31;
  std::int64_t r0 = static_cast<std::int64_t>(prime), r1 = static_cast<std::int64_t>(x);
  std::int64_t t0 = 0, t1 = 1;
  while (r1 >= bound) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    t0 = std::exchange(t1, t0 - q * t1);
  }
  const std::int64_t den = t1 < 0 ? -t1 : t1;
  if (den >= bound) return std::nullopt;
  return Fraction{t1 < 0 ? -r1 : r1, static_cast<Word>(den)};
}

/// Integers in the same proportion as the numbers modulo the prime, if they can be reconstructed.
template <std::size_t size>
std::optional<std::array<Integer, size>> integers(const std::array<Word, size>& x) {
  std::array<Fraction, size> fractions;
  Integer common(1);
  for (std::size_t i = 0; i < size; ++i) {
    const std::optional<Fraction> fraction = reconstructed(x[i]);
    if (!fraction) return std::nullopt;
    fractions[i] = *fraction;
    mpz_lcm_ui(common.get(), common.get(), fraction->den);
  }
  std::array<Integer, size> result;
  for (std::size_t i = 0; i < size; ++i) {
    mpz_divexact_ui(result[i].get(), common.get(), fractions[i].den);
    mpz_mul_si(result[i].get(), result[i].get(), fractions[i].num);
  }
  return result;
}

/// Whether f_0 x_0 + f_1 x_1 = f_2 x_2 + f_3 x_3.
bool balanced(const std::array<Integer, 4>& f, const std::array<const Rational*, 4>& x) {
  Integer common(1);
  for (std::size_t i = 4; i-- > 0;) make_multiple(common.get(), mpq_denref(x[i]->mpq()));
  const bool integral = mpz_cmp_ui(common.get(), 1) == 0;
  Integer sum, factor;
  for (std::size_t i = 0; i < 4; ++i) {
    mpz_srcptr multiplier = f[i].get();
    if (!integral) {
      mpz_divexact(factor.get(), common.get(), mpq_denref(x[i]->mpq()));
      mpz_mul(factor.get(), factor.get(), multiplier);
      multiplier = factor.get();
    }
    if (i < 2) {
      mpz_addmul(sum.get(), multiplier, mpq_numref(x[i]->mpq()));
    } else {
      mpz_submul(sum.get(), multiplier, mpq_numref(x[i]->mpq()));
    }
  }
  return mpz_sgn(sum.get()) == 0;
}

}  // namespace

/// The unknowns are w, a, a' and, for homogeneous rows, w'; points have w' = w.
template <int D>
auto RelationProver<D>::candidate(std::size_t first) const -> std::optional<Relation> {
  constexpr std::size_t unknowns = static_cast<std::size_t>(D);
  Equations<unknowns> equations;
  for (std::size_t cell = first; cell < first + degree_; ++cell) {
    const Word lo = residue(knots_[cell].get());
    const Word hi = residue(knots_[cell + degree_].get());
    for (int j = 0; j < D; ++j) {
      const auto [c0, c1, d0, d1] = residues({&c_[cell][j], &c_[cell + 1][j], &d_[cell][j], &d_[cell + 1][j]});
      const Word w = minus(times(hi, c0), times(lo, c1));
      const Word other = minus(times(lo, d1), times(hi, d0));
      if constexpr (D == 3) {
        equations.add({nmod_add(w, other, field()), minus(c1, c0), minus(d0, d1)});
      } else {
        equations.add({w, minus(c1, c0), minus(d0, d1), other});
      }
    }
  }
  const auto solution = equations.solution();
  if (!solution) return std::nullopt;
  auto x = integers(*solution);
  if (!x) return std::nullopt;
  Relation relation;
  mpz_set(relation[3].get(), (*x)[D == 3 ? 0 : 3].get());
  relation[0] = std::move((*x)[1]);
  relation[1] = std::move((*x)[0]);
  relation[2] = std::move((*x)[2]);
  return relation;
}

template <int D>
bool RelationProver<D>::holds(std::size_t cell) {
  const mpz_srcptr lo = knots_[cell].get();
  const mpz_srcptr hi = knots_[cell + degree_].get();
  std::array<Integer, 4> f;
  for (std::size_t side = 0; side < 2; ++side) {
    const Integer& a = (*relation_)[2 * side];
    const Integer& w = (*relation_)[2 * side + 1];
    mpz_mul(f[2 * side].get(), w.get(), hi);
    mpz_sub(f[2 * side].get(), f[2 * side].get(), a.get());
    mpz_set(f[2 * side + 1].get(), a.get());
    mpz_submul(f[2 * side + 1].get(), w.get(), lo);
  }
  for (int j = 0; j < D; ++j) {
    if (!balanced(f, {&c_[cell][j], &c_[cell + 1][j], &d_[cell][j], &d_[cell + 1][j]})) return false;
  }
  return true;
}

template <int D>
bool RelationProver<D>::prove(int k) {
  const std::size_t first = static_cast<std::size_t>(k - 1);
  const auto extend = [&] {
    if (first < begin_ || first > end_) begin_ = end_ = first;
    while (end_ < first + degree_ && holds(end_)) ++end_;
    return end_ == first + degree_;
  };
  if (relation_ && extend()) return true;
  relation_ = candidate(first);
  begin_ = end_ = first;
  return relation_ && extend();
}

template class RelationProver<3>;
template class RelationProver<4>;

}  // namespace torse
