#include "torse/figures/scene.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "torse/scalar/errors.hpp"

namespace torse::figures {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::string line_style(const Ink& ink) {
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linecap=\"round\"{}", ink.colour,
                     ink.width, ink.dashed ? " stroke-dasharray=\"4 3\"" : "");
}

}  // namespace

Scene::Scene(double azimuth, double elevation) {
  const double a = radians(azimuth);
  const double e = radians(elevation);
  view_.row(0) << -std::sin(a), std::cos(a), 0;
  view_.row(2) << std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e);
  view_.row(1) = Vector(view_.row(2)).cross(Vector(view_.row(0)));
}

double Scene::shade(const std::vector<Vector>& corners) const {
  const Vector normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
  const double length = normal.norm();
  const Vector light = view_.transpose() * Vector(-0.35, 0.55, 0.76).normalized();
  return length > 0 ? std::abs(normal.dot(light)) / length : 1;
}

void Scene::surface(const std::vector<std::vector<Vector>>& rows, double hue) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    for (std::size_t j = 0; j + 1 < rows[i].size(); ++j) {
      const std::vector<Vector> corners{rows[i][j], rows[i][j + 1], rows[i + 1][j + 1], rows[i + 1][j]};
      facet(corners, fmt::format("hsl({:.0f},55%,{:.1f}%)", hue, 52 + 36 * shade(corners)));
    }
  }
}

void Scene::facet(const std::vector<Vector>& corners, const std::string& colour) {
  shapes_.push_back({corners, fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.6\"", colour), true, 0});
}

void Scene::plane(const std::vector<Vector>& corners, const std::string& colour) {
  shapes_.push_back({corners,
                     fmt::format("fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\" stroke-width=\"0.8\"", colour),
                     true, 0.01});
}

void Scene::line(const std::vector<Vector>& points, const Ink& ink) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    shapes_.push_back({{points[i], points[i + 1]}, line_style(ink), false, 0.03});
  }
}

void Scene::polygon(const std::vector<Vector>& points, const Ink& ink) {
  line(points, ink);
  for (const Vector& x : points) dot(x, ink.colour);
}

void Scene::dot(const Vector& at, const std::string& colour, double radius) {
  marks_.push_back({at, "", colour, radius, 0, 0});
}

void Scene::word(const Vector& at, const std::string& text, double right, double down) {
  marks_.push_back({at, text, "", 0, right, down});
}

std::string Scene::svg(const Frame& frame) const {
  Vector low = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector high = -low;
  const auto reach = [&](const Vector& x) {
    if (!x.allFinite()) throw InvalidInput("scene", "expected finite places only");
    low = low.cwiseMin(seen(x));
    high = high.cwiseMax(seen(x));
  };
  for (const Shape& shape : shapes_) std::ranges::for_each(shape.points, reach);
  for (const Mark& mark : marks_) reach(mark.at);
  if (!low.allFinite()) return "";

  const Vector size = high - low;
  const double scale = std::min(frame.width / std::max(size[0], 1e-300), frame.height / std::max(size[1], 1e-300));
  const auto place = [&](const Vector& x) {
    const Vector at = seen(x) - (low + high) / 2;
    return std::pair(frame.x + frame.width / 2 + scale * at[0], frame.y + frame.height / 2 - scale * at[1]);
  };

  std::vector<std::pair<double, const Shape*>> order;
  for (const Shape& shape : shapes_) {
    double depth = 0;
    for (const Vector& x : shape.points) depth += seen(x)[2];
    order.emplace_back(depth / static_cast<double>(shape.points.size()) + shape.nearer * size.norm(), &shape);
  }
  std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first; });

  std::string svg;
  for (const auto& [depth, shape] : order) {
    std::string path;
    for (const Vector& x : shape->points) {
      const auto [right, down] = place(x);
      path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", right, down);
    }
    svg += fmt::format("  <path {} d=\"{}{}\"/>\n", shape->style, path, shape->closed ? "Z" : "");
  }
  for (const Mark& mark : marks_) {
    const auto [right, down] = place(mark.at);
    if (mark.text.empty()) {
      svg += fmt::format("  <circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.1f}\" fill=\"{}\"/>\n", right, down, mark.radius,
                         mark.colour);
    } else {
      svg += fmt::format("  <text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", right + mark.right, down + mark.down,
                         svg_escaped(mark.text));
    }
  }
  return svg;
}

}  // namespace torse::figures
