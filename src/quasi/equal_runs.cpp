#include "torse/quasi/equal_runs.hpp"

#include <algorithm>

namespace torse::quasi {
namespace {

constexpr double least_rise = 1e-6;

}  // namespace

void part_equal(std::vector<double>& beta, const RunLimits& limits) {
  const std::size_t n = beta.size();
  if (beta.front() == beta.back()) return;
  for (std::size_t begin = 0; begin != n;) {
    const double value = beta[begin];
    std::size_t end = begin;
    while (end != n && beta[end] == value) ++end;
    const std::size_t run = end - begin;
    if (run >= (begin == 0 || end == n ? limits.at_end : limits.inside)) {
      const double gap = end == n ? value - beta[begin - 1] : beta[end] - value;
      const double step = std::min(least_rise, gap / 2) / static_cast<double>(run);
      const std::size_t fixed = end == n ? end - 1 : begin;
      for (std::size_t i = begin; i != end; ++i) {
        beta[i] += step * (static_cast<double>(i) - static_cast<double>(fixed));
      }
    }
    begin = end;
  }
}

}  // namespace torse::quasi
