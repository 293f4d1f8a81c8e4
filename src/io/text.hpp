// Text for messages.
//   in_quotes       a value as it stands in a message: in quotes, shortened, without control characters
//   printable       the same without quotes, for names of files
#pragma once

#include <string>
#include <string_view>

namespace torse {

/// The text with control characters and bytes that are not UTF-8 as \xNN.
std::string printable(std::string_view text);

/// The text in double quotes, printable, cut after 40 bytes or so with "...".
std::string in_quotes(std::string_view text);

}  // namespace torse
