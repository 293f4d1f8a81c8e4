// Curves, pairs of rails and ruled surfaces as JSON, for any exact field. docs/formats.md holds the contract.
//   CurveFile, RailsFile, RuledFile      what the files hold
//   file_type                            "ruled", "curve", "rails", "construct"
//   read_curve, read_rails, read_ruled   from a document       write_curve, write_rails, write_ruled   to text
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/developable/ruled.hpp"
#include "torse/io/document.hpp"

namespace torse {

/// A curve: degree and knots, control points with weights.
template <ExactField S>
struct CurveFile {
  KnotList<S> knots;
  WeightedPoints<S, 3> net;
};

/// Two curves, each with its own degree and knots.
template <ExactField S>
struct RailsFile {
  CurveFile<S> c;
  CurveFile<S> d;
};

/// A ruled surface between two rows over one knot list.
template <ExactField S>
struct RuledFile {
  KnotList<S> knots;
  WeightedPoints<S, 3> c;
  WeightedPoints<S, 3> d;
};

/// Whether all weights are 1.
template <ExactField S>
bool unit_weights(const WeightedPoints<S, 3>& net) {
  for (const S& weight : net.weights) {
    if (!definitely(equal(weight, from_int<S>(1)))) return false;
  }
  return true;
}

/// The member "type" of a document, whose version must be 1. Throws FileError.
inline const std::string& file_type(const Document& document) {
  document.root().at("torse").integer(1, 1);
  return document.root().at("type").string();
}

/// Throws FileError unless the document is of this type.
inline void require_type(const Document& document, std::string_view type) {
  if (file_type(document) != type) document.root().at("type").expected('"' + std::string(type) + '"');
}

namespace detail {

template <ExactField S>
std::vector<S> read_numbers(const Value& list) {
  std::vector<S> numbers;
  for (const Value& item : list.items()) numbers.push_back(item.number<S>());
  return numbers;
}

/// A point or vector: an array of exactly three numbers.
template <ExactField S>
Vec<S, 3> read_point(const Value& value) {
  const std::vector<Value> items = value.items();
  if (items.size() != 3) value.expected("three coordinates");
  return Vec<S, 3>(items[0].number<S>(), items[1].number<S>(), items[2].number<S>());
}

/// The members "points" and, if it is there, "weights" of an object. No weights are weights 1; no weight is 0.
template <ExactField S>
WeightedPoints<S, 3> read_net(const Value& object) {
  WeightedPoints<S, 3> net;
  const Value points = object.at("points");
  const std::vector<Value> items = points.items();
  if (items.size() < 2 || items.size() > static_cast<std::size_t>(limits::points)) {
    points.expected("2 to " + std::to_string(limits::points) + " control points");
  }
  for (const Value& item : items) net.points.push_back(read_point<S>(item));
  net.weights.assign(items.size(), from_int<S>(1));
  if (const std::optional<Value> weights = object.find("weights")) {
    const std::vector<Value> list = weights->items();
    if (list.size() != items.size()) weights->expected(std::to_string(items.size()) + " weights, one for each point");
    for (std::size_t i = 0; i < list.size(); ++i) {
      net.weights[i] = list[i].number<S>();
      if (definitely(is_zero(net.weights[i]))) list[i].expected("a weight that is not zero");
    }
  }
  return net;
}

/// The members "degree" and "knots" of an object whose curves have `count` control points, listed in the place
/// `points`. No knots are one Bezier piece on [0, 1].
template <ExactField S>
KnotList<S> read_knots(const Document& document, const Value& object, const Value& points, int count) {
  const int degree = object.at("degree").integer(1, limits::degree);
  const std::optional<Value> knots = object.find("knots");
  if (count < degree + 1 || (!knots && count != degree + 1)) {
    points.expected(std::string(knots ? "at least " : "") + std::to_string(degree + 1) + " control points for degree " +
                    std::to_string(degree) + (knots ? "" : " without knots"));
  }
  if (!knots) return bezier_knots<S>(degree);

  const std::vector<Value> items = knots->items();
  const int papers = count + degree - 1;
  const bool cad = static_cast<int>(items.size()) == papers + 2;
  if (!cad && static_cast<int>(items.size()) != papers) {
    knots->expected(std::to_string(papers) + " (papers' list) or " + std::to_string(papers + 2) +
                    " (CAD list) knots for degree " + std::to_string(degree) + " and " + std::to_string(count) +
                    " control points");
  }
  const std::vector<S> list = read_numbers<S>(*knots);
  const std::size_t run = static_cast<std::size_t>(degree);
  for (std::size_t i = 1; i < list.size(); ++i) {
    if constexpr (OrderedField<S>) {
      if (definitely(less(list[i], list[i - 1]))) items[i].expected("a knot not below the one before it");
    }
    // The outer knots of a CAD list are not used, so they do not count towards the multiplicity.
    const std::size_t first = cad ? 1 : 0;
    if (i >= first + run && i < list.size() - first && definitely(equal(list[i], list[i - run]))) {
      items[i].fail("expected a knot at most " + std::to_string(degree) + " times (the degree), found it more often");
    }
  }
  try {
    return KnotList<S>::from_list(degree, count - 1, list);
  } catch (const InvalidInput& invalid) {
    throw document.error("knots", invalid.what());
  }
}

template <ExactField S>
std::string list_text(const std::vector<S>& numbers) {
  std::string text;
  for (const S& x : numbers) text += (text.empty() ? "\"" : ", \"") + as_text(x) + '"';
  return '[' + text + ']';
}

template <ExactField S>
std::string knots_text(const KnotList<S>& u) {
  return "\"degree\": " + std::to_string(u.degree()) + ", \"knots\": " + list_text(u.list());
}

template <ExactField S>
std::string net_text(const WeightedPoints<S, 3>& net) {
  std::string points;
  for (const Vec<S, 3>& x : net.points) {
    points += (points.empty() ? "\n  " : ",\n  ") + list_text(std::vector<S>{x[0], x[1], x[2]});
  }
  return "\"points\": [" + points + "],\n  \"weights\": " + list_text(net.weights);
}

template <ExactField S>
std::string curve_text(const CurveFile<S>& curve) {
  return knots_text(curve.knots) + ",\n  " + net_text(curve.net);
}

template <ExactField S>
CurveFile<S> read_curve_members(const Document& document, const Value& object) {
  WeightedPoints<S, 3> net = read_net<S>(object);
  KnotList<S> knots = read_knots<S>(document, object, object.at("points"), static_cast<int>(net.points.size()));
  return {std::move(knots), std::move(net)};
}

}  // namespace detail

/// Reads {"torse": 1, "type": "curve", "degree", "knots"?, "points", "weights"?}. Throws FileError.
template <ExactField S>
CurveFile<S> read_curve(const Document& document) {
  require_type(document, "curve");
  document.root().expect_keys({"torse", "type", "degree", "knots", "points", "weights"});
  return detail::read_curve_members<S>(document, document.root());
}

/// Reads {"torse": 1, "type": "rails", "c": curve, "d": curve}. Throws FileError.
template <ExactField S>
RailsFile<S> read_rails(const Document& document) {
  require_type(document, "rails");
  const Value root = document.root();
  root.expect_keys({"torse", "type", "c", "d"});
  const auto read = [&](std::string_view key) {
    root.at(key).expect_keys({"degree", "knots", "points", "weights"});
    return detail::read_curve_members<S>(document, root.at(key));
  };
  CurveFile<S> c = read("c");
  return {std::move(c), read("d")};
}

/// Reads {"torse": 1, "type": "ruled", "degree", "knots"?, "c": {"points", "weights"?}, "d": {...}}. Throws FileError.
template <ExactField S>
RuledFile<S> read_ruled(const Document& document) {
  require_type(document, "ruled");
  const Value root = document.root();
  root.expect_keys({"torse", "type", "degree", "knots", "c", "d"});
  root.at("c").expect_keys({"points", "weights"});
  root.at("d").expect_keys({"points", "weights"});
  const Value c_points = root.at("c").at("points");
  const Value d_points = root.at("d").at("points");
  const std::size_t count = c_points.items().size();
  // A row c without points is at fault itself.
  if (count > 0 && d_points.items().size() != count) {
    d_points.expected(std::to_string(count) + " control points, as many as in c");
  }
  WeightedPoints<S, 3> c = detail::read_net<S>(root.at("c"));
  WeightedPoints<S, 3> d = detail::read_net<S>(root.at("d"));
  return {detail::read_knots<S>(document, root, c_points, static_cast<int>(count)), std::move(c), std::move(d)};
}

/// The text of a curve file; every number is a string with its exact value.
template <ExactField S>
std::string write_curve(const CurveFile<S>& curve) {
  return "{\"torse\": 1, \"type\": \"curve\", " + detail::curve_text(curve) + "}\n";
}

/// The text of a rails file.
template <ExactField S>
std::string write_rails(const RailsFile<S>& rails) {
  return "{\"torse\": 1, \"type\": \"rails\",\n \"c\": {" + detail::curve_text(rails.c) + "},\n \"d\": {" +
         detail::curve_text(rails.d) + "}}\n";
}

/// The text of a ruled file.
template <ExactField S>
std::string write_ruled(const RuledFile<S>& ruled) {
  return "{\"torse\": 1, \"type\": \"ruled\", " + detail::knots_text(ruled.knots) + ",\n \"c\": {" +
         detail::net_text(ruled.c) + "},\n \"d\": {" + detail::net_text(ruled.d) + "}}\n";
}

}  // namespace torse
