#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/fuzz/properties/agreement.hpp"

namespace torse::fuzz {

void require_in_cpp(const Construction::In& in, const SurfaceOver<Rational>& exact) {
  const auto lift = [](const Rational& x) { return CppRational::from_text(x.text()); };
  const auto surface = construct<CppRational>(in.input.method, ingredients<CppRational>(in.input, lift));
  require_same_numbers(surface, exact, [](const CppRational& x, const Rational& y) { return x.text() == y.text(); });
  require_no_witness(surface);
}

}  // namespace torse::fuzz
