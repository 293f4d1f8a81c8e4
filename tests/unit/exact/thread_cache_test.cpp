// What a thread gives back: FLINT calls the functions that have been left with it for the purpose.
#include "torse/exact/symbolic/thread_cache.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "torse/exact/symbolic/flint_headers.hpp"

namespace torse {
namespace {

thread_local int cleaned = 0;

void count_cleaning() { ++cleaned; }

TEST(ThreadCache, IsGivenBackWhenAskedFor) {
  int before = 0, after = 0;
  std::thread worker([&] {
    flint_register_cleanup_function(count_cleaning);
    before = cleaned;
    release_flint_cache();
    after = cleaned;
  });
  worker.join();
  EXPECT_EQ(before, 0);
  EXPECT_EQ(after, 1);
}

}  // namespace
}  // namespace torse
