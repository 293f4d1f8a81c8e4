// The faces of a model of STEP or IGES: one for each strip, and not too many.
#include "torse/cli/cad_faces.hpp"

#include <gtest/gtest.h>

#include <string>

#include "torse/io/document.hpp"

namespace torse::cli {
namespace {

/// A plate with so many strips between two lines, and spheres, which have none.
CadModel model_of(std::size_t strips, std::size_t spheres) {
  const auto line = [](double y) {
    return CadRail{.degree = 1, .knots = {0, 1}, .points = {{0, y, 0}, {1, y, 0}}, .weights = {1, 1}};
  };
  CadFace plate{.number = 1, .type = "plane"};
  for (std::size_t i = 0; i < strips; ++i) plate.strips.push_back({CadRails{line(0), line(1)}});
  CadModel model;
  model.faces.push_back(plate);
  for (std::size_t i = 0; i < spheres; ++i)
    model.faces.push_back({.number = static_cast<int>(i + 2), .type = "sphere"});
  return model;
}

std::string error_of(const CadModel& model) {
  try {
    faces_of("model", model);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(CadFaces, OneForEachStrip) {
  const std::vector<Face> faces = faces_of("model", model_of(2, 1));
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[0].name, "face 1 strip 1");
  EXPECT_EQ(faces[1].name, "face 1 strip 2");
  EXPECT_EQ(faces[0].strip, 1U);
  EXPECT_EQ(faces[1].strip, 2U);
  EXPECT_TRUE(faces[1].surface);
  EXPECT_EQ(faces[2].name, "face 2");
  EXPECT_EQ(faces[2].strip, 0U);
  EXPECT_FALSE(faces[2].surface);
}

TEST(CadFaces, AHundredThousandAtMost) {
  EXPECT_EQ(error_of(model_of(3, 99'997)), "");
  EXPECT_NE(error_of(model_of(4, 99'997)).find("expected at most 100000 surfaces, found 100001"), std::string::npos);
  EXPECT_NE(error_of(model_of(0, 100'000)).find("expected at most 100000 surfaces, found 100001"), std::string::npos);
}

/// A file of 80 columns has nothing but the number of the line behind the letter of its section.
TEST(CadFaces, JsonIsNoIgesWhateverStandsInColumn73) {
  const std::string json = R"({"torse":1, "type":"ruled", "degree":1, "c": {"points": [[0, 0, 0], ["0xB",)";
  for (const char letter : {'B', 'C', 'S'}) {
    std::string line = json;
    ASSERT_EQ(line[72], 'B');
    line[72] = letter;
    EXPECT_EQ(cad_format("a.json", line + "\n0, 0]]}"), std::nullopt) << letter;
  }
  const std::string start(72, ' ');
  EXPECT_EQ(cad_format("a", start + "S      1\n"), CadFormat::iges);
  EXPECT_EQ(cad_format("a", start + "S\r\n"), CadFormat::iges);
  EXPECT_THROW(cad_format("a", start + "B      1\n"), FileError);
}

}  // namespace
}  // namespace torse::cli
