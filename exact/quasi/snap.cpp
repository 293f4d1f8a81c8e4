#include "torse/exact/quasi/snap.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "torse/exact/quasi/crossing.hpp"
#include "torse/exact/quasi/monotony.hpp"
#include "torse/exact/repair/real.hpp"
#include "torse/quasi/preimages.hpp"
#include "torse/quasi/surface.hpp"
#include "torse/spline/compatible.hpp"

namespace torse {

namespace {

using Q = Rational;
using quasi::Crossing;
using quasi::exponent_of;

Q magnitude(const Q& x) { return x.sign() < 0 ? -x : x; }

/// What every trial works with.
struct Task {
  Mapping<Q> sigma;       ///< clamped, its end values final
  std::vector<Q> marks;   ///< the knots of sigma and C1 inside the domain
  std::vector<Q> values;  ///< the inner knots of C2 between the end values
  Q tolerance;            ///< the largest change for a domain of C2 of length 1
  Q near;                 ///< values no further apart are taken for each other
  Q allowed;              ///< the largest change
};

/// How a trial goes about it: the bits of its numbers beyond those of the tolerance, and whether crossings may be
/// marks.
struct Manner {
  long bits;
  bool take_marks;
};

/// sigma with d-fold knots at both ends.
Mapping<Q> clamped(const Mapping<Q>& sigma) {
  if (definitely(sigma.knots.clamped())) return sigma;
  return restrict_spline(sigma, sigma.knots.domain_begin(), sigma.knots.domain_end());
}

/// The knot of C2's domain within `near` of the value, or the value. Throws InvalidInput for one outside the domain.
Q end_value(const Q& value, const KnotList<Q>& of_c2, const Q& near) {
  const Q& begin = of_c2.domain_begin();
  const Q& end = of_c2.domain_end();
  std::optional<Q> best;
  for (const Q& knot : of_c2.list()) {
    if (knot < begin || end < knot || near < magnitude(knot - value)) continue;
    if (!best || magnitude(knot - value) < magnitude(*best - value)) best = knot;
  }
  if (!best && (value < begin || end < value)) {
    throw InvalidInput("sigma", "expected values within the second rail's domain [" + as_text(begin) + ", " +
                                    as_text(end) + "], found " + as_text(value));
  }
  return best.value_or(value);
}

/// Takes the end values, and what lies on the way, to knots of C2 that are near.
void fix_ends(Mapping<Q>& sigma, const KnotList<Q>& of_c2, const Q& near) {
  for (const Q& old_end : {sigma.control.front()[0], sigma.control.back()[0]}) {
    const Q end = end_value(old_end, of_c2, near);
    const auto& [low, high] = std::minmax(old_end, end);
    for (Vec<Q, 1>& b : sigma.control) {
      if (!(b[0] < low) && !(high < b[0])) b[0] = end;
    }
  }
}

/// The mark at which sigma comes nearest to the value, if it comes near.
std::optional<Q> mark_of(const Task& task, const Q& value) {
  std::optional<Q> found;
  Q least = task.near;
  for (const Q& t : task.marks) {
    const Q distance = magnitude(mapping_value(task.sigma, t) - value);
    if (distance < least || (distance == least && !found)) {
      found = t;
      least = distance;
    }
  }
  return found;
}

bool contains(const std::vector<Q>& list, const Q& x) { return std::ranges::find(list, x) != list.end(); }

/// Where the values are to be passed; nothing where two would be passed at once or none in time.
std::optional<std::vector<Crossing>> crossings(const Task& task, const Manner& manner) {
  const KnotList<Q>& u = task.sigma.knots;
  const Q share = task.tolerance * repair::power_of_two(-manner.bits);
  std::vector<Crossing> list;
  for (const Q& value : task.values) {
    std::optional<Q> t = manner.take_marks ? mark_of(task, value) : std::nullopt;
    if (!t) {
      t = quasi::last_below(task.sigma, value, share);
      if (contains(u.list(), *t)) return std::nullopt;
    }
    if (!list.empty() && !(list.back().t < *t)) return std::nullopt;
    list.push_back({std::move(*t), value});
  }
  return list;
}

/// Knots between crossings that would share coefficients for more than a few in a row, as each equation makes the
/// numbers of the next one longer: d - 1 knots between two crossings leave them none in common.
std::vector<Q> separators(const KnotList<Q>& u, const std::vector<Crossing>& list) {
  constexpr int longest_run = 6;
  std::vector<Q> knots;
  int run = 1;
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    const Q& a = list[i].t;
    const Q& b = list[i + 1].t;
    const auto between = std::ranges::count_if(u.list(), [&](const Q& t) { return a < t && t < b; });
    const int missing = u.degree() - 1 - static_cast<int>(between);
    run = missing > 0 ? run + 1 : 1;
    if (run <= longest_run) continue;
    for (int j = 1; j <= missing; ++j) {
      knots.push_back(repair::rounded(a + ratio<Q>(j, missing + 1) * (b - a), exponent_of(b - a) - 8));
    }
    run = 1;
  }
  return knots;
}

/// The coefficients but the first and the last: one near a value becomes that value, others are rounded.
void shorten(Mapping<Q>& sigma, const Task& task, long exponent) {
  std::vector<Q> values = task.values;
  values.insert(values.end(), {sigma.control.front()[0], sigma.control.back()[0]});
  for (std::size_t i = 1; i + 1 < sigma.control.size(); ++i) {
    Q& b = sigma.control[i][0];
    const auto value = std::ranges::find_if(values, [&](const Q& v) { return !(task.near < magnitude(v - b)); });
    b = value != values.end() ? *value : repair::rounded(b, exponent);
  }
}

Q largest_difference(const Mapping<Q>& x, const Mapping<Q>& y) {
  Q largest(0);
  for (std::size_t i = 0; i < x.control.size(); ++i) {
    largest = std::max(largest, magnitude(x.control[i][0] - y.control[i][0]));
  }
  return largest;
}

/// Whether `fine` goes up as `sigma` does: by its coefficients if that does.
bool still_rises(const Mapping<Q>& sigma, const Mapping<Q>& fine) {
  return definitely(monotone(sigma)) ? definitely(monotone(fine)) : decide_monotony(fine).kind != Monotony::none;
}

std::optional<SnappedMapping> attempt(const Task& task, const Mapping<Q>& original, const Manner& manner) {
  const std::optional<std::vector<Crossing>> list = crossings(task, manner);
  if (!list) return std::nullopt;
  std::vector<Q> inserted = separators(task.sigma.knots, *list);
  for (const Crossing& crossing : *list) inserted.push_back(crossing.t);
  Mapping<Q> fine = task.sigma;
  Mapping<Q> before = original;
  for (const Q& t : inserted) {
    if (contains(fine.knots.list(), t)) continue;
    fine = insert_knot(fine, t);
    before = insert_knot(before, t);
  }
  shorten(fine, task, exponent_of(task.allowed) - manner.bits);
  quasi::fit_coefficients(fine, *list);
  Q change = largest_difference(fine, before);
  if (task.allowed < change || !still_rises(task.sigma, fine)) return std::nullopt;
  SnappedMapping result{std::move(fine), {}, std::move(change)};
  for (const Crossing& crossing : *list) result.parameters.push_back(crossing.t);
  return result;
}

}  // namespace

