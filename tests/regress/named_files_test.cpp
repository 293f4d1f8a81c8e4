// No file is written twice by one run, or over what the run reads: told before anything is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "support/program.hpp"

namespace torse::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string cylinder = R"({"torse": 1, "type": "ruled", "degree": 2,
 "c": {"points": [[0,0,0],[10,"20/3",0],[30,0,0]]}, "d": {"points": [[0,0,5],[10,"20/3",5],[30,0,5]]}})";
const std::string rails = R"({"torse": 1, "type": "rails", "c": {"degree": 1, "points": [[0,0,0],[1,0,0]]},
 "d": {"degree": 1, "points": [[0,0,1],[1,0,1]]}})";
const std::string curve = R"({"torse": 1, "type": "construct", "method": "bezier", "degree": 2, "Lambda": "3", "M": "2",
 "c": {"points": [[0,0,0],[1,1,0],[2,0,1]]}, "d0": [0,0,1]})";

class NamedFiles : public ::testing::Test {
 protected:
  NamedFiles() {
    spill(scratch_ / "in.json", cylinder);
    spill(scratch_ / "rails.json", rails);
    spill(scratch_ / "curve.json", curve);
    fs::create_directory(scratch_ / "folder");
    fs::create_directory_symlink(scratch_ / "folder", scratch_ / "way");
    fs::create_symlink(scratch_ / "in.json", scratch_ / "link.json");
  }
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  std::set<std::string> names() const {
    std::set<std::string> list;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path())) list.insert(entry.path().string());
    return list;
  }
  /// Words that begin with @ are names in the scratch folder.
  ProgramResult run(std::vector<std::string> words) const {
    for (std::string& word : words) {
      if (word.starts_with('@')) word = scratch_.path().string() + "/" + word.substr(1);
    }
    return run_program(words);
  }
  /// The run is refused with this message and leaves no trace.
  void expect_refused(const std::vector<std::string>& words, const std::string& message) const {
    SCOPED_TRACE(::testing::PrintToString(words));
    const std::set<std::string> before = names();
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit, 2) << result.out;
    EXPECT_THAT(result.err, HasSubstr("torse: error: "));
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(names(), before);
    EXPECT_EQ(slurp(scratch_ / "in.json"), cylinder);
    EXPECT_EQ(slurp(scratch_ / "rails.json"), rails);
    EXPECT_EQ(slurp(scratch_ / "curve.json"), curve);
  }

  Scratch scratch_;
};

TEST_F(NamedFiles, AreNotWrittenTwice) {
  expect_refused({"check", "@in.json", "--json", "@x", "--junit", "@x"},
                 "--json and --junit: expected different files, found \"" + file("x") + "\" and \"" + file("x") + '"');
  expect_refused({"check", "@in.json", "--json", "@x", "--sarif", "@./folder/../x"}, "--json and --sarif: ");
  expect_refused({"check", "@in.json", "--json", "@folder/x", "--sarif", "@way/x"}, "--json and --sarif: ");
  expect_refused({"check", "@in.json", "--repair", "@x.json", "--json", "@x.json"}, "--repair and --json: ");
  expect_refused({"check", "@in.json", "--html", "@page", "--json", "@page/index.html"}, "--json and --html: ");
  expect_refused({"check", "@in.json", "--html", "@x.html", "--json", "@x.html"}, "--json and --html: ");
  expect_refused({"convert", "@in.json", "-o", "@q.obj", "--json", "@q.obj"}, "--output and --json: ");
  expect_refused({"unroll", "@in.json", "-o", "@x.svg", "-o", "@x.svg"}, "--output: expected different files");
  expect_refused({"fit", "@rails.json", "-o", "@x.json", "--json", "@x.json"}, "--output and --json: ");
  expect_refused({"fit", "@rails.json", "-o", "@x.json", "--svg", "@y.svg", "--unroll", "@y.svg"},
                 "--svg and --unroll");
  expect_refused({"study", "gap", "--json", "@x", "--csv", "@x"}, "--json and --csv: ");
  expect_refused({"verify", "--claim", "FJ07.5", "--json", "@x", "--ledger", "@x"}, "--ledger and --json: ");
  expect_refused({"campaign", "run", "--db", "@x", "--json", "@x"}, "--db and --json: ");
}

