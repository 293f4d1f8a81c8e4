// Reading in the plugin: what the formats share.
//   Unreadable       why a file cannot be used
//   read_model       by format      read_step, read_iges      in the file's own unit
#pragma once

#include <stdexcept>
#include <string>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// A file that is no use; `what()` completes "FILE: ...".
class Unreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Each throws Unreadable, and what OpenCASCADE throws.
CadModel read_model(CadFormat format, const std::string& path);
CadModel read_step(const std::string& path);
CadModel read_iges(const std::string& path);

}  // namespace torse::cad
