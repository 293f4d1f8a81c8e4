// What a call refuses.
//   place_of    the place that its error names
//   told        the whole text of its error
#pragma once

#include <string>

#include "torse/scalar/errors.hpp"

namespace torse::test {

/// The place that a call's InvalidInput names, or "" if it does not throw.
template <class Call>
std::string place_of(Call call) {
  try {
    static_cast<void>(call());
  } catch (const InvalidInput& error) {
    return error.place();
  }
  return {};
}

/// What a call's InvalidInput says, or "" if it does not throw.
template <class Call>
std::string told(Call call) {
  try {
    static_cast<void>(call());
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace torse::test
