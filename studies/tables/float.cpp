// The routes over float.
#include "torse/scalar/builtin.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_float(std::size_t route, const Case& in) { return run_in<float>(route, in); }

}  // namespace torse::studies
