// The recursion FJ07.13 over Q, n = 3, points of space: the library over Rational against the same steps written by
// hand in mpq_t, fmpq_t, Boost's mpq_rational and cpp_rational.
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <gmp.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "side_by_side.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/random.hpp"

namespace {

using torse::Rational;
using Point = torse::Vec<Rational, 3>;

constexpr int degree = 3;

struct Input {
  torse::KnotList<Rational> u;
  std::vector<Point> c;
  Point d0;
  Rational lambda;
  Rational m;
};

/// Fractions of two digits and steps of the knots of one.
Input random_input(int last) {
  torse::proofs::Rng rng(static_cast<std::uint64_t>(last));
  const auto point = [&] {
    Point x;
    for (Rational& coordinate : x) coordinate = Rational(rng.between(-99, 99)) / Rational(rng.between(1, 9));
    return x;
  };
  std::vector<Rational> u{Rational(0)};
  while (u.size() < static_cast<std::size_t>(last + degree)) {
    u.push_back(u.back() + Rational(rng.between(1, 9)) / Rational(rng.between(1, 9)));
  }
  Input input{
      torse::KnotList<Rational>(degree, u), {}, point(), Rational(-5) / Rational(7), Rational(-8) / Rational(3)};
  for (int i = 0; i <= last; ++i) input.c.push_back(point());
  return input;
}

/// What the hand-written recursion needs of a C library's fractions.
struct Gmp {
  using Number = mpq_t;
  static void init(mpq_t x) { mpq_init(x); }
  static void clear(mpq_t x) { mpq_clear(x); }
  static void set(mpq_t x, const Rational& y) { mpq_set(x, y.mpq()); }
  static bool equal(const mpq_t x, const Rational& y) { return mpq_equal(x, y.mpq()) != 0; }
  static void add(mpq_t r, const mpq_t x, const mpq_t y) { mpq_add(r, x, y); }
  static void subtract(mpq_t r, const mpq_t x, const mpq_t y) { mpq_sub(r, x, y); }
  static void multiply(mpq_t r, const mpq_t x, const mpq_t y) { mpq_mul(r, x, y); }
  static void divide(mpq_t r, const mpq_t x, const mpq_t y) { mpq_div(r, x, y); }
};
struct Flint {
  using Number = fmpq_t;
  static void init(fmpq_t x) { fmpq_init(x); }
  static void clear(fmpq_t x) { fmpq_clear(x); }
  static void set(fmpq_t x, const Rational& y) { fmpq_set_mpq(x, y.mpq()); }
  static bool equal(const fmpq_t x, const Rational& y) {
    fmpq_t z;
    fmpq_init(z);
    set(z, y);
    const bool same = fmpq_equal(x, z) != 0;
    fmpq_clear(z);
    return same;
  }
  static void add(fmpq_t r, const fmpq_t x, const fmpq_t y) { fmpq_add(r, x, y); }
  static void subtract(fmpq_t r, const fmpq_t x, const fmpq_t y) { fmpq_sub(r, x, y); }
  static void multiply(fmpq_t r, const fmpq_t x, const fmpq_t y) { fmpq_mul(r, x, y); }
  static void divide(fmpq_t r, const fmpq_t x, const fmpq_t y) { fmpq_div(r, x, y); }
};

/// An array of a C library's fractions.
template <class C>
class Row {
 public:
  explicit Row(std::size_t size) : x_(new typename C::Number[size]), size_(size) {
    for (std::size_t i = 0; i < size; ++i) C::init(x_[i]);
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  ~Row() {
    for (std::size_t i = 0; i < size_; ++i) C::clear(x_[i]);
    delete[] x_;
  }
  typename C::Number& operator[](std::size_t i) { return x_[i]; }

 private:
  typename C::Number* x_;
  std::size_t size_;
};

template <class C>
class ByHand {
 public:
  explicit ByHand(const Input& input)
      : last_(input.c.size() - 1), u_(last_ + degree), c_(3 * last_ + 3), parameters_(2) {
    for (std::size_t i = 0; i < last_ + degree; ++i) C::set(u_[i], input.u[static_cast<int>(i)]);
    for (std::size_t i = 0; i <= last_; ++i) {
      for (std::size_t j = 0; j < 3; ++j) C::set(c_[3 * i + j], input.c[i][static_cast<Eigen::Index>(j)]);
    }
    C::set(parameters_[0], input.lambda);
    C::set(parameters_[1], input.m);
    for (std::size_t j = 0; j < 3; ++j) d0_.push_back(input.d0[static_cast<Eigen::Index>(j)]);
  }

