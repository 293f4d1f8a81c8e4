// How large the drawn things may be.
//   Scale           degree, pieces, digits          scale_of      that of an effort
#pragma once

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

}  // namespace torse::fuzz
