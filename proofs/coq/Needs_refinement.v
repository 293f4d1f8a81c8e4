(* Whole curves and surfaces: what happens without the hypotheses of the theorems on the programs, one counterexample each, over the rational numbers.
   Definitions:
     on_axis s        the numbers s as points of a line *)
From Torse Require Import Prelude Executable Executable_knots Executable_splines Executable_mappings Executable_elimination Executable_surface.
From mathcomp Require Import order ssrnum.

Section Line.
Variable F : realFieldType.
Implicit Types (u v s : seq F) (n k : nat) (t x : F).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] 1).
Local Notation point x := (const_mx x : 'rV[F]_1).

Definition on_axis s : seq 'rV[F]_1 := [seq point x | x <- s].

Lemma nth_line s i : nth 0 (on_axis s) i = point (nth 0 s i).
Proof. by elim: s i => [|x s ih] [|i] //=; rewrite ?nth_nil; apply/rowP=> j; rewrite !mxE. Qed.

Lemma deboor_line u s a : deboor K V u (on_axis s) a = point (deboor K (itself K) u s a).
Proof.
elim: a u s => [|x a ih] u s; first exact: nth_line.
rewrite [LHS]/= [in RHS]/= -ih; congr deboor; rewrite /on_axis /mkseq -map_comp; apply: eq_map => i.
by rewrite /step_point /= !nth_line; apply/rowP=> j; rewrite !mxE.
Qed.

Lemma refined_line n u s v r : refined_program K (itself K) n u s v = Value r -> refined_program K V n u (on_axis s) v = Value (on_axis r).
Proof.
rewrite /refined_program /knot_list /fits size_map /given; do !case: ifP => // _; case=> <-; congr Value.
rewrite /on_axis /mkseq -map_comp; apply: eq_map => i; rewrite /over_piece /= -deboor_line /on_axis map_drop //.
Qed.

Lemma value_line n u s t x : mapping_value_program K (itself K) n u s t = Value x -> mapping_value_program K V n u (on_axis s) t = Value (point x).
Proof.
rewrite /mapping_value_program /point_program /blossom_program /knot_list /fits size_map /given; do !case: ifP => // _; case=> <-; congr Value.
by rewrite -deboor_line /on_axis map_drop.
Qed.
End Line.

Section Needs.
Local Notation K := (ordered [realFieldType of rat]).
Local Notation V := (rows [fieldType of rat] 1).
Local Notation point x := (const_mx x : 'rV[rat]_1).

(** blossoms refined_curve_needs_start: over the knots $0,0,1,1,2,2$ of degree 2 the points $0,0,0,1,0$ have $c(0)=0$; over $-1,-1,1,1,2,2$, where 0 is no
    knot and each knot inside is as often, the vertices are $0,-2,0,1,0$, and at 0 the curve is $-1$. *)
Theorem blossoms_refined_curve_needs_start (u := [:: 0; 0; 1; 1; 2%:R; 2%:R]) (c := on_axis [:: 0; 0; 0; 1; 0]) (v := [:: -1; -1; 1; 1; 2%:R; 2%:R]) :
  exists2 r, refined_program K V 2 u c v = Value r &
    mapping_value_program K V 2 u c 0 = Value (point 0) /\ mapping_value_program K V 2 v r 0 = Value (point (-1)).
Proof.
exists (on_axis [:: 0; - 2%:R; 0; 1; 0]); first by apply: refined_line; vm_compute.
by split; apply: value_line; vm_compute.
Qed.

(** BZZ19.16 rails_needs_monotone: where $\sigma$ decreases between two breakpoints $C_2$ is continued beyond its piece. One coordinate: over the knots $0,1,2$ of
    degree 1 let $C_2$ have the points $0,1,0$, and let the mapping on $[0,1]$ have the coefficients $0,3,1$, $\sigma(\frac12)=\frac74$, $C_2(\frac74)=\frac14$. The
    program gives a row with the point $\frac74$ at $\frac12$. *)
Theorem BZZ19_16_rails_needs_monotone (u := [:: 0; 1]) (v := [:: 0; 1; 2%:R]) (w := [:: 0; 0; 1; 1]) (b := [:: 0; 3%:R; 1]) (h := 2%:R^-1) (s := 7%:R / 4%:R) :
  exists2 S, exists z R, surface_program K (itself K) 1 u [:: 0; 0] 1 v [:: 0; 1; 0] 2 w b false = Value (z, R, S) /\
      mapping_value_program K (itself K) 2 z S h = Value s &
    value_of K 2 w b h h = s /\ mapping_value_program K (itself K) 1 v [:: 0; 1; 0] s = Value 4%:R^-1.
Proof.
exists [:: 0; 3%:R; 1]; last by split; vm_compute.
by exists [:: 0; 0; 1; 1], [:: 0; 0; 0]; split; vm_compute.
Qed.
End Needs.
