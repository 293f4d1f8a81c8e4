#include "torse/fuzz/draw/knots.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

enum class Steps { one, integer, fraction, extreme };

Rational draw_step(Choices& choices, const Scale& scale, Steps steps) {
  if (steps == Steps::one) return Rational(1);
  if (steps == Steps::integer) return Rational(1 + choices.between(0, 4));
  if (steps == Steps::fraction) return draw_positive(choices, scale);
  const int e = choices.between(0, choices.pick({40, 200, std::min(504, 42 * scale.bits)}));
  return power_of_two(choices.once_in(2) ? e : -e);
}

/// Where the list must or may stand still.
struct Shape {
  int degree;
  int size;
  bool begin_clamped;
  bool end_clamped;
  bool repeats;

  bool clamped_at(int i) const { return (begin_clamped && i < degree) || (end_clamped && i > size - degree); }
  bool moves_at(int i) const { return (begin_clamped && i == degree) || (end_clamped && i == size - degree); }
};

Shape draw_shape(Choices& choices, const Scale& scale, int degree) {
  const int pieces = choices.between(1, scale.pieces);
  const std::uint64_t ends = choices.below(6);
  return {degree, 2 * degree + pieces - 1, ends < 4, ends < 3 || ends == 4, choices.once_in(2)};
}

}  // namespace

KnotList<Rational> draw_knots(Choices& choices, const Scale& scale, int degree) {
  const Shape shape = draw_shape(choices, scale, degree);
  const Steps steps =
      choices.pick({Steps::one, Steps::integer, Steps::integer, Steps::fraction, Steps::fraction, Steps::extreme});
  std::vector<Rational> list{steps == Steps::one ? Rational() : draw_integer(choices, 3)};
  int run = 1;
  for (int i = 1; i < shape.size; ++i) {
    const bool may_stand = run < degree && !shape.moves_at(i) &&
                           !(i == shape.size - degree && list.back() == list[static_cast<std::size_t>(degree) - 1]);
    const bool stands = may_stand && (shape.clamped_at(i) || (shape.repeats && !choices.once_in(3)));
    list.push_back(stands ? list.back() : list.back() + draw_step(choices, lean(scale, shape.size), steps));
    run = stands ? run + 1 : 1;
  }
  return {degree, std::move(list)};
}

KnotList<Rational> draw_knots(Choices& choices, const Scale& scale) {
  const int degree = choices.between(1, scale.degree);
  return draw_knots(choices, scale, degree);
}

std::string_view knot_kind(const KnotList<Rational>& u) {
  const bool begin = u[0] == u.domain_begin();
  const bool end = u[u.size() - 1] == u.domain_end();
  if (begin && end && u.pieces() == 1) return "bezier";
  std::optional<Rational> before;
  int most = 1;
  int run = 1;
  for (int i = 1; i < u.size(); ++i) {
    run = u[i] == u[i - 1] ? run + 1 : 1;
    if (u.domain_begin() < u[i] && u[i] < u.domain_end()) most = std::max(most, run);
    if (run > 1) continue;
    const Rational step = u[i] - u[i - 1];
    const Rational limit = power_of_two(20);
    if (before && (step > limit * *before || *before > limit * step)) return "extreme";
    before = step;
  }
  if (most > 1) return most == u.degree() ? "full" : "repeated";
  if (begin && end) return "clamped";
  return begin || end ? "mixed" : "unclamped";
}

}  // namespace torse::fuzz
