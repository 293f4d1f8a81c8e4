// A construction in another arithmetic beside the exact one.
//   require_agreement      the same surface, number by number, and developable there
#pragma once

#include "torse/developable/condition.hpp"
#include "torse/fuzz/properties/construction.hpp"

namespace torse::fuzz {

/// Throws Failed unless `agrees(x, y)` for every number x of the surface and y of the exact one.
template <class S, class Agrees>
void require_same_numbers(const SurfaceOver<S>& surface, const SurfaceOver<Rational>& exact, const Agrees& agrees) {
  require(surface.knots.size() == exact.knots.size(), "another number of knots");
  for (int i = 0; i < exact.knots.size(); ++i) require(agrees(surface.knots[i], exact.knots[i]), "another knot");
  for (std::size_t i = 0; i < exact.c.size(); ++i) {
    for (int j = 0; j < 4; ++j) {
      require(agrees(surface.c[i][j], exact.c[i][j]), "another coordinate of the first row");
      require(agrees(surface.d[i][j], exact.d[i][j]), "another coordinate of the second row");
    }
  }
}

/// Throws Failed if a coefficient of a determinant is not zero.
template <class S>
void require_no_witness(const SurfaceOver<S>& surface) {
  for (const int k : surface.knots.proper_pieces()) {
    const BinaryForm<S> det = span_determinant<S>(surface.knots, surface.c_row(), surface.d_row(), k);
    require(!det.first_nonzero(), "a coefficient of the determinant is not zero");
  }
}

}  // namespace torse::fuzz
