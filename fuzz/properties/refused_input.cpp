#include "torse/fuzz/properties/refused_input.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "torse/developable/cells.hpp"
#include "torse/developable/directrix_nets.hpp"
#include "torse/developable/interpolation.hpp"
#include "torse/developable/piece_functions.hpp"
#include "torse/developable/pieces.hpp"
#include "torse/developable/regression.hpp"
#include "torse/developable/special.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/elimination.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

using In = RefusedInput::In;
using Q = Rational;
/// The start of the place that an error is to name, or nothing where there is to be none.
using Place = std::optional<std::string>;

bool contains(const std::vector<Q>& list, const Q& x) { return std::ranges::find(list, x) != list.end(); }

KnotList<Q> knots(const In& in) { return {in.degree, in.list}; }

Place when(bool wrong, const char* place) { return wrong ? Place(place) : std::nullopt; }

bool fits(const In& in) { return in.c.size() + static_cast<std::size_t>(in.degree) == in.list.size() + 1; }

/// What FJ07.13 and its kin need.
Place net_error(const In& in) {
  if (!fits(in)) return "points";
  return when(contains(in.list, in.functions.m), "M");
}

/// The rules of a knot list, one after the other.
Place list_error(const In& in) {
  const std::size_t n = static_cast<std::size_t>(in.degree);
  if (in.list.size() < 2 * n) return "knots";
  if (!std::ranges::is_sorted(in.list)) return "knots[";
  for (std::size_t i = 0; i + n < in.list.size(); ++i) {
    if (in.list[i] == in.list[i + n]) return "knots[";
  }
  return when(in.list[n - 1] == in.list[in.list.size() - n], "knots");
}

bool parallel(const Point3& v, const Point3& w) {
  plain::Rows<3> rows;
  rows.insert(v);
  rows.insert(w);
  return rows.rank() < 2;
}

std::vector<Row4> rows_of(const std::vector<Point3>& points) {
  std::vector<Row4> rows;
  for (const Point3& x : points) rows.emplace_back(Q(1), x[0], x[1], x[2]);
  return rows;
}

/// A call of the library, and the error that the input deserves.
struct Call {
  std::string_view name;
  std::function<void(const In&)> run;
  std::function<Place(const In&)> expected;
};

void interpolate(const In& in) {
  interpolating_net<Q>(knots(in), in.c, in.d[0], in.d[1], in.functions.m, in.functions.lambda);
}

Place interpolation_error(const In& in) {
  const std::size_t n = static_cast<std::size_t>(in.degree);
  if (in.list.front() != in.list[n - 1] || in.list.back() != in.list[in.list.size() - n]) return "knots";
  if (contains(in.list, in.functions.m)) return "M";
  return when(parallel(in.d[0], in.d[1]), "v");
}

void insert(const In& in) { insert_knot(Spline<Q, Point3>(knots(in), in.c), in.x); }

Place insertion_error(const In& in) {
  const std::size_t n = static_cast<std::size_t>(in.degree);
  if (in.x < in.list[n - 1] || in.list[in.list.size() - n] < in.x) return "t";
  return when(std::ranges::count(in.list, in.x) == in.degree, "knots[");
}

/// The cells after the first, whose only pole is M* = u_{i-1}; the first one refuses all knots.
void cells(const In& in) {
  cell_net<Q, Point3>(knots(in), in.c, first_cell(knots(in), in.functions.lambda, in.functions.m), in.d.front());
}

void recover(const In& in) {
  const std::vector<Row4> p = rows_of(in.c);
  recover_pieces<Q>(knots(in), p, rows_of(in.d));
}

Place recovery_error(const In& in) {
  const plain::Strip strip = plain::strip_of(knots(in), in.c, in.d);
  return when(plain::refuted(strip, 3 * in.degree + 1), "piece[");
}

bool first_piece_starts_at(const In& in, const Q& m) {
  const KnotList<Q> u = knots(in);
  for (const int k : u.proper_pieces()) {
    if (u.piece_begin(k) == m) return true;
  }
  return false;
}

