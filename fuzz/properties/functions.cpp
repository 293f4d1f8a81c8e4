#include "torse/fuzz/properties/functions.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "torse/developable/factors.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/piece_functions.hpp"
#include "torse/developable/recovery.hpp"
#include "torse/developable/regression.hpp"
#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/elimination.hpp"
#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz {
namespace {

using Blossom = BlossomFunctions<Rational>;
using Factor = Linear<Rational>;
using plain::PolyRow;

bool zero(const Rational& x) { return x.sign() == 0; }

PolyRow<4> times(const Factor& f, const PolyRow<4>& row) {
  PolyRow<4> product;
  for (std::size_t j = 0; j < 4; ++j) product[j] = plain::times({f.constant, f.slope}, row[j]);
  return product;
}

PolyRow<4> plus(const PolyRow<4>& x, const Rational& factor, const PolyRow<4>& y) {
  PolyRow<4> sum;
  for (std::size_t j = 0; j < 4; ++j) sum[j] = plain::plus(x[j], plain::scaled(factor, y[j]));
  return sum;
}

/// Both rows as polynomials, and a parameter.
struct Patch {
  PolyRow<4> p;
  PolyRow<4> q;
  int n;

  Row4 p_at(const Rational& t) const { return plain::value_at<4>(p, t); }
  Row4 q_at(const Rational& t) const { return plain::value_at<4>(q, t); }
  Row4 dp(const Rational& t) const { return plain::value_at<4>(plain::derivative<4>(p), t); }
  Row4 dq(const Rational& t) const { return plain::value_at<4>(plain::derivative<4>(q), t); }

  /// Throws Failed unless p[t^<n-1>, Lambda] = sigma q[t^<n-1>, M].
  void require_blossom(const Rational& t, const Blossom& f, const char* message) const {
    const Rational over = Rational(1) / Rational(n);
    const Row4 left = blend(Rational(1), p_at(t), (f.lambda - t) * over, dp(t));
    const Row4 right = blend(f.sigma, q_at(t), f.sigma * (f.m - t) * over, dq(t));
    require(left == right, message);
  }
  /// Throws Failed unless p' = lambda W + mu W' + nu p.
  void require_frame(const Rational& t, const FrameFunctions<Rational>& f, const char* message) const {
    const Row4 w = blend(Rational(1), q_at(t), Rational(-1), p_at(t));
    const Row4 dw = blend(Rational(1), dq(t), Rational(-1), dp(t));
    require(dp(t) == blend(Rational(1), blend(f.lambda, w, f.mu, dw), f.nu, p_at(t)), message);
  }
};

/// The value of `formula`, or nothing where it divides by zero.
template <class Formula>
auto finite(const Formula& formula) -> std::optional<decltype(formula())> {
  try {
    return formula();
  } catch (const DivisionByZero&) {
    return std::nullopt;
  }
}

struct Case {
  const FunctionsOfAPatch::In& in;
  std::vector<Row4> q;
  Patch patch;
  Blossom functions;
  Factor f;
  Factor g;

