// text.refused: files with one thing wrong with them.
#pragma once

#include "torse/fuzz/draw/damage.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct RefusedFile {
  struct In {
    std::string type;  ///< which reader is asked
    std::string damage;
    Bytes text;
    std::string place;
    std::optional<int> line;  ///< with column, where it is known: 0 for errors of the file as a whole
    std::optional<int> column;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("type", in.type);
      visit("damage", in.damage);
      visit("text", in.text);
      visit("place", in.place);
      visit("line", in.line);
      visit("column", in.column);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
