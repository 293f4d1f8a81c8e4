// text.file: valid files in every layout.
#pragma once

#include "torse/fuzz/draw/file_text.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct FileText {
  struct In {
    Bytes text;
    FileMeant meant;
    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("text", in.text);
      visit("meant", in.meant);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
