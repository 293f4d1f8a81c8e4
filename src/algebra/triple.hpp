// Products of three coordinates of any type with + - *: polynomials, forms, lanes of doubles. Vec<S, 3> has its own.
//   dot, cross
#pragma once

#include <array>

namespace torse {

/// a . b.
template <class T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a x b.
template <class T>
std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace torse
