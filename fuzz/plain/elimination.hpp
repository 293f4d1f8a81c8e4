// Linear algebra over the rationals by the textbook.
//   Rows<D>      a growing list of vectors in echelon form: its rank and the vectors orthogonal to it
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::fuzz::plain {

/// The span of vectors, kept as a reduced echelon form.
template <int D>
class Rows {
 public:
  using Vector = Vec<Rational, D>;

  int rank() const { return static_cast<int>(rows_.size()); }

  /// Adds a vector to the span.
  void insert(Vector x) {
    for (const Pivoted& row : rows_) eliminate(x, row);
    int column = 0;
    while (column < D && x[column].sign() == 0) ++column;
    if (column == D) return;
    const Rational pivot = x[column];
    for (int j = 0; j < D; ++j) x[j] /= pivot;
    Pivoted added{column, std::move(x)};
    for (Pivoted& row : rows_) eliminate(row.vector, added);
    rows_.push_back(std::move(added));
  }

  /// A basis of the vectors orthogonal to all rows.
  std::vector<Vector> orthogonal() const {
    std::vector<Vector> basis;
    for (int free = 0; free < D; ++free) {
      Vector x;
      for (int j = 0; j < D; ++j) x[j] = Rational(j == free ? 1 : 0);
      bool pivot = false;
      for (const Pivoted& row : rows_) {
        pivot = pivot || row.column == free;
        x[row.column] = -row.vector[free];
      }
      if (!pivot) basis.push_back(std::move(x));
    }
    return basis;
  }

 private:
  struct Pivoted {
    int column;
    Vector vector;
  };

  static void eliminate(Vector& x, const Pivoted& row) {
    const Rational factor = x[row.column];
    if (factor.sign() == 0) return;
    for (int j = 0; j < D; ++j) x[j] -= factor * row.vector[j];
  }

  std::vector<Pivoted> rows_;
};

}  // namespace torse::fuzz::plain
