#include <algorithm>

#include "torse/fuzz/draw/classes.hpp"
#include "torse/fuzz/plain/rewriting.hpp"
#include "torse/fuzz/plain/truth.hpp"
#include "torse/fuzz/properties/construction.hpp"

namespace torse::fuzz {
namespace {

using plain::Pieces;
using plain::Poly;

Pieces<4> negative(const Pieces<4>& x) { return plain::multiplied({Rational(-1)}, x); }
Pieces<4> difference_of(const Pieces<4>& x, const Pieces<4>& y) { return plain::added(x, negative(y)); }

Pieces<4> derivative_of(const Pieces<4>& x) {
  Pieces<4> dx = x;
  for (plain::PolyRow<4>& row : dx.rows) row = plain::derivative<4>(row);
  return dx;
}

bool is_zero_curve(const Pieces<4>& x) {
  return std::ranges::all_of(x.rows, [](const plain::PolyRow<4>& row) {
    return std::ranges::all_of(
        row, [](const Poly& f) { return std::ranges::all_of(f, [](const Rational& a) { return a.sign() == 0; }); });
  });
}

void require_equal(const Pieces<4>& x, const Pieces<4>& y, const char* message) {
  require(x.breaks == y.breaks, message);
  require(is_zero_curve(difference_of(x, y)), message);
}

/// p[t^<n-1>, x] = p + (x-t)/n p' as a curve in t.
Pieces<4> polar(const Pieces<4>& p, int n, const Rational& x) {
  const Rational over = Rational(1) / Rational(n);
  return plain::added(p, plain::multiplied({x * over, -over}, derivative_of(p)));
}

struct Promise {
  const ConstructionInput& in;
  const SurfaceOver<Rational>& surface;
  plain::Strip strip;
  int n;

  /// The curve of the rows that go in, on the whole domain or of the first Bezier piece.
  Pieces<4> given() const { return plain::pieces_of<4>(in.knots, in.p); }
  Pieces<4> first() const { return bezier(std::vector<Row4>(in.p.begin(), in.p.begin() + n + 1)); }
  static Pieces<4> bezier(const std::vector<Row4>& rows) {
    return plain::pieces_of<4>(bezier_knots<Rational>(static_cast<int>(rows.size()) - 1), rows);
  }

  Pieces<4> tau() const { return difference_of(strip.q, strip.p); }

  void keeps(const Pieces<4>& p) const { require_equal(strip.p, p, "the first row is another curve"); }
  void starts() const { require(surface.d.front() == in.q0, "the second row does not start at q_0"); }
  /// x p[.., Lambda] = sigma q[.., M] on all pieces.
  void relates(const Rational& sigma) const {
    require_equal(polar(strip.p, n, in.functions.lambda), plain::multiplied({sigma}, polar(strip.q, n, in.functions.m)),
                  "Lambda, M, sigma do not belong to it");
  }
  /// left p' = a tau + b tau'.
  void solves(const Poly& left, const Poly& a, const Poly& b) const {
    const Pieces<4> right = plain::added(plain::multiplied(a, tau()), plain::multiplied(b, derivative_of(tau())));
    require_equal(plain::multiplied(left, derivative_of(strip.p)), right,
                  "the equation of the directrix is not solved");
  }

