// Pages: the data come back from the page as they were, whatever is in them, and a page keeps its limit.
#include "torse/cli/html_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "torse/cli/command.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view small_viewer = "<body><script type=\"application/json\">@report@</script></body>";

/// What a browser takes as the text of the first script: all up to the first "</script", in any case.
std::string script_of(const std::string& page) {
  const std::size_t begin = page.find("json\">") + 6;
  std::string lower = page;
  for (char& letter : lower) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return page.substr(begin, lower.find("</script", begin) - begin);
}

Json report_of(Json sections) { return {{"torse", 1}, {"sections", std::move(sections)}, {"notes", Json::array()}}; }

TEST(HtmlPage, HoldsTheReport) {
  const Json report = report_of({{{"kind", "ledger"}, {"data", {1, 2.5, "x"}}}});
  const std::string page = html_page(small_viewer, report);
  EXPECT_EQ(Json::parse(script_of(page)), report);
  EXPECT_TRUE(page.starts_with("<body>"));
  EXPECT_TRUE(page.ends_with("</script></body>"));
}

TEST(HtmlPage, NoNameEndsTheScript) {
  for (const std::string name : {"</script><script>alert(1)</script>", "<!--<SCRIPT>", "</ScRiPt >", "@report@"}) {
    const Json report = report_of({{{"kind", "check"}, {"data", name}}});
    const std::string page = html_page(small_viewer, report);
    EXPECT_EQ(Json::parse(script_of(page))["sections"][0]["data"], name);
    EXPECT_EQ(script_of(page).find('<'), std::string::npos);
  }
}

TEST(HtmlPage, BytesThatAreNoTextAreReplaced) {
  const std::string page = html_page(small_viewer, report_of({{{"data", "a\xFF z"}}}));
  EXPECT_EQ(Json::parse(script_of(page))["sections"][0]["data"], "a\xEF\xBF\xBD z");
}

TEST(HtmlPage, KeepsItsLimitAndSaysSo) {
  Json list = Json::array();
  for (int i = 0; i < 3000; ++i) list.push_back(std::string(50, 'x'));
  Json pictures = Json::array();
  for (int i = 0; i < 50; ++i) pictures.push_back({{"c", std::string(900, 'y')}});
  const Json report = report_of({{{"data", list}, {"text", std::string(30000, 'z')}, {"pictures", pictures}}});
  for (const std::size_t limit : {200'000U, 100'000U, 20'000U, 6'000U}) {
    const std::string page = html_page(small_viewer, report, limit);
    EXPECT_LE(page.size(), limit);
    const Json kept = Json::parse(script_of(page));
    EXPECT_FALSE(kept["notes"].empty());
    for (const Json& picture : kept["sections"][0]["pictures"]) EXPECT_EQ(picture, pictures[0]);
  }
  EXPECT_TRUE(Json::parse(script_of(html_page(small_viewer, report)))["notes"].empty());
}

TEST(HtmlPage, ThinsListsWithinLists) {
  Json list = Json::array();
  for (int i = 0; i < 3; ++i) list.push_back({{"names", Json::array({std::string(60000, 'x')})}});
  const Json kept = Json::parse(script_of(html_page(small_viewer, report_of({{{"data", list}}}), 100'000)));
  for (const Json& entry : kept["sections"][0]["data"]) {
    EXPECT_EQ(entry["names"][0], std::string(20000, 'x') + "\xE2\x80\xA6");
  }
}

TEST(HtmlPage, CutsBetweenCharacters) {
  std::string text = "a";
  for (int i = 0; i < 20000; ++i) text += "é";
  const std::string page = html_page(small_viewer, report_of({{{"data", text}}}), 30000);
  const std::string kept = Json::parse(script_of(page))["sections"][0]["data"];
  EXPECT_TRUE(kept.ends_with("é…")) << kept.substr(kept.size() - 8);
}

TEST(HtmlPage, NeedsAPlaceForTheReport) { EXPECT_THROW(html_page("<body></body>", report_of({})), Error); }

TEST(Viewer, IsRequiredOnlyWhereAPageIsWanted) {
  EXPECT_THROW(require_viewer({.path = "page.html"}, ""), UsageError);
  EXPECT_NO_THROW(require_viewer({}, ""));
  EXPECT_NO_THROW(require_viewer({.path = "page.html"}, small_viewer));
}

TEST(Viewer, HasOnePlaceForTheReport) {
  if (viewer().empty()) GTEST_SKIP() << "built without the viewer";
  const std::size_t place = viewer().find(viewer_mark);
  ASSERT_NE(place, std::string_view::npos);
  EXPECT_EQ(viewer().find(viewer_mark, place + 1), std::string_view::npos);
}

}  // namespace
}  // namespace torse::cli
