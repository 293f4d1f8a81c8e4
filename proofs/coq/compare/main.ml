(* Reads a problem a line, `NAME KEY=VALUE ...`, and prints the answer that the program NAME extracted from proofs/coq gives over the rational
   numbers of Zarith: its fractions, or `error` and what is wrong. Numbers in a list are separated by commas, points by semicolons. Running error
   analysis, which is of doubles, is in doubles.ml. *)
open Programs

let field = {
  zero = Q.zero; one = Q.one; sadd = Q.add; ssub = Q.sub; smul = Q.mul; same = Q.equal; less = Q.lt;
  sinv = fun x -> if Q.sign x = 0 then Q.zero else Q.inv x }

(* Points are lists of coordinates. *)
let space dimension = {
  origin = List.init dimension (fun _ -> Q.zero); padd = List.map2 Q.add; psub = List.map2 Q.sub; pscale = fun a -> List.map (Q.mul a) }

let pieces separator text = if text = "" then [] else String.split_on_char separator text

let member problem key =
  match List.assoc_opt key problem with
  | Some text -> text
  | None -> failwith ("no " ^ key)

let integer problem key = int_of_string (member problem key)
let number problem key = Q.of_string (member problem key)
let list_of text = List.map Q.of_string (pieces ',' text)
let numbers problem key = list_of (member problem key)
let points problem key = List.map list_of (pieces ';' (member problem key))
let point problem key = list_of (member problem key)
let pairs problem key = List.map (function [a; w] -> (a, w) | _ -> failwith key) (points problem key)
let dimension problem = match points problem "c" with p :: _ -> List.length p | [] -> 3

let reason = function
  | Division -> "division" | Degree -> "degree" | Knots -> "knots" | Knot i -> Printf.sprintf "knots[%d]" i | Vertices -> "points"
  | At_knot -> "M" | Vertex -> "k" | Cell i -> Printf.sprintf "cell[%d]" i | Sigma -> "sigma" | Outside -> "t" | Lambda -> "Lambda"
  | Weight i -> Printf.sprintf "weights[%d]" i | Rho -> "rho" | Factor -> "s" | Alpha -> "alpha" | Parallel -> "v"
  | Lengths -> "lengths" | Equation -> "a" | Directrix -> "c.points"

let answer numbers = function
  | Value a -> String.concat " " (List.map Q.to_string (numbers a))
  | Fails why -> "error " ^ reason why

let of_point = answer Fun.id
let of_points = answer List.concat

(* The keys of a spline, a row over it and what (13) asks for, applied to a program. *)
let spline program p = program field (space (dimension p)) (integer p "n") (numbers p "u") (points p "c")
let row program p = spline program p (number p "L") (number p "M")

let over_knots program p = program field (integer p "n") (numbers p "u")

(* Three functions x at the parameter t; two factors of degree one. *)
let functions program p = match numbers p "x" with
  | [a; b; c] -> of_point (program field (integer p "n") (number p "t") a b c)
  | _ -> failwith "x"
let with_factors program p = match numbers p "x", numbers p "f", numbers p "g" with
  | [a; b; c], [f0; f1], [g0; g1] -> of_point (program field (integer p "n") (number p "t") a b c f0 f1 g0 g1)
  | _ -> failwith "x"

(* Coordinates of points and of homogeneous rows. *)
let x p = List.nth p 0 and y p = List.nth p 1 and z p = List.nth p 2 and t p = List.nth p 3

(* End rulings v, w, and a branch. *)
let with_rulings program p = spline (fun k s -> program k s x y z) p (point p "v") (point p "w") (number p "M") (number p "L")

(* A Bezier curve c, whose row is always there. *)
let of_directrix program p = of_points (Value (program field (space 3) (points p "c")))

(* Bernstein coefficients a and b, a directrix c with rulings d. *)
let vanishes = List.for_all (fun x -> Q.sign x = 0)
let of_rulings = function
  | Contradiction (s, r) -> Q.zero :: s @ r
  | Only tau -> Q.one :: List.concat tau
  | Family (tau, kappa) -> Q.of_int 2 :: List.concat tau @ kappa

