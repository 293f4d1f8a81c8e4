// From B-spline rows to directions on a piece in doubles. Every weight is a quotient of differences of knots and not
// negative, so each step is a mean of its operands up to a relative error that is counted here.
#include "torse/exact/warp/rounded_net.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "torse/exact/warp/rounded_forms.hpp"

namespace torse {
namespace {

/// Coordinates outside are left to other arithmetics: products of eight of them stay far from overflow and underflow.
constexpr double largest = 0x1p120;
constexpr double smallest = 0x1p-120;

/// Control points with K coordinates, at most degree 16.
template <int K>
struct LocalRow {
  static constexpr int most = 17;
  int degree;
  std::array<std::array<double, static_cast<std::size_t>(K)>, most> p;
};

/// Whether sine_forms, of degree 8n - 4 for points and 16n - 8 for homogeneous rows, have no room.
template <int D>
constexpr bool too_high(int degree) {
  return (D == 3 ? 8 * degree - 4 : 16 * degree - 8) > rounding::most_degree;
}
static_assert(too_high<3>(LocalRow<3>::most) && too_high<4>(LocalRow<4>::most), "rows have room for all other degrees");

/// p_j = before p_i + after p_j.
template <std::size_t K>
void mix(const std::array<double, K>& from, double before, std::array<double, K>& to, double after) {
  for (std::size_t j = 0; j < K; ++j) to[j] = before * from[j] + after * to[j];
}

/// Replaces the control points of a piece over knots t_0 ... t_{2m-1} by its Bezier points over [t_{m-1}, t_m]: first
/// the left end becomes m-fold, then the right end, each by m(m+1)/2 means at most.
template <int K>
void make_bezier(LocalRow<K>& row, const double* t) {
  const int m = row.degree;
  const double a = t[m - 1];
  const double b = t[m];
  auto& p = row.p;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  LocalRow<K> right;
  right.p[at(m)] = p[at(m)];
  for (int r = 1; r <= m; ++r) {
    for (int i = m; i >= r; --i) {
      const double width = t[i + m - r] - t[i - 1];
      mix(p[at(i - 1)], (t[i + m - r] - a) / width, p[at(i)], (a - t[i - 1]) / width);
    }
    right.p[at(m - r)] = p[at(m)];
  }
  p = right.p;
  for (int r = 2; r <= m; ++r) {
    for (int j = m; j >= r; --j) {
      const double width = t[m + j - r + 1] - a;
      mix(p[at(j - 1)], (t[m + j - r + 1] - b) / width, p[at(j)], (b - a) / width);
    }
  }
}

/// What make_bezier adds to the error of a row with coordinates up to `norm`: 2m steps of two products with weights of
/// relative error 3u + 2 knot_error.
double bezier_error(int m, double norm, double knot_error) {
  return 2 * m * (8 * rounding::unit + 3 * knot_error) * norm;
}

/// The largest coordinate, NaN or infinite if one is.
template <int K>
double norm_of(const LocalRow<K>& row) {
  double norm = 0;
  double sum = 0;
  for (int i = 0; i <= row.degree; ++i) {
    for (const double x : row.p[static_cast<std::size_t>(i)]) {
      norm = std::max(norm, std::abs(x));
      sum += std::abs(x);
    }
  }
  return std::isfinite(sum) ? norm : sum;
}

/// The forms of Bezier points from coordinate `first` on, scaled by a power of two to a norm near 1. None unless the
/// norm is in range.
template <int L, int K>
std::optional<RoundedForms<L>> forms_of(const LocalRow<K>& row, int first, double error) {
  double norm = 0;
  for (int i = 0; i <= row.degree; ++i) {
    for (int j = 0; j < L; ++j) {
      norm = std::max(norm, std::abs(row.p[static_cast<std::size_t>(i)][static_cast<std::size_t>(first + j)]));
    }
  }
  if (!(norm >= smallest && norm <= largest)) return std::nullopt;
  const double scale = std::ldexp(1.0, -std::ilogb(norm));
  const auto& binomial = rounding::binomials.value[static_cast<std::size_t>(row.degree)];
  std::optional<RoundedForms<L>> forms(std::in_place, row.degree);
  for (int i = 0; i <= row.degree; ++i) {
    for (int j = 0; j < L; ++j) {
      forms->at(j, i) = binomial[static_cast<std::size_t>(i)] * scale *
                        row.p[static_cast<std::size_t>(i)][static_cast<std::size_t>(first + j)];
    }
  }
  forms->close((error + 3 * rounding::unit * norm) * scale);
  return forms;
}

/// Directions along c', d - c, d'; none where one is out of range. The forms are large, so they are made in place.
struct Directions {
  std::optional<RoundedForms<3>> a{};
  std::optional<RoundedForms<3>> w{};
  std::optional<RoundedForms<3>> b{};

