#include "torse/proofs/engines/engine.hpp"

#include <algorithm>
#include <utility>

namespace torse::proofs {

std::string_view status_name(Status status) {
  switch (status) {
    case Status::proved:
      return "Proved";
    case Status::supported:
      return "Supported";
    case Status::bounded:
      return "Bounded";
    case Status::refuted:
      return "Refuted";
    case Status::undecided:
      return "Undecided";
    case Status::gave_up:
      return "GaveUp";
    case Status::not_applicable:
      return "NotApplicable";
  }
  return "";
}

const std::vector<Engine>& engines() {
  static const std::vector<Engine> all{
      {"symbolic", "rational functions over Q, every free parameter an indeterminate",
       "Proved for the sizes listed, or Refuted", run_symbolic},
      {"modular", "random primes of 62 bits, 64 random points at once",
       "Refuted, or Supported with a bound on the probability of error", run_modular},
      {"rational", "rational numbers, generic and hostile", "Refuted with the witness, or Supported", run_rational},
      {"ball", "balls (Arb)", "Refuted if 0 is outside, or Bounded", run_ball},
      {"numeric", "float, double, long double, MPFR", "Bounded: the error in ulps against exact arithmetic",
       run_numeric},
      {"mutation", "wrong variants of the claim, corrupted operations", "killed, survived, equivalent", run_mutation},
  };
  return all;
}

Finding open_finding(const ClaimInfo& info, std::string_view engine, const Plan& plan) {
  Finding finding;
  finding.claim = info.id;
  finding.engine = engine;
  finding.seed = plan.seed;
  return finding;
}

Finding gave_up(Finding finding, std::string why) {
  finding.status = Status::gave_up;
  finding.detail = std::move(why);
  return finding;
}

std::string size_text(Size size) { return "n=" + std::to_string(size.n) + ", N=" + std::to_string(size.pieces); }

std::vector<Size> sizes_for(const ClaimInfo& info, const std::vector<Size>& wanted) {
  std::vector<Size> sizes;
  for (Size size : wanted) {
    size.pieces = std::min(size.pieces, info.max_pieces);
    if (size.n < info.min_degree || size.n > info.max_degree) continue;
    if (std::find(sizes.begin(), sizes.end(), size) == sizes.end()) sizes.push_back(size);
  }
  return sizes;
}

std::vector<Size> grid(int max_n, int max_pieces) {
  std::vector<Size> sizes;
  for (int n = 1; n <= max_n; ++n) {
    for (int pieces = 1; pieces <= max_pieces; ++pieces) sizes.push_back({n, pieces});
  }
  return sizes;
}

}  // namespace torse::proofs
