// What the plugin has read as bytes, to send it from one process to another of the same program.
//   cad_bytes      model or curves -> bytes        cad_model, cad_curves      and back
#pragma once

#include <string>
#include <string_view>

#include "torse/io/cad.hpp"

namespace torse {

/// The members one after the other; doubles and sizes as they stand in memory.
std::string cad_bytes(const CadModel& model);
std::string cad_bytes(const CadCurves& curves);

/// The inverses. Each throws Error for bytes that are not from its `cad_bytes`.
CadModel cad_model(std::string_view bytes);
CadCurves cad_curves(std::string_view bytes);

}  // namespace torse
