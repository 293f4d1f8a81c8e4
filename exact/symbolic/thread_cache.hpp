// FLINT keeps memory for reuse in every thread that has used it.
#pragma once

namespace torse {

/// Gives back what FLINT keeps for this thread. A thread calls it last, when no RationalFunction or Ball of its own is
/// left.
void release_flint_cache();

}  // namespace torse
