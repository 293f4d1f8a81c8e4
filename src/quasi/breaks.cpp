#include "torse/quasi/breaks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace torse::quasi {
namespace {

double on_grid(double t) { return std::round(t * 0x1p24) * 0x1p-24; }

}  // namespace

std::vector<double> even_breaks(int pieces) {
  std::vector<double> breaks;
  for (int i = 0; i <= pieces; ++i) breaks.push_back(on_grid(static_cast<double>(i) / pieces));
  return breaks;
}

std::vector<double> means_by_piece(const std::vector<double>& breaks, const std::vector<double>& parameters,
                                   const std::vector<double>& values) {
  std::vector<double> means(breaks.size() - 1, 0);
  std::vector<std::size_t> counts(means.size(), 0);
  for (std::size_t r = 0; r < parameters.size(); ++r) {
    const auto above = std::upper_bound(breaks.begin(), breaks.end() - 1, parameters[r]);
    const std::size_t piece = static_cast<std::size_t>(above - breaks.begin()) - 1;
    means[piece] += values[r];
    ++counts[piece];
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (counts[i] != 0) means[i] /= static_cast<double>(counts[i]);
  }
  return means;
}

std::vector<double> moved_breaks(const std::vector<double>& breaks, const std::vector<double>& warp, int degree) {
  const std::size_t pieces = warp.size();
  const double largest = std::max(std::ranges::max(warp), std::numeric_limits<double>::min());
  std::vector<double> mass{0};
  for (std::size_t i = 0; i < pieces; ++i) {
    const double density = std::pow(warp[i] / largest, 1.0 / (degree + 1)) + 0.1;
    mass.push_back(mass.back() + density * (breaks[i + 1] - breaks[i]));
  }
  std::vector<double> moved{0};
  std::size_t at = 0;
  for (std::size_t i = 1; i < pieces; ++i) {
    const double wanted = mass.back() * static_cast<double>(i) / static_cast<double>(pieces);
    while (mass[at + 1] < wanted) ++at;
    const double share = (wanted - mass[at]) / (mass[at + 1] - mass[at]);
    moved.push_back(on_grid(breaks[at] + share * (breaks[at + 1] - breaks[at])));
  }
  moved.push_back(1);
  return moved;
}

}  // namespace torse::quasi
