// What the libFuzzer targets share: a property that does not hold ends the program, and the fuzzer keeps the input.
//   require        a property        text_of      the input as text
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace torse::targets {

/// Standard error as it is before the fuzzer closes it to what the input prints (-close_fd_mask).
inline const int messages = dup(STDERR_FILENO);

/// Ends the program with this message unless the property holds.
inline void require(bool holds, std::string_view property) {
  if (holds) return;
  dprintf(messages, "property violated: %.*s\n", static_cast<int>(property.size()), property.data());
  std::abort();
}

/// The input of a target as text.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace torse::targets
