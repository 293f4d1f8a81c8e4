// The routes in each arithmetic, a translation unit each.
#pragma once

#include "torse/studies/routes.hpp"

namespace torse::studies {

Computed run_float(std::size_t route, const Case& in);
Computed run_double(std::size_t route, const Case& in);
Computed run_long_double(std::size_t route, const Case& in);
Computed run_float128(std::size_t route, const Case& in);
Computed run_mpfr53(std::size_t route, const Case& in);
Computed run_mpfr113(std::size_t route, const Case& in);
Computed run_mpfr200(std::size_t route, const Case& in);
Computed run_exact(std::size_t route, const Case& in);

}  // namespace torse::studies
