// What tells this program from the same version compiled from other sources.
//   build_id      the number that the linker has given it      id_among    that of a segment of notes
#pragma once

#include <string>
#include <string_view>

namespace torse::cli {

/// The GNU build id of the program in hexadecimal digits, or "unknown" where it was linked without one.
std::string build_id();

/// The description of the note NT_GNU_BUILD_ID in the bytes of a segment of notes, in hexadecimal digits; empty for none.
std::string id_among(std::string_view notes);

}  // namespace torse::cli