DirectrixEquation<Q> equation_of(const In& in) {
  return {Bernstein<Q>({in.x}), Bernstein<Q>({in.functions.sigma, in.functions.sigma})};
}

const std::vector<Call>& calls() {
  static const std::vector<Call> list{
      {"linear_net",
       [](const In& in) { linear_net<Q, Point3>(knots(in), in.c, in.functions.lambda, in.functions.m, in.d.front()); },
       net_error},
      {"rational_net",
       [](const In& in) {
         rational_net<Q, Point3>(knots(in), in.c, in.functions.lambda, in.functions.m, in.functions.sigma,
                                 in.d.front());
       },
       [](const In& in) { return in.functions.sigma.sign() == 0 ? Place("sigma") : net_error(in); }},
      {"cell_net", cells,
       [](const In& in) { return contains(in.list, in.functions.m) ? Place("M") : when(!fits(in), "points"); }},
      {"piecewise_net",
       [](const In& in) {
         piecewise_net<Q, Point3>(knots(in), in.c, in.functions.lambda, in.functions.m, in.d.front());
       },
       [](const In& in) { return when(first_piece_starts_at(in, in.functions.m), "M"); }},
      {"interpolating_net", interpolate, interpolation_error},
      {"insert_knot", insert, insertion_error},
      {"recover_pieces", recover, recovery_error},
      {"Spline", [](const In& in) { Spline<Q, Point3>(knots(in), in.c); },
       [](const In& in) { return when(!fits(in), "points"); }},
      {"KnotList", [](const In& in) { knots(in); }, list_error},
      {"cylinder_net", [](const In& in) { cylinder_net<Q, Point3>(in.c, in.d.front(), in.list); },
       [](const In& in) { return when(in.list.size() != in.c.size(), "lengths"); }},
      {"cone_vertex", [](const In& in) { cone_vertex<Q, Point3>(in.c[0], in.d[0], in.x); },
       [](const In& in) { return when(in.x == Q(1), "alpha"); }},
      {"start_cone_net", [](const In& in) { start_cone_net<Q, Point3>(in.c, in.x); },
       [](const In& in) { return when(in.x.sign() == 0, "s"); }},
      {"aumann_equation", [](const In& in) { aumann_equation<Q>(in.degree, in.x, in.functions.m); },
       [](const In& in) { return when(in.x == Q(1), "rho"); }},
      {"solve_directrix", [](const In& in) { solve_directrix<Q, Point3>(in.c, equation_of(in)); },
       [](const In& in) {
         if (in.c.size() < 2) return Place("c.points");
         return when(in.x.sign() == 0 && in.functions.sigma.sign() == 0, "a");
       }},
      {"directrix_vertex", [](const In& in) { directrix_vertex<Q, Point3>(in.c, in.d, equation_of(in)); },
       [](const In& in) { return when(in.x.sign() != 0, "a"); }},  // b is constant
      {"edge_curve",
       [](const In& in) {
         edge_curve<Q, Point3>(in.c, in.d, {in.functions.lambda, in.functions.m, in.functions.sigma});
       },
       [](const In& in) { return when(in.functions.lambda == in.functions.m, "Lambda"); }},
      {"homogeneous",
       [](const In& in) {
         homogeneous(WeightedPoints<Q, 3>{in.c, in.weights});
       },
       [](const In& in) {
         if (in.weights.size() != in.c.size()) return Place("weights");
         return when(contains(in.weights, Q(0)), "weights[");
       }},
      {"from_dependence",
       [](const In& in) {
         const auto& [lambda, m, sigma] = in.functions;
         from_dependence<Q>(lambda, in.x, m, sigma);
       },
       [](const In& in) {
         if ((in.functions.lambda + in.x).sign() == 0) return Place("Lambda");
         return when((in.functions.m + in.functions.sigma).sign() == 0, "M");
       }},
  };
  return list;
}

const Call& call_of(const In& in) {
  const auto at = std::ranges::find(calls(), in.call, &Call::name);
  if (at == calls().end()) throw Discard("no such call");
  return *at;
}

