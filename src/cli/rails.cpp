#include "torse/cli/rails.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "torse/algebra/determinant.hpp"
#include "torse/cli/cad_faces.hpp"
#include "torse/cli/cad_process.hpp"
#include "torse/cli/cad_surface.hpp"
#include "torse/cli/command.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"
#include "torse/spline/compatible.hpp"

namespace torse::cli {
namespace {

/// As many curves as an error lists.
constexpr std::size_t most_listed = 12;

CurveFile<Rational> reversed(const CurveFile<Rational>& curve) {
  const auto rows = homogeneous(curve.net);
  const Spline<Rational, Vec<Rational, 4>> back =
      reversed_spline(Spline<Rational, Vec<Rational, 4>>(curve.knots, rows));
  return {back.knots, dehomogenize<Rational, 4>(back.control)};
}

Rational squared_distance(const Vec<Rational, 3>& x, const Vec<Rational, 3>& y) {
  const Vec<Rational, 3> w = difference(x, y);
  return dot(w, w);
}

/// The end points of a rail.
std::pair<Vec<Rational, 3>, Vec<Rational, 3>> ends_of(const CurveFile<Rational>& curve) {
  const Spline<Rational, Vec<Rational, 4>> rows(curve.knots, homogeneous(curve.net));
  const std::vector<int> pieces = curve.knots.proper_pieces();
  const auto at = [&](int k, const Rational& t) {
    return dehomogenize<Rational, 4>({curve_point(rows.knots, rows.points(), k, t)}).points.front();
  };
  return {at(pieces.front(), curve.knots.domain_begin()), at(pieces.back(), curve.knots.domain_end())};
}

std::string name_of(const CadCurve& curve) {
  return curve.name.empty() ? fmt::format("curve {}", curve.number) : printable(curve.name);
}

/// "3 curves: 1 "chine", 2 "sheer", 3 "curve 3"".
std::string listed(const std::vector<CadCurve>& curves) {
  if (curves.empty()) return "none";
  std::string text = curves.size() == 1 ? "one curve" : fmt::format("{} curves", curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i == most_listed) return text + ", ...";
    text += fmt::format("{}{} {}", i == 0 ? ": " : ", ", curves[i].number, in_quotes(name_of(curves[i])));
  }
  return text;
}

/// The curves of that name, else that of that number.
std::vector<const CadCurve*> chosen(const std::vector<CadCurve>& curves, const std::string& choice) {
  std::vector<const CadCurve*> found;
  for (const CadCurve& curve : curves) {
    if (name_of(curve) == printable(choice)) found.push_back(&curve);
  }
  for (const CadCurve& curve : curves) {
    if (found.empty() && std::to_string(curve.number) == choice) return {&curve};
  }
  return found;
}

const CadCurve& the_curve(const std::string& file, const std::vector<CadCurve>& curves, const std::string& choice) {
  const std::vector<const CadCurve*> found = chosen(curves, choice);
  if (found.size() == 1) return *found.front();
  throw FileError(
      file, found.empty() ? fmt::format("expected a curve {}, found {}", in_quotes(choice), listed(curves))
                          : fmt::format("{} curves are called {}: choose by number", found.size(), in_quotes(choice)));
}

std::pair<const CadCurve*, const CadCurve*> pick(const RailsInput& input, const std::vector<CadCurve>& curves) {
  if (!input.c.empty() && !input.d.empty()) {
    return {&the_curve(input.file, curves, input.c), &the_curve(input.file, curves, input.d)};
  }
  const std::vector<const CadCurve*> c = chosen(curves, "c");
  const std::vector<const CadCurve*> d = chosen(curves, "d");
  if (c.size() == 1 && d.size() == 1) return {c.front(), d.front()};
  if (curves.size() == 2) return {&curves[0], &curves[1]};
  throw FileError(input.file, fmt::format("expected two curves that bound no face, found {}{}", listed(curves),
                                          curves.size() > 2 ? "; choose them by --c and --d" : ""));
}

CurveFile<Rational> rail_of(const std::string& file, const CadCurve& curve) {
  if (!curve.rail) throw FileError(file, fmt::format("{} cannot be a rail: {}", name_of(curve), curve.reason));
  try {
    return curve_file(*curve.rail, curve.placement);
  } catch (const InvalidInput& error) {
    throw FileError(file, fmt::format("curve {} {}: {}", curve.number, in_quotes(name_of(curve)), error.what()));
  }
}

InputRails cad_rails(const RailsInput& input, CadFormat format, const std::string& bytes) {
  const CadCurves read = read_cad_curves(input.file, format, bytes);
  const auto [c, d] = pick(input, read.curves);
  const LengthUnit unit =
      unit_of_length(read.metres)
          .value_or(LengthUnit{.name = printable(read.unit), .metres = Rational::from_double(read.metres)});
  return {{rail_of(input.file, *c), rail_of(input.file, *d)}, unit, read.tolerance};
}

InputRails either_rails(const RailsInput& input) {
  std::string bytes = read_file(input.file);
  if (const std::optional<CadFormat> format = cad_format(input.file, bytes)) return cad_rails(input, *format, bytes);
  if (!input.c.empty() || !input.d.empty()) throw UsageError("--c, --d: choose curves of STEP and IGES files");
  return {read_rails<Rational>(Document(input.file, std::move(bytes))), millimetres()};
}

bool same_curve(const CurveFile<Rational>& c, const CurveFile<Rational>& d) {
  return c.knots.list() == d.knots.list() && c.net.points == d.net.points && c.net.weights == d.net.weights;
}

}  // namespace

InputRails read_input_rails(const RailsInput& input) {
  if (input.c.empty() != input.d.empty()) throw UsageError("--c, --d: expected both or none");
  InputRails result = either_rails(input);
  if (input.reverse) result.rails.d = reversed(result.rails.d);
  return result;
}

bool opposite(const RailsFile<Rational>& rails) {
  const auto [c0, c1] = ends_of(rails.c);
  const auto [d0, d1] = ends_of(rails.d);
  return squared_distance(c0, d1) + squared_distance(c1, d0) < squared_distance(c0, d0) + squared_distance(c1, d1);
}

bool one_point(const CurveFile<Rational>& rail) {
  return std::ranges::all_of(rail.net.points, [&](const auto& x) { return x == rail.net.points.front(); });
}

std::vector<std::string> notes_on(const RailsFile<Rational>& rails) {
  std::vector<std::string> notes;
  for (const auto& [rail, name] : {std::pair{&rails.c, "first"}, std::pair{&rails.d, "second"}}) {
    if (!one_point(*rail)) continue;
    notes.push_back(std::string("the ") + name + " rail is one point: all rulings meet there, as on a cone");
  }
  if (same_curve(rails.c, rails.d)) notes.emplace_back("both rails are the same curve: there is no strip between them");
  return notes;
}

}  // namespace torse::cli
