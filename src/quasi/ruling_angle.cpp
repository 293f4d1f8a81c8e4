#include "torse/quasi/ruling_angle.hpp"

#include <cmath>
#include <numbers>

namespace torse::quasi {

RulingAngle ruling_angle(const RulingTerms<double>& terms, AngleKind kind) {
  const auto& [x, volume, square] = terms;
  const double length = std::sqrt(square.value);
  const double by_length = 1 / length;
  const double length1 = square.first / 2 * by_length;
  const double length2 = (square.second / 2 - length1 * length1) * by_length;
  const Taylor<double> y{length * volume.value, length1 * volume.value + length * volume.first,
                         length2 * volume.value + 2 * length1 * volume.first + length * volume.second};
  const double norm = x.value * x.value + y.value * y.value;
  if (!(norm > 0)) return {{0, 0, 0}, false};

  RulingAngle ruling{{}, x.value < 0};
  ruling.angle.value = std::atan2(y.value, x.value);
  if (kind == AngleKind::planes && ruling.folded) {
    ruling.angle.value += ruling.angle.value > 0 ? -std::numbers::pi : std::numbers::pi;
  }
  const double by_norm = 1 / norm;
  ruling.angle.first = (x.value * y.first - y.value * x.first) * by_norm;
  ruling.angle.second =
      (x.value * y.second - y.value * x.second - 2 * ruling.angle.first * (x.value * x.first + y.value * y.first)) *
      by_norm;
  return ruling;
}

RulingAngle ruling_angle(const RailJet& c, const RailJet& d, AngleKind kind) {
  return ruling_angle(ruling_terms<double>(c.first, d.point - c.point, d.first, d.second, d.third), kind);
}

}  // namespace torse::quasi
