// The plugin torse_cad in a process of its own: what OpenCASCADE does to a damaged file is no concern of the program.
//   CadCrash          what it did not survive
//   run_cad           a task for the plugin in a child with limits of time and memory
//   read_cad          the model of a STEP or IGES file
//   read_cad_curves   its curves
#pragma once

#include <functional>
#include <string>

#include "torse/io/cad.hpp"
#include "torse/io/document.hpp"

namespace torse::cli {

/// The plugin crashed or ran out of time or memory.
class CadCrash : public FileError {
 public:
  CadCrash(const std::string& file, const std::string& reason, unsigned seconds_left)
      : FileError(file, reason), seconds_left_(seconds_left) {}

  /// What the child left of its time; 0 for one that reached a limit.
  unsigned seconds_left() const { return seconds_left_; }

 private:
  unsigned seconds_left_;
};

/// Gives the plugin to `task` in a child process and returns the task's bytes. `file` is the name for errors, `seconds`
/// the child's processor time. Throws FileError where there is no plugin, for an exception of the task (its text is the
/// reason), and CadCrash for a child that crashes or exceeds its time or limits::cad_memory.
std::string run_cad(const std::string& file, const std::function<std::string(CadFormats&)>& task,
                    unsigned seconds = limits::cad_seconds);

/// Reads the bytes of a file. Throws FileError.
CadModel read_cad(const std::string& file, CadFormat format, const std::string& bytes);

/// Reads the curves in the bytes of a file. Throws FileError.
CadCurves read_cad_curves(const std::string& file, CadFormat format, const std::string& bytes);

}  // namespace torse::cli
