// Deciding whether one span is developable: torse's multi-modular decision against the interpolation of the determinant
// at 3(n-1)+1 parameters in mpq_t, and against the same in mpz_t after scaling the coordinates to integers.
#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/proofs/random.hpp"

namespace {

using torse::Rational;
using torse::Vec;
using Point = Vec<Rational, 3>;

/// How the coordinates look.
enum class Kind { integers, fractions };

Rational random_integer(torse::proofs::Rng& rng, int bits) {
  std::string digits = "1";
  for (int i = 1; i < bits; ++i) digits += rng.once_in(2) ? '1' : '0';
  Rational r(0);
  for (const char digit : digits) r = r + r + Rational(digit - '0');
  return r;
}

Rational random_coordinate(torse::proofs::Rng& rng, Kind kind, int bits) {
  Rational x = random_integer(rng, bits);
  if (kind == Kind::fractions) x /= random_integer(rng, bits);
  return rng.once_in(2) ? x : -x;
}

struct Net {
  torse::KnotList<Rational> u;
  std::vector<Point> c;
  std::vector<Point> d;
};

/// A developable Bezier net of degree n, by FJ07.13 or a cylinder with lengths of its own for every ruling, which has
/// no constant relation between its rows. These are the hard cases, since every coefficient has to be proved zero.
Net developable_net(int n, Kind kind, int bits, bool cylinder) {
  torse::proofs::Rng rng(static_cast<std::uint64_t>(1000 * n + bits));
  const auto point = [&] {
    Point x;
    for (Rational& coordinate : x) coordinate = random_coordinate(rng, kind, bits);
    return x;
  };
  Net net{torse::bezier_knots<Rational>(n), {}, {}};
  for (int i = 0; i <= n; ++i) net.c.push_back(point());
  if (cylinder) {
    const Point direction = point();
    for (const Point& x : net.c)
      net.d.push_back(torse::sum(x, torse::scaled(Rational(rng.between(1, 999)), direction)));
    return net;
  }
  net.d = torse::linear_net<Rational, Point>(net.u, net.c, Rational(3), Rational(-2), point());
  return net;
}

/// What the interpolation needs of a number type: mpq_t and mpz_t differ in the prefix of GMP's functions only.
struct Fraction {
  mpq_t x;
  Fraction() { mpq_init(x); }
  ~Fraction() { mpq_clear(x); }
  Fraction(const Fraction&) = delete;
  Fraction& operator=(const Fraction&) = delete;
  void set(long i) { mpq_set_si(x, i, 1); }
  void multiply(const Fraction& a, const Fraction& b) { mpq_mul(x, a.x, b.x); }
  void add(const Fraction& a) { mpq_add(x, x, a.x); }
  void subtract(const Fraction& a) { mpq_sub(x, x, a.x); }
  bool zero() const { return mpq_sgn(x) == 0; }
};
struct Whole {
  mpz_t x;
  Whole() { mpz_init(x); }
  ~Whole() { mpz_clear(x); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  void set(long i) { mpz_set_si(x, i); }
  void multiply(const Whole& a, const Whole& b) { mpz_mul(x, a.x, b.x); }
  void add(const Whole& a) { mpz_add(x, x, a.x); }
  void subtract(const Whole& a) { mpz_sub(x, x, a.x); }
  bool zero() const { return mpz_sgn(x) == 0; }
};

/// Evaluates [c_1 - c_0, d_0 - c_0, d_1 - c_0] for the points c_0^{n-1}(t), ..., d_1^{n-1}(t) at t = 0 ... 3(n-1).
template <class Number>
class Interpolation {
 public:
  explicit Interpolation(int n) : n_(n), c_(static_cast<std::size_t>(3 * (n + 1))), d_(c_.size()), weight_(c_.size()) {}

  Number& c(int i, int j) { return c_[static_cast<std::size_t>(3 * i + j)]; }
  Number& d(int i, int j) { return d_[static_cast<std::size_t>(3 * i + j)]; }

  bool vanishes() {
    for (int t = 0; t <= 3 * (n_ - 1); ++t) {
      set_weights(t);
      for (int j = 0; j < 3; ++j) {
        evaluate(origin_, c_, 0, j);
        evaluate(entry(0, j), c_, 1, j);
        evaluate(entry(1, j), d_, 0, j);
        evaluate(entry(2, j), d_, 1, j);
        for (int row = 0; row < 3; ++row) entry(row, j).subtract(origin_);
      }
      if (!determinant_vanishes()) return false;
    }
    return true;
  }

 private:
  Number& entry(int row, int j) { return m_[static_cast<std::size_t>(3 * row + j)]; }

