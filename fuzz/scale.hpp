// How large the drawn things may be.
//   Scale           degree, pieces, digits          scale_of      that of an effort
//   lean            fewer digits for more numbers
#pragma once

#include <algorithm>

#include "torse/proofs/engines/engine.hpp"

namespace torse::fuzz {

/// The greatest degree, number of pieces and number of bits of a numerator or denominator that is drawn.
struct Scale {
  int degree = 3;
  int pieces = 3;
  int bits = 12;
};

/// The scale of an effort.
constexpr Scale scale_of(proofs::Effort effort) {
  if (effort == proofs::Effort::quick) return {3, 3, 12};
  if (effort == proofs::Effort::standard) return {5, 6, 40};
  return {9, 24, 300};
}

/// Exact results of `count` numbers have about count times their digits and as many terms, so that long lists get short
/// numbers: at most 4000/count^2 bits, but 8.
constexpr Scale lean(Scale scale, int count) {
  scale.bits = std::min(scale.bits, std::max(8, 4000 / (count * count)));
  return scale;
}

}  // namespace torse::fuzz
