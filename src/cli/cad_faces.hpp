// The faces of STEP and IGES files.
//   cad_format      which of the two a file is, by its content
//   faces_of        the faces of a model as exact surfaces, a strip each
//   cad_faces       those of a file
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

/// A face with several strips becomes several, "NAME strip 1", ..., of one number. Throws FileError naming `file` for
/// more than 100000 in all and for a strip that is no surface.
std::vector<Face> faces_of(const std::string& file, const CadModel& model);

/// Throws FileError for a file that cannot be read, and like faces_of.
std::vector<Face> cad_faces(const std::string& file, CadFormat format, const std::string& bytes);

}  // namespace torse::cli
