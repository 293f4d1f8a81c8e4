// What tells this program from the same version compiled from other sources.
//   build_id      the number that the linker has given it
#pragma once

#include <string>

namespace torse::cli {

/// The GNU build id of the program in hexadecimal digits, or "unknown" where it was linked without one.
std::string build_id();

}  // namespace torse::cli