  /// Computes all vertices and compares the last one.
  bool run(const Point& expected) {
    Row<C> d(3 * last_ + 3);
    Row<C> work(5);
    auto& a = work[0];
    auto& b = work[1];
    auto& e = work[2];
    auto& f = work[3];
    auto& product = work[4];
    for (std::size_t j = 0; j < 3; ++j) C::set(d[j], d0_[j]);
    for (std::size_t i = 0; i < last_; ++i) {
      C::subtract(a, u_[i + degree], parameters_[0]);
      C::subtract(b, parameters_[0], u_[i]);
      C::subtract(e, parameters_[1], u_[i + degree]);
      C::subtract(f, parameters_[1], u_[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        auto& next = d[3 * i + 3 + j];
        C::multiply(next, a, c_[3 * i + j]);
        C::multiply(product, b, c_[3 * i + 3 + j]);
        C::add(next, next, product);
        C::multiply(product, e, d[3 * i + j]);
        C::add(next, next, product);
        C::divide(next, next, f);
      }
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (!C::equal(d[3 * last_ + j], expected[static_cast<Eigen::Index>(j)])) return false;
    }
    return true;
  }

 private:
  std::size_t last_;
  Row<C> u_, c_, parameters_;  // parameters: L*, M*
  std::vector<Rational> d0_;
};

/// The same in a C++ number type.
template <class S>
class InCpp {
 public:
  explicit InCpp(const Input& input) : lambda_(input.lambda.text()), m_(input.m.text()) {
    for (const Rational& x : input.u.list()) u_.emplace_back(x.text());
    for (const Point& x : input.c) {
      for (const Rational& coordinate : x) c_.emplace_back(coordinate.text());
    }
    for (const Rational& coordinate : input.d0) d0_.emplace_back(coordinate.text());
  }

  bool run(const Point& expected) const {
    std::vector<S> d(c_.size());
    for (std::size_t j = 0; j < 3; ++j) d[j] = d0_[j];
    for (std::size_t i = 0; 3 * i + 3 < c_.size(); ++i) {
      const S a = u_[i + degree] - lambda_;
      const S b = lambda_ - u_[i];
      const S e = m_ - u_[i + degree];
      const S f = m_ - u_[i];
      for (std::size_t j = 0; j < 3; ++j) {
        S& next = d[3 * i + 3 + j];
        next = a * c_[3 * i + j];
        next += b * c_[3 * i + 3 + j];
        next += e * d[3 * i + j];
        next /= f;
      }
    }
    for (std::size_t j = 0; j < 3; ++j) {
      if (d[d.size() - 3 + j].str() != expected[static_cast<Eigen::Index>(j)].text()) return false;
    }
    return true;
  }

 private:
  S lambda_, m_;
  std::vector<S> u_, c_, d0_;
};

}  // namespace

int main() {
  namespace mp = boost::multiprecision;
  using torse::bench::Contender;
  std::puts("## Exact recursion FJ07.13, n = 3, points of space\n");
  std::puts("All vertices from fractions of two digits. In brackets: ratio to torse.\n");
  bool met = true;
  for (const int last : {10, 100, 1000}) {
    const Input in = random_input(last);
    const Point expected = torse::linear_net<Rational, Point>(in.u, in.c, in.lambda, in.m, in.d0).back();
    ByHand<Gmp> gmp(in);
    ByHand<Flint> flint(in);
    const InCpp<mp::mpq_rational> boost_gmp(in);
    const InCpp<mp::cpp_rational> boost(in);
    std::vector<Contender> contenders{
        {"torse, Rational",
         [&] {
           const Point end = torse::linear_net<Rational, Point>(in.u, in.c, in.lambda, in.m, in.d0).back();
           return end == expected;
         }},
        {"mpq_t by hand", [&] { return gmp.run(expected); }},
        {"FLINT fmpq_t by hand", [&] { return flint.run(expected); }},
        {"Boost mpq_rational", [&] { return boost_gmp.run(expected); }},
        {"Boost cpp_rational", [&] { return boost.run(expected); }}};
    if (last == 10) print_head("L", contenders);
    // Boost's cpp_rational takes most of a minute at L = 1000, so there it has fewer rounds of its own.
    if (last == 1000) {
      const torse::bench::Timing slow = torse::bench::time_in_turn({contenders[0], contenders[4]}, 1)[1];
      contenders.pop_back();
      met = compare("1000", contenders)[1].ratio > 1 / 1.15 && met;
      std::printf("\nBoost cpp_rational at L = 1000, one round: %s (%.0f)\n",
                  torse::bench::readable(slow.seconds).c_str(), slow.ratio);
    } else {
      met = compare(std::to_string(last), contenders)[1].ratio > 1 / 1.15 && met;
    }
  }
  torse::bench::goal("Goal: torse within 1.15 times the time of mpq_t by hand", met);
}
