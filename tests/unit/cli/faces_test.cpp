// Which words choose a face among those of its file.
#include "torse/cli/faces.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace torse::cli {
namespace {

struct Named {
  std::string name;
  std::size_t number;
  std::size_t strip = 0;
};

std::vector<Face> faces_of(const std::vector<Named>& list) {
  std::vector<Face> faces;
  for (const Named& each : list)
    faces.push_back({.file = "part.step", .name = each.name, .number = each.number, .strip = each.strip});
  set_choices(faces);
  return faces;
}

/// The choices, each of which gives its own face and no other.
std::vector<std::string> choices_of(const std::vector<Named>& list) {
  const std::vector<Face> faces = faces_of(list);
  std::vector<std::string> choices;
  for (const Face& face : faces) {
    EXPECT_EQ(face.of, list.size());
    choices.push_back(face.choice);
    if (face.choice.empty()) continue;
    const std::vector<Face> found = chosen(faces, face.choice);
    EXPECT_EQ(found.size(), 1U) << face.choice;
    for (const Face& other : found) {
      EXPECT_EQ(other.name, face.name);
      EXPECT_EQ(other.number, face.number);
      EXPECT_EQ(other.strip, face.strip);
    }
  }
  return choices;
}

using Choices = std::vector<std::string>;

TEST(Faces, AreChosenByNumberUnlessItIsTheNameOfAnother) {
  EXPECT_EQ(choices_of({{"port", 1}, {"stern", 2}}), (Choices{"1", "2"}));
  EXPECT_EQ(choices_of({{"NONE", 1}, {"NONE", 2}}), (Choices{"1", "2"}));
  EXPECT_EQ(choices_of({{"2", 1}, {"x", 2}}), (Choices{"1", "x"}));
  EXPECT_EQ(choices_of({{"2", 1}, {"1", 2}}), (Choices{"2", "1"}));
}

TEST(Faces, StripsOfOneFaceAreChosenByTheirNames) {
  EXPECT_EQ(choices_of({{"hull strip 1", 1}, {"hull strip 2", 1}, {"lid", 2}}),
            (Choices{"hull strip 1", "hull strip 2", "2"}));
}

TEST(Faces, StripsOfFacesOfOneNameAreChosenByBothNumbers) {
  EXPECT_EQ(choices_of({{"a strip 1", 1, 1}, {"a strip 2", 1, 2}, {"a strip 1", 2, 1}, {"a strip 2", 2, 2}}),
            (Choices{"1 strip 1", "1 strip 2", "2 strip 1", "2 strip 2"}));
  EXPECT_EQ(choices_of({{"a strip 1", 1, 1}, {"a strip 2", 1, 2}, {"a strip 1", 2, 1}, {"1 strip 1", 3}}),
            (Choices{"", "a strip 2", "2 strip 1", "3"}));
  EXPECT_EQ(chosen(faces_of({{"a strip 1", 1, 1}, {"a strip 2", 1, 2}, {"b", 2}}), "1").size(), 2U);
}

TEST(Faces, ThatNothingTellsFromOthersAreShownWithThem) {
  EXPECT_EQ(choices_of({{"2", 1}, {"2", 2}}), (Choices{"1", ""}));
  EXPECT_EQ(choices_of({{"a strip 1", 1}, {"a strip 1", 1}}), (Choices{"", ""}));
  EXPECT_EQ(choices_of({{"alone", 1}}), (Choices{""}));
}

TEST(Faces, TheirWordsAndTitlesNameThem) {
  const std::vector<Face> strips = faces_of({{"hull strip 1", 1}, {"hull strip 2", 1}});
  EXPECT_EQ(title_of(strips[1]), "part.step: hull strip 2");
  EXPECT_EQ(words_of(strips[1]), (Choices{"--face", "hull strip 2", "part.step"}));
  const std::vector<Face> alone = faces_of({{"hull", 1}});
  EXPECT_EQ(title_of(alone[0]), "part.step");
  EXPECT_EQ(words_of(alone[0]), (Choices{"part.step"}));
}

TEST(Faces, WhatBeginsWithADashIsNoOption) {
  EXPECT_EQ(words_of("-net.json", ""), (Choices{"./-net.json"}));
  EXPECT_EQ(words_of("-", ""), (Choices{"-"}));
  EXPECT_EQ(words_of(faces_of({{"-lid", 1}, {"1", 2}})[0]), (Choices{"--face", "-lid", "part.step"}));
}

}  // namespace
}  // namespace torse::cli
