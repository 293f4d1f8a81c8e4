// The warp angle of a ruling and its derivatives: products against polynomials in T over the rationals, the angle
// against the square of its sine, its derivatives against differences in 256 bits.
#include "torse/quasi/ruling_angle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "rails.hpp"
#include "torse/developable/warp.hpp"
#include "torse/exact/bigfloat/bigfloat.hpp"

namespace torse::quasi {
namespace {

using test::Polynomials;
using test::Q;
using F = Polynomial<Q>;

/// The ruling from c with the tangent a to points of d, with the products as polynomials in T.
struct Case {
  Vec<Q, 3> c;
  Vec<Q, 3> a;
  Polynomials d;
  F cosine, volume, square;
};

Polynomials product(const Polynomials& x, const Polynomials& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

F inner(const Polynomials& x, const Polynomials& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

Polynomials constants(const Vec<Q, 3>& x) { return {F::constant(x[0]), F::constant(x[1]), F::constant(x[2])}; }

Case drawn(std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const auto draw = [&] {
    const Q x = test::sixteenths(rng), y = test::sixteenths(rng);
    return Vec<Q, 3>(x, y, test::sixteenths(rng));
  };
  Case it{draw(), draw(), {}, {}, {}, {}};
  for (F& x : it.d) x = F(std::vector<Q>{Q(1), test::sixteenths(rng), test::sixteenths(rng), test::sixteenths(rng)});
  const Polynomials a = constants(it.a), b = test::derivative(it.d),
                    w = test::plus(it.d, test::times(F(-1), constants(it.c)));
  it.cosine = inner(product(a, w), product(b, w));
  it.volume = inner(product(a, w), b);
  it.square = inner(w, w);
  return it;
}

Vec<Q, 3> at(const Polynomials& f, const Q& t) { return {f[0](t), f[1](t), f[2](t)}; }

RulingTerms<Q> terms_at(const Case& it, const Q& t) {
  const Polynomials b = test::derivative(it.d), e = test::derivative(b), f = test::derivative(e);
  const Vec<Q, 3> point = at(it.d, t);
  return ruling_terms<Q>(it.a, Vec<Q, 3>(point[0] - it.c[0], point[1] - it.c[1], point[2] - it.c[2]), at(b, t),
                         at(e, t), at(f, t));
}

Vector rounded(const Vec<Q, 3>& x) { return {x[0].to_double(), x[1].to_double(), x[2].to_double()}; }

RulingAngle angle_at(const Case& it, const Q& t, AngleKind kind) {
  const Polynomials b = test::derivative(it.d), e = test::derivative(b), f = test::derivative(e);
  const RailJet c{rounded(it.c), rounded(it.a), Vector::Zero(), Vector::Zero()};
  return ruling_angle(c, {rounded(at(it.d, t)), rounded(at(b, t)), rounded(at(e, t)), rounded(at(f, t))}, kind);
}

TEST(RulingTerms, AreTheProductsAndTheirDerivatives) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Case it = drawn(seed);
    for (const Q& t : {Q(0), ratio<Q>(2, 7), Q(1), Q(-3)}) {
      const RulingTerms<Q> terms = terms_at(it, t);
      for (const auto& [found, f] : {std::pair{terms.cosine, it.cosine}, std::pair{terms.volume, it.volume},
                                     std::pair{terms.square, it.square}}) {
        EXPECT_EQ(found.value, f(t));
        EXPECT_EQ(found.first, f.derivative()(t));
        EXPECT_EQ(found.second, f.derivative().derivative()(t));
      }
    }
  }
}

TEST(RulingAngle, ItsSineIsTheWarpAngles) {
  int folded = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Case it = drawn(seed);
    const Q t = ratio<Q>(static_cast<int>(seed % 9), 8);
    // The first rail as a segment with the direction a: only its point and tangent at its begin count.
    const std::vector<Vec<Q, 3>> c{it.c, Vec<Q, 3>(it.c[0] + it.a[0], it.c[1] + it.a[1], it.c[2] + it.a[2])};
    const Vec<Q, 3> b = at(test::derivative(it.d), t), p = at(it.d, t);
    const std::vector<Vec<Q, 3>> d{p, Vec<Q, 3>(p[0] + b[0], p[1] + b[1], p[2] + b[2])};
    const Q exact = pointwise_sine_squared<Q>(bezier_knots<Q>(1), c, d, 1, Q(0));

    const RulingAngle planes = angle_at(it, t, AngleKind::planes);
    EXPECT_NEAR(std::pow(std::sin(planes.angle.value), 2), exact.to_double(), 1e-13);
    EXPECT_LE(std::abs(planes.angle.value), std::numbers::pi / 2);

    // With the normals as vectors: the cosine of the angle between them.
    const RulingAngle sides = angle_at(it, t, AngleKind::sides);
    const Vector w = rounded(p) - rounded(it.c), m = rounded(it.a).cross(w), n = rounded(b).cross(w);
    EXPECT_NEAR(std::cos(sides.angle.value), m.dot(n) / (m.norm() * n.norm()), 1e-13);
    EXPECT_EQ(sides.folded, it.cosine(t) < Q(0));
    EXPECT_EQ(planes.folded, sides.folded);
    EXPECT_NEAR(std::tan(planes.angle.value), std::tan(sides.angle.value),
                1e-9 * (1 + std::pow(std::tan(sides.angle.value), 2)));
    EXPECT_EQ(planes.angle.first, sides.angle.first);
    EXPECT_EQ(planes.angle.second, sides.angle.second);
    EXPECT_EQ(sides.angle.value > 0, it.volume(t) > Q(0));
    folded += sides.folded;
  }
  EXPECT_GT(folded, 10);
  EXPECT_LT(folded, 50);
}

constexpr int bits = 256;
using Big = BigFloat<bits>;

/// The oriented angle in 256 bits.
Big precise_angle(const Case& it, const Q& t) {
  const Big x = Big::from_rational(it.cosine(t));
  const Big y = Big::from_rational(it.square(t)).square_root() * Big::from_rational(it.volume(t));
  mpfr_t angle;
  mpfr_init2(angle, bits);
  mpfr_atan2(angle, y.mpfr(), x.mpfr(), MPFR_RNDN);
  mpq_t exact;
  mpq_init(exact);
  mpfr_get_q(exact, angle);
  const Big value = Big::from_rational(Rational::from_mpq(exact));
  mpq_clear(exact);
  mpfr_clear(angle);
  return value;
}

TEST(RulingAngle, DerivativesAreThoseOfTheAngle) {
  const Q h = Q(1) / Q(std::int64_t{1} << 40);  // central differences err by some h^2 = 2^-80, and 2^-256 / h^2
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Case it = drawn(seed);
    const Q t = ratio<Q>(static_cast<int>(seed % 5), 4);
    const Big before = precise_angle(it, t - h), here = precise_angle(it, t), after = precise_angle(it, t + h);
    const Big step = Big::from_rational(h);
    const Taylor<double> exact{here.to_double(), ((after - before) / (step + step)).to_double(),
                               ((after - here - here + before) / (step * step)).to_double()};
    const Taylor<double> found = angle_at(it, t, AngleKind::sides).angle;
    EXPECT_NEAR(found.value, exact.value, 1e-13);
    EXPECT_NEAR(found.first, exact.first, 1e-11 * (1 + std::pow(exact.first, 2)));
    EXPECT_NEAR(found.second, exact.second, 1e-11 * (1 + std::pow(exact.first, 2) + std::abs(exact.second)));
  }
}

