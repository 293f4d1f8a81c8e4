// rails: two curves brought to one degree and one knot list are the same two curves.
#pragma once

#include "torse/fuzz/draw/rails.hpp"

namespace torse::fuzz {

struct JoinedRails {
  using In = Rails;

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
