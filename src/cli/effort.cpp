// Bits of the control points, by prefix sums over the rows, and of the equations of a directrix.
#include "torse/cli/effort.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "torse/io/document.hpp"

namespace torse::cli {
namespace {

constexpr double most_directrix_effort = 0x1p38;
constexpr double most_branch_effort = 0x1p31;

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

std::size_t most_numerator_bits(const std::vector<Rational>& list) {
  std::size_t most = 0;
  for (const Rational& x : list) most = std::max(most, x.numerator_bits());
  return most;
}

std::vector<Rational> coordinates_of(const std::vector<Vec<Rational, 3>>& points) {
  std::vector<Rational> coordinates;
  for (const Vec<Rational, 3>& x : points) {
    for (int j = 0; j < 3; ++j) coordinates.push_back(x[j]);
  }
  return coordinates;
}

std::size_t common_denominator_bits(const std::vector<Rational>& list) {
  return ScalarTraits<Rational>::common_denominator(list).numerator_bits();
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

void require_effort(const std::string& file, const RuledFile<Rational>& surface, const std::string& what, int most) {
  const double effort = effort_of(surface, 2, 1.5);
  if (effort <= std::ldexp(1.0, most)) return;
  throw FileError(file,
                  fmt::format("expected {} of effort 2^{} at most, found 2^{:.1f}: {} control points of "
                              "degree {} with numbers of this length take too long",
                              what, most, std::log2(effort), 2 * surface.c.points.size(), surface.knots.degree()));
}

double directrix_effort(const ConstructFile<Rational>& input) {
  std::vector<Rational> factors = input.a;
  factors.insert(factors.end(), input.b.begin(), input.b.end());
  const std::vector<Rational> coordinates = coordinates_of(input.c.points);
  const double unknowns = static_cast<double>(input.c.points.size());
  const std::size_t spread = std::max(input.a.size() - 1, input.b.size() - std::min<std::size_t>(input.b.size(), 2));
  const double width = std::min(unknowns, static_cast<double>(spread) + 10);
  const double entry = static_cast<double>(std::max(most_numerator_bits(factors), most_numerator_bits(coordinates)) +
                                           common_denominator_bits(factors));
  const double bits = unknowns * entry + static_cast<double>(common_denominator_bits(coordinates));
  return unknowns * unknowns * width * std::pow(bits, 1.5);
}

void require_directrix(const ConstructFile<Rational>& input) {
  const double effort = directrix_effort(input);
  if (effort <= most_directrix_effort) return;
  throw InvalidInput("c.points",
                     fmt::format("expected a linear system of effort 2^38 at most, found 2^{:.1f}: {} points "
                                 "with numbers of this length take too long",
                                 std::log2(effort), input.c.points.size()));
}

double branch_effort(const ConstructFile<Rational>& input) {
  std::vector<Vec<Rational, 3>> points = input.c.points;
  points.insert(points.end(), {*input.va, *input.vb});
  const std::vector<Rational> coordinates = coordinates_of(points);
  const std::vector<Rational>& knots = input.knots.list();
  const double last = input.knots.last();
  const double factor =
      static_cast<double>(3 * (most_numerator_bits(knots) + common_denominator_bits(knots)) + bits_of(*input.lambda));
  const double start = static_cast<double>(most_numerator_bits(coordinates) + common_denominator_bits(coordinates));
  return last * last * (start + last * factor);
}

void require_branches(const ConstructFile<Rational>& input) {
  const double effort = branch_effort(input);
  if (effort <= most_branch_effort) return;
  throw InvalidInput("c.points",
                     fmt::format("expected a polynomial in M of effort 2^31 at most, found 2^{:.1f}: {} control "
                                 "points with numbers of this length take too long",
                                 std::log2(effort), input.c.points.size()));
}

}  // namespace torse::cli
