// An owned GMP integer, and a surface's knots as integers.
//   Integer           mpz_t with a lifetime
//   make_multiple     a common multiple
//   integer_knots     the knot list in the parameter where all knots are integers without a common factor
#pragma once

#include <gmp.h>

#include <utility>
#include <vector>

#include "torse/exact/rational/rational.hpp"

namespace torse {

/// An mpz_t that is initialised, moved and cleared; GMP's functions work on get().
class Integer {
 public:
  Integer() { mpz_init(z_); }
  explicit Integer(unsigned long value) { mpz_init_set_ui(z_, value); }
  Integer(Integer&& other) noexcept : Integer() { mpz_swap(z_, other.z_); }
  Integer& operator=(Integer&& other) noexcept {
    mpz_swap(z_, other.z_);
    return *this;
  }
  ~Integer() { mpz_clear(z_); }

  mpz_ptr get() { return z_; }
  mpz_srcptr get() const { return z_; }

 private:
  mpz_t z_;
};

/// m becomes a common multiple of m and x, the least one, for positive m and x.
inline void make_multiple(mpz_ptr m, mpz_srcptr x) {
  if (mpz_divisible_p(m, x) == 0) mpz_lcm(m, m, x);
}

/// (u_i - u_0) times the positive number that makes all of them integers without a common factor.
inline std::vector<Integer> integer_knots(const std::vector<Rational>& u) {
  Integer denominator(1);
  for (const Rational& x : u) make_multiple(denominator.get(), mpq_denref(x.mpq()));
  std::vector<Integer> v(u.size());
  Integer factor;
  for (std::size_t i = u.size(); i-- > 0;) {
    mpz_divexact(v[i].get(), denominator.get(), mpq_denref(u[i].mpq()));
    mpz_mul(v[i].get(), v[i].get(), mpq_numref(u[i].mpq()));
  }
  for (std::size_t i = u.size(); i-- > 0;) {
    mpz_sub(v[i].get(), v[i].get(), v[0].get());
    mpz_gcd(factor.get(), factor.get(), v[i].get());
  }
  for (Integer& x : v) mpz_divexact(x.get(), x.get(), factor.get());
  return v;
}

}  // namespace torse
