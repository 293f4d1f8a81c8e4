// Colours by fmt, quoting as POSIX shells want it.
#include "torse/cli/terminal.hpp"

#include <fmt/color.h>
#include <unistd.h>

#include <cstdlib>

#include "torse/scalar/errors.hpp"

namespace torse::cli {
namespace {

bool wants_colours(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  if (no_color != nullptr && *no_color != '\0') return false;
  if (term != nullptr && std::string_view(term) == "dumb") return false;
  return isatty(fileno(stream)) == 1;
}

fmt::text_style style_of(Paint paint) {
  switch (paint) {
    case Paint::good:
      return fmt::fg(fmt::terminal_color::green);
    case Paint::bad:
      return fmt::fg(fmt::terminal_color::red);
    case Paint::doubtful:
      return fmt::fg(fmt::terminal_color::yellow);
    case Paint::dim:
      break;
  }
  return fmt::emphasis::faint;
}

}  // namespace

Terminal::Terminal(std::FILE* stream) : stream_(stream), colours_(wants_colours(stream)) {}

std::string Terminal::painted(Paint paint, const std::string& text) const {
  return colours_ ? fmt::format(style_of(paint), "{}", text) : text;
}

void Terminal::print(const std::string& text) const {
  const bool written = std::fwrite(text.data(), 1, text.size(), stream_) == text.size() && std::fflush(stream_) == 0;
  if (!written) throw Error("the output cannot be written");
}

void print_error(const std::string& message) {
  const Terminal terminal(stderr);
  terminal.print("torse: " + terminal.painted(Paint::bad, "error") + ": " + message + "\n");
}

std::string command_line(const std::vector<std::string>& words) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._/=+:,@%";
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

std::string file_word(const std::string& file) { return file.starts_with('-') && file != "-" ? "./" + file : file; }

}  // namespace torse::cli
