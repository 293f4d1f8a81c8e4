(* The programs of proofs/coq as OCaml: run by compare.py in build/coq/compare. Natural numbers become int; nothing else is replaced but
   booleans, lists, pairs and options by OCaml's own. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt.
From Torse Require Import Executable Executable_knots Executable_net.

Extraction Language OCaml.
Extraction "programs.ml" knot_list blossom_program point_program derivative_program net_program
  closed14_program closed15_program closed16_program.
