// Reading and writing by the standard library.
#include "torse/io/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>

namespace torse {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

std::string system_reason() { return std::generic_category().message(errno); }

void write_to(const std::string& path, std::FILE* file, std::string_view content) {
  if (std::fwrite(content.data(), 1, content.size(), file) != content.size() || std::fflush(file) != 0) {
    throw FileError(path, "cannot be written: " + system_reason());
  }
}

void write_directly(const std::string& path, std::string_view content) {
  const File file(std::fopen(path.c_str(), "wb"));
  if (!file) throw FileError(path, "cannot be written: " + system_reason());
  write_to(path, file.get(), content);
}

/// Creates a new file next to `target` and returns it with its path.
std::pair<File, fs::path> create_beside(const std::string& path, const fs::path& target) {
  std::random_device random;
  for (int attempt = 0; attempt < 100; ++attempt) {
    fs::path name = target;
    name.replace_filename(".torse." + std::to_string(random()) + ".tmp");
    File file(std::fopen(name.c_str(), "wbx"));
    if (file) return {std::move(file), name};
    if (errno != EEXIST) break;
  }
  throw FileError(path, "cannot be written: " + system_reason());
}

void replace_file(const std::string& path, const fs::path& target, std::string_view content) {
  auto [file, temporary] = create_beside(path, target);
  std::error_code ignored;
  try {
    write_to(path, file.get(), content);
    if (std::fclose(file.release()) != 0) throw FileError(path, "cannot be written: " + system_reason());
    const fs::file_status old = fs::status(target, ignored);
    if (fs::exists(old)) fs::permissions(temporary, old.permissions(), ignored);
    std::error_code failure;
    fs::rename(temporary, target, failure);
    if (failure) throw FileError(path, "cannot be written: " + failure.message());
  } catch (...) {
    fs::remove(temporary, ignored);
    throw;
  }
}

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code ignored;
  if (path != "-" && fs::is_directory(path, ignored)) throw FileError(path, "expected a file, found a folder");
  const File opened(path == "-" ? nullptr : std::fopen(path.c_str(), "rb"));
  if (path != "-" && !opened) throw FileError(path, "cannot be read: " + system_reason());
  std::FILE* file = opened ? opened.get() : stdin;
  std::string content;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
    content.append(buffer, count);
    if (content.size() > limits::file_bytes) {
      throw FileError(path, "expected at most " + std::to_string(limits::file_bytes) + " bytes, found more");
    }
  }
  if (std::ferror(file) != 0) throw FileError(path, "cannot be read: " + system_reason());
  return content;
}

void write_file(const std::string& path, std::string_view content) {
  if (path == "-") return write_to("standard output", stdout, content);
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw FileError(path, "cannot be written: it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, content);
  const fs::path resolved = fs::weakly_canonical(path, ignored);
  replace_file(path, resolved.empty() ? fs::path(path) : resolved, content);
}

void make_folder(const std::string& path) {
  std::error_code failure;
  std::error_code ignored;
  fs::create_directories(path, failure);
  if (fs::is_directory(path, ignored)) return;
  if (!failure) failure = std::make_error_code(std::errc::not_a_directory);
  throw FileError(path, "cannot be made: " + failure.message());
}

}  // namespace torse
