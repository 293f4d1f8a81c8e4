#include "torse/fuzz/properties/double_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "torse/developable/closed_forms.hpp"
#include "torse/developable/condition.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/developable/special.hpp"
#include "torse/fuzz/properties/lifted.hpp"
#include "torse/spline/elevation.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::fuzz {
namespace {

template <class S>
using Row = std::vector<Vec<S, 4>>;
template <class S>
using Surface = RuledSpline<S, Vec<S, 4>>;

/// The input in one arithmetic.
template <class S>
struct Lifted {
  KnotList<S> u;
  Row<S> p;
  Vec<S, 4> q0;
  S lambda;
  S m;
  S factor;
};

Vec<double, 4> weighted(double w, const Vec<double, 3>& x) { return {w, w * x[0], w * x[1], w * x[2]}; }

template <class S>
Lifted<S> lifted(const DoubleRows::In& in) {
  std::vector<Vec<double, 4>> rows;
  for (std::size_t i = 0; i < in.net.c.size(); ++i) rows.push_back(weighted(in.weights.at(i), in.net.c[i]));
  return {lift_knots<S>(in.net.degree, in.net.knots),
          lift_row<S, 4>(rows),
          lift_point<S, 4>(weighted(in.weight, in.net.d0)),
          lift<S>(in.net.lambda),
          lift<S>(in.net.m),
          lift<S>(in.factor)};
}

template <class S>
Row<S> linear(const Lifted<S>& in) {
  return linear_net<S, Vec<S, 4>>(in.u, in.p, in.lambda, in.m, in.q0);
}

/// The vertices that a closed form gives one by one.
template <class S, class Form>
Row<S> vertices(const Lifted<S>& in, const Form& form) {
  Row<S> row{in.q0};
  for (int i = 1; i <= in.u.last(); ++i) row.push_back(form(i));
  return row;
}

/// The vertices p_i + r_i where a closed form gives the rulings r_i.
template <class S, class Form>
Row<S> along_rulings(const Lifted<S>& in, const Form& form) {
  return vertices(in, [&](int i) { return sum(in.p[static_cast<std::size_t>(i)], form(i)); });
}

/// Both rows after a transformation of curves.
template <class S, class Transform>
Surface<S> both(const Lifted<S>& in, const Transform& transform) {
  auto p = transform(Spline<S, Vec<S, 4>>(in.u, in.p));
  auto q = transform(Spline<S, Vec<S, 4>>(in.u, linear(in)));
  return {std::move(p.knots), std::move(p.control), std::move(q.control)};
}

constexpr std::array functions{"13",       "7.1",     "14",       "15",     "16",      "cone",
                               "cylinder", "tangent", "restrict", "insert", "elevate", "moebius"};

/// The rows of the function `name`. Functions of one Bezier piece take the first vertices on [0, 1].
template <class S>
Surface<S> apply(std::string_view name, const Lifted<S>& in) {
  using P = Vec<S, 4>;
  const auto with = [&](Row<S> q) { return Surface<S>(in.u, in.p, std::move(q)); };
  const std::span<const P> p = in.p;
  if (name == "13") return with(linear(in));
  if (name == "7.1") return with(rational_net<S, P>(in.u, p, in.lambda, in.m, in.factor, in.q0));
  if (name == "14") return with(vertices(in, [&](int i) { return eq14<S, P>(in.u, p, in.lambda, in.m, in.q0, i); }));
  if (name == "15")
    return with(along_rulings(in, [&](int i) { return eq15<S, P>(in.u, p, in.lambda, in.m, in.q0, i); }));
  if (name == "16")
    return with(along_rulings(in, [&](int i) { return eq16<S, P>(in.u, p, in.lambda, in.m, in.q0, i); }));
  if (name == "cone") return with(cone_net<S, P>(p, in.factor, in.q0));
  if (name == "cylinder") {
    std::vector<S> lengths;
    for (const P& x : in.p) lengths.push_back(x[1] * in.factor);
    return with(cylinder_net<S, P>(p, in.q0, lengths));
  }
  if (name == "restrict") return with(restrict_rulings<S, P>(p, linear(in), in.factor));
  if (name == "insert")
    return both(in, [&](const Spline<S, P>& curve) {
      return insert_knot(curve, in.factor, in.u.proper_pieces().front() + in.u.degree() - 2);
    });
  if (name == "elevate") return both(in, [](const Spline<S, P>& curve) { return elevate(curve); });
  const auto bezier = bezier_knots<S>(in.u.degree());
  const Row<S> first(in.p.begin(), in.p.begin() + in.u.degree() + 1);
  if (name == "tangent") return {bezier, first, tangent_net<S, P>(first)};
  if (name == "moebius") {
    const Row<S> q = linear_net<S, P>(bezier, first, in.lambda, in.m, in.q0);
    return {bezier, moebius_rows<S, P>(first, in.factor), moebius_rows<S, P>(q, in.factor)};
  }
  throw Discard("no such function");
}

bool at_a_knot(const DoubleRows::In& in) {
  const auto& knots = in.net.knots;
  return std::find(knots.begin(), knots.end(), in.net.m) != knots.end() || in.net.m == 0 || in.net.m == 1;
}

}  // namespace

