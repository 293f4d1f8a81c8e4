// The viewer of the HTML report: the page that web/ is built into, within the program.
//   viewer           the page, with the place `viewer_mark` for the data
#pragma once

#include <string_view>

namespace torse::cli {

/// Where the data of a report stand in the page.
inline constexpr std::string_view viewer_mark = "@report@";

/// The page; empty in a program that was built without it.
std::string_view viewer();

}  // namespace torse::cli
