#include "torse/fuzz/draw/polygons.hpp"

#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/elimination.hpp"

namespace torse::fuzz {
namespace {

template <class Draw>
Point3 vector_of(const Draw& draw) {
  Rational x = draw();
  Rational y = draw();
  Rational z = draw();
  return {std::move(x), std::move(y), std::move(z)};
}

/// One of the lists of points of draw_polygon, by its number.
Point3 draw_plain(Choices& choices, const Scale& scale, std::uint64_t kind) {
  switch (kind) {
    case 0:
      return vector_of([&] { return draw_integer(choices, 3); });
    case 1:
      return vector_of([&] { return draw_integer(choices, scale.bits); });
    case 2:
      return vector_of([&] { return draw_dyadic(choices, std::min(53, scale.bits), 20); });
    case 3:
      return vector_of([&] { return draw_dyadic(choices, 4, std::min(1000, 25 * scale.bits)); });
    default:
      return draw_vector(choices, scale);
  }
}

bool dyadic(Rational x) {
  for (std::size_t bit = x.denominator_bits(); bit > 1; --bit) x = x * Rational(2);
  return x.denominator_bits() == 1;
}

}  // namespace

Point3 draw_vector(Choices& choices, const Scale& scale) {
  return vector_of([&] { return draw_number(choices, scale); });
}

Point3 draw_nonzero_vector(Choices& choices, const Scale& scale) {
  Point3 x = draw_vector(choices, scale);
  if (x[0].sign() == 0 && x[1].sign() == 0 && x[2].sign() == 0) x[static_cast<int>(choices.below(3))] = Rational(1);
  return x;
}

std::vector<Point3> draw_polygon(Choices& choices, const Scale& largest, int count) {
  const Scale scale = lean(largest, count);
  const std::uint64_t kind = choices.below(10);
  const std::uint64_t coordinates = choices.below(5);
  // 0 to 5 are general, 6 and 7 repeat points, 8 lies on a line, 9 in a plane.
  std::vector<Point3> points;
  const int spans = kind == 8 ? 1 : 2;
  std::vector<Point3> frame;
  for (int i = 0; kind >= 8 && i <= spans; ++i) frame.push_back(draw_plain(choices, scale, coordinates));
  for (int i = 0; i < count; ++i) {
    if (kind >= 8) {
      Point3 x = frame[0];
      for (int j = 1; j <= spans; ++j) add_scaled(x, draw_fraction(choices, 4), frame[static_cast<std::size_t>(j)]);
      points.push_back(std::move(x));
    } else if (kind >= 6 && i > 0 && choices.once_in(2)) {
      const int back = choices.between(1, kind == 6 ? 1 : i);
      points.push_back(points[static_cast<std::size_t>(i - back)]);
    } else {
      points.push_back(draw_plain(choices, scale, coordinates));
    }
  }
  return points;
}

std::string_view polygon_kind(const std::vector<Point3>& points) {
  plain::Rows<4> span;
  for (const Point3& x : points) span.insert(Row4(Rational(1), x[0], x[1], x[2]));
  if (span.rank() < 4) {
    constexpr std::array<std::string_view, 4> names{"none", "point", "line", "plane"};
    return names[static_cast<std::size_t>(span.rank())];
  }
  bool huge = false;
  bool tiny = false;
  bool integer = true;
  bool binary = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i] == points[i - 1]) return "coincident";
    for (int j = 0; j < 3; ++j) {
      const Rational& x = points[i][j];
      huge = huge || x.numerator_bits() > x.denominator_bits() + 64;
      tiny = tiny || (x.sign() != 0 && x.denominator_bits() > x.numerator_bits() + 64);
      integer = integer && x.denominator_bits() == 1;
      binary = binary && dyadic(x);
    }
  }
  if (huge) return "huge";
  if (tiny) return "tiny";
  if (integer) return "integer";
  return binary ? "dyadic" : "fraction";
}

template <int D>
Matrix<D> draw_matrix(Choices& choices) {
  const auto triangle = [&](bool lower) {
    Matrix<D> m;
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        Rational x = i == j ? Rational(1) : Rational();
        if (i == j && choices.once_in(3)) x = choices.once_in(2) ? Rational(-1) : Rational(2);
        if (i != j && (j < i) == lower) x = draw_integer(choices, 2);
        m[static_cast<std::size_t>(i)][j] = std::move(x);
      }
    }
    return m;
  };
  const Matrix<D> left = triangle(true);
  const Matrix<D> right = triangle(false);
  Matrix<D> product;
  for (std::size_t i = 0; i < product.size(); ++i) {
    for (int j = 0; j < D; ++j) {
      product[i][j] = Rational();
      for (int k = 0; k < D; ++k) product[i][j] += left[i][k] * right[static_cast<std::size_t>(k)][j];
    }
  }
  for (std::size_t i = 0; i + 1 < product.size(); ++i) std::swap(product[i], product[i + choices.below(D - i)]);
  return product;
}

template Matrix<3> draw_matrix<3>(Choices& choices);
template Matrix<4> draw_matrix<4>(Choices& choices);

}  // namespace torse::fuzz
