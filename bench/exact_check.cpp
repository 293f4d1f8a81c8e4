// How the exact answers of torse check and torse recover grow with a rational surface: FJ21.7.1 with n = 3, whose
// numbers get longer from piece to piece.
#include <cstdio>
#include <vector>

#include "side_by_side.hpp"
#include "torse/developable/classify.hpp"
#include "torse/developable/linear_net.hpp"
#include "torse/developable/piece_edge.hpp"
#include "torse/exact/decide/decide.hpp"
#include "torse/exact/decide/singularities.hpp"

namespace {

using torse::Rational;
using Row = torse::Vec<Rational, 4>;
using Piece = torse::PieceFunctions<Rational>;

struct Net {
  torse::KnotList<Rational> u;
  std::vector<Row> p;
  std::vector<Row> q;
};

Rational q(int numerator, int denominator) { return Rational(numerator) / Rational(denominator); }

Net rational_surface(int pieces) {
  constexpr int n = 3;
  std::vector<Rational> knots(n, Rational(0));
  for (int i = 1; i < pieces; ++i) knots.push_back(q(i, pieces));
  knots.insert(knots.end(), n, Rational(1));
  Net net{torse::KnotList<Rational>(n, std::move(knots)), {}, {}};
  for (int i = 0; i <= net.u.last(); ++i) {
    const Rational weight = q(3 + i % 4, 5);
    net.p.emplace_back(weight, weight * Rational(i), weight * q(i * i % 97, 7), weight * q(7 * i % 89, 9));
  }
  net.q = torse::rational_net<Rational, Row>(net.u, net.p, q(-4, 3), Rational(-2), Rational(1),
                                             Row(Rational(1), Rational(0), Rational(0), Rational(2)));
  return net;
}

double megabits(const std::vector<Row>& row) {
  std::size_t bits = 0;
  for (const Row& x : row) {
    for (int j = 0; j < 4; ++j) bits += x[j].numerator_bits() + x[j].denominator_bits();
  }
  return 1e-6 * static_cast<double>(bits);
}

/// The bits of the dependences, of which Lambda, M, sigma are quotients, and of the rows of the edge.
double megabits(const std::vector<Piece>& pieces, const std::vector<torse::EdgeOfRegression<Rational>>& edges) {
  std::size_t bits = 0;
  const auto count = [&](const torse::Polynomial<Rational>& f) {
    for (const Rational& x : f.coefficients()) bits += x.numerator_bits() + x.denominator_bits();
  };
  for (const Piece& piece : pieces) {
    for (const auto* f : {&piece.alpha, &piece.beta, &piece.gamma, &piece.delta}) count(*f);
  }
  for (const auto& edge : edges) {
    for (const auto& f : edge.row) count(f);
  }
  return 1e-6 * static_cast<double>(bits);
}

template <class Run>
double seconds(Run run) {
  const double start = torse::bench::processor_seconds();
  run();
  return torse::bench::processor_seconds() - start;
}

}  // namespace

int main() {
  std::puts("## Exact answers for a rational surface, n = 3\n");
  std::puts(
      "| pieces | net, Mbit | decision | class | functions and edge | singularities | output, Mbit | time per "
      "Mbit of output |");
  std::puts("|--:|--:|--:|--:|--:|--:|--:|--:|");
  bool right = true;
  for (const int pieces : {10, 100, 300, 1000}) {
    const Net net = rational_surface(pieces);
    bool developable = false, tangent = false, regular = false;
    std::vector<Piece> functions;
    std::vector<torse::EdgeOfRegression<Rational>> edges;
    const double decision = seconds([&] { developable = !torse::find_witness_over_q<4>(net.u, net.p, net.q); });
    const double classified =
        seconds([&] { tangent = torse::classify<Rational>(net.u, net.p, net.q).kind == torse::SurfaceClass::tangent; });
    const double recovered = seconds([&] {
      functions = torse::recover_pieces<Rational>(net.u, net.p, net.q);
      for (const Piece& piece : functions) edges.push_back(*torse::edge_of(piece));
    });
    const double singular = seconds([&] { regular = torse::find_singularities(functions).empty(); });
    right = right && developable && tangent && regular;
    const double output = megabits(functions, edges);
    const auto readable = [](double x) { return torse::bench::readable(x); };
    std::printf("| %d | %.3g | %s | %s | %s | %s | %.3g | %s |\n", pieces, megabits(net.p) + megabits(net.q),
                readable(decision).c_str(), readable(classified).c_str(), readable(recovered).c_str(),
                readable(singular).c_str(), output, readable((recovered + singular) / output).c_str());
    std::fflush(stdout);
  }
  torse::bench::goal("Every surface is a regular tangent surface", right);
}
