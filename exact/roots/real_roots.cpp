// Rational roots first; the others are isolated by Descartes' rule in ball arithmetic, whose exponents are unbounded,
// and bisected. No end of an interval is a root then, so every sign is found at some precision. Roots that are very
// near to each other are approached by Newton's steps, whose digits double, and parted by halvings.
#include "torse/exact/roots/real_roots.hpp"

#include <arb.h>
#include <arb_poly.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "torse/exact/roots/integer_polynomial.hpp"
#include "torse/exact/roots/rational_roots.hpp"

namespace torse {
namespace {

constexpr slong least_precision = 128;

/// A real ball.
class Real {
 public:
  Real() { arb_init(x_); }
  Real(const Rational& q, slong precision) : Real() {
    fmpq_t f;
    fmpq_init(f);
    fmpq_set_mpq(f, q.mpq());
    arb_set_fmpq(x_, f, precision);
    fmpq_clear(f);
  }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  ~Real() { arb_clear(x_); }
  arb_ptr get() { return x_; }

 private:
  arb_t x_;
};

/// A polynomial with balls as coefficients.
class RealPolynomial {
 public:
  RealPolynomial(const IntegerPolynomial& f, slong precision) {
    arb_poly_init(f_);
    arb_poly_set_fmpz_poly(f_, f.get(), precision);
  }
  RealPolynomial(const RealPolynomial&) = delete;
  RealPolynomial& operator=(const RealPolynomial&) = delete;
  ~RealPolynomial() { arb_poly_clear(f_); }
  arb_poly_struct* get() { return f_; }

 private:
  arb_poly_t f_;
};

/// The sign of a ball, 0 where it contains 0.
int sign_of(const arb_t x) { return arb_is_positive(x) != 0 ? 1 : arb_is_negative(x) != 0 ? -1 : 0; }

/// 2^e.
Rational power_of_two(slong e) {
  mpq_t q;
  mpq_init(q);
  mpq_set_ui(q, 1, 1);
  if (e >= 0) {
    mpq_mul_2exp(q, q, static_cast<mp_bitcnt_t>(e));
  } else {
    mpq_div_2exp(q, q, static_cast<mp_bitcnt_t>(-e));
  }
  Rational result = Rational::from_mpq(q);
  mpq_clear(q);
  return result;
}

/// 0 < lower < upper.
struct Bracket {
  Rational lower;
  Rational upper;

  /// A point inside: far apart ends, which are powers of two, meet in the middle of their exponents.
  Rational middle() const {
    if (upper <= Rational(4) * lower) return (lower + upper) / Rational(2);
    return power_of_two((exponent(lower) + exponent(upper)) / 2);
  }

