// Scaling, the recursion of Cox and de Boor, and Laplace's expansion in integers.
#include "torse/exact/decide/evaluation.hpp"

#include <utility>

namespace torse {
namespace {

/// r = a b - c d.
void set_minor(Integer& r, const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  mpz_mul(r.get(), a.get(), b.get());
  mpz_submul(r.get(), c.get(), d.get());
}

bool singular(const std::array<std::array<Integer, 3>, 3>& m) {
  Integer sum, minor;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const std::size_t l = (j + 2) % 3;
    set_minor(minor, m[1][k], m[2][l], m[1][l], m[2][k]);
    mpz_addmul(sum.get(), m[0][j].get(), minor.get());
  }
  return mpz_sgn(sum.get()) == 0;
}

bool singular(const std::array<std::array<Integer, 4>, 4>& m) {
  // The pairs of columns in the order of their signs + - + + - +; the i-th and the (5-i)-th are complementary.
  constexpr std::array<std::array<std::size_t, 2>, 6> pairs{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  Integer sum, top, low;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [a, b] = pairs[i];
    const auto [c, d] = pairs[5 - i];
    set_minor(top, m[0][a], m[1][b], m[0][b], m[1][a]);
    set_minor(low, m[2][c], m[3][d], m[2][d], m[3][c]);
    if (i == 1 || i == 4) {
      mpz_submul(sum.get(), top.get(), low.get());
    } else {
      mpz_addmul(sum.get(), top.get(), low.get());
    }
  }
  return mpz_sgn(sum.get()) == 0;
}

}  // namespace

template <int D>
PieceEvaluator<D>::PieceEvaluator(int degree, const std::vector<Integer>& knots, std::span<const Vec<Rational, D>> c,
                                  std::span<const Vec<Rational, D>> d, int k)
    : degree_(static_cast<std::size_t>(degree)),
      knots_(knots),
      end_(degree_ + static_cast<std::size_t>(k) - 1),
      basis_(degree_),
      next_(degree_) {
  const std::size_t first = static_cast<std::size_t>(k - 1);
  for (std::size_t level = 1; level <= degree_; ++level) factors_.push_back(level_factors(level));
  insert_ends(scaled_points(c.subspan(first, degree_ + 1), d.subspan(first, degree_ + 1)));
}

/// K / (v_hi - v_lo) for the differences of a level and a common multiple K of them.
template <int D>
std::vector<Integer> PieceEvaluator<D>::level_factors(std::size_t level) const {
  std::vector<Integer> factors(level);
  Integer multiple(1);
  for (std::size_t i = 0; i < level; ++i) {
    mpz_sub(factors[i].get(), knot(0, i).get(), knot(level, i).get());
    make_multiple(multiple.get(), factors[i].get());
  }
  for (Integer& factor : factors) mpz_divexact(factor.get(), multiple.get(), factor.get());
  return factors;
}

/// The n+1 control points of c, then those of d, every column times its common denominator.
template <int D>
auto PieceEvaluator<D>::scaled_points(std::span<const Vec<Rational, D>> c, std::span<const Vec<Rational, D>> d) const
    -> std::vector<Row> {
  std::vector<Row> points(2 * (degree_ + 1));
  for (std::size_t j = 0; j < size; ++j) {
    const auto coordinate = [&](std::size_t i) {
      return (i <= degree_ ? c[i] : d[i - degree_ - 1])[static_cast<Eigen::Index>(j)].mpq();
    };
    Integer common(1);
    for (std::size_t i = points.size(); i-- > 0;) {  // denominators tend to grow along the second row
      make_multiple(common.get(), mpq_denref(coordinate(i)));
    }
    const bool integral = mpz_cmp_ui(common.get(), 1) == 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      mpz_ptr x = points[i][j].get();
      if (integral) {
        mpz_set(x, mpq_numref(coordinate(i)));
      } else {
        mpz_divexact(x, common.get(), mpq_denref(coordinate(i)));
        mpz_mul(x, x, mpq_numref(coordinate(i)));
      }
    }
  }
  return points;
}

