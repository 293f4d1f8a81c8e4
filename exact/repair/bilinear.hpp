// Families of developable nets: equations that are linear in the control points and linear in a few unknown constants.
//   BilinearSystem<S>     sum over terms of coefficient * constant * point = 0, an equation a row
//   constant_relation     FJ07.13 and FJ21.7.1: constants a, w, a', w' with L* = a/w, M* = a'/w', sigma = w'/w
//
// Points count as c_0, d_0, c_1, d_1, ...; the rows of a polynomial surface are points, whose weights are 1: the
// equations hold for these too, which leaves out some constants.
#pragma once

#include <cstddef>
#include <vector>

#include "torse/scalar/traits.hpp"

namespace torse::repair {

/// coefficient * constant * point.
template <class S>
struct Term {
  std::size_t point;
  std::size_t constant;
  S coefficient;
};

/// Homogeneous equations; the terms of an equation are sorted by their points.
template <class S>
struct BilinearSystem {
  std::size_t constants;
  std::vector<std::vector<Term<S>>> equations;
};

/// (w u_{i+n} - a) c_i + (a - w u_i) c_{i+1} = (w' u_{i+n} - a') d_i + (a' - w' u_i) d_{i+1} for i = 0..L-1. The
/// constants are a, w, a', w'; for points a, w, a', since w' = w. From each of the cells `joints`, in increasing order,
/// on there are new ones.
template <class S>
BilinearSystem<S> constant_relation(int degree, const std::vector<S>& u, bool homogeneous,
                                    const std::vector<int>& joints = {}) {
  const std::size_t n = static_cast<std::size_t>(degree);
  const S one = from_int<S>(1);
  const std::size_t other = homogeneous ? 3 : 1;
  const std::size_t count = homogeneous ? 4 : 3;
  BilinearSystem<S> system{count * (joints.size() + 1), {}};
  for (std::size_t i = 0, segment = 0; i < u.size() - n; ++i) {
    if (segment < joints.size() && static_cast<int>(i) == joints[segment]) ++segment;
    const std::size_t at = count * segment;
    const std::size_t c = 2 * i;
    const std::size_t d = c + 1;
    system.equations.push_back({{c, at, -one},
                                {c, at + 1, u[i + n]},
                                {d, at + 2, one},
                                {d, at + other, -u[i + n]},
                                {c + 2, at, one},
                                {c + 2, at + 1, -u[i]},
                                {d + 2, at + 2, -one},
                                {d + 2, at + other, u[i]}});
  }
  return system;
}

}  // namespace torse::repair
