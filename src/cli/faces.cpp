// Reading the faces of a file and choosing one of them.
#include "torse/cli/faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
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
  for (const Face& face : faces) {
    if (face.number > most_listed) return text + ", ...";
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", face.number, in_quotes(face.name));
  }
  return text;
}

}  // namespace

std::string name_of_file(const std::string& file) {
  return printable(file == "-" ? file : std::filesystem::path(file).stem().string());
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

std::vector<std::string> words_of(const Face& face) {
  return words_of(face.file, face.of > 1 ? std::to_string(face.number) : "");
}

std::vector<Face> read_faces(const std::string& file, const std::string& choice) {
  std::vector<Face> faces = all_faces(file);
  if (choice.empty()) return faces;
  const auto named = [&](const Face& face) { return face.name == printable(choice); };
  const auto numbered = [&](const Face& face) { return std::to_string(face.number) == choice; };
  std::vector<Face> chosen;
  std::ranges::copy_if(faces, std::back_inserter(chosen), named);
  if (chosen.empty()) std::ranges::copy_if(faces, std::back_inserter(chosen), numbered);
  if (chosen.empty()) {
    throw FileError(file,
                    fmt::format("expected a face {}, found {}: {}", in_quotes(choice),
                                faces.size() == 1 ? "one face" : fmt::format("{} faces", faces.size()), listed(faces)));
  }
  return chosen;
}

}  // namespace torse::cli
