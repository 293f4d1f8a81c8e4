// Products with fractions whose numerator and denominator are units or linear, which fill the formulas of the papers
// ((M* - u_{i+n}) / (M* - u_i) and the like): two trial divisions in the place of two greatest common divisors.
//   is_simple                  whether a polynomial is +-1 or linear and primitive
//   multiply_by_simple         z = x c / d for simple c, d
#pragma once

#include "torse/exact/symbolic/flint_headers.hpp"

namespace torse::detail {

/// Whether p is 1, -1, or of total degree one with a coefficient +-1, hence irreducible over Z. Some simple polynomials
/// are not recognised.
bool is_simple(const fmpz_mpoly_struct* p, const fmpz_mpoly_ctx_struct* ring);

/// z = x c / d, reduced, for a reduced x and coprime simple c, d. z may be x, and c, d may be parts of z.
void multiply_by_simple(fmpz_mpoly_q_struct* z, const fmpz_mpoly_q_struct* x, const fmpz_mpoly_struct* c,
                        const fmpz_mpoly_struct* d, const fmpz_mpoly_ctx_struct* ring);

}  // namespace torse::detail
