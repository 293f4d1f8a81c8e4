// Runs the real program and catches what it says.
//   ProgramResult    exit code, standard output, standard error
//   run_program      with words as they are, in no shell's eyes
//   Scratch          a folder that is removed at the end
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace torse::testing {

inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline void spill(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A new folder below the system's one for temporary files.
class Scratch {
 public:
  Scratch() {
    do {
      path_ = std::filesystem::temp_directory_path() / ("torse-test-" + std::to_string(std::random_device()()));
    } while (!std::filesystem::create_directory(path_));
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct ProgramResult {
  int exit;
  std::string out;
  std::string err;
};

/// `input` comes through a pipe on standard input; without it there is none.
inline ProgramResult run_program(const std::vector<std::string>& words, const std::string& input = "") {
  const auto quote = [](const std::string& word) {
    std::string text = "'";
    for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
  };
  const Scratch scratch;
  spill(scratch / "in", input);
  std::string line =
      (input.empty() ? "" : "cat " + quote((scratch / "in").string()) + " | ") + quote(TORSE_PROGRAM_PATH);
  for (const std::string& word : words) line += ' ' + quote(word);
  line += " >" + quote((scratch / "out").string()) + " 2>" + quote((scratch / "err").string()) +
          (input.empty() ? " </dev/null" : "");
  const int status = std::system(line.c_str());
  const int exit = (status & 0x7F) == 0 ? (status >> 8) & 0xFF : 128 + (status & 0x7F);
  return {exit, slurp(scratch / "out"), slurp(scratch / "err")};
}

}  // namespace torse::testing
