// double.net: FJ07.13 in doubles, checked exactly at the cost of doubles.
#pragma once

#include "torse/fuzz/draw/doubles.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// The net that FJ07.13 computes in doubles is, within its running error, a developable one, and a net with one
/// coordinate moved is told from it: by a determinant whose bound excludes zero, or else exactly.
struct DoubleNetProperty {
  struct In {
    DoubleNet net;
    int piece = 1;       ///< where the determinant is taken
    double share = 0.5;  ///< of the piece
    int moved = -1;      ///< 3 i + j: coordinate j of d_i is moved; -1: none
    double shift = 0;    ///< relative to the coordinate, or absolute where that is zero
    bool exact = false;  ///< whether the exact answer is computed also where the bound decides

    template <class Self, class Visitor>
    static void fields(Self& in, Visitor& visit) {
      visit("net", in.net);
      visit("piece", in.piece);
      visit("share", in.share);
      visit("moved", in.moved);
      visit("shift", in.shift);
      visit("exact", in.exact);
    }
  };

  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);

  /// An input of this size.
  static In draw_sized(Choices& choices, int degree, int last, Labels& labels);
};

}  // namespace torse::fuzz
