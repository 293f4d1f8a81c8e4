// The ruled surfaces of an input file, a face each.
//   CadNote                       what else a CAD file says of a face
//   Face                          a surface with its name, or why it is none
//   FaceInput, add_face_inputs    the files and the option --face of a subcommand
//   read_faces                    the faces of a file that were asked for      set_choices, chosen    how
//   name_of_file, title_of, extension_of   what they are called       words_of    for a command that shows one again
#pragma once

#include <CLI/App.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// Of a face of a CAD file. Lengths are in the file's unit, `metres` long.
struct CadNote {
  std::string unit;
  double metres{};
  /// 0 where the file states none.
  double tolerance{};
  /// "plane", "cylinder", "B-spline surface", ...
  std::string type;
  /// Whether the face has a smaller range of parameters than its surface; then `surface` is that part.
  bool trimmed = false;
  /// The developable flag of an IGES ruled surface.
  std::optional<bool> claimed_developable{};
};

/// A face of a file. torse's JSON holds one; a CAD file holds any number.
struct Face {
  std::string file;
  /// Printable: the file's stem, or the name that the face has in its CAD file.
  std::string name;
  /// In the file's order, from 1. The strips of a face of a CAD file have the same.
  std::size_t number = 1;
  /// Of a face of several strips, which one, from 1; else 0.
  std::size_t strip = 0;
  /// How many the file has, every strip counted.
  std::size_t of = 1;
  /// What --face takes to choose this one alone; empty where it is the only one, or no name or number tells it from the
  /// others.
  std::string choice{};
  /// None for a face that is not ruled; then `remark` says why.
  std::optional<RuledFile<Rational>> surface{};
  std::string remark{};
  std::optional<CadNote> cad{};
};

/// What a subcommand takes: files, "-" being standard input, and a face by name or number, empty for all.
struct FaceInput {
  std::vector<std::string> files;
  std::string face;
};

/// Adds FILE... and --face to a subcommand. `what` describes the files in its help.
void add_face_inputs(CLI::App& app, FaceInput& input, const std::string& what);

/// The name of a file without folder and extension, printable.
std::string name_of_file(const std::string& file);

/// The extension of a file's name with its dot, in small letters.
std::string extension_of(const std::string& file);

/// What a person reads before a verdict: the file, with the face's name where it has others.
std::string title_of(const Face& face);

/// The words that name a file and the choice of a face in it on the command line, the file last.
std::vector<std::string> words_of(const std::string& file, const std::string& choice);

/// The words that name a face.
std::vector<std::string> words_of(const Face& face);

/// Sets how many the faces of a file are and what chooses each.
void set_choices(std::vector<Face>& faces);

/// Those of the faces that `choice` names, else those that it numbers: "3", or "3 strip 2" for one of several strips.
std::vector<Face> chosen(const std::vector<Face>& faces, const std::string& choice);

/// The faces of `file`, or those that `choice` names or numbers. Throws FileError, also where there is none such.
std::vector<Face> read_faces(const std::string& file, const std::string& choice);

}  // namespace torse::cli
