// torse figures: the papers' figures, drawn from what the library computes.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "torse/cli/command.hpp"
#include "torse/cli/html_report.hpp"
#include "torse/cli/page_sections.hpp"
#include "torse/cli/suggest.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/figures/figure.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using figures::PaperFigure;

struct FiguresOptions {
  std::vector<std::string> ids;
  std::string folder;
  HtmlOption html;
};

// Those with the ids, or of the papers with the ids; all without one.
std::vector<PaperFigure> chosen(const std::vector<std::string>& ids) {
  const std::vector<PaperFigure> all = figures::all_figures();
  std::vector<PaperFigure> result;
  for (const std::string& id : ids) {
    const std::size_t before = result.size();
    for (const PaperFigure& figure : all) {
      if (figure.id == id || figure.id.starts_with(id + ".")) result.push_back(figure);
    }
    if (result.size() > before) continue;
    std::vector<std::string> known;
    for (const PaperFigure& figure : all) known.push_back(figure.id);
    throw UsageError("no figure " + printable(id) + suggestion(id, known));
  }
  return ids.empty() ? all : result;
}

int run_figures(const FiguresOptions& options) {
  require_viewer(options.html);
  const std::vector<PaperFigure> list = chosen(options.ids);
  std::string text;
  for (const PaperFigure& figure : list) {
    text += fmt::format("{:<12} {}\n", figure.id, figure.title);
    if (options.folder.empty()) continue;
    make_folder(options.folder);
    const std::string file = (std::filesystem::path(options.folder) / (figure.id + ".svg")).string();
    write_file(file, figures::figure_svg(figure, figure.draw()));
  }
  if (options.html.wanted()) {
    write_html(options.html, "The papers' figures", nlohmann::ordered_json::array({figures_section(list, true)}));
  }
  Terminal(stdout).print(text);
  return exit_code::success;
}

}  // namespace

std::function<int()> define_figures(CLI::App& app) {
  const auto options = std::make_shared<FiguresOptions>();
  app.add_option("id", options->ids, "a figure, FJ07.Fig1, or all of a paper, FJ07 (all)")->type_name("ID");
  app.add_option("-o,--out", options->folder, "write each as ID.svg into this folder, which is made")->type_name("DIR");
  add_html_option(app, options->html);
  return [options] { return run_figures(*options); };
}

}  // namespace torse::cli