TEST_F(NamedFiles, AreNotWrittenOverWhatIsRead) {
  expect_refused({"check", "@in.json", "--json", "@in.json"},
                 "FILE and --json: expected different files, found \"" + file("in.json"));
  expect_refused({"check", "@in.json", "--repair", "@link.json"}, "FILE and --repair: ");
  expect_refused({"check", "@link.json", "--junit", "@in.json"}, "FILE and --junit: ");
  expect_refused({"check", "@rails.json", "@in.json", "--sarif", "@in.json"}, "FILE and --sarif: ");
  expect_refused({"convert", "@in.json", "-o", "@in.json"}, "FILE and --output: ");
  expect_refused({"construct", "bezier", "@curve.json", "-o", "@curve.json"}, "INPUT and --output: ");
  expect_refused({"fit", "@rails.json", "-o", "@rails.json"}, "RAILS and --output: ");
  expect_refused({"unroll", "@in.json", "-o", "@in.json"}, "FILE and --output: ");
  expect_refused({"recover", "@in.json", "--json", "@in.json"}, "FILE and --json: ");
  expect_refused({"study", "@in.json", "--csv", "@in.json"}, "name and --csv: ");
  expect_refused({"study", "autopsy", "@in.json", "--json", "@in.json"}, "file and --json: ");
  expect_refused({"verify", "--baseline", "@in.json", "--json", "@in.json"}, "--baseline and --json: ");
  expect_refused({"campaign", "show", "@in.json", "--json", "@in.json"}, "DB and --json: ");
  expect_refused({"campaign", "diff", "@rails.json", "@in.json", "--json", "@in.json"}, "B and --json: ");
}

/// What stands behind an output and its name is an input, wherever the options stand.
TEST_F(NamedFiles, BehindAnOutputAreInputs) {
  EXPECT_EQ(run({"fit", "-o", "@x.json", "@rails.json", "--max-warp", "1"}).exit, 0);
  EXPECT_EQ(run({"fit", "-o", "@y.json", "--unroll", "@y.svg", "@rails.json", "--json", "@report.json"}).exit, 0);
  EXPECT_EQ(run({"unroll", "-o", "@x.svg", "-o", "@x.dxf", "@in.json", "--rulings", "3"}).exit, 0);
  for (const char* name : {"x.json", "y.json", "y.svg", "report.json", "x.svg", "x.dxf"}) {
    EXPECT_TRUE(fs::exists(scratch_ / name)) << name;
  }
  expect_refused({"fit", "@rails.json", "-o", "@a.json", "@in.json"}, "unexpected word " + file("in.json"));
  expect_refused({"fit", "@rails.json", "-o", "@a.json", "--unroll", "@a.svg", "@in.json"}, "unexpected word ");
  expect_refused({"unroll", "@in.json", "-o", "@a.svg", "@rails.json"}, "expected one FILE, found 2");
}

/// A study keeps what is done beside the first of its results and removes that at its end.
TEST_F(NamedFiles, AreNotWhereAStudyKeepsItsCases) {
  const std::string kept = ": expected another file than \"" + file("a.part") + '"';
  expect_refused({"study", "gap", "--json", "@a", "--csv", "@a.part"}, "--csv" + kept);
  expect_refused({"study", "gap", "--json", "@a", "--svg", "@./a.part"}, "--svg" + kept);
  EXPECT_EQ(run({"study", "gap", "--effort", "quick", "--json", "@a", "--csv", "@b.part"}).exit, 0);
  EXPECT_TRUE(fs::exists(scratch_ / "b.part"));
  EXPECT_FALSE(fs::exists(scratch_ / "a.part"));
}

/// "[a,b]" is one file, not the list of a and b.
TEST_F(NamedFiles, MayHaveBrackets) {
  const fs::path before = fs::current_path();
  fs::current_path(scratch_.path());
  spill("[in.json,rails.json]", cylinder);
  const ProgramResult one = run({"check", "[in.json,rails.json]"});
  const ProgramResult two = run({"check", "in.json", "[in.json,rails.json]"});
  fs::current_path(before);
  EXPECT_EQ(one.exit, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("[in.json,rails.json]  developable"));
  EXPECT_THAT(two.out, HasSubstr("2 of 2 developable"));
}

