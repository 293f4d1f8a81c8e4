// Pages from reports.
#include "torse/cli/html_report.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/version.hpp"
#include "torse/io/document.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The words that were typed: the options in the order of the help, what has no name last.
std::vector<std::string> words_of(const CLI::App& app) {
  std::vector<std::string> words =
      app.get_parent() == nullptr ? std::vector<std::string>{} : words_of(*app.get_parent());
  words.push_back(app.get_name());
  std::vector<std::string> unnamed;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (option->get_positional()) {
        unnamed.push_back(file_word(value));
        continue;
      }
      words.push_back(option->get_name());
      if (option->get_items_expected_max() > 0) words.push_back(value);
    }
  }
  words.insert(words.end(), unnamed.begin(), unnamed.end());
  return words;
}

/// How much of a report is kept.
struct Kept {
  std::size_t letters;
  std::size_t entries;
  std::size_t pictures;
  bool drawings = false;
};

/// Level by level less; the last one is a few kilobytes for each section.
constexpr std::array<Kept, 6> levels{
    {{20'000, 20'000, 400, true}, {2'000, 5'000, 100}, {500, 2'000, 20}, {200, 500, 4}, {80, 100, 1}, {40, 20, 0}}};

/// Cuts a text between two characters, never within one.
std::string cut(const std::string& text, std::size_t letters) {
  std::size_t end = letters;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

/// Cuts texts and lists; pictures are whole or left out, drawings whole or null.
void thin(Json& json, const Kept& kept) {
  if (json.is_string() && json.get_ref<const std::string&>().size() > kept.letters) {
    json = cut(json.get_ref<const std::string&>(), kept.letters);
  }
  if (json.is_array()) {
    if (json.size() > kept.entries) json.erase(json.begin() + static_cast<std::ptrdiff_t>(kept.entries), json.end());
    for (Json& item : json) thin(item, kept);
  }
  if (!json.is_object()) return;
  for (auto& [key, value] : json.items()) {
    if (key == "svg") {
      if (!kept.drawings) value = nullptr;
    } else if (key != "pictures") {
      thin(value, kept);
    } else if (value.size() > kept.pictures) {
      value.erase(value.begin() + static_cast<std::ptrdiff_t>(kept.pictures), value.end());
    }
  }
}

/// As text within a script element: no "<" can end it, and no bytes are left that are not UTF-8.
std::string script_text(const Json& json) {
  const std::string plain = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(plain.size());
  for (const char letter : plain) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

}  // namespace

void add_html_option(CLI::App& app, HtmlOption& option) {
  option.app = &app;
  app.add_option("--html", option.path, "write a page for people: FILE.html, or a folder that gets index.html")
      ->type_name("PATH");
}

void require_viewer(const HtmlOption& option, std::string_view page) {
  if (option.wanted() && page.empty()) {
    throw UsageError("--html: this program was built without the viewer; ./x web builds it and the program with it");
  }
}

std::string html_page(std::string_view viewer, Json report, std::size_t most_bytes) {
  const std::size_t place = viewer.find(viewer_mark);
  if (place == std::string_view::npos) throw Error("the viewer has no place for a report");
  const Json whole = report;
  std::string data = script_text(report);
  for (const Kept& kept : levels) {
    if (viewer.size() + data.size() <= most_bytes) break;
    report = whole;
    for (Json& section : report["sections"]) thin(section, kept);
    report["notes"].push_back(fmt::format(
        "To keep this page below {} MiB, texts end after {} characters, lists after {} entries and there are "
        "at most {} pictures in a section. --json writes everything.",
        most_bytes >> 20, kept.letters, kept.entries, kept.pictures));
    data = script_text(report);
  }
  std::string page(viewer.substr(0, place));
  page += data;
  return page += viewer.substr(place + viewer_mark.size());
}

std::string page_file(const std::string& path) {
  const std::filesystem::path name(path);
  return name.extension() == ".html" ? path : (name / "index.html").string();
}

void write_html(const HtmlOption& option, const std::string& title, const Json& sections) {
  if (!option.wanted()) return;
  require_viewer(option);
  const std::string file = page_file(option.path);
  if (file != option.path) {
    std::error_code error;
    std::filesystem::create_directories(option.path, error);
    if (error) throw FileError(option.path, "cannot make this folder: " + error.message());
  }
  const Json report{{"torse", 1},
                    {"type", "report"},
                    {"version", version},
                    {"title", title},
                    {"command", printable(command_line(words_of(*option.app)))},
                    {"sections", sections},
                    {"notes", Json::array()}};
  write_file(file, html_page(viewer(), report));
}

}  // namespace torse::cli
