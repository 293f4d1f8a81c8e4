// Which formula an operation belongs to, for scalars that keep a record of what is done to them.
//   FormulaScope<S>    names the formula, row and index that are computed while it lives; nothing for other scalars
#pragma once

#include <concepts>
#include <string_view>

#include "torse/scalar/traits.hpp"

namespace torse {

/// A scalar that keeps a record: `ScalarTraits<S>::enter(formula, row, index)` and `ScalarTraits<S>::leave()`.
template <class S>
concept RecordsFormulas = requires {
  ScalarTraits<S>::enter(std::string_view(), std::string_view(), 0);
  ScalarTraits<S>::leave();
};

/// While it lives, operations on S compute entry `index` of `row` by the formula with this claim id. For a scalar
/// without a record it is an empty object without any code.
template <class S>
class FormulaScope {
 public:
  FormulaScope(std::string_view, std::string_view, int) {}
};

template <RecordsFormulas S>
class FormulaScope<S> {
 public:
  FormulaScope(std::string_view formula, std::string_view row, int index) {
    ScalarTraits<S>::enter(formula, row, index);
  }
  FormulaScope(const FormulaScope&) = delete;
  FormulaScope& operator=(const FormulaScope&) = delete;
  ~FormulaScope() { ScalarTraits<S>::leave(); }
};

}  // namespace torse
