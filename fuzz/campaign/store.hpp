// The database of a campaign: every unit once.
//   RunInfo, Failure, StoredUnit     rows
//   Store                            the database   Units       the units of a series, one after the other
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "torse/fuzz/campaign/plan.hpp"
#include "torse/fuzz/campaign/sqlite.hpp"

namespace torse::fuzz {

/// A run of the program that has added units.
struct RunInfo {
  std::string token;    ///< tells it from every other run
  std::string started;  ///< "2026-11-22T08:44:22Z"
  std::string version;  ///< of torse
  std::string build;    ///< the same for the same program only
  std::string options;  ///< in words
  double seconds = 0;   ///< up to the last units that were stored
};

/// A failing case.
struct Failure {
  Series series;
  SavedCase saved;
  std::string build;  ///< of the run that found it
};

/// A unit and the run that it came from.
struct StoredUnit {
  UnitResult result;
  std::int64_t run = 0;
};

/// Whether a unit was new, there already with the same result, or there with another one.
enum class Put { added, known, contradiction };

/// A database of units. All that is written in one Transaction of `database()` is stored together. Errors are
/// FileError.
class Store {
 public:
  /// Opens a database. With Open::create, a file that is not there or is empty becomes one.
  Store(const std::string& file, Database::Open how);

  const std::string& file() const { return database_.file(); }
  const Database& database() const { return database_; }

  /// The number of a run, which is stored if it is new; its seconds become the greater ones.
  std::int64_t put_run(const RunInfo& run);
  /// Stores a unit, the first time. Of equal results that of the run which began later stays, whichever was put first.
  Put put(const UnitResult& result, std::int64_t run);
  /// The same for a unit that has just been run: what failed under another build gives way to it, equal or not.
  Put put_anew(const UnitResult& result, std::int64_t run);

  /// By the numbers that the units refer to.
  std::map<std::int64_t, RunInfo> runs();
  std::vector<Series> series();
  std::uint64_t unit_count(const Series& series, const Seeds& seeds);
  /// The seeds that need not be run again by this build.
  SeedSet settled(const Series& series, const Seeds& seeds, const std::string& build);
  /// The sum of the units, without their failures.
  UnitResult total(const Series& series, const Seeds& seeds);
  /// Of the run whose result for this unit is stored, or empty.
  std::string build_of(const Series& series, std::uint64_t seed);
  /// By seed and case.
  std::vector<Failure> failures(const Series& series, const Seeds& seeds);

 private:
  friend class Units;

  std::optional<std::int64_t> find_series(const Series& series);
  std::int64_t add_series(const Series& series);
  bool began_later(std::int64_t run, std::int64_t other);
  bool add_unit(std::int64_t number, const UnitResult& result, std::int64_t run);
  void put_distribution(std::int64_t number, std::uint64_t seed, const char* kind, const Distribution& distribution);
  void erase(std::int64_t number, std::uint64_t seed);

  Database database_;
  Statement find_series_;
  Statement find_outdated_;
  Statement add_unit_;
  Statement add_count_;
  Statement add_label_;
};

/// The units of a series with these seeds in ascending order, with everything that is stored of them.
class Units {
 public:
  Units(Store& store, const Series& series, const Seeds& seeds);
  /// The next unit; none behind the last.
  std::optional<StoredUnit> next();

 private:
  Series series_;
  std::int64_t number_;
  Statement units_;
  Statement counts_;
  Statement failures_;
};

}  // namespace torse::fuzz
