// What torse check knows of a face, as a case of a report, as JSON and in words.
//   CheckedFace      verdict and warp of a face, or an error      check_faces, check_face    finding it out
//   outcome_of       whether it passes                            verdict_of, findings       in words
//   case_of          for JUnit and SARIF                          checked_json               for other programs
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/warp.hpp"
#include "torse/io/report.hpp"

namespace torse::cli {

/// What check demands of a surface.
struct Demand {
  /// The largest warp angle that passes, as typed and as a value; none where surfaces must be developable.
  std::string typed;
  std::optional<Angle> max_warp;
};

/// One face: a judgement with the warp of what is not developable, nothing for a face that is not ruled, or the error
/// of the whole file.
struct CheckedFace {
  Face face;
  std::string replay;
  std::optional<Judgement> judgement{};
  WarpVerdict warp{};
  /// Whether it meets the demand.
  Truth passes = Truth::unknown;
  std::optional<FileError> error{};
  double seconds = 0;
};

/// Reads the faces of a file and judges each; an unreadable file is one entry with its error.
std::vector<CheckedFace> check_faces(const std::string& file, const std::string& choice, const Demand& demand);

/// Judges a face.
CheckedFace check_face(Face face, const Demand& demand);

/// Whether it passes: without an angle a surface must be developable, with it the warp must not exceed it. A face that
/// is not ruled is skipped.
Outcome outcome_of(const CheckedFace& checked);

/// The case for JUnit and SARIF; its message names face, span and value.
ReportCase case_of(const CheckedFace& checked, const Demand& demand);

/// "developable", "not developable" or "not ruled". The face has no error.
std::string verdict_of(const CheckedFace& checked);

/// What was found, a line each: the class, or witness and largest warp angle, or why a face is not ruled. At least one.
std::vector<std::string> findings(const CheckedFace& checked);

/// The report on a face, docs/formats.md. It has no error.
nlohmann::ordered_json checked_json(const CheckedFace& checked);

}  // namespace torse::cli
