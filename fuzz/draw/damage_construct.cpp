// Damages of constructions alone. One that does not apply returns no place.
#include <array>

#include "torse/fuzz/draw/damages.hpp"
#include "torse/fuzz/draw/json_places.hpp"

namespace torse::fuzz {
namespace {

using Place = std::optional<std::string>;

Place unknown_method(Choices& choices, JsonTree& root) {
  *root.find("method") = json_string(choices.pick<const char*>({"spline", "Cone", "", "bspline "}));
  return "method";
}

Place zero_factor(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"sigma", "omega0"});
  JsonTree* value = root.find(key);
  if (value == nullptr) return std::nullopt;
  *value = json_number(choices.pick<const char*>({"0", "0/3", "-0"}));
  return key;
}

Place polynomial_size(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"a", "b"});
  JsonTree* polynomial = root.find(key);
  if (polynomial == nullptr) return std::nullopt;
  polynomial->items.assign(choices.once_in(2) ? 102 : 0, json_literal("1"));
  return key;
}

Place key_of_another_method(Choices& choices, JsonTree& root) {
  const char* key = choices.pick<const char*>({"Lambda", "M", "sigma", "d0", "omega0", "va", "vb", "a", "b", "v"});
  const std::string& method = root.find("method")->text;
  if (root.find(key) != nullptr || method == "cylinder" || method == "directrix") return std::nullopt;
  root.add(key, json_literal("1"));
  return key;
}

Place weights_of_a_polynomial_method(Choices& choices, JsonTree& root) {
  const std::string& method = root.find("method")->text;
  if (method == "rational" || method == "cylinder" || method == "cone") return std::nullopt;
  JsonTree* c = root.find("c");
  if (c->find("weights") == nullptr) return std::nullopt;
  std::vector<JsonTree>& weights = c->find("weights")->items;
  weights[choices.below(weights.size())] = json_literal(choices.pick<const char*>({"2", "-1", "0.5"}));
  return "c.weights";
}

std::string construction(Choices& choices, DrawnFile& file) {
  constexpr std::array damages{unknown_method, zero_factor, polynomial_size, key_of_another_method,
                               weights_of_a_polynomial_method};
  const Place place = damages[choices.below(damages.size())](choices, file.tree);
  if (!place) throw Discard("nothing to damage");
  return *place;
}

}  // namespace

TreeDamage construction_damage() { return {"construction", construction}; }

}  // namespace torse::fuzz
