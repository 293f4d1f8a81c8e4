// torse recover: Lam, M, sigma of developable surfaces as exact rational functions, with all that follows from them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/recovered.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// As many singularities as a person reads; --json has all.
constexpr std::size_t most_singular = 12;

struct RecoverOptions {
  FaceInput input;
  std::string json;
};

Json report_of(const std::vector<RecoveredFace>& faces) {
  Json surfaces = Json::array();
  Json errors = Json::array();
  for (const RecoveredFace& recovered : faces) {
    if (recovered.error) {
      errors.push_back({{"file", printable(recovered.face.file)}, {"message", recovered.error->what()}});
    } else {
      surfaces.push_back(recovered_json(recovered));
    }
  }
  return {{"torse", 1}, {"surfaces", surfaces}, {"errors", errors}};
}

void print_face(const Terminal& terminal, const RecoveredFace& recovered) {
  const std::string title = title_of(recovered.face);
  if (!recovered.judgement) {
    terminal.print(
        fmt::format("{}: {}: {}\n", title, terminal.painted(Paint::doubtful, "not ruled"), recovered.face.remark));
    return;
  }
  const Judgement& judgement = *recovered.judgement;
  if (!judgement.developable()) {
    terminal.print(fmt::format("{}: {}: {}\n  {}\n", title, terminal.painted(Paint::bad, "not developable"),
                               describe(*judgement.witness, recovered.face.surface->knots),
                               terminal.painted(Paint::dim, "replay: " + recovered.replay)));
    return;
  }
  if (recovered.beyond_budget) {
    terminal.print(fmt::format(
        "{}: {}\n  {}\n", title, describe(judgement.classification),
        terminal.painted(Paint::doubtful, "the numbers of its net are too long to recover Lambda, M and sigma")));
    return;
  }
  const Paint paint = recovered.singular.empty() ? Paint::good : Paint::doubtful;
  terminal.print(fmt::format("{}: {}\n{}  {}\n", title, describe(judgement.classification), recovered_text(recovered),
                             terminal.painted(paint, singular_text(recovered.singular, most_singular))));
}

/// A run that recovered nothing decides nothing.
int code_of(const std::vector<RecoveredFace>& faces) {
  const auto any = [&](auto&& property) { return std::ranges::any_of(faces, property); };
  if (any([](const RecoveredFace& f) { return f.error.has_value(); })) return exit_code::unusable;
  if (any([](const RecoveredFace& f) { return f.judgement && !f.judgement->developable(); })) return exit_code::refuted;
  if (any([](const RecoveredFace& f) { return f.beyond_budget; })) return exit_code::undecided;
  return any([](const RecoveredFace& f) { return f.developable(); }) ? exit_code::success : exit_code::undecided;
}

int run_recover(const RecoverOptions& options) {
  std::vector<RecoveredFace> faces;
  const Terminal terminal(stdout);
  for (const std::string& file : options.input.files) {
    for (RecoveredFace& recovered : recover_faces(file, options.input.face)) {
      if (recovered.error) {
        print_error(std::string(recovered.error->what()) + "\n  replay: " + recovered.replay);
      } else if (options.json != "-") {
        print_face(terminal, recovered);
      }
      faces.push_back(std::move(recovered));
    }
  }
  write_json(options.json, report_of(faces));
  return code_of(faces);
}

}  // namespace

std::function<int()> define_recover(CLI::App& app) {
  const auto options = std::make_shared<RecoverOptions>();
  add_face_inputs(app, options->input, "developable ruled surfaces");
  app.add_option("--json", options->json, "write the results as JSON; - is standard output")->type_name("FILE");
  return [options] { return run_recover(*options); };
}

}  // namespace torse::cli
