// torse recover: Lam, M, sigma of developable surfaces as exact rational functions, with all that follows from them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/recovered.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// As many singularities as a person reads; --json has all.
constexpr std::size_t most_singular = 12;

struct RecoverOptions {
  std::vector<std::string> files;
  std::string json;
};

std::string json_report(const std::vector<RecoveredFile>& files) {
  Json surfaces = Json::array();
  Json errors = Json::array();
  for (const RecoveredFile& recovered : files) {
    if (recovered.error) {
      errors.push_back({{"file", printable(recovered.file)}, {"message", recovered.error->what()}});
    } else {
      surfaces.push_back(recovered_json(recovered));
    }
  }
  return Json{{"torse", 1}, {"surfaces", surfaces}, {"errors", errors}}.dump(2) + '\n';
}

void print_file(const Terminal& terminal, const RecoveredFile& recovered) {
  const Judgement& judgement = *recovered.judgement;
  const std::string file = printable(recovered.file);
  if (!judgement.developable()) {
    terminal.print(fmt::format("{}: {}: {}\n  {}\n", file, terminal.painted(Paint::bad, "not developable"),
                               describe(*judgement.witness, recovered.surface->knots),
                               terminal.painted(Paint::dim, "replay: " + recovered.replay)));
    return;
  }
  const Paint paint = recovered.singular.empty() ? Paint::good : Paint::doubtful;
  terminal.print(fmt::format("{}: {}\n{}  {}\n", file, describe(judgement.classification), recovered_text(recovered),
                             terminal.painted(paint, singular_text(recovered.singular, most_singular))));
}

int code_of(const std::vector<RecoveredFile>& files) {
  if (std::ranges::any_of(files, [](const RecoveredFile& f) { return f.error.has_value(); })) {
    return exit_code::unusable;
  }
  const bool all = std::ranges::all_of(files, [](const RecoveredFile& f) { return f.judgement->developable(); });
  return all ? exit_code::success : exit_code::refuted;
}

int run_recover(const RecoverOptions& options) {
  std::vector<RecoveredFile> files;
  const Terminal terminal(stdout);
  for (const std::string& file : options.files) {
    files.push_back(recover_file(file));
    if (files.back().error) {
      print_error(std::string(files.back().error->what()) + "\n  replay: " + files.back().replay);
    } else if (options.json != "-") {
      print_file(terminal, files.back());
    }
  }
  if (!options.json.empty()) write_file(options.json, json_report(files));
  return code_of(files);
}

}  // namespace

std::function<int()> define_recover(CLI::App& app) {
  const auto options = std::make_shared<RecoverOptions>();
  app.add_option("FILE", options->files, "developable ruled surfaces in torse's JSON; - is standard input")->required();
  app.add_option("--json", options->json, "write the results as JSON; - is standard output")->type_name("FILE");
  return [options] { return run_recover(*options); };
}

}  // namespace torse::cli