  bool complete() const { return a && w && b; }
};

/// The B-splines c', d' of degree n-1 and d - c of degree n from differences of control points.
Directions directions(const RoundedNet<3>& net, int k) {
  const int n = net.degree;
  const double* t = net.knots.data() + (k - 1);
  LocalRow<6> speed{n - 1, {}};
  LocalRow<3> ruling{n, {}};
  for (int i = 0; i <= n; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const Vec<double, 3>& c = net.c[static_cast<std::size_t>(k - 1) + at];
    const Vec<double, 3>& d = net.d[static_cast<std::size_t>(k - 1) + at];
    for (int j = 0; j < 3; ++j) ruling.p[at][static_cast<std::size_t>(j)] = d[j] - c[j];
    if (i == n) break;
    const Vec<double, 3>& next_c = net.c[static_cast<std::size_t>(k) + at];
    const Vec<double, 3>& next_d = net.d[static_cast<std::size_t>(k) + at];
    const double width = (t[i + n] - t[i]) / (t[n] - t[n - 1]);  // at least 1
    for (int j = 0; j < 3; ++j) {
      speed.p[at][static_cast<std::size_t>(j)] = (next_c[j] - c[j]) / width;
      speed.p[at][static_cast<std::size_t>(j + 3)] = (next_d[j] - d[j]) / width;
    }
  }
  const double speed_norm = norm_of(speed);
  const double ruling_norm = norm_of(ruling);
  if (!(speed_norm <= largest && ruling_norm <= largest)) return {};
  double speed_error = 2 * net.coordinate_error * rounding::up + (8 * rounding::unit + 5 * net.knot_error) * speed_norm;
  double ruling_error = 2 * net.coordinate_error + 2 * rounding::unit * ruling_norm;
  if (n > 1) make_bezier(speed, t + 1);
  make_bezier(ruling, t);
  speed_error += bezier_error(n - 1, speed_norm, net.knot_error);
  ruling_error += bezier_error(n, ruling_norm, net.knot_error);
  return {forms_of<3>(speed, 0, speed_error), forms_of<3>(ruling, 0, ruling_error), forms_of<3>(speed, 3, speed_error)};
}

/// The points of a row on piece k as forms of degree n.
std::optional<RoundedForms<4>> piece_row(const RoundedNet<4>& net, const std::vector<Vec<double, 4>>& points, int k) {
  LocalRow<4> row{net.degree, {}};
  for (int i = 0; i <= net.degree; ++i) {
    for (int j = 0; j < 4; ++j) {
      row.p[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = points[static_cast<std::size_t>(k - 1 + i)][j];
    }
  }
  const double norm = norm_of(row);
  if (!(norm <= largest)) return std::nullopt;
  make_bezier(row, net.knots.data() + (k - 1));
  return forms_of<4>(row, 0, net.coordinate_error + bezier_error(net.degree, norm, net.knot_error));
}

/// dp/ds_0 dp/dt - dp/dt_0 dp/ds, up to a positive constant, along c'.
RoundedForms<3> row_speed(const RoundedForms<4>& p) {
  const int n = p.degree();
  const auto& from = rounding::binomials.inverse[static_cast<std::size_t>(n)];
  const auto& to = rounding::binomials.value[static_cast<std::size_t>(n - 1)];
  RoundedForms<4> s(n - 1);
  RoundedForms<4> t(n - 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    for (int j = 0; j < 4; ++j) {
      s.form(j)[i] = p.form(j)[i] * from[i] * to[i];
      t.form(j)[i] = p.form(j)[i + 1] * from[i + 1] * to[i];
    }
  }
  const double error = p.radius() + 8 * rounding::unit * p.norm();
  s.close(error);
  t.close(error);
  return rounded_minors(s, t);
}

/// A multiple by a power of two with a norm near 1.
std::optional<RoundedForms<3>> normalised(RoundedForms<3> x) {
  if (!(x.norm() >= smallest && x.norm() <= largest)) return std::nullopt;
  const double scale = std::ldexp(1.0, -std::ilogb(x.norm()));
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= x.degree(); ++i) x.at(j, i) *= scale;
  }
  x.close(x.radius() * scale);
  return x;
}

Directions directions(const RoundedNet<4>& net, int k) {
  const std::optional<RoundedForms<4>> p = piece_row(net, net.c, k);
  const std::optional<RoundedForms<4>> q = piece_row(net, net.d, k);
  if (!p || !q) return {};
  return {normalised(row_speed(*p)), normalised(rounded_minors(*p, *q)), normalised(row_speed(*q))};
}

/// x rounded; the error is noted.
double rounded(const Rational& x, double& error) {
  const double nearest = x.to_double();
  if (std::isfinite(nearest) && Rational::from_double(nearest) != x) {
    error = std::max(error, rounding::unit * std::abs(nearest) + rounding::underflow);
  }
  return nearest;
}

/// The relative error of differences of knots with an absolute error each; none where two knots that differ may not be
/// told apart.
std::optional<double> relative_knot_error(const std::vector<double>& knots, double error) {
  double least = detail::infinity;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] > knots[i - 1]) least = std::min(least, knots[i] - knots[i - 1]);
  }
  constexpr double most = 0x1p-30;
  const double width = knots.back() - knots.front();
  if (!(width <= largest && least >= smallest && 2 * error <= most * least)) return std::nullopt;
  return 3 * error / least;
}

