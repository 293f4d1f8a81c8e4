// The routes over long double.
#include "torse/scalar/builtin.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_long_double(std::size_t route, const Case& in) { return run_in<long double>(route, in); }

}  // namespace torse::studies
