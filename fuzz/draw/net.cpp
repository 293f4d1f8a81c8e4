#include "torse/fuzz/draw/net.hpp"

#include <algorithm>
#include <utility>

#include "torse/fuzz/draw/disguise.hpp"
#include "torse/fuzz/draw/joined.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/weights.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {
namespace {

/// Drawings that may fail to be what is wanted, before the case is given up.
constexpr int tries = 8;

using Drafting = Draft (*)(Choices&, const Scale&, Weights);

/// What a developable net is made by; the first is the simplest.
constexpr std::initializer_list<Drafting> developable_drafts = {draft_plane, draft_cylinder, draft_cone, draft_linear,
                                                                draft_edge,  draft_joined,   draft_line, draft_cylinder,
                                                                draft_cone,  draft_linear,   draft_edge, draft_curve};
/// What near-misses are made of: nets that a move of a few coordinates makes twisted.
constexpr std::initializer_list<Drafting> missed_drafts = {draft_cylinder, draft_cone, draft_linear, draft_edge};

Draft draw_draft(Choices& choices, const Scale& scale, Weights weights, std::initializer_list<Drafting> list) {
  for (int i = 0; i < tries; ++i) {
    Draft draft = choices.pick(list)(choices, scale, weights);
    if (fits(draft, weights)) return draft;
  }
  throw Discard("a weight is zero");
}

template <int D>
std::vector<Vec<Rational, D>> coordinates(std::vector<Row4> rows) {
  if constexpr (D == 4) {
    return rows;
  } else {
    std::vector<Point3> points;
    for (const Row4& x : rows) points.emplace_back(x[1], x[2], x[3]);
    return points;
  }
}

template <int D>
Net<D> developable_net(const Draft& draft) {
  const plain::ClassTruth truth = plain::class_of(draft.knots, draft.p, draft.q, draft.common_point);
  return {.knots = draft.knots,
          .c = coordinates<D>(draft.p),
          .d = coordinates<D>(draft.q),
          .developable = true,
          .klass = std::string(truth.name),
          .made = draft.made,
          .common = truth.common,
          .functions = draft.functions,
          .disguise = draft.disguise};
}

template <int D>
Net<D> twisted_net(const Draft& draft, int miss) {
  return {.knots = draft.knots,
          .c = coordinates<D>(draft.p),
          .d = coordinates<D>(draft.q),
          .developable = false,
          .klass = "none",
          .made = draft.made,
          .miss = miss,
          .disguise = draft.disguise};
}

bool is_refuted(const Draft& draft) { return plain::refuted(plain::strip_of(draft.knots, draft.p, draft.q)); }

/// Moves one coordinate of one row by its size (1 for zero) times `factor`.
void move(Choices& choices, Draft& draft, const Rational& factor) {
  std::vector<Row4>& rows = choices.once_in(2) ? draft.p : draft.q;
  Row4& x = rows[choices.below(rows.size())];
  Rational& coordinate = x[1 + static_cast<int>(choices.below(3))];
  coordinate += factor * (coordinate.sign() == 0 ? Rational(1) : coordinate);
}

Draft missed(Choices& choices, Draft draft, int k) {
  const Rational factor = power_of_two(-k);
  for (int i = 0; i < tries; ++i) {
    move(choices, draft, factor);
    if (is_refuted(draft)) return draft;
  }
  throw Discard("the moved net is developable");
}

/// A twisted draft disguised: as it is if only a part that is developable would be left.
Draft disguised(Choices& choices, const Scale& scale, Weights weights, const Draft& draft) {
  Draft next = draft;
  disguise(choices, scale, weights, next);
  return is_refuted(next) ? next : draft;
}

template <int D>
Net<D> draw_near_miss(Choices& choices, const Scale& scale, Weights weights) {
  const int k = 1 + choices.between(0, choices.pick({16, 60, 25 * scale.bits}));
  Draft draft = missed(choices, draw_draft(choices, scale, weights, missed_drafts), k);
  return twisted_net<D>(disguised(choices, scale, weights, draft), k);
}

template <int D>
Net<D> draw_free(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = draw_draft(choices, scale, weights, {draft_free});
  if (!is_refuted(draft)) draft = missed(choices, std::move(draft), 0);
  return twisted_net<D>(disguised(choices, scale, weights, draft), 0);
}

template <int D>
Net<D> draw_developable(Choices& choices, const Scale& scale, Weights weights) {
  Draft draft = draw_draft(choices, scale, weights, developable_drafts);
  disguise(choices, scale, weights, draft);
  return developable_net<D>(draft);
}

template <int D>
Net<D> draw_any(Choices& choices, const Scale& scale, Weights weights) {
  switch (choices.below(8)) {
    case 6:
      return draw_near_miss<D>(choices, scale, weights);
    case 7:
      return draw_free<D>(choices, scale, weights);
    default:
      return draw_developable<D>(choices, scale, weights);
  }
}

std::string_view bits_of_miss(int k) {
  if (k == 0) return "none";
  return k <= 20 ? "to 20" : k <= 60 ? "to 60" : "beyond 60";
}

template <int D>
void add_labels(Labels& labels, const Net<D>& net) {
  labels.add("class", net.klass);
  labels.add("made", net.made);
  labels.add("degree", net.knots.degree());
  labels.add("pieces", static_cast<int>(net.knots.proper_pieces().size()));
  labels.add("knots", std::string(knot_kind(net.knots)));
  labels.add("miss", std::string(bits_of_miss(net.miss)));
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = net.disguise.find('+', begin);
    labels.add("disguise", net.disguise.empty() ? "none" : net.disguise.substr(begin, end - begin));
  }
}

}  // namespace

Net<3> draw_net(Choices& choices, const Scale& scale) { return draw_any<3>(choices, scale, Weights::one); }

Net<4> draw_rational_net(Choices& choices, const Scale& scale) { return draw_any<4>(choices, scale, Weights::nonzero); }

Net<4> draw_row_net(Choices& choices, const Scale& scale) { return draw_any<4>(choices, scale, Weights::any); }

Net<3> draw_developable_net(Choices& choices, const Scale& scale) {
  return draw_developable<3>(choices, scale, Weights::one);
}

Net<4> draw_developable_rational_net(Choices& choices, const Scale& scale) {
  return draw_developable<4>(choices, scale, Weights::nonzero);
}

Net<4> with_weights(const Net<3>& net) {
  Net<4> rows{.knots = net.knots,
              .developable = net.developable,
              .klass = net.klass,
              .made = net.made,
              .miss = net.miss,
              .common = net.common,
              .functions = net.functions,
              .disguise = net.disguise};
  for (const Point3& x : net.c) rows.c.emplace_back(Rational(1), x[0], x[1], x[2]);
  for (const Point3& x : net.d) rows.d.emplace_back(Rational(1), x[0], x[1], x[2]);
  return rows;
}

std::vector<Rational> weights_of(const Net<4>& net) {
  std::vector<Rational> weights;
  for (const Row4& x : net.c) weights.push_back(x[0]);
  for (const Row4& x : net.d) weights.push_back(x[0]);
  return weights;
}

void add_net_labels(Labels& labels, const Net<3>& net) {
  add_labels(labels, net);
  labels.add("polygon", std::string(polygon_kind(net.c)));
  labels.add("weights", "none");
}

void add_net_labels(Labels& labels, const Net<4>& net) {
  add_labels(labels, net);
  labels.add("weights", std::string(weight_kind(weights_of(net))));
}

}  // namespace torse::fuzz
