// Whole nets of ruled surfaces that know their true verdict and class.
//   Net<D>                        control rows c, d over one knot list, and what is known of them; D = 3: points,
//                                 D = 4: rows w (1, x)
//   draw_net                      polynomial
//   draw_rational_net             with weights, none of them 0
//   draw_row_net                  with weights that may be 0
//   draw_developable_net, draw_developable_rational_net
//   add_net_labels                what a net is, as labels
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// A net and the truth about it. That it is developable holds by construction (draw/classes.hpp), that it is not is
/// proved by a determinant at a parameter, and the class of a developable one is decided by plain/truth.hpp.
template <int D>
struct Net {
  KnotList<Rational> knots = bezier_knots<Rational>(1);
  std::vector<Vec<Rational, D>> c{};
  std::vector<Vec<Rational, D>> d{};
  bool developable = true;
  /// The word of src/developable/classify.hpp: "plane", "cylinder", "cone", "tangent", "none".
  std::string klass{};
  /// How it was made: "plane", "cylinder", "cone", "linear", "edge", "joined", "curve", "line", "free".
  std::string made{};
  /// k of a near-miss: some coordinates were moved by about 2^-k of their size; 0 for others.
  int miss = 0;
  /// The vertex of a cone or the direction of a cylinder as a homogeneous row, up to a factor.
  std::optional<Row4> common{};
  /// Lambda*, M*, sigma where they are constants by construction: p[.., Lambda*] = sigma q[.., M*] on all pieces.
  std::optional<Functions> functions{};
  /// How it was rewritten since (draw/disguise.hpp): words joined by '+', or nothing.
  std::string disguise{};

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("knots", in.knots);
    visit("c", in.c);
    visit("d", in.d);
    visit("developable", in.developable);
    visit("class", in.klass);
    visit("made", in.made);
    visit("miss", in.miss);
    visit("common", in.common);
    visit("functions", in.functions);
    visit("disguise", in.disguise);
  }
};

/// Any net: developable, nearly so or not at all.
Net<3> draw_net(Choices& choices, const Scale& scale);
/// The same with weights, none of them 0: what a file can hold.
Net<4> draw_rational_net(Choices& choices, const Scale& scale);
/// The same where weights may be 0.
Net<4> draw_row_net(Choices& choices, const Scale& scale);

Net<3> draw_developable_net(Choices& choices, const Scale& scale);
Net<4> draw_developable_rational_net(Choices& choices, const Scale& scale);

/// The same surface in homogeneous rows.
Net<4> with_weights(const Net<3>& net);

/// The weights of both rows.
std::vector<Rational> weights_of(const Net<4>& net);

/// "class", "made", "degree", "pieces", "knots" (knot_kind), "polygon" (polygon_kind of c, where it has points),
/// "weights" (weight_kind), "miss" (by how many bits),
/// "disguise" (each, or "none").
void add_net_labels(Labels& labels, const Net<3>& net);
void add_net_labels(Labels& labels, const Net<4>& net);

}  // namespace torse::fuzz
