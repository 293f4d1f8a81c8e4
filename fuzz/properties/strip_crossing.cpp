#include "torse/fuzz/properties/strip_crossing.hpp"

#include <algorithm>
#include <string>

#include "torse/exact/quasi/self_intersection.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz {
namespace {

using In = StripCrossing::In;
using Q = Rational;

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
                                 2,
                                 {"cannot=no", "crosses=yes"},
                                 {"cannot=no", "crosses=yes"}};
  return info;
}

StripCrossing::In StripCrossing::draw(Choices& choices, const Scale& scale, Labels&) {
  Scale small = scale;
  small.degree = std::min(scale.degree, 3);
  small.pieces = std::min(scale.pieces, 3);
  In in{.knots = draw_knots(choices, small)};
  if (!told_apart(in.knots)) throw Discard("knots that doubles hardly tell apart");
  in.crosses = choices.once_in(2);
  const int count = in.knots.last() + 1;
  in.c = draw_row(choices, count, 0, !in.crosses);
  in.d = draw_row(choices, count, choices.between(1, 9), !in.crosses);
  if (in.crosses) make_cross(choices, in);
  return in;
}

void StripCrossing::check(const In& in, Labels& labels) {
  const SelfIntersection verdict = find_self_intersection<3>(in.knots, in.c, in.d, 2000);
  const std::string answer = verdict.crosses == Truth::yes ? "yes" : verdict.crosses == Truth::no ? "no" : "unknown";
  labels.add(in.crosses ? "crosses" : "cannot", answer);
  require(answer != (in.crosses ? "no" : "yes"), "rulings cross or do not, and the opposite is said");
  require(verdict.witness.has_value() == (verdict.crosses == Truth::yes), "a witness too many or too few");
  if (verdict.witness) check_witness(in, *verdict.witness);
}

}  // namespace torse::fuzz
