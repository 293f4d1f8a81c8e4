#include "torse/fuzz/properties/construction.hpp"

#include "torse/developable/condition.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/plain/truth.hpp"

namespace torse::fuzz {

const PropertyInfo& Construction::info() {
  static const PropertyInfo info{
      "construct",
      "every construction keeps its promise and is developable, and is the same in fractions, prime fields and balls",
      12,
      {"method=13",         "method=7.1",
       "method=14",         "method=15",
       "method=16",         "method=16 rulings",
       "method=18",         "method=pieces",
       "method=cylinder",   "method=cone",
       "method=tangent",    "method=part",
       "method=start cone", "method=mean tangent",
       "method=mean chord", "method=affine",
       "method=directrix",  "method=interpolate",
       "method=moebius",    "method=edge",
       "method=factors",    "method=elevate",
       "method=insert",     "arithmetic=Q",
       "arithmetic=cpp",    "arithmetic=Z/p",
       "arithmetic=batch",  "arithmetic=ball",
       "knots=extreme",     "knots=full",
       "knots=unclamped",   "Lambda=huge",
       "Lambda=knot",       "M=near",
       "M=inside"},
      {"ball=decided"}};
  return info;
}

Construction::In Construction::draw(Choices& choices, const Scale& scale, Labels& labels) {
  In in;
  const std::string_view method = construction_names[choices.below(construction_names.size())];
  in.input = draw_construction(choices, scale, method);
  in.arithmetic = choices.pick({"Q", "cpp", "Z/p", "batch", "ball"});
  in.prime = choices.between(0, 1000);
  labels.add("method", in.input.method);
  labels.add("arithmetic", in.arithmetic);
  labels.add("degree", in.input.knots.degree());
  labels.add("knots", std::string(knot_kind(in.input.knots)));
  labels.add("Lambda", std::string(parameter_kind(in.input.knots, in.input.functions.lambda)));
  labels.add("M", std::string(parameter_kind(in.input.knots, in.input.functions.m)));
  return in;
}

void Construction::check(const In& in, Labels& labels) {
  const auto same = [](const Rational& x) { return x; };
  const SurfaceOver<Rational> exact = construct<Rational>(in.input.method, ingredients<Rational>(in.input, same));
  require_promise(in.input, exact);
  require(!find_witness<Rational, 4>(exact.knots, exact.c_row(), exact.d_row()), "a witness against developability");
  require(!plain::refuted(plain::strip_of(exact.knots, exact.c, exact.d)), "the surface is twisted somewhere");
  if (in.arithmetic == "cpp") require_in_cpp(in, exact);
  if (in.arithmetic == "Z/p") require_in_prime_field(in, exact);
  if (in.arithmetic == "batch") require_in_batch(in, exact);
  if (in.arithmetic == "ball") labels.add("ball", hold_in_balls(in, exact) ? "decided" : "open");
}

}  // namespace torse::fuzz
