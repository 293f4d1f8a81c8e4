// The files that a command line names.
//   require_distinct_files     none is written twice or written over what is read
#pragma once

#include <CLI/App.hpp>

namespace torse::cli {

/// Throws UsageError where two options of the parsed subcommand name one file to write, or standard output, or where
/// one names a file that is read. Options whose value is FILE, OUT or PATH in the help name files to write. Two names
/// are one file if they lead to it, by whatever folders and links; what is not a regular file (/dev/null) may be
/// written twice.
void require_distinct_files(const CLI::App& app);

}  // namespace torse::cli