  void recovery() const;
  void frames() const;
  void rewritten() const;
  void factors() const;
  void edge() const;
};

Case case_of(const FunctionsOfAPatch::In& in) {
  const int n = static_cast<int>(in.p.size()) - 1;
  const KnotList<Rational> u = bezier_knots<Rational>(n);
  std::vector<Row4> q = cell_row(u, in.p, in.functions, in.q0);
  Patch patch{plain::pieces_of<4>(u, in.p).rows[0], plain::pieces_of<4>(u, q).rows[0], n};
  return {in,
          std::move(q),
          std::move(patch),
          {in.functions.lambda, in.functions.m, in.functions.sigma},
          {in.factors.at(0), in.factors.at(1)},
          {in.factors.at(2), in.factors.at(3)}};
}

void require_equal(const Blossom& x, const Blossom& y, const char* message) {
  require(x.lambda == y.lambda && x.m == y.m && x.sigma == y.sigma, message);
}

/// The functions come back from the cells, where those determine them, and from the piece.
void Case::recovery() const {
  const KnotList<Rational> u = bezier_knots<Rational>(patch.n);
  for (int i = 0; i < patch.n; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    plain::Rows<4> cell;
    for (const Row4& x : {in.p[at], in.p[at + 1], q[at], q[at + 1]}) cell.insert(x);
    try {
      require_equal(cell_functions<Rational>(u, in.p, q, i), functions, "a cell gives other functions");
      require(cell.rank() == 3, "a cell on a line gives functions");
    } catch (const InvalidInput&) {
      require(cell.rank() < 3, "a cell in a plane gives no functions");
    }
  }
  const PieceFunctions<Rational> piece = recover_piece<Rational>(u, in.p, q, 1);
  if (piece.sweep != Sweep::surface) return;
  require(piece.constant(), "the piece has no constant functions");
  const auto found = *piece.blossom();
  require_equal({*found.lambda.constant_value(), *found.m.constant_value(), *found.sigma.constant_value()}, functions,
                "the piece gives other functions");
}

void Case::frames() const {
  const Rational& t = in.t;
  const Rational e = functions.lambda - functions.sigma * functions.m + t * (functions.sigma - Rational(1));
  const auto frame = finite([&] { return to_frame(patch.n, t, functions); });
  require(frame.has_value() != zero(e), "the frame exists where it should not, or not where it should");
  if (!frame) return;
  patch.require_frame(t, *frame, "FJ21.4.3 does not hold");
  require_equal(to_blossom(patch.n, t, *frame), functions, "Corollary 4.1 there and back");
  if (zero(f(t))) return;
  const Patch product{times(f, patch.p), times(f, patch.q), patch.n + 1};
  product.require_frame(t, gauged(*frame, f(t), f.slope), "a common factor gives another frame");
}

void Case::rewritten() const {
  const Rational& alpha = in.factors.at(0);
  const Rational& beta = in.factors.at(2);
  const PolyRow<4> none{};
  if (!zero(beta)) {
    const Patch weighted{plus(none, alpha, patch.p), plus(none, beta, patch.q), patch.n};
    weighted.require_blossom(in.t, scaled_weights(functions, alpha, beta), "other weights, other functions");
  }
  const Rational one(1);
  const auto at = [&](const Rational& x) { return one + (in.b - one) * x; };
  const auto moved = finite([&] { return moebius_functions(functions, in.b); });
  require(moved.has_value() == (!zero(at(functions.lambda)) && !zero(at(functions.m))),
          "Moebius functions exist where they should not, or not where they should");
  if (!moved) return;
  const KnotList<Rational> u = bezier_knots<Rational>(patch.n);
  const Patch again{plain::pieces_of<4>(u, moebius_rows<Rational, Row4>(in.p, in.b)).rows[0],
                    plain::pieces_of<4>(u, moebius_rows<Rational, Row4>(q, in.b)).rows[0], patch.n};
  again.require_blossom(in.t, *moved, "FJ21.5.2 does not hold");
  require_equal(moebius_functions(*moved, one / in.b), functions, "b and then 1/b do not give the functions back");
}

/// FJ21.5.3 and 5.4, and back.
void Case::factors() const {
  const Rational& t = in.t;
  const auto raised = finite([&] { return elevated_functions(patch.n, t, functions, f, g); });
  if (raised) {
    const Patch product{times(f, patch.p), times(g, patch.q), patch.n + 1};
    if (!zero(f(t)) && !zero(g(t))) product.require_blossom(t, *raised, "FJ21.5.3 does not hold");
    const auto back = finite([&] { return unelevated(patch.n, t, *raised, f, g); });
    if (back && !zero(f(t)) && !zero(g(t))) require_equal(*back, functions, "FJ21.5.3 there and back");
  }
  const auto shortened = finite([&] { return shortened_functions(patch.n, t, functions, f, g); });
  if (!shortened || zero(f(t)) || zero(g(t))) return;
  const PolyRow<4> ruling = plus(patch.q, Rational(-1), patch.p);
  const Patch part{times(f, patch.p), plus(times(f, patch.p), Rational(1), times(g, ruling)), patch.n + 1};
  part.require_blossom(t, *shortened, "FJ21.5.4 does not hold");
  if (const auto back = finite([&] { return unshortened(patch.n, t, *shortened, f, g); })) {
    require_equal(*back, functions, "FJ21.5.4 there and back");
  }
}

void Case::edge() const {
  const Rational& t = in.t;
  const Rational one(1);
  if (const auto v = finite([&] { return edge_parameter(t, functions); })) {
    const EdgeSpeed<Rational> speed = edge_speed(patch.n, t, functions);
    const Row4 r = edge_row(*v, patch.p_at(t), patch.q_at(t));
    const Row4 ruling = blend(one, patch.q_at(t), -one, patch.p_at(t));
    require(blend(one - *v, patch.dp(t), *v, patch.dq(t)) == blend(speed.alpha, ruling, speed.beta, r),
            "the surface is not singular at the edge");
  }
  try {
    const std::vector<Row4> rows = edge_curve<Rational, Row4>(in.p, q, functions);
    require(functions.lambda != functions.m, "an edge for Lambda = M");
    const Patch edge{plain::pieces_of<4>(bezier_knots<Rational>(patch.n + 1), rows).rows[0], {}, patch.n + 1};
    const Row4 expected =
        blend(functions.lambda - t, patch.p_at(t), functions.sigma * (t - functions.m), patch.q_at(t));
    require(blend(functions.lambda - functions.m, edge.p_at(t), -one, expected) == Row4::Constant(Rational()),
            "another edge of regression");
    require((edge_patch<Rational, Row4>(rows, functions.m) == in.p), "the tangents of the edge do not give p back");
    std::vector<Row4> scaled_q;
    for (const Row4& x : q) scaled_q.push_back(blend(functions.sigma, x, Rational(0), x));
    require((edge_patch<Rational, Row4>(rows, functions.lambda) == scaled_q),
            "the tangents of the edge do not give q back");
  } catch (const InvalidInput&) {
    require(functions.lambda == functions.m, "no edge though Lambda is not M");
  }
}

}  // namespace

