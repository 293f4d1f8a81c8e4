// Developable nets of each class by constructions of a few lines, none of which is the library's.
//   Weights                        what weights are wanted
//   Draft, blend, cell_row         two control rows and what is known of them
//   draft_plane, draft_line        all points in a plane, on a line
//   draft_cylinder, draft_cone     rulings through a point that is chosen
//   draft_linear                   the cells of FJ21.7.1, one after the other
//   draft_edge                     tangents of a curve of degree n + 1 (FJ21.T6.1)
//   draft_curve                    d = c: rulings of length zero
//   draft_free                     anything, developable or not
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torse/fuzz/draw/parameters.hpp"
#include "torse/fuzz/draw/polygons.hpp"

namespace torse::fuzz {

/// All 1 (a polynomial surface), none 0, or any.
enum class Weights { one, nonzero, any };

/// Homogeneous control rows.
struct Draft {
  KnotList<Rational> knots;
  std::vector<Row4> p{};
  std::vector<Row4> q{};
  std::string made{};
  bool common_point = false;  ///< whether a point lies on all rulings by construction
  std::optional<Functions> functions{};
  std::string disguise{};  ///< see draw/disguise.hpp
};

/// Rows w (1, x) over points of any kind.
std::vector<Row4> draw_rows(Choices& choices, const Scale& scale, int count, Weights weights);

/// a x + b y.
Row4 blend(const Rational& a, const Row4& x, const Rational& b, const Row4& y);

/// The row q from q_0 by the cells of FJ21.7.1: (u_{i+n}-L*) p_i + (L*-u_i) p_{i+1} = sigma ((u_{i+n}-M*) q_i +
/// (M*-u_i) q_{i+1}) for i = 0..L-1.
std::vector<Row4> cell_row(const KnotList<Rational>& u, const std::vector<Row4>& p, const Functions& f, const Row4& q0);

/// Two nets of the plane z = 0 under an affine map.
Draft draft_plane(Choices& choices, const Scale& scale, Weights weights);
/// Points A + s v.
Draft draft_line(Choices& choices, const Scale& scale, Weights weights);
/// q_i = beta p_i + h_i (0, v); beta = 1 for polynomial surfaces.
Draft draft_cylinder(Choices& choices, const Scale& scale, Weights weights);
/// q_i = beta p_i + a_i (1, O); a_i = 1 - beta for polynomial surfaces.
Draft draft_cone(Choices& choices, const Scale& scale, Weights weights);
/// Any p, and q by cell_row. Where L* = M*, p - sigma q is a constant times (t-L*)^n, a point on all rulings.
Draft draft_linear(Choices& choices, const Scale& scale, Weights weights);
/// p = r + (M*-t)/(n+1) r', sigma q = r + (L*-t)/(n+1) r' for a spline r of degree n + 1.
Draft draft_edge(Choices& choices, const Scale& scale, Weights weights);
Draft draft_curve(Choices& choices, const Scale& scale, Weights weights);
Draft draft_free(Choices& choices, const Scale& scale, Weights weights);

}  // namespace torse::fuzz
