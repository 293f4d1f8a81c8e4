#include "torse/fuzz/draw/space_map.hpp"

#include <array>
#include <cstddef>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

/// The rotation of the quaternion 1 + a i + b j + c k.
Matrix<3> rotation(const Rational& a, const Rational& b, const Rational& c) {
  const Rational one(1);
  const Rational two(2);
  const Rational norm = one + a * a + b * b + c * c;
  Matrix<3> m{{{one + a * a - b * b - c * c, two * (a * b - c), two * (a * c + b)},
               {two * (a * b + c), one - a * a + b * b - c * c, two * (b * c - a)},
               {two * (a * c - b), two * (b * c + a), one - a * a - b * b + c * c}}};
  for (Point3& row : m) {
    for (int j = 0; j < 3; ++j) row[j] /= norm;
  }
  return m;
}

SpaceMap affine(std::string kind, const Matrix<3>& m, const Point3& shift) {
  SpaceMap map{std::move(kind), {Row4(Rational(1), Rational(), Rational(), Rational())}};
  for (int i = 0; i < 3; ++i) {
    const Point3& row = m[static_cast<std::size_t>(i)];
    map.rows.emplace_back(shift[i], row[0], row[1], row[2]);
  }
  return map;
}

/// The determinant of the rows from `first` on among the columns that are not used.
Rational laplace(const std::vector<Row4>& rows, std::size_t first, std::array<bool, 4> used) {
  if (first == rows.size()) return Rational(1);
  Rational sum;
  bool negative = false;
  for (std::size_t j = 0; j < 4; ++j) {
    if (used[j]) continue;
    used[j] = true;
    const Rational term = rows[first][static_cast<int>(j)] * laplace(rows, first + 1, used);
    sum += negative ? -term : term;
    used[j] = false;
    negative = !negative;
  }
  return sum;
}

}  // namespace

Row4 SpaceMap::operator()(const Row4& x) const {
  Row4 y;
  for (int i = 0; i < 4; ++i) {
    y[i] = Rational();
    for (int j = 0; j < 4; ++j) y[i] += rows[static_cast<std::size_t>(i)][j] * x[j];
  }
  return y;
}

Point3 SpaceMap::operator()(const Point3& x) const {
  const Row4 y = (*this)(Row4(Rational(1), x[0], x[1], x[2]));
  return {y[1], y[2], y[3]};
}

SpaceMap identity_map() {
  return affine("identity", rotation(Rational(), Rational(), Rational()), Point3(Rational(), Rational(), Rational()));
}

SpaceMap draw_motion(Choices& choices, const Scale& scale) {
  const auto draw = [&] { return choices.once_in(3) ? Rational() : draw_fraction(choices, 4); };
  const Rational a = draw();
  const Rational b = draw();
  Matrix<3> m = rotation(a, b, draw());
  const bool reflected = choices.once_in(4);
  for (Point3& row : m) row[0] = reflected ? -row[0] : row[0];
  return affine(reflected ? "reflection" : "rotation", m, draw_vector(choices, scale));
}

SpaceMap draw_similarity(Choices& choices, const Scale& scale) {
  SpaceMap map = draw_motion(choices, scale);
  const Rational factor = draw_nonzero(choices, scale);
  for (std::size_t i = 1; i < 4; ++i) {
    for (int j = 1; j < 4; ++j) map.rows[i][j] *= factor;
  }
  map.kind = "similarity";
  return map;
}

SpaceMap draw_space_map(Choices& choices, const Scale& scale, bool projective) {
  switch (choices.below(projective ? 5 : 4)) {
    case 0:
      return identity_map();
    case 1:
      return draw_motion(choices, scale);
    case 2:
      return draw_similarity(choices, scale);
    case 3: {
      const Matrix<3> linear = draw_matrix<3>(choices);
      return affine("affine", linear, draw_vector(choices, scale));
    }
    default:
      const Matrix<4> m = draw_matrix<4>(choices);
      return {"projective", {m.begin(), m.end()}};
  }
}

Rational determinant(const SpaceMap& map) { return laplace(map.rows, 0, {}); }

}  // namespace torse::fuzz
