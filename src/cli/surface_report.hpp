// What check and recover both say of a surface, as JSON and in words.
//   face_json                     which face it is
//   point_json, witness_json      a point, what refutes developability
//   quick_singularities           of a file
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

/// Where a developable surface is singular; none where its numbers have too many bits to find that out beside a
/// decision
/// (`torse recover` does it all the same).
std::optional<std::vector<SingularSet>> quick_singularities(const RuledFile<Rational>& surface);

/// [{"reason", "from", "to"}]: a bound is "p/q", or {"lo", "hi", "zero_of": [integers]} where it is irrational.
nlohmann::ordered_json singular_json(const std::vector<SingularSet>& sets);

/// "regular" or "singular at u = 1/2 (vanishing), 1/4 to about 0.667 (edge)", at most `most` of them.
std::string singular_text(const std::vector<SingularSet>& sets, std::size_t most);

}  // namespace torse::cli
