// The routes over Float128.
#include "torse/exact/bigfloat/float128.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_float128(std::size_t route, const Case& in) { return run_in<Float128>(route, in); }

}  // namespace torse::studies
