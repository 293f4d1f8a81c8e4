// What the program prints with STEP and IGES, word for word: the transcripts beside this file, and the examples of
// README.md and docs/. These show what they are about: a command without output is not run, exit codes are not
// compared.
#include "support/transcript.hpp"

namespace torse::testing {
namespace {

class CadWords : public Transcript {};

TEST_P(CadWords, PrintWhatIsWritten) { expect_as_written(); }

INSTANTIATE_TEST_SUITE_P(Golden, CadWords, ::testing::ValuesIn(pages_below("tests/cad/transcripts")), Transcript::name);

bool is_exit_code(const std::string& line) { return line.starts_with('[') && line.ends_with(']') && line.size() <= 5; }

class Page : public Transcript {};

TEST_P(Page, ShowsWhatIsPrinted) {
  for (const Example& example : examples_of(page())) {
    if (example.printed.empty()) continue;
    std::vector<std::string> printed = printed_by(example.command);
    if (!printed.empty() && is_exit_code(printed.back())) printed.pop_back();
    EXPECT_TRUE(fits(example.printed, printed))
        << GetParam() << ":" << example.line << ": $ " << example.command << "\nprinted\n"
        << as_in_a_page(printed);
  }
}

std::vector<std::string> pages_with_examples() {
  std::vector<std::string> names = pages_below("docs");
  names.emplace_back("README.md");
  std::erase_if(names, [](const std::string& name) {
    const auto examples = examples_of(lines_of(slurp(std::filesystem::path(TORSE_SOURCE_PATH) / name)));
    return std::ranges::all_of(examples, [](const Example& example) { return example.printed.empty(); });
  });
  return names;
}

INSTANTIATE_TEST_SUITE_P(Golden, Page, ::testing::ValuesIn(pages_with_examples()), Transcript::name);

}  // namespace
}  // namespace torse::testing
