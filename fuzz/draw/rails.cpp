#include "torse/fuzz/draw/rails.hpp"

#include <utility>

#include "torse/fuzz/draw/disguise.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/numbers.hpp"

namespace torse::fuzz {
namespace {

Rail draw_rail(Choices& choices, const Scale& scale) {
  Rail rail{draw_knots(choices, scale)};
  rail.rows = draw_rows(choices, scale, rail.knots.last() + 1, choices.once_in(2) ? Weights::nonzero : Weights::one);
  return rail;
}

/// The curve of a row with further knots or a higher degree.
Rail draw_rewritten(Choices& choices, const Scale& scale, const KnotList<Rational>& u, const std::vector<Row4>& row) {
  Draft draft{.knots = u, .p = row, .q = row};
  refine(choices, scale, Weights::nonzero, draft);
  return {draft.knots, draft.p};
}

/// The same curve over begin + width [0, 1].
Rail moved(Rail rail, const Rational& begin, const Rational& width) {
  const KnotList<Rational>& u = rail.knots;
  std::vector<Rational> list;
  const Rational factor = width / (u.domain_end() - u.domain_begin());
  for (const Rational& t : u.list()) list.push_back(begin + factor * (t - u.domain_begin()));
  return {{u.degree(), std::move(list)}, std::move(rail.rows)};
}

}  // namespace

Rails draw_rails(Choices& choices, const Scale& scale) {
  if (choices.once_in(2)) {
    Rails rails{draw_rail(choices, scale)};
    rails.d = draw_rail(choices, scale);
    return rails;
  }
  Rails rails{.net = draw_rational_net(choices, scale)};
  rails.c = draw_rewritten(choices, scale, rails.net->knots, rails.net->c);
  rails.d = draw_rewritten(choices, scale, rails.net->knots, rails.net->d);
  const Rational begin = draw_number(choices, scale);
  rails.d = moved(std::move(rails.d), begin, draw_positive(choices, scale));
  return rails;
}

Spline<Rational, Row4> as_spline(const Rail& rail) { return {rail.knots, rail.rows}; }

}  // namespace torse::fuzz
