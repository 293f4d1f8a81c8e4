// Algorithm 1 against the rails themselves: boundary curves at parameters by basis functions, pieces and degrees of the
// paper's Fig. 4, degenerate mappings.
#include "torse/quasi/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../spline/splines.hpp"
#include "torse/quasi/preimages.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::test {
namespace {

using Point3 = Vec<Q, 3>;
using Point4 = Vec<Q, 4>;

template <int D>
Spline<Q, Vec<Q, D>> drawn(const KnotList<Q>& u, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<Vec<Q, D>> row;
  for (int i = 0; i <= u.last(); ++i) {
    Vec<Q, D> point;
    for (int j = 0; j < D; ++j)
      point[j] = ratio<Q>(static_cast<int>(rng() % 201) - 100, static_cast<int>(rng() % 9) + 1);
    row.push_back(point);
  }
  return Spline<Q, Vec<Q, D>>(u, row);
}

/// By Cox and de Boor's basis functions; blossoms are what the surface is made of.
template <int D>
Vec<Q, D> by_basis(const KnotList<Q>& u, const std::vector<Vec<Q, D>>& c, const Q& t) {
  int k = 0;
  for (int piece : u.proper_pieces()) {
    if (k == 0 || !(t < u.piece_begin(piece))) k = piece;
  }
  const auto forms = piece_forms<Q, D>(basis_forms(u, k), c, k);
  const Q s = (t - u.piece_begin(k)) / (u.piece_end(k) - u.piece_begin(k));
  Vec<Q, D> value;
  for (int j = 0; j < D; ++j) value[j] = forms[static_cast<std::size_t>(j)](Q(1) - s, s);
  return value;
}

template <int D>
Vec<Q, D> by_basis(const Spline<Q, Vec<Q, D>>& c, const Q& t) {
  return by_basis<D>(c.knots, c.control, t);
}

/// The rows are C1(t) and C2(sigma(t)): at more parameters of each piece than the degree.
template <int D>
void expect_rails(const RuledSpline<Q, Vec<Q, D>>& surface, const Spline<Q, Vec<Q, D>>& c1,
                  const Spline<Q, Vec<Q, D>>& c2, const Mapping<Q>& sigma) {
  const int n = surface.knots.degree();
  for (int k : surface.knots.proper_pieces()) {
    for (int i = 0; i <= n; ++i) {
      const Q t =
          surface.knots.piece_begin(k) + ratio<Q>(i, n) * (surface.knots.piece_end(k) - surface.knots.piece_begin(k));
      EXPECT_EQ(by_basis<D>(surface.knots, surface.c, t), by_basis<D>(c1, t));
      EXPECT_EQ(by_basis<D>(surface.knots, surface.d, t), by_basis<D>(c2, by_basis<1>(sigma, t)[0]));
    }
  }
}

Mapping<Q> rising(const KnotList<Q>& u, const Q& from, const Q& to, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::vector<Q> steps{Q(0)};
  for (int i = 1; i <= u.last(); ++i) steps.push_back(steps.back() + Q(static_cast<int>(rng() % 7) + 1));
  for (Q& b : steps) b = from + (to - from) * b / steps.back();
  return mapping_of(u, steps);
}

KnotList<Q> fig4_rails() { return KnotList<Q>(3, {Q(0), Q(0), Q(0), ratio<Q>(1, 2), Q(1), Q(1), Q(1)}); }

KnotList<Q> fig4_mapping() {
  std::vector<Q> list{Q(0), Q(0)};
  for (int i : {3, 5, 7, 9, 11, 13, 15}) list.push_back(ratio<Q>(i, 18));
  list.insert(list.end(), {Q(1), Q(1)});
  return KnotList<Q>(2, list);
}

TEST(ComposedPoints, AgreeWithPolynomialsOfTheCoordinates) {
  const Spline<Q, Point2> c(bezier_knots<Q>(3), points(bezier_knots<Q>(3), 4));
  const std::vector<Q> e{ratio<Q>(1, 3), ratio<Q>(-2, 5), Q(2)};
  const std::vector<Point2> composed = composed_points<Q, Point2>(c.points(), e);
  ASSERT_EQ(composed.size(), 7U);
  for (int j = 0; j < 2; ++j) {
    std::vector<Q> outer;
    for (const Point2& p : c.control) outer.push_back(p[j]);
    const std::vector<Q> expected = Bernstein<Q>(outer).compose(Bernstein<Q>(e)).coefficients();
    for (std::size_t i = 0; i < composed.size(); ++i) EXPECT_EQ(composed[i][j], expected[i]);
  }
  try {
    composed_points<Q, Point2>({}, e);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.place(), "points");
  }
}

