#include "torse/fuzz/campaign/store.hpp"

#include <algorithm>
#include <utility>

#include "torse/io/document.hpp"

namespace torse::fuzz {
namespace {

/// "trse": tells a database of ours from those of other programs.
constexpr std::int64_t application = 0x74727365;
/// The version of the tables below.
constexpr std::int64_t format = 1;

constexpr const char* tables = R"(
CREATE TABLE run (
  id INTEGER PRIMARY KEY, token TEXT NOT NULL UNIQUE, started TEXT NOT NULL, version TEXT NOT NULL,
  build TEXT NOT NULL, options TEXT NOT NULL, seconds REAL NOT NULL) STRICT;
CREATE TABLE series (
  id INTEGER PRIMARY KEY, property TEXT NOT NULL, effort TEXT NOT NULL, UNIQUE (property, effort)) STRICT;
CREATE TABLE unit (
  series INTEGER NOT NULL REFERENCES series, seed INTEGER NOT NULL, run INTEGER NOT NULL REFERENCES run,
  cases INTEGER NOT NULL, failed INTEGER NOT NULL, discarded INTEGER NOT NULL, microseconds INTEGER NOT NULL,
  PRIMARY KEY (series, seed)) STRICT, WITHOUT ROWID;
CREATE TABLE label (
  id INTEGER PRIMARY KEY, kind TEXT NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, UNIQUE (kind, key, value)) STRICT;
CREATE TABLE met (
  series INTEGER NOT NULL, seed INTEGER NOT NULL, label INTEGER NOT NULL REFERENCES label, cases INTEGER NOT NULL,
  PRIMARY KEY (series, seed, label)) STRICT, WITHOUT ROWID;
CREATE TABLE failure (
  series INTEGER NOT NULL, seed INTEGER NOT NULL, number INTEGER NOT NULL, message TEXT NOT NULL, file TEXT NOT NULL,
  PRIMARY KEY (series, seed, number)) STRICT, WITHOUT ROWID;
)";

constexpr const char* of_label = "label";
constexpr const char* of_discard = "discard";

std::int64_t number(std::uint64_t value) { return static_cast<std::int64_t>(value); }
std::uint64_t natural(std::int64_t value) { return static_cast<std::uint64_t>(value); }

bool is_empty(const Database& database) { return database.number("SELECT count(*) FROM sqlite_schema") == 0; }

void create_tables(const Database& database) {
  Transaction transaction(database);
  if (!is_empty(database)) return;  // another process was faster
  database.run(tables);
  database.run("PRAGMA application_id = " + std::to_string(application));
  database.run("PRAGMA user_version = " + std::to_string(format));
  transaction.commit();
}

Database opened(const std::string& file, Database::Open how) {
  Database database(file, how);
  if (how == Database::Open::create && is_empty(database)) create_tables(database);
  if (database.number("PRAGMA application_id") != application) {
    throw FileError(file, "expected a database of torse campaign, found another database");
  }
  if (const std::int64_t found = database.number("PRAGMA user_version"); found != format) {
    throw FileError(file, "expected a database of torse campaign in format " + std::to_string(format) +
                              ", found format " + std::to_string(found));
  }
  return database;
}

void add_count(Tally& tally, const std::string& kind, const std::string& key, const std::string& value,
               std::uint64_t cases) {
  (kind == of_label ? tally.labels : tally.discards).add(key, value, cases);
}

}  // namespace

Store::Store(const std::string& file, Database::Open how)
    : database_(opened(file, how)),
      find_series_(database_.prepare("SELECT id FROM series WHERE property = ? AND effort = ?")),
      find_outdated_(database_.prepare("SELECT 1 FROM unit WHERE series = ? AND seed = ? AND failed > 0 AND run NOT IN"
                                       " (SELECT id FROM run WHERE build = (SELECT build FROM run WHERE id = ?))")),
      add_unit_(database_.prepare("INSERT INTO unit (series, seed, run, cases, failed, discarded, microseconds)"
                                  " VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING")),
      add_count_(database_.prepare("INSERT INTO met (series, seed, label, cases)"
                                   " SELECT ?, ?, id, ? FROM label WHERE kind = ? AND key = ? AND value = ?")),
      add_label_(database_.prepare("INSERT INTO label (kind, key, value) VALUES (?, ?, ?)")) {}

