// The routes over BigFloat<200>.
#include "torse/exact/bigfloat/bigfloat.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_mpfr200(std::size_t route, const Case& in) { return run_in<BigFloat<200>>(route, in); }

}  // namespace torse::studies
