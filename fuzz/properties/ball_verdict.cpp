#include "torse/fuzz/properties/ball_verdict.hpp"

#include <cmath>
#include <limits>

#include "torse/developable/condition.hpp"
#include "torse/exact/ball/ball.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/plain/determinant.hpp"
#include "torse/scalar/interval.hpp"

namespace torse::fuzz {
namespace {

using Wide = Ball<128>;

/// The two doubles around a number.
Interval interval_of(const Rational& x) {
  const double nearest = x.to_double();
  if (std::isinf(nearest)) throw Discard("beyond the range of doubles");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rational rounded = Rational::from_double(nearest);
  return Interval::hull(x < rounded ? std::nextafter(nearest, -infinity) : nearest,
                        rounded < x ? std::nextafter(nearest, infinity) : nearest);
}

template <class S>
S lifted(const Rational& x) {
  if constexpr (std::same_as<S, Interval>) {
    return interval_of(x);
  } else {
    return S::rational(x.text());
  }
}

bool contains(const Wide& x, const Rational& y) { return x.contains(y.text()); }
bool contains(const Interval& x, const Rational& y) {
  return (std::isinf(x.lower()) || Rational::from_double(x.lower()) <= y) &&
         (std::isinf(x.upper()) || y <= Rational::from_double(x.upper()));
}

template <class S>
std::vector<Vec<S, 4>> lifted_row(const std::vector<Row4>& row) {
  std::vector<Vec<S, 4>> result(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (int j = 0; j < 4; ++j) result[i][j] = lifted<S>(row[i][j]);
  }
  return result;
}

/// A determinant of balls contains the exact one, whatever else they contain; a witness is one.
template <class S>
const char* verdict_of(const Net<4>& net) {
  std::vector<S> list;
  for (const Rational& x : net.knots.list()) list.push_back(lifted<S>(x));
  const KnotList<S> u(net.knots.degree(), std::move(list));
  const std::vector<Vec<S, 4>> c = lifted_row<S>(net.c);
  const std::vector<Vec<S, 4>> d = lifted_row<S>(net.d);
  const plain::Strip strip = plain::strip_of(net.knots, net.c, net.d);
  const int n = net.knots.degree();
  const std::vector<int> pieces = net.knots.proper_pieces();
  for (std::size_t j = 0; j < pieces.size(); ++j) {
    const BinaryForm<S> det =
        span_determinant<S>(u, std::span<const Vec<S, 4>>(c), std::span<const Vec<S, 4>>(d), pieces[j]);
    const auto exact = plain::bernstein_coefficients(plain::twist_polynomial(strip, static_cast<int>(j)), 4 * (n - 1));
    for (int i = 0; i <= det.degree(); ++i) {
      const Rational value = Rational(n * n) * exact[static_cast<std::size_t>(i)] * binomial<Rational>(det.degree(), i);
      require(contains(det[i], value), "a coefficient of the determinant is outside its ball");
    }
  }
  try {
    const auto witness = find_witness<S, 4>(u, std::span<const Vec<S, 4>>(c), std::span<const Vec<S, 4>>(d));
    require(witness.has_value() != net.developable, "a verdict that is wrong");
    return witness ? "refuted" : "proved";
  } catch (const Undecided&) {
    return "open";
  }
}

}  // namespace

const PropertyInfo& BallVerdict::info() {
  static const PropertyInfo info{
      "verdict.balls",
      "balls and intervals around a net contain its determinant; where they decide, they "
      "decide what is true",
      6,
      {"ball=refuted", "ball=open", "interval=refuted", "interval=open", "class=none", "class=tangent", "miss=to 20"}};
  return info;
}

BallVerdict::In BallVerdict::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In net = draw_row_net(choices, scale);
  add_net_labels(labels, net);
  return net;
}

void BallVerdict::check(const In& in, Labels& labels) {
  labels.add("ball", verdict_of<Wide>(in));
  labels.add("interval", verdict_of<Interval>(in));
}

}  // namespace torse::fuzz