  void net(const Rational& sigma) const {
    keeps(given());
    starts();
    relates(sigma);
  }
  void special() const;
  void parallel(const Row4& x, const Row4& y, const char* message) const {
    for (int i = 1; i < 4; ++i) {
      for (int j = 1; j < i; ++j) require(x[i] * y[j] == x[j] * y[i], message);
    }
  }
  void interpolates() const;
  void rewrites() const;
  /// The second row of FJ07.13.
  Pieces<4> linear(const KnotList<Rational>& u, const std::vector<Row4>& p) const {
    Functions f = in.functions;
    f.sigma = Rational(1);
    return plain::pieces_of<4>(u, cell_row(u, p, f, in.q0));
  }
};

void Promise::special() const {
  const std::string& method = in.method;
  const Rational one(1);
  const Rational degree(n);
  if (method == "cylinder" || method == "cone") {
    keeps(given());
    for (std::size_t i = 0; i < in.p.size(); ++i) {
      const Row4 ruling =
          method == "cylinder" ? blend(one, surface.d[i], -one, in.p[i]) : blend(one, surface.d[i], -in.a, in.p[i]);
      const Row4 common = method == "cylinder" ? blend(in.lengths[i], in.q0, Rational(0), in.q0)
                                               : blend(one, in.q0, -in.a, in.p.front());
      require(ruling == common, "the rulings do not pass through the point");
    }
    return;
  }
  if (method == "edge") {
    std::vector<Row4> r(in.p.begin(), in.p.begin() + n + 1);
    r.push_back(in.q0);
    require_equal(strip.p, polar(bezier(r), n + 1, in.functions.m), "p is not the blossom of the edge");
    return require_equal(strip.q, polar(bezier(r), n + 1, in.functions.lambda), "q is not the blossom of the edge");
  }
  keeps(first());
  const Poly t{Rational(0), one};
  if (method == "tangent") return solves({one}, {one}, {});
  if (method == "mean tangent") return solves({one}, {Rational(2)}, t);
  if (method == "mean chord") return solves(t, {one}, t);
  if (method == "affine") {
    starts();
    return solves({in.a - one}, {degree * (one - in.b)}, {one, in.b - one});
  }
  if (method == "start cone") {
    Pieces<4> from_start = strip.p;
    for (plain::PolyRow<4>& row : from_start.rows) {
      for (Poly& f : row) f.front() = Rational();
    }
    return require_equal(plain::multiplied({Rational(0), in.a}, tau()), from_start, "s u tau is not c - c_0");
  }
  const auto power = [](const std::vector<Rational>& b) {
    std::vector<Vec<Rational, 1>> control;
    for (const Rational& x : b) control.push_back(Vec<Rational, 1>::Constant(x));
    return plain::pieces_of<1>(bezier_knots<Rational>(static_cast<int>(b.size()) - 1), control).rows[0][0];
  };
  solves({one}, power(in.polynomial_a), power(in.polynomial_b));
}

void Promise::interpolates() const {
  keeps(given());
  relates(Rational(1));
  const auto ruling = [&](std::size_t i) { return blend(Rational(1), surface.d[i], Rational(-1), surface.c[i]); };
  // The rulings that went in are a and b times those of a net with these Lambda and M, which is the only one.
  require(blend(in.a, ruling(0), Rational(-1), in.q0) == Row4::Constant(Rational()), "another first ruling");
  require(blend(in.b, ruling(surface.c.size() - 1), Rational(-1), in.end) == Row4::Constant(Rational()),
          "another last ruling");
}

void Promise::rewrites() const {
  if (in.method == "elevate" || in.method == "insert") {
    const bool insert = in.method == "insert";
    const KnotList<Rational>& u = surface.knots;
    require(u.degree() == n + (insert ? 0 : 1), "another degree");
    require(!insert || u.size() == in.knots.size() + 1, "another number of knots");
    // As functions on the pieces of the finer list.
    const auto refined = [&](const Pieces<4>& curve) {
      return plain::pieces_of<4>(u, plain::control_row<4>(curve, u));
    };
    require_equal(strip.p, refined(given()), "p is another curve");
    return require_equal(strip.q, refined(linear(in.knots, in.p)), "q is another curve");
  }
  const KnotList<Rational> bezier = bezier_knots<Rational>(n);
  const std::vector<Row4> rows(in.p.begin(), in.p.begin() + n + 1);
  const Pieces<4> q = linear(bezier, rows);
  if (in.method == "moebius") {
    const plain::Substitution by{Rational(1), Rational(0), Rational(1) - in.b, in.b};
    const auto moved = [&](const Pieces<4>& x) {
      Pieces<4> y = plain::substituted(x, n, by);
      y.breaks = x.breaks;
      return y;
    };
    require_equal(strip.p, moved(first()), "p is another curve");
    return require_equal(strip.q, moved(q), "q is another curve");
  }
  require_equal(strip.p, plain::multiplied({in.a, in.b}, first()), "p is not multiplied");
  require_equal(strip.q, plain::multiplied({in.b, in.a}, q), "q is not multiplied");
}

}  // namespace

void require_promise(const ConstructionInput& in, const SurfaceOver<Rational>& surface) {
  const Promise promise{in, surface, plain::strip_of(surface.knots, surface.c, surface.d), in.knots.degree()};
  const std::string& method = in.method;
  const auto is_one_of = [&](std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* name) { return method == name; });
  };
  if (is_one_of({"13", "14", "15", "16", "16 rulings", "18", "pieces"})) return promise.net(Rational(1));
  if (method == "7.1") return promise.net(in.functions.sigma);
  if (method == "interpolate") return promise.interpolates();
  if (is_one_of({"elevate", "insert", "moebius", "factors"})) return promise.rewrites();
  if (method != "part") return promise.special();
  promise.keeps(promise.given());
  const plain::Pieces<4> ruling = difference_of(promise.linear(in.knots, in.p), promise.strip.p);
  require_equal(promise.tau(), plain::multiplied({in.a}, ruling), "not the part of the rulings");
}

}  // namespace torse::fuzz
