// What tests of IGES files share.
//   IgesFiles       one file in a folder of its own, and its faces
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cad/iges_text.hpp"
#include "support/program.hpp"
#include "torse/cli/faces.hpp"

namespace torse::testing {

class IgesFiles : public ::testing::Test {
 public:
  /// Writes the file anew.
  std::string file(const IgesText& iges) const {
    spill(scratch / "part.igs", iges.file());
    return (scratch / "part.igs").string();
  }
  std::vector<cli::Face> faces(const IgesText& iges) const { return cli::read_faces(file(iges), ""); }
  Scratch scratch;
};

}  // namespace torse::testing
