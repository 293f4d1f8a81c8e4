// The option --html: a report as one page that needs no network.
//   HtmlOption           what the command line asks for
//   add_html_option      defines it          require_viewer     before the work begins
//   write_html           the page            page_file          its name
//   html_page            as text
#pragma once

#include <CLI/App.hpp>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "torse/cli/viewer.hpp"

namespace torse::cli {

/// Where the page goes; an empty path asks for none. The subcommand tells which command makes the page again.
struct HtmlOption {
  std::string path;
  const CLI::App* app = nullptr;

  bool wanted() const { return !path.empty(); }
};

/// Adds --html to a subcommand. Both must live until the page is written.
void add_html_option(CLI::App& app, HtmlOption& option);

/// Throws UsageError where a page is wanted and there is no viewer to put it into: the program was built without.
void require_viewer(const HtmlOption& option, std::string_view page = viewer());

/// Where the page of a path goes: that file where it ends in .html, otherwise index.html in that folder.
std::string page_file(const std::string& path);

/// Writes the page to its file if it is wanted; a folder is made. `sections` is an array of objects with "kind",
/// docs/report.md. Throws FileError.
void write_html(const HtmlOption& option, const std::string& title, const nlohmann::ordered_json& sections);

/// As large as a page may be, in bytes.
inline constexpr std::size_t most_html_bytes = std::size_t{5} << 20;

/// The viewer with the report in it. Where that exceeds `most_bytes`, long texts and lists are cut, pictures are left
/// out, and the report's "notes" say so.
std::string html_page(std::string_view viewer, nlohmann::ordered_json report, std::size_t most_bytes = most_html_bytes);

}  // namespace torse::cli