(* A vector N, a ruling w and the tangents a and b at its ends. *)
let of_tangents program p = program field x y z (point p "v") (point p "d") (point p "a") (point p "b")

(* Running results, given by the bits of their values and bounds. *)
let bits p key = List.map Z.of_string (pieces ',' (member p key))
let one_running operation p = Doubles.one operation (bits p "x")
let two_running operation p = Doubles.two operation (bits p "x") (bits p "y")

let programs = [
  "knots", (fun p -> answer (fun () -> []) (knot_list field (integer p "n") (numbers p "u") (Value ())));
  "blossom", (fun p -> of_point (spline blossom_program p (integer p "k") (pairs p "v")));
  "point", (fun p -> of_point (spline point_program p (integer p "k") (number p "t")));
  "derivative", (fun p -> of_point (spline derivative_program p (integer p "k") (number p "t")));
  "net", (fun p -> of_points (row net_program p 0 (point p "d")));
  "net_from", (fun p -> of_points (row net_program p (integer p "i") (point p "d")));
  "printed_net", (fun p -> of_points (row net_program p (integer p "i") (point p "d")));
  "products", (fun p -> of_point (over_knots products_program p (number p "M") (integer p "a") (integer p "b")));
  "eq14", (fun p -> of_point (row closed14_program p (point p "d") (integer p "i")));
  "eq15", (fun p -> of_point (row closed15_program p (point p "d") (integer p "i")));
  "eq16", (fun p -> of_point (row closed16_program p (point p "d") (integer p "i")));
  "local_parameter", (fun p -> of_point (over_knots local_program p (number p "t") (integer p "k")));
  "next_local", (fun p -> of_point (over_knots next_local_program p (number p "t") (integer p "k")));
  "affine_from_local", (fun p -> of_point (affine_program field (number p "L") (number p "M")));
  "next_affine", (fun p -> of_point (over_knots next_affine_program p (number p "l") (number p "m") (integer p "k")));
  "aumann_net", (fun p -> of_points (aumann_program field (space 3) (points p "c") (number p "L") (number p "M") (point p "d")));
  "first_cell", (fun p -> of_point (over_knots first_cell_program p (number p "L") (number p "M")));
  "next_cell", (fun p -> of_point (over_knots next_cell_program p (number p "l") (number p "m") (integer p "i")));
  "cell_net", (fun p -> of_points (spline cell_program p (number p "l") (number p "m") (point p "d")));
  "restrict_rulings", (fun p -> of_points (Value (restricted_program (space 3) (points p "c") (points p "d") (number p "x"))));
  "determinant", (fun p -> of_point (spline (fun k v -> determinant_program k v x y z) p (points p "d") (integer p "k") (number p "t")));
  "find_witness", (fun p -> answer (fun k -> [Q.of_int k]) (spline (fun k v -> check_program k v x y z) p (points p "d")));
  "to_blossom", functions to_blossom_program;
  "to_frame", functions to_frame_program;
  "standard_parameter", (fun p -> match numbers p "x" with [v; w; o] -> of_point (standard_program field v w o) | _ -> failwith "x");
  "gauged", (fun p -> match numbers p "x" with [a; b; c] -> of_point (gauge_program field a b c (number p "a") (number p "b")) | _ -> failwith "x");
  "scaled_weights", (fun p -> match numbers p "x" with [a; b; c] -> of_point (weights_program field a b c (number p "a") (number p "b")) | _ -> failwith "x");
  "edge", functions edge_program;
  "unelevated", with_factors unelevated_program;
  "elevated_functions", with_factors elevated_program;
  "restricted_points", (fun p -> of_points (spline pieces_program p (integer p "k") (number p "a") (number p "b")));
  "bezier_points", (fun p -> of_points (spline bezier_program p (integer p "k")));
  "insert_knot", (fun p -> answer (fun (u, c) -> u @ List.concat c) (spline insertion_program p (number p "t")));
  "coefficients_from_steps", (fun p -> of_point (Value (steps_program field (numbers p "e"))));
  "elevated_points", (fun p -> of_points (Value (elevation_program field (space 3) (points p "c") (integer p "i"))));
  "cone_net", (fun p -> of_points (Value (cone_program (space 3) (points p "c") (number p "x") (point p "d"))));
  "start_cone_net", (fun p -> of_points (start_cone_program field (space 3) (points p "c") (number p "s")));
  "mean_tangent_net", of_directrix mean_tangent_program;
  "tangent_net", of_directrix tangent_program;
  "mean_chord_net", of_directrix mean_chord_program;
  "affine_net", (fun p -> of_points (Value (affine_net_program (space 3) (points p "c") (number p "x") (number p "s") (point p "d"))));
  "from_dependence", (fun p -> match numbers p "x" with [a; b; c; d] -> of_point (dependence_program field a b c d) | _ -> failwith "x");
  "moebius_parameter", (fun p -> of_point (moebius_program field (number p "a") (number p "t")));
  "moebius_rows", (fun p -> of_points (Value (moebius_rows field (space 3) (number p "a") (points p "c"))));
  "moebius_functions", (fun p -> match numbers p "x" with [a; b; c] -> of_point (moebius_functions_program field a b c (number p "a")) | _ -> failwith "x");
  "unshortened", with_factors unshortened_program;
  "shortened_functions", with_factors shortened_program;
  "times_linear", (fun p -> match numbers p "f" with [a; b] -> of_points (Value (times_program field (space 3) (points p "c") a b)) | _ -> failwith "f");
  "edge_curve", (fun p -> match numbers p "x" with
    [a; b; c] -> of_points (edge_rows_program field (space 3) (points p "c") (points p "d") a b c) | _ -> failwith "x");
  "edge_patch", (fun p -> of_points (Value (patch_program field (space 3) (points p "c") (number p "x"))));
  "determinant4", (fun p -> of_point (spline (fun k v -> determinant4_program k v x y z t) p (points p "d") (integer p "k") (number p "t")));
  "find_witness4", (fun p -> answer (fun k -> [Q.of_int k]) (spline (fun k v -> check4_program k v x y z t) p (points p "d")));
  "eq20", (fun p -> of_point (spline aim_program p (number p "M") (integer p "i")));
  "branch_polynomial", (fun p -> of_point (spline (fun k s -> branch_program k s x y z) p (point p "v") (point p "w")));
  "chord_coordinates", (fun p -> of_point (coordinates_program field x y z (point p "d") (point p "v") (point p "w")));
  "end_rulings", (fun p -> of_point (with_rulings ends_program p));
  "interpolating_net", (fun p -> of_points (with_rulings interpolation_program p));
  "piecewise_net", (fun p -> answer (fun rows -> List.concat (List.concat rows)) (row rows_program p (point p "d")));
  "mapping_value", (fun p -> of_point (spline mapping_value_program p (number p "t")));
  "mapping_slope", (fun p -> of_point (spline mapping_slope_program p (number p "t")));
  "identity_mapping", (fun p -> of_point (over_knots greville_program p));
  "pointwise_sine_squared", (fun p -> of_point (spline (fun k v -> warp_program k v x y z) p (points p "d") (integer p "k") (number p "t")));
  "composed_points", (fun p -> of_points (composed_program field (space (dimension p)) (points p "c") (numbers p "e")));
  "bezier_rows", (fun p -> of_point (bernstein_program field (numbers p "f") (integer p "n") (number p "a") (number p "b")));
  "piece_polynomials", (fun p -> of_point (over_knots polynomial_program p (numbers p "f") (integer p "k")));
  "cylinder_net", (fun p -> of_points (cylinder_program field (space 3) (points p "c") (point p "v") (numbers p "h")));
  "cone_vertex", (fun p -> of_point (apex_program field (space 3) (point p "v") (point p "d") (number p "x")));
  "restricted_lambda", (fun p -> of_point (Value [restricted_lambda field (number p "L") (number p "M") (number p "x")]));
  "tangent_point", (fun p -> of_point (spline tangent_point_program p (integer p "k") (number p "t") (number p "a", number p "w")));
  "last_pair", (fun p -> of_points (spline last_pair_program p (integer p "k") (number p "t")));
  "cell_functions", (fun p -> of_point (spline (fun k v -> functions_program k v x y z t) p (points p "d") (integer p "i")));
  "is_cone_equation", (fun p -> of_point (Value [if is_cone field (numbers p "a") (numbers p "b") then Q.one else Q.zero]));
  "solve_directrix", (fun p -> answer of_rulings (directrix_program field (space 3) vanishes (points p "c") (numbers p "a") (numbers p "b")));
  "times_polynomial", (fun p -> of_points (Value (times_rows field (space 3) (numbers p "b") (points p "c"))));
  "directrix_edge", (fun p -> of_points (Value (edge_of field (space 3) (points p "c") (points p "d") (numbers p "b"))));
  "directrix_vertex", (fun p -> of_point (vertex_of_cone field (space 3) (points p "c") (points p "d") (numbers p "a") (numbers p "b")));
  "aumann_equation", (fun p -> answer (fun (a, b) -> a @ b) (equation_program field (integer p "n") (number p "x") (number p "s")));
  "cell_point", (fun p -> of_point (spline side_program p (integer p "i") (number p "t")));
  "eq16_rulings", (fun p -> of_points (row rulings_program p (point p "d")));
  "derivative_sum", (fun p -> of_point (spline slope_program p (integer p "k") (number p "t")));
  "spline_vertex", (fun p -> of_point (vertex_program field (space 3) (integer p "n") (numbers p "u") (points p "c") (integer p "k") (integer p "i")));
  "ruling_determinant", (fun p -> of_point (Value [determinant_of field x y z (point p "d") (point p "a") (point p "b")]));
  "normal_products", (fun p -> of_point (Value (of_tangents products_of p)));
  "normal_residual", (fun p -> of_point (Value [of_tangents squares_of p]));
  "unit_penalty", (fun p -> of_point (Value [unit_of field x y z (point p "v")]));
  "refined", (fun p -> of_points (spline refined_program p (numbers p "v")));
  "elevate", (fun p -> answer (fun (u, c) -> u @ List.concat c) (spline raised_program p));
  "breakpoints", (fun p -> let n = integer p "n" and u = numbers p "u" and v = numbers p "v" in
    of_point (knot_list field n u (knot_list field n v (Value (breaks field n u v)))));
  "quasi_surface", (fun p -> answer (fun ((u, c), d) -> u @ List.concat c @ List.concat d)
    (spline surface_program p (integer p "p") (numbers p "v") (points p "e") (integer p "d") (numbers p "w") (numbers p "b") (integer p "s" = 1)));
  "rational_net", (fun p -> of_points (row rational_program p (number p "s") (point p "d")));
  "running_sum", two_running Running.plus_running;
  "running_difference", two_running Running.minus_running;
  "running_product", two_running Running.times_running;
  "running_quotient", two_running Running.over_running;
  "running_opposite", one_running Running.opposite_running;
  "running_root", one_running Running.root_running;
  "running_number", (fun p -> Doubles.(answer (Running.of_number prec emax (number (Z.of_string (member p "x"))))));
  "running_integer", (fun p -> Doubles.(answer (Running.of_int prec emax (integer (Z.of_string (member p "x"))))));
  "running_is_zero", (fun p -> Doubles.(decided (Running.is_zero prec emax (running (bits p "x")))));
  "running_less", (fun p -> Doubles.(decided (Running.is_less prec emax (running (bits p "x")) (running (bits p "y")))));
]

let solve line =
  match pieces ' ' line with
  | name :: members ->
    let split text = let i = String.index text '=' in (String.sub text 0 i, String.sub text (i + 1) (String.length text - i - 1)) in
    List.assoc name programs (List.map split members)
  | [] -> failwith "an empty line"

let () =
  try
    while true do
      print_endline (solve (input_line stdin))
    done
  with End_of_file -> ()
