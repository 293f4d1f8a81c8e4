#include "torse/fuzz/draw/disguise.hpp"

#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/rewriting.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

/// Degrees above that of the scale that a disguise may reach.
constexpr int extra_degree = 2;

/// A net as polynomials, with what its knot list owes to them: the degree and how often each inner break is a knot.
struct Figure {
  plain::Strip strip;
  int degree;
  std::vector<int> repeats;
};

int repeats_of(const KnotList<Rational>& u, const Rational& t) {
  return static_cast<int>(std::count(u.list().begin(), u.list().end(), t));
}

Figure figure_of(const Draft& draft) {
  Figure figure{plain::strip_of(draft.knots, draft.p, draft.q), draft.knots.degree(), {}};
  const std::vector<Rational>& breaks = figure.strip.p.breaks;
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) figure.repeats.push_back(repeats_of(draft.knots, breaks[i]));
  return figure;
}

/// n-fold ends, or n - 1 knots beyond them.
KnotList<Rational> draw_list(Choices& choices, const Figure& figure) {
  const std::vector<Rational>& breaks = figure.strip.p.breaks;
  const int n = figure.degree;
  const Rational width = breaks.back() - breaks.front();
  const Rational before = choices.once_in(3) ? width : Rational();
  const Rational after = choices.once_in(3) ? width : Rational();
  std::vector<Rational> list;
  for (int i = n - 1; i >= 0; --i) list.push_back(breaks.front() - Rational(i) * before);
  for (std::size_t i = 0; i < figure.repeats.size(); ++i) {
    list.insert(list.end(), static_cast<std::size_t>(figure.repeats[i]), breaks[i + 1]);
  }
  for (int i = 0; i < n; ++i) list.push_back(breaks.back() + Rational(i) * after);
  return {n, std::move(list)};
}

void realize(Draft& draft, const plain::Strip& strip, KnotList<Rational> u) {
  draft.p = plain::control_row<4>(strip.p, u);
  draft.q = plain::control_row<4>(strip.q, u);
  draft.knots = std::move(u);
}

void realize(Choices& choices, Draft& draft, const Figure& figure) {
  realize(draft, figure.strip, draw_list(choices, figure));
}

/// The figure with every row times polynomials of degree `by`: knots become as much more frequent.
void raise(Figure& figure, int by) {
  figure.degree += by;
  for (int& times : figure.repeats) times += by;
}

// Each of these rewrites a draft; those that find nothing to do leave it as it is.
using Rewriting = void (*)(Choices&, const Scale&, Weights, Draft&);

/// One to three knots more, new ones or repeated ones.
void insert_knots(Choices& choices, const Scale&, Weights, Draft& draft) {
  const plain::Strip strip = plain::strip_of(draft.knots, draft.p, draft.q);
  KnotList<Rational> u = draft.knots;
  const int count = choices.between(1, 3);
  for (int i = 0; i < count; ++i) {
    const int k = choices.between(1, u.pieces());
    const Rational t = draw_inside(choices, u, k);
    if (repeats_of(u, t) == u.degree() || t == u.domain_begin() || t == u.domain_end()) continue;
    std::vector<Rational> list = u.list();
    list.insert(std::upper_bound(list.begin(), list.end(), t), t);
    u = {u.degree(), std::move(list)};
  }
  realize(draft, strip, std::move(u));
}

void elevate_degree(Choices& choices, const Scale&, Weights, Draft& draft) {
  Figure figure = figure_of(draft);
  raise(figure, 1);
  realize(choices, draft, figure);
  draft.functions.reset();
}

void trim_domain(Choices& choices, const Scale&, Weights, Draft& draft) {
  const KnotList<Rational> u = draft.knots;
  Rational a = draw_inside(choices, u, choices.between(1, u.pieces()));
  Rational b = draw_inside(choices, u, choices.between(1, u.pieces()));
  if (a == b) return;
  if (b < a) std::swap(a, b);
  Figure figure{plain::strip_of(u, draft.p, draft.q), u.degree(), {}};
  figure.strip = {plain::trimmed(figure.strip.p, a, b), plain::trimmed(figure.strip.q, a, b)};
  const std::vector<Rational>& breaks = figure.strip.p.breaks;
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) figure.repeats.push_back(repeats_of(u, breaks[i]));
  realize(choices, draft, figure);
}

void substitute(Choices& choices, Draft& draft, const plain::Substitution& by) {
  Figure figure = figure_of(draft);
  const Rational& begin = figure.strip.p.breaks.front();
  const Rational& end = figure.strip.p.breaks.back();
  const auto pole_side = [&](const Rational& t) { return (by.a - by.c * t).sign(); };
  if (pole_side(begin) * pole_side(end) <= 0) return;
  const bool reversed = by.inverse(end) < by.inverse(begin);
  figure.strip = {plain::substituted(figure.strip.p, figure.degree, by),
                  plain::substituted(figure.strip.q, figure.degree, by)};
  if (reversed) std::reverse(figure.repeats.begin(), figure.repeats.end());
  realize(choices, draft, figure);
  if (!draft.functions) return;
  // The blossom of (c s + d)^n p(t(s)) is the product of the c s_i + d times that of p at the t(s_i).
  Functions& f = *draft.functions;
  if (pole_side(f.lambda) == 0 || pole_side(f.m) == 0) {
    draft.functions.reset();
    return;
  }
  f.lambda = by.inverse(f.lambda);
  f.m = by.inverse(f.m);
  f.sigma = f.sigma * (by.c * f.lambda + by.d) / (by.c * f.m + by.d);
}

void change_parameter(Choices& choices, const Scale& scale, Weights, Draft& draft) {
  const Rational a = choices.once_in(2) ? draw_nonzero(choices, scale) : Rational(-1);
  substitute(choices, draft, {a, draw_number(choices, scale), Rational(0), Rational(1)});
}

