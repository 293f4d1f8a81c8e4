// Algorithm 1 of BZZ19: the ruled surface (1-s) C1(t) + s C2(sigma(t)) as one B-spline surface of degree 1 x D.
//   composed_points       the Bezier polygon of c(e(t)) (BZZ19.13 and 14)
//   elevated_points       the Bezier polygon of a higher degree (BZZ19.14 and 15)
//   breakpoints           where the pieces of the surface meet (step 1)
//   SurfacePiece, surface_piece     the two polygons of one piece (steps 2 to 4)
//   SurfaceKnots, join_pieces       the mapping's own knots, or uniform ones as the paper prints (step 5)
//   quasi_surface         the surface (steps 1 to 5, BZZ19.16)
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse {

/// The p d + 1 Bezier points of c(e(t)), where c has the p + 1 Bezier points `c` and e the d + 1 Bernstein coefficients
/// `e`: sum_i C(p, i) (1-e)^{p-i} e^i c_i, expanded. Throws InvalidInput naming "points" where one of them is empty.
template <Field S, Point<S> P>
std::vector<P> composed_points(std::span<const P> c, std::span<const S> e) {
  if (c.empty() || e.empty()) throw InvalidInput("points", "expected a Bezier polygon, found no points");
  const int p = static_cast<int>(c.size()) - 1;
  const int d = static_cast<int>(e.size()) - 1;
  const BinaryForm<S> r = Bernstein<S>(std::vector<S>(e.begin(), e.end())).form();
  const BinaryForm<S> l = BinaryForm<S>(binomials<S>(d)) - r;
  std::vector<BinaryForm<S>> powers{BinaryForm<S>(std::vector<S>{from_int<S>(1)})};  // of 1 - e
  for (int i = 0; i < p; ++i) powers.push_back(powers.back() * l);
  const std::vector<S> outer = binomials<S>(p);
  const std::vector<S> inner = binomials<S>(p * d);
  std::vector<P> points(inner.size(), PointTraits<P>::zero());
  BinaryForm<S> power = powers.front();  // of e
  for (int i = 0; i <= p; ++i) {
    const std::size_t at_i = static_cast<std::size_t>(i);
    const BinaryForm<S> weight = outer[at_i] * (powers[static_cast<std::size_t>(p - i)] * power);
    for (std::size_t j = 0; j < inner.size(); ++j) {
      add_scaled(points[j], weight[static_cast<int>(j)] / inner[j], c[at_i]);
    }
    if (i < p) power = power * r;
  }
  return points;
}

/// The same Bezier curve with D + 1 >= c.size() points: b_i = sum_j C(p, j) C(D-p, i-j) / C(D, i) c_j.
template <Field S, Point<S> P>
std::vector<P> elevated_points(std::span<const P> c, int degree) {
  const int p = static_cast<int>(c.size()) - 1;
  if (degree == p) return std::vector<P>(c.begin(), c.end());
  const std::vector<S> old_row = binomials<S>(p);
  const std::vector<S> more = binomials<S>(degree - p);
  const std::vector<S> all = binomials<S>(degree);
  std::vector<P> points(all.size(), PointTraits<P>::zero());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < c.size() && j <= i; ++j) {
      if (i - j < more.size()) add_scaled(points[i], old_row[j] * more[i - j] / all[i], c[j]);
    }
  }
  return points;
}

/// Where the polynomials of the surface meet, in order and each once: the ends of sigma's domain and, inside it, the
/// knots of sigma and of C1. Step 1 of Algorithm 1 for the parameter t; the preimages of the knots of C2 are knots of
/// sigma by then.
template <OrderedField S>
std::vector<S> breakpoints(const KnotList<S>& of_sigma, const KnotList<S>& of_c1) {
  const S& begin = of_sigma.domain_begin();
  const S& end = of_sigma.domain_end();
  std::vector<S> inside;
  for (const KnotList<S>* u : {&of_sigma, &of_c1}) {
    for (const S& t : u->list()) {
      if (definitely(less(begin, t)) && definitely(less(t, end))) inside.push_back(t);
    }
  }
  std::ranges::sort(inside, [](const S& x, const S& y) { return definitely(less(x, y)); });
  std::vector<S> list{begin};
  for (S& t : inside) {
    if (definitely(less(list.back(), t))) list.push_back(std::move(t));
  }
  list.push_back(end);
  return list;
}

