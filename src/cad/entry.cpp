// The plugin torse_cad: STEP and IGES by OpenCASCADE behind the interface of torse/io/cad.hpp.
//   torse_cad_formats      the one symbol that it exports
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>
#include <exception>
#include <new>

#include "torse/cad/read.hpp"
#include "torse/cad/write.hpp"

namespace torse::cad {
namespace {

/// Runs a task and returns what was wrong, an empty text for nothing. `failed` words what OpenCASCADE says.
template <class Task, class Words>
std::string guarded(const Task& task, const Words& failed) noexcept {
  try {
    task();
    return {};
  } catch (const Standard_OutOfMemory&) {
    return cad_out_of_memory();
  } catch (const std::bad_alloc&) {
    return cad_out_of_memory();
  } catch (const Standard_Failure& failure) {
    return failed(failure.GetMessageString());
  } catch (const std::exception& error) {
    return error.what();
  }
}

class Formats final : public CadFormats {
 public:
  Formats() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

  std::string version() const override { return std::string("OpenCASCADE ") + OCC_VERSION_COMPLETE; }

  std::string read(CadFormat format, const std::string& path, CadModel& model) noexcept override {
    return guarded([&] { model = read_model(format, path); },
                   [&](const char* text) { return unreadable(format, path, text); });
  }

  std::string read_curves(CadFormat format, const std::string& path, CadCurves& curves) noexcept override {
    return guarded([&] { curves = format == CadFormat::step ? read_step_curves(path) : read_iges_curves(path); },
                   [&](const char* text) { return unreadable(format, path, text); });
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
    return guarded([&] { bytes = format == CadFormat::step ? write_step(sheets) : write_iges(sheets); },
                   [](const char* text) { return std::string("cannot be written by OpenCASCADE: ") + text; });
  }

 private:
  std::string unreadable(CadFormat format, const std::string& path, const char* text) {
    const std::string damage = complaint(format, path);
    return (damage.empty() ? "" : damage + ": ") + "OpenCASCADE cannot read it: " + text;
  }
};

}  // namespace
}  // namespace torse::cad

extern "C" __attribute__((visibility("default"))) torse::CadFormats* torse_cad_formats() {
  static torse::cad::Formats formats;
  return &formats;
}
