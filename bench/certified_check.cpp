// Is a surface developable up to 0.5 degrees? torse's certificate against a plain test in doubles: the normalised
// determinant [c', d', d - c] at 100 parameters, which says nothing about what lies between them, and against the
// Gaussian curvature at 100 parameters by OpenCASCADE and SISL.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "curvature_peers.hpp"
#include "side_by_side.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/warp/max_warp.hpp"

namespace {

using torse::Rational;
using Point = torse::Vec<double, 3>;

struct Net {
  torse::KnotList<double> u;
  std::vector<Point> c;
  std::vector<Point> d;
};

/// FJ07.13 with n = 3 and 8 pieces, rounded to doubles; every third point of the second row moved by `twist`.
Net rounded_net(double twist) {
  const int n = 3, pieces = 8;
  std::vector<Rational> knots(3, Rational(0));
  for (int i = 1; i < pieces; ++i) knots.push_back(Rational(i) / Rational(pieces));
  knots.insert(knots.end(), 3, Rational(1));
  const torse::KnotList<Rational> u(n, knots);
  std::vector<torse::Vec<Rational, 3>> c;
  for (int i = 0; i <= u.last(); ++i) {
    c.emplace_back(Rational(i), Rational(i * i) / Rational(7), Rational(i * (10 - i)) / Rational(9));
  }
  const auto d = torse::linear_net<Rational, torse::Vec<Rational, 3>>(
      u, c, Rational(4), Rational(3), torse::Vec<Rational, 3>(Rational(0), Rational(6), Rational(1)));
  std::vector<double> plain;
  for (const Rational& x : knots) plain.push_back(x.to_double());
  Net net{torse::KnotList<double>(n, plain), {}, {}};
  const auto point = [](const torse::Vec<Rational, 3>& x) {
    return Point(x[0].to_double(), x[1].to_double(), x[2].to_double());
  };
  for (std::size_t i = 0; i < c.size(); ++i) {
    net.c.push_back(point(c[i]));
    net.d.push_back(point(d[i]));
    if (i % 3 == 1) net.d.back()[2] += twist;
  }
  return net;
}

/// The cubic basis functions that do not vanish on [t_2, t_3] of six knots, and their derivatives.
void cubic_basis(const double* t, double x, Eigen::Vector4d& value, Eigen::Vector4d& slope) {
  const double a = 1 / (t[3] - t[2]);
  const double l1 = (t[3] - x) * a, r1 = (x - t[2]) * a;
  const double b0 = 1 / (t[3] - t[1]), b1 = 1 / (t[4] - t[2]);
  const double q0 = (t[3] - x) * b0 * l1;
  const double q1 = (x - t[1]) * b0 * l1 + (t[4] - x) * b1 * r1;
  const double q2 = (x - t[2]) * b1 * r1;
  const double c0 = 1 / (t[3] - t[0]), c1 = 1 / (t[4] - t[1]), c2 = 1 / (t[5] - t[2]);
  value << (t[3] - x) * c0 * q0, (x - t[0]) * c0 * q0 + (t[4] - x) * c1 * q1,
      (x - t[1]) * c1 * q1 + (t[5] - x) * c2 * q2, (x - t[2]) * c2 * q2;
  slope << -3 * c0 * q0, 3 * (c0 * q0 - c1 * q1), 3 * (c1 * q1 - c2 * q2), 3 * c2 * q2;
}

constexpr int parameters = 100;

double parameter(const Net& net, int i) {
  const double from = net.u.domain_begin(), to = net.u.domain_end();
  return from + (to - from) * i / (parameters - 1);
}

/// The largest [c', d', d - c]^2 / (|c'| |d'| |d - c|)^2 at 100 parameters.
double largest_determinant_squared(const Net& net) {
  double worst = 0;
  int k = 1;
  for (int i = 0; i < parameters; ++i) {
    const double x = parameter(net, i);
    while (k < net.u.pieces() && x > net.u.piece_end(k)) ++k;
    Eigen::Vector4d value, slope;
    cubic_basis(net.u.list().data() + (k - 1), x, value, slope);
    Eigen::Vector3d c = Eigen::Vector3d::Zero(), dc = c, d = c, dd = c;
    for (int j = 0; j < 4; ++j) {
      const std::size_t at = static_cast<std::size_t>(k - 1 + j);
      c += value[j] * net.c[at];
      dc += slope[j] * net.c[at];
      d += value[j] * net.d[at];
      dd += slope[j] * net.d[at];
    }
    const Eigen::Vector3d w = d - c;
    const double det = dc.dot(dd.cross(w));
    worst = std::max(worst, det * det / (dc.squaredNorm() * dd.squaredNorm() * w.squaredNorm()));
  }
  return worst;
}

/// Whether it is at most sin^2 0.5 degrees.
bool plain_test(const Net& net) {
  constexpr double limit = 0.00872653549837393;
  return largest_determinant_squared(net) <= limit * limit;
}

/// The largest |K| at 100 parameters.
template <class Surface>
double largest_curvature(Surface& surface, const Net& net) {
  double worst = 0;
  for (int i = 0; i < parameters; ++i) worst = std::max(worst, std::abs(surface.curvature(parameter(net, i))));
  return worst;
}

torse::WarpEnclosure warp_of(const Net& net) { return torse::max_warp<double, 3>(net.u, net.c, net.d); }

/// Adds a contender that samples the curvature of a surface that is there already, and says if it is missing.
template <class Surface>
void add_peer(std::vector<torse::bench::Contender>& contenders, const char* name, Surface& surface, const Net& net) {
  contenders.push_back({name, [&] { return largest_curvature(surface, net) < 1; }});
}

/// The decision of torse, first, and the plain test and the peers beside it. Whether the peers take 6 times as long.
bool compare_with_peers() {
  const Net net = rounded_net(1e-3);
  const torse::Angle half{Rational(1) / Rational(2)};
  std::vector<torse::bench::Contender> contenders{
      {"torse, at most 0.5 degrees",
       [&] { return torse::warp_at_most<double, 3>(net.u, net.c, net.d, half) == torse::Truth::yes; }},
      {"plain test, not certified", [&] { return plain_test(net); }}};
#ifdef TORSE_BENCH_OCCT
  torse::bench::OcctSurface occt(net.u, net.c, net.d);
  add_peer(contenders, "OpenCASCADE, K at 100 parameters", occt, net);
#else
  std::puts("OpenCASCADE was not found when this was built.\n");
#endif
#ifdef TORSE_BENCH_SISL
  torse::bench::SislSurface sisl(net.u, net.c, net.d);
  add_peer(contenders, "SISL, K at 100 parameters", sisl, net);
#else
  std::puts("SISL was not found when this was built.\n");
#endif
  print_head("n = 3, 8 pieces", contenders);
  const auto timings = compare("in brackets: ratio to torse", contenders);
  return std::all_of(timings.begin() + 2, timings.end(), [](const auto& peer) { return peer.ratio >= 6; });
}

/// What an absolute tolerance on the curvature accepts, and that it depends on the unit of length.
void show_absolute_tolerance() {
  std::puts("\nAn absolute tolerance of 1e-12 on |K|, at 100 parameters:\n");
  std::puts(
      "| surface | normalised determinant | OpenCASCADE | SISL | torse: warp in degrees |\n|---|--:|--:|--:|--:|");
  const auto verdict = [](double k) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2g, %s", k, k <= 1e-12 ? "accepted" : "refused");
    return std::string(text);
  };
  for (const auto& [twist, scale] : {std::pair{3e-6, 1.0}, {1e-3, 1.0}, {1e-3, 1000.0}, {1.0, 1e6}}) {
    Net net = rounded_net(twist);
    for (auto* row : {&net.c, &net.d}) {
      for (Point& x : *row) x *= scale;
    }
    std::string occt = "not there", sisl = occt;
#ifdef TORSE_BENCH_OCCT
    torse::bench::OcctSurface first(net.u, net.c, net.d);
    occt = verdict(largest_curvature(first, net));
#endif
#ifdef TORSE_BENCH_SISL
    torse::bench::SislSurface second(net.u, net.c, net.d);
    sisl = verdict(largest_curvature(second, net));
#endif
    const torse::WarpEnclosure warp = warp_of(net);
    std::printf("| twist %g, size %g | %.2g | %s | %s | %.4g to %.4g |\n", twist, scale,
                std::sqrt(largest_determinant_squared(net)), occt.c_str(), sisl.c_str(), warp.lower, warp.upper);
  }
}

}  // namespace