/// The knots of the surface: those of the mapping, so that the boundary curves are C1(t) and C2(sigma(t)) with t as it
/// was, or equally long pieces over the same domain, as BZZ19's Fig. 4 has them: the same surface and the same rulings,
/// each piece's parameter changed by an affine map of its own.
enum class SurfaceKnots { of_mapping, uniform };

/// The rounding of a value of sigma: the d levels of de Boor's triangle are d affine combinations with weights in
/// [0, 1], each with at most six roundings, so it is less than (6 d + 1) epsilon times the largest coefficient. Zero in
/// exact fields.
template <OrderedField S>
S value_rounding(const Mapping<S>& sigma) {
  S bound = from_int<S>(0);
  if constexpr (std::floating_point<S>) {
    for (const Vec<S, 1>& b : sigma.control) bound = std::max(bound, std::abs(b[0]));
    bound *= from_int<S>(6 * sigma.knots.degree() + 1) * std::numeric_limits<S>::epsilon();
  }
  return bound;
}

/// The Bezier polygons of C1 and of C2 o sigma on one piece of the surface.
template <class P>
struct SurfacePiece {
  std::vector<P> first;
  std::vector<P> second;
};

/// Those polygons with D + 1 points on [a, b], which lies on piece k of sigma and k1 of C1, while sigma goes over piece
/// k2 of C2 there (any of its pieces where it does not move). D >= p1 and D >= p2 d.
///
/// Where the paper refines C2 too and takes T^ = (sigma^(t^) - sigma(a)) / (sigma(b) - sigma(a)) (BZZ19.13), the piece
/// of C2 is kept whole here and T^ is the coordinate of that piece: the same polynomial with no division by zero.
template <Field S, Point<S> P>
SurfacePiece<P> surface_piece(const Spline<S, P>& c1, int k1, const Spline<S, P>& c2, int k2, const Mapping<S>& sigma,
                              int k, const S& a, const S& b, int degree) {
  const S& low = c2.knots.piece_begin(k2);
  const S length = c2.knots.piece_end(k2) - low;
  std::vector<S> e;
  for (const Vec<S, 1>& value : restricted_points(sigma.knots, sigma.points(), k, a, b)) {
    e.push_back((value[0] - low) / length);
  }
  const std::vector<P> on_c1 = restricted_points(c1.knots, c1.points(), k1, a, b);
  const std::vector<P> on_c2 = composed_points<S, P>(bezier_points(c2.knots, c2.points(), k2), e);
  return {elevated_points<S, P>(on_c1, degree), elevated_points<S, P>(on_c2, degree)};
}

/// The pieces between `list[j]` and `list[j + 1]` as one surface: their polygons share their ends, and each knot occurs
/// D times (BZZ19.16). Throws InvalidInput for numbers that do not match.
template <Field S, Point<S> P>
RuledSpline<S, P> join_pieces(const std::vector<S>& list, const std::vector<SurfacePiece<P>>& pieces, int degree,
                              SurfaceKnots kind = SurfaceKnots::of_mapping) {
  const int count = static_cast<int>(list.size()) - 1;
  std::vector<S> knots;
  for (int j = 0; j <= count; ++j) {
    const S uniform = list.front() + from_int<S>(j) * (list.back() - list.front()) / from_int<S>(count);
    const bool own = kind == SurfaceKnots::of_mapping || j == 0 || j == count;
    knots.insert(knots.end(), static_cast<std::size_t>(degree), own ? list[static_cast<std::size_t>(j)] : uniform);
  }
  std::vector<P> first;
  std::vector<P> second;
  for (const SurfacePiece<P>& piece : pieces) {
    const std::ptrdiff_t shared = first.empty() ? 0 : 1;
    first.insert(first.end(), piece.first.begin() + shared, piece.first.end());
    second.insert(second.end(), piece.second.begin() + shared, piece.second.end());
  }
  return RuledSpline<S, P>(KnotList<S>(degree, std::move(knots)), std::move(first), std::move(second));
}

