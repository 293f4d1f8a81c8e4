// The exact verdict on a ruled surface.
//   Judgement        verdict, class, witness
//   judge            whether it is developable, then the class
#pragma once

#include <optional>
#include <string>

#include "torse/developable/classify.hpp"
#include "torse/developable/condition.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// What is known of a surface. `witness` is there iff it is not developable.
struct Judgement {
  Classification<Rational> classification;
  std::optional<DevelopabilityWitness<Rational>> witness;

  bool developable() const { return !witness.has_value(); }
};

/// Decides a surface exactly: the affine determinant of degree 3(n-1) if all weights are 1, else the homogeneous one of
/// degree 4(n-1).
Judgement judge(const RuledFile<Rational>& surface);

/// The class in words, with its vertex or direction: "cone, vertex (0, 1/2, 3)".
std::string describe(const Classification<Rational>& classification);

}  // namespace torse::cli
