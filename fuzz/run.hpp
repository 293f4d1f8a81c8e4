// Running properties on seeds.
//   SavedCase       a failing case, shrunk, as its file        Tally       what a run of cases came to
//   run_seed        all cases of a property for one seed       draw_case   the choices of one of them
//   shrink          the simplest failing case that is found    replay_case a saved case again
//   unmet           the labels that a property should have met and did not
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// A case that failed.
struct SavedCase {
  std::uint64_t seed = 0;
  int index = 0;        ///< its number among the cases of the seed
  std::string message;  ///< of the shrunk case
  std::string text;     ///< the JSON file that `torse replay` runs

  friend bool operator==(const SavedCase&, const SavedCase&) = default;
};

/// What a run of cases came to.
struct Tally {
  std::uint64_t cases = 0;  ///< held, failed and discarded
  std::uint64_t failed = 0;
  std::uint64_t discarded = 0;
  Distribution labels;              ///< of the cases that were not discarded
  Distribution discards;            ///< "reason" -> reason -> count
  std::vector<SavedCase> failures;  ///< the first ones of each seed

  void add(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// The choices of case `index` of a seed: a function of the property's name, the seed and the index alone.
Choices draw_case(const Property& property, std::uint64_t seed, int index);

/// All cases of one seed, property.info().batch of them. At most one failure is shrunk and saved.
Tally run_seed(const Property& property, proofs::Effort effort, std::uint64_t seed);

/// The record of the simplest failing case that is reached from a failing one, by at most `runs` runs.
Record shrink(const Property& property, const Scale& scale, Record failing, int runs = 2000);

/// Why this run proves nothing, in words, or an empty text: too many of the cases were discarded, or labels that the
/// property must meet were not, or those that most cases should have had were rare. Runs of fewer than
/// `property.info().batch` * 20 cases are too short to tell.
std::string vacuity(const Property& property, const Tally& tally);

/// {"torse": 1, "type": "case", "property": NAME, "input": {...}}.
std::string case_file(const Property& property, const std::string& input);

/// Runs the case of a document of type "case". Throws FileError for an unknown property or a wrong input.
CaseReport replay_case(const Document& document);

}  // namespace torse::fuzz
