// Jacobi's cyclic method; a sweep squares the size of what is off the diagonal.
#include "torse/exact/repair/symmetric.hpp"

#include <algorithm>
#include <utility>

namespace torse::repair {
namespace {

/// The rotation of coordinates p and q that makes a_pq zero, in its stable form (Golub and Van Loan, Matrix
/// Computations, 8.5.2).
void rotate(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q) {
  const Real half = (a[q][q] - a[p][p]) / (Real(2) * a[p][q]);
  const Real root = (Real(1) + half * half).square_root();
  const Real tangent = half < Real(0) ? Real(-1) / (root - half) : Real(1) / (root + half);
  const Real c = Real(1) / (Real(1) + tangent * tangent).square_root();
  const Real s = tangent * c;
  const auto mix = [&](Real& x, Real& y) {
    const Real old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (std::size_t i = 0; i < a.size(); ++i) mix(a[i][p], a[i][q]);
  for (std::size_t i = 0; i < a.size(); ++i) mix(a[p][i], a[q][i]);
  for (std::size_t i = 0; i < a.size(); ++i) mix(vectors[i][p], vectors[i][q]);
}

}  // namespace

Matrix zero_matrix(std::size_t size) { return Matrix(size, std::vector<Real>(size)); }

std::vector<EigenPair> symmetric_eigen(Matrix a) {
  const std::size_t size = a.size();
  Matrix vectors = zero_matrix(size);
  Real largest;
  for (std::size_t i = 0; i < size; ++i) {
    vectors[i][i] = Real(1);
    for (const Real& x : a[i]) largest = std::max(largest, magnitude(x));
  }
  const Real negligible = largest * Real::from_rational(power_of_two(-2 * Real::precision));
  constexpr int sweeps = 40;
  bool diagonal = false;
  for (int sweep = 0; sweep < sweeps && !diagonal; ++sweep) {
    diagonal = true;
    for (std::size_t p = 0; p < size; ++p) {
      for (std::size_t q = p + 1; q < size; ++q) {
        if (magnitude(a[p][q]) <= negligible) continue;
        diagonal = false;
        rotate(a, vectors, p, q);
      }
    }
  }
  std::vector<EigenPair> pairs;
  for (std::size_t k = 0; k < size; ++k) {
    pairs.push_back({a[k][k], {}});
    for (std::size_t i = 0; i < size; ++i) pairs.back().vector.push_back(vectors[i][k]);
  }
  std::sort(pairs.begin(), pairs.end(), [](const EigenPair& x, const EigenPair& y) { return x.value < y.value; });
  return pairs;
}

std::optional<std::vector<Real>> solve_positive(Matrix a, std::vector<Real> b) {
  const std::size_t size = a.size();
  for (std::size_t k = 0; k < size; ++k) {
    if (!(a[k][k] > Real(0))) return std::nullopt;
    for (std::size_t i = k + 1; i < size; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < size; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

}  // namespace torse::repair