  /// C(n-1, i) (1-t)^{n-1-i} t^i.
  void set_weights(int t) {
    Number factor;
    for (int i = 0; i < n_; ++i) {
      Number& weight = weight_[static_cast<std::size_t>(i)];
      weight.set(1);
      for (int k = 0; k < n_ - 1 - i; ++k) {
        factor.set(1 - t);
        weight.multiply(weight, factor);
      }
      long binomial = 1;
      for (int k = 0; k < i; ++k) {
        factor.set(t);
        weight.multiply(weight, factor);
        binomial = binomial * (n_ - 1 - k) / (k + 1);
      }
      factor.set(binomial);
      weight.multiply(weight, factor);
    }
  }

  void evaluate(Number& value, std::vector<Number>& row, int first, int j) {
    value.set(0);
    for (int i = 0; i < n_; ++i) {
      const Number& weight = weight_[static_cast<std::size_t>(i)];
      if (weight.zero()) continue;
      product_.multiply(weight, row[static_cast<std::size_t>(3 * (first + i) + j)]);
      value.add(product_);
    }
  }

  bool determinant_vanishes() {
    sum_.set(0);
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3;
      const int l = (j + 2) % 3;
      minor_.multiply(entry(1, k), entry(2, l));
      product_.multiply(entry(1, l), entry(2, k));
      minor_.subtract(product_);
      product_.multiply(entry(0, j), minor_);
      sum_.add(product_);
    }
    return sum_.zero();
  }

  int n_;
  std::vector<Number> c_, d_, weight_;
  std::array<Number, 9> m_;
  Number origin_, product_, minor_, sum_;
};

bool by_fractions(const Net& net) {
  const int n = net.u.degree();
  Interpolation<Fraction> interpolation(n);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < 3; ++j) {
      mpq_set(interpolation.c(i, j).x, net.c[static_cast<std::size_t>(i)][j].mpq());
      mpq_set(interpolation.d(i, j).x, net.d[static_cast<std::size_t>(i)][j].mpq());
    }
  }
  return interpolation.vanishes();
}

/// Every column times the least common denominator of its coordinates.
bool by_integers(const Net& net) {
  const int n = net.u.degree();
  Interpolation<Whole> interpolation(n);
  Whole common;
  for (int j = 0; j < 3; ++j) {
    common.set(1);
    for (const auto* row : {&net.c, &net.d}) {
      for (const Point& x : *row) mpz_lcm(common.x, common.x, mpq_denref(x[j].mpq()));
    }
    for (int i = 0; i <= n; ++i) {
      const auto scale = [&](Whole& to, const Rational& from) {
        mpz_divexact(to.x, common.x, mpq_denref(from.mpq()));
        mpz_mul(to.x, to.x, mpq_numref(from.mpq()));
      };
      scale(interpolation.c(i, j), net.c[static_cast<std::size_t>(i)][j]);
      scale(interpolation.d(i, j), net.d[static_cast<std::size_t>(i)][j]);
    }
  }
  return interpolation.vanishes();
}

/// Times one net and prints its row. Returns the ratio of the interpolation in mpq_t to torse.
double decide(const std::string& name, const Net& net, bool head) {
  const std::vector<torse::bench::Contender> contenders{
      {"torse", [&] { return !torse::find_witness_over_q<3>(net.u, net.c, net.d); }},
      {"interpolation, mpq_t", [&] { return by_fractions(net); }},
      {"interpolation, scaled to mpz_t", [&] { return by_integers(net); }},
      {"torse's generic find_witness", [&] { return !torse::find_witness<Rational, 3>(net.u, net.c, net.d); }}};
  if (head) print_head("case", contenders);
  return compare(name, contenders, 5)[1].ratio;
}

/// All degrees and sizes of numbers. Returns the least ratio.
double table(bool cylinder) {
  double least = 1e9;
  bool head = true;
  for (const Kind kind : {Kind::integers, Kind::fractions}) {
    for (const int n : {2, 3, 5, 8}) {
      for (const int bits : {30, 100, 500, 2000}) {
        const std::string name = "n = " + std::to_string(n) + ", " + std::to_string(bits) + " bits, " +
                                 (kind == Kind::integers ? "integers" : "fractions");
        least = std::min(least, decide(name, developable_net(n, kind, bits, cylinder), std::exchange(head, false)));
      }
    }
  }
  return least;
}

}  // namespace

int main() {
  std::puts("## Exact decision of one span\n");
  std::puts(
      "Developable Bezier nets of degree n from FJ07.13, so that every coefficient has to be proved zero. In brackets: "
      "ratio to torse.\n");
  const double least = table(false);
  torse::bench::goal("Goal: at least 3 times faster than interpolation in mpq_t in every case of this table",
                     least >= 3);
  std::puts(
      "\nCylinders with a length of its own for each ruling: no constant relation between the rows, the determinant "
      "decides.\n");
  std::printf("\nLeast ratio of the interpolation in mpq_t here: %.2f\n", table(true));
}
