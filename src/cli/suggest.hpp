// Suggestions for mistyped words.
//   edit_distance    Levenshtein's, with a swap of neighbours as one edit
//   suggestion       "; did you mean X?" or nothing
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace torse::cli {

/// The least number of insertions, deletions, replacements and swaps of neighbours (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// "; did you mean X?" for the nearest candidate that is not too far (a third of the word's length, at least 1), or "".
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace torse::cli