std::int64_t Store::put_run(const RunInfo& run) {
  database_
      .prepare(
          "INSERT INTO run (token, started, version, build, options, seconds) VALUES (?, ?, ?, ?, ?, ?)"
          " ON CONFLICT (token) DO UPDATE SET seconds = max(seconds, excluded.seconds)")
      .bind(run.token, run.started, run.version, run.build, run.options, run.seconds)
      .run();
  Statement find = database_.prepare("SELECT id FROM run WHERE token = ?");
  return find.bind(run.token).step() ? find.integer(0) : 0;
}

Put Store::put(const UnitResult& result, std::int64_t run) {
  const std::int64_t series = add_series(result.series);
  if (add_unit(series, result, run)) return Put::added;
  const auto stored = Units(*this, result.series, {result.seed, result.seed}).next();
  if (stored->result.tally != result.tally) return Put::contradiction;
  if (began_later(run, stored->run)) {
    erase(series, result.seed);
    add_unit(series, result, run);
  }
  return Put::known;
}

Put Store::put_anew(const UnitResult& result, std::int64_t run) {
  const std::int64_t series = add_series(result.series);
  find_outdated_.bind(series, number(result.seed), run);
  if (find_outdated_.step()) {
    find_outdated_.reset();
    erase(series, result.seed);
  }
  return put(result, run);
}

std::map<std::int64_t, RunInfo> Store::runs() {
  std::map<std::int64_t, RunInfo> runs;
  Statement rows = database_.prepare("SELECT id, token, started, version, build, options, seconds FROM run");
  while (rows.step()) {
    runs[rows.integer(0)] = {rows.text(1), rows.text(2), rows.text(3), rows.text(4), rows.text(5), rows.real(6)};
  }
  return runs;
}

std::vector<Series> Store::series() {
  std::vector<Series> list;
  Statement rows = database_.prepare("SELECT property, effort FROM series");
  while (rows.step()) list.push_back({rows.text(0), rows.text(1)});
  std::sort(list.begin(), list.end());
  return list;
}

std::uint64_t Store::unit_count(const Series& series, const Seeds& seeds) {
  const auto id = find_series(series);
  if (!id) return 0;
  Statement rows = database_.prepare("SELECT count(*) FROM unit WHERE series = ? AND seed BETWEEN ? AND ?");
  return rows.bind(*id, number(seeds.first), number(seeds.last)).step() ? natural(rows.integer(0)) : 0;
}

SeedSet Store::settled(const Series& series, const Seeds& seeds, const std::string& build) {
  SeedSet set;
  const auto id = find_series(series);
  if (!id) return set;
  Statement rows = database_.prepare(
      "SELECT seed FROM unit WHERE series = ? AND seed BETWEEN ? AND ?"
      " AND (failed = 0 OR run IN (SELECT id FROM run WHERE build = ?)) ORDER BY seed");
  rows.bind(*id, number(seeds.first), number(seeds.last), build);
  while (rows.step()) set.add(natural(rows.integer(0)));
  return set;
}

UnitResult Store::total(const Series& series, const Seeds& seeds) {
  UnitResult total{series, 0, {}, 0};
  const auto id = find_series(series);
  if (!id) return total;
  Statement sums = database_.prepare(
      "SELECT total(cases), total(failed), total(discarded), total(microseconds) FROM unit"
      " WHERE series = ? AND seed BETWEEN ? AND ?");
  if (sums.bind(*id, number(seeds.first), number(seeds.last)).step()) {
    total.tally.cases = natural(sums.integer(0));
    total.tally.failed = natural(sums.integer(1));
    total.tally.discarded = natural(sums.integer(2));
    total.microseconds = sums.integer(3);
  }
  Statement counts = database_.prepare(
      "SELECT kind, key, value, n FROM (SELECT label, sum(cases) AS n FROM met WHERE series = ? AND seed BETWEEN ? AND "
      "?"
      " GROUP BY label) JOIN label ON label.id = label");
  counts.bind(*id, number(seeds.first), number(seeds.last));
  while (counts.step()) {
    add_count(total.tally, counts.text(0), counts.text(1), counts.text(2), natural(counts.integer(3)));
  }
  return total;
}

std::string Store::build_of(const Series& series, std::uint64_t seed) {
  Statement rows = database_.prepare("SELECT build FROM unit JOIN run ON run.id = run WHERE series = ? AND seed = ?");
  rows.bind(find_series(series).value_or(0), number(seed));
  return rows.step() ? rows.text(0) : "";
}