int main() {
  using torse::Truth;
  using torse::bench::Contender;
  std::puts("## Certified check in doubles\n");
  std::puts("n = 3, 8 pieces. In brackets: ratio to the plain test at 100 parameters.\n");
  const torse::Angle half{Rational(1) / Rational(2)};
  bool all = true;
  bool first = true;
  for (const double twist : {0.0, 1e-9, 1e-3, 1e-2}) {
    const Net net = rounded_net(twist);
    const std::vector<Contender> contenders{
        {"plain test, not certified", [&] { return plain_test(net); }},
        {"torse, at most 0.5 degrees",
         [&] { return torse::warp_at_most<double, 3>(net.u, net.c, net.d, half) == Truth::yes; }},
        {"torse, enclosure to 1e-3", [&] { return torse::max_warp<double, 3>(net.u, net.c, net.d).complete; }}};
    if (first) print_head("case", contenders);
    first = false;
    const torse::WarpEnclosure warp = warp_of(net);
    char name[128];
    std::snprintf(name, sizeof name, "warp %.3g to %.3g degrees (%s, %ld intervals)", warp.lower, warp.upper,
                  std::string(name_of(warp.stage)).c_str(), warp.intervals);
    all = compare(name, contenders)[1].ratio <= 1.5 && all;
  }
  torse::bench::goal("Goal: the certified decision at most 1.5 times the plain test in every case", all);

  std::puts(
      "\nThe decision against the Gaussian curvature at 100 parameters, in doubles, of surfaces built beforehand:\n");
  const bool faster = compare_with_peers();
  torse::bench::goal("Goal: at least 6 times faster than each of the peers", faster);
  show_absolute_tolerance();
}
