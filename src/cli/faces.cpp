// Reading the faces of a file and choosing one of them.
#include "torse/cli/faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include "torse/cli/cad_faces.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/document.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

/// As many faces as an error lists.
constexpr std::size_t most_listed = 12;

std::vector<Face> all_faces(const std::string& file) {
  std::string bytes = read_file(file);
  if (const std::optional<CadFormat> format = cad_format(file, bytes)) return cad_faces(file, *format, bytes);
  const Document document(file, std::move(bytes));
  RuledFile<Rational> surface = read_ruled<Rational>(document);
  require_effort(file, surface);
  return {Face{.file = file, .name = name_of_file(file), .surface = std::move(surface)}};
}

std::string listed(const std::vector<Face>& faces) {
  std::string text;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == most_listed) return text + ", ...";
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", faces[i].number, in_quotes(faces[i].name));
  }
  return text;
}

/// "3", or "3 strip 2".
std::string number_text(const Face& face) {
  return face.strip == 0 ? std::to_string(face.number) : fmt::format("{} strip {}", face.number, face.strip);
}

}  // namespace

std::string name_of_file(const std::string& file) {
  return printable(file == "-" ? file : std::filesystem::path(file).stem().string());
}

std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

std::string title_of(const Face& face) {
  return face.of > 1 ? printable(face.file) + ": " + face.name : printable(face.file);
}

void add_face_inputs(CLI::App& app, FaceInput& input, const std::string& what) {
  app.add_option("FILE", input.files, what + "; - is standard input")->required();
  app.add_option("--face", input.face, "only the face of this name or number")->type_name("NAME|NUMBER");
}

std::vector<std::string> words_of(const std::string& file, const std::string& choice) {
  std::vector<std::string> words;
  if (!choice.empty()) words = {"--face", choice};
  words.push_back(file_word(file));
  return words;
}

std::vector<std::string> words_of(const Face& face) { return words_of(face.file, face.choice); }

void set_choices(std::vector<Face>& faces) {
  std::map<std::string, int> names;
  std::map<std::size_t, int> numbers;
  for (Face& face : faces) {
    ++names[face.name];
    ++numbers[face.number];
    face.of = faces.size();
  }
  if (faces.size() == 1) return;
  for (Face& face : faces) {
    const std::string number = number_text(face);
    if (numbers[face.number] == 1 && !names.contains(number)) {
      face.choice = number;
    } else if (names[face.name] == 1) {
      face.choice = face.name;
    } else if (face.strip > 0 && !names.contains(number)) {
      face.choice = number;
    }
  }
}

std::vector<Face> chosen(const std::vector<Face>& faces, const std::string& choice) {
  const auto named = [&](const Face& face) { return face.name == printable(choice); };
  const auto numbered = [&](const Face& face) {
    return std::to_string(face.number) == choice || number_text(face) == choice;
  };
  std::vector<Face> list;
  std::ranges::copy_if(faces, std::back_inserter(list), named);
  if (list.empty()) std::ranges::copy_if(faces, std::back_inserter(list), numbered);
  return list;
}

std::vector<Face> read_faces(const std::string& file, const std::string& choice) {
  std::vector<Face> faces = all_faces(file);
  set_choices(faces);
  if (choice.empty()) return faces;
  std::vector<Face> list = chosen(faces, choice);
  if (list.empty()) {
    throw FileError(file,
                    fmt::format("expected a face {}, found {}: {}", in_quotes(choice),
                                faces.size() == 1 ? "one face" : fmt::format("{} faces", faces.size()), listed(faces)));
  }
  return list;
}

}  // namespace torse::cli
