#include <algorithm>
#include <string_view>
#include <vector>

#include "torse/exact/decide/singularities.hpp"
#include "torse/fuzz/plain/ruling.hpp"
#include "torse/fuzz/plain/sturm.hpp"
#include "torse/fuzz/properties/recovery.hpp"

namespace torse::fuzz {
namespace {

using Bound = SingularSet::Bound;

/// Whether t is certainly not below, not above a bound. An irrational root lies between its ends, which are none.
bool from_there(const Bound& from, const Rational& t) { return from.root.upper <= t; }
bool until_there(const Bound& to, const Rational& t) { return t <= to.root.lower; }

/// Whether t lies between the ends of an irrational bound, where it cannot be told from the root.
bool ambiguous(const std::vector<SingularSet>& sets, const Rational& t) {
  for (const SingularSet& set : sets) {
    for (const Bound* bound : {&set.from, &set.to}) {
      if (bound->root.lower < t && t < bound->root.upper) return true;
    }
  }
  return false;
}

bool listed(const std::vector<SingularSet>& sets, std::string_view reason, const Rational& t) {
  for (const SingularSet& set : sets) {
    if ((reason.empty() || name_of(set.reason) == reason) && from_there(set.from, t) && until_there(set.to, t)) {
      return true;
    }
  }
  return false;
}

/// What is true at a parameter.
class Oracle {
 public:
  Oracle(const Net<4>& net, const std::vector<PieceFunctions<Rational>>& pieces)
      : strip_(plain::strip_of(net.knots, net.c, net.d)), pieces_(pieces) {}

  /// The reasons of the pieces that it belongs to.
  std::vector<std::string_view> at(const Rational& t) const {
    std::vector<std::string_view> reasons;
    for (std::size_t j = 0; j < pieces_.size(); ++j) {
      if (t < pieces_[j].begin || pieces_[j].end < t) continue;
      const std::string_view reason = pieces_[j].sweep == Sweep::surface
                                          ? plain::singular_at(plain::ruling_at(strip_, static_cast<int>(j), t))
                                          : "no surface";
      if (!reason.empty()) reasons.push_back(reason);
    }
    return reasons;
  }

  /// A weight that changes its sign between two parameters of a surface has a pole between them.
  void check_signs(const std::vector<SingularSet>& sets, std::vector<Rational> sorted) const {
    for (std::size_t j = 0; j < pieces_.size(); ++j) {
      if (pieces_[j].sweep != Sweep::surface) continue;
      for (const plain::Poly* weight : {&strip_.p.rows[j][0], &strip_.q.rows[j][0]}) {
        for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
          if (sorted[i] < pieces_[j].begin || pieces_[j].end < sorted[i + 1]) continue;
          const int change = plain::value(*weight, sorted[i]).sign() * plain::value(*weight, sorted[i + 1]).sign();
          require(change >= 0 || pole_between(sets, sorted[i], sorted[i + 1]), "a pole is not listed");
        }
      }
    }
  }

 private:
  static bool pole_between(const std::vector<SingularSet>& sets, const Rational& from, const Rational& to) {
    for (const SingularSet& set : sets) {
      if (set.reason == Singularity::pole && set.from.root.lower <= to && from <= set.to.root.upper) return true;
    }
    return false;
  }

  plain::Strip strip_;
  const std::vector<PieceFunctions<Rational>>& pieces_;
};

void check_parameter(const std::vector<SingularSet>& sets, const Oracle& oracle, const Rational& t) {
  if (ambiguous(sets, t)) return;
  const std::vector<std::string_view> reasons = oracle.at(t);
  for (const std::string_view reason : reasons) {
    require(listed(sets, reason, t), "a singular parameter is not listed");
  }
  require(!reasons.empty() || !listed(sets, "", t), "a regular parameter is listed");
}

/// An irrational bound is the only root of its polynomial there.
void check_bound(const Bound& bound) {
  if (bound.root.rational()) return;
  const Rational& lower = bound.root.lower;
  const Rational& upper = bound.root.upper;
  require(lower < upper, "an empty interval");
  const plain::Poly f = bound.zero_of.coefficients();
  require(plain::value(f, upper).sign() != 0, "an end of the interval is a root");
  require(plain::roots_between(f, lower, upper) == 1, "not one root between the bounds of a parameter");
}

}  // namespace

const PropertyInfo& SingularParameters::info() {
  static const PropertyInfo info{
      "recover.singular",
      "the listed parameters are those where the ruling has a singular point, by rank and sign at parameters, at the "
      "bounds and between them; irrational bounds are single roots by Sturm's theorem",
      6,
      {"class=plane", "class=cylinder", "class=cone", "class=tangent", "reason=edge", "reason=vanishing", "reason=pole",
       "reason=stationary", "reason=no surface", "reason=none", "bound=irrational", "bound=rational"}};
  return info;
}

SingularParameters::In SingularParameters::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in{choices.below(3) == 2 ? draw_row_net(choices, scale) : draw_developable_rational_net(choices, scale), {}};
  if (!in.net.developable) throw Discard("not developable");
  add_net_labels(labels, in.net);
  for (int i = 0; i < 3; ++i) in.shares.push_back(Rational(choices.between(0, 16)) / Rational(16));
  return in;
}

void SingularParameters::check(const In& in, Labels& labels) {
  const std::vector<PieceFunctions<Rational>> pieces = recover_pieces<Rational>(in.net.knots, in.net.c, in.net.d);
  const std::vector<SingularSet> sets = find_singularities(pieces);
  const Oracle oracle(in.net, pieces);
  std::vector<Rational> parameters;
  for (const PieceFunctions<Rational>& f : pieces) {
    for (const Rational& share : in.shares) parameters.push_back(f.begin + share * (f.end - f.begin));
    parameters.push_back(f.begin);
    parameters.push_back(f.end);
  }
  if (sets.empty()) labels.add("reason", "none");
  for (const SingularSet& set : sets) {
    labels.add("reason", std::string(name_of(set.reason)));
    require(set.from.root.lower <= set.to.root.upper, "a set with its ends exchanged");
    for (const Bound* bound : {&set.from, &set.to}) {
      labels.add("bound", bound->root.rational() ? "rational" : "irrational");
      check_bound(*bound);
      parameters.push_back(bound->root.lower);
      parameters.push_back(bound->root.upper);
    }
  }
  std::vector<Rational> sorted = parameters;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) parameters.push_back((sorted[i] + sorted[i + 1]) / Rational(2));
  oracle.check_signs(sets, sorted);
  for (const Rational& t : parameters) check_parameter(sets, oracle, t);
}

}  // namespace torse::fuzz
