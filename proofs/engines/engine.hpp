// An engine runs one claim in one arithmetic and says what that arithmetic may say about it.
//   Status, Finding      the outcome of a claim in an engine
//   Effort, Plan         how much to do, and the seed
//   Engine, engines()    the list of engines
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torse/proofs/claim.hpp"

namespace torse::proofs {

/// What may be said of a claim.
enum class Status { proved, supported, bounded, refuted, undecided, gave_up, not_applicable };

/// "Proved", "Supported", ...
std::string_view status_name(Status status);

/// How much work to do.
enum class Effort { quick, standard, deep };

/// The outcome of wrong variants or of corrupted operations.
struct Score {
  long killed = 0;
  long survived = 0;
  long equivalent = 0;

  Score& operator+=(const Score& other) {
    killed += other.killed;
    survived += other.survived;
    equivalent += other.equivalent;
    return *this;
  }
};

/// What one engine found out about one claim.
struct Finding {
  std::string claim;
  std::string engine;
  Status status = Status::not_applicable;
  std::vector<Size> sizes;             ///< the instances that were run
  std::uint64_t seed = 0;              ///< the run's seed
  long trials = 0;                     ///< inputs that met the hypotheses
  long discards = 0;                   ///< inputs that did not
  std::optional<double> error_log2;    ///< modular: log2 of the probability of a false "Supported"
  Score mutants;                       ///< mutation: the claim's own wrong variants
  Score faults;                        ///< mutation: corrupted operations
  std::vector<std::string> survivors;  ///< mutation: what survived without an explanation
  std::string detail;                  ///< one line for a person: the witness, the bound, the reason
  double seconds = 0;
};

/// What to do.
struct Plan {
  Effort effort = Effort::standard;
  std::uint64_t seed = 1;
  /// A wrong variant to run in the place of the claim: the tests of the engines themselves.
  int mutant = 0;
};

/// A finding to fill in, of the claim in the engine.
Finding open_finding(const ClaimInfo& info, std::string_view engine, const Plan& plan);

/// The finding of an engine that could not find out anything, and why.
Finding gave_up(Finding finding, std::string why);

/// Why, where none of the sizes of a plan is one of the claim.
inline constexpr const char* no_size = "no size of the claim is among those of this effort";

/// "n=2, N=3".
std::string size_text(Size size);

/// One way to run claims. `run` takes the claim's index in all_claims(). Engines never throw for a claim that fails.
struct Engine {
  std::string_view name;
  std::string_view scalar;   ///< the arithmetic in words
  std::string_view may_say;  ///< what its findings mean
  std::function<Finding(std::size_t, const Plan&)> run;
};

/// All engines in ledger order: symbolic, modular, rational, ball, numeric, mutation.
const std::vector<Engine>& engines();

/// The sizes of `wanted` that the claim is about, N cut to its greatest number of pieces, without repetitions.
std::vector<Size> sizes_for(const ClaimInfo& info, const std::vector<Size>& wanted);

/// All sizes 1 <= n <= max_n, 1 <= N <= max_pieces.
std::vector<Size> grid(int max_n, int max_pieces);

Finding run_symbolic(std::size_t claim, const Plan& plan);
Finding run_modular(std::size_t claim, const Plan& plan);
Finding run_rational(std::size_t claim, const Plan& plan);
Finding run_ball(std::size_t claim, const Plan& plan);
Finding run_numeric(std::size_t claim, const Plan& plan);
Finding run_mutation(std::size_t claim, const Plan& plan);

}  // namespace torse::proofs
