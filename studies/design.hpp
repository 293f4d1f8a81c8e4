// Designs of experiment: what a study varies, and what it runs.
//   Factor, factor_names     the quantities that may vary
//   Levels                   a value of each of them
//   Design                   a study as its JSON file declares it
//   Block                    the part of a study's cases that a shard has
//   read_design, design_names, built_in_design
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "torse/proofs/engines/engine.hpp"

namespace torse::studies {

/// What may vary. Lengths are in units of the domain's length for knots and parameters, of the polygon's for points.
enum class Factor {
  degree,        ///< n
  pieces,        ///< N
  knot_ratio,    ///< the longest piece over the shortest
  before,        ///< M* lies so far before the first knot
  after,         ///< ... or so far behind the last one
  inside,        ///< ... or so far behind the knot in the middle of the domain
  gap,           ///< |L* - M*|
  weight_ratio,  ///< the largest weight over the smallest
  offset,        ///< how far the points are from the origin
  moved,         ///< how far a vertex of a developable net was moved (verdicts)
  scale,         ///< the size of that net (verdicts)
};
inline constexpr std::array<std::string_view, 11> factor_names{
    "degree", "pieces", "knot_ratio", "before", "after", "inside", "gap", "weight_ratio", "offset", "moved", "scale"};

/// A level of each factor. Of `before`, `after` and `inside` one is positive, the others are 0.
class Levels {
 public:
  /// One cubic with four pieces of like lengths, M* one length behind the domain.
  Levels() : values_{3, 4, 4, 0, 1, 0, 1, 4, 0, 0, 1} {}

  double operator[](Factor factor) const { return values_[static_cast<std::size_t>(factor)]; }
  double& operator[](Factor factor) { return values_[static_cast<std::size_t>(factor)]; }
  int degree() const { return static_cast<int>((*this)[Factor::degree]); }
  int pieces() const { return static_cast<int>((*this)[Factor::pieces]); }
  int last() const { return degree() + pieces() - 1; }

 private:
  std::array<double, factor_names.size()> values_;
};

/// A factor and the levels that a design gives it.
struct Variation {
  Factor factor;
  std::vector<double> levels;
};

/// The consecutive cases [begin, end): shard i of k has the i-th of k parts, so that the results of all shards, one
/// after the other, are those of the whole.
struct Block {
  std::size_t begin;
  std::size_t end;
};

/// A study.
struct Design {
  std::string name;
  std::string title;
  bool verdicts = false;              ///< tests of developability, not routes
  std::vector<std::string> subjects;  ///< routes, or tests
  std::vector<std::string> scalars;   ///< of routes
  std::vector<Variation> variations;
  std::array<int, 3> repetitions{};  ///< by effort
  std::uint64_t seed = 1;
  std::string text;  ///< of its file

  /// The combinations of levels, and the cases: every combination so many times.
  std::size_t combinations() const;
  std::size_t cases(proofs::Effort effort) const;
  /// The levels of a combination; the last variation varies fastest.
  Levels levels(std::size_t combination) const;
  /// The cases of shard `index` of `count`, from 0.
  Block block(proofs::Effort effort, std::size_t index, std::size_t count) const;
};

/// Reads a design. Throws FileError.
Design read_design(const std::string& file, const std::string& text);

/// The studies that are part of the program, in the order of their names.
std::vector<std::string> design_names();
/// One of them; throws Error for another name.
Design built_in_design(const std::string& name);

}  // namespace torse::studies
