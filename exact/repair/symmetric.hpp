// Eigenvectors of small symmetric matrices in 256 bits.
//   Matrix              rows of Real
//   EigenPair, symmetric_eigen      by Jacobi's rotations
//   solve_positive      linear equations by Cholesky's method without square roots
#pragma once

#include <optional>
#include <vector>

#include "torse/exact/repair/real.hpp"

namespace torse::repair {

using Matrix = std::vector<std::vector<Real>>;

/// A square matrix of zeros.
Matrix zero_matrix(std::size_t size);

/// An eigenvalue with its eigenvector of length 1.
struct EigenPair {
  Real value;
  std::vector<Real> vector;
};

/// All eigenpairs of a symmetric matrix, the smallest value first.
std::vector<EigenPair> symmetric_eigen(Matrix a);

/// x with a x = b for a symmetric matrix; nothing unless it is positive definite in this arithmetic.
std::optional<std::vector<Real>> solve_positive(Matrix a, std::vector<Real> b);

}  // namespace torse::repair