namespace detail {

/// The proper piece of C2 on which sigma stays while it goes from `low` to `high`.
template <OrderedField S>
int piece_of_values(const KnotList<S>& u, const S& low, const S& high, const S& rounding) {
  const auto text = [&] { return "[" + as_text(low) + ", " + as_text(high) + "]"; };
  if (definitely(less(high + rounding, low))) {
    throw InvalidInput("sigma",
                       "expected a mapping that increases, found values from " + as_text(low) + " to " + as_text(high));
  }
  if (definitely(less(low + rounding, u.domain_begin())) || definitely(less(u.domain_end(), high - rounding))) {
    throw InvalidInput("sigma", "expected values within the second rail's domain [" + as_text(u.domain_begin()) + ", " +
                                    as_text(u.domain_end()) + "], found " + text());
  }
  const S middle = (low + high) / from_int<S>(2);
  const std::vector<int> pieces = u.proper_pieces();
  int found = pieces.front();
  for (int k : pieces) {
    if (definitely(!less(middle, u.piece_begin(k)))) found = k;
  }
  if (definitely(less(low + rounding, u.piece_begin(found))) || definitely(less(u.piece_end(found), high - rounding))) {
    throw InvalidInput(
        "sigma", "expected its knots where it passes the knots of the second rail; one of these lies inside " + text());
  }
  return found;
}

}  // namespace detail

/// The surface (1-s) C1(t) + s C2(sigma(t)) over sigma's domain (BZZ19.10) as a B-spline surface of degree D = max(p1,
/// p2 d) with knots of multiplicity D (BZZ19.16): exactly that in an exact field. P is Vec<S, 3>, or Vec<S, 4> for
/// homogeneous rows of rational rails. The rails may have degrees p1 and p2, knots and domains of their own.
///
/// sigma does not decrease (it may be constant: the piece of C2 is a point then, that of the surface a cone), its
/// domain lies in that of C1, its values in that of C2, and it has a knot wherever it passes a knot of C2, as `snapped`
/// (exact/quasi/snap.hpp) and, rounded, `with_preimages` (quasi/preimages.hpp) give it one. Throws InvalidInput naming
/// "sigma" otherwise; that it does not decrease is tested at the breakpoints only.
template <OrderedField S, Point<S> P>
RuledSpline<S, P> quasi_surface(const Spline<S, P>& c1, const Spline<S, P>& c2, const Mapping<S>& sigma,
                                SurfaceKnots kind = SurfaceKnots::of_mapping) {
  const KnotList<S>& u = sigma.knots;
  if (definitely(less(u.domain_begin(), c1.knots.domain_begin())) ||
      definitely(less(c1.knots.domain_end(), u.domain_end()))) {
    throw InvalidInput("sigma", "expected a domain within that of the first rail");
  }
  const int degree = std::max(c1.knots.degree(), c2.knots.degree() * u.degree());
  const S rounding = value_rounding(sigma);
  const std::vector<S> list = breakpoints(u, c1.knots);
  std::vector<SurfacePiece<P>> pieces;
  for (std::size_t j = 0; j + 1 < list.size(); ++j) {
    const S& a = list[j];
    const S& b = list[j + 1];
    const int k = piece_at(u, a);
    const S low = curve_point(u, sigma.points(), k, a)[0];
    const S high = curve_point(u, sigma.points(), k, b)[0];
    const int k2 = detail::piece_of_values(c2.knots, low, high, rounding);
    pieces.push_back(surface_piece(c1, piece_at(c1.knots, a), c2, k2, sigma, k, a, b, degree));
  }
  return join_pieces(list, pieces, degree, kind);
}

}  // namespace torse