TEST(ElevatedPoints, AgreeWithRepeatedElevation) {
  const Spline<Q, Point2> c(bezier_knots<Q>(3), points(bezier_knots<Q>(3), 5));
  EXPECT_EQ((elevated_points<Q, Point2>(c.points(), 3)), c.control);
  for (int j = 0; j < 2; ++j) {
    std::vector<Q> row;
    for (const Point2& p : c.control) row.push_back(p[j]);
    const std::vector<Q> expected = Bernstein<Q>(row).elevated(8).coefficients();
    const std::vector<Point2> raised = elevated_points<Q, Point2>(c.points(), 8);
    ASSERT_EQ(raised.size(), expected.size());
    for (std::size_t i = 0; i < raised.size(); ++i) EXPECT_EQ(raised[i][j], expected[i]);
  }
}

// Fig. 4: sigma has 8 pieces; the ninth comes from the preimage of C2's knot 1/2, which is not 1/2. Here it is 4/9.
TEST(ValueRounding, IsThatOfDeBoorsTriangle) {
  const KnotList<double> u(2, {0, 0, 1, 2, 2});
  const Mapping<double> sigma(
      u, std::vector<Vec<double, 1>>{Vec<double, 1>(-3), Vec<double, 1>(0), Vec<double, 1>(1), Vec<double, 1>(2)});
  EXPECT_EQ(value_rounding(sigma), 3 * 13 * 0x1p-52);
  EXPECT_EQ(value_rounding(identity_mapping(bezier_knots<Q>(3))), Q(0));
}

TEST(QuasiSurface, NinePiecesOfTheWorkedExample) {
  const Spline<Q, Point3> c1 = drawn<3>(fig4_rails(), 1);
  const Spline<Q, Point3> c2 = drawn<3>(fig4_rails(), 2);
  const Q preimage = ratio<Q>(4, 9);
  Mapping<Q> sigma = rising(fig4_mapping(), Q(0), Q(1), 3);
  ASSERT_EQ(sigma.control.size(), 10U);
  sigma = insert_knot(sigma, preimage);
  // Its value there is (beta_4 + beta_5) / 2 between the knots 7/18, 4/9 and 1/2.
  sigma.control[4][0] = Q(1) - sigma.control[5][0];
  ASSERT_EQ(mapping_value(sigma, preimage), ratio<Q>(1, 2));
  ASSERT_EQ(strictly_monotone(sigma), Truth::yes);

  const RuledSpline<Q, Point3> surface = quasi_surface(c1, c2, sigma);
  EXPECT_EQ(surface.knots.degree(), 6);
  EXPECT_EQ(surface.knots.proper_pieces().size(), 9U);
  EXPECT_EQ(surface.c.size(), 55U);
  EXPECT_EQ(surface.d.size(), 55U);
  EXPECT_EQ(std::ranges::count(surface.knots.list(), preimage), 6);
  EXPECT_EQ(std::ranges::count(surface.knots.list(), Q(0)), 6);
  expect_rails<3>(surface, c1, c2, sigma);

  const RuledSpline<Q, Point3> uniform = quasi_surface(c1, c2, sigma, SurfaceKnots::uniform);
  EXPECT_EQ(uniform.c, surface.c);
  EXPECT_EQ(uniform.d, surface.d);
  for (int i = 1; i < 9; ++i) EXPECT_EQ(std::ranges::count(uniform.knots.list(), ratio<Q>(i, 9)), 6) << i;
}

