#include "torse/fuzz/properties/strip_folds.hpp"

#include <algorithm>
#include <array>

#include "torse/exact/quasi/folds.hpp"
#include "torse/fuzz/plain/sturm.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

using In = StripFolds::In;
using Q = Rational;
using PolyVector = std::array<plain::Poly, 3>;

plain::Poly minus(const plain::Poly& f, const plain::Poly& g) { return plain::plus(f, plain::scaled(Q(-1), g)); }

PolyVector product(const PolyVector& x, const PolyVector& y) {
  PolyVector z;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    z[i] = minus(plain::times(x[j], y[k]), plain::times(x[k], y[j]));
  }
  return z;
}

/// y_0 x - x_0 y without coordinate 0: by the quotient rule (x_0^2 times) the velocity of the point of x for y = x',
/// and (x_0 y_0 times, the other way round) the way from the point of x to that of y.
PolyVector wedge(const plain::PolyRow<4>& x, const plain::PolyRow<4>& y) {
  PolyVector z;
  for (std::size_t i = 0; i < 3; ++i) z[i] = minus(plain::times(x[0], y[i + 1]), plain::times(y[0], x[i + 1]));
  return z;
}

/// m . n times w^4 omega^4, for the normals at both ends of the ruling.
plain::Poly product_of_normals(const plain::PolyRow<4>& p, const plain::PolyRow<4>& q) {
  const PolyVector ruling = wedge(p, q);
  const PolyVector m = product(wedge(p, plain::derivative<4>(p)), ruling);
  const PolyVector n = product(wedge(q, plain::derivative<4>(q)), ruling);
  plain::Poly sum;
  for (std::size_t i = 0; i < 3; ++i) sum = plain::plus(sum, plain::times(m[i], n[i]));
  return sum;
}

std::vector<Vec<Q, 3>> points_of(const std::vector<Row4>& row) {
  std::vector<Vec<Q, 3>> points;
  for (const Row4& x : row) points.push_back({x[1], x[2], x[3]});
  return points;
}

std::optional<RulingPlace> fold_of(const In& in) {
  if (!in.polynomial) return find_fold<4>(in.net.knots, in.net.c, in.net.d);
  const std::vector<Vec<Q, 3>> c = points_of(in.net.c);
  const std::vector<Vec<Q, 3>> d = points_of(in.net.d);
  return find_fold<3>(in.net.knots, c, d);
}

}  // namespace

const PropertyInfo& StripFolds::info() {
  static const PropertyInfo info{"strip.folds",
                                 "a strip folds over where Sturm's theorem says that the product of its normals is "
                                 "negative somewhere, and at the ruling that is named",
                                 4,
                                 {"folded=yes", "folded=no", "polynomial=0", "polynomial=1", "half=right"}};
  return info;
}

StripFolds::In StripFolds::draw(Choices& choices, const Scale& scale, Labels& labels) {
  Scale small = lean(scale, 24);
  small.degree = 2;
  small.pieces = std::min(scale.pieces, 2);
  In in;
  in.polynomial = !choices.once_in(3);
  if (in.polynomial) {
    in.net = with_weights(draw_net(choices, small));
  } else {
    in.net = draw_rational_net(choices, small);
    for (std::vector<Row4>* row : {&in.net.c, &in.net.d}) {
      for (Row4& x : *row) {
        if (x[0].sign() < 0) x = Row4(-x);
      }
    }
  }
  if (in.net.knots.degree() > 2) throw Discard("products of high degree");
  labels.add("polynomial", in.polynomial ? 1 : 0);
  return in;
}

void StripFolds::check(const In& in, Labels& labels) {
  const plain::Strip strip = plain::strip_of(in.net.knots, in.net.c, in.net.d);
  const std::vector<int> numbers = in.net.knots.proper_pieces();
  const std::optional<RulingPlace> fold = fold_of(in);
  std::vector<plain::Poly> products;
  bool folded = false;
  for (std::size_t j = 0; j < strip.p.rows.size(); ++j) {
    products.push_back(product_of_normals(strip.p.rows[j], strip.q.rows[j]));
    const Q& begin = strip.p.breaks[j];
    const Q& end = strip.p.breaks[j + 1];
    folded = folded || plain::negative_inside(products[j], begin, end).has_value();
  }
  labels.add("folded", folded ? "yes" : "no");
  require(fold.has_value() == folded, "a fold too many or too few");
  if (!fold) return;
  const auto [piece, t] = *fold;
  const auto place = std::ranges::find(numbers, piece);
  require(place != numbers.end(), "a fold in a piece that is none");
  const std::size_t j = static_cast<std::size_t>(place - numbers.begin());
  require(strip.p.breaks[j] <= t && t <= strip.p.breaks[j + 1], "a fold outside its piece");
  require(plain::value(products[j], t).sign() < 0, "no fold where one is said to be");
  labels.add("half", t + t > strip.p.breaks[j] + strip.p.breaks[j + 1] ? "right" : "left");
}

}  // namespace torse::fuzz
