// The worked example of FJ21, section 8: every printed number beside the one the library computes from c, its weights,
// d_0, d_1, omega_0 and omega_1.
//   ExampleValue<S>    one printed item: group, label, pattern, printed numbers, computed numbers
//   ExampleRow         the same as text, for the terminal and the report
//   Section8Data<S>    what the example starts from         section8<S>    all printed items
//   Section8Net<S>     the patch that the data decide
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/developable/linear_net.hpp"
#include "torse/developable/moebius.hpp"
#include "torse/developable/recovery.hpp"
#include "torse/developable/regression.hpp"
#include "torse/spline/insertion.hpp"

namespace torse::proofs {

/// "p" or "p/q" as an element of S.
template <class S>
S fraction(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto integer = [](std::string_view digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
  };
  return slash == std::string_view::npos ? from_int<S>(integer(text))
                                         : ratio<S>(integer(text.substr(0, slash)), integer(text.substr(slash + 1)));
}

/// The pattern with each '%' replaced by the next of the numbers.
inline std::string fill(std::string_view pattern, const std::vector<std::string>& numbers) {
  std::string text;
  std::size_t next = 0;
  for (const char letter : pattern) {
    if (letter != '%') {
      text += letter;
    } else if (numbers[next].starts_with('-') && text.ends_with("+ ")) {
      text.replace(text.size() - 2, 2, "- " + numbers[next++].substr(1));
    } else {
      text += numbers[next++];
    }
  }
  return text;
}

/// A line of the example as text.
struct ExampleRow {
  std::string group;
  std::string label;
  std::string printed;
  std::string computed;
  bool equal;
};

/// A printed item of an example. The numbers fill the places '%' of the pattern.
template <class S>
struct ExampleValue {
  std::string group;
  std::string label;
  std::string pattern;
  std::vector<std::string> printed;
  std::vector<S> computed;

  /// As text; `equal` only where every number is decidedly the printed one.
  ExampleRow row() const {
    std::vector<std::string> numbers;
    bool same = printed.size() == computed.size();
    for (std::size_t i = 0; i < computed.size(); ++i) {
      numbers.push_back(as_text(computed[i]));
      same = same && definitely(torse::equal(computed[i], fraction<S>(printed[i])));
    }
    return {group, label, fill(pattern, printed), fill(pattern, numbers), same};
  }
};

/// The input of the example, with the paper's values.
template <class S>
struct Section8Data {
  std::vector<std::array<int, 3>> c{{0, 0, 0}, {3, 3, 0}, {4, 3, 0}, {5, 0, 0}};
  std::vector<S> w{from_int<S>(1), from_int<S>(1), ratio<S>(3, 5), ratio<S>(5, 6)};
  std::array<int, 3> d0{0, 0, 2};
  std::array<int, 3> d1{2, 2, 3};
  S omega0 = from_int<S>(1);
  S omega1 = from_int<S>(1);
  S b = from_int<S>(2);                          ///< of the Moebius transformation
  Linear<S> g{from_int<S>(1), ratio<S>(-3, 4)};  ///< of the trimming
  S knot = ratio<S>(2, 3);                       ///< to insert
};

template <class S>
Vec<S, 4> homogeneous_row(const S& weight, const std::array<int, 3>& point) {
  Vec<S, 4> row;
  row << weight, weight * from_int<S>(point[0]), weight * from_int<S>(point[1]), weight * from_int<S>(point[2]);
  return row;
}

/// The patch: Lam, M, sigma of the first cell and the rows of both curves.
template <class S>
struct Section8Net {
  KnotList<S> u = bezier_knots<S>(3);
  BlossomFunctions<S> f;
  std::vector<Vec<S, 4>> p;
  std::vector<Vec<S, 4>> q;

  explicit Section8Net(const Section8Data<S>& data) {
    for (std::size_t i = 0; i < data.c.size(); ++i) p.push_back(homogeneous_row(data.w[i], data.c[i]));
    q = {homogeneous_row(data.omega0, data.d0), homogeneous_row(data.omega1, data.d1)};
    f = cell_functions<S>(u, p, q, 0);
    q = rational_net<S, Vec<S, 4>>(u, p, f.lambda, f.m, f.sigma, q[0]);
  }
};

namespace detail {

/// The items of one group.
template <class S>
class ExampleGroup {
 public:
  ExampleGroup(std::vector<ExampleValue<S>>& values, std::string group) : values_(values), group_(std::move(group)) {}

