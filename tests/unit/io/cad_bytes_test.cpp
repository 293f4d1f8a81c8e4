// A model survives the way through bytes, and damaged bytes are an error.
#include "torse/io/cad_bytes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "torse/scalar/errors.hpp"

namespace torse {
namespace {

CadModel sample() {
  const CadRail rail{2, {0, 0, 0, 1, 1, 1}, {{0, 0, 0}, {1, 0.1, 0}, {1, 1, 0}}, {1, 0.5, 1}};
  const CadRail line{1, {-1, -1, 3, 3}, {{0, 0, 1}, {1e300, 5e-324, 1}}, {1, 1}, CadRange{0, 2}, true};
  CadFace face{.number = 7, .name = "plate \xC3\xA9", .type = "ruled surface", .claimed_developable = false};
  face.strips.push_back({CadRails{rail, line}, CadRange{0.25, 0.75}, std::nullopt});
  face.strips.push_back({CadExtrusion{rail, {0, 0, -2}, CadPoint{4, 5, 6}}, std::nullopt, CadRange{-1, 4}});
  face.strips.push_back({CadRevolution{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, {{{{1, 1, 1}, 2, 3}, {{}, 4, 5}}}, {0, 6.25}},
                         std::nullopt, std::nullopt});
  face.placement[1][3] = -0.5;
  return {"inch", 0.0254, 1e-5, {face, {.number = 8, .type = "sphere", .reason = "not ruled", .trimmed = true}}};
}

TEST(CadBytes, AModelComesBack) {
  const std::string bytes = cad_bytes(sample());
  const CadModel model = cad_model(bytes);
  EXPECT_EQ(cad_bytes(model), bytes);
  EXPECT_EQ(model.unit, "inch");
  ASSERT_EQ(model.faces.size(), 2U);
  const CadFace& face = model.faces.front();
  EXPECT_EQ(face.name, "plate \xC3\xA9");
  EXPECT_EQ(face.claimed_developable, false);
  ASSERT_EQ(face.strips.size(), 3U);
  const CadRails& rails = std::get<CadRails>(face.strips[0].surface);
  EXPECT_EQ(rails.d.points[1], (CadPoint{1e300, 5e-324, 1}));
  EXPECT_EQ(rails.d.part->to, 2);
  EXPECT_TRUE(rails.d.reversed);
  EXPECT_FALSE(rails.c.part || rails.c.reversed);
  EXPECT_EQ(rails.c.weights, (std::vector<double>{1, 0.5, 1}));
  EXPECT_EQ(face.strips[0].along->to, 0.75);
  EXPECT_FALSE(face.strips[0].across);
  EXPECT_EQ(std::get<CadExtrusion>(face.strips[1].surface).vector[2], -2);
  EXPECT_EQ(std::get<CadExtrusion>(face.strips[1].surface).end, (CadPoint{4, 5, 6}));
  EXPECT_EQ(face.strips[1].across->from, -1);
  EXPECT_EQ(std::get<CadRevolution>(face.strips[2].surface).meridian[1].height, 5);
  EXPECT_EQ(face.placement[1][3], -0.5);
  EXPECT_TRUE(model.faces.back().trimmed);
  EXPECT_EQ(model.faces.back().reason, "not ruled");
}

TEST(CadBytes, CurvesComeBack) {
  const CadRail rail{2, {0, 0, 0, 1, 1, 1}, {{0, 0, 0}, {1, 0.1, 0}, {1, 1, 0}}, {1, 0.5, 1}, CadRange{0, 0.5}};
  CadCurve curve{.number = 1, .name = "chine", .rail = rail};
  curve.placement[2][3] = 4;
  const CadCurves curves{"m", 1, 1e-6, {curve, {.number = 2, .reason = "it has no curve in space"}}};
  const CadCurves back = cad_curves(cad_bytes(curves));
  EXPECT_EQ(cad_bytes(back), cad_bytes(curves));
  EXPECT_EQ(back.metres, 1);
  ASSERT_EQ(back.curves.size(), 2U);
  EXPECT_EQ(back.curves[0].name, "chine");
  EXPECT_EQ(back.curves[0].rail->part->to, 0.5);
  EXPECT_EQ(back.curves[0].placement[2][3], 4);
  EXPECT_FALSE(back.curves[1].rail);
  EXPECT_EQ(back.curves[1].reason, "it has no curve in space");
  EXPECT_THROW(cad_curves(cad_bytes(sample())), Error);
}

TEST(CadBytes, EveryPrefixIsAnError) {
  const std::string bytes = cad_bytes(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(cad_model(std::string_view(bytes).substr(0, size)), Error) << size;
  }
  EXPECT_THROW(cad_model(bytes + '\0'), Error);
}

/// A bool is 0 or 1 and a variant one of its alternatives: whatever is read is what was there.
TEST(CadBytes, AChangedByteIsAnErrorOrAnotherModel) {
  const std::string bytes = cad_bytes(sample());
  int errors = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (char value : {'\x02', '\x03', '\xff'}) {
      std::string changed = bytes;
      changed[i] = value;
      try {
        EXPECT_EQ(cad_bytes(cad_model(changed)), changed) << i;
      } catch (const Error&) {
        ++errors;
      }
    }
  }
  EXPECT_GT(errors, 100);
}

TEST(CadBytes, APromiseOfManyFacesTakesNoMemory) {
  std::string bytes = cad_bytes(CadModel{});
  bytes.resize(bytes.size() - sizeof(std::size_t));
  const std::size_t size = std::size_t{1} << 26;
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(size, '\xff');
  EXPECT_THROW(cad_model(bytes), Error);
}

}  // namespace
}  // namespace torse
