// Linear systems over an exact field, equation by equation.
//   RowEchelon<S, Row>   the reduced row echelon form of any kind of rows
//   Echelon<S, D>        homogeneous systems with D unknowns: insert, rank, kernel
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

/// Whether an entry that would decide a pivot is zero. Throws Undecided where it is neither zero nor not.
template <Field S>
bool no_pivot(const S& entry) {
  const Truth zero = is_zero(entry);
  if (zero == Truth::unknown) throw Undecided("linear system: a pivot is neither zero nor not");
  return definitely(zero);
}

/// Entry j of a row.
template <Field S, int D>
const S& entry_of(const Vec<S, D>& row, int j) {
  return row[j];
}

/// The position of a row's pivot: its first entry that is not zero.
template <Field S, int D>
std::optional<int> pivot_of(const Vec<S, D>& row) {
  for (int j = 0; j < D; ++j) {
    if (!no_pivot(S(row[j]))) return j;
  }
  return std::nullopt;
}

/// The row space of the rows so far in reduced row echelon form: every kept row is 1 at its pivot, where all others are
/// 0. A Row has add_scaled, divide, entry_of(row, j) and pivot_of(row).
template <Field S, class Row>
class RowEchelon {
 public:
  struct Kept {
    Row row;
    int pivot;
  };

  /// Adds a row; nothing if it is independent of the ones before, else what remains of it: zeros, and whatever the row
  /// carries along.
  std::optional<Row> insert(Row row) {
    for (const Kept& known : kept_) {
      const S factor = entry_of(row, known.pivot);
      if (!definitely(is_zero(factor))) add_scaled(row, -factor, known.row);
    }
    const std::optional<int> pivot = pivot_of(row);
    if (!pivot) return row;
    divide(row, S(entry_of(row, *pivot)));
    for (Kept& known : kept_) {
      const S factor = entry_of(known.row, *pivot);
      if (!definitely(is_zero(factor))) add_scaled(known.row, -factor, row);
    }
    kept_.push_back({std::move(row), *pivot});
    return std::nullopt;
  }

  const std::vector<Kept>& kept() const { return kept_; }

  bool is_pivot(int j) const {
    for (const Kept& known : kept_) {
      if (known.pivot == j) return true;
    }
    return false;
  }

 private:
  std::vector<Kept> kept_;
};

/// The row space of vectors with D coordinates, kept in reduced row echelon form.
template <Field S, int D>
class Echelon {
 public:
  /// Adds the equation row . x = 0; true if it is independent of the ones before. Throws Undecided where an entry that
  /// decides a pivot is neither zero nor not.
  bool insert(Vec<S, D> row) { return !rows_.insert(std::move(row)); }

  /// The number of independent equations.
  int rank() const { return static_cast<int>(rows_.kept().size()); }

  /// A basis of the solutions: one vector for each coordinate without a pivot, 1 there and 0 in the other such ones.
  std::vector<Vec<S, D>> kernel() const {
    std::vector<Vec<S, D>> basis;
    for (int free = 0; free < D; ++free) {
      if (rows_.is_pivot(free)) continue;
      Vec<S, D> x = PointTraits<Vec<S, D>>::zero();
      x[free] = from_int<S>(1);
      for (const auto& known : rows_.kept()) x[known.pivot] = -known.row[free];
      basis.push_back(std::move(x));
    }
    return basis;
  }

 private:
  RowEchelon<S, Vec<S, D>> rows_;
};

}  // namespace torse
