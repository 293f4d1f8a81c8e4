// Signs of the factors of a strip.
#include "torse/exact/unroll/strip.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "torse/algebra/triple.hpp"
#include "torse/exact/decide/rootless.hpp"

namespace torse {
namespace {

using Q = Rational;
using Poly = Polynomial<Q>;

/// The relative width of the interval around an irrational root.
constexpr int root_bits = 96;

/// The distinct roots in [0, 1], in order; none for the zero polynomial. An interval that reaches over an end is cut
/// there.
std::vector<RealRoot> unit_roots(const Poly& f) {
  if (f.degree() < 1 || surely_rootless(f, Q(0), Q(1))) return {};
  std::vector<RealRoot> roots = real_roots(f.coefficients(), root_bits);
  std::erase_if(roots, [](const RealRoot& x) { return x.upper < Q(0) || x.lower > Q(1); });
  for (RealRoot& x : roots) x = {std::max(x.lower, Q(0)), std::min(x.upper, Q(1))};
  return roots;
}

bool inside(const RealRoot& x) { return x.upper > Q(0) && x.lower < Q(1); }

/// The sets of one piece, in its own parameter t.
class PieceObstacles {
 public:
  explicit PieceObstacles(const PieceStrip& strip) : strip_(strip) {}

  void add_roots(Singularity reason, const Poly& f) {
    for (const RealRoot& x : unit_roots(f)) add(reason, bound(x, f), bound(x, f));
  }

  void add_piece(Singularity reason) { add(reason, {{strip_.begin, strip_.begin}}, {{strip_.end, strip_.end}}); }

  /// The roots of the ruling's length, but for those at the ends of the surface.
  void add_meetings(bool first, bool last) {
    const Poly& f = strip_.forms.terms.gap;
    for (const RealRoot& x : unit_roots(f)) {
      const bool at_end = (first && x.upper == Q(0)) || (last && x.lower == Q(1));
      if (!at_end) add(Singularity::vanishing, bound(x, f), bound(x, f));
    }
  }

  /// The roots where f changes its sign.
  void add_changes(Singularity reason, const Poly& f) {
    const std::vector<RealRoot> roots = unit_roots(f);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (!inside(roots[i])) continue;
      if (sign_between(f, roots, i) * sign_between(f, roots, i + 1) < 0)
        add(reason, bound(roots[i], f), bound(roots[i], f));
    }
  }

  /// The intervals where f < 0.
  void add_negative(Singularity reason, const Poly& f) {
    const std::vector<RealRoot> roots = unit_roots(f);
    for (std::size_t i = 0; i <= roots.size(); ++i) {
      const bool empty = (i == 0 && !roots.empty() && roots.front().lower <= Q(0)) ||
                         (i == roots.size() && i > 0 && roots.back().upper >= Q(1));
      if (empty || sign_between(f, roots, i) >= 0) continue;
      add(reason, i == 0 ? Bound{{strip_.begin, strip_.begin}} : bound(roots[i - 1], f),
          i == roots.size() ? Bound{{strip_.end, strip_.end}} : bound(roots[i], f));
    }
  }

  std::vector<SingularSet> take() { return std::move(sets_); }

 private:
  using Bound = SingularSet::Bound;

  void add(Singularity reason, Bound from, Bound to) { sets_.push_back({reason, std::move(from), std::move(to)}); }

  /// The sign before root i (after the last one for i = roots.size()).
  static int sign_between(const Poly& f, const std::vector<RealRoot>& roots, std::size_t i) {
    const Q from = i == 0 ? Q(0) : roots[i - 1].upper;
    const Q to = i == roots.size() ? Q(1) : roots[i].lower;
    return f((from + to) / Q(2)).sign();
  }

  Bound bound(const RealRoot& x, const Poly& f) const {
    const Q length = strip_.end - strip_.begin;
    const RealRoot root{strip_.begin + length * x.lower, strip_.begin + length * x.upper};
    if (root.rational()) return {root};
    return {root, square_free_part(f).compose(Poly(std::vector<Q>{-strip_.begin / length, Q(1) / length}))};
  }

