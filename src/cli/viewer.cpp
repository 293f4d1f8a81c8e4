// The file TORSE_VIEWER as bytes of the program. CMake sets the name where the file is there.
#include "torse/cli/viewer.hpp"

#ifdef TORSE_VIEWER

// The assembler copies the file, which no compiler then has to read as a list of numbers.
asm(R"(
  .pushsection .rodata
  .global torse_viewer_begin
  .global torse_viewer_end
torse_viewer_begin:
  .incbin ")" TORSE_VIEWER R"("
torse_viewer_end:
  .byte 0
  .popsection
)");

extern "C" const char torse_viewer_begin[];
extern "C" const char torse_viewer_end[];

namespace torse::cli {

std::string_view viewer() { return {torse_viewer_begin, torse_viewer_end}; }

}  // namespace torse::cli

#else

namespace torse::cli {

std::string_view viewer() { return {}; }

}  // namespace torse::cli

#endif
