// Running a study: cases in order, by all threads, kept in a journal that a killed run goes on from.
//   Task            a design with effort, seed and the part of its cases
//   case_record     the result of one case, a line of JSON
//   Journal         the records of a run that has not ended
//   run_study       the lines of all cases
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "torse/studies/design.hpp"

namespace torse::studies {

/// What is to be run.
struct Task {
  Design design;
  proofs::Effort effort = proofs::Effort::standard;
  std::uint64_t seed = 1;
  std::size_t shard = 0;
  std::size_t shards = 1;

  Block block() const { return design.block(effort, shard, shards); }
  /// Everything that the records depend on, in words.
  std::string key() const;
};

/// One case as a line of JSON without its end. It depends on the design, the seed and the case only.
std::string case_record(const Task& task, std::size_t number);

/// Records in a file beside the results, so that nothing is lost when the program is killed.
class Journal {
 public:
  /// Opens or makes the file. With `resume` it goes on from the records there; throws FileError where they are of
  /// another run. Without, it begins anew.
  Journal(const std::string& file, const Task& task, const std::string& build, bool resume);
  ~Journal();

  /// The record of a case, empty where there is none.
  std::string record(std::size_t number);
  /// Stores records all at once.
  void store(const std::vector<std::pair<std::size_t, std::string>>& records);
  /// Removes the file: the results are written.
  void remove();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All records in order. `journal` may be null; `progress` is called with what is done and what there is.
std::vector<std::string> run_study(const Task& task, unsigned threads, Journal* journal,
                                   const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace torse::studies
