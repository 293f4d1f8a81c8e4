// fork, limits, dlopen in the child, a pipe back.
#include "torse/cli/cad_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string_view>

#include "torse/cli/plugin.hpp"
#include "torse/io/cad_bytes.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Whether this program runs under AddressSanitizer, whose shadow memory needs more address space than any limit
/// allows.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// The first byte of an answer.
constexpr char answer = '+';
constexpr char refusal = '-';

void set_limit(__rlimit_resource resource, rlim_t most) {
  const rlimit limit{most, most};
  setrlimit(resource, &limit);
}

CadFormats& load(const fs::path& path) { return *reinterpret_cast<CadEntry>(plugin_symbol(path, cad_entry))(); }

/// Writes all of a text, which the system may take in parts. Whether that went well; errno tells why not.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// The child: OpenCASCADE talks on standard output, which belongs to the reports.
[[noreturn]] void serve(int pipe, const fs::path& plugin, unsigned seconds,
                        const std::function<std::string(CadFormats&)>& task) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, seconds);
  if (!sanitized) set_limit(RLIMIT_DATA, limits::cad_memory);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  std::string text;
  try {
    text = answer + task(load(plugin));
  } catch (const std::bad_alloc&) {
    text = refusal + cad_out_of_memory();
  } catch (const std::exception& error) {
    text = refusal + std::string(error.what());
  }
  _exit(write_all(pipe, text) ? 0 : 1);
}

/// What the child sends until it closes the pipe; none if the time runs out.
std::optional<std::string> receive(int pipe, Clock::time_point deadline) {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return std::nullopt;
    pollfd ready{pipe, POLLIN, 0};
    if (poll(&ready, 1, static_cast<int>(left)) <= 0) continue;
    const ssize_t count = read(pipe, buffer, sizeof buffer);
    if (count == 0) return text;
    if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) return text;
  }
}

/// The end of a child, from its status and its times.
struct End {
  int status = 0;
  unsigned seconds = 0;
  long mebibytes = 0;
};

End wait_for(pid_t child) {
  End end;
  rusage usage{};
  while (wait4(child, &end.status, 0, &usage) < 0 && errno == EINTR) {
  }
  end.seconds = static_cast<unsigned>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1;
  end.mebibytes = usage.ru_maxrss >> 10;
  return end;
}

/// A child without an answer.
CadCrash failure_of(const std::string& file, const End& end, bool in_time, unsigned seconds) {
  const std::string fails = "OpenCASCADE fails on it: ";
  const int signal = WIFSIGNALED(end.status) ? WTERMSIG(end.status) : 0;
  if (!in_time || signal == SIGXCPU || signal == SIGKILL) {
    return {file, fails + "it did not end in " + std::to_string(seconds) + " seconds", 0};
  }
  const std::string how = (signal == 0 ? "" : std::string(strsignal(signal)) + ", ") + std::to_string(end.mebibytes);
  return {file, fails + "it crashed (" + how + " MiB in use)", end.seconds < seconds ? seconds - end.seconds : 0};
}

/// The bytes of a file once more as a file, since OpenCASCADE opens files by name and these may be those of a pipe;
/// without a byte order mark, after which it reads nothing.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("torse", MFD_CLOEXEC)) {
    if (!write_all(descriptor_, without_byte_order_mark(bytes))) {
      throw Error(std::string("cannot be copied to memory: ") + std::strerror(errno));
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// What a member of the plugin reads from a file.
template <class T>
using ReadMember = std::string (CadFormats::*)(CadFormat, const std::string&, T&) noexcept;

template <class T>
std::string run_reader(const std::string& file, CadFormat format, const std::string& bytes, ReadMember<T> member) {
  return run_cad(file, [&](CadFormats& formats) {
    T read;
    const MemoryFile copy(bytes);
    const std::string reason = (formats.*member)(format, copy.path(), read);
    if (!reason.empty()) throw Error(reason);
    return cad_bytes(read);
  });
}

/// What may explain a crash, found in the time that is left.
std::string complaint_about(const std::string& file, CadFormat format, const std::string& bytes, unsigned seconds) {
  if (seconds == 0) return "";
  const auto task = [&](CadFormats& formats) { return formats.complaint(format, MemoryFile(bytes).path()); };
  try {
    return run_cad(file, task, seconds);
  } catch (const FileError&) {
    return "";
  }
}

/// The bytes of what was read; a crash is explained as far as possible.
template <class T>
std::string read_bytes(const std::string& file, CadFormat format, const std::string& bytes, ReadMember<T> member) {
  try {
    return run_reader(file, format, bytes, member);
  } catch (const CadCrash& crash) {
    const std::string complaint = complaint_about(file, format, bytes, crash.seconds_left());
    throw FileError(file, complaint.empty() ? crash.reason() : complaint + " (" + crash.reason() + ")");
  }
}

}  // namespace

std::string run_cad(const std::string& file, const std::function<std::string(CadFormats&)>& task, unsigned seconds) {
  const std::optional<fs::path> plugin = find_plugin("torse_cad.so");
  if (!plugin) {
    throw FileError(file, "STEP and IGES need the optional part of torse that uses OpenCASCADE: ./x cad builds it");
  }
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw FileError(file, std::string("cannot be read: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) serve(ends[1], *plugin, seconds, task);
  close(ends[1]);
  // A busy machine gives the child a part of its time only.
  const std::optional<std::string> text =
      child < 0 ? std::nullopt : receive(ends[0], Clock::now() + std::chrono::seconds(4 * seconds));
  close(ends[0]);
  if (child < 0) throw FileError(file, std::string("cannot be read: ") + std::strerror(errno));
  if (!text) kill(child, SIGKILL);
  const End end = wait_for(child);
  if (!text || end.status != 0 || text->empty()) throw failure_of(file, end, text.has_value(), seconds);
  if (text->front() != answer) throw FileError(file, text->substr(1));
  return text->substr(1);
}

CadModel read_cad(const std::string& file, CadFormat format, const std::string& bytes) {
  return cad_model(read_bytes<CadModel>(file, format, bytes, &CadFormats::read));
}

CadCurves read_cad_curves(const std::string& file, CadFormat format, const std::string& bytes) {
  return cad_curves(read_bytes<CadCurves>(file, format, bytes, &CadFormats::read_curves));
}

}  // namespace torse::cli
