// What mpirun is told by the tests.
#pragma once

#include <map>
#include <string>

namespace torse::testing {

/// Ranks on this machine alone, as any user, more of them than processors. Open MPI keeps memory to its end.
inline const std::map<std::string, std::string> mpi_variables{{"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                                                              {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                                                              {"OMPI_MCA_plm", "isolated"},
                                                              {"OMPI_MCA_rmaps_base_oversubscribe", "1"},
                                                              {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"},
                                                              {"ASAN_OPTIONS", "detect_leaks=0"}};

}  // namespace torse::testing
