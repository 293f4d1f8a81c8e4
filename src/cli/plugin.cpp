#include "torse/cli/plugin.hpp"

#include <dlfcn.h>

#include <system_error>

#include "torse/scalar/errors.hpp"

namespace torse::cli {

namespace fs = std::filesystem;

std::optional<fs::path> find_plugin(const std::string& name) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& folder : {program, program.parent_path() / "lib/torse"}) {
    const fs::path plugin = folder / name;
    if (fs::exists(plugin, ignored)) return plugin;
  }
  return std::nullopt;
}

void* plugin_symbol(const fs::path& plugin, const char* symbol) {
  void* const library = dlopen(plugin.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(std::string("cannot load the plugin: ") + dlerror());
  void* const found = dlsym(library, symbol);
  if (found == nullptr) {
    throw Error("cannot use the plugin: " + plugin.string() + " is not " + plugin.stem().string());
  }
  return found;
}

}  // namespace torse::cli
