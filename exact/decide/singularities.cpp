// Signs between isolated roots.
#include "torse/exact/decide/singularities.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "torse/exact/decide/rootless.hpp"

namespace torse {
namespace {

using Q = Rational;
using Poly = Polynomial<Q>;
using Bound = SingularSet::Bound;

/// The relative width of the interval around an irrational parameter.
constexpr int parameter_bits = 64;

/// A polynomial by its square-free part, which changes its sign at every root; 1 where it has no root on the piece.
struct Factor {
  Poly simple;

  Factor(const Poly& f, const Q& a, const Q& b)
      : simple(f.zero()                   ? Poly()
               : surely_rootless(f, a, b) ? Poly(1)
                                          : square_free_part(f)) {}

  /// Whether a root of a multiple of this polynomial, isolated for that multiple, is a root of this polynomial.
  bool vanishes(const RealRoot& root) const {
    if (simple.zero()) return true;
    return simple(root.lower).sign() * simple(root.upper).sign() <= 0;
  }
};

/// One piece: the parameters where anything happens, its ends included, and what happens there.
class PieceEvents {
 public:
  explicit PieceEvents(const PieceFunctions<Q>& f) : inside_(-(f.beta * f.delta * f.p[0] * f.q[0])) {
    Poly product(1);
    for (const Poly& g : {f.beta, f.delta, f.p[0], f.q[0], common_divisor(ruling_coordinates<Q>(f.p, f.q)), f.minors}) {
      zeros_.emplace_back(g, f.begin, f.end);
      if (!g.zero()) product *= zeros_.back().simple;
    }
    if (product.degree() == 0) {
      roots_ = {{f.begin, f.begin}, {f.end, f.end}};
      return;
    }
    product *= Poly(std::vector<Q>{f.begin * f.end, -(f.begin + f.end), Q(1)});
    for (RealRoot& root : real_roots(product.coefficients(), parameter_bits)) {
      if (root.rational()) rational_.push_back(root.lower);
      if (root.lower >= f.begin && root.upper <= f.end) roots_.push_back(std::move(root));
    }
  }

  std::size_t size() const { return roots_.size(); }

  /// What is singular at parameter i for another reason than the edge.
  std::optional<Singularity> degenerate(std::size_t i) const {
    if (at(i, w) || at(i, omega)) return Singularity::pole;
    if (at(i, ruling)) return Singularity::vanishing;
    if (at(i, minors)) return Singularity::stationary;
    return std::nullopt;
  }

  /// Whether the edge passes through the end of the ruling at parameter i.
  bool edge_on_boundary(std::size_t i) const { return at(i, beta) || at(i, delta); }

  /// Whether the edge meets the rulings between the parameters i and i+1; it does for all of them or for none.
  bool edge_between(std::size_t i) const {
    return inside_.zero() || inside_((roots_[i].upper + roots_[i + 1].lower) / Q(2)).sign() > 0;
  }

  /// The parameter with a polynomial from which all rational roots are divided out.
  Bound bound(std::size_t i) const {
    if (roots_[i].rational()) return {roots_[i]};
    const auto zero =
        std::ranges::find_if(zeros_, [&](const Factor& f) { return !f.simple.zero() && f.vanishes(roots_[i]); });
    Poly simple = zero->simple;
    for (const Q& x : rational_) {
      if (simple(x).sign() == 0) simple = exact_quotient(simple, Poly(std::vector<Q>{-x, Q(1)}));
    }
    return {roots_[i], std::move(simple)};
  }

 private:
  enum Index : std::size_t { beta, delta, w, omega, ruling, minors };

  bool at(std::size_t i, Index zero) const { return zeros_[zero].vanishes(roots_[i]); }

  std::vector<Factor> zeros_{};
  Poly inside_;
  std::vector<RealRoot> roots_{};
  std::vector<Q> rational_{};
};

/// Appends a set, or extends the last of its reason if that ends where this one begins (at a knot).
void append(std::vector<SingularSet>& sets, SingularSet next) {
  for (auto last = sets.rbegin(); last != sets.rend(); ++last) {
    if (last->reason != next.reason) continue;
    if (last->to.root.rational() && last->to.root.lower == next.from.root.lower) {
      last->to = std::move(next.to);
      return;
    }
    break;
  }
  sets.push_back(std::move(next));
}

void append_piece(std::vector<SingularSet>& sets, const PieceFunctions<Q>& f) {
  const bool no_surface = f.sweep != Sweep::surface;
  if (no_surface || f.p[0].zero() || f.q[0].zero()) {
    append(sets, {no_surface ? Singularity::no_surface : Singularity::pole, {{f.begin, f.begin}}, {{f.end, f.end}}});
    return;
  }
  const PieceEvents events(f);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::optional<Singularity> reason = events.degenerate(i);
    if (reason) append(sets, {*reason, events.bound(i), events.bound(i)});
    const bool before = i > 0 && events.edge_between(i - 1);
    std::size_t last = i;
    while (!before && last + 1 < events.size() && events.edge_between(last)) ++last;
    if (last > i || (!before && !reason && events.edge_on_boundary(i))) {
      append(sets, {Singularity::edge, events.bound(i), events.bound(last)});
    }
  }
}

}  // namespace

std::string_view name_of(Singularity reason) {
  constexpr std::array<std::string_view, 5> names{"edge", "vanishing", "stationary", "pole", "no surface"};
  return names[static_cast<std::size_t>(reason)];
}

std::vector<SingularSet> find_singularities(const std::vector<PieceFunctions<Rational>>& pieces) {
  std::vector<SingularSet> sets;
  for (const PieceFunctions<Rational>& piece : pieces) append_piece(sets, piece);
  return sets;
}

}  // namespace torse
