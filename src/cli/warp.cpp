// Reading angles, and the choice between points and homogeneous rows.
#include "torse/cli/warp.hpp"

#include "torse/cli/command.hpp"
#include "torse/io/number.hpp"

namespace torse::cli {
namespace {

template <int D>
WarpVerdict verdict(const KnotList<Rational>& u, const std::vector<Vec<Rational, D>>& c,
                    const std::vector<Vec<Rational, D>>& d, const std::optional<Angle>& limit) {
  WarpVerdict result{max_warp<Rational, D>(u, c, d)};
  if (limit) result.within_limit = warp_at_most<Rational, D>(u, c, d, *limit);
  return result;
}

}  // namespace

Angle read_angle(const std::string& text) {
  const bool radians = text.ends_with("rad");
  const std::string number = radians || text.ends_with("deg") ? text.substr(0, text.size() - 3) : text;
  try {
    Angle angle{parse_number<Rational>(number), radians};
    if (angle.value.sign() < 0) throw UsageError("--max-warp: expected an angle of at least 0, found " + text);
    return angle;
  } catch (const BadNumber& bad) {
    throw UsageError(std::string("--max-warp: ") + bad.what());
  }
}

WarpVerdict judge_warp(const RuledFile<Rational>& surface, const std::optional<Angle>& limit) {
  if (unit_weights(surface.c) && unit_weights(surface.d)) {
    return verdict<3>(surface.knots, surface.c.points, surface.d.points, limit);
  }
  return verdict<4>(surface.knots, homogeneous(surface.c), homogeneous(surface.d), limit);
}

}  // namespace torse::cli
