// Integrals over the stretches.
#include "torse/exact/unroll/measure.hpp"

#include <acb_calc.h>

#include "torse/exact/unroll/stretch.hpp"

namespace torse {
namespace {

using Q = Rational;
using arb::Complex;
using arb::Real;

/// Relative accuracy of the quadrature; the results are rounded to doubles.
constexpr slong goal = 64;

/// The absolute accuracy below any length in doubles (2^-1074) that ends the search for digits of an integral that is
/// 0.
constexpr slong negligible = -1200;

using Density = DiscBall (*)(const Strip<DiscBall>&);

struct Integrand {
  const Stretch& stretch;
  Density density;
};

int evaluate(acb_ptr out, const acb_t tau, void* param, slong, slong) {
  const Integrand& integrand = *static_cast<const Integrand*>(param);
  Complex z;
  acb_set(z.get(), tau);
  acb_set(out, integrand.density(integrand.stretch.at(z)).value.get());
  return 0;
}

/// A bound of a density on a breaking stretch times its length.
void add_breaking(Real& sum, const Stretch& stretch, Density density) {
  const slong bits = stretch.bits();
  Complex z;
  Real width = arb::real((stretch.to() - stretch.from()) / Q(2), bits);
  acb_set_arb(z.get(), arb::real((stretch.to() + stretch.from()) / Q(2), bits).get());
  arb_add_error(acb_realref(z.get()), width.get());
  Real size;
  acb_abs(size.get(), density(stretch.at(z)).value.get(), bits);
  arb_mul_2exp_si(width.get(), width.get(), 1);
  arb_mul(size.get(), size.get(), width.get(), bits);
  arb_add_error(sum.get(), size.get());
}

void add_integral(Real& sum, const Stretch& stretch, Density density) {
  if (stretch.breaking()) return add_breaking(sum, stretch, density);
  const slong bits = stretch.bits();
  Integrand integrand{stretch, density};
  Complex from;
  Complex to;
  Complex value;
  acb_set_arb(from.get(), arb::real(stretch.from(), bits).get());
  acb_set_arb(to.get(), arb::real(stretch.to(), bits).get());
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, negligible);
  acb_calc_integrate(value.get(), evaluate, &integrand, from.get(), to.get(), goal, tolerance, nullptr, bits);
  mag_clear(tolerance);
  arb_add(sum.get(), sum.get(), acb_realref(value.get()), bits);
}

Interval integral(const std::vector<std::vector<Stretch>>& parts, Density density) {
  Real sum;
  for (const std::vector<Stretch>& list : parts) {
    for (const Stretch& stretch : list) add_integral(sum, stretch, density);
  }
  const Interval value = arb::enclosure(sum);
  return Interval::hull(std::max(value.lower(), 0.0), value.upper());
}

}  // namespace

SurfaceMeasures measure(const std::vector<PieceStrip>& strips) {
  std::vector<std::vector<Stretch>> parts;
  for (const PieceStrip& strip : strips) parts.push_back(stretches(strip, {}));
  return {integral(parts, speed_c<DiscBall>), integral(parts, speed_d<DiscBall>),
          integral(parts, planar_density<DiscBall>)};
}

}  // namespace torse
