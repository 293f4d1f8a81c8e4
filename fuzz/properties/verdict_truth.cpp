#include "torse/fuzz/properties/verdict_truth.hpp"

#include <optional>
#include <vector>

#include "torse/developable/classify.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/plain/determinant.hpp"
#include "torse/fuzz/plain/elimination.hpp"

namespace torse::fuzz {
namespace {

using Witness = DevelopabilityWitness<Rational>;

bool same(const std::optional<Witness>& a, const std::optional<Witness>& b) {
  if (!a || !b) return !a && !b;
  return a->piece == b->piece && a->coefficient == b->coefficient && a->value == b->value;
}

/// The first nonzero Bernstein coefficient by the power expansions. The library's determinant is that of the
/// derivatives by s and t of the forms, n^2 det(p, p', q, q') for homogeneous rows, and of their differences, where n
/// is taken out of the weights' column, for points.
template <int D>
std::optional<Witness> plain_witness(const Net<D>& net) {
  const plain::Strip strip = plain::strip_of(net.knots, net.c, net.d);
  const std::vector<int> pieces = net.knots.proper_pieces();
  const int n = net.knots.degree();
  const Rational factor(D == 4 ? n * n : n);
  for (int j = 0; j < strip.p.count(); ++j) {
    const std::vector<Rational> b = plain::bernstein_coefficients(plain::twist_polynomial(strip, j), D * (n - 1));
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (b[i].sign() != 0) return Witness{pieces[static_cast<std::size_t>(j)], static_cast<int>(i), factor * b[i]};
    }
  }
  return std::nullopt;
}

bool parallel(const Row4& x, const Row4& y) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (x[i] * y[j] != x[j] * y[i]) return false;
    }
  }
  return true;
}

/// Rulings without length and others on one line: no point of that line is distinguished, but the cylinder has its
/// direction.
void check_line(const Net<4>& net, const std::optional<Point3>& direction) {
  const plain::Strip strip = plain::strip_of(net.knots, net.c, net.d);
  bool any = false;
  for (int j = 0; j < strip.p.count(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Rational& begin = strip.p.breaks[at];
    const Rational width = strip.p.breaks[at + 1] - begin;
    for (int i = 0; i <= 2 * net.knots.degree(); ++i) {
      const Rational t = begin + width * Rational(i) / Rational(2 * net.knots.degree());
      const Row4 p = plain::value_at<4>(strip.p.rows[at], t);
      const Row4 q = plain::value_at<4>(strip.q.rows[at], t);
      if (parallel(p, q)) continue;
      any = true;
      if (!direction) break;
      plain::Rows<4> rows;
      rows.insert(p);
      rows.insert(q);
      rows.insert(Row4(Rational(), (*direction)[0], (*direction)[1], (*direction)[2]));
      require(rows.rank() == 2, "a ruling has another direction");
    }
  }
  require(any == direction.has_value(), "a direction is missing or too much");
}

/// Vertex or direction are the point common to all rulings, if there is only one.
void check_common(const Net<4>& net, const Classification<Rational>& found) {
  const bool cone = found.kind == SurfaceClass::cone;
  const bool cylinder = found.kind == SurfaceClass::cylinder;
  require(found.vertex.has_value() == cone, "a cone without a vertex, or a vertex of something else");
  require(cylinder || !found.direction, "a direction of something else than a cylinder");
  if (cylinder && !net.common) return check_line(net, found.direction);
  if (!cone && !cylinder) return;
  require(cone || found.direction.has_value(), "a cylinder without a direction");
  const Point3& x = cone ? *found.vertex : *found.direction;
  require(parallel(*net.common, Row4(Rational(cone ? 1 : 0), x[0], x[1], x[2])), "not the point on all rulings");
  int first = 0;
  while (cylinder && x[first].sign() == 0) ++first;
  require(cone || x[first] == Rational(1), "the first coordinate of the direction is not 1");
}

void check_class(const Net<4>& net) {
  const Classification<Rational> found = classify<Rational>(net.knots, net.c, net.d);
  require(name_of(found.kind) == net.klass, "another class");
  check_common(net, found);
}

/// Moves the last point of d, so that the determinant of the last piece begins with coefficients 0.
template <int D>
void move_last(Choices& choices, Net<D>& net) {
  Net<D> moved{.knots = net.knots, .c = net.c, .d = net.d, .developable = false, .klass = "none", .made = "moved last"};
  moved.d.back()[D - 1 - choices.between(0, 2)] += Rational(1);
  if (!plain::holds_by_samples(plain::strip_of(moved.knots, moved.c, moved.d))) net = std::move(moved);
}

Net<4> in_rows(const Net<3>& net) { return with_weights(net); }
const Net<4>& in_rows(const Net<4>& net) { return net; }

}  // namespace

template <>
const PropertyInfo& VerdictTruth<3>::info() {
  static const PropertyInfo info{
      "verdict.truth",
      "polynomial nets: the slow and the fast exact decision and both forms of the determinant say what is true by "
      "construction, the witness is the first nonzero Bernstein coefficient with its value, and the class, vertex and "
      "direction are the true ones",
      10,
      {"class=plane", "class=cylinder", "class=cone", "class=tangent", "class=none", "miss=to 20", "witness=0",
       "witness=2"}};
  return info;
}

template <>
const PropertyInfo& VerdictTruth<4>::info() {
  static const PropertyInfo info{"verdict.rational_truth",
                                 "the same of homogeneous rows with any weights",
                                 4,
                                 {"class=plane", "class=cylinder", "class=cone", "class=tangent", "class=none",
                                  "miss=to 20", "witness=0", "witness=2"}};
  return info;
}

template <int D>
typename VerdictTruth<D>::In VerdictTruth<D>::draw(Choices& choices, const Scale& scale, Labels& labels) {
  constexpr int tries = 6;
  const auto draw_any = [&] {
    if constexpr (D == 3) {
      return draw_net(choices, scale);
    } else {
      return draw_row_net(choices, scale);
    }
  };
  In net = draw_any();
  if (choices.once_in(5)) {
    for (int i = 0; i < tries && (net.klass != "tangent" || net.knots.degree() < 3); ++i) net = draw_any();
    if (net.developable) move_last(choices, net);
  }
  add_net_labels(labels, net);
  return net;
}

template <int D>
void VerdictTruth<D>::check(const In& net, Labels& labels) {
  const std::optional<Witness> truth = plain_witness(net);
  if (truth) labels.add("witness", truth->coefficient < 2 ? truth->coefficient : 2);
  require(truth.has_value() != net.developable, "the determinant contradicts the construction");
  require(same(find_witness<Rational, D>(net.knots, net.c, net.d), truth), "find_witness is wrong");
  require(same(find_witness_over_q<D>(net.knots, net.c, net.d), truth), "find_witness_over_q is wrong");
  const Net<4> rows = in_rows(net);
  require(find_witness_over_q<4>(rows.knots, rows.c, rows.d).has_value() != net.developable,
          "the verdict on homogeneous rows is wrong");
  if (net.developable) check_class(rows);
}

template struct VerdictTruth<3>;
template struct VerdictTruth<4>;

}  // namespace torse::fuzz
