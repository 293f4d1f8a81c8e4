#include "torse/fuzz/properties/mapping_monotony.hpp"

#include <algorithm>
#include <string>

#include "torse/exact/quasi/monotony.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"
#include "torse/fuzz/plain/sturm.hpp"

namespace torse::fuzz {
namespace {

using In = MappingMonotony::In;
using Q = Rational;

/// The slope (t - r)^2, or (t - r)^3 towards one side, and its integral as coefficients: a mapping that all but
/// decreases at r, or does.
std::vector<Q> with_flat_point(Choices& choices, const KnotList<Q>& u) {
  const Q r = u.domain_begin() + Q(choices.below(9)) / Q(8) * (u.domain_end() - u.domain_begin());
  plain::Poly slope{Q(1)};
  const int roots = std::min(u.degree() - 1, choices.pick({2, 1, 3, 4}));
  for (int i = 0; i < roots; ++i) slope = plain::times(slope, {-r, Q(1)});
  plain::Poly sigma{Q(0)};
  for (std::size_t i = 0; i < slope.size(); ++i) sigma.push_back(slope[i] / Q(static_cast<long>(i) + 1));
  plain::Pieces<1> curve{plain::breaks_of(u), {}};
  curve.rows.assign(curve.breaks.size() - 1, {sigma});
  std::vector<Q> beta;
  for (const Vec<Q, 1>& b : plain::control_row<1>(curve, u)) beta.push_back(b[0]);
  return beta;
}

/// Coefficients that increase but for a few, or do not move.
std::vector<Q> with_steps(Choices& choices, const Scale& scale, const KnotList<Q>& u) {
  std::vector<Q> beta;
  Q total(0);
  const int down = choices.pick({0, 1, 3});
  for (int i = 0; i <= u.last(); ++i) {
    beta.push_back(total);
    const bool falls = choices.below(8) < static_cast<std::uint64_t>(down);
    const Q step = choices.once_in(3) ? Q(0) : draw_positive(choices, scale);
    total += falls ? -step / Q(choices.between(1, 16)) : step;
  }
  return beta;
}

struct Course {
  bool falls = false;
  bool rests = false;
};

Course course_of(const std::vector<plain::Poly>& slopes, const std::vector<Q>& breaks) {
  Course course;
  for (std::size_t j = 0; j < slopes.size(); ++j) {
    const bool zero = std::ranges::all_of(slopes[j], [](const Q& a) { return a.sign() == 0; });
    course.rests = course.rests || zero;
    course.falls = course.falls || plain::negative_inside(slopes[j], breaks[j], breaks[j + 1]).has_value();
  }
  return course;
}

}  // namespace

const PropertyInfo& MappingMonotony::info() {
  static const PropertyInfo info{
      "mapping.monotony",
      "a mapping increases, rests or decreases as Sturm's theorem says of its slope, and the witness shows it",
      20,
      {"kind=strict", "kind=weak", "kind=none", "coefficients=ordered", "coefficients=not"}};
  return info;
}

MappingMonotony::In MappingMonotony::draw(Choices& choices, const Scale& scale, Labels& labels) {
  Scale small = lean(scale, 10);
  small.degree = std::min(scale.degree, 6);
  small.pieces = std::min(scale.pieces, 6);
  In in{draw_knots(choices, small)};
  in.beta = in.knots.degree() > 1 && choices.once_in(3) ? with_flat_point(choices, in.knots)
                                                        : with_steps(choices, small, in.knots);
  labels.add("coefficients", std::ranges::is_sorted(in.beta) ? "ordered" : "not");
  return in;
}

void MappingMonotony::check(const In& in, Labels& labels) {
  const Mapping<Q> sigma = mapping_of(in.knots, in.beta);
  const plain::Pieces<1> pieces = plain::pieces_of<1>(sigma.knots, sigma.control);
  std::vector<plain::Poly> slopes;
  for (const plain::PolyRow<1>& row : pieces.rows) slopes.push_back(plain::derivative(row[0]));
  const Course course = course_of(slopes, pieces.breaks);

  const MonotonyVerdict verdict = decide_monotony(sigma);
  const Monotony kind = course.falls ? Monotony::none : course.rests ? Monotony::weak : Monotony::strict;
  labels.add("kind", kind == Monotony::none ? "none" : kind == Monotony::weak ? "weak" : "strict");
  require(verdict.kind == kind, "a mapping does not go as it is said to");
  require(verdict.witness.has_value() == (kind != Monotony::strict), "a witness too many or too few");
  if (verdict.witness) {
    const Q& t = *verdict.witness;
    const auto above = std::ranges::upper_bound(pieces.breaks, t);
    require(above != pieces.breaks.begin() && above != pieces.breaks.end(), "a witness outside the domain");
    const std::size_t j = static_cast<std::size_t>(above - pieces.breaks.begin()) - 1;
    require(pieces.breaks[j] < t, "a witness that is a knot");
    const Q slope = plain::value(slopes[j], t);
    require(kind == Monotony::none ? slope.sign() < 0 : slope.sign() == 0, "a witness shows nothing");
  }
  const Truth by_coefficients = monotone(sigma);
  require(by_coefficients == Truth::unknown || (by_coefficients == Truth::yes) == !course.falls,
          "the coefficients tell something else");
}

}  // namespace torse::fuzz
