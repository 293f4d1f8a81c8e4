// The compiler's 128-bit integers, for exact products of 64-bit ones.
#pragma once

namespace torse {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

}  // namespace torse
