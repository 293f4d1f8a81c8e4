// Every property of fuzz/, drawn by RapidCheck and run through its saved file, and on the first seeds of a campaign.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/rapidcheck.hpp"
#include "torse/fuzz/run.hpp"

namespace torse::fuzz {
namespace {

class EveryProperty : public ::testing::TestWithParam<const Property*> {};

TEST_P(EveryProperty, HoldsUnderRapidCheck) { rc::detail::checkGTest(testable(*GetParam())); }

TEST_P(EveryProperty, HoldsOnTheFirstSeedsAndMeetsWhatItMustMeet) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 20; ++seed) tally.add(run_seed(*GetParam(), proofs::Effort::quick, seed));
  for (const SavedCase& failure : tally.failures) ADD_FAILURE() << failure.message << '\n' << failure.text;
  EXPECT_EQ(vacuity(*GetParam(), tally), "");
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryProperty, ::testing::ValuesIn(properties()), [](const auto& param) {
  std::string name(param.param->info().name);
  for (char& ch : name) {
    if (ch == '.') ch = '_';
  }
  return name;
});

TEST(Properties, HaveNamesOfTheirOwnAndAreAllThere) {
  std::set<std::string_view> names;
  for (const Property* property : properties()) names.insert(property->info().name);
  EXPECT_EQ(names.size(), properties().size());
  EXPECT_EQ(properties().size(), 32U);
}

}  // namespace
}  // namespace torse::fuzz
