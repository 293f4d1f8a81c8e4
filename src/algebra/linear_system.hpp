// Homogeneous linear systems with few unknowns over an exact field, equation by equation.
//   Echelon<S, D>     the reduced row echelon form of the equations so far: insert, rank, kernel
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// The row space of vectors with D coordinates, kept in reduced row echelon form.
template <Field S, int D>
class Echelon {
 public:
  /// Adds the equation row . x = 0; true if it is independent of the ones before. Throws Undecided where an entry that
  /// decides a pivot is neither zero nor not.
  bool insert(Vec<S, D> row) {
    for (const Row& known : rows_) {
      const S factor = row[known.pivot];
      if (!definitely(is_zero(factor))) add_scaled(row, -factor, known.row);
    }
    for (int j = 0; j < D; ++j) {
      const Truth zero = is_zero(row[j]);
      if (zero == Truth::unknown) throw Undecided("linear system: a pivot is neither zero nor not");
      if (!definitely(zero)) {
        keep(std::move(row), j);
        return true;
      }
    }
    return false;
  }

  /// The number of independent equations.
  int rank() const { return static_cast<int>(rows_.size()); }

  /// A basis of the solutions: one vector for each coordinate without a pivot, 1 there and 0 in the other such ones.
  std::vector<Vec<S, D>> kernel() const {
    std::vector<Vec<S, D>> basis;
    for (int free = 0; free < D; ++free) {
      if (is_pivot(free)) continue;
      Vec<S, D> x = PointTraits<Vec<S, D>>::zero();
      x[free] = from_int<S>(1);
      for (const Row& known : rows_) x[known.pivot] = -known.row[free];
      basis.push_back(std::move(x));
    }
    return basis;
  }

 private:
  struct Row {
    Vec<S, D> row;
    int pivot;
  };

  void keep(Vec<S, D> row, int pivot) {
    divide(row, S(row[pivot]));
    for (Row& known : rows_) {
      const S factor = known.row[pivot];
      if (!definitely(is_zero(factor))) add_scaled(known.row, -factor, row);
    }
    rows_.push_back({std::move(row), pivot});
  }

  bool is_pivot(int j) const {
    for (const Row& known : rows_) {
      if (known.pivot == j) return true;
    }
    return false;
  }

  std::vector<Row> rows_;
};

}  // namespace torse
