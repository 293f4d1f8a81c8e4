// verdict.truth, verdict.rational_truth: verdict, witness and class of nets that know theirs.
#pragma once

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// D = 3: polynomial nets, D = 4: homogeneous rows, weights 0 among them.
template <int D>
struct VerdictTruth {
  using In = Net<D>;

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