/// A list that may be out of order, too short or too repetitive.
void spoil_list(Choices& choices, In& in) {
  switch (choices.below(4)) {
    case 1:
      std::swap(in.list[choices.below(in.list.size())], in.list[choices.below(in.list.size())]);
      break;
    case 2:
      in.list[choices.below(in.list.size())] = in.list[choices.below(in.list.size())];
      std::ranges::sort(in.list);
      break;
    case 3:
      in.list.resize(choices.below(in.list.size() + 1));
      break;
    default:
      break;
  }
}

}  // namespace

const PropertyInfo& RefusedInput::info() {
  static const PropertyInfo info{
      "refused",
      "a call with an input that no formula applies to throws InvalidInput naming the member, and no other call does",
      100,
      {"linear_net=refused",
       "linear_net=accepted",
       "rational_net=refused",
       "rational_net=accepted",
       "cell_net=refused",
       "cell_net=accepted",
       "piecewise_net=refused",
       "piecewise_net=accepted",
       "interpolating_net=refused",
       "interpolating_net=accepted",
       "insert_knot=refused",
       "insert_knot=accepted",
       "recover_pieces=refused",
       "recover_pieces=accepted",
       "Spline=refused",
       "Spline=accepted",
       "KnotList=refused",
       "KnotList=accepted",
       "cylinder_net=refused",
       "cylinder_net=accepted",
       "cone_vertex=refused",
       "cone_vertex=accepted",
       "start_cone_net=refused",
       "start_cone_net=accepted",
       "aumann_equation=refused",
       "aumann_equation=accepted",
       "solve_directrix=refused",
       "solve_directrix=accepted",
       "directrix_vertex=refused",
       "directrix_vertex=accepted",
       "edge_curve=refused",
       "edge_curve=accepted",
       "homogeneous=refused",
       "homogeneous=accepted",
       "from_dependence=refused",
       "from_dependence=accepted"}};
  return info;
}

RefusedInput::In RefusedInput::draw(Choices& choices, const Scale& scale, Labels& labels) {
  const Call& call = calls()[choices.below(calls().size())];
  const KnotList<Q> u = draw_knots(choices, scale);
  In in{.call = std::string(call.name), .list = u.list(), .degree = u.degree()};
  const int more = choices.pick({0, 0, 0, -1, 1});
  const bool counts = call.name == "linear_net" || call.name == "rational_net" || call.name == "cell_net" ||
                      call.name == "Spline" || call.name == "solve_directrix";
  in.c = draw_polygon(choices, scale, u.last() + 1 + (counts ? more : 0));
  in.d = draw_polygon(choices, scale, u.last() + 1);
  const Q small[] = {Q(0), Q(1), Q(-1), Q(2)};
  const auto draw_small = [&] { return small[choices.below(4)]; };
  in.functions.m = choices.once_in(3) ? draw_small() : draw_parameter(choices, scale, u);
  in.functions.lambda = choices.once_in(3) ? draw_small() : draw_parameter(choices, scale, u);
  if (choices.once_in(3)) in.functions.lambda = in.functions.m;
  in.functions.sigma = draw_small();
  in.x = choices.once_in(2) ? draw_parameter(choices, scale, u) : draw_small();
  for (std::size_t i = 0; i < in.c.size(); ++i) in.weights.push_back(choices.once_in(8) ? Q(0) : Q(2));
  if (call.name == "cylinder_net") in.list.resize(in.c.size() + (choices.once_in(2) ? 1 : 0));
  if (call.name == "KnotList") spoil_list(choices, in);
  labels.add(call.name, call.expected(in) ? "refused" : "accepted");
  return in;
}

void RefusedInput::check(const In& in, Labels&) {
  const Call& call = call_of(in);
  const Place expected = call.expected(in);
  try {
    call.run(in);
  } catch (const InvalidInput& refusal) {
    require(expected.has_value(), "an input is refused that is none to refuse");
    require(refusal.place().starts_with(*expected), "the error names another member");
    return;
  }
  require(!expected, "an input is accepted that no formula applies to");
}

}  // namespace torse::fuzz
