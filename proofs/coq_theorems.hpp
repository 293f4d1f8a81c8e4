// The theorems of proofs/coq that Coq's kernel accepts without axioms, by claim. Written by `./x coq`; do not edit.
//   CoqTheorem, coq_theorems
#pragma once

#include <array>
#include <string_view>

namespace torse::proofs {

/// A machine-checked theorem and the claim that it proves, for every degree and every number of pieces.
struct CoqTheorem {
  std::string_view claim;
  std::string_view name;
};

// clang-format off
inline constexpr std::array<CoqTheorem, 79> coq_theorems{
    CoqTheorem{"FJ07.1", "FJ07_1_curvature"},
    CoqTheorem{"FJ07.2", "FJ07_2_ruling"},
    CoqTheorem{"FJ07.3", "FJ07_3_normals"},
    CoqTheorem{"FJ07.3", "FJ07_3_blossoms"},
    CoqTheorem{"FJ07.4", "FJ07_4_cylinder"},
    CoqTheorem{"FJ07.8", "FJ07_8_quadratic"},
    CoqTheorem{"FJ07.9", "FJ07_9_curve"},
    CoqTheorem{"FJ07.10", "FJ07_10_star"},
    CoqTheorem{"FJ07.10", "FJ07_10_recursion"},
    CoqTheorem{"FJ07.10", "FJ07_10_jump"},
    CoqTheorem{"FJ07.10", "FJ07_10_unique"},
    CoqTheorem{"FJ07.11", "FJ07_11_recursion"},
    CoqTheorem{"FJ07.11", "FJ07_11_cylinder"},
    CoqTheorem{"FJ07.11", "FJ07_11_cone"},
    CoqTheorem{"FJ07.11", "FJ07_11_needs_mu"},
    CoqTheorem{"FJ07.12", "FJ07_12_aumann"},
    CoqTheorem{"FJ07.12", "FJ07_12_barycentric"},
    CoqTheorem{"FJ07.13", "FJ07_13_exists"},
    CoqTheorem{"FJ07.13", "FJ07_13_unique"},
    CoqTheorem{"FJ07.13", "FJ07_13_knot"},
    CoqTheorem{"FJ07.13", "FJ07_13_knot_line"},
    CoqTheorem{"FJ07.13", "FJ07_13_rulings"},
    CoqTheorem{"FJ07.13", "FJ07_13_needs_off"},
    CoqTheorem{"FJ07.14", "FJ07_14_closed"},
    CoqTheorem{"FJ07.15", "FJ07_15_closed"},
    CoqTheorem{"FJ07.16", "FJ07_16_closed"},
    CoqTheorem{"FJ07.17", "FJ07_17_restriction"},
    CoqTheorem{"FJ07.17", "FJ07_17_swap"},
    CoqTheorem{"FJ07.18", "FJ07_18_cell"},
    CoqTheorem{"FJ07.18", "FJ07_18_recursion"},
    CoqTheorem{"FJ07.18", "FJ07_18_cylinder"},
    CoqTheorem{"FJ07.18", "FJ07_18_cone"},
    CoqTheorem{"FJ07.18", "FJ07_18_cone_sides"},
    CoqTheorem{"FJ07.C1", "FJ07_C1_blossoms"},
    CoqTheorem{"FJ07.C1", "FJ07_C1_cells"},
    CoqTheorem{"FJ07.C2", "FJ07_C2_cylinder"},
    CoqTheorem{"FJ07.C2", "FJ07_C2_spans"},
    CoqTheorem{"FJ07.C3", "FJ07_C3_velocity"},
    CoqTheorem{"FJ07.C3", "FJ07_C3_regular"},
    CoqTheorem{"FJ07.T1", "FJ07_T1_piece"},
    CoqTheorem{"FJ07.T1", "FJ07_T1_developable"},
    CoqTheorem{"FJ21.3.5", "FJ21_3_5_tangent"},
    CoqTheorem{"FJ21.4.1", "FJ21_4_1_parameter"},
    CoqTheorem{"FJ21.4.3", "FJ21_4_3_gauge"},
    CoqTheorem{"FJ21.5.2", "FJ21_5_2_blossom"},
    CoqTheorem{"FJ21.5.3", "FJ21_5_3_elevation"},
    CoqTheorem{"FJ21.6", "FJ21_6_edge"},
    CoqTheorem{"FJ21.6.1", "FJ21_6_1_degree"},
    CoqTheorem{"FJ21.7.1", "FJ21_7_1_polarisation"},
    CoqTheorem{"FJ21.C4.1", "FJ21_C4_1_relation"},
    CoqTheorem{"FJ21.C4.1", "FJ21_C4_1_frame"},
    CoqTheorem{"FJ21.T6.1", "FJ21_T6_1_tangent"},
    CoqTheorem{"FJ21.W", "FJ21_W_weights"},
    CoqTheorem{"ZW06.5", "ZW06_5_condition"},
    CoqTheorem{"ZW06.9", "ZW06_9_derivative"},
    CoqTheorem{"ZW06.11", "ZW06_11_cone"},
    CoqTheorem{"ZW06.12", "ZW06_12_unique"},
    CoqTheorem{"ZW06.13", "ZW06_13_unique"},
    CoqTheorem{"ZW06.15", "ZW06_15_tangent"},
    CoqTheorem{"ZW06.16", "ZW06_16_recursion"},
    CoqTheorem{"ZW06.16", "ZW06_16_closed"},
    CoqTheorem{"ZW06.17", "ZW06_17_unique"},
    CoqTheorem{"ZW06.18", "ZW06_18_recursion"},
    CoqTheorem{"ZW06.20", "ZW06_20_unique"},
    CoqTheorem{"BZZ19.4", "BZZ19_4_derivative"},
    CoqTheorem{"BZZ19.5", "BZZ19_5_steps"},
    CoqTheorem{"BZZ19.5", "BZZ19_5_slope"},
    CoqTheorem{"BZZ19.5", "BZZ19_5_monotone"},
    CoqTheorem{"BZZ19.6", "BZZ19_6_determinant"},
    CoqTheorem{"BZZ19.6", "BZZ19_6_condition"},
    CoqTheorem{"BZZ19.7", "BZZ19_7_common"},
    CoqTheorem{"BZZ19.7", "BZZ19_7_normal"},
    CoqTheorem{"BZZ19.8", "BZZ19_8_product"},
    CoqTheorem{"BZZ19.13", "BZZ19_13_composition"},
    CoqTheorem{"BZZ19.14", "BZZ19_14_power"},
    CoqTheorem{"BZZ19.14", "BZZ19_14_bernstein"},
    CoqTheorem{"BZZ19.15", "BZZ19_15_elevation"},
    CoqTheorem{"BZZ19.W", "BZZ19_W_product"},
    CoqTheorem{"BZZ19.W", "BZZ19_W_sine"},
};
// clang-format on

}  // namespace torse::proofs
