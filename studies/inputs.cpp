#include "torse/studies/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "torse/proofs/random.hpp"

namespace torse::studies {
namespace {

using proofs::Rng;

/// Uniform in [low, high], of 53 bits.
double uniform(Rng& rng, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(rng() >> 11), -53);
}

/// ratio^share, share in [0, 1], without the library's pow: squarings and square roots are rounded alike everywhere.
double power(double ratio, double share) {
  double result = 1;
  double root = ratio;
  for (int bit = 0; bit < 20; ++bit) {
    root = std::sqrt(root);
    share *= 2;
    if (share >= 1) {
      result *= root;
      share -= 1;
    }
  }
  return result;
}

/// `count` numbers of [1, ratio] with both ends among them where there are two or more.
std::vector<double> spread(Rng& rng, std::size_t count, double ratio) {
  std::vector<double> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(power(ratio, uniform(rng, 0, 1)));
  const std::size_t first = rng.below(count);
  list[first] = 1;
  if (count > 1) list[(first + 1 + rng.below(count - 1)) % count] = ratio;
  return list;
}

std::vector<float> draw_knots(Rng& rng, const Levels& levels) {
  const std::size_t n = static_cast<std::size_t>(levels.degree());
  std::vector<double> spans = spread(rng, static_cast<std::size_t>(levels.pieces()), levels[Factor::knot_ratio]);
  double length = 0;
  for (const double span : spans) length += span;
  std::vector<float> u(n, 0.0F);
  double end = 0;
  for (const double span : spans) {
    end += span / length;
    u.push_back(std::max(static_cast<float>(end), std::nextafter(u.back(), 2.0F)));
  }
  u.back() = std::max(u.back(), 1.0F);
  u.insert(u.end(), n - 1, u.back());
  return u;
}

FloatPoint near(Rng& rng, const std::array<double, 3>& center) {
  FloatPoint x;
  for (std::size_t j = 0; j < 3; ++j) x[j] = static_cast<float>(center[j] + uniform(rng, -1, 1));
  return x;
}

std::vector<FloatPoint> draw_row(Rng& rng, int last, double offset) {
  std::vector<FloatPoint> row;
  for (int i = 0; i <= last; ++i) row.push_back(near(rng, {offset + i, offset, offset}));
  return row;
}

std::vector<float> draw_weights(Rng& rng, const Levels& levels) {
  std::vector<float> weights;
  for (const double w : spread(rng, static_cast<std::size_t>(levels.last()) + 1, levels[Factor::weight_ratio])) {
    weights.push_back(static_cast<float>(w));
  }
  return weights;
}

/// M*, not at a knot: a level too small for a float next to the knot becomes the next float.
float draw_m(const Case& in, const Levels& levels) {
  if (levels[Factor::before] > 0) return static_cast<float>(-levels[Factor::before]);
  const bool inside = levels[Factor::inside] > 0;
  const std::size_t n = static_cast<std::size_t>(in.degree);
  const float knot = inside ? in.knots[n - 1 + (in.knots.size() - 2 * n + 1) / 2] : in.knots.back();
  float m = static_cast<float>(knot + levels[inside ? Factor::inside : Factor::after]);
  while (std::ranges::find(in.knots, m) != in.knots.end()) m = std::nextafter(m, 0x1p100F);
  return m;
}

}  // namespace

Case draw_case(const Levels& levels, std::uint64_t seed) {
  Rng rng(seed);
  Case in;
  const double offset = levels[Factor::offset];
  in.degree = levels.degree();
  in.knots = draw_knots(rng, levels);
  in.c = draw_row(rng, levels.last(), offset);
  in.e = draw_row(rng, levels.last(), offset);
  in.weights = draw_weights(rng, levels);
  in.e_weights = draw_weights(rng, levels);
  in.m = draw_m(in, levels);
  in.lambda = static_cast<float>(in.m + (rng.once_in(2) ? 1 : -1) * levels[Factor::gap] * uniform(rng, 0.5, 1));
  in.sigma = static_cast<float>(uniform(rng, 0.5, 2));
  in.share = static_cast<float>(uniform(rng, 0.25, 0.75));
  for (std::size_t a = 0; a < 3; ++a) {
    const FloatPoint& foot = in.c[(in.c.size() - 1) * a / 2];
    in.anchors[a] = near(rng, {foot[0], foot[1], foot[2]});
  }
  return in;
}

std::vector<float> numbers_of(const Case& in) {
  std::vector<float> numbers;
  static_cast<void>(lift<double>(in, [&](float x, std::size_t) {
    numbers.push_back(x);
    return static_cast<double>(x);
  }));
  return numbers;
}

std::string hex_text(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

std::string input_file(const Case& in) {
  const auto number = [](float x) { return '"' + hex_text(x) + '"'; };
  const auto list = [&](const auto& xs, const auto& shown) {
    std::string text = "[";
    for (const auto& x : xs) text += (text.size() > 1 ? "," : "") + shown(x);
    return text + "]";
  };
  const auto point = [&](const FloatPoint& x) { return list(x, number); };
  return "{\"torse\":1,\"type\":\"construct\",\"method\":\"bspline\",\"degree\":" + std::to_string(in.degree) +
         ",\"knots\":" + list(in.knots, number) + ",\"c\":{\"points\":" + list(in.c, point) +
         "},\"Lambda\":" + number(in.lambda) + ",\"M\":" + number(in.m) + ",\"d0\":" + point(in.anchors[0]) + "}";
}

}  // namespace torse::studies
