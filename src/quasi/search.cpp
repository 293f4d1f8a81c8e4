#include "torse/quasi/search.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace torse::quasi {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

/// A rail at evenly spaced parameters.
std::vector<RailJet> jets_of(const Rail& rail, int intervals) {
  std::vector<RailJet> jets;
  for (int i = 0; i <= intervals; ++i) jets.push_back(rail(static_cast<double>(i) / intervals));
  return jets;
}

/// The power of two of the largest finite coordinate: in this unit the fourth powers that an angle takes are floats.
double unit_of(const std::vector<RailJet>& c, const std::vector<RailJet>& d) {
  double largest = std::numeric_limits<double>::min();
  for (const auto* jets : {&c, &d}) {
    for (const RailJet& jet : *jets) {
      if (jet.point.allFinite()) largest = std::max(largest, jet.point.cwiseAbs().maxCoeff());
    }
  }
  return std::exp2(std::ilogb(largest));
}

/// Points and tangents of a rail, coordinate by coordinate, so that loops over them vectorize.
struct Stations {
  std::array<std::vector<float>, 3> point;
  std::array<std::vector<float>, 3> tangent;

  Stations(const std::vector<RailJet>& jets, double unit) {
    for (const RailJet& jet : jets) {
      const Vector direction = jet.first.normalized();  // zero where the rail is at rest
      for (int k = 0; k < 3; ++k) {
        point[static_cast<std::size_t>(k)].push_back(static_cast<float>(jet.point[k] / unit));
        tangent[static_cast<std::size_t>(k)].push_back(static_cast<float>(direction[k]));
      }
    }
  }
};

constexpr float pi = std::numbers::pi_v<float>;

/// An angle in [0, pi/2] from its sine without calls, within 0.2 percent: (pi/2 - asin x) / sqrt(1 - x) is nearly a
/// parabola, whose coefficients make the relative error of the angle small.
float rough_angle(float sine_squared) {
  const float x = std::sqrt(sine_squared);
  return pi / 2 - std::sqrt(1 - x) * (pi / 2 - x * (0.2136F - 0.066F * x));
}

using Costs = Eigen::ArrayXf;

/// What steps from column i - 1 to column i cost: from row j - k to row j a quarter of the two costs there and a
/// quarter of the mean of both columns over the rows j - k..j, twice.
class PathCosts {
 public:
  explicit PathCosts(const RulingGrid& grid) : height_(grid.rows() + 1) {
    for (int i = 0; i <= grid.columns(); ++i) {
      column_.push_back(Eigen::Map<const Costs>(grid.column(i), height_));
      Costs sums = Costs::Zero(height_ + 1);
      for (Eigen::Index j = 0; j < height_; ++j) sums[j + 1] = sums[j] + column_.back()[j];
      sums_.push_back(std::move(sums));
    }
  }

  /// The least costs of paths to the rows of column i, from those of column i - 1.
  Costs extend(int i, const Costs& least) const {
    const Costs begin = least + quarter * column(i - 1);
    const Costs sums = this->sums(i);
    Costs next = Costs::Constant(height_, never);
    for (Eigen::Index k = 0; k < height_; ++k) {
      const Eigen::Index size = height_ - k;
      next.tail(size) = next.tail(size).min(begin.head(size) + share(k) * (sums.tail(size) - sums.head(size)));
    }
    return next + quarter * column(i);
  }

  /// The step k that leads to row j of column i at the least cost.
  Eigen::Index best_step(int i, const Costs& least, Eigen::Index j) const {
    const Costs sums = this->sums(i);
    Eigen::Index best = 0;
    float lowest = never;
    for (Eigen::Index k = 0; k <= j; ++k) {
      const float total = least[j - k] + quarter * column(i - 1)[j - k] + share(k) * (sums[j + 1] - sums[j - k]);
      if (total < lowest) {
        lowest = total;
        best = k;
      }
    }
    return best;
  }