TEST_F(NamedFiles, OnlyOneIsStandardOutput) {
  expect_refused({"check", "@in.json", "--json", "-", "--sarif", "-"},
                 "only one of --json and --sarif can write to standard output");
  expect_refused({"check", "@in.json", "--repair", "-", "--json", "-"}, "standard output");
  expect_refused({"verify", "--junit", "-", "--json", "-"}, "standard output");
  expect_refused({"fit", "@rails.json", "-o", "-", "--json", "-"}, "standard output");
  expect_refused({"unroll", "@in.json", "-o", "-", "-o", "-"}, "--output: only one can be standard output");
  expect_refused({"study", "gap", "--csv", "-", "--json", "-"}, "standard output");
  expect_refused({"campaign", "run", "--db", "@x", "--junit", "-", "--json", "-"}, "standard output");
}

/// Surfaces in torse's JSON do not get a name under which another program, or torse itself, would read something else.
TEST_F(NamedFiles, AreNotThoseOfAnotherFormat) {
  for (const char* name :
       {"@x.step", "@x.STP", "@x.igs", "@x.obj", "@x.stl", "@x.glb", "@x.svg", "@x.dxf", "@x.html"}) {
    expect_refused({"check", "@in.json", "--repair", name}, "--repair: expected a name for torse's JSON, found \"");
    expect_refused({"construct", "bezier", "@curve.json", "-o", name}, "--output: expected a name for torse's JSON");
  }
  for (const char* name : {"@x.json", "@x", "@x.txt", "@x.step.json"}) {
    EXPECT_EQ(run({"check", "@in.json", "--repair", name}).exit, 0);
    EXPECT_EQ(run({"construct", "bezier", "@curve.json", "-o", name}).exit, 0);
  }
}

/// Nor do reports, tables and pictures.
TEST_F(NamedFiles, AreNotThoseOfAnotherFormatForReports) {
  for (const char* name : {"@x.step", "@x.IGS", "@x.html", "@x.svg", "@x.csv", "@x.xml", "@x.sarif"}) {
    expect_refused({"check", "@in.json", "--json", name}, "--json: expected a name for JSON, found \"");
    expect_refused({"verify", "--claim", "FJ07.5", "--ledger", name}, "--ledger: expected a name for JSON");
    expect_refused({"campaign", "run", "--db", "@x", "--json", name}, "--json: expected a name for JSON");
  }
  for (const char* name : {"@x.stp", "@x.json", "@x.sarif"}) {
    expect_refused({"check", "@in.json", "--junit", name}, "--junit: expected a name for JUnit's XML, found \"");
    expect_refused({"study", "gap", "--csv", name}, "--csv: expected a name for CSV");
    expect_refused({"study", "gap", "--svg", name}, "--svg: expected a name for SVG");
    expect_refused({"fit", "@rails.json", "-o", "@y.obj", "--svg", name}, "--svg: expected a name for SVG");
  }
  expect_refused({"check", "@in.json", "--sarif", "@x.xml"}, "--sarif: expected a name for SARIF, found \"");
  for (const char* sarif : {"@x.sarif", "@x.sarif.json", "@x", "@x.txt"}) {
    EXPECT_EQ(run({"check", "@in.json", "--json", "@a.JSON", "--junit", "@a.xml", "--sarif", sarif}).exit, 0) << sarif;
  }
}

/// Devices keep nothing; what is called like a file elsewhere is another one; a word that is no file is none.
TEST_F(NamedFiles, MayBeDevicesAndFilesOfTheSameNameElsewhere) {
  EXPECT_EQ(run({"check", "@in.json", "--json", "/dev/null", "--junit", "/dev/null"}).exit, 0);
  EXPECT_EQ(run({"check", "@in.json", "--json", "@x", "--junit", "@folder/x"}).exit, 0);
  EXPECT_EQ(run({"check", "@in.json", "@in.json"}).exit, 0);
  EXPECT_EQ(run({"convert", "@in.json", "-o", "@x.obj", "--json", "-"}).exit, 0);
  EXPECT_EQ(run({"convert", "@in.json", "-o", "@x.obj"}).exit, 0);
  spill(scratch_ / "bezier", "old");
  const fs::path before = fs::current_path();
  fs::current_path(scratch_.path());
  EXPECT_EQ(run({"construct", "bezier", "curve.json", "-o", "bezier"}).exit, 0);
  EXPECT_THAT(slurp(scratch_ / "bezier"), HasSubstr("ruled"));
  EXPECT_THAT(run({"check", "--face", "bezier", "@in.json", "--json", "bezier"}).err, HasSubstr("expected a face"));
  fs::current_path(before);
}

}  // namespace
}  // namespace torse::testing
