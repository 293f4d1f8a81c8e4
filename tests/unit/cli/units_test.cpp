// Units of length by their definitions.
#include "torse/cli/units.hpp"

#include <gtest/gtest.h>

namespace torse::cli {
namespace {

using Q = Rational;

/// A foot is 12 inches, a mile 5280 feet, a mil the thousandth part and a microinch the millionth part of an inch.
TEST(Units, AreWhatTheyAreDefinedAs) {
  const Q inch = ratio<Q>(254, 10) / Q(1000);
  const Q million(1000000);
  const std::pair<const char*, Q> units[] = {{"mm", ratio<Q>(1, 1000)},
                                             {"cm", ratio<Q>(1, 100)},
                                             {"m", Q(1)},
                                             {"km", Q(1000)},
                                             {"um", Q(1) / million},
                                             {"in", inch},
                                             {"inch", inch},
                                             {"ft", Q(12) * inch},
                                             {"mi", Q(5280 * 12) * inch},
                                             {"mile", Q(63360) * inch},
                                             {"mil", inch / Q(1000)},
                                             {"uin", inch / million}};
  for (const auto& [name, metres] : units) {
    EXPECT_EQ(read_unit(name).metres, metres) << name;
  }
}

}  // namespace
}  // namespace torse::cli
