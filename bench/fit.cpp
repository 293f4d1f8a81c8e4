// The most developable surface between two rails: torse's fit against the method of BZZ19, on 100 drawn pairs of rails.
#include "torse/quasi/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "rail_pairs.hpp"
#include "side_by_side.hpp"
#include "torse/quasi/paper_fit.hpp"
#include "twist_search.hpp"

namespace {

using torse::Mapping;
using torse::bench::goal;
using torse::bench::median;
using torse::quasi::Ends;
using torse::quasi::Rails;

constexpr int pairs = 100;
constexpr int degree = 2;
constexpr int coefficients = 50;

/// Rulings at which every result is measured: none of them is a sample of a fit.
constexpr std::size_t rulings = 2000;

/// Timed runs of each method on each pair, after one that warms up.
constexpr int runs = 3;

/// Parameters on the second rail that the search for the least twist chooses among.
constexpr int candidates = 400;

torse::KnotList<double> even_knots() {
  std::vector<double> breaks;
  for (int i = 0; i <= coefficients - degree; ++i) breaks.push_back(static_cast<double>(i) / (coefficients - degree));
  return torse::quasi::mapping_knots(degree, breaks);
}

/// The mapping with these coefficients, none of them beyond the rail: the literal formula leaves the last ones free.
Mapping<double> on_the_rail(const torse::KnotList<double>& knots, std::vector<double> beta) {
  for (double& b : beta) b = std::clamp(b, 0.0, 1.0);
  return torse::mapping_of(knots, beta);
}

/// The polyline through values at evenly spaced parameters.
Mapping<double> polyline(const std::vector<double>& values) {
  std::vector<double> knots;
  const double last = static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) knots.push_back(static_cast<double>(i) / last);
  return on_the_rail({1, knots}, values);
}

/// A way to find a mapping.
struct Method {
  std::string name;
  std::function<Mapping<double>(const Rails&, Ends)> fit;
};

Mapping<double> baseline(const Rails& rails, Ends ends) {
  torse::quasi::PaperOptions options;
  options.ends = ends;
  const torse::KnotList<double> knots = even_knots();
  return on_the_rail(knots, torse::quasi::paper_fit(rails, knots, options).beta);
}

Mapping<double> discrete(const Rails& rails, Ends ends) {
  torse::quasi::PaperOptions options;
  options.ends = ends;
  options.samples = coefficients;
  return polyline(torse::quasi::discrete_fit(rails, options).beta);
}

Mapping<double> twist_search(const Rails& rails, Ends ends) {
  return polyline(torse::bench::least_twist(rails, coefficients, candidates, ends));
}

Mapping<double> ours(const Rails& rails, Ends ends, bool adaptive) {
  torse::quasi::FitOptions options;
  options.degree = degree;
  options.coefficients = coefficients;
  options.ends = ends;
  options.adaptive = adaptive;
  return torse::quasi::fit_rails(rails, options).mapping;
}

/// The baseline first, and once more as a control of the times.
std::vector<Method> methods() {
  return {{"BZZ19, L-BFGS", baseline},
          {"BZZ19 again", baseline},
          {"torse, even knots", [](const Rails& r, Ends e) { return ours(r, e, false); }},
          {"torse, adaptive knots", [](const Rails& r, Ends e) { return ours(r, e, true); }},
          {"BZZ19, discrete mapping", discrete},
          {"least twist, 50 rulings", twist_search},
          {"T = t", [](const Rails&, Ends) { return torse::identity_mapping(even_knots()); }}};
}

/// What a method made of a pair.
struct Outcome {
  double warp;     ///< mean, degrees
  double seconds;  ///< median of the runs
};

/// Outcomes by method, then pair.
using Outcomes = std::vector<std::vector<Outcome>>;

/// The methods run in turn on each pair.
Outcomes measure(const std::vector<Method>& methods, Ends ends) {
  Outcomes outcomes(methods.size());
  for (int id = 0; id < pairs; ++id) {
    const Rails rails = torse::bench::draw_rails(id);
    std::vector<std::vector<double>> seconds(methods.size());
    for (const Method& method : methods) {
      const Mapping<double> sigma = method.fit(rails, ends);
      outcomes[static_cast<std::size_t>(&method - methods.data())].push_back(
          {torse::quasi::warp_statistics(rails, sigma, rulings).mean, 0});
    }
    for (int run = 0; run < runs; ++run) {
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const double start = torse::bench::processor_seconds();
        methods[m].fit(rails, ends);
        seconds[m].push_back(torse::bench::processor_seconds() - start);
      }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) outcomes[m].back().seconds = median(seconds[m]);
  }
  return outcomes;
}

