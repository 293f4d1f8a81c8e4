// The summary, the CSV rows and the page's section of a study, from records written by hand.
#include "torse/cli/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

studies::Task task() {
  studies::Task task;
  task.design = studies::read_design("d.json", R"({"torse": 1, "type": "study", "name": "d", "title": "by hand, twice",
    "kind": "routes", "routes": ["FJ07.13.rulings"], "scalars": ["float", "double"], "factors": {"pieces": [1, 4]},
    "repetitions": {"quick": 1, "standard": 1, "deep": 1}, "seed": 1})");
  return task;
}

Json result(const char* scalar, double units, double bound) {
  return {
      {"route", "FJ07.13.rulings"}, {"scalar", scalar}, {"finite", true},      {"ulps", 2 * units}, {"units", units},
      {"conditioned", 0.5},         {"condition", 3},   {"backward", nullptr}, {"warp_deg", 1e-9},  {"bound", bound}};
}

std::string record(int number, int pieces, const std::vector<Json>& results) {
  Json factors = Json::object();
  const studies::Levels levels;
  for (std::size_t i = 0; i < studies::factor_names.size(); ++i) {
    factors[std::string(studies::factor_names[i])] = levels[static_cast<studies::Factor>(i)];
  }
  factors["pieces"] = pieces;
  return Json{{"torse", 1},
              {"study", "d"},
              {"case", number},
              {"repetition", 0},
              {"factors", factors},
              {"input", {{"a", "b,\"c\""}}},
              {"more", Json::object()},
              {"results", results}}
      .dump();
}

std::vector<std::string> records() {
  const Json failed{{"route", "FJ07.13.rulings"}, {"scalar", "float"}, {"finite", false}};
  return {record(0, 1, {result("float", 3, 0.5), result("double", 1, 0.25)}),
          record(1, 4, {result("float", 5, 1.5), result("double", 7, 0.75)}), record(2, 4, {failed})};
}

TEST(StudyReport, SummaryByHand) {
  const StudySummary summary = summary_of(task(), records());
  const RouteSummary& low = summary.routes.at({"FJ07.13.rulings", "float"});
  EXPECT_EQ(low.units.median(), 3);
  EXPECT_EQ(low.units.most(), 5);
  EXPECT_EQ(low.ulps.most(), 10);
  EXPECT_EQ(low.failed, 1U);
  EXPECT_TRUE(low.backward.values.empty());
  EXPECT_EQ(summary.above_bound, 1U);
  const auto& level = summary.levels.at({"FJ07.13.rulings", "double", studies::Factor::pieces, 4.0});
  EXPECT_EQ(level.median(), 7);
}

TEST(StudyReport, NothingIsNoNumberToo) {
  EXPECT_EQ(Spread().median(), 0);
  EXPECT_EQ(Spread().most(), 0);
  EXPECT_EQ((Spread{{4, 1, 3, 2}}).median(), 2);
  EXPECT_EQ(TestSummary().false_yes + TestSummary().false_no + TestSummary().cases, 0U);
}

