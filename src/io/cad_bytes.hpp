// A CadModel as bytes, to send it from one process to another of the same program.
//   cad_bytes      model -> bytes        cad_model      bytes -> model
#pragma once

#include <string>
#include <string_view>

#include "torse/io/cad.hpp"

namespace torse {

/// The members one after the other; doubles and sizes as they stand in memory.
std::string cad_bytes(const CadModel& model);

/// The inverse. Throws Error for bytes that are not from `cad_bytes`.
CadModel cad_model(std::string_view bytes);

}  // namespace torse
