// What torse verify says of the ledger's entries.
//   ledger_outcome   an entry in the words of the exit codes        ledger_code      of all of them
//   culprit          the finding that a failing entry should be replayed with
//   ledger_text      a line for each entry          tally_of         how many there are of each status
//   ledger_case      an entry for JUnit and SARIF
#pragma once

#include <string>
#include <vector>

#include "torse/cli/terminal.hpp"
#include "torse/io/report.hpp"
#include "torse/proofs/runner.hpp"

namespace torse::cli {

/// Failed where an engine refutes or a wrong variant survives, undecided where nothing was found out, passed otherwise.
Outcome ledger_outcome(const proofs::Entry& entry);

/// The exit code of all entries; refuted as well where one `regressed` since an earlier run, undecided where no engine
/// has anything to say of any of them and they are the `whole` run, not a shard.
int ledger_code(const std::vector<proofs::Entry>& entries, bool regressed, bool whole);

/// The first finding that refutes or has survivors; otherwise the first that came to nothing, or the first. The entry
/// has a finding.
const proofs::Finding& culprit(const proofs::Entry& entry);

/// A headline and a line for each entry; below one that has not passed its reason, survivors and command.
std::string ledger_text(const std::vector<proofs::Entry>& entries, const proofs::Plan& plan, const Terminal& terminal);

/// "40 claims: 38 Proved, 2 Supported, 0 surviving mutants", in the order of strength.
std::string tally_of(const std::vector<proofs::Entry>& entries);

/// The entry as a case of the suite "verify".
ReportCase ledger_case(const proofs::Entry& entry, const proofs::Plan& plan);

}  // namespace torse::cli
