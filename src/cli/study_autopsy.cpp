// torse study autopsy: the operations of an input that lose digits, by the formulas they belong to.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "torse/cli/command.hpp"
#include "torse/cli/json_report.hpp"
#include "torse/cli/study.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"
#include "torse/studies/autopsy.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using studies::Autopsy;
using studies::Loss;

/// "d[3].y" of an operation's place.
std::string entry_of(const Loss& loss) {
  if (loss.place.formula.empty()) return "-";
  return fmt::format("{}[{}]{}", loss.place.row, loss.place.index,
                     loss.coordinate.empty() ? "" : "." + loss.coordinate);
}

std::string formula_of(const Loss& loss) {
  if (!loss.place.formula.empty()) return loss.place.formula;
  return loss.kind == '=' ? "input" : "-";
}

Json json_of(const Loss& loss) {
  return {{"formula", loss.place.formula},
          {"row", loss.place.row},
          {"index", loss.place.index},
          {"coordinate", loss.coordinate},
          {"operation", std::string(1, loss.kind)},
          {"expression", loss.expression},
          {"digits_lost", loss.digits},
          {"bits_cancelled", loss.cancelled},
          {"rounding_units", loss.local},
          {"value", loss.value},
          {"exact", loss.exact},
          {"share", loss.share}};
}

Json report_of(const std::string& file, const Autopsy& autopsy) {
  Json lost = Json::array();
  Json made = Json::array();
  for (const Loss& loss : autopsy.lost) lost.push_back(json_of(loss));
  for (const Loss& loss : autopsy.made) made.push_back(json_of(loss));
  Json report{{"torse", 1},
              {"file", printable(file)},
              {"operations", autopsy.operations},
              {"worst",
               {{"name", autopsy.worst.name},
                {"value", autopsy.worst.value},
                {"exact", autopsy.worst.exact},
                {"digits", autopsy.worst.digits}}},
              {"lost", std::move(lost)},
              {"made", std::move(made)}};
  return report;
}

}  // namespace

int print_autopsy(const std::string& file, const std::string& route, const std::string& json) {
  const Document document(file, read_file(file));
  const Autopsy autopsy = studies::autopsy_of(document, route);
  write_json(json, report_of(file, autopsy));
  if (json == "-") return exit_code::success;

  const Terminal terminal(stdout);
  const auto& worst = autopsy.worst;
  terminal.print(fmt::format("{}: {} operations in double\n", printable(file), autopsy.operations));
  terminal.print(
      std::isfinite(worst.value)
          ? fmt::format("the worst result is {} = {:.17g}, exactly {:.17g}: {:.1f} of 16.0 digits are right\n",
                        worst.name, worst.value, worst.exact, worst.digits)
          : fmt::format("{} leaves the range of double\n", worst.name));
  if (autopsy.lost.empty()) terminal.print("no operation loses a digit\n");
  if (!autopsy.lost.empty()) {
    terminal.print(terminal.painted(Paint::dim, fmt::format("\n{:>11} {:>9}  {:<16} {:<10} operation that loses them\n",
                                                            "digits lost", "cancelled", "formula", "entry")));
  }
  for (const Loss& loss : autopsy.lost) {
    terminal.print(fmt::format("{:>11.1f} {:>9}  {:<16} {:<10} {}\n", loss.digits,
                               fmt::format("{:.0f} bits", loss.cancelled), formula_of(loss), entry_of(loss),
                               loss.expression));
  }
  if (autopsy.made.empty()) return exit_code::success;
  terminal.print(terminal.painted(
      Paint::dim, fmt::format("\n{:>11} {:>9}  {:<16} {:<10} rounding that the worst result suffers from\n", "share",
                              "rounded", "formula", "entry")));
  for (const Loss& loss : autopsy.made) {
    terminal.print(fmt::format("{:>11} {:>9}  {:<16} {:<10} {}\n", fmt::format("{:.1f}%", 100 * loss.share),
                               fmt::format("{:.2f} u", loss.local), formula_of(loss), entry_of(loss), loss.expression));
  }
  return exit_code::success;
}

}  // namespace torse::cli