TEST(StudyReport, RowsQuoteWhatNeedsIt) {
  studies::Task part = task();
  const std::string rows = study_csv(part, records());
  EXPECT_EQ(std::ranges::count(rows, '\n'), 6);
  EXPECT_TRUE(rows.starts_with("study,case,repetition,degree,pieces,"));
  EXPECT_NE(rows.find(R"("{""a"":""b,\""c\""""}")"), std::string::npos) << rows;
  part.shard = 1;
  part.shards = 2;
  EXPECT_EQ(std::ranges::count(study_csv(part, records()), '\n'), 5);  // no header
}

/// A row of the failed case alone: the factors, the route, what is not there, the input, more.
TEST(StudyReport, EveryFieldOfARow) {
  std::string names;
  std::string values;
  const studies::Levels levels;
  for (std::size_t i = 0; i < studies::factor_names.size(); ++i) {
    names += std::string(studies::factor_names[i]) + ",";
    const double level = studies::factor_names[i] == "pieces" ? 4 : levels[static_cast<studies::Factor>(i)];
    values += (studies::factor_names[i] == "pieces" ? "4" : Json(level).dump()) + ",";
  }
  EXPECT_EQ(study_csv(task(), {records()[2]}),
            "study,case,repetition," + names +
                "route,scalar,finite,ulps,units,conditioned,condition,backward,warp_deg,bound,input,more\nd,2,0," +
                values + "FJ07.13.rulings,float,false,,,,,,,,\"{\"\"a\"\":\"\"b,\\\"\"c\\\"\"\"\"}\",{}\n");
  studies::Task verdicts = task();
  verdicts.design.verdicts = true;
  Json line = Json::parse(record(5, 4, {}));
  line["developable"] = true;
  line["results"] = Json::array({{{"test", "double, 0"}, {"says_developable", false}, {"wrong", true}}});
  line["input"] = "x";
  EXPECT_EQ(study_csv(verdicts, {line.dump()}), "study,case,repetition," + names +
                                                    "developable,test,says_developable,wrong,input\nd,5,0," + values +
                                                    "true,\"double, 0\",false,true,x\n");
}

TEST(StudyReport, ThePageHasTheSameNumbers) {
  const Json section = study_section(task(), summary_of(task(), records()));
  EXPECT_EQ(section["kind"], "plots");
  const Json& rows = section["tables"][0]["rows"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0], Json::parse(R"(["FJ07.13.rulings", "float", 6.0, 10.0, 3.0, 5.0, 0.5, 0.5, null, 1e-9, 1.5, 1])"));
  EXPECT_EQ(rows[0].size(), section["tables"][0]["columns"].size());
  ASSERT_EQ(section["plots"].size(), 1U);
  EXPECT_EQ(section["plots"][0]["series"][1]["points"], Json::parse("[[1.0, 1.0], [4.0, 7.0]]"));
}

TEST(StudyReport, TheDrawingIsXml) {
  const std::string svg = study_svg(task(), summary_of(task(), records()));
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_NE(svg.find("FJ07.13.rulings, double"), std::string::npos);
  EXPECT_EQ(svg.find("FJ07.13.rulings, float"), std::string::npos);  // one arithmetic, to be read
  double width = 0;
  double height = 0;
  double right = 0;
  double bottom = 0;
  ASSERT_EQ(
      std::sscanf(svg.c_str(),
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%lf\" height=\"%lf\" viewBox=\"0 0 %lf %lf\">",
                  &width, &height, &right, &bottom),
      4);
  EXPECT_EQ(width, right);
  EXPECT_EQ(height, bottom);
  // One plot and its margins; two factors have two plots, one below the other.
  studies::Task more = task();
  more.design.variations.push_back(more.design.variations.front());
  const std::string taller = study_svg(more, summary_of(more, records()));
  double twice = 0;
  ASSERT_EQ(std::sscanf(taller.c_str(), "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%lf\" height=\"%lf\"",
                        &right, &twice),
            2);
  EXPECT_EQ(right, width);
  // A plot of 520 by 320 with its margins of 70: 660 wide, 460 high, after 70
  EXPECT_EQ(height, 530);
  EXPECT_EQ(twice, 990);
}

/// What is printed, in a file instead of a terminal.
std::string printed(const studies::Task& task, const StudySummary& summary) {
  std::FILE* file = std::tmpfile();
  print_study(Terminal(file), task, summary);
  std::string text(static_cast<std::size_t>(std::ftell(file)), ' ');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  return text;
}

TEST(StudyReport, EveryLevelIsPrinted) {
  const std::string text = printed(task(), summary_of(task(), records()));
  EXPECT_NE(text.find("\nmedian error in u by pieces                  1         4\n"
                      "FJ07.13.rulings            float               3         5\n"
                      "FJ07.13.rulings            double              1         7\n"),
            std::string::npos)
      << text;
  const std::string part = printed(task(), summary_of(task(), {records()[0]}));
  EXPECT_NE(part.find("FJ07.13.rulings            float               3         -\n"), std::string::npos) << part;
  studies::Task fixed = task();
  fixed.design.variations[0].levels = {4};
  EXPECT_EQ(printed(fixed, summary_of(fixed, records())).find("median error"), std::string::npos);
}

TEST(StudyReport, FailedCasesArePrinted) {
  const std::string text = printed(task(), summary_of(task(), records()));
  EXPECT_NE(text.find("1.5  1 not finite\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("0 not finite"), std::string::npos) << text;
  EXPECT_NE(text.find("1 errors exceed the proved bound\n"), std::string::npos) << text;
}

/// Verdicts of a naive test on five nets.
TEST(StudyReport, WrongVerdictsByHand) {
  studies::Task verdicts = task();
  verdicts.design.verdicts = true;
  verdicts.design.subjects = {"double, 0"};
  std::vector<std::string> lines;
  const auto add = [&](int pieces, bool developable, bool wrong) {
    Json line = Json::parse(record(static_cast<int>(lines.size()), pieces, {}));
    line["developable"] = developable;
    line["results"] =
        Json::array({{{"test", "double, 0"}, {"says_developable", developable != wrong}, {"wrong", wrong}}});
    lines.push_back(line.dump());
  };
  add(1, true, true);
  add(1, true, false);
  add(4, true, true);
  add(4, false, true);
  add(4, false, false);
  const StudySummary summary = summary_of(verdicts, lines);
  const TestSummary& test = summary.tests.at("double, 0");
  EXPECT_EQ(test.cases, 5U);
  EXPECT_EQ(test.false_no, 2U);
  EXPECT_EQ(test.false_yes, 1U);
  const TestSummary& level = summary.test_levels.at({"double, 0", studies::Factor::pieces, 4.0});
  EXPECT_EQ(level.cases, 3U);
  EXPECT_EQ(level.false_no, 1U);
  EXPECT_EQ(level.false_yes, 1U);
  EXPECT_NE(printed(verdicts, summary).find("double, 0                          1/2       2/3\n"), std::string::npos)
      << printed(verdicts, summary);
  const Json plot = study_section(verdicts, summary)["plots"][0];
  EXPECT_EQ(plot["series"], Json::parse(R"([{"name": "double, 0", "points": [[1, 50.0], [4, 66.66666666666667]]}])"));
  EXPECT_EQ(plot["title"], "Wrong verdicts by pieces");
  lines.resize(2);  // nothing is known of 4 pieces
  EXPECT_EQ(study_section(verdicts, summary_of(verdicts, lines))["plots"][0]["series"][0]["points"],
            Json::parse("[[1, 50.0]]"));
}

}  // namespace
}  // namespace torse::cli
