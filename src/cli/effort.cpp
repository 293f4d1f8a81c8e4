// Bits of the control points, by prefix sums over the rows.
#include "torse/cli/effort.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "torse/io/document.hpp"

namespace torse::cli {
namespace {

constexpr double most_effort = 0x1p40;

std::size_t bits_of(const Rational& x) { return x.numerator_bits() + x.denominator_bits(); }

/// Entry i: the bits of the points before i of both rows.
std::vector<std::size_t> bits_before(const RuledFile<Rational>& surface) {
  std::vector<std::size_t> sums{0};
  for (std::size_t i = 0; i < surface.c.points.size(); ++i) {
    std::size_t bits = 0;
    for (const WeightedPoints<Rational, 3>* net : {&surface.c, &surface.d}) {
      for (int j = 0; j < 3; ++j) bits += bits_of(net->points[i][j]);
      bits += bits_of(net->weights[i]);
    }
    sums.push_back(sums.back() + bits);
  }
  return sums;
}

}  // namespace

double effort_of(const RuledFile<Rational>& surface, double degree_power, double bits_power) {
  const int n = surface.knots.degree();
  const std::vector<std::size_t> sums = bits_before(surface);
  double effort = 0;
  for (const int k : surface.knots.proper_pieces()) {
    const std::size_t bits = sums[static_cast<std::size_t>(k + n)] - sums[static_cast<std::size_t>(k - 1)];
    effort += std::pow(static_cast<double>(bits), bits_power);
  }
  return effort * std::pow(n, degree_power);
}

void require_effort(const std::string& file, const RuledFile<Rational>& surface) {
  const double effort = effort_of(surface, 2, 1.5);
  if (effort <= most_effort) return;
  throw FileError(file, fmt::format("expected a surface of effort 2^40 at most, found 2^{:.1f}: {} control points of "
                                    "degree {} with numbers of this length take too long",
                                    std::log2(effort), 2 * surface.c.points.size(), surface.knots.degree()));
}

}  // namespace torse::cli
