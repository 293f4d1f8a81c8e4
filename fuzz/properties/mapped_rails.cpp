#include "torse/fuzz/properties/mapped_rails.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "torse/exact/quasi/snap.hpp"
#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"
#include "torse/quasi/surface.hpp"
#include "torse/spline/compatible.hpp"

namespace torse::fuzz {
namespace {

using In = MappedRails::In;
using Q = Rational;

Rail draw_rail(Choices& choices, const Scale& scale) {
  Rail rail{draw_knots(choices, scale)};
  rail.rows = draw_rows(choices, scale, rail.knots.last() + 1, Weights::nonzero);
  return rail;
}

/// A number in [0, 1], often an end.
Q draw_share(Choices& choices) { return Q(choices.below(9)) / Q(8); }

/// The polynomials of a curve at t, to the right at a break.
template <int D>
const plain::PolyRow<D>& row_at(const plain::Pieces<D>& curve, const Q& t) {
  std::size_t j = 0;
  while (j + 1 < curve.rows.size() && curve.breaks[j + 1] <= t) ++j;
  return curve.rows[j];
}

/// f(g(t)) by Horner's rule.
plain::Poly composed(const plain::Poly& f, const plain::Poly& g) {
  plain::Poly value;
  for (std::size_t i = f.size(); i-- > 0;) value = plain::plus(plain::times(value, g), {f[i]});
  return value;
}

bool same(const plain::Poly& f, const plain::Poly& g) {
  const plain::Poly rest = plain::plus(f, plain::scaled(Q(-1), g));
  return std::ranges::all_of(rest, [](const Q& a) { return a.sign() == 0; });
}

void check_snapped(const Mapping<Q>& sigma, const SnappedMapping& result, const KnotList<Q>& of_d) {
  const Mapping<Q>& fine = result.sigma;
  require(monotone(fine) == Truth::yes, "a snapped mapping decreases");
  const plain::Pieces<1> before = plain::pieces_of<1>(sigma.knots, sigma.control);
  const plain::Pieces<1> after = plain::pieces_of<1>(fine.knots, fine.control);
  for (std::size_t j = 0; j + 1 < after.breaks.size(); ++j) {
    const Q& t = after.breaks[j];
    const Q change = plain::value_at<1>(row_at(before, t), t)[0] - plain::value_at<1>(after.rows[j], t)[0];
    require(change <= result.change && -result.change <= change, "a mapping changed by more than it says");
    if (j > 0) require(multiplicity(fine.knots, t) == std::max(1, multiplicity(sigma.knots, t)), "a knot was doubled");
  }
  const Q low = plain::value_at<1>(after.rows.front(), after.breaks.front())[0];
  const Q high = plain::value_at<1>(after.rows.back(), after.breaks.back())[0];
  for (const Q& value : plain::breaks_of(of_d)) {
    if (value <= low || high <= value) continue;
    const bool passed = std::ranges::any_of(
        after.breaks, [&](const Q& t) { return plain::value_at<1>(row_at(after, t), t)[0] == value; });
    require(passed, "a knot of the second rail is passed between the knots of the mapping");
  }
}

void check_surface(const In& in, const Mapping<Q>& sigma) {
  const RuledSpline<Q, Row4> surface = quasi_surface(as_spline(in.c), as_spline(in.d), sigma);
  const plain::Pieces<4> c = plain::pieces_of<4>(in.c.knots, in.c.rows);
  const plain::Pieces<4> d = plain::pieces_of<4>(in.d.knots, in.d.rows);
  const plain::Pieces<1> map = plain::pieces_of<1>(sigma.knots, sigma.control);
  const plain::Pieces<4> first = plain::pieces_of<4>(surface.knots, surface.c);
  const plain::Pieces<4> second = plain::pieces_of<4>(surface.knots, surface.d);
  for (std::size_t j = 0; j < first.rows.size(); ++j) {
    const Q middle = (first.breaks[j] + first.breaks[j + 1]) / Q(2);
    const plain::Poly& at = row_at(map, middle)[0];
    for (std::size_t i = 0; i < 4; ++i) {
      require(same(first.rows[j][i], row_at(c, middle)[i]), "the first row is not the first rail");
      require(same(second.rows[j][i], composed(row_at(d, plain::value(at, middle))[i], at)),
              "the second row is not the second rail over the mapping");
    }
  }
}

/// Whether a knot of the first rail lies inside the mapping's domain, so that its pieces are looked at in parts.
bool cut_by_first_rail(const In& in, const Mapping<Q>& sigma) {
  const auto inside = [&](const Q& t) { return sigma.knots.domain_begin() < t && t < sigma.knots.domain_end(); };
  return std::ranges::any_of(plain::breaks_of(in.c.knots), inside);
}

/// A mapping that goes a little beyond an end of the second rail is refused as such, or because another part of its
/// last piece passes a knot now.
void check_refused(const In& in, const Mapping<Q>& sigma) {
  const KnotList<Q>& u = in.d.knots;
  const Q little = (u.domain_end() - u.domain_begin()) / Q(1'000'000);
  Mapping<Q> below = sigma;
  below.control.front()[0] = u.domain_begin() - little;
  Mapping<Q> above = sigma;
  above.control.back()[0] = u.domain_end() + little;
  for (const Mapping<Q>& beyond : {below, above}) {
    std::string reason;
    try {
      quasi_surface(as_spline(in.c), as_spline(in.d), beyond);
    } catch (const InvalidInput& error) {
      reason = error.what();
    }
    require(reason.starts_with("sigma: expected values within the second rail's domain") ||
                (cut_by_first_rail(in, beyond) && reason.starts_with("sigma: expected its knots where it passes")),
            "a mapping beyond the second rail's ends is not refused as such");
  }
}

/// A knot of the second rail that is passed between those of the mapping, before or behind the middle, is told.
void check_passed_between(const In& in, const Mapping<Q>& sigma) {
  const plain::Pieces<1> map = plain::pieces_of<1>(sigma.knots, sigma.control);
  const std::size_t j = map.rows.size() / 2;
  for (const int quarter : {1, 3}) {
    const Q t = map.breaks[j] + ratio<Q>(quarter, 4) * (map.breaks[j + 1] - map.breaks[j]);
    const Q value = plain::value_at<1>(map.rows[j], t)[0];
    const std::vector<Q> known = plain::breaks_of(in.d.knots);
    const bool level = plain::value_at<1>(map.rows[j], map.breaks[j])[0] == value;
    if (level || std::ranges::count(known, value) > 0 || std::ranges::count(plain::breaks_of(in.c.knots), t) > 0)
      continue;
    std::string reason;
    try {
      quasi_surface(as_spline(in.c), insert_knot(as_spline(in.d), value), sigma);
    } catch (const InvalidInput& error) {
      reason = error.what();
    }
    require(reason.starts_with("sigma: expected its knots where it passes"), "a knot that is passed is not told");
  }
}

}  // namespace

const PropertyInfo& MappedRails::info() {
  static const PropertyInfo info{
      "rails.mapped",
      "the ruled surface over a mapping is its rails exactly, snapping does what it says, and a mapping beyond the "
      "second rail or past its knots is refused",
      1,
      {"level=yes", "level=no", "passed=none", "passed=some"}};
  return info;
}

MappedRails::In MappedRails::draw(Choices& choices, const Scale& scale, Labels& labels) {
  Scale small = lean(scale, 12);
  small.degree = std::min(scale.degree, 3);
  small.pieces = std::min(scale.pieces, 4);
  In in{draw_rail(choices, small), draw_rail(choices, small)};
  const KnotList<Q> drawn = draw_knots(choices, small);
  const auto inside = [](const KnotList<Q>& u, const Q& share) {
    return u.domain_begin() + share * (u.domain_end() - u.domain_begin());
  };
  const Q begin = draw_share(choices) / Q(2);
  const Q end = Q(1) - draw_share(choices) / Q(3);
  in.knots = reparametrized(identity_mapping(drawn), inside(in.c.knots, begin), inside(in.c.knots, end)).knots;
  Q total(0);
  in.beta.push_back(total);
  bool level = false;
  for (int i = 1; i <= in.knots.last(); ++i) {
    const bool still = choices.once_in(4);
    level = level || still;
    if (!still) total += Q(1 + choices.below(20));
    in.beta.push_back(total);
  }
  const Q low = draw_share(choices) / Q(3);
  const Q high = Q(1) - draw_share(choices) / Q(3);
  for (Q& b : in.beta) b = inside(in.d.knots, low + (total.sign() == 0 ? Q(0) : b / total) * (high - low));
  labels.add("level", level ? "yes" : "no");
  return in;
}

void MappedRails::check(const In& in, Labels& labels) {
  const Mapping<Q> sigma = mapping_of(in.knots, in.beta);
  try {
    const SnappedMapping result = snapped(sigma, in.c.knots, in.d.knots);
    labels.add("passed", result.parameters.empty() ? "none" : "some");
    check_snapped(sigma, result, in.d.knots);
    check_surface(in, result.sigma);
    check_refused(in, result.sigma);
    check_passed_between(in, result.sigma);
  } catch (const Undecided&) {
    labels.add("passed", "undecided");
  }
}

}  // namespace torse::fuzz
