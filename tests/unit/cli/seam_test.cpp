// The search for the seam of closed rails.
#include "torse/cli/seam.hpp"

#include <gtest/gtest.h>

#include "support/program.hpp"
#include "torse/cli/fitting.hpp"
#include "torse/spline/closed.hpp"

namespace torse::cli {
namespace {

using Q = Rational;

/// The rails of a hat's brim, the rim from another point on.
RailsFile<Q> turned_brim(const Q& begin) {
  const std::string file = TORSE_SOURCE_PATH "/examples/hat-brim.json";
  RailsFile<Q> rails = read_rails<Q>(Document(file, testing::slurp(file)));
  const Spline<Q, Vec<Q, 4>> moved = rotated(Spline<Q, Vec<Q, 4>>(rails.d.knots, homogeneous(rails.d.net)), begin);
  rails.d = {moved.knots, dehomogenize<Q, 4>(moved.control)};
  return rails;
}

/// With 8 coefficients these rails do best from another place on than with 20, which is what 8 coefficients say there.
TEST(Seam, IsThatOfFitsWithAsFewCoefficientsAsAreWanted) {
  const RailsFile<Q> rails = turned_brim(ratio<Q>(17, 45));
  const auto wished = [](int coefficients) {
    return quasi::FitOptions{.degree = 2, .coefficients = coefficients, .adaptive = false};
  };
  const auto measure = [&](int seam_of) {
    const std::optional<Seam> seam = best_seam(rails, wished(seam_of));
    return quasi::fit_rails(unit_rails(seam.value().rails), wished(8)).value;
  };
  EXPECT_LT(measure(8), measure(20));
}

}  // namespace
}  // namespace torse::cli
