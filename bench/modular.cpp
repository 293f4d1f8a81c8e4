// FJ07.16 against FJ07.13 at random points modulo a 61-bit prime, n = 3, L = 10, all vertices: the library over Batch
// against a loop written by hand over blocks of 64 points, with one inversion a block, and with one for each division.
#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "side_by_side.hpp"
#include "torse/developable/closed_forms.hpp"
#include "torse/exact/modular/batch.hpp"
#include "torse/proofs/random.hpp"

namespace {

using torse::Batch;
using torse::Modulus;
using Point = torse::Vec<Batch, 1>;
using Block = std::array<std::uint64_t, Batch::lanes>;

constexpr int degree = 3;
constexpr int last = 10;
constexpr std::size_t lanes = Batch::lanes;

/// 64 random inputs, the same for all contenders.
struct Input {
  std::array<Block, last + degree> u;
  std::array<Block, last + 1> c;
  Block d0, lambda, m;

  Input(const Modulus& p, torse::proofs::Rng& rng) {
    const auto fill = [&](Block& block) {
      for (std::uint64_t& x : block) x = p.draw(rng);
    };
    for (Block& block : u) fill(block);
    for (Block& block : c) fill(block);
    for (Block* block : {&d0, &lambda, &m}) fill(*block);
  }
};

/// Whether the library's two ways agree at every vertex and every point.
bool with_torse(const Modulus& p, const Input& in) {
  const auto batch = [&](const Block& x) {
    return Batch(p, [&](int i) { return p.decode(x[static_cast<std::size_t>(i)]); });
  };
  std::vector<Batch> knots;
  for (const Block& x : in.u) knots.push_back(batch(x));
  const torse::KnotList<Batch> u(degree, std::move(knots));
  std::vector<Point> c;
  for (const Block& x : in.c) c.push_back(Point(batch(x)));
  const Point d0(batch(in.d0));
  const Batch lambda = batch(in.lambda);
  const Batch m = batch(in.m);
  const std::vector<Point> d = torse::linear_net<Batch, Point>(u, c, lambda, m, d0);
  const std::vector<Point> rulings = torse::eq16_rulings<Batch, Point>(u, c, lambda, m, d0);
  for (std::size_t vertex = 1; vertex <= last; ++vertex) {
    Point rest = torse::difference(d[vertex], c[vertex]);
    torse::subtract(rest, rulings[vertex - 1]);
    if (rest[0].nonzero() != 0) return false;
  }
  return true;
}

/// 1/x for all of them by one inversion.
void invert(const Modulus& p, std::vector<std::uint64_t>& x) {
  std::vector<std::uint64_t> before(x.size());
  std::uint64_t product = p.one();
  for (std::size_t i = 0; i < x.size(); ++i) {
    before[i] = product;
    product = p.multiply(product, x[i]);
  }
  std::uint64_t inverse = p.inverse(product);
  for (std::size_t i = x.size(); i-- > 0;) {
    const std::uint64_t factor = p.multiply(inverse, before[i]);
    inverse = p.multiply(inverse, x[i]);
    x[i] = factor;
  }
}

/// The two ways for one lane, given 1 / (M* - u_i) for i = 0 ... L-1.
bool agrees(const Modulus& p, const Input& in, std::size_t lane, const std::array<std::uint64_t, last>& over) {
  const auto u = [&](int i) { return in.u[static_cast<std::size_t>(i)][lane]; };
  const auto c = [&](int i) { return in.c[static_cast<std::size_t>(i)][lane]; };
  const std::uint64_t lambda = in.lambda[lane];
  const std::uint64_t m = in.m[lane];
  const std::uint64_t gap = p.subtract(lambda, m);
  std::uint64_t d = in.d0[lane];
  for (int vertex = 1; vertex <= last; ++vertex) {
    const int i = vertex - 1;
    const std::uint64_t sum =
        p.add(p.multiply(p.subtract(u(i + degree), lambda), c(i)),
              p.add(p.multiply(p.subtract(lambda, u(i)), c(i + 1)), p.multiply(p.subtract(m, u(i + degree)), d)));
    d = p.multiply(sum, over[static_cast<std::size_t>(i)]);
    std::uint64_t total = 0;
    std::uint64_t product = p.one();
    for (int j = i; j >= 0; --j) {
      const std::uint64_t factor = p.multiply(product, over[static_cast<std::size_t>(j)]);
      total = p.add(total, p.multiply(factor, p.subtract(c(j + 1), c(j))));
      product = p.multiply(factor, p.subtract(m, u(j + degree)));
    }
    const std::uint64_t ruling = p.add(p.multiply(gap, total), p.multiply(product, p.subtract(in.d0[lane], c(0))));
    if (p.subtract(d, c(vertex)) != ruling) return false;
  }
  return true;
}

bool by_hand(const Modulus& modulus, const Input& in) {
  const Modulus p = modulus;
  std::vector<std::uint64_t> over(last * lanes);
  for (std::size_t i = 0; i < last; ++i) {
    for (std::size_t lane = 0; lane < lanes; ++lane) over[i * lanes + lane] = p.subtract(in.m[lane], in.u[i][lane]);
  }
  invert(p, over);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::array<std::uint64_t, last> mine;
    for (std::size_t i = 0; i < last; ++i) mine[i] = over[i * lanes + lane];
    if (!agrees(p, in, lane, mine)) return false;
  }
  return true;
}

/// Every division inverts its own divisor: once in a step of the recursion, once in a term of the closed form.
bool plain_division(const Modulus& modulus, const Input& in) {
  const Modulus p = modulus;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::array<std::uint64_t, last> over;
    for (int vertex = 1; vertex <= last; ++vertex) {
      for (int i = 0; i < vertex; ++i) {
        const std::size_t at = static_cast<std::size_t>(i);
        over[at] = p.inverse(p.subtract(in.m[lane], in.u[at][lane]));
      }
    }
    if (!agrees(p, in, lane, over)) return false;
  }
  return true;
}

}  // namespace

int main() {
  using torse::bench::Contender;
  torse::proofs::Rng rng(1);
  const Modulus p = torse::random_prime(rng);
  const Input in(p, rng);
  std::puts("## Modular engine, n = 3, L = 10: FJ07.16 at every vertex of 64 random points\n");
  std::puts("In brackets: ratio to torse.\n");
  const std::vector<Contender> contenders{{"torse, Batch", [&] { return with_torse(p, in); }},
                                          {"by hand, one inversion a block", [&] { return by_hand(p, in); }},
                                          {"by hand, plain division", [&] { return plain_division(p, in); }}};
  print_head("case", contenders);
  const std::vector<torse::bench::Timing> timings = compare("64 points", contenders);
  std::printf("\nPoints per second:");
  for (std::size_t i = 0; i < timings.size(); ++i) {
    std::printf(" %s %.3g%s", contenders[i].name.c_str(), lanes / timings[i].seconds,
                i + 1 < timings.size() ? "," : ".\n");
  }
  torse::bench::goal("Goal: at least half of the points per second of the loop by hand", timings[1].ratio >= 0.5);
}
