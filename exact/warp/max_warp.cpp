// The three stages: doubles for all pieces, balls for those left open, exact rationals for the rest.
#include "torse/exact/warp/max_warp.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "torse/developable/warp.hpp"
#include "torse/exact/decide/evaluation.hpp"
#include "torse/exact/warp/common_factor.hpp"
#include "torse/exact/warp/exact_cost.hpp"
#include "torse/exact/warp/exact_quotients.hpp"
#include "torse/exact/warp/piece_bounds.hpp"
#include "torse/exact/warp/rounded_net.hpp"
#include "torse/exact/warp/search.hpp"
#include "torse/exact/warp/surface.hpp"

namespace torse {
namespace {

constexpr int ball_bits = 256;
using WarpBall = Ball<ball_bits>;

/// The cost of a step in balls, one in doubles being 1.
constexpr double ball_cost = 300;

/// Pieces that are bounded only, in balls, as a multiple of the steps of a search there.
constexpr double most_bounded = 4;

/// Products of coefficients times their bits that the quotients of the exact stage may take to make: some seconds.
constexpr double most_exact_work = 0x1p28;

/// One run through the stages.
template <class S, int D>
class WarpRun {
 public:
  WarpRun(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d, const WarpOptions& options,
          std::optional<Angle> limit)
      : u_(u), c_(c), d_(d), options_(options), limit_(std::move(limit)) {
    const std::size_t expected = static_cast<std::size_t>(u.last()) + 1;
    if (c.size() != expected || d.size() != expected) {
      throw InvalidInput("points", "expected " + std::to_string(expected) + " control points in each row");
    }
    if (!(options.tolerance >= 1e-9 && options.tolerance <= 1)) {
      throw InvalidInput("tolerance", "expected a number between 1e-9 and 1");
    }
    goal_.tolerance = options.tolerance;
  }

  void run() {
    set_scale(0);
    std::vector<int> open = rounded_stage(u_.proper_pieces());
    if (!done(open)) open = ball_stage(open);
    if (!done(open)) open = exact_stage(open);
    if (!open.empty() && !exceeded()) bound_open(open);
    // Scaled values (settle_exactly) may leave the range of doubles where they differ by more than that.
    if (record_.upper == detail::infinity) record_.complete = false;
  }

  /// The answer to the limit.
  Truth within_limit() const {
    if (exceeded()) return Truth::no;
    return record_.upper <= goal_.limit->lower() ? Truth::yes : Truth::unknown;
  }

  WarpEnclosure enclosure() {
    WarpEnclosure result;
    const Interval degrees = degrees_of(record_.lower, record_.upper, record_.scale);
    result.lower = degrees.lower();
    result.upper = degrees.upper();
    result.piece = record_.piece;
    if (record_.piece > 0) result.parameter = parameter(record_.piece, Rational::from_double(record_.position));
    result.exclusions = std::move(exclusions_);
    result.stage = stage_;
    result.intervals = record_.intervals;
    result.complete = record_.complete;
    return result;
  }

 private:
  static Rational exact(const S& x) {
    if constexpr (std::is_same_v<S, double>) {
      return Rational::from_double(x);
    } else {
      return x;
    }
  }

  Rational parameter(int k, const Rational& t) const {
    const Rational begin = exact(u_.piece_begin(k));
    return begin + t * (exact(u_.piece_end(k)) - begin);
  }

  void set_scale(long scale) {
    record_.scale = scale;
    if (limit_) goal_.limit = sine_squared_at_most_90(*limit_, scale);
  }

  bool exceeded() const { return goal_.limit && record_.lower > goal_.limit->upper(); }
  bool done(const std::vector<int>& open) const { return open.empty() || exceeded() || !record_.complete; }

  /// The number of sub-intervals where each costs `factor` times as much as in doubles; the cost grows with the square
  /// of the degree of the quotient.
  long budget(double factor) const {
    const double size = std::max(1.0, (sine_degree<D>(u_.degree()) + 1) / 21.0);
    return std::max(1L, static_cast<long>(static_cast<double>(options_.intervals) / (factor * size * size)));
  }

  template <class Q>
  std::vector<int> settle(std::vector<WarpPiece<Q>>& pieces, long budget) {
    std::vector<int> open;
    for (const std::size_t i : search(pieces, goal_, budget, record_)) open.push_back(pieces[i].piece);
    return open;
  }

