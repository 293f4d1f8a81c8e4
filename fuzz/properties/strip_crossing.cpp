#include "torse/fuzz/properties/strip_crossing.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "torse/exact/quasi/self_intersection.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz {
namespace {

using In = StripCrossing::In;
using Q = Rational;

struct Kind {
  std::string_view name;
  bool crosses;
};

constexpr std::array kinds{
    Kind{"onward", false},    // rails that go on in one direction
    Kind{"crossing", true},   // two rulings with a common point
    Kind{"tangents", false},  // tangents of a curve on one side of it
    Kind{"slide", true},      // a piece along its ruling
    Kind{"fold", true},       // tangents of a plane curve on both sides of it
    Kind{"edge", false},      // tangents of a twisted curve on both sides of it
};

const Kind& kind_of(const In& in) {
  const auto* const kind = std::ranges::find(kinds, in.kind, &Kind::name);
  require(kind != kinds.end(), "a kind of strips that there is not");
  return *kind;
}

/// Points that go on and on in the direction of x over one plane y = height, or along any curve.
std::vector<Point3> draw_row(Choices& choices, int count, int height, bool onward) {
  std::vector<Point3> row;
  int x = 0;
  for (int i = 0; i < count; ++i) {
    x = onward ? x + choices.between(1, 12) : choices.between(-8, 8);
    row.push_back({Q(x), Q(height), Q(choices.between(-8, 8))});
  }
  return row;
}

std::size_t piece_of(const std::vector<Q>& breaks, const Q& t) {
  std::size_t j = 0;
  while (j + 2 < breaks.size() && breaks[j + 1] <= t) ++j;
  return j;
}

/// The point at a share of the ruling of t.
Point3 point_at(const In& in, const Q& t, const Q& share) {
  const plain::Pieces<3> c = plain::pieces_of<3>(in.knots, in.c);
  const plain::Pieces<3> d = plain::pieces_of<3>(in.knots, in.d);
  const std::size_t j = piece_of(c.breaks, t);
  const Point3 x = plain::value_at<3>(c.rows[j], t);
  const Point3 y = plain::value_at<3>(d.rows[j], t);
  Point3 z;
  for (int i = 0; i < 3; ++i) z[i] = (Q(1) - share) * x[i] + share * y[i];
  return z;
}

/// Moves one control point of c so that the rulings of two parameters have a point between the rails in common.
void make_cross(Choices& choices, In& in) {
  const auto parameter = [&](int eighths) {
    return in.knots.domain_begin() + Q(eighths) / Q(8) * (in.knots.domain_end() - in.knots.domain_begin());
  };
  const Q first = parameter(choices.between(0, 3));
  const Q second = parameter(choices.between(5, 8));
  // Inside both rulings: neighbours may share a point of a rail.
  const Q first_share = Q(choices.between(1, 3)) / Q(4);
  const Q second_share = Q(choices.between(1, 3)) / Q(4);
  const std::size_t moved = static_cast<std::size_t>(choices.between(0, in.knots.last()));
  In unit = in;
  std::ranges::fill(unit.c, Point3(Q(0), Q(0), Q(0)));
  std::ranges::fill(unit.d, Point3(Q(0), Q(0), Q(0)));
  unit.c[moved] = {Q(1), Q(0), Q(0)};
  const Q influence = point_at(unit, first, first_share)[0] - point_at(unit, second, second_share)[0];
  if (influence.sign() == 0) throw Discard("a point that moves neither ruling, or both alike");
  const Point3 x = point_at(in, first, first_share);
  const Point3 y = point_at(in, second, second_share);
  for (int i = 0; i < 3; ++i) in.c[moved][i] += (y[i] - x[i]) / influence;
}

/// One piece slides along its ruling: all of its rulings have half of one segment in common.
void make_slide(Choices& choices, In& in) {
  const std::vector<int> pieces = in.knots.proper_pieces();
  const int piece = pieces[choices.below(pieces.size())];
  const std::size_t begin = static_cast<std::size_t>(piece - 1);
  const std::size_t end = begin + static_cast<std::size_t>(in.knots.degree());
  const Point3 start = in.c[begin];
  const Point3 way = in.d[begin] - start;
  for (std::size_t i = begin; i <= end; ++i) {
    const int place = i == begin ? -1 : i == end ? 1 : choices.between(-1, 1);
    in.c[i] = start + Q(place) / Q(4) * way;
    in.d[i] = start + Q(4 + choices.between(-1, 1)) / Q(4) * way;
  }
}

/// A curve over the parabola (s, s^2), s in [0, 1] on the domain, and its tangents from `behind` to `ahead` of it.
/// Those of two parameters, seen from above, meet ahead of the first and behind the second, halfway between.
void make_tangents(In& in, const std::array<Q, 3>& height, const Q& behind, const Q& ahead) {
  const Q begin = in.knots.domain_begin();
  const Q length = in.knots.domain_end() - begin;
  const plain::Poly s{Q(-begin / length), Q(Q(1) / length)};
  const plain::Poly square = plain::times(s, s);
  const plain::Poly cube = plain::times(square, s);
  const plain::Poly over = plain::plus(plain::plus(plain::scaled(height[0], s), plain::scaled(height[1], square)),
                                       plain::scaled(height[2], cube));
  const plain::PolyRow<3> edge{s, square, height[2].sign() == 0 ? plain::Poly(over.begin(), over.begin() + 3) : over};
  const auto moved = [&](const Q& share) {
    const plain::PolyRow<3> slope = plain::derivative<3>(edge);
    plain::Pieces<3> curve{.breaks = plain::breaks_of(in.knots), .rows = {}};
    plain::PolyRow<3> row;
    for (std::size_t j = 0; j < 3; ++j) row[j] = plain::plus(edge[j], plain::scaled(share * length, slope[j]));
    curve.rows.assign(curve.breaks.size() - 1, row);
    return plain::control_row<3>(curve, in.knots);
  };
  in.c = moved(-behind);
  in.d = moved(ahead);
}

/// The same strip on other axes, perhaps from its other rail.
void lean(Choices& choices, In& in) {
  const std::array<Q, 3> by{Q(choices.between(-2, 2)), Q(choices.between(-2, 2)), Q(choices.between(-2, 2))};
  const bool turned = choices.once_in(2);
  if (choices.once_in(2)) std::swap(in.c, in.d);
  for (std::vector<Point3>* row : {&in.c, &in.d}) {
    for (Point3& p : *row) {
      p[0] += by[0] * p[1] + by[1] * p[2];
      p[1] += by[2] * p[2];
      if (turned) p = {p[2], p[0], p[1]};
    }
  }
}

/// Every piece is long enough for parameters in doubles, in which witnesses are.
bool told_apart(const KnotList<Q>& u) {
  const auto magnitude = [](const Q& x) { return x.sign() < 0 ? Q(-x) : x; };
  const Q length = u.domain_end() - u.domain_begin();
  const Q least = power_of_two(-20) * std::max({magnitude(u.domain_begin()), magnitude(u.domain_end()), length});
  return std::ranges::all_of(u.proper_pieces(), [&](int k) { return u.piece_end(k) - u.piece_begin(k) >= least; });
}

void check_witness(const In& in, const RulingCrossing& found) {
  const Q first = Q::from_double(found.first);
  const Q second = Q::from_double(found.second);
  const Q& begin = in.knots.domain_begin();
  const Q& end = in.knots.domain_end();
  require(begin <= first && first <= end && begin <= second && second <= end, "a crossing outside the domain");
  require(first != second, "a ruling that crosses itself");
  const auto share = [](double v) {
    require(0 <= v && v <= 1, "a crossing beyond the rails");
    return Q::from_double(v);
  };
  const Point3 x = point_at(in, first, share(found.first_share));
  const Point3 y = point_at(in, second, share(found.second_share));
  Q size(0);
  for (const std::vector<Point3>* row : {&in.c, &in.d}) {
    for (const Point3& p : *row) {
      for (int i = 0; i < 3; ++i) size = std::max(size, p[i].sign() < 0 ? Q(-p[i]) : p[i]);
    }
  }
  for (int i = 0; i < 3; ++i) {
    const Q gap = x[i] - y[i];
    // The witness is found in doubles; what it says is held against its own distance with some 30 bits of room.
    const Q most = Q::from_double(found.distance) + size * power_of_two(-30);
    require(gap <= most && -gap <= most, "no crossing where one is said to be");
  }
}

}  // namespace