TEST(RulingAngle, IsNotDefinedWhereANormalVanishes) {
  const Vector zero = Vector::Zero(), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const RailJet start{zero, x, zero, zero};
  for (const RailJet& end : {RailJet{zero, y, z, z},     // the rails meet
                             RailJet{x, y, z, z},        // the ruling is a tangent of the first rail
                             RailJet{y, y, z, z},        // of the second one
                             RailJet{y, zero, z, z}}) {  // a cusp
    for (const AngleKind kind : {AngleKind::planes, AngleKind::sides}) {
      const RulingAngle ruling = ruling_angle(start, end, kind);
      EXPECT_EQ(ruling.angle.value, 0);
      EXPECT_EQ(ruling.angle.first, 0);
      EXPECT_EQ(ruling.angle.second, 0);
      EXPECT_FALSE(ruling.folded);
    }
  }
}

TEST(RulingAngle, RightAnglesAndHalfTurns) {
  const Vector zero = Vector::Zero(), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const RailJet start{zero, x, zero, zero};
  // Seen along the ruling z the tangent turns from x to y, to -y and to -x.
  EXPECT_NEAR(std::abs(ruling_angle(start, {z, y, zero, zero}, AngleKind::planes).angle.value), std::numbers::pi / 2,
              1e-15);
  EXPECT_EQ(ruling_angle(start, {z, y, zero, zero}, AngleKind::sides).angle.value,
            -ruling_angle(start, {z, -y, zero, zero}, AngleKind::sides).angle.value);
  const RulingAngle back = ruling_angle(start, {z, -x, zero, zero}, AngleKind::planes);
  EXPECT_TRUE(back.folded);
  EXPECT_NEAR(back.angle.value, 0, 1e-15);
  EXPECT_NEAR(std::abs(ruling_angle(start, {z, -x, zero, zero}, AngleKind::sides).angle.value), std::numbers::pi,
              1e-15);
}

TEST(RulingAngle, SizesOfEveryKind) {
  const Case it = drawn(5);
  const RulingAngle plain = angle_at(it, ratio<Q>(1, 4), AngleKind::planes);
  const Polynomials b = test::derivative(it.d), e = test::derivative(b), f = test::derivative(e);
  const Q t = ratio<Q>(1, 4);
  for (const double size : {0x1p-20, 0x1p20, 0x1p-60, 0x1p60}) {
    const RailJet c{size * rounded(it.c), size * rounded(it.a), Vector::Zero(), Vector::Zero()};
    const RailJet d{size * rounded(at(it.d, t)), size * rounded(at(b, t)), size * rounded(at(e, t)),
                    size * rounded(at(f, t))};
    const RulingAngle scaled = ruling_angle(c, d, AngleKind::planes);
    EXPECT_EQ(scaled.angle.value, plain.angle.value);  // powers of two round nothing
    EXPECT_EQ(scaled.angle.first, plain.angle.first);
    EXPECT_EQ(scaled.angle.second, plain.angle.second);
  }
}

}  // namespace
}  // namespace torse::quasi
