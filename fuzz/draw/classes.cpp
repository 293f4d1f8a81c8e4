#include "torse/fuzz/draw/classes.hpp"

#include <utility>

#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/weights.hpp"
#include "torse/fuzz/plain/pieces.hpp"

namespace torse::fuzz {
namespace {

Row4 row_of(const Rational& weight, const Point3& x) {
  if (weight.sign() == 0) return {weight, x[0], x[1], x[2]};
  return {weight, weight * x[0], weight * x[1], weight * x[2]};
}

std::vector<Rational> draw_weights_of(Choices& choices, const Scale& scale, int count, Weights weights) {
  if (weights == Weights::one) return std::vector<Rational>(static_cast<std::size_t>(count), Rational(1));
  return weights == Weights::any ? draw_row_weights(choices, scale, count) : draw_weights(choices, scale, count);
}

std::vector<Row4> rows_of(const std::vector<Rational>& weights, const std::vector<Point3>& points) {
  std::vector<Row4> rows;
  for (std::size_t i = 0; i < points.size(); ++i) rows.push_back(row_of(weights[i], points[i]));
  return rows;
}

Draft start(Choices& choices, const Scale& scale, Weights weights, const char* made) {
  Draft draft{draw_knots(choices, scale)};
  draft.p = draw_rows(choices, scale, draft.knots.last() + 1, weights);
  draft.made = made;
  return draft;
}

/// The list for degree n + 1 with the same inner knots.
KnotList<Rational> widened(const KnotList<Rational>& u) {
  std::vector<Rational> list{u[0] - Rational(1)};
  list.insert(list.end(), u.list().begin(), u.list().end());
  list.push_back(list.back() + Rational(1));
  return {u.degree() + 1, std::move(list)};
}

/// r + (x-t)/(n+1) r' over u, for r of degree n + 1.
std::vector<Row4> tangent_row(const plain::Pieces<4>& r, const KnotList<Rational>& u, const Rational& x) {
  const Rational over = Rational(1) / Rational(u.degree() + 1);
  plain::Pieces<4> row{r.breaks, {}};
  for (const plain::PolyRow<4>& piece : r.rows) {
    plain::PolyRow<4> f;
    for (std::size_t j = 0; j < 4; ++j) {
      f[j] = plain::plus(piece[j], plain::times({x * over, -over}, plain::derivative(piece[j])));
    }
    row.rows.push_back(std::move(f));
  }
  return plain::control_row<4>(row, u);
}

}  // namespace

Row4 blend(const Rational& a, const Row4& x, const Rational& b, const Row4& y) {
  Row4 z;
  for (int j = 0; j < 4; ++j) z[j] = a * x[j] + b * y[j];
  return z;
}

std::vector<Row4> cell_row(const KnotList<Rational>& u, const std::vector<Row4>& p, const Functions& f,
                           const Row4& q0) {
  const int n = u.degree();
  std::vector<Row4> q{q0};
  for (int i = 0; i < u.last(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const Row4 side = blend(u[i + n] - f.lambda, p[at], f.lambda - u[i], p[at + 1]);
    const Rational width = f.m - u[i];
    q.push_back(blend(Rational(1) / (f.sigma * width), side, (f.m - u[i + n]) / width, q[at]));
  }
  return q;
}

std::vector<Row4> draw_rows(Choices& choices, const Scale& scale, int count, Weights weights) {
  const std::vector<Rational> w = draw_weights_of(choices, scale, count, weights);
  return rows_of(w, draw_polygon(choices, scale, count));
}

Draft draft_plane(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "plane");
  draft.q = draw_rows(choices, scale, draft.knots.last() + 1, weights);
  const Matrix<3> turn = draw_matrix<3>(choices);
  const Point3 shift = draw_vector(choices, scale);
  for (auto* rows : {&draft.p, &draft.q}) {
    for (Row4& x : *rows) {
      const Point3 y = mapped<3>(turn, {x[1], x[2], Rational()});
      for (int j = 0; j < 3; ++j) x[j + 1] = y[j] + x[0] * shift[j];
    }
  }
  return draft;
}

Draft draft_line(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft{.knots = draw_knots(choices, scale), .made = "line"};
  const Point3 origin = draw_vector(choices, scale);
  const Point3 direction = draw_vector(choices, scale);
  const int count = draft.knots.last() + 1;
  for (auto* rows : {&draft.p, &draft.q}) {
    for (const Rational& w : draw_weights_of(choices, scale, count, weights)) {
      Point3 x = origin;
      add_scaled(x, draw_number(choices, scale), direction);
      rows->push_back(row_of(w, x));
    }
  }
  return draft;
}

Draft draft_cylinder(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "cylinder");
  draft.common_point = true;
  const Point3 v = draw_nonzero_vector(choices, scale);
  const Rational beta = weights == Weights::one ? Rational(1) : draw_nonzero(choices, scale);
  for (const Row4& x : draft.p) {
    draft.q.push_back(blend(beta, x, draw_number(choices, scale), {Rational(), v[0], v[1], v[2]}));
  }
  return draft;
}

Draft draft_cone(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "cone");
  draft.common_point = true;
  const Point3 vertex = draw_vector(choices, scale);
  const Rational beta = draw_number(choices, scale);
  for (const Row4& x : draft.p) {
    const Rational part = weights == Weights::one ? Rational(1) - beta : draw_number(choices, scale);
    draft.q.push_back(blend(beta, x, part, {Rational(1), vertex[0], vertex[1], vertex[2]}));
  }
  return draft;
}

Draft draft_linear(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "linear");
  const Functions f = draw_functions(choices, scale, draft.knots, weights != Weights::one);
  draft.functions = f;
  draft.common_point = f.lambda == f.m;
  draft.q = cell_row(draft.knots, draft.p, f, draw_rows(choices, scale, 1, weights).front());
  return draft;
}

Draft draft_edge(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft{.knots = draw_knots(choices, scale), .made = "edge"};
  const KnotList<Rational>& u = draft.knots;
  const KnotList<Rational> wide = widened(u);
  const plain::Pieces<4> r = plain::pieces_of<4>(wide, draw_rows(choices, scale, wide.last() + 1, weights));
  Functions f = draw_functions(choices, scale, u, weights != Weights::one);
  f.m = draw_parameter(choices, scale, u);
  draft.p = tangent_row(r, u, f.m);
  draft.q = tangent_row(r, u, f.lambda);
  const Rational over = Rational(1) / f.sigma;
  for (Row4& x : draft.q) torse::scale(x, over);
  draft.functions = f;
  return draft;
}

Draft draft_curve(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "curve");
  draft.q = draft.p;
  return draft;
}

Draft draft_free(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = start(choices, scale, weights, "free");
  draft.q = draw_rows(choices, scale, draft.knots.last() + 1, weights);
  return draft;
}

}  // namespace torse::fuzz
