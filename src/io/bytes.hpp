// Numbers as little-endian bytes of binary formats.
//   append_word       a 32-bit unsigned integer        append_float      a number of single precision
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "torse/scalar/errors.hpp"

namespace torse {

/// Throws Error for a number beyond 32 bits.
inline void append_word(std::string& bytes, std::size_t value) {
  if (value > std::numeric_limits<std::uint32_t>::max()) throw Error("the mesh is too large for this format");
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 0xFF);
}

inline void append_float(std::string& bytes, double value) {
  append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

}  // namespace torse
