// The same seed gives the same cases, verdicts and counts on whatever thread it runs, and beside whatever else.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "torse/exact/symbolic/thread_cache.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/run.hpp"

namespace torse::fuzz {
namespace {

constexpr std::uint64_t seed = 7;

Tally tally_of(std::size_t i) { return run_seed(*properties()[i], proofs::Effort::quick, seed); }

TEST(Threads, DoNotChangeWhatASeedComesTo) {
  const std::size_t count = properties().size();
  std::vector<Tally> alone;
  for (std::size_t i = 0; i < count; ++i) alone.push_back(tally_of(i));

  constexpr std::size_t threads = 3;
  std::vector<Tally> together(count);
  std::vector<std::thread> running;
  for (std::size_t first = 0; first < threads; ++first) {
    running.emplace_back([&together, first, count] {
      for (std::size_t i = first; i < count; i += threads) together[count - 1 - i] = tally_of(count - 1 - i);
      release_flint_cache();
    });
  }
  for (std::thread& thread : running) thread.join();
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(together[i], alone[i]) << properties()[i]->info().name;
}

}  // namespace
}  // namespace torse::fuzz
