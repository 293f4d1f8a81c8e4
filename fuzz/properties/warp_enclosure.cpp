#include "torse/fuzz/properties/warp_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "torse/exact/warp/max_warp.hpp"
#include "torse/exact/warp/piece_bounds.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/rough.hpp"
#include "torse/fuzz/plain/angle.hpp"

namespace torse::fuzz {
namespace {

template <class S, int D>
using Row = std::vector<Vec<S, D>>;

/// An exact sin^2 somewhere; none where it is not defined.
struct Sample {
  int piece;
  Rational t;
  std::optional<Rational> sine;
};

template <int D>
class Surface {
 public:
  explicit Surface(const Net<D>& net)
      : pieces_(net.knots.proper_pieces()), strip_(plain::strip_of(net.knots, net.c, net.d)) {}

  std::optional<Rational> sine_at(int piece, const Rational& t) const {
    const auto j = std::find(pieces_.begin(), pieces_.end(), piece) - pieces_.begin();
    return plain::sine_squared(plain::ruling_at(strip_, static_cast<int>(j), t));
  }

  /// At both ends of each piece too.
  std::vector<Sample> samples(std::vector<Rational> shares) const {
    std::vector<Sample> list;
    shares.insert(shares.end(), {Rational(0), Rational(1)});
    for (std::size_t j = 0; j < pieces_.size(); ++j) {
      for (const Rational& share : shares) {
        const Rational& begin = strip_.p.breaks[j];
        const Rational t = begin + share * (strip_.p.breaks[j + 1] - begin);
        list.push_back({pieces_[j], t, sine_at(pieces_[j], t)});
      }
    }
    return list;
  }

  bool developable() const { return plain::holds_by_samples(strip_); }
  bool developable(int piece) const {
    const auto j = static_cast<std::size_t>(std::find(pieces_.begin(), pieces_.end(), piece) - pieces_.begin());
    const std::vector<Rational> breaks{strip_.p.breaks[j], strip_.p.breaks[j + 1]};
    return plain::holds_by_samples({{breaks, {strip_.p.rows[j]}}, {breaks, {strip_.q.rows[j]}}});
  }

