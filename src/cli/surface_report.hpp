// What check and recover both say of a surface, as JSON and in words.
//   face_json                     which face it is
//   point_json, witness_json      a point, what refutes developability
//   quick_singularities           of a file
//   within_budget                 whether a surface is short enough for what takes long
//   singular_json, singular_text  where the patch is singular
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "torse/cli/faces.hpp"
#include "torse/developable/condition.hpp"
#include "torse/exact/decide/singularities.hpp"
#include "torse/io/spline_file.hpp"

namespace torse::cli {

/// {"file", "name", "face", "ruled", "developable": null, "class": "none"}, and "remark" for a face that is not ruled:
/// what is known of a face before it is judged.
nlohmann::ordered_json face_json(const Face& face);

/// ["p/q", "p/q", "p/q"].
nlohmann::ordered_json point_json(const Vec<Rational, 3>& x);

/// {"piece", "span", "coefficient", "value"}.
nlohmann::ordered_json witness_json(const DevelopabilityWitness<Rational>& witness, const KnotList<Rational>& knots);

/// Whether the knots, coordinates and weights of a surface have at most `most_bits` bits, numerators and denominators
/// counted; of degree n > 3 at most 3/n of them, since the degrees of all polynomials are multiples of it.
/// docs/formats.md lists the budgets.
bool within_budget(const RuledFile<Rational>& surface, std::size_t most_bits);

/// Where a developable surface is singular; none beyond the budget of a decision (`torse recover` has a larger one).
std::optional<std::vector<SingularSet>> quick_singularities(const RuledFile<Rational>& surface);

/// [{"reason", "from", "to"}]: a bound is "p/q", or {"lo", "hi", "zero_of": [integers]} where it is irrational.
nlohmann::ordered_json singular_json(const std::vector<SingularSet>& sets);

/// "regular" or "singular at u = 1/2 (vanishing), 1/4 to about 0.667 (edge)", at most `most` of them.
std::string singular_text(const std::vector<SingularSet>& sets, std::size_t most);

}  // namespace torse::cli
