// Text for messages, and what text may begin with.
//   in_quotes       a value as it stands in a message: in quotes, shortened, without control characters
//   printable       the same without quotes, for names of files
//   without_byte_order_mark      what follows it
#pragma once

#include <string>
#include <string_view>

namespace torse {

/// The text with control characters (C0, DEL, C1), U+FFFE, U+FFFF and bytes that are not UTF-8 as \xNN.
std::string printable(std::string_view text);

/// The text in double quotes, printable, cut after 40 bytes or so with "...".
std::string in_quotes(std::string_view text);

/// What follows UTF-8's byte order mark where the text begins with it, else the text.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace torse