  std::vector<int> rounded_stage(const std::vector<int>& pieces) {
    const std::optional<RoundedNet<D>> net = rounded_net(u_, c_, d_);
    if (!net) return pieces;
    std::vector<int> high = pieces;
    if constexpr (D == 3) high = high_pieces(*net, pieces);
    std::vector<int> open;
    std::vector<WarpPiece<RoundedQuotient>> quotients;
    quotients.reserve(high.size());
    for (const int k : high) {
      if (std::optional<RoundedQuotient> quotient = rounded_quotient(*net, k)) {
        quotients.push_back({k, *std::move(quotient)});
      } else {
        open.push_back(k);
      }
    }
    const std::vector<int> rest = settle(quotients, budget(1));
    open.insert(open.end(), rest.begin(), rest.end());
    return open;
  }

  /// The quotients of these pieces in doubles; none where one has none.
  std::optional<std::vector<RoundedQuotient>> rounded_quotients(const std::vector<int>& pieces) const {
    const std::optional<RoundedNet<D>> net = rounded_net(u_, c_, d_);
    if (!net) return std::nullopt;
    std::vector<RoundedQuotient> quotients;
    for (const int k : pieces) {
      std::optional<RoundedQuotient> quotient = rounded_quotient(*net, k);
      if (!quotient) return std::nullopt;
      quotients.push_back(*std::move(quotient));
    }
    return quotients;
  }

  std::vector<BernsteinQuotient<WarpBall>> ball_quotients(const std::vector<int>& pieces) const {
    const Surface<WarpBall, D> surface = converted<WarpBall, Rational, D>(
        surface_->knots, surface_->c, surface_->d, [](const Rational& x) { return WarpBall::rational(x.text()); });
    std::vector<BernsteinQuotient<WarpBall>> quotients;
    quotients.reserve(pieces.size());
    for (const int k : pieces) quotients.push_back(quotient_of(sine_forms_of(surface, k)));
    return quotients;
  }

  /// Pieces that no stage has settled count by the best bound that there is.
  void bound_open(const std::vector<int>& open) {
    record_.complete = false;
    const double threshold = record_.scale == 0 ? detail::search_threshold(record_, goal_) : 0;
    double bound = detail::infinity;
    if (std::optional<std::vector<RoundedQuotient>> quotients = rounded_quotients(open)) {
      bound = bound_above(*std::move(quotients), threshold, budget(1) / 10);
    }
    if (bound > threshold &&
        static_cast<double>(open.size()) <= most_bounded * static_cast<double>(budget(ball_cost))) {
      if (!surface_) surface_ = converted<Rational, S, D>(u_, c_, d_, exact);
      bound = std::min(bound, bound_above(ball_quotients(open), threshold, budget(ball_cost) / 10));
    }
    if (record_.scale == 0) bound = std::min(bound, 1.0);
    record_.upper = std::max(record_.upper, std::ldexp(bound, static_cast<int>(2 * record_.scale)));
  }

  /// Settles what the cheap bounds can, and returns the other pieces.
  std::vector<int> high_pieces(const RoundedNet<3>& net, const std::vector<int>& pieces) {
    if (static_cast<long>(pieces.size()) > budget(1)) return pieces;
    const std::vector<PieceBound> bounds = piece_bounds(net, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      detail::note(record_, bounds[i].at_begin, pieces[i], 0);
      detail::note(record_, bounds[i].at_end, pieces[i], 1);
    }
    record_.intervals += static_cast<long>(pieces.size());
    if (exceeded()) return {};
    const double threshold = detail::search_threshold(record_, goal_);
    std::vector<int> high;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (bounds[i].upper <= threshold) {
        record_.upper = std::max(record_.upper, bounds[i].upper);
      } else {
        high.push_back(pieces[i]);
      }
    }
    return high;
  }

  std::vector<int> ball_stage(std::vector<int> pieces) {
    stage_ = WarpStage::balls;
    surface_ = converted<Rational, S, D>(u_, c_, d_, exact);
    const std::vector<Integer> knots = integer_knots(surface_->knots.list());
    std::erase_if(pieces, [&](int k) {  // developable: 0
      return PieceEvaluator<D>(u_.degree(), knots, surface_->c, surface_->d, k).vanishes();
    });
    if (static_cast<long>(pieces.size()) > budget(ball_cost)) return pieces;
    std::vector<BernsteinQuotient<WarpBall>> quotients = ball_quotients(pieces);
    std::vector<WarpPiece<BernsteinQuotient<WarpBall>>> list;
    for (std::size_t i = 0; i < pieces.size(); ++i) list.push_back({pieces[i], std::move(quotients[i])});
    return settle(list, budget(ball_cost));
  }

