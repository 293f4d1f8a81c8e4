// The edge from pairs of control points, and back with exact numbers.
#include "torse/exact/repair/constant_net.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "torse/exact/repair/vectors.hpp"

namespace torse::repair {
namespace {

/// A control point as a combination of two neighbours in the edge: row 2 i is c_i, row 2 i + 1 is d_i, of r_i, r_{i+1}.
struct EdgeRow {
  std::array<Rational, 2> exact;
  std::array<Real, 2> real;
};

std::vector<EdgeRow> edge_rows(const KnotList<Rational>& u, const RelationConstants& constants) {
  const std::vector<Rational> v = u.cad_list();
  std::vector<EdgeRow> rows;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(u.last()); ++i) {
    const Rational& low = v[i];
    const Rational& high = v[i + static_cast<std::size_t>(u.degree()) + 1];
    for (const bool first : {true, false}) {
      const Rational& x = first ? constants.m : constants.lambda;
      const Rational factor = first ? constants.sigma : Rational(1);
      EdgeRow row{{factor * (high - x) / (high - low), factor * (x - low) / (high - low)}, {}};
      for (std::size_t j = 0; j < 2; ++j) row.real[j] = Real::from_rational(row.exact[j]);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Real norm(const Real& a, const Real& b) { return magnitude(a) + magnitude(b); }

/// How much the rows enlarge errors of the edge, in units of their scales.
template <int D>
Real growth(const std::vector<EdgeRow>& rows, const RealNet<D>& net) {
  Real most(0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    most = std::max(most, norm(rows[k].real[0], rows[k].real[1]) / net.scale[k].square_root());
  }
  return most;
}

/// r_i and r_{i+1} from c_i and d_i, by their coefficients.
template <class S, class P>
std::array<P, 2> edge_from(const std::array<S, 2>& row_c, const std::array<S, 2>& row_d, const P& c, const P& d) {
  const auto& [a0, b0] = row_c;
  const auto& [a1, b1] = row_d;
  const S det = a0 * b1 - a1 * b0;
  return {combine(b1 / det, c, -b0 / det, d), combine(a0 / det, d, -a1 / det, c)};
}

/// r_0, ..., r_{L+1} of a net that has an edge.
template <int D>
std::vector<Vec<Real, D>> edge_of(const std::vector<EdgeRow>& rows, const RealNet<D>& net) {
  std::vector<Vec<Real, D>> r;
  for (std::size_t k = 0; k < rows.size(); k += 2) {
    auto pair = edge_from(rows[k].real, rows[k + 1].real, net.points[k], net.points[k + 1]);
    r.push_back(std::move(pair[0]));
    if (k + 2 == rows.size()) r.push_back(std::move(pair[1]));
  }
  return r;
}

/// How much errors of the first points, one unit of their scales each, are enlarged in the second edge point of
/// edge_from. The first is not used again.
Real joint_growth(const std::vector<EdgeRow>& rows, const Real& scale_c, const Real& scale_d) {
  const auto& [a0, b0] = rows[0].real;
  const auto& [a1, b1] = rows[1].real;
  const Real unit = std::max(scale_c, scale_d).square_root();
  return norm(a0, a1) * unit / magnitude(a0 * b1 - a1 * b0);
}

/// A segment with what its exact points come from.
template <int D>
struct SegmentRows {
  RealNet<D> part;
  std::vector<EdgeRow> rows;
};

/// For each segment how much its rounding errors matter: its own growth, times that of the segments that start from
/// them, which is 1 or more: |a0 b1 - a1 b0| <= (|a0| + |a1|) max(|b0|, |b1|). For n > 1 the second edge point of a
/// segment does not reach its end; for n = 1 errors travel on.
template <int D>
std::vector<Real> reach_of_errors(const std::vector<SegmentRows<D>>& segments, int degree) {
  std::vector<Real> reach(segments.size());
  Real later(1);
  for (std::size_t s = segments.size(); s-- > 0;) {
    const auto& [part, rows] = segments[s];
    const Real own = growth(rows, part);
    reach[s] = own * later;
    const Real enlarged = joint_growth(rows, part.scale[0], part.scale[1]) * own;
    later = degree == 1 ? enlarged * later : enlarged;
  }
  return reach;
}

bool finite(const Real& x) { return mpfr_number_p(x.mpfr()) != 0; }

/// Whether no number left the reals: L* and M* may differ by less than a Real resolves.
template <int D>
bool finite(const std::vector<Vec<Real, D>>& points) {
  return std::ranges::all_of(points, [](const Vec<Real, D>& x) {
    return std::all_of(x.data(), x.data() + D, [](const Real& y) { return finite(y); });
  });
}

}  // namespace

template <int D>
std::optional<ExactNet<D>> realise_constant_net(const std::vector<Segment>& segments, const RealNet<D>& net,
                                                const std::vector<RelationConstants>& constants,
                                                const Accuracy& accuracy) {
  std::vector<SegmentRows<D>> parts;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (constants[s].lambda == constants[s].m) return std::nullopt;
    parts.push_back({part_of(net, segments[s]), edge_rows(segments[s].knots, constants[s])});
  }
  const std::vector<Real> reach = reach_of_errors(parts, segments.front().knots.degree());
  if (!std::ranges::all_of(reach, [](const Real& x) { return finite(x); })) return std::nullopt;
  ExactNet<D> result;
  for (std::size_t s = 0; s < parts.size(); ++s) {
    const std::vector<EdgeRow>& rows = parts[s].rows;
    const std::vector<Vec<Real, D>> edge = edge_of<D>(rows, parts[s].part);
    if (!finite<D>(edge)) return std::nullopt;
    const long exponent = accuracy.exponent() - exponent_of(reach[s]);
    std::vector<Vec<Rational, D>> r;
    for (const Vec<Real, D>& x : edge) r.push_back(rounded_point<D>(x, exponent));
    std::size_t first = 0;
    if (s > 0) {
      r[1] = edge_from(rows[0].exact, rows[1].exact, result[result.size() - 2], result.back())[1];
      first = 2;
    }
    for (std::size_t k = first; k < rows.size(); ++k) {
      result.push_back(combine(rows[k].exact[0], r[k / 2], rows[k].exact[1], r[k / 2 + 1]));
    }
  }
  return result;
}

template std::optional<ExactNet<3>> realise_constant_net<3>(const std::vector<Segment>&, const RealNet<3>&,
                                                            const std::vector<RelationConstants>&, const Accuracy&);
template std::optional<ExactNet<4>> realise_constant_net<4>(const std::vector<Segment>&, const RealNet<4>&,
                                                            const std::vector<RelationConstants>&, const Accuracy&);

}  // namespace torse::repair
