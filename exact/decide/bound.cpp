// The bound of the header, computed from bit lengths.
#include "torse/exact/decide/bound.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace torse {
namespace {

/// Bits of W: the differences of level r are those of r neighbouring knots around piece k.
long basis_bits(const KnotList<Rational>& u, const std::vector<Integer>& v, int k) {
  const int m = u.degree() + k - 2;
  long bits = 0;
  Integer difference;
  for (int r = 1; r <= u.degree(); ++r) {
    Integer multiple(1);
    for (int i = 0; i < r; ++i) {
      mpz_sub(difference.get(), v[static_cast<std::size_t>(m + 1 + i)].get(),
              v[static_cast<std::size_t>(m + 1 + i - r)].get());
      make_multiple(multiple.get(), difference.get());
    }
    bits += bits_above(multiple.get());
  }
  return bits;
}

/// Bits of Q_j m_j.
template <int D>
long coordinate_bits(std::array<std::span<const Vec<Rational, D>>, 2> rows, int j) {
  Integer multiple(1);
  long largest = 0;  // m_j < 2^largest
  bool zero = true;
  for (const std::span<const Vec<Rational, D>> row : rows) {
    for (std::size_t i = row.size(); i-- > 0;) {  // denominators tend to grow along the second row
      const Rational& x = row[i][j];
      if (x.sign() == 0) continue;
      make_multiple(multiple.get(), mpq_denref(x.mpq()));
      const long bits = static_cast<long>(x.numerator_bits()) - static_cast<long>(x.denominator_bits()) + 1;
      largest = zero ? bits : std::max(largest, bits);
      zero = false;
    }
  }
  constexpr long never = std::numeric_limits<long>::min() / 16;
  return zero ? never : largest + bits_above(multiple.get());
}

}  // namespace

template <int D>
long determinant_bits(const KnotList<Rational>& u, const std::vector<Integer>& v, std::span<const Vec<Rational, D>> c,
                      std::span<const Vec<Rational, D>> d, int k) {
  const std::size_t first = static_cast<std::size_t>(k - 1);
  const std::size_t count = static_cast<std::size_t>(u.degree()) + 1;
  const long basis = basis_bits(u, v, k);
  long bits = D == 3 ? 3 : 5;  // 6 < 2^3, 24 < 2^5
  for (int j = 0; j < D; ++j) {
    bits += (D == 3 ? u.degree() : u.degree() - 1) + basis +
            coordinate_bits<D>({d.subspan(first, count), c.subspan(first, count)}, j);
  }
  return bits;
}

template long determinant_bits<3>(const KnotList<Rational>&, const std::vector<Integer>&,
                                  std::span<const Vec<Rational, 3>>, std::span<const Vec<Rational, 3>>, int);
template long determinant_bits<4>(const KnotList<Rational>&, const std::vector<Integer>&,
                                  std::span<const Vec<Rational, 4>>, std::span<const Vec<Rational, 4>>, int);

}  // namespace torse
