// Pairs of curves as they come from files: of different degrees, over different knots and intervals.
//   Rail, Rails        a curve          two of them, and whether the ruled surface between them is known
//   draw_rails         any              as_spline        a rail for the library
#pragma once

#include "torse/fuzz/draw/net.hpp"
#include "torse/spline/curve.hpp"

namespace torse::fuzz {

/// A B-spline curve in homogeneous rows.
struct Rail {
  KnotList<Rational> knots = bezier_knots<Rational>(1);
  std::vector<Row4> rows{};

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("knots", in.knots);
    visit("rows", in.rows);
  }
};

/// Two curves. The ruled surface joins points whose parameters have equal places in the two domains.
struct Rails {
  Rail c{};
  Rail d{};
  /// The net that both are taken from, where there is one.
  std::optional<Net<4>> net{};

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("c", in.c);
    visit("d", in.d);
    visit("net", in.net);
  }
};

/// Two curves that have nothing to do with each other, or the rows of a net, each with knots and degree of its own and
/// d over another interval. No weight is 0.
Rails draw_rails(Choices& choices, const Scale& scale);

Spline<Rational, Row4> as_spline(const Rail& rail);

}  // namespace torse::fuzz