/// The polygons of c[.., a], c[.., b], d[.., a], d[.., b]; for points, the first one subtracted from the others.
template <int D>
void PieceEvaluator<D>::insert_ends(const std::vector<Row>& points) {
  const std::vector<Integer>& factors = factors_.back();
  const auto inserted = [&](std::size_t row, const Integer& x) {
    std::vector<Row> polygon(degree_);
    Integer left, right;
    for (std::size_t i = 0; i < degree_; ++i) {
      const std::size_t at = row * (degree_ + 1) + i;
      mpz_sub(left.get(), knot(0, i).get(), x.get());
      mpz_mul(left.get(), left.get(), factors[i].get());
      mpz_sub(right.get(), x.get(), knot(degree_, i).get());
      mpz_mul(right.get(), right.get(), factors[i].get());
      for (std::size_t j = 0; j < size; ++j) {
        mpz_mul(polygon[i][j].get(), left.get(), points[at][j].get());
        mpz_addmul(polygon[i][j].get(), right.get(), points[at + 1][j].get());
      }
    }
    return polygon;
  };
  const Integer& a = knots_[end_ - 1];
  const Integer& b = knots_[end_];
  std::array<std::vector<Row>, 4> all{inserted(0, a), inserted(0, b), inserted(1, a), inserted(1, b)};
  if constexpr (D == 3) {
    for (std::size_t row = 1; row < 4; ++row) {
      for (std::size_t i = 0; i < degree_; ++i) {
        for (std::size_t j = 0; j < 3; ++j) mpz_sub(all[row][i][j].get(), all[row][i][j].get(), all[0][i][j].get());
      }
      polygons_[row - 1] = std::move(all[row]);
    }
  } else {
    polygons_ = std::move(all);
  }
}

/// The values at x of the n basis functions of degree n-1 on the piece, up to a common factor (compare basis_forms).
template <int D>
void PieceEvaluator<D>::evaluate_basis(const Integer& x) {
  Integer difference;
  mpz_set_ui(basis_[0].get(), 1);
  for (std::size_t level = 1; level < degree_; ++level) {
    for (std::size_t i = 0; i <= level; ++i) mpz_set_ui(next_[i].get(), 0);
    for (std::size_t i = 0; i < level; ++i) {
      mpz_mul(basis_[i].get(), basis_[i].get(), factors_[level - 1][i].get());
      mpz_sub(difference.get(), knot(0, i).get(), x.get());
      mpz_addmul(next_[i].get(), difference.get(), basis_[i].get());
      mpz_sub(difference.get(), x.get(), knot(level, i).get());
      mpz_mul(next_[i + 1].get(), difference.get(), basis_[i].get());
    }
    std::swap(basis_, next_);
  }
}

template <int D>
bool PieceEvaluator<D>::vanishes_at(const Integer& x) {
  evaluate_basis(x);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t j = 0; j < size; ++j) {
      mpz_ptr entry = matrix_[row][j].get();
      mpz_set_ui(entry, 0);
      for (std::size_t i = 0; i < degree_; ++i) mpz_addmul(entry, basis_[i].get(), polygons_[row][i][j].get());
    }
  }
  return singular(matrix_);
}

template <int D>
bool PieceEvaluator<D>::vanishes() {
  Integer x, step;
  mpz_set(x.get(), knots_[end_ - 1].get());
  mpz_sub(step.get(), knots_[end_].get(), knots_[end_ - 1].get());
  for (std::size_t i = 0; i <= size * (degree_ - 1); ++i) {
    if (!vanishes_at(x)) return false;
    mpz_add(x.get(), x.get(), step.get());
  }
  return true;
}

template class PieceEvaluator<3>;
template class PieceEvaluator<4>;

}  // namespace torse