 private:
  std::vector<int> pieces_;
  plain::Strip strip_;
};

bool covers(const std::vector<WarpExclusion>& list, const Sample& x) {
  return std::any_of(list.begin(), list.end(),
                     [&](const WarpExclusion& e) { return e.piece == x.piece && e.lower <= x.t && x.t <= e.upper; });
}

/// The ends are bounds of the angle at every parameter, the lower one is reached.
template <int D>
void check_bounds(const WarpEnclosure& warp, const Surface<D>& surface, const std::vector<Sample>& samples) {
  require(0 <= warp.lower && warp.lower <= warp.upper && warp.upper <= 90, "the bounds are not in order");
  const Rational above = plain::sine_squared_above(Rational::from_double(warp.upper));
  for (const Sample& x : samples) {
    if (x.sine) {
      require(*x.sine <= above, "an angle is larger than the upper bound");
    } else if (warp.complete && warp.upper > 0) {
      require(covers(warp.exclusions, x) || surface.developable(x.piece), "an excluded parameter is not listed");
    }
  }
  if (warp.lower == 0) return;
  const std::optional<Rational> sine = surface.sine_at(warp.piece, warp.parameter);
  require(!sine || *sine >= plain::sine_squared_below(Rational::from_double(warp.lower)),
          "the lower bound is not reached where it should be");
}

void check_exclusions(const WarpEnclosure& warp, const KnotList<Rational>& u) {
  for (const WarpExclusion& e : warp.exclusions) {
    require(u.piece_begin(e.piece) <= e.lower && e.lower <= e.upper && e.upper <= u.piece_end(e.piece),
            "an exclusion outside its piece");
  }
}

/// 10^-digits as the option holds it.
double tolerance_of(int digits) { return std::pow(10.0, -digits); }

template <class S, int D>
void check_enclosure(const typename WarpEnclosures<D>::In& in, const KnotList<S>& u, const Row<S, D>& c,
                     const Row<S, D>& d, const Surface<D>& surface, const std::vector<Sample>& samples,
                     std::vector<WarpEnclosure>& found) {
  const WarpOptions options{tolerance_of(in.tolerance), in.intervals};
  const WarpEnclosure warp = max_warp<S, D>(u, c, d, options);
  check_bounds(warp, surface, samples);
  check_exclusions(warp, in.net.knots);
  const bool developable = surface.developable();
  require(warp.upper > 0 || developable, "0 for a surface that is not developable");
  require(warp.upper == 0 || !developable || (!warp.complete && in.intervals < WarpOptions{}.intervals),
          "more than 0 for a developable surface");
  if (warp.complete && warp.upper >= std::numeric_limits<double>::min()) {
    require(warp.upper - warp.lower <= options.tolerance * warp.upper, "the bounds are wider than promised");
  }
  found.push_back(warp);
}

/// A decision contradicts neither the angles nor the enclosure.
template <class S, int D>
Truth check_limit(const typename WarpEnclosures<D>::In& in, const KnotList<S>& u, const Row<S, D>& c,
                  const Row<S, D>& d, const WarpEnclosure& warp, const std::vector<Sample>& samples,
                  const Rational& limit) {
  const WarpOptions options{tolerance_of(in.tolerance), in.intervals};
  const Truth within = warp_at_most<S, D>(u, c, d, Angle{limit}, options);
  const Rational lower = Rational::from_double(warp.lower);
  const Rational upper = Rational::from_double(warp.upper);
  if (within == Truth::no) {
    require(upper > limit, "more than a limit that the upper bound is not above");
    return within;
  }
  if (within == Truth::unknown) return within;
  require(lower <= limit, "at most a limit that the lower bound is above");
  const Rational above = plain::sine_squared_above(limit);
  for (const Sample& x : samples) require(!x.sine || *x.sine <= above, "an angle is larger than a limit that holds");
  return within;
}

template <int D>
Row<double, D> in_doubles(const Row<Rational, D>& row) {
  Row<double, D> result(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (int j = 0; j < D; ++j) result[i][j] = row[i][j].to_double();
  }
  return result;
}

KnotList<double> in_doubles(const KnotList<Rational>& u) {
  std::vector<double> list;
  for (const Rational& x : u.list()) list.push_back(x.to_double());
  return {u.degree(), std::move(list)};
}

/// The net with every number rounded to a double; its truth goes.
template <int D>
void round_to_doubles(Net<D>& net) {
  const auto rounded = [](const Rational& x) {
    const double value = x.to_double();
    if (!std::isfinite(value)) throw Discard("beyond the range of doubles");
    return Rational::from_double(value);
  };
  for (auto* row : {&net.c, &net.d}) {
    for (Vec<Rational, D>& x : *row) {
      for (int j = 0; j < D; ++j) x[j] = rounded(x[j]);
    }
  }
  std::vector<Rational> knots;
  for (const Rational& x : net.knots.list()) knots.push_back(rounded(x));
  try {
    net.knots = KnotList<Rational>(net.knots.degree(), std::move(knots));
  } catch (const InvalidInput&) {
    throw Discard("knots that are the same double");
  }
}

template <int D>
Row<Rational, D> moved(const SpaceMap& map, const Row<Rational, D>& row) {
  Row<Rational, D> result;
  for (const Vec<Rational, D>& x : row) result.push_back(map(x));
  return result;
}

/// Bounds of single pieces in doubles.
void check_pieces(const Net<3>& net, const std::vector<Sample>& samples, const Surface<3>& surface, Labels& labels) {
  const std::optional<RoundedNet<3>> rounded = rounded_net<3>(net.knots, net.c, net.d);
  if (!rounded) return;
  const std::vector<int> pieces = net.knots.proper_pieces();
  const std::vector<PieceBound> bounds = piece_bounds(*rounded, pieces);
  require(bounds.size() == pieces.size(), "another number of bounds than of pieces");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto within = [&](double bound, const Rational& t) {
      const std::optional<Rational> sine = surface.sine_at(pieces[i], t);
      require(!sine || *sine >= Rational::from_double(bound), "the angle at an end of a piece is below its bound");
    };
    within(bounds[i].at_begin, net.knots.piece_begin(pieces[i]));
    within(bounds[i].at_end, net.knots.piece_end(pieces[i]));
    labels.add("piece bound", std::isfinite(bounds[i].upper) ? "finite" : "infinite");
    if (!std::isfinite(bounds[i].upper)) continue;
    const Rational upper = Rational::from_double(bounds[i].upper);
    for (const Sample& x : samples) {
      require(x.piece != pieces[i] || !x.sine || *x.sine <= upper, "an angle is larger than the bound of its piece");
    }
  }
}
void check_pieces(const Net<4>&, const std::vector<Sample>&, const Surface<4>&, Labels&) {}

void check_overlap(const std::vector<WarpEnclosure>& found) {
  for (const WarpEnclosure& x : found) {
    for (const WarpEnclosure& y : found)
      require(x.lower <= y.upper, "two enclosures of one angle have no angle in common");
  }
}

}  // namespace

