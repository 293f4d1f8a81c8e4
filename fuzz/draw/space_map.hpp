// Maps of space that keep developable surfaces developable.
//   SpaceMap         a 4 x 4 matrix for homogeneous rows, with its kind        identity_map
//   draw_motion      rotations, reflections, translations        draw_similarity   with a factor
//   draw_space_map   affine or projective ones too               determinant       of the matrix
#pragma once

#include <string>
#include <vector>

#include "torse/fuzz/draw/polygons.hpp"
#include "torse/fuzz/input_text.hpp"

namespace torse::fuzz {

/// x -> M x for rows x = w (1, point). An affine map has the first row (1, 0, 0, 0).
struct SpaceMap {
  std::string kind = "identity";
  std::vector<Row4> rows;

  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("kind", in.kind);
    visit("rows", in.rows);
  }

  Row4 operator()(const Row4& x) const;
  /// Of a point; for affine maps.
  Point3 operator()(const Point3& x) const;
};

SpaceMap identity_map();

/// A translation after a rotation, which is Cayley's of a rational skew-symmetric matrix; every fourth is a reflection
/// too. Lengths and angles stay.
SpaceMap draw_motion(Choices& choices, const Scale& scale);
/// The same with all lengths multiplied by one factor that is not 0.
SpaceMap draw_similarity(Choices& choices, const Scale& scale);
/// Any of these, an affine map or, if it may be, a projective one: invertible.
SpaceMap draw_space_map(Choices& choices, const Scale& scale, bool projective);

Rational determinant(const SpaceMap& map);

}  // namespace torse::fuzz
