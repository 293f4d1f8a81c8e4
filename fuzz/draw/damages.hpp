// The damages that draw_damaged_file chooses from.
//   TreeDamage, value_damages, construction_damage      of the tree before it is written
//   TextDamage, syntax_damages                          of the text
// Each knows the place of the error because it is the only thing that is wrong. One that does not apply to a file (no
// weights, no knots) makes no case: it throws Discard.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "torse/fuzz/draw/file_text.hpp"

namespace torse::fuzz {

/// Returns the place of the error.
struct TreeDamage {
  const char* name;
  std::string (*damage)(Choices&, DrawnFile&);
};

/// A text and the offset where the parser stops, if that is known.
using DamagedText = std::pair<std::string, std::optional<std::size_t>>;

/// Returns the damaged text.
struct TextDamage {
  const char* name;
  DamagedText (*damage)(Choices&, DrawnFile&);
};

/// Keys, types, counts and ranges of any file.
std::span<const TreeDamage> value_damages();
/// What a construction alone may have wrong.
TreeDamage construction_damage();
/// What is no JSON.
std::span<const TextDamage> syntax_damages();

}  // namespace torse::fuzz