const PropertyInfo& StripCrossing::info() {
  static const PropertyInfo info{"strip.crossing",
                                 "rulings that cross by construction are never said not to, those that cannot are "
                                 "never said to, and the crossing that is named is one",
                                 4,
                                 {"onward=no", "tangents=no", "crossing=yes", "slide=yes", "fold=yes"},
                                 {"onward=no", "tangents=no", "crossing=yes", "slide=yes", "fold=yes"}};
  return info;
}

StripCrossing::In StripCrossing::draw(Choices& choices, const Scale& scale, Labels&) {
  Scale small = scale;
  small.degree = std::min(scale.degree, 3);
  small.pieces = std::min(scale.pieces, 3);
  In in{.knots = draw_knots(choices, small)};
  if (!told_apart(in.knots)) throw Discard("knots that doubles hardly tell apart");
  in.kind = kinds[choices.below(kinds.size())].name;
  const auto some = [&] { return Q(choices.between(1, 8)) / Q(4); };
  if (in.kind == "tangents" || in.kind == "fold" || in.kind == "edge") {
    const int degree = in.knots.degree();
    const bool edge = in.kind == "edge";
    if (degree < (edge ? 3 : 2)) throw Discard("a degree that no such edge of regression has");
    // In a plane tangents meet on both sides; those of a twisted cubic never do.
    const bool twisted = edge || (in.kind == "tangents" && degree == 3);
    const std::array<Q, 3> height{Q(choices.between(-4, 4)), Q(choices.between(-4, 4)), twisted ? some() : Q(0)};
    std::array<Q, 2> reach{some(), some()};
    if (in.kind == "tangents") reach[choices.below(2)] = Q(0);
    make_tangents(in, height, reach[0], reach[1]);
  } else {
    const int count = in.knots.last() + 1;
    const bool onward = in.kind == "onward" || (in.kind == "slide" && choices.once_in(2));
    in.c = draw_row(choices, count, 0, onward);
    in.d = draw_row(choices, count, choices.between(1, 9), onward);
    if (in.kind == "crossing") make_cross(choices, in);
    if (in.kind == "slide") make_slide(choices, in);
  }
  lean(choices, in);
  return in;
}

void StripCrossing::check(const In& in, Labels& labels) {
  const SelfIntersection verdict = find_self_intersection<3>(in.knots, in.c, in.d, 2000);
  const std::string answer = verdict.crosses == Truth::yes ? "yes" : verdict.crosses == Truth::no ? "no" : "unknown";
  const Kind& kind = kind_of(in);
  labels.add(kind.name, answer);
  require(answer != (kind.crosses ? "no" : "yes"), "rulings cross or do not, and the opposite is said");
  require(verdict.witness.has_value() == (verdict.crosses == Truth::yes), "a witness too many or too few");
  if (verdict.witness) check_witness(in, *verdict.witness);
}

}  // namespace torse::fuzz
