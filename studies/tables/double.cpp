// The routes over double.
#include "torse/scalar/builtin.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_double(std::size_t route, const Case& in) { return run_in<double>(route, in); }

}  // namespace torse::studies
