#include "torse/proofs/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "torse/proofs/coq_theorems.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::proofs {

namespace {

using Json = nlohmann::ordered_json;

Json theorems(std::string_view claim) {
  Json names = Json::array();
  for (const CoqTheorem& theorem : coq_theorems) {
    if (theorem.claim == claim) names.push_back(theorem.name);
  }
  return names;
}

Json score_json(const Score& score) {
  return {{"killed", score.killed}, {"survived", score.survived}, {"equivalent", score.equivalent}};
}

Json sizes_json(const std::vector<Size>& sizes) {
  Json list = Json::array();
  for (const Size size : sizes) list.push_back({size.n, size.pieces});
  return list;
}

Json error_json(const Finding& finding) {
  return finding.error_log2 ? Json(std::ceil(*finding.error_log2 * 10) / 10) : Json(nullptr);
}

double rounded_seconds(double seconds) { return std::round(seconds * 1000) / 1000; }

Json finding_json(const Finding& finding) {
  return {{"engine", finding.engine},
          {"status", status_name(finding.status)},
          {"sizes", sizes_json(finding.sizes)},
          {"trials", finding.trials},
          {"discards", finding.discards},
          {"error_log2", error_json(finding)},
          {"detail", finding.detail},
          {"survivors", finding.survivors},
          {"seconds", rounded_seconds(finding.seconds)}};
}

Json entry_json(const Entry& entry, const Plan& plan) {
  const ClaimInfo& info = *entry.info;
  const Finding* decisive = entry.decisive();
  Json hypotheses = Json::array();
  bool as_printed = true;
  for (const Hypothesis& hypothesis : info.hypotheses) {
    as_printed = as_printed && hypothesis.stated;
    hypotheses.push_back({{"words", hypothesis.words}, {"stated", hypothesis.stated}});
  }
  Json engines = Json::array();
  Json error = nullptr;
  double seconds = 0;
  for (const Finding& finding : entry.findings) {
    engines.push_back(finding_json(finding));
    if (finding.error_log2) error = error_json(finding);
    seconds += finding.seconds;
  }
  return {{"id", info.id},
          {"paper", info.paper()},
          {"source", info.source},
          {"title", info.title},
          {"statement", info.statement},
          {"status", status_name(entry.status())},
          {"engine", decisive == nullptr ? Json(nullptr) : Json(decisive->engine)},
          {"sizes", decisive == nullptr ? Json::array() : sizes_json(decisive->sizes)},
          {"error_log2", error},
          {"hypotheses", hypotheses},
          {"as_printed", as_printed},
          {"remark", info.remark},
          {"coq", theorems(info.id)},
          {"mutants", score_json(entry.mutants())},
          {"faults", score_json(entry.faults())},
          {"seed", plan.seed},
          {"seconds", rounded_seconds(seconds)},
          {"engines", engines}};
}

int rank(std::string_view status) {
  constexpr std::array<std::string_view, 7> order{"Refuted", "NotApplicable", "GaveUp", "Undecided",
                                                  "Bounded", "Supported",     "Proved"};
  const auto* const at = std::find(order.begin(), order.end(), status);
  if (at == order.end()) throw Error("baseline: unknown status " + std::string(status));
  return static_cast<int>(at - order.begin());
}

/// Whether a status below that of an earlier report tells of something worse though other engines may have run
/// elsewhere.
bool comparable(const Entry& entry, const Json& engine) {
  return entry.status() == Status::refuted || !engine.is_string() ||
         std::any_of(entry.findings.begin(), entry.findings.end(),
                     [&](const Finding& finding) { return engine == finding.engine; });
}

}  // namespace

std::string_view effort_name(Effort effort) {
  switch (effort) {
    case Effort::quick:
      return "quick";
    case Effort::standard:
      return "standard";
    case Effort::deep:
      return "deep";
  }
  return "";
}

std::string sizes_text(const std::vector<Size>& sizes) {
  if (sizes.empty()) return "-";
  int max_n = 0;
  int max_pieces = 0;
  int min_n = sizes.front().n;
  for (const Size size : sizes) {
    max_n = std::max(max_n, size.n);
    min_n = std::min(min_n, size.n);
    max_pieces = std::max(max_pieces, size.pieces);
  }
  const std::string n = min_n == max_n ? "n=" + std::to_string(max_n)
                        : min_n == 1   ? "n<=" + std::to_string(max_n)
                                       : std::to_string(min_n) + "<=n<=" + std::to_string(max_n);
  const std::string pieces = (max_pieces == 1 ? "N=" : "N<=") + std::to_string(max_pieces);
  const bool full = static_cast<int>(sizes.size()) == (max_n - min_n + 1) * max_pieces;
  return n + " " + pieces + (full ? "" : " (" + std::to_string(sizes.size()) + " sizes)");
}

std::string replay_command(const Finding& finding, const Plan& plan) {
  return "torse verify --claim " + finding.claim + " --engine " + finding.engine + " --effort " +
         std::string(effort_name(plan.effort)) + " --seed " + std::to_string(plan.seed);
}

std::string json_report(const std::vector<Entry>& entries, const Plan& plan) {
  Json claims = Json::array();
  for (const Entry& entry : entries) claims.push_back(entry_json(entry, plan));
  const Json report{{"torse", 1}, {"effort", effort_name(plan.effort)}, {"seed", plan.seed}, {"claims", claims}};
  return report.dump(1) + "\n";
}

std::string ledger(const std::vector<Entry>& entries, const Plan& plan) {
  std::string lines;
  for (const Entry& entry : entries) {
    Json line = entry_json(entry, plan);
    Json kept = Json::object();
    for (const char* key : {"id", "status", "engine", "sizes", "as_printed", "mutants", "faults"})
      kept[key] = line[key];
    lines += (lines.empty() ? "" : ",\n") + std::string("  ") + kept.dump();
  }
  return "{\"torse\": 1, \"effort\": \"" + std::string(effort_name(plan.effort)) +
         "\", \"seed\": " + std::to_string(plan.seed) + ", \"claims\": [\n" + lines + "\n]}\n";
}

std::vector<std::string> regressions(const std::string& baseline, const std::vector<Entry>& entries, Extent extent) {
  const Json earlier = Json::parse(baseline, nullptr, false);
  if (earlier.is_discarded() || !earlier.is_object() || !earlier.contains("claims") || !earlier["claims"].is_array()) {
    throw Error("expected a report of torse verify --json, an object with \"claims\"");
  }
  std::vector<std::string> worse;
  for (const Json& claim : earlier["claims"]) {
    if (!claim.is_object() || !claim.value("id", Json()).is_string() || !claim.value("status", Json()).is_string()) {
      throw Error("expected \"id\" and \"status\" in every claim");
    }
    const std::string id = claim["id"];
    const std::string before = claim["status"];
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.info->id == id; });
    if (entry == entries.end()) {
      if (extent == Extent::whole) worse.push_back(id + " was " + before + " and is gone");
    } else if (rank(status_name(entry->status())) < rank(before) &&
               (extent != Extent::shard || comparable(*entry, claim.value("engine", Json())))) {
      worse.push_back(id + " was " + before + " and is " + std::string(status_name(entry->status())));
    }
  }
  return worse;
}

}  // namespace torse::proofs