TEST(QuasiSurface, RailsOfDifferentDegreesKnotsAndDomains) {
  const Spline<Q, Point4> c1 = drawn<4>(knots(4, {0, 0, 0, 0, 1, 2, 2, 5, 5, 5, 5}), 4);
  const Spline<Q, Point4> c2 = drawn<4>(knots(1, {0, 1, 3, 4}), 5);
  // Values 0, 1, 3, 4 at the knots of a linear mapping on a part of C1's domain.
  const Mapping<Q> sigma = mapping_of(KnotList<Q>(1, {Q(1), ratio<Q>(3, 2), Q(2), Q(4)}), {Q(0), Q(1), Q(3), Q(4)});
  const RuledSpline<Q, Point4> surface = quasi_surface(c1, c2, sigma);
  EXPECT_EQ(surface.knots.degree(), 4);
  EXPECT_EQ(surface.knots.proper_pieces().size(), 3U);
  EXPECT_EQ(surface.knots.domain_begin(), Q(1));
  EXPECT_EQ(surface.knots.domain_end(), Q(4));
  expect_rails<4>(surface, c1, c2, sigma);
}

TEST(QuasiSurface, UnclampedMappingsAndCornersOfTheRails) {
  const Spline<Q, Point3> c1 = drawn<3>(knots(3, {0, 0, 1, 2, 2, 2, 3, 4, 4}), 6);  // a corner at 2
  const Spline<Q, Point3> c2 = drawn<3>(knots(2, {-1, 0, 4, 5}), 7);
  const Mapping<Q> sigma = rising(knots(3, {0, 1, 1, 2, 3, 4}), Q(0), Q(4), 8);
  const RuledSpline<Q, Point3> surface = quasi_surface(c1, c2, sigma);
  EXPECT_EQ(surface.knots.degree(), 6);
  EXPECT_EQ(surface.knots.proper_pieces().size(), 1U);
  expect_rails<3>(surface, c1, c2, sigma);
}

TEST(QuasiSurface, AConstantPieceGivesACone) {
  const Spline<Q, Point3> c1 = drawn<3>(knots(2, {0, 0, 3, 3}), 9);
  const Spline<Q, Point3> c2 = drawn<3>(knots(2, {0, 0, 1, 2, 2}), 10);
  // Constant at C2's knot 1 over [1, 2]: the coefficients of that piece are 1, 1, 1.
  const Mapping<Q> sigma = mapping_of(knots(2, {0, 0, 1, 2, 3, 3}), {Q(0), Q(1), Q(1), Q(1), Q(2)});
  const RuledSpline<Q, Point3> surface = quasi_surface(c1, c2, sigma);
  ASSERT_EQ(surface.d.size(), 13U);
  for (std::size_t i = 4; i <= 8; ++i) EXPECT_EQ(surface.d[i], by_basis<3>(c2, Q(1)));
  expect_rails<3>(surface, c1, c2, sigma);
}

TEST(QuasiSurface, RefusesWhatIsNotItsCase) {
  const Spline<Q, Point3> c1 = drawn<3>(bezier_knots<Q>(2), 11);
  const Spline<Q, Point3> c2 = drawn<3>(KnotList<Q>(2, {Q(0), Q(0), ratio<Q>(1, 3), Q(1), Q(1)}), 12);
  const auto refused = [&](const Mapping<Q>& sigma, const std::string& word) {
    try {
      quasi_surface(c1, c2, sigma);
      ADD_FAILURE() << "expected an error with " << word;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.place(), "sigma");
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused(identity_mapping(bezier_knots<Q>(2)), "one of these lies inside [0, 1]");
  const Spline<Q, Point3> late = drawn<3>(KnotList<Q>(2, {Q(0), Q(0), ratio<Q>(3, 4), Q(1), Q(1)}), 12);
  EXPECT_THROW(quasi_surface(c1, late, identity_mapping(bezier_knots<Q>(2))), InvalidInput);
  refused(mapping_of(bezier_knots<Q>(1), {Q(0), Q(2)}), "found [0, 2]");
  refused(mapping_of(bezier_knots<Q>(1), {ratio<Q>(1, 4), Q(0)}), "increases");
  refused(identity_mapping(bezier_knots<Q>(1, Q(0), Q(2))), "first rail");
}

using Point3d = Vec<double, 3>;

KnotList<double> rounded(const KnotList<Q>& u) {
  std::vector<double> list;
  for (const Q& t : u.list()) list.push_back(t.to_double());
  return KnotList<double>(u.degree(), list);
}

Spline<double, Point3d> rounded(const Spline<Q, Point3>& spline) {
  std::vector<Point3d> row;
  for (const Point3& p : spline.control) row.push_back(Point3d(p[0].to_double(), p[1].to_double(), p[2].to_double()));
  return Spline<double, Point3d>(rounded(spline.knots), row);
}

TEST(QuasiSurface, InDoublesTheIdentityAddsNoPieces) {
  const Spline<Q, Point3> c1 = drawn<3>(fig4_rails(), 1);
  const Spline<Q, Point3> c2 = drawn<3>(fig4_rails(), 2);
  const RuledSpline<Q, Point3> exact = quasi_surface(c1, c2, identity_mapping(fig4_mapping()));
  const Mapping<double> sigma =
      with_preimages(identity_mapping(rounded(fig4_mapping())), rounded(c1.knots), rounded(c2.knots));
  const RuledSpline<double, Point3d> surface = quasi_surface(rounded(c1), rounded(c2), sigma);
  ASSERT_EQ(surface.d.size(), exact.d.size());
  ASSERT_EQ(surface.d.size(), 49U);
  for (std::size_t i = 0; i < exact.d.size(); ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(surface.c[i][j], exact.c[i][j].to_double(), 1e-12);
      EXPECT_NEAR(surface.d[i][j], exact.d[i][j].to_double(), 1e-12);
    }
  }
}

