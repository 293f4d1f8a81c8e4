// Files with one thing wrong with them.
//   DamagedFile     the text, what is wrong and where the error has to be        draw_damaged_file
//   scrambled       a text after random changes of its bytes
#pragma once

#include <optional>
#include <string>

#include "torse/fuzz/draw/file_text.hpp"

namespace torse::fuzz {

/// A text that has to be refused.
struct DamagedFile {
  std::string type;    ///< which reader is asked
  std::string damage;  ///< "weight zero"
  std::string text;
  std::string place;             ///< of the error; empty for errors of syntax and of the whole file
  std::optional<LineColumn> at;  ///< where that stands, if it is known
};

/// A valid file, damaged in one way out of many: syntax, keys, types, counts, ranges, knots, weights, numbers.
DamagedFile draw_damaged_file(Choices& choices, const Scale& scale, Labels& labels);

/// The text with bytes left out, replaced, repeated or moved; every other one with changes of digits alone.
std::string scrambled(Choices& choices, std::string text);

}  // namespace torse::fuzz
