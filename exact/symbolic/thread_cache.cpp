#include "torse/exact/symbolic/thread_cache.hpp"

#include "torse/exact/symbolic/flint_headers.hpp"

namespace torse {

void release_flint_cache() { flint_cleanup(); }

}  // namespace torse
