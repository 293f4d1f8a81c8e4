// The instrumented scalars obey the laws of what they wrap; Degree never contradicts one.
#include "laws/laws.hpp"
#include "torse/exact/instrumented/counting.hpp"
#include "torse/exact/instrumented/degree.hpp"
#include "torse/exact/instrumented/dual.hpp"
#include "torse/exact/instrumented/faulty.hpp"
#include "torse/exact/instrumented/shadow.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/scalar/builtin.hpp"

namespace torse::laws {

template <>
struct Samples<Counting<Rational>> : FractionSamples<Counting<Rational>> {};
template <>
struct Samples<Faulty<Rational>> : FractionSamples<Faulty<Rational>> {};
template <>
struct Samples<Dual<Rational>> : FractionSamples<Dual<Rational>> {};

template <>
struct Samples<Shadow> : DyadicSamples<Shadow> {
  static constexpr bool throws_on_zero = true;
};

template <>
struct Samples<Degree> : DyadicSamples<Degree> {
  /// Degree bounds values without knowing them.
  static constexpr bool decided = false;

  static Degree any(Rng& rng) { return rng() % 2 == 0 ? DyadicSamples<Degree>::any(rng) : unit(rng); }
  static Degree unit(Rng& rng) { return Degree::input() * Degree::input() / (Degree::input() + Degree(rng() % 3)); }
};

using Exact = testing::Types<Counting<Rational>, Faulty<Rational>, Dual<Rational>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Instrumented, RingLaws, Exact, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Instrumented, FieldLaws, Exact, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Instrumented, OrderLaws, Exact, ScalarName);

using Rounded = testing::Types<Counting<double>, Faulty<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedDouble, RingLaws, Rounded, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedDouble, FieldLaws, Rounded, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedDouble, OrderLaws, Rounded, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedDouble, RealLaws, Rounded, ScalarName);

using Recorded = testing::Types<Shadow>;
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedRecord, RingLaws, Recorded, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedRecord, FieldLaws, Recorded, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedRecord, OrderLaws, Recorded, ScalarName);

INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedBounds, RingLaws, Degree, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(InstrumentedBounds, FieldLaws, Degree, ScalarName);

}  // namespace torse::laws
