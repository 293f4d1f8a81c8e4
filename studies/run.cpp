#include "torse/studies/run.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "torse/fuzz/campaign/sqlite.hpp"
#include "torse/io/document.hpp"
#include "torse/proofs/random.hpp"
#include "torse/proofs/report.hpp"
#include "torse/studies/inputs.hpp"
#include "torse/studies/measure.hpp"
#include "torse/studies/verdicts.hpp"

namespace torse::studies {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); }

Json json_of(const Measurement& m) {
  Json json{{"route", m.route}, {"scalar", m.scalar}, {"finite", m.finite}};
  if (!m.finite) return json;
  json.update({{"ulps", m.ulps},
               {"units", m.units},
               {"conditioned", m.conditioned},
               {"condition", m.condition},
               {"backward", json_of(m.backward)},
               {"warp_deg", json_of(m.warp)},
               {"bound", json_of(m.bound)}});
  return json;
}

Json anchors_of(const Case& in) {
  Json anchors = Json::array();
  for (const FloatPoint& x : in.anchors) anchors.push_back({hex_text(x[0]), hex_text(x[1]), hex_text(x[2])});
  return anchors;
}

Json others_of(const Case& in) {
  const auto list = [](const std::vector<float>& xs) {
    Json numbers = Json::array();
    for (const float x : xs) numbers.push_back(hex_text(x));
    return numbers;
  };
  Json e = Json::array();
  for (const FloatPoint& x : in.e) e.push_back({hex_text(x[0]), hex_text(x[1]), hex_text(x[2])});
  return {{"e", std::move(e)},           {"weights", list(in.weights)}, {"e_weights", list(in.e_weights)},
          {"sigma", hex_text(in.sigma)}, {"share", hex_text(in.share)}, {"anchors", anchors_of(in)}};
}

void add_routes(Json& record, const Task& task, const Levels& levels, std::uint64_t seed) {
  const Case in = draw_case(levels, seed);
  record["input"] = Json::parse(input_file(in));
  record["more"] = others_of(in);
  Json results = Json::array();
  for (const Measurement& m : measure_case(in, task.design.subjects, task.design.scalars))
    results.push_back(json_of(m));
  record["results"] = std::move(results);
}

void add_verdicts(Json& record, const Task& task, const Levels& levels, std::uint64_t seed) {
  const Verdicts verdicts = judge_case(levels, seed, task.design.subjects);
  record["input"] = Json::parse(verdicts.net);
  record["developable"] = verdicts.developable;
  Json results = Json::array();
  for (std::size_t i = 0; i < verdicts.said.size(); ++i) {
    results.push_back({{"test", task.design.subjects[i]},
                       {"says_developable", bool(verdicts.said[i])},
                       {"wrong", verdicts.said[i] != verdicts.developable}});
  }
  record["results"] = std::move(results);
}

}  // namespace

std::string Task::key() const {
  return std::string("1 ") + std::string(proofs::effort_name(effort)) + " " + std::to_string(seed) + " " +
         std::to_string(shard) + "/" + std::to_string(shards) + " " + design.text;
}

std::string case_record(const Task& task, std::size_t number) {
  const std::size_t repetitions =
      static_cast<std::size_t>(task.design.repetitions[static_cast<std::size_t>(task.effort)]);
  const std::size_t combination = number / repetitions;
  const Levels levels = task.design.levels(combination);
  const std::uint64_t seed =
      proofs::seed_of(task.seed, task.design.name + "/" + std::to_string(combination), number % repetitions);
  Json record{{"torse", 1}, {"study", task.design.name}, {"case", number}, {"repetition", number % repetitions}};
  Json chosen = Json::object();
  for (std::size_t i = 0; i < factor_names.size(); ++i) {
    chosen[std::string(factor_names[i])] = levels[static_cast<Factor>(i)];
  }
  record["factors"] = std::move(chosen);
  if (task.design.verdicts) {
    add_verdicts(record, task, levels, seed);
  } else {
    add_routes(record, task, levels, seed);
  }
  return record.dump();
}

struct Journal::State {
  State(const std::string& file, const std::string& key) : database(file, fuzz::Database::Open::create) {
    database.run(
        "PRAGMA synchronous=NORMAL; CREATE TABLE IF NOT EXISTS run (key TEXT NOT NULL);"
        "CREATE TABLE IF NOT EXISTS record (number INTEGER PRIMARY KEY, text TEXT NOT NULL)");
    if (database.number("SELECT count(*) FROM run") == 0) {
      fuzz::Statement insert = database.prepare("INSERT INTO run VALUES (?)");
      insert.bind(std::string_view(key)).run();
    }
    fuzz::Statement select = database.prepare("SELECT key FROM run");
    if (!select.step() || select.text(0) != key) {
      throw FileError(file, "expected the records of this design, effort, seed, shard and program, found others");
    }
  }

  fuzz::Database database;
};

Journal::Journal(const std::string& file, const Task& task, const std::string& build, bool resume) {
  std::error_code ignored;
  if (!resume) std::filesystem::remove(file, ignored);
  state_ = std::make_unique<State>(file, build + " " + task.key());
}

Journal::~Journal() = default;

std::string Journal::record(std::size_t number) {
  fuzz::Statement select = state_->database.prepare("SELECT text FROM record WHERE number = ?");
  select.bind(static_cast<std::int64_t>(number));
  return select.step() ? select.text(0) : "";
}

void Journal::store(const std::vector<std::pair<std::size_t, std::string>>& records) {
  fuzz::Transaction transaction(state_->database);
  fuzz::Statement insert = state_->database.prepare("INSERT INTO record VALUES (?, ?)");
  for (const auto& [number, text] : records) {
    insert.bind(static_cast<std::int64_t>(number), std::string_view(text)).run();
  }
  transaction.commit();
}

void Journal::remove() {
  const std::string file = state_->database.file();
  state_.reset();
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

std::vector<std::string> run_study(const Task& task, unsigned threads, Journal* journal,
                                   const std::function<void(std::size_t, std::size_t)>& progress) {
  const Block block = task.block();
  const std::size_t count = block.end - block.begin;
  std::vector<std::string> records(count);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < count; ++i) {
    if (journal != nullptr) records[i] = journal->record(block.begin + i);
    if (records[i].empty()) missing.push_back(i);
  }
  std::atomic<std::size_t> next{0};
  std::size_t done = count - missing.size();
  std::mutex mutex;
  std::exception_ptr defect;
  const auto work = [&] {
    for (std::size_t at = next++; at < missing.size(); at = next++) {
      try {
        std::string record = case_record(task, block.begin + missing[at]);
        const std::lock_guard lock(mutex);
        if (journal != nullptr) journal->store({{block.begin + missing[at], record}});
        records[missing[at]] = std::move(record);
        if (progress) progress(++done, count);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!defect) defect = std::current_exception();
        next = missing.size();
      }
    }
  };
  std::vector<std::thread> pool;
  for (unsigned t = 1; t < std::max(1U, threads); ++t) pool.emplace_back(work);
  work();
  for (std::thread& thread : pool) thread.join();
  if (defect) std::rethrow_exception(defect);
  return records;
}

}  // namespace torse::studies