/// Scales the coordinates of homogeneous rows by a power of two to the size of the weights, so that one bound of the
/// errors suits both.
void balance(RoundedNet<4>& net, double weight_error) {
  double weight = 0;
  double coordinate = 0;
  for (const auto* row : {&net.c, &net.d}) {
    for (const Vec<double, 4>& x : *row) {
      weight = std::max(weight, std::abs(x[0]));
      coordinate = std::max({coordinate, std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
    }
  }
  const double ratio = coordinate / weight;
  if (!(ratio >= smallest && ratio <= largest)) return;  // the pieces will not be in range
  const double scale = std::ldexp(1.0, -std::ilogb(ratio));
  for (auto* row : {&net.c, &net.d}) {
    for (Vec<double, 4>& x : *row) {
      for (int j = 1; j < 4; ++j) x[j] *= scale;
    }
  }
  net.coordinate_error = std::max(net.coordinate_error * scale, weight_error) + rounding::underflow;
}

}  // namespace

template <int D>
std::optional<RoundedNet<D>> rounded_net(const KnotList<Rational>& u, std::span<const Vec<Rational, D>> c,
                                         std::span<const Vec<Rational, D>> d) {
  if (too_high<D>(u.degree())) return std::nullopt;
  RoundedNet<D> net{u.degree(), {}, {}, {}, 0, 0};
  double knot_error = 0;
  for (int i = 0; i < u.size(); ++i) {
    net.knots.push_back(rounded(u[i] - u.domain_begin(), knot_error));
    if (i > 0 && net.knots[static_cast<std::size_t>(i)] == net.knots[static_cast<std::size_t>(i - 1)] &&
        u[i] != u[i - 1]) {
      return std::nullopt;
    }
  }
  const std::optional<double> relative = relative_knot_error(net.knots, knot_error);
  if (!relative) return std::nullopt;
  net.knot_error = *relative;
  double weight_error = 0;
  const auto copy = [&](std::span<const Vec<Rational, D>> row, std::vector<Vec<double, D>>& into) {
    for (const Vec<Rational, D>& x : row) {
      Vec<double, D> y;
      if constexpr (D == 3) {
        for (int j = 0; j < 3; ++j) y[j] = rounded(x[j] - c[0][j], net.coordinate_error);
      } else {
        y[0] = rounded(x[0], weight_error);
        for (int j = 1; j < 4; ++j) y[j] = rounded(x[j] - x[0] * c[0][j] / c[0][0], net.coordinate_error);
      }
      into.push_back(y);
    }
  };
  copy(c, net.c);
  copy(d, net.d);
  if constexpr (D == 4) balance(net, weight_error);
  return net;
}

template <int D>
std::optional<RoundedNet<D>> rounded_net(const KnotList<double>& u, std::span<const Vec<double, D>> c,
                                         std::span<const Vec<double, D>> d) {
  if (too_high<D>(u.degree())) return std::nullopt;
  const std::optional<double> relative = relative_knot_error(u.list(), 0);
  if (!relative) return std::nullopt;
  RoundedNet<D> net{u.degree(), u.list(), {c.begin(), c.end()}, {d.begin(), d.end()}, *relative, 0};
  if constexpr (D == 4) balance(net, 0);
  return net;
}

template <int D>
std::optional<RoundedQuotient> rounded_quotient(const RoundedNet<D>& net, int k) {
  const Directions f = directions(net, k);
  if (!f.complete()) return std::nullopt;
  const RoundedForms<1> w2 = rounded_dot(*f.w, *f.w);
  const RoundedForms<1> det = rounded_dot(rounded_cross(*f.a, *f.b), *f.w);
  const RoundedForms<1> cosine = rounded_sum(rounded_dot(rounded_dot(*f.a, *f.b), w2), -1,
                                             rounded_dot(rounded_dot(*f.a, *f.w), rounded_dot(*f.b, *f.w)));
  const RoundedForms<1> numerator = rounded_dot(w2, rounded_dot(det, det));
  return RoundedQuotient(numerator, rounded_sum(rounded_dot(cosine, cosine), 1, numerator));
}

template std::optional<RoundedNet<3>> rounded_net<3>(const KnotList<Rational>&, std::span<const Vec<Rational, 3>>,
                                                     std::span<const Vec<Rational, 3>>);
template std::optional<RoundedNet<4>> rounded_net<4>(const KnotList<Rational>&, std::span<const Vec<Rational, 4>>,
                                                     std::span<const Vec<Rational, 4>>);
template std::optional<RoundedNet<3>> rounded_net<3>(const KnotList<double>&, std::span<const Vec<double, 3>>,
                                                     std::span<const Vec<double, 3>>);
template std::optional<RoundedNet<4>> rounded_net<4>(const KnotList<double>&, std::span<const Vec<double, 4>>,
                                                     std::span<const Vec<double, 4>>);
template std::optional<RoundedQuotient> rounded_quotient<3>(const RoundedNet<3>&, int);
template std::optional<RoundedQuotient> rounded_quotient<4>(const RoundedNet<4>&, int);

}  // namespace torse
