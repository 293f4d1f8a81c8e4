#include "torse/fuzz/properties/joined_rails.hpp"

#include "torse/developable/condition.hpp"
#include "torse/fuzz/plain/rewriting.hpp"
#include "torse/fuzz/plain/truth.hpp"
#include "torse/spline/compatible.hpp"

namespace torse::fuzz {
namespace {

/// The values of a rail at a parameter of [0, 1], by its polynomials.
Row4 value_of(const plain::Pieces<4>& curve, const Rational& s) {
  const Rational t = curve.breaks.front() + s * (curve.breaks.back() - curve.breaks.front());
  std::size_t j = 0;
  while (j + 1 < curve.rows.size() && curve.breaks[j + 1] <= t) ++j;
  return plain::value_at<4>(curve.rows[j], t);
}

/// Equal at more parameters of each piece than the degree.
void require_same_curve(const Rail& rail, const Spline<Rational, Row4>& curve) {
  const plain::Pieces<4> before = plain::pieces_of<4>(rail.knots, rail.rows);
  const plain::Pieces<4> after = plain::pieces_of<4>(curve.knots, curve.control);
  const Rational begin = after.breaks.front();
  const Rational length = after.breaks.back() - begin;
  const int samples = curve.knots.degree() + 1;
  for (std::size_t j = 0; j < after.rows.size(); ++j) {
    for (int i = 0; i < samples; ++i) {
      const Rational part = Rational(i) / Rational(samples);
      const Rational t = after.breaks[j] + part * (after.breaks[j + 1] - after.breaks[j]);
      const Rational s = (t - begin) / length;
      require(value_of(before, s) == value_of(after, s), "a rail is another curve");
    }
  }
}

}  // namespace

const PropertyInfo& JoinedRails::info() {
  static const PropertyInfo info{
      "rails",
      "rails of different degrees and knots become rows over one knot list, as developable as the net they are from",
      4,
      {"degrees=equal", "degrees=different", "net=none", "net=developable", "net=twisted"}};
  return info;
}

JoinedRails::In JoinedRails::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in = draw_rails(choices, scale);
  labels.add("degrees", in.c.knots.degree() == in.d.knots.degree() ? "equal" : "different");
  labels.add("net", !in.net ? "none" : in.net->developable ? "developable" : "twisted");
  return in;
}

void JoinedRails::check(const In& in, Labels&) {
  const auto [c, d] = make_compatible(as_spline(in.c), as_spline(in.d));
  require(c.knots.degree() == d.knots.degree() && c.knots.list() == d.knots.list(), "not the same knots");
  require_same_curve(in.c, c);
  require_same_curve(in.d, d);
  const bool developable = !find_witness<Rational, 4>(c.knots, c.points(), d.points());
  require(developable == !plain::refuted(plain::strip_of(c.knots, c.control, d.control), 4 * c.knots.degree() + 1),
          "another verdict than by samples");
  require(!in.net || developable == in.net->developable, "another verdict than that of the net");
}

}  // namespace torse::fuzz
