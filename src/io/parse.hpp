// The JSON parser behind Document.
//   parse_json       text -> tree
//   position_of      line and column of an offset
//   exponent_bits    how long the exponent makes a number
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "torse/io/document.hpp"

namespace torse {

/// Where the byte at `offset` stands.
TextPosition position_of(std::string_view text, std::size_t offset);

/// The bits that the exponent at the end of a number adds to it: e for 2^e, 3.33 e for 10^e, 0 for a text without one.
std::size_t exponent_bits(std::string_view text);

/// The tree of a JSON text. Throws FileError for syntax errors, duplicate keys and what is beyond limits.hpp.
Node parse_json(const std::string& file, std::string_view text);

}  // namespace torse