/// A method against another one, pair by pair.
struct Comparison {
  double warp_ratio = 0;  ///< geometric mean
  int better = 0;
  int worse = 0;          ///< by more than 1 percent
  double seconds = 0;     ///< median
  double time_ratio = 0;  ///< median of the ratios
};

Comparison compare(const std::vector<Outcome>& mine, const std::vector<Outcome>& other) {
  Comparison comparison;
  std::vector<double> seconds, ratios;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    comparison.warp_ratio += std::log(mine[i].warp / other[i].warp) / static_cast<double>(mine.size());
    comparison.better += mine[i].warp < other[i].warp;
    comparison.worse += mine[i].warp > 1.01 * other[i].warp;
    seconds.push_back(mine[i].seconds);
    ratios.push_back(mine[i].seconds / other[i].seconds);
  }
  comparison.warp_ratio = std::exp(comparison.warp_ratio);
  comparison.seconds = median(seconds);
  comparison.time_ratio = median(ratios);
  return comparison;
}

/// One row for each method, compared with the first one.
void print_table(const std::vector<Method>& methods, const Outcomes& outcomes) {
  std::puts("| method | mean warp, ratio | better on | worse on | median time | median ratio of times |");
  std::puts("|---|--:|--:|--:|--:|--:|");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Comparison c = compare(outcomes[m], outcomes[0]);
    std::printf("| %s | %.3f | %d | %d | %s | %.3g |\n", methods[m].name.c_str(), c.warp_ratio, c.better, c.worse,
                torse::bench::readable(c.seconds).c_str(), c.time_ratio);
  }
}

/// The ratios of the mean warp of both fits of torse, kind by kind.
void print_kinds(const std::vector<Method>& methods, const Outcomes& outcomes) {
  std::printf("\n| mean warp, ratio to %s |", methods[0].name.c_str());
  for (const char* kind : torse::bench::rail_kinds) std::printf(" %s |", kind);
  std::puts("\n|---|--:|--:|--:|--:|--:|");
  for (std::size_t m = 2; m < methods.size(); ++m) {
    std::printf("| %s |", methods[m].name.c_str());
    for (std::size_t kind = 0; kind < torse::bench::rail_kinds.size(); ++kind) {
      std::vector<Outcome> mine, other;
      for (std::size_t id = kind; id < outcomes[m].size(); id += torse::bench::rail_kinds.size()) {
        mine.push_back(outcomes[m][id]);
        other.push_back(outcomes[0][id]);
      }
      std::printf(" %.3f |", compare(mine, other).warp_ratio);
    }
    std::puts("");
  }
}

}  // namespace

int main() {
  std::puts("## The most developable surface between two rails\n");
  std::array<double, 1> load{};
  getloadavg(load.data(), 1);
  std::printf("Load %.1f. ", load[0]);
  std::printf("%d pairs of rails, mappings of degree %d with %d coefficients; mean warp over %zu rulings.\n", pairs,
              degree, coefficients, rulings);
  const std::vector<Method> contenders = methods();
  for (const Ends ends : {Ends::fixed, Ends::free}) {
    const Outcomes outcomes = measure(contenders, ends);
    std::printf("\n%s ends, against %s:\n\n", ends == Ends::fixed ? "Fixed" : "Free", contenders[0].name.c_str());
    print_table(contenders, outcomes);
    print_kinds(contenders, outcomes);
    for (const std::size_t m : {std::size_t{2}, std::size_t{3}}) {
      const Comparison c = compare(outcomes[m], outcomes[0]);
      const bool met = c.warp_ratio <= 0.85 && c.better >= 90 && c.worse == 0 &&
                       c.seconds <= 0.1 * compare(outcomes[0], outcomes[0]).seconds;
      goal("Goal, " + contenders[m].name +
               ": ratio of the mean warp at most 0.85, better on 90, worse by more than 1 % " +
               "on none, a tenth of the median time",
           met);
    }
  }
}
