#include "torse/exact/quasi/self_intersection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/developable/warp.hpp"
#include "torse/exact/quasi/nearest_in_hull.hpp"
#include "torse/exact/quasi/ruling_order.hpp"
#include "torse/exact/quasi/strip_crossing.hpp"
#include "torse/exact/quasi/unit_rows.hpp"
#include "torse/exact/warp/quotient.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/closed.hpp"

namespace torse {
namespace {

using Q = Rational;
using Box = Vec<Interval, 3>;
using Direction = Vec<double, 3>;

/// Halvings of a piece of the knot list.
constexpr int most_halvings = 30;

/// As many pairs of neighbours are looked at without rounding, and one for so many pairs of the budget at most.
constexpr long most_exact = 60;
constexpr long pairs_per_exact = 300;

/// The work for a run is the square of its length.
constexpr std::size_t most_together = 16;

/// A part of this share of a piece is small enough to look for a crossing by Newton's method, with one pair for so many
/// of the budget at most.
constexpr int promising_halvings = 2;
constexpr long pairs_per_attempt = 16;

/// A direction parts two hulls when it sees all ways between them with this share of the shortest one.
constexpr double good = 0.25;

double middle(const Interval& x) { return x.lower() / 2 + x.upper() / 2; }

Direction middle(const Box& x) { return {middle(x[0]), middle(x[1]), middle(x[2])}; }

Direction nowhere() { return Direction::Constant(std::numeric_limits<double>::quiet_NaN()); }

Box as_box(const Direction& x) { return {Interval::point(x[0]), Interval::point(x[1]), Interval::point(x[2])}; }

/// A row of Bernstein coefficients cut in the middle of its interval.
template <class Row>
std::pair<std::vector<Row>, std::vector<Row>> halves(std::vector<Row> row) {
  const Interval half = Interval::point(0.5);
  std::vector<Row> left{row.front()};
  std::vector<Row> right{row.back()};
  for (std::size_t size = row.size(); size > 1; --size) {
    for (std::size_t i = 0; i + 1 < size; ++i) {
      for (int k = 0; k < row[i].size(); ++k) row[i][k] = half * (row[i][k] + row[i + 1][k]);
    }
    left.push_back(row.front());
    right.push_back(row[size - 2]);
  }
  std::ranges::reverse(right);
  return {std::move(left), std::move(right)};
}

using Homogeneous = Vec<Interval, 4>;

/// A part of the strip: control points and the directions of c', d - c and d', all by Bernstein coefficients.
struct Part {
  double begin;  ///< the number of the piece and the share of it
  double end;
  int halvings;
  std::vector<Homogeneous> c;
  std::vector<Homogeneous> d;
  std::vector<Box> a;
  std::vector<Box> w;
  std::vector<Box> b;
  const RulingForms<Q>* forms;  ///< of the whole piece, exactly
  std::vector<Box> hull{};
  std::array<std::unique_ptr<Part>, 2> halves{};

  double size = 0;  ///< the largest coordinate in the hull

  bool within_hull = true;  ///< the weights of either rail have one sign, so that it lies in the hull of its points

