// GoogleMock matchers for the tests of other people's surfaces: EXPECT_THAT(surface, IsDevelopable()).
//   IsDevelopable              the surface is developable, decided exactly
//   IsDevelopableWithin        its largest warp angle is at most so many degrees, certified
//   test_surface               a RuledSpline out of rows of Eigen vectors and a knot list of either convention
// A surface is a RuledSpline of doubles, floats or Rationals, of points (Vec<S, 3>) or of homogeneous rows w (1, x)
// (Vec<S, 4>). Floating-point numbers count as the exact numbers they are. Link GTest::gmock and torse::exact.
#pragma once

#include <gmock/gmock.h>

#include <concepts>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "torse/developable/ruled.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/exact/warp/max_warp.hpp"
#include "torse/exact/warp/words.hpp"

namespace torse::testing {

/// The exact value of a coordinate, weight or knot. Throws InvalidInput for NaN and infinities.
inline Rational exact_value(const Rational& x) { return x; }
template <std::floating_point S>
requires(sizeof(S) <= sizeof(double)) Rational exact_value(S x) { return Rational::from_double(x); }

/// The surface in exact numbers.
template <class S, int D>
RuledSpline<Rational, Vec<Rational, D>> exact_surface(const RuledSpline<S, Vec<S, D>>& surface) {
  const auto row = [](const std::vector<Vec<S, D>>& points) {
    std::vector<Vec<Rational, D>> exact(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int j = 0; j < D; ++j) exact[i][j] = exact_value(points[i][j]);
    }
    return exact;
  };
  std::vector<Rational> knots;
  for (const S& u : surface.knots.list()) knots.push_back(exact_value(u));
  return {KnotList<Rational>(surface.knots.degree(), std::move(knots)), row(surface.c), row(surface.d)};
}

/// A surface of degree `degree` between two rows. `knots` is the papers' list or the CAD list. Throws InvalidInput.
template <class S, int D>
RuledSpline<S, Vec<S, D>> test_surface(int degree, std::vector<S> knots, std::vector<Vec<S, D>> c,
                                       std::vector<Vec<S, D>> d) {
  const int last = static_cast<int>(c.size()) - 1;
  return {KnotList<S>::from_list(degree, last, std::move(knots)), std::move(c), std::move(d)};
}

/// The matcher behind IsDevelopable and IsDevelopableWithin; `limit` is none for exact developability.
class DevelopableMatcher {
 public:
  using is_gtest_matcher = void;

  explicit DevelopableMatcher(std::optional<Angle> limit) : limit_(std::move(limit)) {}

  /// False, with the reason, for a surface with numbers that are not finite and where the budget of the enclosure runs
  /// out before the limit is decided.
  template <class S, int D>
  bool MatchAndExplain(const RuledSpline<S, Vec<S, D>>& surface, std::ostream* explanation) const {
    std::string reason;
    bool holds = false;
    try {
      holds = judge(exact_surface<S, D>(surface), reason);
    } catch (const InvalidInput& invalid) {
      reason = invalid.what();
    }
    if (explanation != nullptr) *explanation << reason;
    return holds;
  }

  void DescribeTo(std::ostream* out) const { *out << "is " << demand(); }
  void DescribeNegationTo(std::ostream* out) const { *out << "is not " << demand(); }

 private:
  template <int D>
  bool judge(const RuledSpline<Rational, Vec<Rational, D>>& surface, std::string& reason) const {
    const auto witness = find_witness_over_q<D>(surface.knots, surface.c_row(), surface.d_row());
    if (!witness) {
      reason = "developable";
      return true;
    }
    const WarpEnclosure warp = max_warp<Rational, D>(surface.knots, surface.c_row(), surface.d_row());
    reason = "not developable: " + describe(*witness, surface.knots) + "; " + describe(warp);
    if (!limit_) return false;
    const Truth within = warp_at_most<Rational, D>(surface.knots, surface.c_row(), surface.d_row(), *limit_);
    if (within == Truth::unknown) reason += "; the budget ran out before the limit was decided";
    return definitely(within);
  }

  std::string demand() const {
    if (!limit_) return "developable";
    return "developable within a warp angle of " + short_number(limit_->value) +
           (limit_->radians ? " radians" : " degrees");
  }

  std::optional<Angle> limit_;
};

/// Matches surfaces that are developable, decided exactly.
inline DevelopableMatcher IsDevelopable() { return DevelopableMatcher(std::nullopt); }

/// Matches surfaces whose largest warp angle is at most `limit`, certified.
inline DevelopableMatcher IsDevelopableWithin(const Angle& limit) { return DevelopableMatcher(limit); }

/// The same in degrees; the double counts as the exact number it is.
inline DevelopableMatcher IsDevelopableWithin(double degrees) {
  return DevelopableMatcher(Angle{Rational::from_double(degrees), false});
}

}  // namespace torse::testing
