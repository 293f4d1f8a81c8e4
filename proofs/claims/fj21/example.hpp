// FJ21, section 8: the worked example.
//   E8     every printed fraction
#pragma once

#include <vector>

#include "torse/proofs/claim.hpp"
#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse::proofs::fj21 {

/// FJ21.E8: all printed numbers of section 8, from c, its weights, d_0, d_1, omega_0, omega_1.
struct E8 {
  static constexpr PointKind points = PointKind::space;
  static constexpr int dimension = 4;
  static const ClaimInfo& info() {
    static const ClaimInfo info{
        .id = "FJ21.E8",
        .source = "section 8",
        .title = "worked example",
        .statement = R"(\Lambda=-\tfrac43,\ M=-2,\ \sigma=1,\ d_2=(\tfrac32,\tfrac{21}{22},\tfrac{135}{22}),\
d_3=(\tfrac{293}{172},-\tfrac{189}{172},\tfrac{1215}{172}),\ v(t)=\tfrac32t+3,\ \dots)",
        .kind = Kind::example,
        .hypotheses = {},
        .mutants = {"w_2 = 2/5", "b = 3", "g = 1 - t/4", "omega_0 = 2"},
        .min_degree = 3,
        .max_degree = 3,
        .max_pieces = 1,
        .remark =
            "Lam, M, sigma are recovered from the dependence of the first cell's four rows. All printed fractions are "
            "right."};
    return info;
  }

  template <class S, class P>
  struct In {};

  template <class S, class P>
  static In<S, P> draw(Source<S>&, Size) {
    return {};
  }

  template <class S, class P>
  static NonZero<S> nonzero(const In<S, P>&) {
    return {};
  }

  template <class S, class P>
  static void residual(const In<S, P>&, Mutant mutant, Equations<S>& equations) {
    Section8Data<S> data;
    if (mutant.is(1)) data.w[2] = ratio<S>(2, 5);
    if (mutant.is(2)) data.b = from_int<S>(3);
    if (mutant.is(3)) data.g.slope = ratio<S>(-1, 4);
    if (mutant.is(4)) data.omega0 = from_int<S>(2);
    for (const ExampleValue<S>& value : section8(data)) {
      for (std::size_t i = 0; i < value.computed.size(); ++i) {
        equations.equal(value.computed[i], fraction<S>(value.printed[i]));
      }
    }
  }
};

}  // namespace torse::proofs::fj21
