// An irreducible factor divides a polynomial or is coprime to it, and a wrong leading or trailing monomial rules the
// first out at once: a monomial order makes those of a product the products of those of the factors.
#include "torse/exact/symbolic/simple_fraction.hpp"

namespace torse::detail {
namespace {

using Polynomial = fmpz_mpoly_struct;
using Ring = fmpz_mpoly_ctx_struct;

/// A polynomial that lives as long as its scope.
class Temporary {
 public:
  explicit Temporary(const Ring* ring) : ring_(ring) { fmpz_mpoly_init(&value_, ring); }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() { fmpz_mpoly_clear(&value_, ring_); }
  Polynomial* get() { return &value_; }

 private:
  const Ring* ring_;
  Polynomial value_;
};

bool is_unit(const Polynomial* p, const Ring* ring) {
  return p->length == 1 && fmpz_is_pm1(p->coeffs) != 0 && fmpz_mpoly_is_fmpz(p, ring) != 0;
}

/// Whether the monomial of term `at` of the linear polynomial divides that of term `in` of p.
bool monomial_divides(const Polynomial* linear, slong at, const Polynomial* p, slong in, const Ring* ring) {
  const slong variables = fmpz_mpoly_ctx_nvars(ring);
  for (slong v = 0; v < variables; ++v) {
    if (fmpz_mpoly_get_term_var_exp_ui(linear, at, v, ring) != 0) {
      return fmpz_mpoly_get_term_var_exp_ui(p, in, v, ring) != 0;
    }
  }
  return true;
}

/// Whether the linear polynomial divides p; the quotient then.
bool divides(Polynomial* quotient, const Polynomial* p, const Polynomial* linear, const Ring* ring) {
  return monomial_divides(linear, 0, p, 0, ring) &&
         monomial_divides(linear, linear->length - 1, p, p->length - 1, ring) &&
         fmpz_mpoly_divides_monagan_pearce(quotient, p, linear, ring) != 0;
}

}  // namespace

bool is_simple(const Polynomial* p, const Ring* ring) {
  constexpr slong most_terms = 4;
  if (p->length == 0 || p->length > most_terms || p->bits > FLINT_BITS) return false;
  bool is_primitive = false;
  for (slong i = 0; i < p->length; ++i) is_primitive = is_primitive || fmpz_is_pm1(p->coeffs + i) != 0;
  return is_primitive && fmpz_mpoly_total_degree_si(p, ring) <= 1;
}

void multiply_by_simple(fmpz_mpoly_q_struct* z, const fmpz_mpoly_q_struct* x, const Polynomial* c, const Polynomial* d,
                        const Ring* ring) {
  Temporary num(ring);
  Temporary den(ring);
  const bool c_cancels = !is_unit(c, ring) && divides(den.get(), &x->den, c, ring);
  const bool d_cancels = !is_unit(d, ring) && divides(num.get(), &x->num, d, ring);
  const Polynomial* const a = d_cancels ? num.get() : &x->num;
  const Polynomial* const b = c_cancels ? den.get() : &x->den;
  Temporary above(ring);
  Temporary below(ring);
  if (c_cancels) {
    fmpz_mpoly_set(above.get(), a, ring);
  } else {
    fmpz_mpoly_mul(above.get(), a, c, ring);
  }
  if (d_cancels) {
    fmpz_mpoly_set(below.get(), b, ring);
  } else {
    fmpz_mpoly_mul(below.get(), b, d, ring);
  }
  if (fmpz_sgn(below.get()->coeffs) < 0) {
    fmpz_mpoly_neg(above.get(), above.get(), ring);
    fmpz_mpoly_neg(below.get(), below.get(), ring);
  }
  fmpz_mpoly_swap(&z->num, above.get(), ring);
  fmpz_mpoly_swap(&z->den, below.get(), ring);
}

}  // namespace torse::detail
