#include "torse/fuzz/draw/parameters.hpp"

#include <algorithm>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

Rational draw_knot(Choices& choices, const KnotList<Rational>& u) { return u[choices.between(0, u.size() - 1)]; }

Rational length(const KnotList<Rational>& u) { return u[u.size() - 1] - u[0]; }

bool is_knot(const KnotList<Rational>& u, const Rational& x) {
  return std::find(u.list().begin(), u.list().end(), x) != u.list().end();
}

Rational signed_power(Choices& choices, int exponent) {
  const Rational power = power_of_two(exponent);
  return choices.once_in(2) ? power : -power;
}

}  // namespace

Rational draw_parameter(Choices& choices, const Scale& largest, const KnotList<Rational>& u) {
  const Scale scale = lean(largest, u.size());
  switch (choices.below(8)) {
    case 0:
    case 1:
      return u[0] - Rational(1) - draw_fraction(choices, 3) / Rational(8);
    case 2:
    case 3:
      return draw_number(choices, scale);
    case 4:
      return draw_inside(choices, u, choices.between(1, u.pieces()));
    case 5:
      return draw_knot(choices, u);
    case 6: {
      const Rational knot = draw_knot(choices, u);
      return knot + length(u) * signed_power(choices, -choices.between(20, 20 + 4 * scale.bits));
    }
    default:
      return u[0] + length(u) * signed_power(choices, choices.between(21, 21 + 8 * scale.bits));
  }
}

Rational draw_off_knots(Choices& choices, const Scale& scale, const KnotList<Rational>& u) {
  Rational x = draw_parameter(choices, scale, u);
  if (!is_knot(u, x)) return x;
  const auto above = std::find_if(u.list().begin(), u.list().end(), [&](const Rational& knot) { return knot > x; });
  return above == u.list().end() ? x + Rational(1) : (Rational(2) * x + *above) / Rational(3);
}

Rational draw_inside(Choices& choices, const KnotList<Rational>& u, int k) {
  const int parts = choices.pick({2, 2, 3, 3, 7, 1, 64});
  const int at = choices.between(0, parts);
  return u.piece_begin(k) + Rational(at) / Rational(parts) * (u.piece_end(k) - u.piece_begin(k));
}

std::string_view parameter_kind(const KnotList<Rational>& u, const Rational& x) {
  if (is_knot(u, x)) return "knot";
  const Rational unit = length(u);
  const auto size = [](const Rational& y) { return y.sign() < 0 ? -y : y; };
  for (const Rational& knot : u.list()) {
    if (size(x - knot) <= unit * power_of_two(-20)) return "near";
  }
  if (size(x - u[0]) > unit * power_of_two(20)) return "huge";
  return u.domain_begin() < x && x < u.domain_end() ? "inside" : "outside";
}

Functions draw_functions(Choices& choices, const Scale& scale, const KnotList<Rational>& u, bool rational) {
  Functions f;
  f.m = draw_off_knots(choices, scale, u);
  f.lambda = choices.once_in(8) ? f.m : draw_parameter(choices, scale, u);
  if (rational && choices.once_in(2)) f.sigma = draw_nonzero(choices, scale);
  return f;
}

}  // namespace torse::fuzz
