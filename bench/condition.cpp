// The condition of developability of the nets of FJ07.13, proved with every knot, L*, M*, t and control point symbolic,
// for all degrees and numbers of pieces up to 5.
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.hpp"
#include "torse/algebra/dependence.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/exact/symbolic/rational_function.hpp"

namespace {

using torse::RationalFunction;
using Form = torse::Form<RationalFunction>;

/// Whether c_0^{n-1}, c_1^{n-1}, d_0^{n-1}, d_1^{n-1} are dependent on every piece for all control points.
bool prove(int n, int pieces) {
  const int last = n + pieces - 1;
  std::vector<std::string> names{"L", "M", "t"};
  for (int i = 0; i < last + n; ++i) names.push_back("u" + std::to_string(i));
  const torse::SymbolicContext context(names);
  std::vector<RationalFunction> knots;
  for (int i = 0; i < last + n; ++i) knots.push_back(context.variable(3 + i));
  const torse::KnotList<RationalFunction> u(n, std::move(knots));
  std::vector<Form> c;
  for (int i = 0; i <= last; ++i) c.push_back(Form::generator(i));
  const std::vector<Form> d = torse::linear_net<RationalFunction, Form>(u, c, context.variable(0), context.variable(1),
                                                                        Form::generator(last + 1));
  for (int k = 1; k <= pieces; ++k) {
    const auto [c0, c1] = torse::last_pair<RationalFunction, Form>(u, c, k, context.variable(2));
    const auto [d0, d1] = torse::last_pair<RationalFunction, Form>(u, d, k, context.variable(2));
    for (const RationalFunction& rest : torse::dependence_residual(std::array<Form, 4>{c0, c1, d0, d1})) {
      if (!rest.is_zero()) return false;
    }
  }
  return true;
}

}  // namespace

int main() {
  std::puts("## The determinant condition of FJ07.13 proved, everything symbolic\n");
  std::puts("| n | N = 1 | N = 2 | N = 3 | N = 4 | N = 5 |\n|---|--:|--:|--:|--:|--:|");
  double total = 0;
  for (int n = 1; n <= 5; ++n) {
    std::printf("| %d |", n);
    for (int pieces = 1; pieces <= 5; ++pieces) {
      const double seconds = torse::bench::seconds_of({"proof", [&] { return prove(n, pieces); }}, 1);
      total += seconds;
      std::printf(" %s |", torse::bench::readable(seconds).c_str());
      std::fflush(stdout);
    }
    std::puts("");
  }
  std::printf("\nTotal, each proof once: %s\n", torse::bench::readable(total).c_str());
  torse::bench::goal("Goal: all n <= 5, N <= 5 in less than a minute", total < 60);
}
