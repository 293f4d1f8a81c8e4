// What torse recover knows of a file, as JSON and in words.
//   RecoveredSpan, RecoveredFile     functions, edge and singularities of a surface
//   recover_file                     from a file      recovered_json, recovered_text     for machines and people
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

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

/// One file: a surface with all that was recovered (nothing if it is not developable), or an error.
struct RecoveredFile {
  std::string file;
  std::string name;
  std::string replay;
  std::optional<RuledFile<Rational>> surface{};
  std::optional<Judgement> judgement{};
  std::vector<RecoveredSpan> spans{};
  std::vector<SingularSet> singular{};
  std::optional<FileError> error{};
};

/// Reads a file ("-" is standard input), decides it and recovers its functions.
RecoveredFile recover_file(const std::string& file);

/// The report on a surface, docs/formats.md. The file has no error.
nlohmann::ordered_json recovered_json(const RecoveredFile& recovered);

/// What a person reads of a developable surface: functions, edge, a few lines.
std::string recovered_text(const RecoveredFile& recovered);

}  // namespace torse::cli
