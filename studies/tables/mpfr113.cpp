// The routes over BigFloat<113>.
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_mpfr113(std::size_t route, const Case& in) { return run_in<BigFloat<113>>(route, in); }

}  // namespace torse::studies
