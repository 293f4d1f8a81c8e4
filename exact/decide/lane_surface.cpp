// Residues of the points, the recursion of Cox and de Boor, and Laplace's expansion, all modulo several primes.
#include "torse/exact/decide/lane_surface.hpp"

#include <algorithm>
#include <utility>

namespace torse {

template <int D>
LaneSurface<D>::LaneSurface(const PrimeLanes& field, int degree, const std::vector<Integer>& knots,
                            std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d)
    : field_(field), degree_(static_cast<std::size_t>(degree)) {
  std::size_t limbs = 0;
  for (const Integer& v : knots) limbs = std::max(limbs, mpz_size(v.get()));
  for (const auto& row : {c, d}) {
    for (const Vec<Rational, D>& point : row) {
      for (const Rational& x : point) {
        limbs = std::max({limbs, mpz_size(mpq_numref(x.mpq())), mpz_size(mpq_denref(x.mpq()))});
      }
    }
  }
  const std::vector<Lanes> powers = field_.powers(limbs);
  knots_.reserve(knots.size());
  for (const Integer& v : knots) knots_.push_back(field_.integer(v.get(), powers));
  for (std::size_t i = 0; i <= degree_; ++i) small_.push_back(field_.word(i));
  for (std::size_t j = 0; j < columns; ++j) encode_column(j, c, d, powers);
}

template <int D>
void LaneSurface<D>::encode_column(std::size_t j, std::span<const Vec<Rational, D>> c,
                                   std::span<const Vec<Rational, D>> d, const std::vector<Lanes>& powers) {
  std::vector<Lanes>& numerators = coordinates_[j];
  numerators.reserve(c.size() + d.size());
  std::vector<Lanes> denominators;
  bool integral = true;
  for (const auto& row : {c, d}) {
    for (const Vec<Rational, D>& point : row) {
      const mpq_srcptr x = point[static_cast<Eigen::Index>(j)].mpq();
      numerators.push_back(field_.integer(mpq_numref(x), powers));
      integral = integral && mpz_cmp_ui(mpq_denref(x), 1) == 0;
    }
  }
  if (integral) return;
  denominators.reserve(numerators.size());
  for (const auto& row : {c, d}) {
    for (const Vec<Rational, D>& point : row) {
      denominators.push_back(field_.integer(mpq_denref(point[static_cast<Eigen::Index>(j)].mpq()), powers));
    }
  }
  valid_ &= clear_denominators(numerators, denominators);
}

/// Multiplies each numerator by all denominators but its own. Returns the lanes where no denominator vanishes.
template <int D>
LaneSet LaneSurface<D>::clear_denominators(std::vector<Lanes>& numerators,
                                           const std::vector<Lanes>& denominators) const {
  Lanes before = field_.word(1);
  for (std::size_t i = 0; i < numerators.size(); ++i) {
    numerators[i] = field_.multiply(numerators[i], before);
    before = field_.multiply(before, denominators[i]);
  }
  Lanes after = field_.word(1);
  for (std::size_t i = numerators.size(); i-- > 0;) {
    numerators[i] = field_.multiply(numerators[i], after);
    after = field_.multiply(after, denominators[i]);
  }
  return PrimeLanes::nonzero(after);
}

/// The basis functions on piece k = [a, b] as forms in (s, t), the parameter being a s + b t (compare basis_forms).
template <int D>
auto LaneSurface<D>::basis(int k, LaneSet& valid) const -> std::vector<Form> {
  const std::size_t m = degree_ + static_cast<std::size_t>(k) - 2;
  const Lanes& a = knots_[m];
  const Lanes& b = knots_[m + 1];
  std::vector<Form> basis{Form{field_.word(1)}};
  for (std::size_t r = 1; r <= degree_; ++r) {
    std::vector<Lanes> factors(r, field_.word(1));
    std::vector<Lanes> lengths;
    for (std::size_t i = 0; i < r; ++i) lengths.push_back(field_.subtract(knots_[m + 1 + i], knots_[m + 1 + i - r]));
    valid &= clear_denominators(factors, lengths);
    std::vector<Form> next(r + 1, Form(r + 1, Lanes{}));
    for (std::size_t i = 0; i < r; ++i) {
      const Lanes& lo = knots_[m + 1 + i - r];
      const Lanes& hi = knots_[m + 1 + i];
      const Form until{field_.subtract(hi, a), field_.subtract(hi, b)};
      const Form from{field_.subtract(a, lo), field_.subtract(b, lo)};
      for (Lanes& x : basis[i]) x = field_.multiply(x, factors[i]);
      add_product(next[i], until, basis[i]);
      add_product(next[i + 1], from, basis[i]);
    }
    basis = std::move(next);
  }
  return basis;
}

/// The coordinate forms of both rows on piece k.
template <int D>
auto LaneSurface<D>::curves(int k, LaneSet& valid) const -> Curves {
  const std::vector<Form> functions = basis(k, valid);
  Curves result;
  for (std::size_t row = 0; row < 2; ++row) {
    const std::size_t first = static_cast<std::size_t>(k - 1) + row * (coordinates_[0].size() / 2);
    for (std::size_t j = 0; j < columns; ++j) result[row][j].assign(degree_ + 1, Lanes{});
    for (std::size_t i = 0; i <= degree_; ++i) {
      for (std::size_t power = 0; power <= degree_; ++power) {
        const Lanes& value = functions[i][power];
        if (PrimeLanes::nonzero(value) == 0) continue;
        for (std::size_t j = 0; j < columns; ++j) {
          field_.add_product(result[row][j][power], value, coordinates_[j][first + i]);
        }
      }
    }
  }
  return result;
}

template <int D>
auto LaneSurface<D>::derivative_s(const Form& f) const -> Form {
  Form g(degree_);
  for (std::size_t i = 0; i < degree_; ++i) g[i] = field_.multiply(f[i], small_[degree_ - i]);
  return g;
}

template <int D>
auto LaneSurface<D>::derivative_t(const Form& f) const -> Form {
  Form g(degree_);
  for (std::size_t i = 0; i < degree_; ++i) g[i] = field_.multiply(f[i + 1], small_[i + 1]);
  return g;
}

template <int D>
auto LaneSurface<D>::difference(Form f, const Form& g) const -> Form {
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = field_.subtract(f[i], g[i]);
  return f;
}

/// The matrix of span_matrix: rows of first partial derivatives.
template <int D>
auto LaneSurface<D>::matrix(const Curves& curves) const -> Matrix {
  Matrix m;
  for (std::size_t j = 0; j < columns; ++j) {
    Form c_s = derivative_s(curves[0][j]);
    Form c_t = derivative_t(curves[0][j]);
    Form d_s = derivative_s(curves[1][j]);
    Form d_t = derivative_t(curves[1][j]);
    if constexpr (D == 3) {
      m[0][j] = difference(std::move(c_t), c_s);
      m[1][j] = difference(std::move(d_s), c_s);
      m[2][j] = difference(std::move(d_t), c_s);
    } else {
      m[0][j] = std::move(c_s);
      m[1][j] = std::move(c_t);
      m[2][j] = std::move(d_s);
      m[3][j] = std::move(d_t);
    }
  }
  return m;
}

template <int D>
void LaneSurface<D>::add_product(Form& h, const Form& f, const Form& g) const {
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) field_.add_product(h[i + j], f[i], g[j]);
  }
}

