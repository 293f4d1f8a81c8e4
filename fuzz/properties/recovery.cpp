#include "torse/fuzz/properties/recovery.hpp"

#include <algorithm>
#include <array>

#include "torse/developable/piece_edge.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/plain/ruling.hpp"

namespace torse::fuzz {
namespace {

using Functions4 = PieceFunctions<Rational>;
using plain::parallel;
using plain::rank_of;
using plain::Ruling;
using plain::sum;

RecoveryInput draw_recovery(Choices& choices, const Scale& scale, Labels& labels) {
  RecoveryInput in{choices.below(3) == 2 ? draw_row_net(choices, scale) : draw_developable_rational_net(choices, scale),
                   {}};
  add_net_labels(labels, in.net);
  for (int i = 0; i < 3; ++i) in.shares.push_back(Rational(choices.between(0, 16)) / Rational(16));
  return in;
}

/// f at t by Horner's rule.
Rational value_of(const Polynomial<Rational>& f, const Rational& t) { return plain::value(f.coefficients(), t); }

/// None at a pole.
std::optional<Rational> value_of(const PolynomialFraction<Rational>& f, const Rational& t) {
  const Rational below = value_of(f.denominator(), t);
  if (below.sign() == 0) return std::nullopt;
  return value_of(f.numerator(), t) / below;
}

Row4 row_value(const PolynomialRow<Rational, 4>& row, const Rational& t) {
  return {value_of(row[0], t), value_of(row[1], t), value_of(row[2], t), value_of(row[3], t)};
}

Row4 slope_of(const PolynomialRow<Rational, 4>& row, const Rational& t) {
  Row4 x;
  for (int i = 0; i < 4; ++i) {
    x[i] = plain::value(plain::derivative(row[static_cast<std::size_t>(i)].coefficients()), t);
  }
  return x;
}

/// The blossom x[t^<n-1>, a] = x + (a-t)/n x'.
Row4 blossom_of(int n, const Row4& x, const Row4& dx, const Rational& a, const Rational& t) {
  return sum(Rational(1), x, (a - t) / Rational(n), dx);
}

/// What the rulings sweep, from more parameters than the equations have degrees.
Sweep sweep_of(const plain::Strip& strip, int j, int n) {
  const Rational& begin = strip.p.breaks[static_cast<std::size_t>(j)];
  const Rational width = strip.p.breaks[static_cast<std::size_t>(j) + 1] - begin;
  plain::Strip piece{{{begin, begin + width}, {strip.p.rows[static_cast<std::size_t>(j)]}},
                     {{begin, begin + width}, {strip.q.rows[static_cast<std::size_t>(j)]}}};
  Sweep sweep = Sweep::curve;
  for (int i = 0; i <= 3 * n; ++i) {
    const Ruling at = plain::ruling_at(piece, 0, begin + width * Rational(i) / Rational(3 * n));
    if (rank_of({at.p, at.q, at.dp, at.dq}) > 2 && !parallel(at.p, at.q)) return Sweep::surface;
    if (!parallel(at.p, at.q)) sweep = Sweep::line;
  }
  return sweep;
}

void check_dependence(const Functions4& f, const Ruling& at, const Rational& t) {
  const Row4 left = sum(value_of(f.alpha, t), at.p, value_of(f.beta, t), at.dp);
  const Row4 right = sum(value_of(f.gamma, t), at.q, value_of(f.delta, t), at.dq);
  require(left == right, "alpha p + beta p' is not gamma q + delta q'");
}

void check_blossoms(const Functions4& f, const Ruling& at, const Rational& t) {
  const auto lambda = f.lambda();
  const auto m = f.m();
  const auto sigma = f.sigma();
  if (!lambda || !m || !sigma) return;
  const auto x = value_of(*lambda, t);
  const auto y = value_of(*m, t);
  const auto z = value_of(*sigma, t);
  if (!x || !y || !z) return;
  const Row4 left = blossom_of(f.degree, at.p, at.dp, *x, t);
  const Row4 right = blossom_of(f.degree, at.q, at.dq, *y, t);
  require(left == sum(*z, right, Rational(), right), "p[t, Lambda] is not sigma q[t, M]");
}

void check_frame(const Functions4& f, const Ruling& at, const Rational& t) {
  const auto frame = f.frame();
  if (!frame) return;
  const auto lambda = value_of(frame->lambda, t);
  const auto mu = value_of(frame->mu, t);
  const auto nu = value_of(frame->nu, t);
  if (!lambda || !mu || !nu) return;
  const Rational one(1);
  const Row4 w = sum(one, at.q, -one, at.p);
  const Row4 dw = sum(one, at.dq, -one, at.dp);
  require(at.dp == sum(one, sum(*lambda, w, *mu, dw), *nu, at.p), "p' is not lambda W + mu W' + nu p");
}

/// The edge lies on the ruling and touches it.
void check_edge(const EdgeOfRegression<Rational>& edge, const Ruling& at, const Rational& t) {
  const Row4 r = row_value(edge.row, t);
  require(rank_of({r}) == 1, "the edge's row vanishes: it has a common factor");
  if (parallel(at.p, at.q)) return;
  require(rank_of({at.p, at.q, r}) == 2, "the edge is not on the ruling");
  require(rank_of({at.p, at.q, slope_of(edge.row, t)}) == 2, "the edge does not touch the ruling");
  if (!edge.v) return;
  if (const auto v = value_of(*edge.v, t)) {
    require(parallel(r, sum(Rational(1) - *v, at.p, *v, at.q)), "the edge is not at v on the ruling");
  }
}

/// The patch of FJ21.T6.1 has the same rulings, and its constants.
void check_patch(const ConstantPatch<Rational>& patch, const Functions4& f, const Ruling& at, const Rational& t) {
  const int n = static_cast<int>(patch.p.size()) - 1;
  const plain::Strip strip = plain::strip_of(bezier_knots<Rational>(n, f.begin, f.end), patch.p, patch.q);
  const Ruling other = plain::ruling_at(strip, 0, t);
  require(parallel(at.p, at.q) || parallel(other.p, other.q) || rank_of({at.p, at.q, other.p, other.q}) == 2,
          "the patch with constant functions has another ruling");
  require(blossom_of(n, other.p, other.dp, patch.lambda, t) == blossom_of(n, other.q, other.dq, patch.m, t),
          "the patch does not have its constants");
}

void check_constants(const Functions4& f, const Functions& known) {
  if (f.alpha.zero() || f.gamma.zero()) throw Failed("Lambda or M is infinite where it is a known constant");
  require(f.constant(), "functions that are constant are not");
  require(*f.lambda()->constant_value() == known.lambda, "another Lambda");
  require(*f.m()->constant_value() == known.m, "another M");
  require(*f.sigma()->constant_value() == known.sigma, "another sigma");
}

void check_surface(const RecoveryInput& in, const Functions4& f, const plain::Strip& strip, int j) {
  const std::optional<EdgeOfRegression<Rational>> edge = edge_of(f);
  require(edge.has_value(), "a surface without an edge of regression");
  if (in.net.common) {
    require(edge->degree == 0, "the edge of a cone or cylinder is no point");
    require(parallel(row_value(edge->row, Rational()), *in.net.common), "the edge is another point");
  }
  const std::optional<ConstantPatch<Rational>> patch =
      edge->degree <= 6 ? constant_patch(f, *edge) : std::optional<ConstantPatch<Rational>>();
  for (const Rational& share : in.shares) {
    const Rational t = f.begin + share * (f.end - f.begin);
    const Ruling at = plain::ruling_at(strip, j, t);
    require(value_of(f.alpha, t).sign() != 0 || value_of(f.beta, t).sign() != 0 || value_of(f.gamma, t).sign() != 0 ||
                value_of(f.delta, t).sign() != 0,
            "the dependence has a common factor");
    check_dependence(f, at, t);
    check_blossoms(f, at, t);
    check_frame(f, at, t);
    check_edge(*edge, at, t);
    if (patch) check_patch(*patch, f, at, t);
  }
  if (in.net.functions) check_constants(f, *in.net.functions);
}

void check_refused(const Net<4>& net) {
  const auto witness = find_witness_over_q<4>(net.knots, net.c, net.d);
  require(witness.has_value(), "no witness");
  try {
    recover_pieces<Rational>(net.knots, net.c, net.d);
  } catch (const InvalidInput& invalid) {
    return require(invalid.place() == "piece[" + std::to_string(witness->piece) + "]", "another piece is refused");
  }
  throw Failed("functions of a net that is not developable");
}

}  // namespace

const PropertyInfo& RecoveredFunctions::info() {
  static const PropertyInfo info{
      "recover.functions",
      "the dependence, Lambda, M, sigma, lambda, mu, nu and the patch with constant functions satisfy their equations "
      "at parameters; constants are found; the edge of regression touches every ruling and is the vertex of a cone",
      8,
      {"class=plane", "class=cylinder", "class=cone", "class=tangent", "class=none", "sweep=surface", "sweep=curve",
       "sweep=line"}};
  return info;
}

RecoveredFunctions::In RecoveredFunctions::draw(Choices& choices, const Scale& scale, Labels& labels) {
  return draw_recovery(choices, scale, labels);
}

void RecoveredFunctions::check(const In& in, Labels& labels) {
  if (!in.net.developable) return check_refused(in.net);
  constexpr std::array<const char*, 3> sweeps{"surface", "curve", "line"};
  const plain::Strip strip = plain::strip_of(in.net.knots, in.net.c, in.net.d);
  const std::vector<Functions4> pieces = recover_pieces<Rational>(in.net.knots, in.net.c, in.net.d);
  require(static_cast<int>(pieces.size()) == strip.p.count(), "another number of pieces");
  for (int j = 0; j < strip.p.count(); ++j) {
    const auto at = static_cast<std::size_t>(j);
    const Functions4& f = pieces[at];
    require(f.begin == strip.p.breaks[at] && f.end == strip.p.breaks[at + 1], "another interval");
    const Sweep sweep = sweep_of(strip, j, f.degree);
    labels.add("sweep", sweeps[static_cast<std::size_t>(sweep)]);
    require(f.sweep == sweep, "what the rulings sweep is something else");
    if (sweep == Sweep::surface) check_surface(in, f, strip, j);
  }
}

}  // namespace torse::fuzz
