// The global start: the best path against all paths of small grids, the costs of a grid against angles, and mappings
// along a path.
#include "torse/quasi/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "../spline/splines.hpp"
#include "rails.hpp"

namespace torse::quasi {
namespace {

/// Two random rails, one above the other by 1.
Rails drawn_rails(std::uint64_t seed) {
  test::ExactCurve d = test::drawn_curve(test::knots(3, {0, 0, 0, 1, 2, 2, 2}), true, 2 * seed + 1);
  for (Vec<Rational, 4>& row : d.control) row[3] += row[0];
  return {test::in_doubles(test::drawn_curve(bezier_knots<Rational>(3), false, 2 * seed)), test::in_doubles(d)};
}

/// The mean cost along a polyline through points of the grid, in doubles: along a step half of it is at the two ends,
/// half of it spread over the rows between them, in either column.
double path_cost(const RulingGrid& grid, const std::vector<int>& rows) {
  double total = 0;
  for (int i = 1; i <= grid.columns(); ++i) {
    const float* left = grid.column(i - 1);
    const float* right = grid.column(i);
    const int from = rows[static_cast<std::size_t>(i) - 1], to = rows[static_cast<std::size_t>(i)];
    double between = 0;
    for (int j = from; j <= to; ++j) between += (static_cast<double>(left[j]) + static_cast<double>(right[j])) / 2;
    total += (static_cast<double>(left[from]) + static_cast<double>(right[to])) / 4 + between / (2 * (to - from + 1));
  }
  return total / grid.columns();
}

void each_path(const RulingGrid& grid, Ends ends, std::vector<int>& rows,
               const std::function<void(const std::vector<int>&)>& visit) {
  if (static_cast<int>(rows.size()) == grid.columns() + 1) {
    if (ends == Ends::free || (rows.front() == 0 && rows.back() == grid.rows())) visit(rows);
    return;
  }
  for (int j = rows.empty() ? 0 : rows.back(); j <= grid.rows(); ++j) {
    rows.push_back(j);
    each_path(grid, ends, rows, visit);
    rows.pop_back();
  }
}

double least_cost(const RulingGrid& grid, Ends ends) {
  double least = 1e9;
  std::vector<int> rows;
  each_path(grid, ends, rows, [&](const std::vector<int>& path) { least = std::min(least, path_cost(grid, path)); });
  return least;
}

TEST(BestPath, NoPathOfTheGridCostsLess) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const auto& [columns, rows] :
         {std::pair{1, 1}, std::pair{1, 6}, std::pair{5, 1}, std::pair{4, 5}, std::pair{5, 6}}) {
      for (const AngleKind kind : {AngleKind::planes, AngleKind::sides}) {
        const RulingGrid grid(drawn_rails(seed), columns, rows, kind);
        for (const Ends ends : {Ends::fixed, Ends::free}) {
          const std::vector<double> path = best_path(grid, ends);
          ASSERT_EQ(path.size(), static_cast<std::size_t>(columns) + 1);
          std::vector<int> found;
          for (const double t : path) found.push_back(static_cast<int>(std::lround(t * rows)));
          for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(path[i], static_cast<double>(found[i]) / rows);
          EXPECT_TRUE(std::ranges::is_sorted(found));
          if (ends == Ends::fixed) {
            EXPECT_EQ(found.front(), 0);
            EXPECT_EQ(found.back(), rows);
          }
          // The search adds up floats: some 2 columns rounding errors of 2^-24 of numbers below pi columns.
          const double rounding = 2 * columns * 0x1p-24 * std::numbers::pi;
          EXPECT_NEAR(path_cost(grid, found), least_cost(grid, ends), rounding);
        }
      }
    }
  }
}

TEST(RulingGrid, CostsAreTheAnglesWithinHalfAPercent) {
  double largest = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Rails rails = drawn_rails(seed);
    const int columns = 9, rows = 13;
    const RulingGrid planes(rails, columns, rows, AngleKind::planes), sides(rails, columns, rows, AngleKind::sides);
    EXPECT_EQ(planes.columns(), columns);
    EXPECT_EQ(planes.rows(), rows);
    for (int i = 0; i <= columns; ++i) {
      for (int j = 0; j <= rows; ++j) {
        const RailJet c = rails.c(static_cast<double>(i) / columns), d = rails.d(static_cast<double>(j) / rows);
        const RulingAngle flat = ruling_angle(c, d, AngleKind::planes);
        const double angle = std::abs(flat.angle.value);
        const double error =
            0.005 * angle + 1e-3;  // the latter for right angles in single precision: sqrt(2^-24) and more
        EXPECT_NEAR(static_cast<double>(planes.column(i)[j]), angle, error);
        EXPECT_NEAR(static_cast<double>(sides.column(i)[j]), std::abs(ruling_angle(c, d, AngleKind::sides).angle.value),
                    error);
        largest = std::max(largest, angle);
      }
    }
  }
  EXPECT_GT(largest, 1.5);
}

