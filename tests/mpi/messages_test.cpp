// Messages between ranks by themselves: the test starts itself under mpirun.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "mpi/variables.hpp"
#include "support/process.hpp"
#include "torse/cli/plugin.hpp"
#include "torse/fuzz/campaign/ranks.hpp"

namespace torse::testing {
namespace {

/// Bytes that are different at all places where a message could be cut or joined.
std::string long_message(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>((i * 2654435761U) >> 13U);
  return bytes;
}

const std::size_t sizes[] = {0, 1, 65536, 65537, 3000000};

/// Rank 1 sends, rank 0 sends the same back.
void echo(fuzz::Ranks& ranks) {
  const auto next = [&](std::string& bytes) {
    int from = -1;
    while (from < 0) from = ranks.receive(bytes);
    return from;
  };
  for (const std::size_t size : sizes) {
    std::string bytes;
    if (ranks.rank() == 0) {
      ASSERT_EQ(next(bytes), 1);
      ranks.send(1, bytes);
    } else {
      ranks.send(0, long_message(size));
      ASSERT_EQ(next(bytes), 0);
    }
    ASSERT_TRUE(bytes == long_message(size)) << "rank " << ranks.rank() << ": " << bytes.size() << " of " << size;
  }
}

TEST(Messages, OfManyBytesArriveWhole) {
  if (std::getenv("OMPI_COMM_WORLD_RANK") != nullptr) {
    const auto plugin = std::filesystem::path(TORSE_PROGRAM_PATH).parent_path() / "torse_mpi.so";
    fuzz::Ranks& ranks = *reinterpret_cast<fuzz::RanksEntry>(cli::plugin_symbol(plugin, fuzz::ranks_entry))();
    ASSERT_EQ(ranks.size(), 2);
    echo(ranks);
    ranks.finish();
    return;
  }
  const Scratch scratch;
  Process job({"mpirun", "-n", "2", std::filesystem::read_symlink("/proc/self/exe"),
               "--gtest_filter=Messages.OfManyBytesArriveWhole", "--gtest_color=no"},
              mpi_variables, scratch / "output");
  EXPECT_EQ(job.wait(), 0) << job.output();
  EXPECT_NE(job.output().find("[  PASSED  ] 1 test."), std::string::npos) << job.output();
}

}  // namespace
}  // namespace torse::testing