 private:
  static slong exponent(const Rational& x) {
    return static_cast<slong>(x.numerator_bits()) - static_cast<slong>(x.denominator_bits());
  }
};

/// An upper bound 2^e of the positive roots: |x| <= 2 max_i |a_{m-i} / a_m|^(1/i) (Fujiwara).
slong root_exponent(const IntegerPolynomial& f, bool reversed) {
  const slong m = f.degree();
  const auto bits = [&](slong i) { return static_cast<slong>(fmpz_bits(f.coefficient(reversed ? m - i : i))); };
  slong most = 0;
  bool first = true;
  for (slong i = 1; i <= m; ++i) {
    if (bits(m - i) == 0) continue;
    const slong ratio = bits(m - i) - bits(m) + 1;
    const slong root = ratio >= 0 ? (ratio + i - 1) / i : -(-ratio / i);
    most = first ? root : std::max(most, root);
    first = false;
  }
  return most + 1;
}

/// How many sign variations (1 + x)^m f((lower + upper x) / (1 + x)) has: 0 and 1 are the number of roots between. None
/// where a sign is open at this precision.
std::optional<int> variations(const IntegerPolynomial& f, const Bracket& at, slong precision) {
  RealPolynomial g(f, precision);
  Real lower(at.lower, precision), width(at.upper - at.lower, precision), power;
  arb_poly_taylor_shift_horner(g.get(), g.get(), lower.get(), precision);
  arb_one(power.get());
  for (slong i = 0; i <= f.degree(); ++i) {
    arb_mul(g.get()->coeffs + i, g.get()->coeffs + i, power.get(), precision);
    arb_mul(power.get(), power.get(), width.get(), precision);
  }
  _arb_poly_reverse(g.get()->coeffs, g.get()->coeffs, f.degree() + 1, f.degree() + 1);
  arb_one(power.get());
  arb_poly_taylor_shift_horner(g.get(), g.get(), power.get(), precision);
  int count = 0;
  int before = 0;
  for (slong i = 0; i <= f.degree(); ++i) {
    const arb_srcptr x = g.get()->coeffs + i;
    if (arb_is_zero(x) != 0) continue;
    const int sign = sign_of(x);
    if (sign == 0) return std::nullopt;
    if (sign == -before) ++count;
    before = sign;
  }
  return count;
}

/// The part of a bracket, 2^-share of it wide, to which Newton's step for k roots in one place leads from an end; none
/// where it leads out of the bracket.
std::optional<Bracket> newton_part(const IntegerPolynomial& f, const Bracket& at, bool from_upper, int k, slong share,
                                   slong precision) {
  RealPolynomial g(f, precision);
  Real x(from_upper ? at.upper : at.lower, precision), lower(at.lower, precision);
  Real width(at.upper - at.lower, precision), value, slope;
  arb_poly_evaluate2_horner(value.get(), slope.get(), g.get(), x.get(), precision);
  arb_div(value.get(), value.get(), slope.get(), precision);
  arb_mul_si(value.get(), value.get(), k, precision);
  arb_sub(x.get(), x.get(), value.get(), precision);
  arb_sub(x.get(), x.get(), lower.get(), precision);
  arb_div(x.get(), x.get(), width.get(), precision);
  const arf_srcptr middle = arb_midref(x.get());
  if (arb_is_finite(x.get()) == 0 || arf_sgn(middle) < 0 || arf_cmpabs_2exp_si(middle, 0) > 0) return std::nullopt;
  // In units of a quarter of the part.
  arb_mul_2exp_si(x.get(), x.get(), share + 2);
  fmpq_t q;
  fmpq_init(q);
  arf_get_fmpz(fmpq_numref(q), middle, ARF_RND_FLOOR);
  mpq_t whole;
  mpq_init(whole);
  fmpq_get_mpq(whole, q);
  const Rational first =
      std::max(Rational(0), std::min(Rational::from_mpq(whole) - Rational(1), power_of_two(share + 2) - Rational(4)));
  mpq_clear(whole);
  fmpq_clear(q);
  const Rational unit = (at.upper - at.lower) * power_of_two(-share - 2);
  return Bracket{at.lower + first * unit, at.lower + (first + Rational(4)) * unit};
}

/// The sign of f at x, which is not a root.
int sign_at(const IntegerPolynomial& f, const Rational& x) {
  for (slong precision = least_precision;; precision *= 2) {
    RealPolynomial g(f, precision);
    Real at(x, precision), value;
    arb_poly_evaluate_horner(value.get(), g.get(), at.get(), precision);
    if (const int sign = sign_of(value.get())) return sign;
  }
}

/// The positive roots of a square-free polynomial without rational roots, each alone in its bracket.
std::vector<Bracket> isolate(const IntegerPolynomial& f) {
  constexpr int patience = 8;  // cuts before Newton's steps are tried: most roots are apart by then
  constexpr slong most_share = 1 << 20;
  struct Node {
    Bracket at;
    slong precision;
    int cuts = 0;
    slong share = 1;
  };
  std::vector<Bracket> isolated;
  std::vector<Node> open;
  const Bracket all{power_of_two(-root_exponent(f, true)), power_of_two(root_exponent(f, false))};
  open.push_back({all, least_precision});
  while (!open.empty()) {
    const Node node = std::move(open.back());
    open.pop_back();
    // A sign that stays open may be that of a zero. The halves, with more precision each, settle it.
    slong precision = node.precision;
    std::optional<int> count = variations(f, node.at, precision);
    if (!count) count = variations(f, node.at, precision *= 2);
    if (count == 0) continue;
    if (count == 1) {
      isolated.push_back(node.at);
      continue;
    }
    // A part with as many variations has all roots that there are.
    std::optional<Bracket> part;
    for (const bool from_upper : {false, true}) {
      if (!count || part || node.cuts < patience) continue;
      part = newton_part(f, node.at, from_upper, *count, node.share, 2 * precision);
      if (part && variations(f, *part, 2 * precision) != count) part.reset();
    }
    if (part) {
      open.push_back({*std::move(part), precision, node.cuts, std::min(most_share, 2 * node.share)});
      continue;
    }
    const Rational middle = node.at.middle();
    const slong next = count ? node.precision : precision;
    const slong share = std::max<slong>(1, node.share / 2);
    open.push_back({{middle, node.at.upper}, next, node.cuts + 1, share});
    open.push_back({{node.at.lower, middle}, next, node.cuts + 1, share});
  }
  return isolated;
}

/// A root of f in a bracket, by bisection.
class Refined {
 public:
  Refined(const IntegerPolynomial& f, Bracket at) : f_(&f), at_(std::move(at)), sign_(sign_at(f, at_.lower)) {}