/// Down to neighbouring numbers: the root of 1/2, and 1/2 where t^2 is 1/4 exactly.
TEST(QuasiSurface, PreimagesAreAsNearAsNumbersAre) {
  const Mapping<double> square = mapping_of(KnotList<double>(2, {0.25, 0.25, 1, 1}), {0.0625, 0.25, 1.0});
  const Mapping<double> fine =
      with_preimages(square, KnotList<double>(1, {0.25, 1}), KnotList<double>(1, {0, 0.25, 0.5, 1}));
  ASSERT_EQ(fine.knots.size(), 6);
  EXPECT_EQ(fine.knots[2], 0.5);
  EXPECT_NEAR(fine.knots[3], std::sqrt(0.5), 0x1p-52);
}

/// The pieces of [2, 3] and [3, 6] over knots of their own and over even ones.
TEST(JoinPieces, KnotsOfTheMappingOrEvenOnes) {
  const auto piece = [](double from, double to) {
    return SurfacePiece<Vec<double, 1>>{{Vec<double, 1>(from), Vec<double, 1>(to)},
                                        {Vec<double, 1>(-from), Vec<double, 1>(-to)}};
  };
  const std::vector<double> list{2, 3, 6};
  const std::vector<SurfacePiece<Vec<double, 1>>> pieces{piece(10, 20), piece(20, 40)};
  const auto own = join_pieces<double, Vec<double, 1>>(list, pieces, 1);
  EXPECT_EQ(own.knots.list(), list);
  const auto even = join_pieces<double, Vec<double, 1>>(list, pieces, 1, SurfaceKnots::uniform);
  EXPECT_EQ(even.knots.list(), (std::vector<double>{2, 4, 6}));
  ASSERT_EQ(even.c.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(even.c[i][0], (std::array{10, 20, 40})[i]);
    EXPECT_EQ(even.d[i][0], -even.c[i][0]);
  }
}

TEST(QuasiSurface, InDoublesThePreimageIsAKnot) {
  // t^2 passes 1/2 at the root of 1/2.
  const Mapping<double> square = mapping_of(bezier_knots<double>(2), {0.0, 0.0, 1.0});
  const Mapping<double> fine = with_preimages(square, rounded(fig4_rails()), rounded(fig4_rails()));
  ASSERT_EQ(fine.knots.size(), 5);
  EXPECT_DOUBLE_EQ(fine.knots[2], std::sqrt(0.5));
  const Spline<double, Point3d> c1 = rounded(drawn<3>(fig4_rails(), 1));
  const Spline<double, Point3d> c2 = rounded(drawn<3>(fig4_rails(), 2));
  const RuledSpline<double, Point3d> surface = quasi_surface(c1, c2, fine);
  EXPECT_EQ(surface.c.size(), 19U);  // 0, 1/2, its root, 1
  for (int i = 1; i < 100; ++i) {
    const double t = i / 100.0;
    const auto at = [](const Spline<double, Point3d>& c, double x) {
      return curve_point(c.knots, c.points(), piece_at(c.knots, x), x);
    };
    const Point3d found = at(Spline<double, Point3d>(surface.knots, surface.d), t);
    EXPECT_LT((found - at(c2, t * t)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace torse::test
