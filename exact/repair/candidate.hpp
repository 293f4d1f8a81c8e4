// What a family of developable nets offers: its distance, and an exact net about there.
//   RelationConstants  L*, M*, sigma
//   Candidate<D>       squared distance, realise
//   Accuracy           how much further an exact net with shorter numbers may be
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "torse/exact/repair/descent.hpp"
#include "torse/exact/repair/frame.hpp"

namespace torse::repair {

/// The constants of FJ07.13 and FJ21.7.1 between two knots; sigma is 1 for points.
struct RelationConstants {
  Rational from;
  Rational to;
  Rational lambda;
  Rational m;
  Rational sigma;
};

/// The nearest net of a family. It refers to the net that it was made for, and to the knots.
template <int D>
struct Candidate {
  Real squared;                                         ///< its squared distance
  std::function<std::optional<ExactNet<D>>()> realise;  ///< an exact member of the family at nearly this distance
  std::vector<RelationConstants> constants{};           ///< of the exact member, if the family has such constants
  bool converged = true;                                ///< false where the search for the constants was not finished
};

/// Shares of a squared distance f of a net of `count` points. The exact constants may add f / 2^8. The points of the
/// nearest net for them are rounded, each by less than 2^-5 sqrt(f / count): where the nearest net is the orthogonal
/// projection of the given one, this adds less than f / 2^10. Together, less than 1 % of the root mean square.
class Accuracy {
 public:
  Accuracy(const Real& squared, std::size_t count)
      : squared_(std::max(squared, negligible_distance())),
        exponent_(exponent_of((squared_ / Real(count)).square_root()) - 6) {}

  /// The largest error of a constant whose error e adds weight * e^2 to f, if there are `constants` of them.
  Real tolerance(const Real& weight, std::size_t constants) const {
    return (squared_ / (Real(256) * std::max(weight, negligible_distance()))).square_root() / Real(constants);
  }

  /// Coordinates of a point are rounded to multiples of 2^exponent, or of 2^exponent times the root of its scale.
  long exponent() const { return exponent_; }
  long exponent(const Real& scale) const { return exponent_ + exponent_of(scale.square_root()) - 1; }

 private:
  Real squared_;
  long exponent_;
};

}  // namespace torse::repair
