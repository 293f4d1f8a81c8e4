#include "torse/exact/ball/ball.hpp"
#include "torse/fuzz/properties/agreement.hpp"

namespace torse::fuzz {

using Enclosure = Ball<128>;

bool hold_in_balls(const Construction::In& in, const SurfaceOver<Rational>& exact) {
  const auto lift = [](const Rational& x) { return Enclosure::rational(x.text()); };
  try {
    const auto surface = construct<Enclosure>(in.input.method, ingredients<Enclosure>(in.input, lift));
    require_same_numbers(surface, exact, [](const Enclosure& x, const Rational& y) { return x.contains(y.text()); });
    require_no_witness(surface);
    return true;
  } catch (const Undecided&) {  // the equality of knots and the choice of a pivot may be open
    return false;
  }
}

}  // namespace torse::fuzz
