// Modules that the program opens when it needs them.
//   find_plugin       where one is          plugin_symbol        what it offers
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace torse::cli {

/// The file beside the program or in ../lib/torse from there; none where it is not installed.
std::optional<std::filesystem::path> find_plugin(const std::string& name);

/// Loads a plugin, for good, and gives one of its symbols. Throws Error.
void* plugin_symbol(const std::filesystem::path& plugin, const char* symbol);

}  // namespace torse::cli
