#include "torse/studies/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include "torse/developable/condition.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/proofs/random.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/studies/inputs.hpp"

namespace torse::studies {
namespace {

using Q = Rational;
template <class S>
using Points = std::vector<Vec<S, 3>>;

/// A net in doubles.
struct Net {
  KnotList<double> u;
  Points<double> c;
  Points<double> d;
};

using Measure = double (*)(const Net& net, int k, double t);

double length(const Vec<double, 3>& v) { return std::sqrt(dot(v, v)); }

double determinant_at(const Net& net, int k, double t) {
  return std::abs(pointwise_determinant<double>(net.u, net.c, net.d, k, t));
}

/// The determinant over the product of the lengths.
double relative_at(const Net& net, int k, double t) {
  const Vec<double, 3> a = curve_derivative<double, Vec<double, 3>>(net.u, net.c, k, t);
  const Vec<double, 3> b = curve_derivative<double, Vec<double, 3>>(net.u, net.d, k, t);
  const Vec<double, 3> w = difference(curve_point<double, Vec<double, 3>>(net.u, net.d, k, t),
                                      curve_point<double, Vec<double, 3>>(net.u, net.c, k, t));
  const double size = length(a) * length(b) * length(w);
  return size > 0 ? std::abs(det3(b, a, w)) / size : 0;
}

bool below(const Net& net, Measure measure, int samples, double epsilon) {
  for (const int k : net.u.proper_pieces()) {
    const double begin = net.u.piece_begin(k);
    const double end = net.u.piece_end(k);
    for (int i = 0; i < samples; ++i) {
      const double t = begin + (end - begin) * i / (samples - 1);
      if (!(measure(net, k, t) < epsilon)) return false;
    }
  }
  return true;
}

/// The coefficients of the determinant over the product of the largest coefficients of its rows.
bool coefficients_below(const Net& net, double epsilon) {
  for (const int k : net.u.proper_pieces()) {
    const FormMatrix<double, 3> matrix =
        span_matrix<double>(net.u, std::span<const Vec<double, 3>>(net.c), std::span<const Vec<double, 3>>(net.d), k);
    double size = 1;
    for (const auto& row : matrix) {
      double largest = 0;
      for (const BinaryForm<double>& form : row) {
        for (int i = 0; i <= form.degree(); ++i) largest = std::max(largest, std::abs(form[i]));
      }
      size *= largest;
    }
    const BinaryForm<double> det = form_determinant<double>(matrix);
    for (int i = 0; i <= det.degree(); ++i) {
      if (!(std::abs(det[i]) < epsilon * size)) return false;
    }
  }
  return true;
}

/// A naive test.
struct Test {
  std::string name;
  std::function<bool(const Net&)> says_developable;
};

const std::vector<Test>& tests() {
  static const std::vector<Test> list = [] {
    constexpr int dense = 20;
    constexpr int sparse = 3;
    std::vector<Test> made;
    for (const auto& [digits, epsilon] :
         {std::pair("1e-06", 1e-6), std::pair("1e-09", 1e-9), std::pair("1e-12", 1e-12)}) {
      const double e = epsilon;
      const std::string text = digits;
      made.push_back({"fixed " + text, [e](const Net& net) { return below(net, determinant_at, dense, e); }});
      made.push_back({"relative " + text, [e](const Net& net) { return below(net, relative_at, dense, e); }});
      made.push_back({"sampled " + text, [e](const Net& net) { return below(net, relative_at, sparse, e); }});
      made.push_back({"coefficients " + text, [e](const Net& net) { return coefficients_below(net, e); }});
    }
    return made;
  }();
  return list;
}

Vec<Q, 3> integer_point(proofs::Rng& rng) {
  return {Q(rng.between(-9, 9)), Q(rng.between(-9, 9)), Q(rng.between(-9, 9))};
}

/// Integer knots, M* one or two from them, and all coordinates times their common denominator.
struct ExactNet {
  KnotList<Q> u;
  Points<Q> c;
  Points<Q> d;
};

ExactNet draw_net(proofs::Rng& rng, const Levels& levels) {
  const int n = levels.degree();
  std::vector<Q> knots(static_cast<std::size_t>(n), Q(0));
  for (int k = 1; k <= levels.pieces(); ++k) knots.push_back(Q(k));
  knots.insert(knots.end(), static_cast<std::size_t>(n) - 1, Q(levels.pieces()));
  KnotList<Q> u(n, std::move(knots));
  Points<Q> c;
  for (int i = 0; i <= u.last(); ++i) c.push_back(integer_point(rng));
  const Q m(levels.pieces() + 1);
  const Q lambda = m + Q(rng.between(1, 4));
  Points<Q> d = linear_net<Q, Vec<Q, 3>>(u, c, lambda, m, sum(c[0], integer_point(rng)));
  std::vector<Q> coordinates;
  for (const Vec<Q, 3>& x : d) coordinates.insert(coordinates.end(), {x[0], x[1], x[2]});
  const Q common = ScalarTraits<Q>::common_denominator(coordinates);
  for (Points<Q>* row : {&c, &d}) {
    for (Vec<Q, 3>& x : *row) scale(x, common);
  }
  return {std::move(u), std::move(c), std::move(d)};
}

Points<double> in_doubles(const Points<Q>& row, double factor) {
  Points<double> result;
  for (const Vec<Q, 3>& x : row) {
    result.push_back(Vec<double, 3>(x[0].to_double(), x[1].to_double(), x[2].to_double()) * factor);
  }
  return result;
}

Points<Q> exactly(const Points<double>& row) {
  Points<Q> result;
  for (const Vec<double, 3>& x : row) {
    result.push_back(Vec<Q, 3>(Q::from_double(x[0]), Q::from_double(x[1]), Q::from_double(x[2])));
  }
  return result;
}

double size_of(const Net& net) {
  double size = 0;
  for (const Points<double>* row : {&net.c, &net.d}) {
    for (const Vec<double, 3>& x : *row) size = std::max(size, x.cwiseAbs().maxCoeff());
  }
  return size;
}

std::string file_of(const Net& net) {
  const auto number = [](double x) { return '"' + hex_text(x) + '"'; };
  const auto row = [&](const Points<double>& points) {
    std::string text = "{\"points\":[";
    for (const Vec<double, 3>& x : points) {
      text += (text.back() == '[' ? "[" : ",[") + number(x[0]) + "," + number(x[1]) + "," + number(x[2]) + "]";
    }
    return text + "]}";
  };
  std::string knots;
  for (const double u : net.u.list()) knots += (knots.empty() ? "" : ",") + number(u);
  return "{\"torse\":1,\"type\":\"ruled\",\"degree\":" + std::to_string(net.u.degree()) + ",\"knots\":[" + knots +
         "],\"c\":" + row(net.c) + ",\"d\":" + row(net.d) + "}";
}

}  // namespace

std::vector<std::string> verdict_names() {
  std::vector<std::string> names;
  for (const Test& test : tests()) names.push_back(test.name);
  return names;
}

Verdicts judge_case(const Levels& levels, std::uint64_t seed, const std::vector<std::string>& asked) {
  proofs::Rng rng(seed);
  const ExactNet exact = draw_net(rng, levels);
  const double factor = std::exp2(std::round(std::log2(levels[Factor::scale])));
  std::vector<double> knots;
  for (const Q& u : exact.u.list()) knots.push_back(u.to_double());
  Net net{KnotList<double>(exact.u.degree(), knots), in_doubles(exact.c, factor), in_doubles(exact.d, factor)};
  Vec<double, 3>& vertex = net.d[rng.below(net.d.size())];
  vertex[static_cast<int>(rng.below(3))] += levels[Factor::moved] * size_of(net);

  Verdicts verdicts;
  const Points<Q> c = exactly(net.c);
  const Points<Q> d = exactly(net.d);
  verdicts.developable = !find_witness<Q, 3>(exact.u, c, d);
  for (const std::string& name : asked) {
    verdicts.said.push_back(std::ranges::find(tests(), name, &Test::name)->says_developable(net));
  }
  verdicts.net = file_of(net);
  return verdicts;
}

}  // namespace torse::studies