  void close() {
    for (const auto* row : {&c, &d}) {
      const auto positive = [](const Homogeneous& x) { return x[0].lower() > 0; };
      const auto negative = [](const Homogeneous& x) { return x[0].upper() < 0; };
      within_hull = within_hull && (std::ranges::all_of(*row, positive) || std::ranges::all_of(*row, negative));
      if (!within_hull) return;
      for (const Homogeneous& x : *row) hull.push_back({x[1] / x[0], x[2] / x[0], x[3] / x[0]});
    }
    for (const Box& x : hull) size = std::max(size, middle(x).lpNorm<Eigen::Infinity>());
  }
};

void split(Part& part) {
  if (part.halves[0]) return;
  auto [c0, c1] = halves(part.c);
  auto [d0, d1] = halves(part.d);
  auto [a0, a1] = halves(part.a);
  auto [w0, w1] = halves(part.w);
  auto [b0, b1] = halves(part.b);
  const double middle = (part.begin + part.end) / 2;
  part.halves[0] = std::make_unique<Part>(Part{part.begin, middle, part.halvings + 1, c0, d0, a0, w0, b0, part.forms});
  part.halves[1] = std::make_unique<Part>(Part{middle, part.end, part.halvings + 1, c1, d1, a1, w1, b1, part.forms});
  for (const auto& half : part.halves) half->close();
}

std::vector<Box> boxes_of(const FormVector<Q>& forms) {
  std::vector<Vec<Q, 3>> rows(static_cast<std::size_t>(forms[0].degree()) + 1);
  for (int k = 0; k < 3; ++k) {
    const Bernstein<Q> f = Bernstein<Q>::from_form(forms[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i][k] = f[static_cast<int>(i)];
  }
  bring_to_one(rows, 3);
  std::vector<Box> boxes;
  for (const Vec<Q, 3>& x : rows) boxes.push_back({enclosure(x[0]), enclosure(x[1]), enclosure(x[2])});
  return boxes;
}

template <int D>
std::vector<Homogeneous> bezier_boxes(const KnotList<Q>& u, std::span<const Vec<Q, D>> row, int k) {
  std::vector<Vec<Q, D>> points = bezier_points(u, row, k);
  if constexpr (D == 4) bring_to_one(points, 1);
  std::vector<Homogeneous> boxes;
  for (const Vec<Q, D>& x : points) {
    boxes.emplace_back(Interval(1), Interval(), Interval(), Interval());
    for (int j = 0; j < D; ++j) boxes.back()[j + 4 - D] = enclosure(x[j]);
  }
  return boxes;
}

/// The interval of the hull along a direction.
Interval extent(const Part& part, const Direction& direction) {
  const Box axis = as_box(direction);
  Interval reach = dot(part.hull.front(), axis);
  for (const Box& x : part.hull) {
    const Interval here = dot(x, axis);
    reach = Interval::hull(std::min(reach.lower(), here.lower()), std::max(reach.upper(), here.upper()));
  }
  return reach;
}

bool separated_along(const Part& x, const Part& y, const Direction& direction) {
  if (!direction.allFinite()) return false;
  const Interval first = extent(x, direction);
  const Interval second = extent(y, direction);
  return first.upper() < second.lower() || second.upper() < first.lower();
}

/// Whether a plane parts the hulls. The one to look at is across the way between their nearest points.
bool separated(const Part& x, const Part& y) {
  if (!x.within_hull || !y.within_hull) return false;
  const auto lowest = [](const Part& part, const Direction& e) {
    return middle(*std::ranges::min_element(part.hull, {}, [&](const Box& point) { return e.dot(middle(point)); }));
  };
  const double unit = std::max(x.size, y.size);  // squares of lengths are no zeros and not infinite
  const auto lowest_way = [&](const Direction& e) { return Direction(lowest(x, e) / unit - lowest(y, -e) / unit); };
  return separated_along(x, y, nearest_in_hull(lowest_way, good));
}

RulingTangents<Interval> rounded_tangents(const Part& part) { return {part.w, part.a, part.b}; }

RulingTangents<double> middles(const RulingTangents<Interval>& tangents) {
  const auto of = [](const std::vector<Box>& row) {
    std::vector<Direction> result;
    for (const Box& x : row) result.push_back(middle(x));
    return result;
  };
  return {of(tangents.w), of(tangents.a), of(tangents.b)};
}

/// Three forms on a part of [0, 1], exactly.
std::vector<Vec<Q, 3>> exact_row(const FormVector<Q>& forms, const Part& part) {
  const double piece = std::floor((part.begin + part.end) / 2);
  std::vector<Vec<Q, 3>> row(static_cast<std::size_t>(forms[0].degree()) + 1);
  for (std::size_t k = 0; k < 3; ++k) {
    Bernstein<Q> f = Bernstein<Q>::from_form(forms[k]);
    double begin = piece;
    for (double width = 1; begin != part.begin || begin + width != part.end; width /= 2) {
      auto [left, right] = f.subdivide(ratio<Q>(1, 2));
      const bool upper = part.begin >= begin + width / 2;
      f = upper ? std::move(right) : std::move(left);
      if (upper) begin += width / 2;
    }
    for (std::size_t i = 0; i < row.size(); ++i) row[i][static_cast<int>(k)] = f[static_cast<int>(i)];
  }
  return row;
}

RulingTangents<Q> exact_tangents(const Part& part) {
  return {exact_row(part.forms->w, part), exact_row(part.forms->a, part), exact_row(part.forms->b, part)};
}

template <class S>
std::vector<RulingTangents<S>> backwards(std::vector<RulingTangents<S>> parts) {
  std::ranges::reverse(parts);
  for (RulingTangents<S>& part : parts) {
    for (auto* row : {&part.w, &part.a, &part.b}) std::ranges::reverse(*row);
  }
  return parts;
}

/// Parts of the strip one behind the other, which may be in order from either end: tangents of a curve ahead of it are
/// from its beginning.
class Run {
 public:
  explicit Run(std::vector<const Part*> parts) : parts_(std::move(parts)) {
    // A rail that passes through infinity comes back from the other side.
    if (!std::ranges::all_of(parts_, &Part::within_hull)) return;
    std::vector<RulingTangents<double>> rounded;
    for (const Part* part : parts_) {
      tangents_.push_back(rounded_tangents(*part));
      rounded.push_back(middles(tangents_.back()));
    }
    sides_ = {common_side(rounded), common_side(backwards(rounded))};
  }

  /// Whether all rulings leave each other to the same side.
  Truth in_order() const { return from_either_end(tangents_); }

  /// The same without rounding, for products that vanish: a rail along its ruling, or at rest.
  Truth in_order_exactly() const {
    std::vector<RulingTangents<Q>> tangents;
    for (const Part* part : parts_) tangents.push_back(exact_tangents(*part));
    return from_either_end(tangents);
  }

 private:
  template <class S>
  Truth from_either_end(const std::vector<RulingTangents<S>>& tangents) const {
    const Truth ahead = to_side(tangents, sides_[0]);
    return ahead == Truth::yes ? ahead : ahead | to_side(backwards(tangents), sides_[1]);
  }

  template <class S>
  static Truth to_side(const std::vector<RulingTangents<S>>& tangents, const Direction& e) {
    if (!e.allFinite()) return Truth::unknown;
    Vec<S, 3> side;
    for (int k = 0; k < 3; ++k) {
      if constexpr (std::is_same_v<S, Q>) {
        side[k] = Q::from_double(e[k]);
      } else {
        side[k] = S::point(e[k]);
      }
    }
    return on_one_side<S>(tangents, side);
  }

  std::vector<const Part*> parts_;
  std::vector<RulingTangents<Interval>> tangents_{};
  std::array<Direction, 2> sides_{nowhere(), nowhere()};
};

class Search {
 public:
  Search(std::span<const std::unique_ptr<Part>> parts, bool closed, const CrossingFinder& finder, long most_pairs)
      : last_(static_cast<double>(parts.size())),
        closed_(closed),
        finder_(finder),
        left_(most_pairs),
        attempts_left_(most_pairs / pairs_per_attempt),
        exact_left_(static_cast<int>(std::min(most_pairs / pairs_per_exact, most_exact))) {
    for (std::size_t piece = 0; piece < parts.size() && !witness_; ++piece) witness_ = finder.within(piece);
    if (!witness_) begin_with(parts);
    for (; !pairs_.empty() && !witness_ && left_ > 0; pairs_.pop_front()) {
      look_at(*pairs_.front().first, *pairs_.front().second);
    }
  }

  SelfIntersection result() const {
    if (witness_) return {Truth::yes, witness_};
    return {decided_ && pairs_.empty() ? Truth::no : Truth::unknown};
  }

 private:
  bool neighbours(const Part& x, const Part& y) const {
    return &x == &y || x.end == y.begin || (closed_ && x.begin == 0 && y.end == last_);
  }

  /// All pairs of pieces that are not in one run in order.
  void begin_with(std::span<const std::unique_ptr<Part>> pieces) {
    if (pieces.size() == 1) {
      pairs_.emplace_back(pieces[0].get(), pieces[0].get());
    } else if (pieces.size() > most_together || !in_order(pieces)) {
      const auto left = pieces.first(pieces.size() / 2);
      const auto right = pieces.subspan(left.size());
      begin_with(left);
      begin_with(right);
      for (const auto& x : left) {
        for (const auto& y : right) pairs_.emplace_back(x.get(), y.get());
      }
    }
  }

  static bool in_order(std::span<const std::unique_ptr<Part>> pieces) {
    std::vector<const Part*> parts;
    for (const auto& piece : pieces) parts.push_back(piece.get());
    return Run(parts).in_order() == Truth::yes;
  }

  bool settled(const Part& x, const Part& y) {
    const bool over_seam = x.end != y.begin;
    const Run run(&x == &y    ? std::vector<const Part*>{&x}
                  : over_seam ? std::vector<const Part*>{&y, &x}
                              : std::vector<const Part*>{&x, &y});
    const Truth rounded = run.in_order();
    if (rounded != Truth::unknown || exact_left_ == 0) return rounded == Truth::yes;
    --exact_left_;
    return run.in_order_exactly() == Truth::yes;
  }

  void look_at(Part& x, Part& y) {
    --left_;
    if (neighbours(x, y) ? settled(x, y) : separated(x, y)) return;
    if (x.halvings == most_halvings || y.halvings == most_halvings) {
      decided_ = false;
      return;
    }
    if (&x != &y && x.halvings >= promising_halvings && x.halvings == y.halvings && attempts_left_-- > 0) {
      witness_ = finder_.near((x.begin + x.end) / 2, (y.begin + y.end) / 2);
    }
    Part& longer = x.end - x.begin >= y.end - y.begin ? x : y;
    split(longer);
    const auto& [first, second] = longer.halves;
    if (&x == &y) {
      pairs_.insert(pairs_.end(),
                    {{first.get(), second.get()}, {first.get(), first.get()}, {second.get(), second.get()}});
    } else if (&longer == &x) {
      pairs_.insert(pairs_.end(), {{first.get(), &y}, {second.get(), &y}});
    } else {
      pairs_.insert(pairs_.end(), {{&x, first.get()}, {&x, second.get()}});
    }
  }

  /// The larger ones first: one that does not tell keeps none from being looked at.
  std::deque<std::pair<Part*, Part*>> pairs_{};
  double last_;
  bool closed_;
  const CrossingFinder& finder_;
  long left_;
  long attempts_left_;
  int exact_left_;
  bool decided_ = true;
  std::optional<RulingCrossing> witness_;
};

/// Fewer pairs for high degrees: a pair costs the square of the number of coefficients. `most_pairs` is for degree 6.
long budget(int degree, long most_pairs) {
  const double share = 7.0 / (degree + 1);
  return static_cast<long>(static_cast<double>(most_pairs) * std::min(1.0, share * share));
}

}  // namespace

template <int D>
SelfIntersection find_self_intersection(const KnotList<Q>& u, std::span<const Vec<Q, D>> c,
                                        std::span<const Vec<Q, D>> d, long most_pairs) {
  std::vector<std::unique_ptr<Part>> parts;
  std::vector<std::unique_ptr<RulingForms<Q>>> all_forms;
  for (const int k : u.proper_pieces()) {
    all_forms.push_back(std::make_unique<RulingForms<Q>>(ruling_forms(u, c, d, k)));
    const RulingForms<Q>& forms = *all_forms.back();
    const double begin = static_cast<double>(parts.size());
    parts.push_back(std::make_unique<Part>(Part{begin, begin + 1, 0, bezier_boxes<D>(u, c, k), bezier_boxes<D>(u, d, k),
                                                boxes_of(forms.a), boxes_of(forms.w), boxes_of(forms.b), &forms}));
    parts.back()->close();
  }
  const auto closes = [&](std::span<const Vec<Q, D>> row) {
    return closed(Spline<Q, Vec<Q, D>>(u, {row.begin(), row.end()}));
  };
  return Search(parts, closes(c) && closes(d), CrossingFinder(u, c, d), budget(u.degree(), most_pairs)).result();
}

template SelfIntersection find_self_intersection<3>(const KnotList<Q>&, std::span<const Vec<Q, 3>>,
                                                    std::span<const Vec<Q, 3>>, long);
template SelfIntersection find_self_intersection<4>(const KnotList<Q>&, std::span<const Vec<Q, 4>>,
                                                    std::span<const Vec<Q, 4>>, long);

}  // namespace torse
