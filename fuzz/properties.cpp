#include "torse/fuzz/properties.hpp"

#include "torse/fuzz/properties/double_net.hpp"
#include "torse/fuzz/properties/number_text.hpp"

namespace torse::fuzz {

const std::vector<const Property*>& properties() {
  static const std::vector<const Property*> list{
      &property<NumberText>(),
      &property<DoubleNetProperty>(),
  };
  return list;
}

const Property* find_property(std::string_view name) {
  for (const Property* property : properties()) {
    if (property->info().name == name) return property;
  }
  return nullptr;
}

}  // namespace torse::fuzz
