(* The programs of proofs/coq as OCaml: run by compare.py in build/coq/compare. Natural numbers become int; nothing else is replaced but
   booleans, lists, pairs and options by OCaml's own. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt.
From Flocq Require BinarySingleNaN.
From Torse Require Running.
From Torse Require Import Executable Executable_knots Executable_net Executable_pieces Executable_determinant Executable_FJ21 Executable_ZW06
  Executable_splines
  Executable_changes Executable_edge Executable_rational Executable_rulings Executable_rows
  Executable_mappings Executable_warp Executable_composition Executable_polynomials
  Executable_special Executable_recovery
  Executable_elimination Executable_directrix Executable_sums Executable_surface.

Extraction Language OCaml.
Extraction "programs.ml" knot_list blossom_program point_program derivative_program net_program
  products_program closed14_program closed15_program closed16_program local_program next_local_program affine_program next_affine_program aumann_program
  first_cell_program next_cell_program cell_program restricted_program determinant_program check_program
  to_blossom_program to_frame_program standard_program gauge_program weights_program edge_program unelevated_program elevated_program rational_program
  cone_program start_cone_program mean_tangent_program tangent_program mean_chord_program affine_net_program
  pieces_program bezier_program insertion_program steps_program elevation_program
  dependence_program moebius_program moebius_rows moebius_functions_program unshortened_program shortened_program
  times_program edge_rows_program patch_program determinant4_program check4_program
  aim_program branch_program coordinates_program ends_program interpolation_program rows_program
  mapping_value_program mapping_slope_program greville_program warp_program composed_program bernstein_program polynomial_program
  cylinder_program apex_program restricted_lambda tangent_point_program last_pair_program functions_program
  is_cone directrix_program times_rows edge_of vertex_of_cone equation_program
  side_program rulings_program slope_program determinant_of products_of squares_of unit_of vertex_program
  refined_program raised_program breaks surface_program.

Extraction "running.ml" Running.of_number Running.of_int Running.plus_running Running.minus_running Running.opposite_running Running.times_running
  Running.over_running Running.root_running Running.is_zero Running.is_less BinarySingleNaN.is_finite.