  void number(std::string label, std::string printed, S computed) {
    values_.push_back({group_, std::move(label), "%", {std::move(printed)}, {std::move(computed)}});
  }
  void pattern(std::string label, std::string pattern, std::vector<std::string> printed, std::vector<S> computed) {
    values_.push_back({group_, std::move(label), std::move(pattern), std::move(printed), std::move(computed)});
  }
  void functions(const std::string& suffix, const std::array<std::string, 3>& printed, const BlossomFunctions<S>& f) {
    number("Lambda" + suffix, printed[0], f.lambda);
    number("M" + suffix, printed[1], f.m);
    number("sigma" + suffix, printed[2], f.sigma);
  }
  void point(std::string label, std::vector<std::string> printed, const Vec<S, 3>& x) {
    pattern(std::move(label), "(%, %, %)", std::move(printed), {x[0], x[1], x[2]});
  }
  void weights(std::string label, std::vector<std::string> printed, const std::vector<S>& w) {
    std::string list = "{%";
    for (std::size_t i = 1; i < w.size(); ++i) list += ", %";
    pattern(std::move(label), list + "}", std::move(printed), w);
  }

 private:
  std::vector<ExampleValue<S>>& values_;
  std::string group_;
};

template <class S>
void construction(const Section8Net<S>& net, std::vector<ExampleValue<S>>& values) {
  ExampleGroup<S> group(values, "construction");
  group.functions("", {"-4/3", "-2", "1"}, net.f);
  const WeightedPoints<S, 3> d = dehomogenize<S, 4>(net.q);
  group.point("d_0", {"0", "0", "2"}, d.points[0]);
  group.point("d_1", {"2", "2", "3"}, d.points[1]);
  group.point("d_2", {"3/2", "21/22", "135/22"}, d.points[2]);
  group.point("d_3", {"293/172", "-189/172", "1215/172"}, d.points[3]);
  group.weights("omega", {"1", "1", "11/15", "43/45"}, d.weights);
  const S v0 = edge_parameter(from_int<S>(0), net.f);
  group.pattern("v(t)", "% t + %", {"3/2", "3"}, {edge_parameter(from_int<S>(1), net.f) - v0, v0});
}

template <class S>
void moebius(const Section8Data<S>& data, const Section8Net<S>& net, std::vector<ExampleValue<S>>& values) {
  ExampleGroup<S> group(values, "Moebius transformation, b = 2");
  const std::vector<Vec<S, 4>> p = moebius_rows(net.p, data.b);
  const std::vector<Vec<S, 4>> q = moebius_rows(net.q, data.b);
  group.weights("w~", {"8", "4", "6/5", "5/6"}, dehomogenize<S, 4>(p).weights);
  group.weights("omega~", {"8", "4", "22/15", "43/45"}, dehomogenize<S, 4>(q).weights);
  group.functions("~ by (5.2)", {"8", "4", "3"}, moebius_functions(net.f, data.b));
  group.functions("~ of the last cell", {"8", "4", "3"}, cell_functions<S>(net.u, p, q, 2));
}

template <class S>
void elevation(const Section8Net<S>& net, std::vector<ExampleValue<S>>& values) {
  ExampleGroup<S> group(values, "degree elevation");
  const S zero = from_int<S>(0);
  const S one = from_int<S>(1);
  const Linear<S> unit{one, zero};
  const WeightedPoints<S, 3> c = dehomogenize<S, 4>(times_linear(net.p, unit));
  const WeightedPoints<S, 3> d = dehomogenize<S, 4>(times_linear(net.q, unit));
  const std::vector<std::vector<std::string>> c_printed{
      {"0", "0", "0"}, {"9/4", "9/4", "0"}, {"27/8", "3", "0"}, {"341/79", "162/79", "0"}, {"5", "0", "0"}};
  const std::vector<std::vector<std::string>> d_printed{{"0", "0", "2"},
                                                        {"3/2", "3/2", "11/4"},
                                                        {"93/52", "81/52", "225/52"},
                                                        {"887/568", "189/568", "3645/568"},
                                                        {"293/172", "-189/172", "1215/172"}};
  for (std::size_t i = 0; i < 5; ++i) group.point("c~_" + std::to_string(i), c_printed[i], c.points[i]);
  for (std::size_t i = 0; i < 5; ++i) group.point("d~_" + std::to_string(i), d_printed[i], d.points[i]);
  group.weights("w~", {"1", "1", "4/5", "79/120", "5/6"}, c.weights);
  group.weights("omega~", {"1", "1", "13/15", "71/90", "43/45"}, d.weights);
  const BlossomFunctions<S> at0 = elevated_functions(3, zero, net.f, unit, unit);
  const BlossomFunctions<S> at1 = elevated_functions(3, one, net.f, unit, unit);
  group.pattern("Lambda~(u)", "% u + %", {"-1/3", "-16/9"}, {at1.lambda - at0.lambda, at0.lambda});
  group.pattern("M~(u)", "% u + %", {"-1/3", "-8/3"}, {at1.m - at0.m, at0.m});
  group.weights("sigma~(0), sigma~(1)", {"1", "1"}, {at0.sigma, at1.sigma});
}

template <class S>
void trimming(const Section8Data<S>& data, const Section8Net<S>& net, std::vector<ExampleValue<S>>& values) {
  ExampleGroup<S> group(values, "trimming with g = 1 - 3t/4");
  const S zero = from_int<S>(0);
  const S one = from_int<S>(1);
  const Linear<S> unit{one, zero};
  // The functions at 0, 1, -1 times the printed denominators: numerators of degree 2 and 1.
  std::vector<BlossomFunctions<S>> at;
  for (const S& t : {zero, one, -one}) at.push_back(shortened_functions(3, t, net.f, unit, data.g));
  const S l0 = from_int<S>(9) * at[0].lambda;
  const S l1 = from_int<S>(-9) * at[1].lambda;
  const S l2 = from_int<S>(27) * at[2].lambda;
  const S m0 = from_int<S>(3) * at[0].m;
  const S m1 = from_int<S>(-3) * at[1].m;
  const S two = one + one;
  group.pattern("Lambda~(t)", "(% t^2 + % t + %)/(9 (1 - 2t))", {"9", "-3", "-32"},
                {(l1 + l2) / two - l0, (l1 - l2) / two, l0});
  group.pattern("M~(t)", "(% t + %)/(3 (1 - 2t))", {"7", "-16"}, {m1 - m0, m0});
  group.weights("sigma~(0), sigma~(1), sigma~(-1)", {"1", "1", "1"}, {at[0].sigma, at[1].sigma, at[2].sigma});
  // Beyond the interpolated values the printed functions are evaluated.
  const BlossomFunctions<S> check = shortened_functions(3, from_int<S>(3), net.f, unit, data.g);
  group.functions("~(t) as printed, at t = 3", {"-8/9", "-1/3", "1"}, check);
}

template <class S>
void insertion(const Section8Data<S>& data, const Section8Net<S>& net, std::vector<ExampleValue<S>>& values) {
  ExampleGroup<S> group(values, "knot 2/3 inserted");
  const Spline<S, Vec<S, 4>> p = insert_knot(Spline<S, Vec<S, 4>>(net.u, net.p), data.knot, 2);
  const Spline<S, Vec<S, 4>> q = insert_knot(Spline<S, Vec<S, 4>>(net.u, net.q), data.knot, 2);
  for (int i = 0; i < p.knots.last(); ++i) {
    group.functions(" of cell " + std::to_string(i), {"-4/3", "-2", "1"},
                    cell_functions<S>(p.knots, p.control, q.control, i));
  }
}

}  // namespace detail

/// Every printed item of the section, in its order.
template <class S>
std::vector<ExampleValue<S>> section8(const Section8Data<S>& data = {}) {
  const Section8Net<S> net(data);
  std::vector<ExampleValue<S>> values;
  detail::construction(net, values);
  detail::moebius(data, net, values);
  detail::elevation(net, values);
  detail::trimming(data, net, values);
  detail::insertion(data, net, values);
  return values;
}

/// The same as text.
template <class S>
std::vector<ExampleRow> section8_rows() {
  std::vector<ExampleRow> rows;
  for (const ExampleValue<S>& value : section8<S>()) rows.push_back(value.row());
  return rows;
}

}  // namespace torse::proofs
