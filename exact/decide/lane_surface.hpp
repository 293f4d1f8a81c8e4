// A ruled surface modulo several primes, and the determinants of its pieces there without a division.
//   LaneSurface<D>      D = 3: points of a polynomial surface, D = 4: homogeneous rows
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/exact/decide/integer.hpp"
#include "torse/exact/decide/prime_lanes.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse {

/// The residues of a surface over Q modulo the primes of a block. Instead of dividing, the points' coordinates and the
/// basis functions are multiplied by the other denominators. So the determinant is an integer form times a factor that
/// is not zero over Q, and is a unit in the lanes said to be valid: a coefficient that vanishes there does so modulo
/// the prime, and one that does not vanish in any lane is not zero.
template <int D>
class LaneSurface {
 public:
  /// The degree n, the knots as integers and the control points c_0..c_L, d_0..d_L.
  LaneSurface(const PrimeLanes& field, int degree, const std::vector<Integer>& knots,
              std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d);

  /// The determinant of piece k as a form of degree D(n-1), up to a factor, a unit in each lane of `valid`.
  struct Determinant {
    std::vector<Lanes> coefficients;
    LaneSet valid;
  };
  Determinant determinant(int k) const;

 private:
  static constexpr std::size_t columns = static_cast<std::size_t>(D);
  using Form = std::vector<Lanes>;
  using Curves = std::array<std::array<Form, columns>, 2>;
  using Matrix = std::array<std::array<Form, columns>, columns>;

  void encode_column(std::size_t j, std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d,
                     const std::vector<Lanes>& powers);
  LaneSet clear_denominators(std::vector<Lanes>& numerators, const std::vector<Lanes>& denominators) const;
  std::vector<Form> basis(int k, LaneSet& valid) const;
  Curves curves(int k, LaneSet& valid) const;
  Matrix matrix(const Curves& curves) const;
  Form derivative_s(const Form& f) const;
  Form derivative_t(const Form& f) const;
  Form difference(Form f, const Form& g) const;
  void add_product(Form& h, const Form& f, const Form& g) const;
  void subtract_product(Form& h, const Form& f, const Form& g) const;
  Form minor(const Form& a, const Form& b, const Form& c, const Form& d) const;
  Form determinant_of(const Matrix& m) const;

  const PrimeLanes& field_;
  std::size_t degree_;
  LaneSet valid_ = all_lanes;
  std::vector<Lanes> knots_;
  std::vector<Lanes> small_;                             // 0 ... n
  std::array<std::vector<Lanes>, columns> coordinates_;  // c_0..c_L, then d_0..d_L
};

extern template class LaneSurface<3>;
extern template class LaneSurface<4>;

}  // namespace torse