const PropertyInfo& FunctionsOfAPatch::info() {
  static const PropertyInfo info{
      "functions",
      "Lambda, M, sigma come back from the net, and change with parameters, weights and factors as FJ21 says",
      20,
      {"Lambda=M", "Lambda=other", "sigma=1", "sigma=other", "Lambda=knot", "M=near", "M=huge", "M=inside"}};
  return info;
}

FunctionsOfAPatch::In FunctionsOfAPatch::draw(Choices& choices, const Scale& scale, Labels& labels) {
  const int n = choices.between(1, scale.degree);
  const KnotList<Rational> u = bezier_knots<Rational>(n);
  In in;
  const Weights weights = choices.once_in(2) ? Weights::any : Weights::one;
  in.p = draw_rows(choices, scale, n + 1, weights);
  in.q0 = draw_rows(choices, scale, 1, weights).front();
  in.functions = draw_functions(choices, scale, u, true);
  in.t = draw_parameter(choices, scale, u);
  for (int i = 0; i < 4; ++i) in.factors.push_back(draw_number(choices, scale));
  in.b = draw_nonzero(choices, scale);
  labels.add("degree", n);
  labels.add("Lambda", in.functions.lambda == in.functions.m ? "M" : "other");
  labels.add("Lambda", std::string(parameter_kind(u, in.functions.lambda)));
  labels.add("M", std::string(parameter_kind(u, in.functions.m)));
  labels.add("sigma", in.functions.sigma == Rational(1) ? "1" : "other");
  return in;
}

void FunctionsOfAPatch::check(const In& in, Labels&) {
  const Case patch = case_of(in);
  patch.recovery();
  patch.frames();
  patch.rewritten();
  patch.factors();
  patch.edge();
}

}  // namespace torse::fuzz
