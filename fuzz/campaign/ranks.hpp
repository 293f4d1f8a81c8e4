// The processes of a campaign that MPI has started, as the plugin torse_mpi.so gives them: bytes from one to another.
//   Ranks       this process and the others          ranks_entry      the name of the function that makes it
#pragma once

#include <string>

namespace torse::fuzz {

/// The processes; rank 0 leads. One thread uses it. Nothing is thrown: MPI ends all processes where a message cannot be
/// sent.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const noexcept = 0;
  virtual int size() const noexcept = 0;
  virtual void send(int to, const std::string& bytes) noexcept = 0;
  /// The next message from anybody, if one has come: its sender, or -1.
  virtual int receive(std::string& bytes) noexcept = 0;
  /// Ends this process's part, after its last message. A process that ends without it ends all the others.
  virtual void finish() noexcept = 0;
};

/// The symbol of the plugin, an extern "C" function of this type; the object lives as long as the plugin is loaded.
inline constexpr const char* ranks_entry = "torse_mpi_ranks";
using RanksEntry = Ranks* (*)();

}  // namespace torse::fuzz
