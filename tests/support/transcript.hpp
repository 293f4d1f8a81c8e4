// Pages of commands with what they print.
//   Example          a command of a page, and the lines that it is said to print
//   examples_of      those of a page
//   Transcript       a folder where the page's commands run, one after the other, with the samples and examples at
//   their places pages_below      the pages of a folder
// In an indented block of a page a line "$ COMMAND" is followed by what COMMAND prints on both outputs, and [N] if that
// is its exit code and not 0. "..." stands for any text within a line, alone in a line for any lines.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "support/program.hpp"

namespace torse::testing {

inline const std::string page_margin = "    ";

struct Example {
  std::string command;
  std::size_t line = 0;  ///< of the page, from 1
  std::vector<std::string> printed;
};

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// An empty line belongs to the example if it goes on behind.
inline std::vector<Example> examples_of(const std::vector<std::string>& page) {
  std::vector<Example> examples;
  std::size_t empty = 0;
  bool open = false;
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (page[i].starts_with(page_margin + "$ ")) {
      examples.push_back({page[i].substr(page_margin.size() + 2), i + 1, {}});
      empty = 0;
      open = true;
    } else if (page[i].starts_with(page_margin) && open) {
      examples.back().printed.resize(examples.back().printed.size() + empty);
      examples.back().printed.push_back(page[i].substr(page_margin.size()));
      empty = 0;
    } else if (page[i].empty()) {
      ++empty;
    } else {
      open = false;
    }
  }
  return examples;
}

/// Whether the text has the parts of the pattern between its "...", in their order.
inline bool fits(const std::string& pattern, const std::string& text) {
  const std::string dots = "...";
  std::size_t end = pattern.find(dots);
  if (end == std::string::npos) return text == pattern;
  if (!text.starts_with(pattern.substr(0, end))) return false;
  std::size_t at = end;
  while (true) {
    const std::size_t begin = end + dots.size();
    end = pattern.find(dots, begin);
    const std::string part = pattern.substr(begin, end - begin);
    if (end == std::string::npos) return text.size() >= at + part.size() && text.ends_with(part);
    at = text.find(part, at);
    if (at == std::string::npos) return false;
    at += part.size();
  }
}

inline bool fits(const std::vector<std::string>& pattern, const std::vector<std::string>& text, std::size_t i = 0,
                 std::size_t k = 0) {
  for (; i < pattern.size(); ++i, ++k) {
    if (pattern[i].ends_with("...") && pattern[i].find_first_not_of(' ') == pattern[i].size() - 3) {
      for (; k <= text.size(); ++k) {
        if (fits(pattern, text, i + 1, k)) return true;
      }
      return false;
    }
    if (k == text.size() || !fits(pattern[i], text[k])) return false;
  }
  return k == text.size();
}

/// The printed lines, as the page had them where they fit a line of it.
inline std::vector<std::string> with_dots(std::vector<std::string> printed, const std::vector<std::string>& old) {
  for (std::string& line : printed) {
    const auto same = std::ranges::find_if(old, [&](const std::string& pattern) { return fits(pattern, line); });
    if (same != old.end() && *same != "...") line = *same;
  }
  return printed;
}

inline std::string as_in_a_page(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (line.empty() ? "" : page_margin + line) + "\n";
  return text;
}

inline std::vector<std::string> pages_below(const std::filesystem::path& folder) {
  const std::filesystem::path source = TORSE_SOURCE_PATH;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / folder)) {
    if (entry.path().extension() == ".md") names.push_back(std::filesystem::relative(entry.path(), source));
  }
  std::ranges::sort(names);
  return names;
}

/// Its parameter is a page's path below the source.
class Transcript : public ::testing::TestWithParam<std::string> {
 public:
  static std::string name(const ::testing::TestParamInfo<std::string>& page) {
    std::string name = page.param;
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return name;
  }

 protected:
  Transcript() {
    namespace fs = std::filesystem;
    fs::create_directories(scratch_ / "tests/golden");
    for (const char* folder : {"examples", "tests/golden/samples"}) {
      fs::create_directory_symlink(fs::path(TORSE_SOURCE_PATH) / folder, scratch_ / folder);
    }
  }

  static std::vector<std::string> page() {
    return lines_of(slurp(std::filesystem::path(TORSE_SOURCE_PATH) / GetParam()));
  }

  /// What a line of the shell prints.
  std::vector<std::string> printed_by(const std::string& command) const {
    const std::filesystem::path program = TORSE_PROGRAM_PATH;
    const Scratch outside;
    spill(outside / "command", "cd '" + scratch_.path().string() + "'\nPATH='" + program.parent_path().string() +
                                   "':\"$PATH\"\n" + command + "\n");
    const std::string line =
        "sh '" + (outside / "command").string() + "' >'" + (outside / "out").string() + "' 2>&1 </dev/null";
    const int status = std::system(line.c_str());
    std::vector<std::string> lines = lines_of(slurp(outside / "out"));
    if (status != 0) lines.push_back("[" + std::to_string(status >> 8) + "]");
    return lines;
  }

  /// Every command prints what stands below it. With TORSE_WRITE_TRANSCRIPTS in the environment the page is written
  /// anew where it is not so.
  void expect_as_written() const {
    const std::vector<std::string> lines = page();
    const std::vector<Example> examples = examples_of(lines);
    EXPECT_FALSE(examples.empty());
    std::string anew;
    std::size_t taken = 0;
    const auto take = [&](std::size_t end) {
      for (; taken < end; ++taken) anew += lines[taken] + "\n";
    };
    for (const Example& example : examples) {
      const std::vector<std::string> printed = printed_by(example.command);
      const bool same = fits(example.printed, printed);
      EXPECT_TRUE(same) << GetParam() << ":" << example.line << ": $ " << example.command << "\nprinted\n"
                        << as_in_a_page(printed);
      take(example.line);
      anew += as_in_a_page(same ? example.printed : with_dots(printed, example.printed));
      taken += example.printed.size();
    }
    take(lines.size());
    if (HasFailure() && std::getenv("TORSE_WRITE_TRANSCRIPTS") != nullptr) {
      spill(std::filesystem::path(TORSE_SOURCE_PATH) / GetParam(), anew);
    }
  }

 private:
  Scratch scratch_;
};

}  // namespace torse::testing
