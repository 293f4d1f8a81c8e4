// Writing in the plugin: what the formats share.
//   Unwritable        why surfaces cannot be written
//   write_step, write_iges      the bytes of a file
//   own_string        a text for OpenCASCADE
#pragma once

#include <TCollection_HAsciiString.hxx>
#include <stdexcept>
#include <string>

#include "torse/io/cad.hpp"

namespace torse::cad {

/// Surfaces that the format, or OpenCASCADE, has no place for; `what()` is the reason.
class Unwritable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Each throws Unwritable, and what OpenCASCADE throws.
std::string write_step(const CadSheets& sheets);
std::string write_iges(const CadSheets& sheets);

inline Handle(TCollection_HAsciiString) own_string(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

}  // namespace torse::cad
