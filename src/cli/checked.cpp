// Judging faces, and their reports.
#include "torse/cli/checked.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/exact/warp/words.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string replay_of(std::vector<std::string> words, const Demand& demand) {
  if (!demand.typed.empty()) words.insert(words.begin(), {"--max-warp", demand.typed});
  words.insert(words.begin(), {"torse", "check"});
  return printable(command_line(words));
}

struct Rule {
  std::string id;
  std::string text;
};

/// What the developable flag of the file is worth, held to the demand: "true" and "false" for one that is set,
/// "unclaimed" for a surface that passes without it, "none", "undecided".
std::string claim_of(const CheckedFace& checked) {
  if (checked.passes == Truth::unknown) return "undecided";
  const bool passes = definitely(checked.passes);
  if (*checked.face.cad->claimed_developable) return passes ? "true" : "false";
  return passes ? "unclaimed" : "none";
}

/// Whether a judged face meets the demand.
Truth passes(const CheckedFace& checked, const Demand& demand) {
  if (checked.judgement->developable()) return Truth::yes;
  return demand.max_warp ? checked.warp.within_limit : Truth::no;
}

std::string claim_text(const std::string& claim) {
  if (claim == "true") return "developable flag: claimed and true";
  if (claim == "false") return "developable flag: claimed and false";
  if (claim == "undecided") return "developable flag: not decided";
  return "developable flag: not claimed though true";
}

bool has_claim(const CheckedFace& checked) {
  return checked.judgement && checked.face.cad && checked.face.cad->claimed_developable;
}

/// The rule that a case is held to.
Rule rule_of(const CheckedFace& checked, const Demand& demand) {
  if (checked.error) return {"readable-input", "The file holds ruled surfaces that torse reads."};
  if (!checked.face.surface) return {"ruled", "The face is a ruled surface."};
  if (demand.max_warp)
    return {"max-warp", "The largest warp angle of the ruled surface is at most that of --max-warp."};
  return {"developable", "The ruled surface is developable."};
}

std::string message_of(const CheckedFace& checked, Outcome outcome) {
  if (checked.error) return checked.error->what();
  return fmt::format("{}: {}{}", verdict_of(checked), fmt::join(findings(checked), "; "),
                     outcome == Outcome::undecided ? "; the budget ran out before the limit was decided" : "");
}

Json warp_json(const WarpEnclosure& warp) { return {{"lo", warp.lower}, {"hi", warp.upper}}; }

Json exclusions_json(const WarpEnclosure& warp) {
  Json list = Json::array();
  for (const WarpExclusion& at : warp.exclusions) {
    list.push_back({{"piece", at.piece}, {"from", at.lower.text()}, {"to", at.upper.text()}});
  }
  return list;
}

}  // namespace

CheckedFace check_face(Face face, const Demand& demand) {
  CheckedFace checked{.face = std::move(face), .replay = ""};
  checked.replay = replay_of(words_of(checked.face), demand);
  if (!checked.face.surface) return checked;
  const auto start = std::chrono::steady_clock::now();
  checked.judgement = judge(*checked.face.surface);
  if (!checked.judgement->developable()) checked.warp = judge_warp(*checked.face.surface, demand.max_warp);
  checked.passes = passes(checked, demand);
  checked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return checked;
}

std::vector<CheckedFace> check_faces(const std::string& file, const std::string& choice, const Demand& demand) {
  std::vector<CheckedFace> list;
  try {
    for (Face& face : read_faces(file, choice)) list.push_back(check_face(std::move(face), demand));
  } catch (const FileError& error) {
    list.push_back(
        {.face = {.file = file, .name = name_of_file(file)}, .replay = replay_of(words_of(file, choice), demand)});
    list.back().error = error;
  }
  return list;
}

Outcome outcome_of(const CheckedFace& checked) {
  if (checked.error) return Outcome::error;
  if (!checked.face.surface) return Outcome::skipped;
  if (checked.passes == Truth::unknown) return Outcome::undecided;
  return definitely(checked.passes) ? Outcome::passed : Outcome::failed;
}

std::string verdict_of(const CheckedFace& checked) {
  if (!checked.face.surface) return "not ruled";
  return checked.judgement->developable() ? "developable" : "not developable";
}

std::vector<std::string> findings(const CheckedFace& checked) {
  if (!checked.face.surface) return {checked.face.remark};
  std::vector<std::string> lines;
  if (checked.judgement->developable()) {
    lines = {describe(checked.judgement->classification)};
  } else {
    lines = {describe(*checked.judgement->witness, checked.face.surface->knots), describe(checked.warp.enclosure)};
  }
  if (has_claim(checked)) {
    if (const std::string claim = claim_of(checked); claim != "none") lines.push_back(claim_text(claim));
  }
  if (!checked.face.remark.empty()) lines.push_back(checked.face.remark);
  return lines;
}

ReportCase case_of(const CheckedFace& checked, const Demand& demand) {
  ReportCase c;
  c.suite = "check";
  c.name = checked.face.of > 1 ? name_of_file(checked.face.file) + ": " + checked.face.name : checked.face.name;
  c.outcome = outcome_of(checked);
  c.message = message_of(checked, c.outcome);
  c.replay = checked.replay;
  const Rule rule = rule_of(checked, demand);
  c.rule = rule.id;
  c.rule_text = rule.text;
  c.file = checked.face.file;
  c.seconds = checked.seconds;
  if (checked.error) {
    c.line = checked.error->line();
    c.column = checked.error->character();
  }
  return c;
}

Json checked_json(const CheckedFace& checked) {
  Json json = face_json(checked.face);
  if (!checked.judgement) return json;
  const Judgement& judgement = *checked.judgement;
  json["developable"] = judgement.developable();
  json["exact"] = true;
  if (has_claim(checked)) json["claim"] = claim_of(checked);
  json["class"] = name_of(judgement.classification.kind);
  if (judgement.classification.vertex) json["vertex"] = point_json(*judgement.classification.vertex);
  if (judgement.classification.direction) json["direction"] = point_json(*judgement.classification.direction);
  json["max_warp_deg"] = warp_json(checked.warp.enclosure);
  json["warp_excluded"] = exclusions_json(checked.warp.enclosure);
  json["witness"] = judgement.witness ? witness_json(*judgement.witness, checked.face.surface->knots) : Json();
  const auto singular = judgement.developable() ? quick_singularities(*checked.face.surface) : std::nullopt;
  json["singular"] = singular ? singular_json(*singular) : Json();
  return json;
}

}  // namespace torse::cli
