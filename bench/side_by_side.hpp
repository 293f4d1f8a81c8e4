// Contenders timed side by side on a machine that may be shared.
//   Contender         a name and what to run
//   compare           one row per contender: median time and the median of its ratios to the first one
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace torse::bench {

/// What is timed. `run` does the whole task once and returns whether its result is right.
struct Contender {
  std::string name;
  std::function<bool()> run;
};

/// What was measured of a contender.
struct Timing {
  double seconds;  ///< median of the rounds, for one run
  double ratio;    ///< median over the rounds of its time by that of the first contender in the same round
};

/// Seconds of processor time of this thread: what others do on the machine does not count.
inline double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  const std::size_t half = x.size() / 2;
  return x.size() % 2 == 1 ? x[half] : (x[half - 1] + x[half]) / 2;
}

/// Seconds of one run, averaged over `times` runs. Ends the program if a result is wrong.
inline double seconds_of(const Contender& contender, int times) {
  const double start = processor_seconds();
  for (int i = 0; i < times; ++i) {
    if (!contender.run()) {
      std::fprintf(stderr, "%s: wrong result\n", contender.name.c_str());
      std::exit(1);
    }
  }
  return (processor_seconds() - start) / times;
}

/// Runs the contenders in turn, `rounds` times; a turn repeats its contender until it takes some 20 ms.
inline std::vector<Timing> time_in_turn(const std::vector<Contender>& contenders, int rounds = 9) {
  constexpr double turn = 0.02;
  std::vector<int> times;
  for (const Contender& contender : contenders) {
    const double once = std::max(seconds_of(contender, 1), 1e-9);  // also warms up
    const double again = once < turn / 4 ? std::max(seconds_of(contender, 3), 1e-9) : once;
    times.push_back(std::clamp(static_cast<int>(turn / again), 1, 1'000'000));
  }
  std::vector<std::vector<double>> seconds(contenders.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) seconds[i].push_back(seconds_of(contenders[i], times[i]));
  }
  std::vector<Timing> timings;
  for (const std::vector<double>& mine : seconds) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < mine.size(); ++round) ratios.push_back(mine[round] / seconds[0][round]);
    timings.push_back({median(mine), median(ratios)});
  }
  return timings;
}

/// A time in three digits and a unit that suits it.
inline std::string readable(double seconds) {
  char text[32];
  const char* unit = seconds < 1e-3 ? "us" : seconds < 1 ? "ms" : "s";
  std::snprintf(text, sizeof text, "%.3g %s", seconds * (seconds < 1e-3 ? 1e6 : seconds < 1 ? 1e3 : 1), unit);
  return text;
}

/// The head of a Markdown table whose first column names the case.
inline void print_head(const std::string& first, const std::vector<Contender>& contenders) {
  std::string rule = "|---|";
  std::printf("| %s |", first.c_str());
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::printf(" %s |", contenders[i].name.c_str());
    rule += "--:|";
  }
  std::printf("\n%s\n", rule.c_str());
}

/// Times the contenders and prints a row: each time, and in brackets its ratio to the first one. Returns the timings.
inline std::vector<Timing> compare(const std::string& name, const std::vector<Contender>& contenders, int rounds = 9) {
  const std::vector<Timing> timings = time_in_turn(contenders, rounds);
  std::printf("| %s |", name.c_str());
  for (std::size_t i = 0; i < timings.size(); ++i) {
    std::printf(" %s", readable(timings[i].seconds).c_str());
    if (i > 0) std::printf(" (%.2f)", timings[i].ratio);
    std::printf(" |");
  }
  std::printf("\n");
  std::fflush(stdout);
  return timings;
}

/// A goal and whether it was met, as a line of its own. Returns the latter.
inline bool goal(const std::string& text, bool met) {
  std::printf("\n%s: **%s**\n", text.c_str(), met ? "met" : "not met");
  std::fflush(stdout);
  return met;
}

}  // namespace torse::bench
