// The processes that mpirun has started.
//   ranks_of_environment      this one and the others
#pragma once

#include "torse/fuzz/campaign/ranks.hpp"

namespace torse::cli {

/// Starts MPI where mpirun has started this process; null where it has not. Throws Error where it has but the plugin
/// torse_mpi.so is not there or cannot be used.
fuzz::Ranks* ranks_of_environment();

}  // namespace torse::cli
