// The plugin torse_cad: STEP and IGES by OpenCASCADE behind the interface of torse/io/cad.hpp.
//   torse_cad_formats      the one symbol that it exports
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <exception>

#include "torse/cad/read.hpp"
#include "torse/cad/write.hpp"

namespace torse::cad {
namespace {

class Formats final : public CadFormats {
 public:
  Formats() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

  std::string version() const override { return std::string("OpenCASCADE ") + OCC_VERSION_COMPLETE; }

  std::string read(CadFormat format, const std::string& path, CadModel& model) noexcept override {
    try {
      model = read_model(format, path);
      return {};
    } catch (const Standard_Failure& failure) {
      const std::string damage = complaint(format, path);
      return (damage.empty() ? "" : damage + ": ") + "OpenCASCADE cannot read it: " + failure.GetMessageString();
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  std::string read_curves(CadFormat format, const std::string& path, CadCurves& curves) noexcept override {
    try {
      curves = format == CadFormat::step ? read_step_curves(path) : read_iges_curves(path);
      return {};
    } catch (const Standard_Failure& failure) {
      const std::string damage = complaint(format, path);
      return (damage.empty() ? "" : damage + ": ") + "OpenCASCADE cannot read it: " + failure.GetMessageString();
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  std::string complaint(CadFormat format, const std::string& path) noexcept override {
    try {
      return first_complaint(format, path);
    } catch (const Standard_Failure&) {
      return {};
    } catch (const std::exception&) {
      return {};
    }
  }

  std::string write(CadFormat format, const CadSheets& sheets, std::string& bytes) noexcept override {
    try {
      bytes = format == CadFormat::step ? write_step(sheets) : write_iges(sheets);
      return {};
    } catch (const Standard_Failure& failure) {
      return std::string("cannot be written by OpenCASCADE: ") + failure.GetMessageString();
    } catch (const std::exception& error) {
      return error.what();
    }
  }
};

}  // namespace
}  // namespace torse::cad

extern "C" __attribute__((visibility("default"))) torse::CadFormats* torse_cad_formats() {
  static torse::cad::Formats formats;
  return &formats;
}
