// What torse recover knows of a face, as JSON and in words.
//   RecoveredSpan, RecoveredFace     functions, edge and singularities of a surface
//   recover_faces                    of a file        recovered_json, recovered_text     for machines and people
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/cli/judge.hpp"
#include "torse/developable/piece_edge.hpp"
#include "torse/exact/decide/singularities.hpp"
#include "torse/io/document.hpp"

namespace torse::cli {

/// A piece of positive length with its edge.
struct RecoveredSpan {
  PieceFunctions<Rational> piece;
  std::optional<EdgeOfRegression<Rational>> edge;
};

/// One face with all that was recovered (nothing if it is not developable, not ruled or beyond the budget), or the
/// error of its file.
struct RecoveredFace {
  Face face;
  std::string replay;
  std::optional<Judgement> judgement{};
  std::vector<RecoveredSpan> spans{};
  std::vector<SingularSet> singular{};
  /// Whether the functions of a developable face were not looked for since its numbers are too long.
  bool beyond_budget = false;
  std::optional<FileError> error{};

  bool developable() const { return judgement.has_value() && judgement->developable(); }
};

/// Reads the faces of a file ("-" is standard input), decides each and recovers its functions; an unreadable file is
/// one entry with its error.
std::vector<RecoveredFace> recover_faces(const std::string& file, const std::string& choice);

/// The report on a face, docs/formats.md. It has no error.
nlohmann::ordered_json recovered_json(const RecoveredFace& recovered);

/// What a person reads of a developable surface: functions, edge, a few lines.
std::string recovered_text(const RecoveredFace& recovered);

}  // namespace torse::cli