template <>
const PropertyInfo& WarpEnclosures<3>::info() {
  static const PropertyInfo info{
      "enclosure.warp",
      "the warp angle at every parameter is within the enclosure of the largest one and within the bound of its piece, "
      "the lower bound is reached, 0 means developable; decisions contradict neither; motions, factors and doubles "
      "give enclosures of the same angle",
      4,
      {"class=plane", "class=tangent", "class=none", "made=rough", "doubles=1", "complete=yes", "stage=double",
       "stage=balls", "stage=exact", "within=yes", "within=no", "piece bound=finite"}};
  return info;
}

template <>
const PropertyInfo& WarpEnclosures<4>::info() {
  static const PropertyInfo info{"enclosure.rational_warp",
                                 "the same of homogeneous rows",
                                 2,
                                 {"class=none", "made=rough", "doubles=1", "complete=yes", "stage=double",
                                  "stage=balls", "within=yes", "within=no"}};
  return info;
}

template <int D>
typename WarpEnclosures<D>::In WarpEnclosures<D>::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in;
  if constexpr (D == 3) {
    in.net = draw_net(choices, scale);
  } else {
    in.net = draw_rational_net(choices, scale);
  }
  if (choices.once_in(2)) roughen(choices, in.net);
  add_net_labels(labels, in.net);
  in.doubles = choices.once_in(2);
  if (in.doubles) round_to_doubles(in.net);
  in.tolerance = choices.pick({3, 1, 6});
  in.intervals = in.net.developable && !in.doubles ? static_cast<int>(WarpOptions{}.intervals)
                                                   : choices.pick({1000, 20000, 100000, 10});
  switch (choices.below(3)) {
    case 0:
      in.limit = Rational(choices.pick({30, 0, 45, 60, 90, 1}));
      break;
    case 1:
      in.limit = draw_fraction(choices, 6);
      break;
    default:
      in.limit = power_of_two(-choices.between(0, 60));
  }
  if (in.limit.sign() < 0) in.limit = -in.limit;
  in.motion = choices.once_in(2) ? draw_similarity(choices, scale) : identity_map();
  for (int i = 0; i < 4; ++i) in.shares.push_back(Rational(choices.between(0, 32)) / Rational(32));
  labels.add("doubles", in.doubles);
  labels.add("motion", in.motion.kind);
  return in;
}

template <int D>
void WarpEnclosures<D>::check(const In& in, Labels& labels) {
  const Surface<D> surface(in.net);
  const std::vector<Sample> samples = surface.samples(in.shares);
  std::vector<WarpEnclosure> found;
  check_enclosure<Rational, D>(in, in.net.knots, in.net.c, in.net.d, surface, samples, found);
  const WarpEnclosure& warp = found.front();
  labels.add("complete", warp.complete ? "yes" : "no");
  labels.add("stage", std::string(name_of(warp.stage)));
  if (in.doubles) {
    const KnotList<double> u = in_doubles(in.net.knots);
    const Row<double, D> c = in_doubles<D>(in.net.c);
    const Row<double, D> d = in_doubles<D>(in.net.d);
    check_enclosure<double, D>(in, u, c, d, surface, samples, found);
    check_limit<double, D>(in, u, c, d, found.front(), samples, in.limit);
  }
  if (in.motion.kind != "identity") {
    const Row<Rational, D> c = moved<D>(in.motion, in.net.c);
    const Row<Rational, D> d = moved<D>(in.motion, in.net.d);
    check_enclosure<Rational, D>(in, in.net.knots, c, d, surface, samples, found);
  }
  check_overlap(found);
  const Rational upper = Rational::from_double(found.front().upper);
  for (const Rational& limit : {in.limit, upper}) {
    const Truth within = check_limit<Rational, D>(in, in.net.knots, in.net.c, in.net.d, found.front(), samples, limit);
    labels.add("within", within == Truth::yes ? "yes" : within == Truth::no ? "no" : "unknown");
  }
  check_pieces(in.net, samples, surface, labels);
}

template struct WarpEnclosures<3>;
template struct WarpEnclosures<4>;

}  // namespace torse::fuzz
