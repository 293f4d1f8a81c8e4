// The papers' worked examples as JSON.
//   examples_json        {"torse": 1, "examples": [...]}        examples_section     for a page
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

#include "torse/proofs/examples/fj21_section8.hpp"

namespace torse::cli {

/// What `torse example --json` writes of these rows of FJ21, section 8.
nlohmann::ordered_json examples_json(const std::vector<proofs::ExampleRow>& rows);

/// The section of a page: the values in rational numbers, and pictures of the surfaces.
nlohmann::ordered_json examples_section();

}  // namespace torse::cli
