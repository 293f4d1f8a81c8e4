#include "torse/proofs/runner.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "torse/exact/symbolic/thread_cache.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

namespace {

struct Task {
  std::size_t claim;
  const Engine* engine;
  Finding finding;
};

bool chosen(const std::vector<std::string>& list, std::string_view name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

std::vector<Task> plan_tasks(const Selection& selection) {
  std::vector<Task> tasks;
  int position = 0;
  for (std::size_t claim = 0; claim < all_claims().size(); ++claim) {
    const ClaimInfo& info = *all_claims()[claim];
    if (!chosen(selection.claims, info.id) || !chosen(selection.papers, info.paper())) continue;
    for (const Engine& engine : engines()) {
      if (!chosen(selection.engines, engine.name)) continue;
      if (position++ % selection.shards == selection.shard) tasks.push_back({claim, &engine, {}});
    }
  }
  return tasks;
}

int rank(Status status) {
  switch (status) {
    case Status::refuted:
      return 6;
    case Status::proved:
      return 5;
    case Status::supported:
      return 4;
    case Status::bounded:
      return 3;
    case Status::undecided:
      return 2;
    case Status::gave_up:
      return 1;
    case Status::not_applicable:
      return 0;
  }
  return 0;
}

}  // namespace

const Finding* Entry::decisive() const {
  const Finding* best = nullptr;
  for (const Finding& finding : findings) {
    if (finding.engine == "mutation" && findings.size() > 1) continue;
    if (best == nullptr || rank(finding.status) > rank(best->status)) best = &finding;
  }
  return best;
}

Status Entry::status() const {
  const Finding* best = decisive();
  return best == nullptr ? Status::not_applicable : best->status;
}

Score Entry::mutants() const {
  Score total;
  for (const Finding& finding : findings) total += finding.mutants;
  return total;
}

Score Entry::faults() const {
  Score total;
  for (const Finding& finding : findings) total += finding.faults;
  return total;
}

std::vector<Entry> run_all(const Selection& selection, const Plan& plan, unsigned threads, const Progress& progress) {
  std::vector<Task> tasks = plan_tasks(selection);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex;
  std::exception_ptr defect;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      try {
        const auto start = std::chrono::steady_clock::now();
        tasks[i].finding = tasks[i].engine->run(tasks[i].claim, plan);
        tasks[i].finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!defect) defect = std::current_exception();
        next = tasks.size();
        return;
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done, tasks.size(), tasks[i].finding);
    }
  };
  std::vector<std::thread> pool;
  for (unsigned t = 1; t < std::max(1U, threads); ++t)
    pool.emplace_back([&work] {
      work();
      release_flint_cache();
    });
  work();
  for (std::thread& thread : pool) thread.join();
  if (defect) std::rethrow_exception(defect);

  std::vector<Entry> entries;
  for (Task& task : tasks) {
    const ClaimInfo* info = all_claims()[task.claim];
    if (entries.empty() || entries.back().info != info) entries.push_back({info, {}});
    entries.back().findings.push_back(std::move(task.finding));
  }
  return entries;
}

}  // namespace torse::proofs
