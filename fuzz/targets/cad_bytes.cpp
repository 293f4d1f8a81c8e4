// What the process that reads STEP and IGES files sends: any bytes give a model or an error, a model gives its bytes
// again, and its strips become surfaces or an error.
#include <string>

#include "torse/cli/cad_faces.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/fuzz/targets/target.hpp"
#include "torse/io/cad_bytes.hpp"

namespace torse::targets {
namespace {

void check_surfaces(const CadModel& model) {
  for (const CadFace& face : model.faces) {
    for (const CadStrip& strip : face.strips) {
      try {
        const RuledFile<Rational> surface = cli::surface_of(strip, face.placement);
        const std::size_t count = static_cast<std::size_t>(surface.knots.last()) + 1;
        require(surface.c.points.size() == count && surface.d.points.size() == count, "both rows fit the knots");
      } catch (const InvalidInput&) {
      }
    }
  }
}

void check(std::string_view bytes) {
  CadModel model;
  try {
    model = cad_model(bytes);
  } catch (const Error&) {
    return;
  }
  require(cad_bytes(model) == bytes, "a model has the bytes it came from");
  check_surfaces(model);
}

/// The kind of a file is told, or refused by an error, for any first bytes.
void check_kind(std::string_view bytes) {
  for (const char* file : {"a", "a.json", "a.step", "a.igs"}) {
    try {
      const std::optional<CadFormat> format = cli::cad_format(file, bytes);
      if (format == CadFormat::step) {
        require(bytes.find("ISO-10303-21") != std::string_view::npos, "STEP files hold their mark");
      }
    } catch (const FileError&) {
    }
  }
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check(torse::targets::text_of(data, size));
  torse::targets::check_kind(torse::targets::text_of(data, size));
  return 0;
}
