// What torse fit says of a strip.
//   FitTitle           which rails, which method, in the words of the command line
//   fit_json           for machines, docs/formats.md
//   fit_svg            as a picture     fit_text           for people
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "torse/cli/fitting.hpp"
#include "torse/cli/terminal.hpp"

namespace torse::cli {

/// The names that a report repeats.
struct FitTitle {
  std::string file;  ///< printable
  std::string name;
  std::string method;
  std::string measure;
  std::string ends;
};

/// The entry of "surfaces".
nlohmann::ordered_json fit_json(const FitTitle& title, const FittedStrip& strip);

/// A picture: the strip before and after with its warp in colours, the mapping, the warp along the rail and the
/// convergence curve.
std::string fit_svg(const FitTitle& title, const FittedStrip& strip);

/// Several lines.
std::string fit_text(const FitTitle& title, const FittedStrip& strip, const Terminal& terminal);

}  // namespace torse::cli
