#include "torse/fuzz/draw/joined.hpp"

#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

/// The Bezier rows of one piece on [a, b].
struct Piece {
  std::vector<Row4> p;
  std::vector<Row4> q;
};

Row4 draw_row(Choices& choices, const Scale& scale, Weights weights) {
  return draw_rows(choices, scale, 1, weights).front();
}

/// A combination of the rows, of weight 1 where all weights are to be 1.
Row4 draw_blend(Choices& choices, Weights weights, const std::vector<Row4>& of) {
  const bool affine = weights == Weights::one;
  Row4 x = affine ? of[0] : blend(draw_fraction(choices, 3), of[0], Rational(0), of[0]);
  for (std::size_t i = 1; i < of.size(); ++i) {
    const Rational part = draw_fraction(choices, 3);
    x = blend(Rational(1), x, part, of[i]);
    if (affine) x = blend(Rational(1), x, -part, of[0]);
  }
  return x;
}

/// Rows q_i = beta p_i + a_i centre with the centre on the first ruling.
void add_pencil(Choices& choices, const Scale& scale, Weights weights, Piece& piece, int degree) {
  const bool point = piece.p[0] == piece.q[0];
  const Rational beta = point || choices.once_in(2) ? Rational(1) : draw_number(choices, scale);
  Row4 centre = blend(Rational(1), piece.q[0], -beta, piece.p[0]);
  if (point) {
    const Point3 v = draw_vector(choices, scale);
    centre = {Rational(), v[0], v[1], v[2]};
  }
  const bool weighted = weights == Weights::one && beta != Rational(1);
  for (int i = 1; i <= degree; ++i) {
    piece.p.push_back(draw_row(choices, scale, weights));
    const Rational part = weighted ? Rational(1) : draw_number(choices, scale);
    piece.q.push_back(blend(beta, piece.p.back(), part, centre));
  }
}

void add_flat(Choices& choices, Weights weights, Piece& piece, int degree, const std::vector<Row4>& span) {
  for (int i = 1; i <= degree; ++i) {
    piece.p.push_back(draw_blend(choices, weights, span));
    piece.q.push_back(draw_blend(choices, weights, span));
  }
}

Piece draw_piece(Choices& choices, const Scale& scale, Weights weights, const KnotList<Rational>& u, const Row4& p,
                 const Row4& q) {
  Piece piece{{p}, {q}};
  const int n = u.degree();
  switch (choices.below(6)) {
    case 0:
      add_flat(choices, weights, piece, n, {p, q, draw_row(choices, scale, weights)});
      break;
    case 1:
      add_flat(choices, weights, piece, n, {p, q});
      break;
    case 2:
      for (int i = 1; i <= n; ++i) piece.p.push_back(draw_row(choices, scale, weights));
      piece.q = cell_row(u, piece.p, draw_functions(choices, scale, u, weights != Weights::one), q);
      break;
    case 3:
      if (p == q) {
        for (int i = 1; i <= n; ++i) piece.p.push_back(draw_row(choices, scale, weights));
        piece.q = piece.p;
        break;
      }
      [[fallthrough]];
    default:
      add_pencil(choices, scale, weights, piece, n);
  }
  return piece;
}

}  // namespace

Draft draft_joined(Choices& choices, const Scale& scale, Weights weights) {
  const int n = choices.between(1, scale.degree);
  const int pieces = choices.between(2, std::max(2, scale.pieces));
  std::vector<Rational> list(static_cast<std::size_t>(n), Rational(0));
  std::vector<Row4> p{draw_row(choices, scale, weights)};
  std::vector<Row4> q{choices.once_in(3) ? p.front() : draw_row(choices, scale, weights)};
  for (int k = 0; k < pieces; ++k) {
    const Rational begin = list.back();
    const Rational end = begin + (choices.once_in(2) ? draw_positive(choices, scale) : Rational(1));
    const Piece piece = draw_piece(choices, scale, weights, bezier_knots<Rational>(n, begin, end), p.back(), q.back());
    p.insert(p.end(), piece.p.begin() + 1, piece.p.end());
    q.insert(q.end(), piece.q.begin() + 1, piece.q.end());
    list.insert(list.end(), static_cast<std::size_t>(n), end);
  }
  return {.knots = {n, std::move(list)}, .p = std::move(p), .q = std::move(q), .made = "joined"};
}

}  // namespace torse::fuzz
