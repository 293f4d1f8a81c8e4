// A CAD team points the generators at its own kernel: nets that know whether they are developable, drawn and shrunk by
// RapidCheck. The kernel's test below samples normalised determinants and compares them with a tolerance.
#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <sstream>

#include "torse/exact/decide/decide.hpp"
#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/rapidcheck.hpp"

namespace {

using Net = torse::fuzz::Net<3>;
using Vector = torse::Vec<double, 3>;

Vector rounded(const torse::Vec<torse::Rational, 3>& x) {
  return {x[0].to_double(), x[1].to_double(), x[2].to_double()};
}

/// The kernel: one Bezier piece, flat enough at 21 parameters.
bool kernel_says_developable(const Net& net, double tolerance) {
  const auto at = [](std::vector<Vector> row, double t, bool derivative) {
    for (std::size_t left = row.size() - 1; left > (derivative ? 1U : 0U); --left) {
      for (std::size_t i = 0; i < left; ++i) row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
    return derivative ? Vector(row[1] - row[0]) : row[0];
  };
  std::vector<Vector> c, d;
  for (const auto& x : net.c) c.push_back(rounded(x));
  for (const auto& x : net.d) d.push_back(rounded(x));
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const Vector u = at(c, t, true), v = at(d, t, true), w = at(d, t, false) - at(c, t, false);
    const double size = u.norm() * v.norm() * w.norm();
    if (size > 0 && std::abs(u.cross(v).dot(w)) > tolerance * size) return false;
  }
  return true;
}

/// Whether a test agrees with the truth on nets of one Bezier piece; RapidCheck prints the simplest net where not.
template <class Test>
bool agrees(const char* what, const Test& test) {
  return rc::check(what, [&] {
    const torse::fuzz::Scale one_piece{3, 1, 12};
    const Net net = *torse::fuzz::gen(torse::fuzz::draw_net, one_piece);
    RC_PRE(net.knots.pieces() == 1 && definitely(net.knots.clamped()));
    RC_ASSERT(test(net) == net.developable);
  });
}

}  // namespace

int main() {
  std::ostringstream log;
  std::streambuf* const errors = std::cerr.rdbuf(log.rdbuf());
  const bool exact = agrees("the exact decision",
                            [](const Net& net) { return !torse::find_witness_over_q<3>(net.knots, net.c, net.d); });
  const bool sampled = agrees("samples", [](const Net& net) { return kernel_says_developable(net, 1e-6); });
  std::cerr.rdbuf(errors);
  std::cout << "the exact decision is right: " << exact << "\nsamples are: " << sampled << '\n';
  std::cout << "the net they get wrong was shrunk: " << (log.str().find("\"knots\"") != std::string::npos) << '\n';
}
