// The plugin torse_cad: STEP and IGES by OpenCASCADE behind the interface of torse/io/cad.hpp.
//   torse_cad_formats      the one symbol that it exports
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Version.hxx>
#include <string>

#include "torse/io/cad.hpp"

namespace torse::cad {
namespace {

class Formats final : public CadFormats {
 public:
  Formats() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

  std::string version() const override { return std::string("OpenCASCADE ") + OCC_VERSION_COMPLETE; }
};

}  // namespace
}  // namespace torse::cad

extern "C" __attribute__((visibility("default"))) torse::CadFormats* torse_cad_formats() {
  static torse::cad::Formats formats;
  return &formats;
}