/// Rails 2^-50 and 2^50 times as large, whose fourth powers no float holds.
TEST(RulingGrid, CostsDoNotDependOnTheSize) {
  const test::ExactCurve c = test::drawn_curve(bezier_knots<Rational>(3), false, 3);
  test::ExactCurve d = test::drawn_curve(bezier_knots<Rational>(4), true, 4);
  for (Vec<Rational, 4>& row : d.control) row[3] += row[0];
  const auto grid = [&](double size) {
    const auto scaled = [&](test::ExactCurve curve) {
      for (Vec<Rational, 4>& row : curve.control) {
        for (int k = 1; k < 4; ++k) row[k] *= Rational::from_double(size);
      }
      return test::in_doubles(curve);
    };
    return RulingGrid({scaled(c), scaled(d)}, 6, 6, AngleKind::planes);
  };
  const RulingGrid unit = grid(1);
  for (const double size : {0x1p-50, 0x1p50}) {
    const RulingGrid other = grid(size);
    for (int i = 0; i <= 6; ++i) {
      for (int j = 0; j <= 6; ++j) EXPECT_EQ(other.column(i)[j], unit.column(i)[j]) << size;
    }
  }
}

/// d passes infinity in its middle, where its weights 1 and -1 cancel: no ruling leads there, so it is the worst.
TEST(RulingGrid, ARulingToInfinityCostsMost) {
  const Rail c(1, {0, 1}, {{1, 0, 0, 0}, {1, 1, 0, 0}});
  const Rail d(1, {0, 1}, {{1, 0, 1, 0}, {-1, -1, -1, -1}});
  for (const auto& [kind, largest] : {std::pair{AngleKind::planes, 0.5}, std::pair{AngleKind::sides, 1.0}}) {
    const RulingGrid grid({c, d}, 4, 4, kind);
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; j <= 4; ++j) {
        const double cost = static_cast<double>(grid.column(i)[j]);
        if (j == 2) {
          EXPECT_NEAR(cost, largest * std::numbers::pi, 1e-6);
          continue;
        }
        const double angle = std::abs(ruling_angle(c(i / 4.0), d(j / 4.0), kind).angle.value);
        EXPECT_NEAR(cost, angle, 0.005 * angle + 1e-3);
      }
    }
  }
}

/// A rail that rests where it begins has no tangent there, and no angle is asked for.
TEST(RulingGrid, ARailAtRestCostsNothing) {
  const Rails rails{
      test::rail_of({test::hundredths({0, 0, 100}), test::hundredths({0, 0, 0, 100}), test::hundredths({0})}),
      test::rail_of({test::hundredths({0, 100}), test::hundredths({0, 0, 100}), test::hundredths({100})})};
  const RulingGrid grid(rails, 4, 4, AngleKind::sides);
  for (int j = 0; j <= 4; ++j) EXPECT_EQ(grid.column(0)[j], 0) << j;
  EXPECT_GT(grid.column(1)[4], 0);
}

TEST(RulingGrid, RulingsWithoutAnAngleCostNothing) {
  const Rails meeting{
      test::rail_of({test::hundredths({0, 100}), test::hundredths({0}), test::hundredths({0})}),
      test::rail_of({test::hundredths({0, 100}), test::hundredths({0, 0, 100}), test::hundredths({0})})};
  const RulingGrid grid(meeting, 4, 4, AngleKind::sides);
  EXPECT_EQ(grid.column(0)[0], 0);
}

TEST(FollowPath, ValuesOfThePolyline) {
  const std::vector<double> path{0, 0.25, 0.25, 1};
  EXPECT_EQ(follow_path(path, {0, 1.0 / 6, 1.0 / 2, 5.0 / 6, 1}), (std::vector<double>{0, 0.125, 0.25, 0.625, 1}));
}

TEST(FollowPath, KeepsTheOrder) {
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> path, greville;
    for (int i = 0; i < 12; ++i) path.push_back(static_cast<double>(rng() % 97) / 96);
    for (int i = 0; i < 40; ++i) greville.push_back(static_cast<double>(rng() % 1001) / 1000);
    std::ranges::sort(path);
    std::ranges::sort(greville);
    const std::vector<double> beta = follow_path(path, greville);
    EXPECT_TRUE(std::ranges::is_sorted(beta));
    EXPECT_GE(beta.front(), path.front());
    EXPECT_LE(beta.back(), path.back());
  }
}

}  // namespace
}  // namespace torse::quasi
