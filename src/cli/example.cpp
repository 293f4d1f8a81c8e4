// torse example: the papers' worked examples, the printed value beside the computed one.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/examples.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse::cli {
namespace {

using proofs::ExampleRow;

struct ExampleOptions {
  std::string json;
  HtmlOption html;
};

void print_rows(const std::vector<ExampleRow>& rows) {
  const Terminal terminal(stdout);
  std::size_t label = 0;
  std::size_t printed = 0;
  for (const ExampleRow& row : rows) {
    label = std::max(label, row.label.size());
    printed = std::max(printed, row.printed.size());
  }
  terminal.print("FJ21, section 8: printed, computed\n");
  std::string group;
  for (const ExampleRow& row : rows) {
    if (row.group != group) terminal.print(terminal.painted(Paint::dim, row.group) + "\n");
    group = row.group;
    const std::string mark = row.equal ? terminal.painted(Paint::good, "=") : terminal.painted(Paint::bad, "differs:");
    terminal.print(
        fmt::format("  {:<{}}  {:<{}}  {} {}\n", row.label, label, row.printed, printed, mark, row.computed));
  }
  const auto equal = std::ranges::count(rows, true, &ExampleRow::equal);
  terminal.print(fmt::format("{} of {} printed values reproduced exactly\n", equal, rows.size()));
}

int run_example(const ExampleOptions& options) {
  require_viewer(options.html);
  const std::vector<ExampleRow> rows = proofs::section8_rows<Rational>();
  write_json(options.json, examples_json(rows));
  write_html(options.html, "FJ21, section 8, recomputed", nlohmann::ordered_json::array({examples_section()}));
  if (options.json != "-") print_rows(rows);
  return std::ranges::all_of(rows, &ExampleRow::equal) ? exit_code::success : exit_code::refuted;
}

}  // namespace

std::function<int()> define_example(CLI::App& app) {
  const auto options = std::make_shared<ExampleOptions>();
  app.add_option("--json", options->json, "write the values as JSON; - is standard output")->type_name("FILE");
  add_html_option(app, options->html);
  return [options] { return run_example(*options); };
}

}  // namespace torse::cli
