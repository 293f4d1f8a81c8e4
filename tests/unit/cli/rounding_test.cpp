// Numbers rounded for a CAD file, and what is said of it; two exit codes as one.
#include "torse/cli/rounding.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"

namespace torse::cli {
namespace {

/// A square, with a coordinate of one corner replaced.
RuledFile<Rational> square(const std::string& coordinate) {
  const Rational zero(0);
  const Rational one(1);
  RuledFile<Rational> file{KnotList<Rational>(1, {zero, one}), {}, {}};
  file.c = {{Vec<Rational, 3>(zero, zero, zero), Vec<Rational, 3>(Rational::from_text(coordinate), zero, zero)},
            {one, one}};
  file.d = {{Vec<Rational, 3>(zero, one, zero), Vec<Rational, 3>(one, one, zero)}, {one, one}};
  return file;
}

TEST(Rounding, TheShiftIsABoundOfTheChange) {
  for (const char* coordinate :
       {"1/3", "2/3", "1", "300000000000000004/3", "1000000000000000000001/7", "1/1000000007"}) {
    const Rational exact = Rational::from_text(coordinate);
    const RoundedSurface rounded = round_surface(square(coordinate));
    const Rational change = rounded.surface.c.points[1][0] - exact;
    const Rational size = change.sign() < 0 ? -change : change;
    const Rational shift = Rational::from_double(rounded.shift);
    EXPECT_FALSE(shift < size) << coordinate;
    EXPECT_FALSE(size + size / Rational(1LL << 52) < shift) << coordinate;
    EXPECT_EQ(rounded.changed, size.sign() == 0 ? 0U : 1U) << coordinate;
  }
}

TEST(ExitCodes, OfTwoRunsTheWorseCounts) {
  const std::array order{exit_code::success, exit_code::undecided, exit_code::refuted, exit_code::unusable};
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = 0; j < order.size(); ++j) {
      EXPECT_EQ(exit_code::worse(order[i], order[j]), order[std::max(i, j)]);
    }
  }
}

}  // namespace
}  // namespace torse::cli
