// The version of the program, the one of CMakeLists.txt.
#pragma once

namespace torse::cli {

inline constexpr const char* version = "0.1.0";

}  // namespace torse::cli