SnappedMapping snapped(const Mapping<Rational>& sigma, const KnotList<Rational>& of_c1, const KnotList<Rational>& of_c2,
                       const Rational& tolerance) {
  if (tolerance.sign() <= 0) throw InvalidInput("tolerance", "expected a positive number, found " + as_text(tolerance));
  if (decide_monotony(sigma).kind == Monotony::none) throw InvalidInput("sigma", "expected a mapping that increases");
  const Q allowed = tolerance * (of_c2.domain_end() - of_c2.domain_begin());
  Task task{clamped(sigma), breakpoints(sigma.knots, of_c1), {}, tolerance, allowed / Q(2), allowed};
  const Mapping<Q> original = task.sigma;
  task.marks = std::vector<Q>(task.marks.begin() + 1, task.marks.end() - 1);
  fix_ends(task.sigma, of_c2, task.near);
  task.values = inner_values(task.sigma, of_c2);
  if (task.values.empty()) {
    Q change = largest_difference(task.sigma, original);
    return {std::move(task.sigma), {}, std::move(change)};
  }
  for (const bool take_marks : {true, false}) {
    for (const long bits : {4L, 20L, 50L, 100L}) {
      if (std::optional<SnappedMapping> result = attempt(task, original, {bits, take_marks})) return *std::move(result);
    }
  }
  throw Undecided(
      "mapping: no coefficients within the tolerance pass the knots of the second rail at rational parameters");
}

SnappedMapping snapped(const Mapping<Rational>& sigma, const KnotList<Rational>& of_c1,
                       const KnotList<Rational>& of_c2) {
  for (const long exponent : {-40L, -36L}) {
    try {
      return snapped(sigma, of_c1, of_c2, repair::power_of_two(exponent));
    } catch (const Undecided&) {
    }
  }
  return snapped(sigma, of_c1, of_c2, repair::power_of_two(-30));
}

}  // namespace torse
