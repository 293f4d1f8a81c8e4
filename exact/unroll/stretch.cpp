// Polynomials as balls.
#include "torse/exact/unroll/stretch.hpp"

#include <algorithm>
#include <utility>

namespace torse {
namespace {

using Q = Rational;

/// The parameters 0, 1, the marks in between, and both ends of every break.
std::vector<Q> cuts_of(const PieceStrip& strip, const std::vector<Q>& marks) {
  std::vector<Q> cuts{Q(0), Q(1)};
  for (const Q& t : marks) {
    const Q tau = (t - strip.begin) / (strip.end - strip.begin);
    const bool in_break =
        std::ranges::any_of(strip.breaks, [&](const RealRoot& x) { return x.lower < tau && tau < x.upper; });
    if (tau > Q(0) && tau < Q(1) && !in_break) cuts.push_back(tau);
  }
  for (const RealRoot& x : strip.breaks) cuts.insert(cuts.end(), {x.lower, x.upper});
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace

Stretch::Stretch(const StripForms<Q>& forms, Q from, Q to, bool breaking)
    : from_(std::move(from)), to_(std::move(to)), breaking_(breaking) {
  const StripForms<Q> f = oriented(forms, (from_ + to_) / Q(2));
  int degree = 0;
  f.terms.transformed([&](const Polynomial<Q>& g) { return degree = std::max(degree, g.degree()); });
  bits_ = 192 + 4 * degree;
  terms_ = f.terms.transformed([&](const Polynomial<Q>& g) { return arb::to_poly(g, bits_); });
  for_rates_ = terms_;
  for (arb::RealPoly* g : {&for_rates_.spin2, &for_rates_.fold}) *g = arb::RealPoly();
}

Strip<DiscBall> Stretch::at(const arb::Complex& tau) const {
  return terms_.transformed([&](const arb::RealPoly& f) {
    DiscBall x{{}, bits_};
    arb_poly_evaluate_acb(x.value.get(), f.get(), tau.get(), bits_);
    return x;
  });
}

Strip<arb::RealPoly> Stretch::around(const arb::Real& middle) const {
  return for_rates_.transformed([&](const arb::RealPoly& f) {
    arb::RealPoly g;
    arb_poly_taylor_shift(g.get(), f.get(), middle.get(), bits_);
    return g;
  });
}

arb::Real Stretch::ruling(const Q& tau) const {
  arb::Complex x;
  acb_set_arb(x.get(), arb::real(tau, bits_).get());
  const DiscBall length = ruling_length(at(x));
  arb::Real y;
  acb_get_real(y.get(), length.value.get());
  return y;
}

std::vector<Stretch> stretches(const PieceStrip& strip, const std::vector<Q>& marks) {
  const std::vector<Q> cuts = cuts_of(strip, marks);
  std::vector<Stretch> list;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const bool breaking = std::ranges::any_of(
        strip.breaks, [&](const RealRoot& x) { return x.lower == cuts[i] && x.upper == cuts[i + 1]; });
    list.emplace_back(strip.forms, cuts[i], cuts[i + 1], breaking);
  }
  return list;
}

}  // namespace torse
