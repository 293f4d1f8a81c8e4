// What a descent adds up over its samples instead of the angles: smooth functions of them.
//   Measure              what is made small: the mean, the root mean square or the maximum of the angles
//   Loss                 the loss of an angle, with its derivatives
#pragma once

#include <cmath>

#include "torse/quasi/ruling_angle.hpp"

namespace torse::quasi {

/// Of the angles at the samples.
enum class Measure { mean, rms, max };

/// The last power of the losses of the maximum, and that of a cap.
inline constexpr double most_power = 64;

/// A smooth loss of an angle: its value, slope and curvature.
struct Loss {
  Measure measure;
  double scale;  ///< delta of the mean, the largest angle of the maximum
  double power;  ///< of the maximum
  double cap;    ///< of the mean, infinite for none

  Taylor<double> operator()(double angle) const {
    if (measure == Measure::mean) {
      const double value = std::sqrt(angle * angle + scale * scale);
      const double share = std::abs(angle) / cap;
      const double low = std::pow(share, most_power - 2);
      return {value + (low > 0 ? low * share * share * cap : 0),
              angle / value + std::copysign(most_power * low * share, angle),
              scale / value * (scale / value) / value + most_power * (most_power - 1) * low / cap};
    }
    if (measure == Measure::rms) return {angle * angle, 2 * angle, 2};
    const double share = std::abs(angle) / scale;
    const double low = std::pow(share, power - 2);
    return {low * share * share, std::copysign(power * low * share / scale, angle),
            power * (power - 1) * low / (scale * scale)};
  }
};

}  // namespace torse::quasi
