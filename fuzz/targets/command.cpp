// The command line: lines of the input are words of a run of the program in this process. Whatever they are, it ends
// with one of its exit codes and leaves no half-written file.
//   Folder      the only files that the words can name
//   words_of    the words; those with a stroke name no file, and commands that work for minutes are parsed only
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/fuzz/targets/target.hpp"

namespace torse::targets {
namespace {

namespace fs = std::filesystem;

/// A new folder, the current one as long as the program runs, with a file of each type.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "torse-fuzz-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, "there is a folder for temporary files");
    path_ = name;
    fs::current_path(path_);
    const fs::path samples = fs::path(TORSE_SOURCE_PATH) / "fuzz/corpus/json";
    copy(samples / "ruled-bezier", "r");
    copy(samples / "construct-bezier", "c");
    copy(samples / "construct-interpolate", "i");
    copy(samples / "trailing", "x");
    copy(fs::path(TORSE_SOURCE_PATH) / "tests/golden/samples/check-04-cone-n2-N1-clamped.json", "k");
    restore();
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  /// Removes what a run has written. No temporary file may be left.
  void restore() {
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      const std::string name = entry.path().filename().string();
      require(!name.starts_with('.') || !name.ends_with(".tmp"), "no temporary file is left");
      fs::remove_all(entry.path());
    }
    for (const auto& [name, text] : files_) std::ofstream(path_ / name, std::ios::binary) << text;
  }

 private:
  void copy(const fs::path& from, const std::string& to) {
    std::ifstream file(from, std::ios::binary);
    files_[to] = std::string(std::istreambuf_iterator<char>(file), {});
  }

  fs::path path_;
  std::map<std::string, std::string> files_{};
};

/// Commands that take long whatever their words say, and accuracies that a word may set as fine as it likes.
constexpr std::array<std::string_view, 6> slow{"verify", "campaign", "study", "fit", "--tolerance", "--rulings"};

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (words.size() < 16 && !text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    words.emplace_back(text.substr(0, end));
    std::erase(words.back(), '/');
    std::erase(words.back(), '\0');
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  const auto works_long = [](const std::string& word) {
    return std::ranges::find(slow, std::string_view(word).substr(0, word.find('='))) != slow.end();
  };
  if (std::ranges::any_of(words, works_long)) words.emplace_back("--not-an-option");
  return words;
}

void run(std::string_view text) {
  static Folder folder;
  const int code = cli::run_program(words_of(text));
  require(code >= cli::exit_code::success && code <= cli::exit_code::undecided, "the exit code is one of 0 to 3");
  folder.restore();
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  torse::targets::require(std::freopen("/dev/null", "r", stdin) != nullptr, "standard input is empty");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::run(torse::targets::text_of(data, size));
  return 0;
}
