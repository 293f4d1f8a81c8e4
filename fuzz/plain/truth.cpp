#include "torse/fuzz/plain/truth.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "torse/fuzz/plain/elimination.hpp"

namespace torse::fuzz::plain {
namespace {

using Row4 = Vec<Rational, 4>;

/// Elimination with the first nonzero pivot of a column.
Rational determinant(std::array<Row4, 4> m) {
  Rational product(1);
  for (int column = 0; column < 4; ++column) {
    std::size_t pivot = static_cast<std::size_t>(column);
    while (pivot < 4 && m[pivot][column].sign() == 0) ++pivot;
    if (pivot == 4) return Rational();
    const std::size_t at = static_cast<std::size_t>(column);
    if (pivot != at) {
      std::swap(m[pivot], m[at]);
      product = -product;
    }
    product *= m[at][column];
    for (std::size_t row = at + 1; row < 4; ++row) {
      const Rational factor = m[row][column] / m[at][column];
      for (int j = column; j < 4; ++j) m[row][j] -= factor * m[at][j];
    }
  }
  return product;
}

int degree_of(const Strip& strip) {
  std::size_t size = 1;
  for (const auto* curve : {&strip.p, &strip.q}) {
    for (const PolyRow<4>& row : curve->rows) {
      for (const Poly& f : row) size = std::max(size, f.size());
    }
  }
  return static_cast<int>(size) - 1;
}

/// Parameter `index` of `count` inside piece j.
Rational sample(const Strip& strip, int j, int index, int count) {
  const Rational& a = strip.p.breaks[static_cast<std::size_t>(j)];
  const Rational& b = strip.p.breaks[static_cast<std::size_t>(j) + 1];
  return a + Rational(index + 1) / Rational(count + 1) * (b - a);
}

std::vector<Row4> with_weights(const std::vector<Vec<Rational, 3>>& points) {
  std::vector<Row4> rows;
  for (const auto& x : points) rows.emplace_back(Rational(1), x[0], x[1], x[2]);
  return rows;
}

/// The equations of the points x on the line through p and q: the minors of rank 3 of x, p, q.
void insert_incidence(Rows<4>& equations, const Row4& p, const Row4& q) {
  const auto minor = [&](int i, int j) { return p[i] * q[j] - p[j] * q[i]; };
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      for (int k = j + 1; k < 4; ++k) {
        Row4 row = Row4::Constant(Rational());
        row[i] = minor(j, k);
        row[j] = -minor(i, k);
        row[k] = minor(i, j);
        equations.insert(std::move(row));
      }
    }
  }
}

/// The rank of the control rows that act on a piece of positive length.
int span(const KnotList<Rational>& u, const std::vector<Row4>& p, const std::vector<Row4>& q) {
  Rows<4> rows;
  for (int k = 1; k <= u.pieces(); ++k) {
    if (u.piece_begin(k) == u.piece_end(k)) continue;
    for (int i = k - 1; i < k + u.degree(); ++i) {
      rows.insert(p[static_cast<std::size_t>(i)]);
      rows.insert(q[static_cast<std::size_t>(i)]);
    }
  }
  return rows.rank();
}

}  // namespace

Strip strip_of(const KnotList<Rational>& u, const std::vector<Row4>& p, const std::vector<Row4>& q) {
  return {pieces_of<4>(u, p), pieces_of<4>(u, q)};
}

Strip strip_of(const KnotList<Rational>& u, const std::vector<Vec<Rational, 3>>& c,
               const std::vector<Vec<Rational, 3>>& d) {
  return strip_of(u, with_weights(c), with_weights(d));
}

Rational twist(const Strip& strip, int j, const Rational& t) {
  const PolyRow<4>& p = strip.p.rows[static_cast<std::size_t>(j)];
  const PolyRow<4>& q = strip.q.rows[static_cast<std::size_t>(j)];
  return determinant(
      {value_at<4>(p, t), value_at<4>(derivative<4>(p), t), value_at<4>(q, t), value_at<4>(derivative<4>(q), t)});
}

bool refuted(const Strip& strip, int samples) {
  for (int j = 0; j < strip.p.count(); ++j) {
    for (int i = 0; i < samples; ++i) {
      if (twist(strip, j, sample(strip, j, i, samples)).sign() != 0) return true;
    }
  }
  return false;
}

bool holds_by_samples(const Strip& strip) { return !refuted(strip, 4 * degree_of(strip) + 1); }

ClassTruth class_of(const KnotList<Rational>& u, const std::vector<Row4>& p, const std::vector<Row4>& q,
                    bool common_point_known) {
  if (span(u, p, q) < 4) return {"plane"};
  const Strip strip = strip_of(u, p, q);
  const int count = 2 * degree_of(strip) + 1;  // the equations are polynomials of twice the degree
  Rows<4> equations;
  for (int j = 0; j < strip.p.count(); ++j) {
    const std::size_t at = static_cast<std::size_t>(j);
    for (int i = 0; i < count; ++i) {
      if (equations.rank() == 4) return {"tangent"};
      if (equations.rank() == 3 && common_point_known) break;
      const Rational t = sample(strip, j, i, count);
      insert_incidence(equations, value_at<4>(strip.p.rows[at], t), value_at<4>(strip.q.rows[at], t));
    }
  }
  if (equations.rank() == 4) return {"tangent"};
  if (equations.rank() < 3) return {"cylinder"};
  const Row4 common = equations.orthogonal().front();
  return {common[0].sign() == 0 ? "cylinder" : "cone", common};
}

}  // namespace torse::fuzz::plain
