// Arb's C types with a lifetime, for .cpp files only: FLINT defines macros with short lower-case names.
//   Real, Complex, RealPoly, ComplexPoly      get() is what Arb's functions take
//   set_rational, enclosure, upper_bound      from a Rational, to doubles rounded outwards
//   to_poly                                   a polynomial over Q as balls
#pragma once

#include <gmp.h>

#include <flint/fmpq.h>

#include <acb_poly.h>

#include "torse/algebra/polynomial.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/interval.hpp"

namespace torse::arb {

inline void initialise(arb_struct* x) { arb_init(x); }
inline void initialise(acb_struct* x) { acb_init(x); }
inline void initialise(arb_poly_struct* x) { arb_poly_init(x); }
inline void initialise(acb_poly_struct* x) { acb_poly_init(x); }
inline void release(arb_struct* x) { arb_clear(x); }
inline void release(acb_struct* x) { acb_clear(x); }
inline void release(arb_poly_struct* x) { arb_poly_clear(x); }
inline void release(acb_poly_struct* x) { acb_poly_clear(x); }
inline void assign(arb_struct* x, const arb_struct* y) { arb_set(x, y); }
inline void assign(acb_struct* x, const acb_struct* y) { acb_set(x, y); }
inline void assign(arb_poly_struct* x, const arb_poly_struct* y) { arb_poly_set(x, y); }
inline void assign(acb_poly_struct* x, const acb_poly_struct* y) { acb_poly_set(x, y); }
inline void exchange(arb_struct* x, arb_struct* y) { arb_swap(x, y); }
inline void exchange(acb_struct* x, acb_struct* y) { acb_swap(x, y); }
inline void exchange(arb_poly_struct* x, arb_poly_struct* y) { arb_poly_swap(x, y); }
inline void exchange(acb_poly_struct* x, acb_poly_struct* y) { acb_poly_swap(x, y); }

/// One of Arb's structs, initialised to zero.
template <class T>
class Owned {
 public:
  Owned() { initialise(&x_); }
  Owned(const Owned& y) : Owned() { assign(&x_, &y.x_); }
  Owned(Owned&& y) noexcept : Owned() { exchange(&x_, &y.x_); }
  Owned& operator=(const Owned& y) {
    assign(&x_, &y.x_);
    return *this;
  }
  Owned& operator=(Owned&& y) noexcept {
    exchange(&x_, &y.x_);
    return *this;
  }
  ~Owned() { release(&x_); }

  T* get() { return &x_; }
  const T* get() const { return &x_; }

 private:
  T x_;
};

using Real = Owned<arb_struct>;
using Complex = Owned<acb_struct>;
using RealPoly = Owned<arb_poly_struct>;
using ComplexPoly = Owned<acb_poly_struct>;

inline void set_rational(Real& x, const Rational& q, slong bits) {
  fmpq_t f;
  fmpq_init(f);
  fmpq_set_mpq(f, q.mpq());
  arb_set_fmpq(x.get(), f, bits);
  fmpq_clear(f);
}

inline Real real(const Rational& q, slong bits) {
  Real x;
  set_rational(x, q, bits);
  return x;
}

/// The ends as doubles, rounded outwards; they may be infinite.
inline Interval enclosure(const Real& x) {
  if (arb_is_finite(x.get()) == 0) return Interval::line();
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, x.get(), 128);
  const double lower = arf_get_d(end, ARF_RND_FLOOR);
  arb_get_ubound_arf(end, x.get(), 128);
  const double upper = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return Interval::hull(lower, upper);
}

/// f with coefficients rounded to balls.
inline RealPoly to_poly(const Polynomial<Rational>& f, slong bits) {
  RealPoly g;
  Real x;
  for (int i = 0; i <= f.degree(); ++i) {
    set_rational(x, f[i], bits);
    arb_poly_set_coeff_arb(g.get(), i, x.get());
  }
  return g;
}

}  // namespace torse::arb