  const PieceStrip& strip_;
  std::vector<SingularSet> sets_;
};

/// All roots of several polynomials in (0, 1), each once: those of the product of their square-free parts.
std::vector<RealRoot> joint_breaks(std::initializer_list<const Poly*> list) {
  Poly product(1);
  for (const Poly* f : list) {
    if (f->degree() > 0 && !surely_rootless(*f, Q(0), Q(1))) product *= square_free_part(*f);
  }
  std::vector<RealRoot> roots = unit_roots(product);
  std::erase_if(roots, [](const RealRoot& x) { return !inside(x); });
  return roots;
}

bool has_surface(const Strip<Poly>& f) { return !f.gap.zero() && !f.across.zero(); }

std::vector<SingularSet> obstacles_of(const PieceStrip& strip, bool first, bool last) {
  const Strip<Poly>& f = strip.forms.terms;
  PieceObstacles found(strip);
  found.add_roots(Singularity::pole, f.w);
  found.add_roots(Singularity::pole, f.omega);
  if (f.gap.zero()) {
    found.add_piece(Singularity::vanishing);
  } else if (f.across.zero()) {
    found.add_piece(Singularity::no_surface);
  } else {
    found.add_meetings(first, last);
    found.add_changes(Singularity::stationary, f.across);
    found.add_negative(Singularity::edge, f.fold);
  }
  return found.take();
}

std::array<Q, 3> value_at(const std::array<Poly, 3>& f, const Q& tau) { return {f[0](tau), f[1](tau), f[2](tau)}; }

/// The vector over its largest coordinate in absolute value.
std::array<Q, 3> scaled(std::array<Q, 3> a) {
  Q largest(0);
  for (const Q& x : a) largest = std::max({largest, x, -x});
  for (Q& x : a) x /= largest;
  return a;
}

/// The strip with signs as they are in the last or the first part of its piece.
StripForms<Q> oriented_at(const PieceStrip& strip, bool end) {
  const Q from = end && !strip.breaks.empty() ? strip.breaks.back().upper : Q(0);
  const Q to = end || strip.breaks.empty() ? Q(1) : strip.breaks.front().lower;
  return oriented(strip.forms, (from + to) / Q(2));
}

bool opposite(const Joint& joint) {
  const auto axis = cross(joint.before, joint.after);
  return dot(axis, axis).sign() == 0 && dot(joint.before, joint.after).sign() < 0;
}

}  // namespace

Joint joint_of(const PieceStrip& left, const PieceStrip& right) {
  const StripForms<Q> before = oriented_at(left, true);
  return {scaled(value_at(before.normal, Q(1))), scaled(value_at(oriented_at(right, false).normal, Q(0))),
          value_at(before.ruling, Q(1))};
}

std::vector<PieceStrip> piece_strips(const KnotList<Q>& u, std::span<const Vec<Q, 4>> p, std::span<const Vec<Q, 4>> q) {
  std::vector<PieceStrip> strips;
  for (int k : u.proper_pieces()) {
    PieceStrip strip{k, u.piece_begin(k), u.piece_end(k), strip_forms<Q>(u, p, q, k), {}};
    const Strip<Poly>& f = strip.forms.terms;
    if (has_surface(f) && unit_roots(f.w).empty() && unit_roots(f.omega).empty()) {
      strip.breaks = joint_breaks({&f.speed_c, &f.speed_d, &f.across, &f.across_c, &f.across_d});
    }
    strips.push_back(std::move(strip));
  }
  return strips;
}

std::vector<SingularSet> find_obstacles(const std::vector<PieceStrip>& strips) {
  std::vector<SingularSet> sets;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    for (SingularSet& set : obstacles_of(strips[i], i == 0, i + 1 == strips.size())) sets.push_back(std::move(set));
  }
  if (!sets.empty()) return sets;
  for (std::size_t i = 0; i + 1 < strips.size(); ++i) {
    const SingularSet::Bound knot{{strips[i].end, strips[i].end}};
    if (opposite(joint_of(strips[i], strips[i + 1]))) sets.push_back({Singularity::stationary, knot, knot});
  }
  return sets;
}

}  // namespace torse
