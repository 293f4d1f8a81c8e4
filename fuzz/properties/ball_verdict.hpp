// verdict.balls: balls and intervals may leave open what is true but never deny it.
#pragma once

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct BallVerdict {
  using In = Net<4>;
  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
