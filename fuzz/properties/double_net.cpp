#include "torse/fuzz/properties/double_net.hpp"

#include <cmath>
#include <vector>

#include "torse/developable/condition.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/properties/lifted.hpp"

namespace torse::fuzz {
namespace {

template <class S>
using Row = std::vector<Vec<S, 3>>;

template <class S>
KnotList<S> knots_of(const DoubleNet& net) {
  return lift_knots<S>(net.degree, net.knots);
}

template <class S>
Row<S> second_row(const DoubleNet& net, const KnotList<S>& u, const Row<S>& c) {
  return linear_net<S, Vec<S, 3>>(u, c, lift<S>(net.lambda), lift<S>(net.m), lift_point<S, 3>(net.d0));
}

template <class S>
S determinant(const KnotList<S>& u, const Row<S>& c, const Row<S>& d, const DoubleNetProperty::In& in) {
  const S begin = u.piece_begin(in.piece);
  return pointwise_determinant<S>(u, c, d, in.piece, begin + (u.piece_end(in.piece) - begin) * lift<S>(in.share));
}

/// The exact net has its vertices within the bounds of the computed one and is developable.
void check_exactly(const DoubleNet& net, const Row<RunningError>& computed) {
  const auto u = knots_of<Rational>(net);
  const Row<Rational> c = lift_row<Rational, 3>(net.c);
  const Row<Rational> d = second_row<Rational>(net, u, c);
  require_within<3>(computed, d);
  require(!find_witness<Rational, 3>(u, c, d), "the exact net is not developable");
}

/// The net with one coordinate moved, as the exact surface that its doubles are.
void check_moved(const DoubleNetProperty::In& in, Row<double> d, Labels& labels) {
  double& x = d[static_cast<std::size_t>(in.moved / 3)][in.moved % 3];
  x += in.shift * (x == 0 ? 1 : std::abs(x));
  if (!std::isfinite(x)) return;
  const auto u = knots_of<RunningError>(in.net);
  const auto det = determinant<RunningError>(u, lift_row<RunningError, 3>(in.net.c), lift_row<RunningError, 3>(d), in);
  const bool refuted = is_zero(det) == Truth::no;
  labels.add("moved", refuted ? "refuted by the bound" : "decided exactly");
  if (refuted && !in.exact) return;
  const auto exact = knots_of<Rational>(in.net);
  const Row<Rational> c = lift_row<Rational, 3>(in.net.c);
  const Row<Rational> q = lift_row<Rational, 3>(d);
  const bool developable = !find_witness_over_q<3>(exact, c, q);
  require(!refuted || !developable, "a determinant whose bound excludes zero, of a developable net");
  require(!developable || is_zero(determinant<Rational>(exact, c, q, in)) == Truth::yes,
          "a determinant that is not zero, of a developable net");
}

}  // namespace

const PropertyInfo& DoubleNetProperty::info() {
  static const PropertyInfo info{
      "double.net",
      "FJ07.13 in doubles is developable within its running error; a moved vertex is told from it",
      1000,
      {"M=generic", "M=near a knot", "M=huge", "M=a knot", "knots=uniform", "knots=unlike", "knots=repeated",
       "verdict=within the bound", "moved=refuted by the bound", "moved=decided exactly"}};
  return info;
}

DoubleNetProperty::In DoubleNetProperty::draw_sized(Choices& choices, int degree, int last, Labels& labels) {
  In in;
  in.net = draw_double_net(choices, degree, last, labels);
  const KnotList<double> u(degree, in.net.knots);
  const std::vector<int> pieces = u.proper_pieces();
  in.piece = pieces[choices.below(pieces.size())];
  in.share = static_cast<double>(1 + choices.below(1023)) * 0x1p-10;
  if (choices.once_in(2)) {
    in.moved = 3 * (in.piece - 1 + choices.between(0, degree));  // a vertex of the piece
    in.moved += choices.between(0, 2);
    in.shift = std::ldexp(1, -choices.between(0, 60));
  }
  in.exact = choices.once_in(512);
  return in;
}

DoubleNetProperty::In DoubleNetProperty::draw(Choices& choices, const Scale& scale, Labels& labels) {
  if (choices.once_in(2)) return draw_sized(choices, 3, 10, labels);
  const int degree = choices.between(1, scale.degree);
  return draw_sized(choices, degree, degree + choices.between(0, scale.pieces), labels);
}

void DoubleNetProperty::check(const In& in, Labels& labels) {
  const auto u = knots_of<RunningError>(in.net);
  if (std::find(in.net.knots.begin(), in.net.knots.end(), in.net.m) != in.net.knots.end()) {
    try {
      second_row<double>(in.net, knots_of<double>(in.net), in.net.c);
    } catch (const InvalidInput& error) {
      return require(error.place() == "M", "M* at a knot is reported elsewhere");
    }
    throw Failed("M* at a knot is not refused");
  }
  const Row<RunningError> c = lift_row<RunningError, 3>(in.net.c);
  const Row<RunningError> d = second_row<RunningError>(in.net, u, c);
  const Row<double> rounded = second_row<double>(in.net, knots_of<double>(in.net), in.net.c);
  require_same<3>(d, rounded);
  if (!all_known<3>(d)) return labels.add("verdict", "beyond the range of doubles");
  if (in.moved >= 0) return check_moved(in, rounded, labels);
  labels.add("verdict", "within the bound");
  const bool suspect = is_zero(determinant<RunningError>(u, c, d, in)) == Truth::no;
  if (suspect || in.exact) check_exactly(in.net, d);
  require(!suspect, "a determinant whose bound excludes zero, though the exact one is zero");
}

}  // namespace torse::fuzz
