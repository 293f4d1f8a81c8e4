#include "torse/fuzz/draw/rough.hpp"

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {

template <int D>
void roughen(Choices& choices, Net<D>& net) {
  const Rational step = power_of_two(-choices.pick({3, 0, 10, 30}));
  for (Vec<Rational, D>& x : net.d) {
    for (int j = D - 3; j < D; ++j) x[j] += step * Rational(choices.between(-8, 8)) / Rational(8);
  }
  net = {.knots = net.knots, .c = net.c, .d = net.d, .made = "rough"};
  net.developable = plain::holds_by_samples(plain::strip_of(net.knots, net.c, net.d));
  net.klass = net.developable ? "unknown" : "none";
}

template void roughen<3>(Choices&, Net<3>&);
template void roughen<4>(Choices&, Net<4>&);

}  // namespace torse::fuzz
