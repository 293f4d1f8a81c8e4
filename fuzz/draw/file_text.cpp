#include "torse/fuzz/draw/file_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/draw/spelling.hpp"

namespace torse::fuzz {
namespace {

/// How a knot list and weights stand in a file.
enum class Knots { absent, papers, cad };

/// A method of `torse construct`, from the table of docs/formats.md: the keys that it needs and may have, whether it
/// takes knots and weights other than 1.
struct Method {
  std::string_view name;
  std::vector<std::string_view> needed;
  std::vector<std::string_view> optional;
  bool knots;
  bool weights;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> list{
      {"bspline", {"Lambda", "M", "d0"}, {}, true, false},
      {"bezier", {"Lambda", "M", "d0"}, {}, false, false},
      {"rational", {"Lambda", "M", "sigma", "d0", "omega0"}, {}, true, true},
      {"cylinder", {"d0"}, {"M", "Lambda"}, true, true},
      {"cone", {"Lambda", "d0"}, {}, true, true},
      {"tangent", {}, {}, true, false},
      {"interpolate", {"va", "vb", "Lambda"}, {}, true, false},
      {"directrix", {"a", "b"}, {"d0", "v"}, false, false},
  };
  return list;
}

bool is_vector(std::string_view key) { return key == "d0" || key == "va" || key == "vb" || key == "v"; }
bool is_polynomial(std::string_view key) { return key == "a" || key == "b"; }

Vec<Rational, 3> draw_point(Choices& choices, const Scale& scale) {
  Vec<Rational, 3> x;
  for (int j = 0; j < 3; ++j) x[j] = draw_number(choices, scale);
  return x;
}

/// A valid list: steps of which some are zero, but no n in a row and not those of the whole domain.
std::vector<Rational> draw_list(Choices& choices, const Scale& scale, int degree, int count) {
  std::vector<Rational> list{draw_number(choices, scale)};
  const int size = count - 1 + degree;
  const int inside = choices.between(degree, count - 1);
  int run = 1;
  for (int i = 1; i < size; ++i) {
    const bool step = i == inside || run == degree || choices.below(2) == 0;
    list.push_back(step ? list.back() + draw_positive(choices, scale) : list.back());
    run = step ? 1 : run + 1;
  }
  return list;
}

std::vector<Rational> unit_list(int degree) {
  std::vector<Rational> list(static_cast<std::size_t>(degree), Rational(0));
  list.insert(list.end(), static_cast<std::size_t>(degree), Rational(1));
  return list;
}

JsonTree number_tree(Choices& choices, const Rational& x) { return json_number(spelled(choices, x)); }

template <class List>
JsonTree list_tree(Choices& choices, const List& numbers) {
  JsonTree tree = json_array({});
  for (const Rational& x : numbers) tree.items.push_back(number_tree(choices, x));
  return tree;
}

JsonTree point_tree(Choices& choices, const Vec<Rational, 3>& x) {
  return list_tree(choices, std::vector<Rational>{x[0], x[1], x[2]});
}

/// Points and weights, and their members.
void draw_net(Choices& choices, const Scale& scale, int count, bool weights, SplineMeant& meant, JsonTree& object) {
  JsonTree points = json_array({});
  for (int i = 0; i < count; ++i) {
    meant.points.push_back(draw_point(choices, scale));
    points.items.push_back(point_tree(choices, meant.points.back()));
  }
  object.add("points", std::move(points));
  meant.weights.assign(static_cast<std::size_t>(count), Rational(1));
  if (choices.below(2) == 0) return;
  if (weights) std::ranges::generate(meant.weights, [&] { return draw_nonzero(choices, scale); });
  object.add("weights", list_tree(choices, meant.weights));
}

/// Degree and knots, and their members.
Knots draw_knots(Choices& choices, const Scale& scale, int degree, int count, SplineMeant& meant, JsonTree& object) {
  object.add("degree", json_literal(std::to_string(degree)));
  meant.degree = degree;
  meant.knots = unit_list(degree);
  if (count == degree + 1 && choices.below(2) == 0) return Knots::absent;
  meant.knots = draw_list(choices, scale, degree, count);
  if (choices.below(2) == 0) {
    object.add("knots", list_tree(choices, meant.knots));
    return Knots::papers;
  }
  const auto step = [&] { return choices.once_in(2) ? Rational(0) : draw_positive(choices, scale); };
  std::vector<Rational> cad{meant.knots.front() - step()};
  cad.insert(cad.end(), meant.knots.begin(), meant.knots.end());
  cad.push_back(cad.back() + step());
  object.add("knots", list_tree(choices, cad));
  return Knots::cad;
}

void add_label(Labels& labels, Knots knots) {
  labels.add("knots", knots == Knots::absent ? "absent" : knots == Knots::papers ? "papers" : "cad");
}

/// A curve with its own degree and knots.
void draw_curve(Choices& choices, const Scale& scale, Labels& labels, SplineMeant& meant, JsonTree& object) {
  const int degree = choices.between(1, scale.degree);
  const int count = degree + choices.between(1, scale.pieces);
  add_label(labels, draw_knots(choices, scale, degree, count, meant, object));
  draw_net(choices, scale, count, true, meant, object);
}

void draw_ruled(Choices& choices, const Scale& scale, Labels& labels, FileMeant& meant, JsonTree& root) {
  const int degree = choices.between(1, scale.degree);
  const int count = degree + choices.between(1, scale.pieces);
  add_label(labels, draw_knots(choices, scale, degree, count, meant.c, root));
  meant.d.degree = degree;
  meant.d.knots = meant.c.knots;
  for (SplineMeant* row : {&meant.c, &meant.d}) {
    JsonTree object;
    draw_net(choices, scale, count, true, *row, object);
    root.add(row == &meant.c ? "c" : "d", std::move(object));
  }
}

ParameterMeant draw_parameter(Choices& choices, const Scale& scale, std::string_view key, JsonTree& root) {
  ParameterMeant meant{std::string(key), {}};
  const int count = is_vector(key) ? 3 : is_polynomial(key) ? choices.between(1, 3) : 1;
  for (int i = 0; i < count; ++i) {
    const bool nonzero = key == "sigma" || key == "omega0";
    meant.numbers.push_back(nonzero ? draw_nonzero(choices, scale) : draw_number(choices, scale));
  }
  const bool list = is_vector(key) || is_polynomial(key);
  root.add(meant.key, list ? list_tree(choices, meant.numbers) : number_tree(choices, meant.numbers.front()));
  return meant;
}

void draw_construct(Choices& choices, const Scale& scale, Labels& labels, FileMeant& meant, JsonTree& root) {
  const Method& method = methods()[choices.below(methods().size())];
  meant.method = method.name;
  labels.add("method", meant.method);
  root.add("method", json_string(meant.method));
  const int degree = choices.between(1, scale.degree);
  const int count = degree + (method.knots ? choices.between(1, scale.pieces) : 1);
  if (method.knots) {
    add_label(labels, draw_knots(choices, scale, degree, count, meant.c, root));
  } else {
    root.add("degree", json_literal(std::to_string(degree)));
    meant.c.degree = degree;
    meant.c.knots = unit_list(degree);
  }
  JsonTree object;
  draw_net(choices, scale, count, method.weights, meant.c, object);
  root.add("c", std::move(object));
  for (const std::string_view key : method.needed)
    meant.parameters.push_back(draw_parameter(choices, scale, key, root));
  for (const std::string_view key : method.optional) {
    if (choices.once_in(2)) meant.parameters.push_back(draw_parameter(choices, scale, key, root));
  }
}

}  // namespace

DrawnFile draw_file(Choices& choices, const Scale& scale, Labels& labels) {
  DrawnFile file;
  FileMeant& meant = file.meant;
  JsonTree& root = file.tree;
  meant.type = choices.pick<const char*>({"curve", "ruled", "rails", "construct", "construct"});
  labels.add("type", meant.type);
  root.add("torse", json_literal("1"));
  root.add("type", json_string(meant.type));
  if (meant.type == "curve") draw_curve(choices, scale, labels, meant.c, root);
  if (meant.type == "ruled") draw_ruled(choices, scale, labels, meant, root);
  if (meant.type == "construct") draw_construct(choices, scale, labels, meant, root);
  if (meant.type == "rails") {
    JsonTree c;
    JsonTree d;
    draw_curve(choices, scale, labels, meant.c, c);
    draw_curve(choices, scale, labels, meant.d, d);
    root.add("c", std::move(c)).add("d", std::move(d));
  }
  return file;
}

}  // namespace torse::fuzz
