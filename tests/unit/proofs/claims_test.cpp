// What single claims assert, where nothing but one of their assertions stands between them and a wrong variant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/claims/fj21/features.hpp"

namespace torse::proofs {
namespace {

using testing::ElementsAre;

TEST(Claims, AMoebiusTransformationMapsTheIntervalIntoItself) {
  // The equations alone say what t(u) is; 0 < t(u) < 1 is two values: t and 1 - t. For b = 2 and u = 1/3, t = 1/5.
  const fj21::Eq5_1::In<Rational, Vec<Rational, 1>> in{
      {Vec<Rational, 1>{Rational(0)}, Vec<Rational, 1>{Rational(1)}}, Rational(2), Rational(1), Rational(2)};
  Equations<Rational> equations;
  fj21::Eq5_1::residual<Rational, Vec<Rational, 1>>(in, Mutant(), equations);
  EXPECT_THAT(equations.positives(), ElementsAre(ratio<Rational>(1, 5), ratio<Rational>(4, 5)));
}

}  // namespace
}  // namespace torse::proofs