  void halve() {
    Rational middle = at_.middle();
    (sign_at(*f_, middle) == sign_ ? at_.lower : at_.upper) = std::move(middle);
  }
  void narrow(const Rational& tolerance) {
    while (at_.upper - at_.lower > tolerance * at_.lower) halve();
  }
  const Bracket& bracket() const { return at_; }

 private:
  const IntegerPolynomial* f_;
  Bracket at_;
  int sign_;
};

/// A root of the given polynomial or, with its sign, a rational number.
struct Found {
  bool negative;
  std::optional<Refined> irrational;
  Rational rational{};

  RealRoot interval() const {
    if (!irrational) return {rational, rational};
    const Bracket& at = irrational->bracket();
    return negative ? RealRoot{-at.upper, -at.lower} : RealRoot{at.lower, at.upper};
  }
};

/// Narrows neighbours until they are apart.
std::vector<RealRoot> separated(std::vector<Found> found) {
  const auto lower = [](const Found& x) { return x.interval().lower; };
  for (bool apart = false; !apart;) {
    apart = true;
    std::ranges::sort(found, {}, lower);
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (found[i].interval().lower > found[i - 1].interval().upper) continue;
      apart = false;
      for (Found* x : {&found[i - 1], &found[i]}) {
        if (x->irrational) x->irrational->halve();
      }
    }
  }
  std::vector<RealRoot> roots;
  for (const Found& x : found) roots.push_back(x.interval());
  return roots;
}

}  // namespace

std::vector<RealRoot> real_roots(const std::vector<Rational>& coefficients, int bits) {
  if (std::ranges::all_of(coefficients, [](const Rational& x) { return x.sign() == 0; })) {
    throw InvalidInput("coefficients", "expected a polynomial that is not zero");
  }
  IntegerPolynomial f = square_free(coefficients);
  std::vector<Found> found;
  for (Rational& x : divide_out_rational_roots(f)) found.push_back({false, std::nullopt, std::move(x)});
  IntegerPolynomial reflected;
  fmpz_poly_set(reflected.get(), f.get());
  for (slong i = 1; i <= f.degree(); i += 2) {
    fmpz* x = reflected.get()->coeffs + i;
    fmpz_neg(x, x);
  }
  const Rational tolerance = power_of_two(-bits);
  for (const bool negative : {false, true}) {
    const IntegerPolynomial& g = negative ? reflected : f;
    if (g.degree() < 1) continue;
    for (Bracket& at : isolate(g)) {
      found.push_back({negative, Refined(g, std::move(at))});
      found.back().irrational->narrow(tolerance);
    }
  }
  return separated(std::move(found));
}

}  // namespace torse
