// The files that a command line names.
//   same_file                  whether two names are one file
//   take_one_file_each         a word behind an output is no second output
//   require_fitting_names      none ends like a file of another format
//   require_distinct_files     none is written twice or written over what is read
#pragma once

#include <CLI/App.hpp>

#include <string>

namespace torse::cli {

/// Whether two names lead to one file, by whatever folders and links. What is not a regular file (/dev/null) counts as
/// none.
bool same_file(const std::string& a, const std::string& b);

/// Makes every option of this subcommand, and of those below it, that names files to write take one each time it is
/// given: the parser would take an input behind it for a second output, and the input would be lost.
void take_one_file_each(CLI::App& app);

/// Throws UsageError where an option of the parsed subcommand whose file has one format (--json, --ledger, --junit,
/// --sarif, --csv, --svg) gets a name that ends like that of another format that torse writes. Other endings, and none,
/// are as good as the usual one.
void require_fitting_names(const CLI::App& app);

/// Throws UsageError where two options of the parsed subcommand name one file to write, or standard output, or where
/// one names a file that is read. Options whose value is FILE, OUT or PATH in the help name files to write. Two names
/// are one file if they lead to it, by whatever folders and links; what is not a regular file (/dev/null) may be
/// written twice.
void require_distinct_files(const CLI::App& app);

}  // namespace torse::cli
