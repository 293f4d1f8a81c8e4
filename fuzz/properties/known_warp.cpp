#include "torse/fuzz/properties/known_warp.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "torse/exact/warp/max_warp.hpp"
#include "torse/exact/warp/piece_bounds.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/angle.hpp"

namespace torse::fuzz {
namespace {

struct Net3 {
  KnotList<Rational> u;
  std::vector<Point3> c;
  std::vector<Point3> d;
};

Net3 net_of(const KnownWarp::In& in) {
  Net3 net{KnotList<Rational>(1, in.knots), {}, {}};
  for (const Rational& t : in.knots) {
    net.c.push_back(in.motion(Point3(t, Rational(), Rational())));
    net.d.push_back(in.motion(Point3(t, Rational(1), in.h * t)));
  }
  return net;
}

/// The largest sin^2 between two parameters: the nearer to 0, the larger.
Rational largest(const Rational& h, const Rational& from, const Rational& to) {
  Rational t;
  if (from.sign() > 0) t = from;
  if (to.sign() < 0) t = to;
  const Rational square = h * h;
  return square / (Rational(1) + square + square * t * t);
}

/// sin^2 of the limits for which it is a rational number.
std::optional<Rational> exact_limit(const Rational& degrees) {
  if (degrees == Rational(0)) return Rational(0);
  if (degrees == Rational(30)) return Rational(1) / Rational(4);
  if (degrees == Rational(45)) return Rational(1) / Rational(2);
  if (degrees == Rational(60)) return Rational(3) / Rational(4);
  if (degrees >= Rational(90)) return Rational(1);
  return std::nullopt;
}

void check_enclosure(const Net3& net, const Rational& sine) {
  const WarpEnclosure warp = max_warp<Rational, 3>(net.u, net.c, net.d);
  require(warp.complete, "an enclosure that is not complete");
  require(plain::sine_squared_below(Rational::from_double(warp.lower)) <= sine, "the lower bound is too high");
  require(sine <= plain::sine_squared_above(Rational::from_double(warp.upper)), "the upper bound is too low");
  require(warp.upper - warp.lower <= WarpOptions{}.tolerance * warp.upper, "the bounds are wider than promised");
}

void check_pieces(const Net3& net, const KnownWarp::In& in, Labels& labels) {
  const std::optional<RoundedNet<3>> rounded = rounded_net<3>(net.u, net.c, net.d);
  if (!rounded) return;
  const std::vector<PieceBound> bounds = piece_bounds(*rounded, net.u.proper_pieces());
  require(bounds.size() + 1 == in.knots.size(), "another number of bounds than of pieces");
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    labels.add("piece bound", std::isfinite(bounds[i].upper) ? "finite" : "infinite");
    require(Rational::from_double(bounds[i].at_begin) <= largest(in.h, in.knots[i], in.knots[i]) &&
                Rational::from_double(bounds[i].at_end) <= largest(in.h, in.knots[i + 1], in.knots[i + 1]),
            "a lower bound at the end of a piece is too high");
    require(!std::isfinite(bounds[i].upper) ||
                largest(in.h, in.knots[i], in.knots[i + 1]) <= Rational::from_double(bounds[i].upper),
            "the upper bound of a piece is too low");
  }
}

void check_limit(const Net3& net, const Rational& sine, const Rational& limit, Labels& labels) {
  const Truth within = warp_at_most<Rational, 3>(net.u, net.c, net.d, Angle{limit});
  labels.add("within", within == Truth::yes ? "yes" : within == Truth::no ? "no" : "unknown");
  if (const std::optional<Rational> exact = exact_limit(limit)) {
    if (sine == *exact) labels.add("limit", "attained");
    return require(within == truth(sine <= *exact), "a limit is not decided as it is");
  }
  require(within != Truth::yes || sine <= plain::sine_squared_above(limit), "within a limit that is exceeded");
  require(within != Truth::no || sine >= plain::sine_squared_below(limit), "beyond a limit that is not exceeded");
}

}  // namespace

const PropertyInfo& KnownWarp::info() {
  static const PropertyInfo info{
      "enclosure.known",
      "the enclosure of the warp angle of a hyperbolic paraboloid, tiny or not, contains the exact value and is as "
      "narrow as promised; the bounds of its pieces hold; limits of 0, 30, 45, 60 and 90 degrees are decided",
      30,
      {"h=near a limit", "h=tiny", "h=other", "piece bound=finite", "within=yes", "within=no", "limit=attained"}};
  return info;
}

KnownWarp::In KnownWarp::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in;
  const std::uint64_t kind = choices.below(4);
  // Near 45, 60 and 30 degrees, 45 itself among them.
  if (kind == 0) {
    in.h = Rational(1) + Rational(choices.pick({0, 6, 8, 9})) / Rational(12);
    if (choices.once_in(3)) in.h = Rational(choices.pick({7, 6})) / Rational(12);
  }
  if (kind == 1) in.h = power_of_two(-choices.between(1, 700));
  if (kind >= 2) in.h = draw_nonzero(choices, scale);
  labels.add("h", kind == 0 ? "near a limit" : kind == 1 ? "tiny" : "other");
  Rational t = choices.once_in(2) ? draw_fraction(choices, 3) : Rational();
  in.knots = {t};
  for (int i = choices.between(1, scale.pieces + 2); i > 0; --i) {
    const Rational above(choices.between(1, 8));
    t += above / Rational(choices.between(1, 16));
    in.knots.push_back(t);
  }
  in.motion = choices.once_in(2) ? draw_similarity(choices, scale) : identity_map();
  in.limit =
      choices.once_in(4) ? power_of_two(-choices.between(0, 700)) : Rational(choices.pick({45, 30, 60, 0, 90, 1}));
  return in;
}

void KnownWarp::check(const In& in, Labels& labels) {
  const Net3 net = net_of(in);
  const Rational sine = largest(in.h, in.knots.front(), in.knots.back());
  check_enclosure(net, sine);
  check_pieces(net, in, labels);
  check_limit(net, sine, in.limit, labels);
}

}  // namespace torse::fuzz