template <int D>
void LaneSurface<D>::subtract_product(Form& h, const Form& f, const Form& g) const {
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) field_.subtract_product(h[i + j], f[i], g[j]);
  }
}

template <int D>
auto LaneSurface<D>::minor(const Form& a, const Form& b, const Form& c, const Form& d) const -> Form {
  Form h(a.size() + d.size() - 1, Lanes{});
  add_product(h, a, d);
  subtract_product(h, b, c);
  return h;
}

template <int D>
auto LaneSurface<D>::determinant_of(const Matrix& m) const -> Form {
  Form det(columns * (degree_ - 1) + 1, Lanes{});
  if constexpr (D == 3) {
    add_product(det, m[0][0], minor(m[1][1], m[1][2], m[2][1], m[2][2]));
    subtract_product(det, m[0][1], minor(m[1][0], m[1][2], m[2][0], m[2][2]));
    add_product(det, m[0][2], minor(m[1][0], m[1][1], m[2][0], m[2][1]));
  } else {
    const auto top = [&](std::size_t i, std::size_t j) { return minor(m[0][i], m[0][j], m[1][i], m[1][j]); };
    const auto low = [&](std::size_t i, std::size_t j) { return minor(m[2][i], m[2][j], m[3][i], m[3][j]); };
    add_product(det, top(0, 1), low(2, 3));
    subtract_product(det, top(0, 2), low(1, 3));
    add_product(det, top(0, 3), low(1, 2));
    add_product(det, top(1, 2), low(0, 3));
    subtract_product(det, top(1, 3), low(0, 2));
    add_product(det, top(2, 3), low(0, 1));
  }
  return det;
}

template <int D>
auto LaneSurface<D>::determinant(int k) const -> Determinant {
  LaneSet valid = valid_;
  Form coefficients = determinant_of(matrix(curves(k, valid)));
  return {std::move(coefficients), valid};
}

template class LaneSurface<3>;
template class LaneSurface<4>;

}  // namespace torse
