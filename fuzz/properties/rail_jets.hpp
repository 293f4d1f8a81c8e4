// rails.jets: a rail in doubles and its three derivatives, on numbers of which no operation is rounded.
#pragma once

#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

struct RailJets {
  /// On each piece the rail is the polynomial `points` of the share y of the piece, by its coefficients of 1, y, y^2,
  /// ..., its weight `weights` likewise. All numbers are small
  /// enough for no operation to be rounded: points are multiples of 12.
  struct In {
    std::vector<Rational> breaks{};                ///< 0 first, 1 last, pieces of 2^-k
    std::vector<std::vector<Point3>> points{};     ///< of each piece
    std::vector<std::vector<Rational>> weights{};  ///< of each piece, positive on it
    Rational share{};                              ///< of each piece, where derivatives are looked at

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("breaks", in.breaks);
      visit("points", in.points);
      visit("weights", in.weights);
      visit("share", in.share);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
