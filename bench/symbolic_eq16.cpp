// The proof of FJ07.16 for all vertices with every knot, L*, M* and control point an indeterminate, n = 3: the
// library's recursion and closed form over rational functions against the same linear forms written directly on FLINT,
// against SymPy and against PARI/GP.
//   symbolic_eq16 [FOLDER]      the folder of eq16_sympy.py and eq16.gp; without it those two are left out
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.hpp"
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
  const std::vector<P> rulings = torse::eq16_rulings<RationalFunction, P>(u, c, lambda, m, d0);
  for (std::size_t vertex = 1; vertex < d.size(); ++vertex) {
    P rest = torse::difference(d[vertex], c[vertex]);
    torse::subtract(rest, rulings[vertex - 1]);
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

bool prove_by_hand(int last) { return HandWritten(last).prove(); }

/// The seconds that a program prints in the given unit, or nothing if it fails or takes more than `limit` seconds.
std::optional<double> seconds_from(const std::string& command, double unit, int limit) {
  std::FILE* pipe = popen(("timeout " + std::to_string(limit) + " " + command + " 2> /dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::array<char, 64> text{};
  const bool read = std::fgets(text.data(), static_cast<int>(text.size()), pipe) != nullptr;
  const bool ended_well = pclose(pipe) == 0;
  return read && ended_well ? std::optional(unit * std::strtod(text.data(), nullptr)) : std::nullopt;
}

/// One row of the peers' table. Returns its ratio to torse, none where the peer did not end in time.
std::optional<double> print_peer(const std::string& name, int last, std::optional<double> seconds, int limit,
                                 double ours) {
  if (seconds) {
    std::printf("| %s | %d | %s | %.0f |\n", name.c_str(), last, torse::bench::readable(*seconds).c_str(),
                *seconds / ours);
  } else {
    std::printf("| %s | %d | not within %d s | > %.0f |\n", name.c_str(), last, limit, limit / ours);
  }
  std::fflush(stdout);
  return seconds ? std::optional(*seconds / ours) : std::nullopt;
}

/// SymPy and PARI/GP, which time themselves. `ours` holds the times of torse at L = 10, 22, 60.
void compare_with_systems(const std::string& folder, const std::array<double, 3>& ours) {
  constexpr int limit = 60;
  std::puts("\n| system | L | time | ratio to torse |\n|---|--:|--:|--:|");
  std::optional<double> expressions, forms;
  for (const std::string variant : {"together", "simplify", "cancel", "ratsimp", "field", "forms"}) {
    const auto seconds = seconds_from("python3 " + folder + "/eq16_sympy.py 10 " + variant, 1, limit);
    const auto ratio = print_peer("SymPy, " + variant, 10, seconds, limit, ours[0]);
    std::optional<double>& best = variant == "forms" ? forms : expressions;
    if (ratio) best = std::min(*ratio, best.value_or(*ratio));
  }
  for (const std::string variant : {"field", "forms"}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int last = std::array{10, 22, 60}[i];
      const auto seconds = seconds_from(
          "env L=" + std::to_string(last) + " VARIANT=" + variant + " gp -q -f -s 2G " + folder + "/eq16.gp", 1e-3,
          limit);
      print_peer("PARI/GP, " + variant, last, seconds, limit, ours[i]);
    }
  }
  if (!expressions || !forms) {
    std::puts("\nSymPy did not run.");
    return;
  }
  std::printf(
      "\nSymPy at L = 10: %.0f times the time of torse in the best variant with control points as symbols; %.0f times "
      "in "
      "linear forms, torse's own method written in SymPy.\n",
      *expressions, *forms);
  torse::bench::goal("Goal: at least 1000 times faster than SymPy with everything symbolic, L = 10",
                     *expressions >= 1000);
}

}  // namespace

int main(int count, char** arguments) {
  std::puts("## FJ07.16 at every vertex, every knot, L*, M* and control point symbolic, n = 3\n");
  std::puts("In brackets: ratio to torse.\n");
  std::array<double, 3> ours{};
  double ratio = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int last = std::array{10, 22, 60}[i];
    const std::vector<torse::bench::Contender> contenders{
        {"torse", [&] { return prove_with_torse(last); }},
        {"FLINT linear forms by hand", [&] { return prove_by_hand(last); }}};
    if (i == 0) print_head("L", contenders);
    const auto timings = compare(std::to_string(last), contenders, 5);
    ours[i] = timings[0].seconds;
    ratio = 1 / timings[1].ratio;
  }
  torse::bench::goal("Goal: at L = 60 within 1.5 times the time of FLINT by hand", ratio <= 1.5);
  if (count > 1) compare_with_systems(arguments[1], ours);
}
