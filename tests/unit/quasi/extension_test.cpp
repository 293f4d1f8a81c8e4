// Extended curves: the old curve where it was, smooth at its old ends, through the targets.
#include "torse/quasi/extension.hpp"

#include <gtest/gtest.h>

#include "../spline/splines.hpp"
#include "torse/quasi/mapping.hpp"

namespace torse::test {
namespace {

using Curve = Spline<Q, Point2>;

Curve drawn(const KnotList<Q>& u, std::uint64_t seed) { return {u, points(u, seed)}; }

/// The k-th derivative of the polynomial of a piece at t, up to n!/(n-k)!: the blossom with k directions.
Point2 derivative(const Curve& curve, int piece, const Q& t, int k) {
  std::vector<Parameter<Q>> v = repeated(at(t), curve.knots.degree());
  for (int i = 0; i < k; ++i) v[static_cast<std::size_t>(i)] = direction<Q>();
  return blossom<Q, Point2>(curve.knots, curve.points(), piece, v);
}

const std::vector<KnotList<Q>>& lists() {
  static const std::vector<KnotList<Q>> all{
      KnotList<Q>(1, {Q(0), Q(1), Q(3)}),
      KnotList<Q>(2, {Q(0), Q(0), Q(1), Q(2), Q(2)}),
      KnotList<Q>(3, {Q(-1), Q(-1), Q(-1), Q(0), Q(0), Q(2), Q(2), Q(2)}),
      KnotList<Q>(3, {Q(0), Q(1), Q(2), Q(4), Q(5), Q(7), Q(8)}),  // not clamped
      KnotList<Q>(4, {Q(0), Q(0), Q(0), Q(0), Q(1), Q(1), Q(1), Q(1)}),
  };
  return all;
}

TEST(Extension, ReachesItsTargetAndIsTheOldCurveBefore) {
  for (std::size_t i = 0; i < lists().size(); ++i) {
    const Curve curve = drawn(lists()[i], i + 1);
    const int n = curve.knots.degree();
    const Q b = curve.knots.domain_end();
    const Q e = b + ratio<Q>(3, 2);
    const Point2 target(Q(7), Q(-5));
    const Curve longer = extended_end(curve, e, target);
    EXPECT_EQ(longer.knots.domain_end(), e);
    EXPECT_EQ(longer.knots.domain_begin(), curve.knots.domain_begin());
    EXPECT_EQ(curve_point(longer.knots, longer.points(), piece_at(longer.knots, e), e), target);
    const Q length = b - curve.knots.domain_begin();
    for (int j = 0; j < 20; ++j) {
      const Q t = curve.knots.domain_begin() + ratio<Q>(j, 20) * length;
      EXPECT_EQ(curve_point(longer.knots, longer.points(), piece_at(longer.knots, t), t),
                curve_point(curve.knots, curve.points(), piece_at(curve.knots, t), t));
    }
    const int fresh = piece_at(longer.knots, e);
    const int last = curve.knots.proper_pieces().back();
    for (int k = 0; k < n; ++k) EXPECT_EQ(derivative(longer, fresh, b, k), derivative(curve, last, b, k)) << k;
    EXPECT_NE(derivative(longer, fresh, b, n), derivative(curve, last, b, n));
  }
}

TEST(Extension, BothEndsAlongTheTangents) {
  for (std::size_t i = 0; i < lists().size(); ++i) {
    const Curve curve = drawn(lists()[i], i + 1);
    const Q share = ratio<Q>(1, 4);
    const Curve longer = extended(curve, share);
    const Q a = curve.knots.domain_begin();
    const Q b = curve.knots.domain_end();
    EXPECT_EQ(longer.knots.domain_begin(), a - share * (b - a));
    EXPECT_EQ(longer.knots.domain_end(), b + share * (b - a));
    const std::vector<int> pieces = curve.knots.proper_pieces();
    const auto tangent = [&](int k, const Q& from, const Q& to) {
      return sum(curve_point(curve.knots, curve.points(), k, from),
                 scaled(Q(to - from), curve_derivative(curve.knots, curve.points(), k, from)));
    };
    const auto end_of = [&](const Q& t) {
      return curve_point(longer.knots, longer.points(), piece_at(longer.knots, t), t);
    };
    EXPECT_EQ(end_of(longer.knots.domain_begin()), tangent(pieces.front(), a, longer.knots.domain_begin()));
    EXPECT_EQ(end_of(longer.knots.domain_end()), tangent(pieces.back(), b, longer.knots.domain_end()));
    for (int j = 0; j <= 20; ++j) {
      const Q t = a + ratio<Q>(j, 20) * (b - a);
      EXPECT_EQ(end_of(t), curve_point(curve.knots, curve.points(), piece_at(curve.knots, t), t));
    }
  }
}

TEST(Extension, OnlyForwards) {
  const Curve curve = drawn(lists()[1], 2);
  for (const Q& e : {Q(1), Q(2)}) {
    try {
      extended_end(curve, e, Point2(Q(0), Q(0)));
      ADD_FAILURE();
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place(), "e");
    }
  }
  EXPECT_THROW(extended(curve, Q(0)), InvalidInput);
}

}  // namespace
}  // namespace torse::test
