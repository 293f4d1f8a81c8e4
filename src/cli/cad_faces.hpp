// The faces of STEP and IGES files.
//   cad_format      which of the two a file is, by its content
//   cad_faces       its faces as exact surfaces, a strip each
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/io/cad.hpp"

namespace torse::cli {

/// STEP begins with ISO-10303-21; IGES has an S in column 73 of its first line. None for other content. Throws
/// FileError for a compressed or binary IGES file, and for a file whose extension promises what its content does not
/// hold.
std::optional<CadFormat> cad_format(const std::string& file, std::string_view bytes);

/// A face with several strips becomes several, "NAME strip 1", ..., of one number. Throws FileError.
std::vector<Face> cad_faces(const std::string& file, CadFormat format, const std::string& bytes);

}  // namespace torse::cli
