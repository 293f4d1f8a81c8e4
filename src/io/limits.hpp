// The limits of what is read, so that no input exhausts memory or time. docs/formats.md lists them.
#pragma once

#include <cstddef>

namespace torse::limits {

/// Bytes of a file.
inline constexpr std::size_t file_bytes = std::size_t{64} << 20;
/// Arrays and objects inside each other.
inline constexpr std::size_t depth = 32;
/// Values (numbers, strings, arrays ...) in a document.
inline constexpr std::size_t values = std::size_t{1} << 21;
/// Keys of one object.
inline constexpr std::size_t keys = 64;
/// Spaces and ends of lines in a row.
inline constexpr std::size_t blanks = std::size_t{1} << 20;
/// Characters of one number.
inline constexpr std::size_t number_characters = 1'000'000;
/// The decimal exponent of a number, in absolute value.
inline constexpr long decimal_exponent = 4000;
/// The binary exponent of a hexadecimal float, in absolute value.
inline constexpr long binary_exponent = 20'000;
/// The degree of a spline.
inline constexpr int degree = 100;
/// Control points of a curve.
inline constexpr int points = 100'000;

/// Processor time in seconds and memory in bytes of the process that reads or writes a STEP or IGES file.
inline constexpr unsigned cad_seconds = 7;
inline constexpr std::size_t cad_memory = std::size_t{768} << 20;

}  // namespace torse::limits