 private:
  static constexpr float quarter = 0.25F;

  static float share(Eigen::Index k) { return quarter / static_cast<float>(k + 1); }
  const Costs& column(int i) const { return column_[static_cast<std::size_t>(i)]; }
  Costs sums(int i) const { return sums_[static_cast<std::size_t>(i) - 1] + sums_[static_cast<std::size_t>(i)]; }

  Eigen::Index height_;
  std::vector<Costs> column_;
  std::vector<Costs> sums_;  // over the rows below
};

}  // namespace

RulingGrid::RulingGrid(const Rails& rails, int columns, int rows, AngleKind kind)
    : columns_(columns), rows_(rows), cost_((static_cast<std::size_t>(columns) + 1) * height()) {
  const std::vector<RailJet> on_c = jets_of(rails.c, columns);
  const std::vector<RailJet> on_d = jets_of(rails.d, rows);
  const double unit = unit_of(on_c, on_d);
  const Stations c(on_c, unit);
  const Stations d(on_d, unit);
  const auto& [px, py, pz] = d.point;
  const auto& [bx, by, bz] = d.tangent;
  const bool sides = kind == AngleKind::sides;
  const float largest = sides ? pi : pi / 2;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(columns); ++i) {
    const float cx = c.point[0][i], cy = c.point[1][i], cz = c.point[2][i];
    const float ax = c.tangent[0][i], ay = c.tangent[1][i], az = c.tangent[2][i];
    float* out = cost_.data() + i * height();
    for (std::size_t j = 0; j < height(); ++j) {
      const float wx = px[j] - cx, wy = py[j] - cy, wz = pz[j] - cz;
      const float mx = ay * wz - az * wy, my = az * wx - ax * wz, mz = ax * wy - ay * wx;
      const float nx = by[j] * wz - bz[j] * wy, ny = bz[j] * wx - bx[j] * wz, nz = bx[j] * wy - by[j] * wx;
      const float volume = mx * bx[j] + my * by[j] + mz * bz[j];
      const float cosine = mx * nx + my * ny + mz * nz;
      const float square = (wx * wx + wy * wy + wz * wz) * volume * volume;
      const float norm = square + cosine * cosine;
      const float angle = norm == 0 ? 0 : rough_angle(square / norm);
      const float cost = sides && cosine < 0 ? pi - angle : angle;
      out[j] = cost >= 0 ? cost : largest;  // not a number where a rail is infinite
    }
  }
}

std::vector<double> best_path(const RulingGrid& grid, Ends ends) {
  const PathCosts costs(grid);
  const Eigen::Index top = grid.rows();
  std::vector<Costs> least{Costs::Constant(top + 1, ends == Ends::free ? 0 : never)};
  least.front()[0] = 0;
  for (int i = 1; i <= grid.columns(); ++i) least.push_back(costs.extend(i, least.back()));

  Eigen::Index j = top;
  if (ends == Ends::free) least.back().minCoeff(&j);
  std::vector<double> path(least.size());
  for (int i = grid.columns(); i >= 0; --i) {
    path[static_cast<std::size_t>(i)] = static_cast<double>(j) / static_cast<double>(top);
    if (i > 0) j -= costs.best_step(i, least[static_cast<std::size_t>(i) - 1], j);
  }
  return path;
}

std::vector<double> follow_path(const std::vector<double>& path, const std::vector<double>& greville) {
  std::vector<double> beta;
  beta.reserve(greville.size());
  const double columns = static_cast<double>(path.size() - 1);
  for (const double t : greville) {
    const double place = std::clamp(t * columns, 0.0, columns);
    const std::size_t i = std::min(static_cast<std::size_t>(place), path.size() - 2);
    beta.push_back(path[i] + (place - static_cast<double>(i)) * (path[i + 1] - path[i]));
  }
  return beta;
}

}  // namespace torse::quasi
