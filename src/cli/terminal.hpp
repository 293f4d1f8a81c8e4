// What a person sees: colours on a terminal only, commands to type again.
//   Paint, Terminal      coloured words
//   print_error          a line on standard error
//   command_line         words as a shell takes them
//   file_word            a file among the words of a command
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace torse::cli {

/// The meaning of a word, which decides its colour.
enum class Paint { good, bad, doubtful, dim };

/// A stream that is or is not a terminal. Colours are used on a terminal unless NO_COLOR is set or TERM is "dumb".
class Terminal {
 public:
  explicit Terminal(std::FILE* stream);

  /// The text in its colour, or as it is.
  std::string painted(Paint paint, const std::string& text) const;
  /// Writes a text. Throws Error where that fails.
  void print(const std::string& text) const;

 private:
  std::FILE* stream_;
  bool colours_;
};

/// "torse: error: ..." on standard error.
void print_error(const std::string& message);

/// The words joined by blanks, quoted for a POSIX shell where that is needed.
std::string command_line(const std::vector<std::string>& words);

/// The name of a file as a word of a command that no option stands before: "./-x" for "-x", which would be taken for
/// an option.
std::string file_word(const std::string& file);

}  // namespace torse::cli
