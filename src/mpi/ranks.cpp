// The plugin torse_mpi: torse::fuzz::Ranks by MPI. What goes wrong in MPI ends all processes, as MPI itself does it.
#include <mpi.h>

#include <cstddef>

#include "torse/fuzz/campaign/ranks.hpp"

namespace torse::mpi {
namespace {

class World final : public fuzz::Ranks {
 public:
  World() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  int rank() const noexcept override { return rank_; }
  int size() const noexcept override { return size_; }

  void send(int to, const std::string& bytes) noexcept override {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD);
  }

  int receive(std::string& bytes) noexcept override {
    int come = 0;
    MPI_Message message{};
    MPI_Status status{};
    MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &come, &message, &status);
    if (come == 0) return -1;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    bytes.resize(static_cast<std::size_t>(size));
    MPI_Mrecv(bytes.data(), size, MPI_BYTE, &message, &status);
    return status.MPI_SOURCE;
  }

  void finish() noexcept override { MPI_Finalize(); }

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace
}  // namespace torse::mpi

extern "C" __attribute__((visibility("default"))) torse::fuzz::Ranks* torse_mpi_ranks() {
  static torse::mpi::World world;
  return &world;
}
