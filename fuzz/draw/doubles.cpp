#include "torse/fuzz/draw/doubles.hpp"

#include <cmath>
#include <cstdint>

#include "torse/fuzz/property.hpp"

namespace torse::fuzz {
namespace {

double signed_part(std::uint64_t drawn) {
  const double size = static_cast<double>(drawn / 2);
  return drawn % 2 == 0 ? size : -size;
}

/// The length of the next knot interval, zero for a repeated knot.
double draw_step(Choices& choices, std::uint64_t kind) {
  if (kind == 1) {
    const double share = static_cast<double>(choices.below(1U << 20U)) * 0x1p-20;
    return std::ldexp(1 + share, choices.between(-30, 30));
  }
  if (kind == 2 && choices.once_in(3)) return 0;
  return kind == 0 ? 1 : 0.125 * static_cast<double>(1 + choices.below(64));
}

std::vector<double> draw_steps(Choices& choices, int degree, int last, Labels& labels) {
  const std::uint64_t kind = choices.below(3);
  labels.add("knots", kind == 0 ? "uniform" : kind == 1 ? "unlike" : "repeated");
  std::vector<double> knots{static_cast<double>(choices.below(4))};
  while (static_cast<int>(knots.size()) < last + degree) {
    const double next = knots.back() + draw_step(choices, kind);
    const std::size_t back = static_cast<std::size_t>(degree);
    if (knots.size() >= back && knots[knots.size() - back] == next) {
      knots.push_back(next + 1);
    } else {
      knots.push_back(next);
    }
  }
  const std::size_t first = static_cast<std::size_t>(degree) - 1;
  if (knots[first] == knots[static_cast<std::size_t>(last)]) throw Discard("the domain is empty");
  return knots;
}

double draw_parameter(Choices& choices, const std::vector<double>& knots, DoubleKind kind, Labels& labels,
                      const char* key) {
  const std::uint64_t which = choices.below(16);
  const double knot = knots[choices.below(knots.size())];
  if (which < 10) {
    labels.add(key, "generic");
    return knots.front() - 1 - std::abs(draw_double(choices, kind));
  }
  if (which < 13) {
    labels.add(key, "near a knot");
    return knot + std::ldexp(1, -choices.between(2, 40));
  }
  if (which < 15) {
    labels.add(key, "huge");
    return std::ldexp(1, choices.between(20, 300));
  }
  labels.add(key, "a knot");
  return knot;
}

}  // namespace

const char* name_of(DoubleKind kind) {
  constexpr const char* names[] = {"integer", "dyadic", "full", "scattered"};
  return names[static_cast<std::size_t>(kind)];
}

double draw_double(Choices& choices, DoubleKind kind) {
  switch (kind) {
    case DoubleKind::integer:
      return signed_part(choices.below(18));
    case DoubleKind::dyadic:
      return signed_part(choices.below(1U << 17U)) * 0x1p-10;
    case DoubleKind::full:
      return signed_part(choices.below(std::uint64_t{1} << 54U)) * 0x1p-53;
    case DoubleKind::scattered:
      break;
  }
  const int exponent = choices.between(-40, 40);
  return std::ldexp(signed_part(choices.below(std::uint64_t{1} << 54U)), exponent - 53);
}

DoubleNet draw_double_net(Choices& choices, int degree, int last, Labels& labels) {
  const auto kind = static_cast<DoubleKind>(choices.below(double_kinds));
  const auto draw_point = [&] {
    const double x = draw_double(choices, kind);
    const double y = draw_double(choices, kind);
    return Vec<double, 3>(x, y, draw_double(choices, kind));
  };
  labels.add("points", name_of(kind));
  DoubleNet net{degree, draw_steps(choices, degree, last, labels), {}, draw_point(), 0, 0};
  net.c.reserve(static_cast<std::size_t>(last) + 1);
  for (int i = 0; i <= last; ++i) net.c.push_back(draw_point());
  net.m = draw_parameter(choices, net.knots, kind, labels, "M");
  net.lambda = choices.once_in(16) ? net.m : draw_parameter(choices, net.knots, kind, labels, "Lambda");
  return net;
}

}  // namespace torse::fuzz
