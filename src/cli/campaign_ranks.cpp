#include "torse/cli/campaign_ranks.hpp"

#include <cstdlib>

#include "torse/cli/plugin.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::cli {

fuzz::Ranks* ranks_of_environment() {
  // What mpirun of Open MPI, and other starters of its processes, tell each of them.
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr) return nullptr;
  const auto plugin = find_plugin("torse_mpi.so");
  if (!plugin) {
    throw Error("started by mpirun, but the optional part of torse that uses MPI is not there: ./x mpi builds it");
  }
  return reinterpret_cast<fuzz::RanksEntry>(plugin_symbol(*plugin, fuzz::ranks_entry))();
}

}  // namespace torse::cli
