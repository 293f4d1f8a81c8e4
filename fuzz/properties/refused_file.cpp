#include "torse/fuzz/properties/refused_file.hpp"

#include "torse/fuzz/properties/file_meaning.hpp"

namespace torse::fuzz {

const PropertyInfo& RefusedFile::info() {
  static const PropertyInfo info{
      "text.refused",
      "a file with one thing wrong with it is refused with an error that names the place, its line and its column",
      40,
      {"damage=version",         "damage=type",
       "damage=missing key",     "damage=unknown key",
       "damage=wrong type",      "damage=degree",
       "damage=bad number",      "damage=weight zero",
       "damage=weight count",    "damage=coordinate count",
       "damage=point count",     "damage=knot count",
       "damage=knot decreasing", "damage=knot multiplicity",
       "damage=construction",    "damage=literal",
       "damage=duplicate key",   "damage=cut",
       "damage=trailing",        "damage=punctuation",
       "damage=string bytes",    "damage=depth"}};
  return info;
}

RefusedFile::In RefusedFile::draw(Choices& choices, const Scale& scale, Labels& labels) {
  DamagedFile file = draw_damaged_file(choices, scale, labels);
  In in{file.type, file.damage, {file.text}, file.place, std::nullopt, std::nullopt};
  if (file.at) {
    in.line = file.at->line;
    in.column = file.at->column;
  }
  return in;
}

void RefusedFile::check(const In& in, Labels&) {
  try {
    const Document document("file", in.text.text);
    meaning_of<Rational>(document, in.type);
  } catch (const FileError& error) {
    require(error.file() == "file", "the error names another file");
    require(error.place() == in.place, "the error names another place");
    require(!error.reason().empty(), "the error has no reason");
    if (!in.line) return;
    require(static_cast<int>(error.line()) == *in.line, "the error names another line");
    require(static_cast<int>(error.column()) == *in.column, "the error names another column");
    return;
  }
  throw Failed("the file is accepted");
}

}  // namespace torse::fuzz
