// The note NT_GNU_BUILD_ID among the program headers of the first loaded object, which is the program.
#include "torse/cli/build_id.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstddef>
#include <cstring>
#include <string_view>

namespace torse::cli {
namespace {

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

int visit(dl_phdr_info* object, std::size_t, void* result) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = object->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + header.p_vaddr);
    const std::string id = id_among({notes, header.p_memsz});
    if (!id.empty()) *static_cast<std::string*>(result) = id;
  }
  return 1;  // the first object only
}

}  // namespace

std::string id_among(std::string_view notes) {
  constexpr std::string_view owner("GNU", 4);
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof note);
    const std::size_t name = padded(note.n_namesz);
    const std::size_t whole = sizeof note + name + padded(note.n_descsz);
    if (whole > notes.size()) break;
    if (note.n_type == NT_GNU_BUILD_ID && notes.substr(sizeof note, note.n_namesz) == owner) {
      std::string digits;
      for (const char c : notes.substr(sizeof note + name, note.n_descsz)) {
        digits += fmt::format("{:02x}", static_cast<unsigned char>(c));
      }
      return digits;
    }
    notes.remove_prefix(whole);
  }
  return "";
}

std::string build_id() {
  std::string id = "unknown";
  dl_iterate_phdr(visit, &id);
  return id;
}

}  // namespace torse::cli