void change_by_moebius(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  if (weights == Weights::one) return;
  const Rational a = draw_nonzero(choices, scale);
  const Rational b = draw_fraction(choices, 4);
  const Rational c = draw_nonzero(choices, scale);
  Rational d = draw_fraction(choices, 4);
  if (a * d == b * c) d += Rational(1);
  substitute(choices, draft, {a, b, c, d});
}

void swap_rows(Choices&, const Scale&, Weights, Draft& draft) {
  std::swap(draft.p, draft.q);
  if (draft.functions) {
    Functions& f = *draft.functions;
    std::swap(f.lambda, f.m);
    f.sigma = Rational(1) / f.sigma;
  }
}

/// Two points of each ruling instead of those of p and q: linear functions of t times these, of row sum 1 for
/// polynomial nets.
void mix_rows(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  if (draft.knots.degree() >= scale.degree + extra_degree) return;
  Figure figure = figure_of(draft);
  const bool constant = choices.once_in(2);
  const auto draw_factor = [&] {
    return constant ? plain::Poly{draw_fraction(choices, 3)}
                    : plain::Poly{draw_fraction(choices, 3), draw_fraction(choices, 3)};
  };
  const auto rest = [&](const plain::Poly& f) {
    return weights == Weights::one ? plain::plus({Rational(1)}, plain::scaled(Rational(-1), f)) : draw_factor();
  };
  const plain::Poly f = draw_factor();
  const plain::Poly g = draw_factor();
  const plain::Poly rest_f = rest(f);
  const plain::Poly rest_g = rest(g);
  const plain::Poly minor = plain::plus(plain::times(rest_f, rest_g), plain::scaled(Rational(-1), plain::times(f, g)));
  if (std::all_of(minor.begin(), minor.end(), [](const Rational& x) { return x.sign() == 0; })) return;
  figure.strip = {plain::added(plain::multiplied(rest_f, figure.strip.p), plain::multiplied(f, figure.strip.q)),
                  plain::added(plain::multiplied(g, figure.strip.p), plain::multiplied(rest_g, figure.strip.q))};
  if (!constant) raise(figure, 1);
  realize(choices, draft, figure);
  draft.functions.reset();
}

/// A factor of both rows, or one of each.
void multiply_rows(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  if (weights == Weights::one || draft.knots.degree() >= scale.degree + extra_degree) return;
  Figure figure = figure_of(draft);
  const auto draw_factor = [&] { return plain::Poly{draw_nonzero(choices, scale), draw_number(choices, scale)}; };
  const plain::Poly f = draw_factor();
  const plain::Poly g = choices.once_in(2) ? draw_factor() : f;
  figure.strip = {plain::multiplied(f, figure.strip.p), plain::multiplied(g, figure.strip.q)};
  raise(figure, 1);
  realize(choices, draft, figure);
  draft.functions.reset();
}

/// An affine map of space, for rational nets a projective one.
void map_space(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  Matrix<4> matrix;
  if (weights == Weights::one || choices.once_in(2)) {
    const Matrix<3> turn = draw_matrix<3>(choices);
    const Point3 shift = draw_vector(choices, scale);
    matrix[0] = {Rational(1), Rational(), Rational(), Rational()};
    for (std::size_t i = 0; i < 3; ++i) {
      matrix[i + 1] = {shift[static_cast<int>(i)], turn[i][0], turn[i][1], turn[i][2]};
    }
  } else {
    matrix = draw_matrix<4>(choices);
  }
  for (auto* rows : {&draft.p, &draft.q}) {
    for (Row4& x : *rows) x = mapped<4>(matrix, x);
  }
}

struct Named {
  const char* name;
  Rewriting rewrite;
};

constexpr std::initializer_list<Named> rewritings = {{"knots", insert_knots},
                                                     {"swap", swap_rows},
                                                     {"parameter", change_parameter},
                                                     {"degree", elevate_degree},
                                                     {"part", trim_domain},
                                                     {"mix", mix_rows},
                                                     {"map", map_space},
                                                     {"moebius", change_by_moebius},
                                                     {"factors", multiply_rows}};

constexpr std::initializer_list<Named> refinements = {{"knots", insert_knots}, {"degree", elevate_degree}};

bool same(const Draft& a, const Draft& b) {
  return a.knots.degree() == b.knots.degree() && a.knots.list() == b.knots.list() && a.p == b.p && a.q == b.q;
}

void rewrite(Choices& choices, const Scale& scale, Weights weights, Draft& draft, const Named& chosen) {
  Draft next = draft;
  chosen.rewrite(choices, scale, weights, next);
  if (same(draft, next) || !fits(next, weights)) return;
  next.disguise += (next.disguise.empty() ? "" : "+") + std::string(chosen.name);
  draft = std::move(next);
}

}  // namespace

bool fits(const Draft& draft, Weights weights) {
  if (weights == Weights::any) return true;
  const auto good = [&](const Row4& x) { return weights == Weights::one ? x[0] == Rational(1) : x[0].sign() != 0; };
  return std::all_of(draft.p.begin(), draft.p.end(), good) && std::all_of(draft.q.begin(), draft.q.end(), good);
}

void disguise(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  const int count = choices.pick({0, 0, 1, 1, 2});
  for (int i = 0; i < count; ++i) rewrite(choices, scale, weights, draft, choices.pick(rewritings));
}

void refine(Choices& choices, const Scale& scale, Weights weights, Draft& draft) {
  const int count = choices.between(1, 2);
  for (int i = 0; i < count; ++i) rewrite(choices, scale, weights, draft, choices.pick(refinements));
}

}  // namespace torse::fuzz
