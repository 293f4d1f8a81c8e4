// The properties, in one list.
//   properties      all of them          find_property      one by its name
#pragma once

#include <string_view>
#include <vector>

#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// All properties, by name. A new one is one line in properties.cpp; a test counts them.
const std::vector<const Property*>& properties();

/// The property of this name; null if there is none.
const Property* find_property(std::string_view name);

}  // namespace torse::fuzz
