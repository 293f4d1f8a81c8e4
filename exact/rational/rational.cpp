// The members of Rational that no inner loop calls: conversions, text, and the life of the thread's store.
#include "torse/exact/rational/rational.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace torse {
namespace {

bool all_digits(std::string_view s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// floor(|num| / (den 2^k)) with its last bit set where the division left a remainder. The quotient fits 64 bits.
std::uint64_t scaled_quotient(mpz_srcptr num, mpz_srcptr den, long k) {
  mpz_t n, d;
  mpz_init(n);
  mpz_init(d);
  mpz_abs(n, num);
  mpz_set(d, den);
  if (k < 0) {
    mpz_mul_2exp(n, n, static_cast<mp_bitcnt_t>(-k));
  } else {
    mpz_mul_2exp(d, d, static_cast<mp_bitcnt_t>(k));
  }
  mpz_tdiv_qr(n, d, n, d);
  const std::uint64_t quotient = mpz_get_ui(n) | (mpz_sgn(d) != 0 ? 1U : 0U);
  mpz_clear(n);
  mpz_clear(d);
  return quotient;
}

/// m / 2^drop rounded to the nearest integer, ties to even.
std::uint64_t shift_rounded(std::uint64_t m, int drop) {
  const std::uint64_t half = std::uint64_t{1} << (drop - 1);
  const std::uint64_t rest = m & (2 * half - 1);
  const std::uint64_t floor = m >> drop;
  return floor + (rest > half || (rest == half && floor % 2 == 1) ? 1 : 0);
}

}  // namespace

struct RationalStore::Keeper {
  explicit Keeper(RationalStore& s) : store(s) { store.limit_ = capacity; }
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper() {
    store.limit_ = 0;
    while (store.count_ > 0) mpq_clear(&store.slots_[--store.count_]);
  }
  RationalStore& store;
};

void RationalStore::give_slowly(mpq_ptr q) {
  static thread_local Keeper keeper(*this);
  mpq_clear(q);
}

void Rational::throw_division_by_zero() { throw DivisionByZero(); }

Rational Rational::from_double(double x) {
  if (!std::isfinite(x)) throw InvalidInput("number", "a rational number cannot be NaN or infinite");
  Rational r;
  mpq_set_d(r.q_, x);
  return r;
}

Rational Rational::from_text(std::string_view text) {
  const std::string_view unsigned_text =
      !text.empty() && (text.front() == '-' || text.front() == '+') ? text.substr(1) : text;
  const std::size_t slash = unsigned_text.find('/');
  const bool fraction = slash != std::string_view::npos;
  if (!all_digits(unsigned_text.substr(0, slash)) || (fraction && !all_digits(unsigned_text.substr(slash + 1)))) {
    throw InvalidInput("number", "expected p or p/q with decimal digits, got \"" + std::string(text) + '"');
  }
  if (fraction && unsigned_text.find_first_not_of('0', slash + 1) == std::string_view::npos) {
    throw InvalidInput("number", "zero denominator in \"" + std::string(text) + '"');
  }
  Rational r;
  mpq_set_str(r.q_, std::string(unsigned_text).c_str(), 10);
  mpq_canonicalize(r.q_);
  if (text.front() == '-') mpq_neg(r.q_, r.q_);
  return r;
}

Rational Rational::from_mpq(mpq_srcptr q) {
  if (mpz_sgn(mpq_denref(q)) == 0) throw_division_by_zero();
  Rational r{Raw{}};
  mpz_set(mpq_numref(r.q_), mpq_numref(q));
  mpz_set(mpq_denref(r.q_), mpq_denref(q));
  mpq_canonicalize(r.q_);
  return r;
}

double Rational::to_double() const {
  constexpr int precision = 53;
  constexpr long least_exponent = -1074;
  if (sign() == 0) return 0.0;
  // |x| lies in (2^(e-1), 2^(e+1)), so the quotient by 2^k has 55 or 56 bits (fewer below the normal range), and at
  // least two of them, the lower one sticky, lie beyond the last bit of the result.
  const long e = static_cast<long>(numerator_bits()) - static_cast<long>(denominator_bits());
  if (e > 1100) return sign() * HUGE_VAL;
  const long k = std::max(e - precision - 2, least_exponent - 2);
  const std::uint64_t quotient = scaled_quotient(mpq_numref(q_), mpq_denref(q_), k);
  const int drop = std::max(2, static_cast<int>(std::bit_width(quotient)) - precision);
  const auto mantissa = static_cast<double>(shift_rounded(quotient, drop));
  return sign() * std::ldexp(mantissa, static_cast<int>(k) + drop);
}

std::string Rational::text() const {
  std::string s(mpz_sizeinbase(mpq_numref(q_), 10) + mpz_sizeinbase(mpq_denref(q_), 10) + 3, '\0');
  mpq_get_str(s.data(), 10, q_);
  s.resize(s.find('\0'));
  return s;
}

}  // namespace torse
