// The proof of FJ07.16 for all vertices with every knot, L*, M* and control point an indeterminate, n = 3: the
// library's recursion and closed form over rational functions against the same linear forms written directly on FLINT.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "torse/algebra/free_module.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/exact/symbolic/flint_headers.hpp"
#include "torse/exact/symbolic/rational_function.hpp"

namespace {

using torse::Form;
using torse::RationalFunction;

constexpr int kDegree = 3;

std::vector<std::string> names(int last) {
  std::vector<std::string> result;
  for (int i = 0; i < last + kDegree; ++i) result.push_back("u" + std::to_string(i));
  result.push_back("L");
  result.push_back("M");
  return result;
}

/// Whether the recursion FJ07.13 and the closed form FJ07.16 agree at every vertex.
bool prove_with_torse(int last) {
  using P = Form<RationalFunction>;
  const torse::SymbolicContext context(names(last));
  std::vector<RationalFunction> knots;
  for (int i = 0; i < last + kDegree; ++i) knots.push_back(context.variable(i));
  const torse::KnotList<RationalFunction> u(kDegree, std::move(knots));
  const RationalFunction lambda = context.variable(last + kDegree);
  const RationalFunction m = context.variable(last + kDegree + 1);
  std::vector<P> c;
  for (int i = 0; i <= last; ++i) c.push_back(P::generator(i));
  const P d0 = P::generator(last + 1);
  const std::vector<P> d = torse::linear_net<RationalFunction, P>(u, c, lambda, m, d0);
  for (int vertex = 1; vertex <= last; ++vertex) {
    const std::size_t at = static_cast<std::size_t>(vertex);
    P rest = torse::difference(d[at], c[at]);
    torse::subtract(rest, torse::eq16<RationalFunction, P>(u, c, lambda, m, d0, vertex));
    if (!rest.terms().empty()) return false;
  }
  return true;
}

/// The same proof in FLINT's C interface: a point is an array of L+2 fractions, the last one the coefficient of d_0.
class HandWritten {
 public:
  explicit HandWritten(int last) : last_(last) {
    fmpz_mpoly_ctx_init(ring_, last + kDegree + 2, ORD_LEX);
    for (Fraction* x : {&lambda_, &m_, &gap_, &a_, &b_, &p_, &over_}) fmpz_mpoly_q_init(x, ring_);
    for (std::vector<Fraction>* row : {&u_, &d_, &e_}) {
      row->resize(static_cast<std::size_t>(last + kDegree + 2));
      for (Fraction& x : *row) fmpz_mpoly_q_init(&x, ring_);
    }
  }
  HandWritten(const HandWritten&) = delete;
  HandWritten& operator=(const HandWritten&) = delete;
  ~HandWritten() {
    for (Fraction* x : {&lambda_, &m_, &gap_, &a_, &b_, &p_, &over_}) fmpz_mpoly_q_clear(x, ring_);
    for (std::vector<Fraction>* row : {&u_, &d_, &e_}) {
      for (Fraction& x : *row) fmpz_mpoly_q_clear(&x, ring_);
    }
    fmpz_mpoly_ctx_clear(ring_);
  }

  bool prove() {
    for (int i = 0; i < last_ + kDegree; ++i) fmpz_mpoly_q_gen(&u(i), i, ring_);
    fmpz_mpoly_q_gen(&lambda_, last_ + kDegree, ring_);
    fmpz_mpoly_q_gen(&m_, last_ + kDegree + 1, ring_);
    fmpz_mpoly_q_sub(&gap_, &lambda_, &m_, ring_);
    fmpz_mpoly_q_one(&at(d_, last_ + 1), ring_);
    for (int vertex = 1; vertex <= last_; ++vertex) {
      step(vertex - 1);
      closed_form(vertex);
      for (int j = 0; j <= last_ + 1; ++j) {
        if (fmpz_mpoly_q_equal(&at(d_, j), &at(e_, j), ring_) == 0) return false;
      }
    }
    return true;
  }

 private:
  using Fraction = fmpz_mpoly_q_struct;

  static Fraction& at(std::vector<Fraction>& row, int j) { return row[static_cast<std::size_t>(j)]; }
  Fraction& u(int i) { return at(u_, i); }

  /// d_i becomes d_{i+1}: FJ07.13 divided by M* - u_i.
  void step(int i) {
    fmpz_mpoly_q_sub(&over_, &m_, &u(i), ring_);
    fmpz_mpoly_q_sub(&a_, &m_, &u(i + kDegree), ring_);
    fmpz_mpoly_q_div(&a_, &a_, &over_, ring_);
    for (int j = 0; j <= i; ++j) fmpz_mpoly_q_mul(&at(d_, j), &at(d_, j), &a_, ring_);
    fmpz_mpoly_q_mul(&at(d_, last_ + 1), &at(d_, last_ + 1), &a_, ring_);
    fmpz_mpoly_q_sub(&a_, &u(i + kDegree), &lambda_, ring_);
    fmpz_mpoly_q_div(&a_, &a_, &over_, ring_);
    fmpz_mpoly_q_add(&at(d_, i), &at(d_, i), &a_, ring_);
    fmpz_mpoly_q_sub(&a_, &lambda_, &u(i), ring_);
    fmpz_mpoly_q_div(&at(d_, i + 1), &a_, &over_, ring_);
  }

  /// e becomes c_N + P(0,N) (d_0 - c_0) + (L* - M*) sum_i P(i+1,N) (c_{i+1} - c_i) / (M* - u_i).
  void closed_form(int vertex) {
    for (Fraction& x : e_) fmpz_mpoly_q_zero(&x, ring_);
    fmpz_mpoly_q_one(&p_, ring_);
    for (int i = vertex - 1; i >= 0; --i) {
      fmpz_mpoly_q_sub(&over_, &m_, &u(i), ring_);
      fmpz_mpoly_q_div(&a_, &p_, &over_, ring_);
      fmpz_mpoly_q_mul(&a_, &a_, &gap_, ring_);
      fmpz_mpoly_q_add(&at(e_, i + 1), &at(e_, i + 1), &a_, ring_);
      fmpz_mpoly_q_sub(&at(e_, i), &at(e_, i), &a_, ring_);
      fmpz_mpoly_q_sub(&b_, &m_, &u(i + kDegree), ring_);
      fmpz_mpoly_q_div(&b_, &b_, &over_, ring_);
      fmpz_mpoly_q_mul(&p_, &p_, &b_, ring_);
    }
    fmpz_mpoly_q_sub(&at(e_, 0), &at(e_, 0), &p_, ring_);
    fmpz_mpoly_q_set(&at(e_, last_ + 1), &p_, ring_);
    fmpz_mpoly_q_one(&a_, ring_);
    fmpz_mpoly_q_add(&at(e_, vertex), &at(e_, vertex), &a_, ring_);
  }

  int last_;
  fmpz_mpoly_ctx_t ring_;
  Fraction lambda_, m_, gap_, a_, b_, p_, over_;
  std::vector<Fraction> u_, d_, e_;
};

bool prove_by_hand(int last) {
  return HandWritten(last).prove();
}

void run(benchmark::State& state, bool (*prove)(int)) {
  for (auto _ : state) {
    if (!prove(static_cast<int>(state.range(0)))) state.SkipWithError("the identity was not proved");
  }
}

BENCHMARK_CAPTURE(run, torse, prove_with_torse)->Arg(10)->Arg(30)->Arg(60)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run, flint_by_hand, prove_by_hand)->Arg(10)->Arg(30)->Arg(60)->Unit(benchmark::kMillisecond);

}  // namespace
