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

/// The description of the note in a segment of notes, in hexadecimal digits; empty for none.
std::string id_among(const char* notes, std::size_t size) {
  constexpr std::string_view owner("GNU", 4);
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes, sizeof note);
    const std::size_t name = padded(note.n_namesz);
    const std::size_t whole = sizeof note + name + padded(note.n_descsz);
    if (whole > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && std::string_view(notes + sizeof note, note.n_namesz) == owner) {
      std::string digits;
      for (std::size_t i = 0; i < note.n_descsz; ++i) {
        digits += fmt::format("{:02x}", static_cast<unsigned char>(notes[sizeof note + name + i]));
      }
      return digits;
    }
    notes += whole;
    size -= whole;
  }
  return "";
}

int visit(dl_phdr_info* object, std::size_t, void* result) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = object->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + header.p_vaddr);
    const std::string id = id_among(notes, header.p_memsz);
    if (!id.empty()) *static_cast<std::string*>(result) = id;
  }
  return 1;  // the first object only
}

}  // namespace

std::string build_id() {
  std::string id = "unknown";
  dl_iterate_phdr(visit, &id);
  return id;
}

}  // namespace torse::cli
