// The routes over rationals with derivatives.
#include "torse/exact/instrumented/dual.hpp"
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Sensitivities sensitivities(std::size_t route, const Case& in) {
  using S = Dual<Rational>;
  std::size_t inputs = 0;
  const Inputs<S> lifted = lift<S>(in, [&](float x, std::size_t slot) {
    inputs = slot + 1;
    return S::variable(Rational::from_double(x), slot);
  });
  Sensitivities result;
  for (const S& x : route_table<S>()[route].run(lifted)) {
    result.values.push_back(x.value());
    std::vector<Rational> gradient;
    for (std::size_t k = 0; k < inputs; ++k) gradient.push_back(x.derivative(k));
    result.derivatives.push_back(std::move(gradient));
  }
  return result;
}

}  // namespace torse::studies