  std::vector<int> exact_stage(const std::vector<int>& pieces) {
    stage_ = WarpStage::exact;
    if (static_cast<long>(pieces.size()) > budget(exact_cost(*surface_)) ||
        exact_work(*surface_, pieces) > most_exact_work)
      return pieces;
    std::vector<SineForms<Rational>> forms;
    for (const int k : pieces) {
      const RulingForms<Rational> fractions = ruling_forms<Rational>(surface_->knots, surface_->c, surface_->d, k);
      const RulingForms<Rational> ruling{with_integers(fractions.a), with_integers(fractions.w),
                                         with_integers(fractions.b)};
      const auto [first, second] = normal_forms(ruling);
      const VectorWithZeros m = without_common_zeros(first);
      const VectorWithZeros n = without_common_zeros(second);
      for (const RealRoot& t : zeros_in_unit_interval(m.divisor * n.divisor)) {
        exclusions_.push_back({k, parameter(k, t.lower), parameter(k, t.upper)});
      }
      forms.push_back(in_lowest_terms(sine_forms(with_integers(m.direction), with_integers(n.direction))));
    }
    return settle_exactly(pieces, forms);
  }

  std::vector<int> settle_exactly(const std::vector<int>& pieces, const std::vector<SineForms<Rational>>& forms) {
    if (record_.lower == 0 && record_.upper < 0x1p-800) set_scale(scale_for(forms));
    std::vector<WarpPiece<BernsteinQuotient<Rational>>> quotients;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      quotients.push_back({pieces[i], quotient_of(scaled(forms[i], record_.scale))});
    }
    const std::vector<std::size_t> tangent = search(quotients, goal_, budget(exact_cost(*surface_)), record_);
    std::vector<int> open;
    for (const std::size_t i : tangent) {
      if (!attains_limit_only(forms[i])) open.push_back(pieces[i]);
    }
    return open;
  }

  /// Whether the limit is a rational number that a piece may attain but does not exceed.
  bool attains_limit_only(const SineForms<Rational>& forms) const {
    const std::optional<Rational> value = limit_ ? exact_sine_squared(*limit_) : std::nullopt;
    return value && nowhere_above(forms, *value);
  }

  const KnotList<S>& u_;
  std::span<const Vec<S, D>> c_;
  std::span<const Vec<S, D>> d_;
  WarpOptions options_;
  std::optional<Angle> limit_;
  WarpGoal goal_;
  WarpRecord record_;
  WarpStage stage_ = WarpStage::rounded;
  std::optional<Surface<Rational, D>> surface_;
  std::vector<WarpExclusion> exclusions_;
};

}  // namespace

std::string_view name_of(WarpStage stage) {
  return stage == WarpStage::rounded ? "double" : stage == WarpStage::balls ? "balls" : "exact";
}

template <class S, int D>
WarpEnclosure max_warp(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d,
                       const WarpOptions& options) {
  WarpRun<S, D> run(u, c, d, options, std::nullopt);
  run.run();
  return run.enclosure();
}

template <class S, int D>
Truth warp_at_most(const KnotList<S>& u, std::span<const Vec<S, D>> c, std::span<const Vec<S, D>> d, const Angle& angle,
                   const WarpOptions& options) {
  WarpRun<S, D> run(u, c, d, options, angle);
  run.run();
  return run.within_limit();
}

template WarpEnclosure max_warp<Rational, 3>(const KnotList<Rational>&, std::span<const Vec<Rational, 3>>,
                                             std::span<const Vec<Rational, 3>>, const WarpOptions&);
template WarpEnclosure max_warp<Rational, 4>(const KnotList<Rational>&, std::span<const Vec<Rational, 4>>,
                                             std::span<const Vec<Rational, 4>>, const WarpOptions&);
template WarpEnclosure max_warp<double, 3>(const KnotList<double>&, std::span<const Vec<double, 3>>,
                                           std::span<const Vec<double, 3>>, const WarpOptions&);
template WarpEnclosure max_warp<double, 4>(const KnotList<double>&, std::span<const Vec<double, 4>>,
                                           std::span<const Vec<double, 4>>, const WarpOptions&);
template Truth warp_at_most<Rational, 3>(const KnotList<Rational>&, std::span<const Vec<Rational, 3>>,
                                         std::span<const Vec<Rational, 3>>, const Angle&, const WarpOptions&);
template Truth warp_at_most<Rational, 4>(const KnotList<Rational>&, std::span<const Vec<Rational, 4>>,
                                         std::span<const Vec<Rational, 4>>, const Angle&, const WarpOptions&);
template Truth warp_at_most<double, 3>(const KnotList<double>&, std::span<const Vec<double, 3>>,
                                       std::span<const Vec<double, 3>>, const Angle&, const WarpOptions&);
template Truth warp_at_most<double, 4>(const KnotList<double>&, std::span<const Vec<double, 4>>,
                                       std::span<const Vec<double, 4>>, const Angle&, const WarpOptions&);

}  // namespace torse