std::vector<Failure> Store::failures(const Series& series, const Seeds& seeds) {
  std::vector<Failure> list;
  const auto id = find_series(series);
  if (!id) return list;
  Statement rows = database_.prepare(
      "SELECT seed, number, message, file, build FROM failure JOIN unit USING (series, seed) JOIN run ON run.id = run"
      " WHERE series = ? AND seed BETWEEN ? AND ? ORDER BY seed, number");
  rows.bind(*id, number(seeds.first), number(seeds.last));
  while (rows.step()) {
    list.push_back({series,
                    {natural(rows.integer(0)), static_cast<int>(rows.integer(1)), rows.text(2), rows.text(3)},
                    rows.text(4)});
  }
  return list;
}

std::optional<std::int64_t> Store::find_series(const Series& series) {
  find_series_.bind(series.property, series.effort);
  if (!find_series_.step()) return std::nullopt;
  const std::int64_t id = find_series_.integer(0);
  find_series_.reset();
  return id;
}

std::int64_t Store::add_series(const Series& series) {
  if (const auto known = find_series(series)) return *known;
  database_.prepare("INSERT INTO series (property, effort) VALUES (?, ?)").bind(series.property, series.effort).run();
  return *find_series(series);
}

bool Store::began_later(std::int64_t run, std::int64_t other) {
  return database_
      .prepare(
          "SELECT 1 FROM run AS a, run AS b WHERE a.id = ? AND b.id = ?"
          " AND (a.started, a.token) > (b.started, b.token)")
      .bind(run, other)
      .step();
}

bool Store::add_unit(std::int64_t id, const UnitResult& result, std::int64_t run) {
  const Tally& tally = result.tally;
  add_unit_
      .bind(id, number(result.seed), run, number(tally.cases), number(tally.failed), number(tally.discarded),
            result.microseconds)
      .run();
  if (database_.changes() == 0) return false;
  put_distribution(id, result.seed, of_label, tally.labels);
  put_distribution(id, result.seed, of_discard, tally.discards);
  if (tally.failures.empty()) return true;
  Statement add = database_.prepare("INSERT INTO failure (series, seed, number, message, file) VALUES (?, ?, ?, ?, ?)");
  for (const SavedCase& saved : tally.failures) {
    add.bind(id, number(result.seed), std::int64_t{saved.index}, saved.message, saved.text).run();
  }
  return true;
}

void Store::put_distribution(std::int64_t id, std::uint64_t seed, const char* kind, const Distribution& distribution) {
  for (const auto& [key, values] : distribution.counts()) {
    for (const auto& [value, cases] : values) {
      add_count_.bind(id, number(seed), number(cases), kind, key, value).run();
      if (database_.changes() > 0) continue;
      add_label_.bind(kind, key, value).run();
      add_count_.bind(id, number(seed), number(cases), kind, key, value).run();
    }
  }
}

void Store::erase(std::int64_t id, std::uint64_t seed) {
  for (const char* table : {"unit", "met", "failure"}) {
    database_.prepare(std::string("DELETE FROM ") + table + " WHERE series = ? AND seed = ?")
        .bind(id, number(seed))
        .run();
  }
}

Units::Units(Store& store, const Series& series, const Seeds& seeds)
    : series_(series),
      number_(store.find_series(series).value_or(0)),
      units_(store.database_.prepare("SELECT seed, run, cases, failed, discarded, microseconds FROM unit"
                                     " WHERE series = ? AND seed BETWEEN ? AND ? ORDER BY seed")),
      counts_(store.database_.prepare("SELECT kind, key, value, cases FROM met JOIN label ON label.id = label"
                                      " WHERE series = ? AND seed = ?")),
      failures_(store.database_.prepare("SELECT number, message, file FROM failure"
                                        " WHERE series = ? AND seed = ? ORDER BY number")) {
  units_.bind(number_, number(seeds.first), number(seeds.last));
}

std::optional<StoredUnit> Units::next() {
  if (!units_.step()) return std::nullopt;
  StoredUnit unit{{series_, natural(units_.integer(0)), {}, units_.integer(5)}, units_.integer(1)};
  Tally& tally = unit.result.tally;
  tally.cases = natural(units_.integer(2));
  tally.failed = natural(units_.integer(3));
  tally.discarded = natural(units_.integer(4));
  counts_.bind(number_, units_.integer(0));
  while (counts_.step())
    add_count(tally, counts_.text(0), counts_.text(1), counts_.text(2), natural(counts_.integer(3)));
  failures_.bind(number_, units_.integer(0));
  while (failures_.step()) {
    tally.failures.push_back(
        {unit.result.seed, static_cast<int>(failures_.integer(0)), failures_.text(1), failures_.text(2)});
  }
  return unit;
}

}  // namespace torse::fuzz