const PropertyInfo& DoubleRows::info() {
  static const PropertyInfo info{
      "double.rows",
      "constructions and transformations in doubles are within their running error, and developable within it",
      12,
      {"function=13", "function=7.1", "function=14", "function=15", "function=16", "function=cone", "function=cylinder",
       "function=tangent", "function=restrict", "function=insert", "function=elevate", "function=moebius",
       "verdict=within the bound", "weights=one", "weights=mixed"}};
  return info;
}

DoubleRows::In DoubleRows::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in;
  in.function = functions[choices.below(functions.size())];
  labels.add("function", in.function);
  const int degree = choices.between(1, scale.degree);
  in.net = draw_double_net(choices, degree, degree + choices.between(0, scale.pieces), labels);
  if (at_a_knot(in)) throw Discard("M* is a knot");
  const bool one = choices.once_in(2);
  labels.add("weights", one ? "one" : "mixed");
  const auto weight = [&] {
    return one ? 1.0 : 0.125 * (1 + static_cast<double>(choices.below(64))) * (choices.once_in(4) ? -1 : 1);
  };
  for (std::size_t i = 0; i < in.net.c.size(); ++i) in.weights.push_back(weight());
  in.weight = weight();
  in.factor = 0.5 + 0.125 * choices.between(0, 31);
  if (in.function == "insert") {
    const KnotList<double> u(degree, in.net.knots);
    const int k = u.proper_pieces().front();
    in.factor = u.piece_begin(k) + 0.5 * (u.piece_end(k) - u.piece_begin(k));
    if (!(u.piece_begin(k) < in.factor && in.factor < u.piece_end(k))) throw Discard("no double between the knots");
  }
  return in;
}

void DoubleRows::check(const In& in, Labels& labels) {
  const auto surface = apply<RunningError>(in.function, lifted<RunningError>(in));
  const auto rounded = apply<double>(in.function, lifted<double>(in));
  require_same<4>(surface.c, rounded.c);
  require_same<4>(surface.d, rounded.d);
  if (!all_known<4>(surface.c) || !all_known<4>(surface.d)) return labels.add("verdict", "beyond the range of doubles");
  labels.add("verdict", "within the bound");
  const auto exact = apply<Rational>(in.function, lifted<Rational>(in));
  require_within<4>(surface.c, exact.c);
  require_within<4>(surface.d, exact.d);
  require(!find_witness<Rational, 4>(exact.knots, exact.c_row(), exact.d_row()),
          "the exact surface is not developable");
  for (const int k : surface.knots.proper_pieces()) {
    const BinaryForm<RunningError> det =
        span_determinant<RunningError>(surface.knots, surface.c_row(), surface.d_row(), k);
    require(!det.first_nonzero(), "a determinant whose bound excludes zero, though the exact one is zero");
  }
}

}  // namespace torse::fuzz
