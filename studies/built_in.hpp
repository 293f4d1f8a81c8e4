// The designs of studies/*.json as they were when the program was built.
//   BuiltIn, built_in_designs
#pragma once

#include <string_view>
#include <vector>

namespace torse::studies {

/// A file of studies/ without its ending, and its text.
struct BuiltIn {
  std::string_view name;
  std::string_view text;
};

/// All of them by name. CMake writes the definition.
const std::vector<BuiltIn>& built_in_designs();

}  // namespace torse::studies
