// What the readers of files make of a text, in one form for all types.
//   meaning_of       the exact numbers that a file is read as        written_again    the file that is written for them
#pragma once

#include <optional>
#include <string>

#include "torse/fuzz/draw/file_text.hpp"
#include "torse/io/construct_file.hpp"

namespace torse::fuzz {

namespace detail {

template <class S>
Rational as_rational(const S& x) {
  return Rational::from_text(as_text(x));
}

template <class S>
Vec<Rational, 3> as_rational(const Vec<S, 3>& x) {
  return {as_rational(x[0]), as_rational(x[1]), as_rational(x[2])};
}

template <class List>
auto as_rationals(const List& list) {
  std::vector<decltype(as_rational(list.front()))> result;
  for (const auto& x : list) result.push_back(as_rational(x));
  return result;
}

template <class S>
SplineMeant spline_meaning(const KnotList<S>& knots, const WeightedPoints<S, 3>& net) {
  return {knots.degree(), as_rationals(knots.list()), as_rationals(net.points), as_rationals(net.weights)};
}

template <class S>
void add_parameter(FileMeant& meant, const char* key, const std::optional<S>& x) {
  if (x) meant.parameters.push_back({key, {as_rational(*x)}});
}

template <class S>
void add_parameter(FileMeant& meant, const char* key, const std::optional<Vec<S, 3>>& x) {
  if (x) meant.parameters.push_back({key, {as_rational((*x)[0]), as_rational((*x)[1]), as_rational((*x)[2])}});
}

template <class S>
void add_parameter(FileMeant& meant, const char* key, const std::vector<S>& list) {
  if (!list.empty()) meant.parameters.push_back({key, as_rationals(list)});
}

template <class S>
FileMeant construct_meaning(const ConstructFile<S>& file) {
  FileMeant meant{"construct", spline_meaning(file.knots, file.c), {}, file.method, {}};
  add_parameter(meant, "Lambda", file.lambda);
  add_parameter(meant, "M", file.m);
  add_parameter(meant, "sigma", file.sigma);
  add_parameter(meant, "omega0", file.omega0);
  add_parameter(meant, "d0", file.d0);
  add_parameter(meant, "va", file.va);
  add_parameter(meant, "vb", file.vb);
  add_parameter(meant, "a", file.a);
  add_parameter(meant, "b", file.b);
  add_parameter(meant, "v", file.v);
  return meant;
}

}  // namespace detail

/// What a document is read as over S by the reader of a type; parameters in the order above. Throws FileError.
template <class S>
FileMeant meaning_of(const Document& document, const std::string& type) {
  if (type == "ruled") {
    const RuledFile<S> file = read_ruled<S>(document);
    return {type, detail::spline_meaning(file.knots, file.c), detail::spline_meaning(file.knots, file.d), "", {}};
  }
  if (type == "rails") {
    const RailsFile<S> file = read_rails<S>(document);
    return {type,
            detail::spline_meaning(file.c.knots, file.c.net),
            detail::spline_meaning(file.d.knots, file.d.net),
            "",
            {}};
  }
  if (type == "construct") return detail::construct_meaning(read_construct<S>(document));
  const CurveFile<S> file = read_curve<S>(document);
  return {type, detail::spline_meaning(file.knots, file.net), {}, "", {}};
}

/// The file that is written for a document that can be read; none for "construct", which is never written. Throws
/// FileError.
template <class S>
std::optional<std::string> written_again(const Document& document) {
  const std::string& type = file_type(document);
  if (type == "curve") return write_curve(read_curve<S>(document));
  if (type == "rails") return write_rails(read_rails<S>(document));
  if (type == "ruled") return write_ruled(read_ruled<S>(document));
  return std::nullopt;
}

}  // namespace torse::fuzz
