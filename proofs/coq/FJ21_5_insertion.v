(* Knot insertion and the cells of a net, FJ21, section 5.
   Definitions:
     cell_half u n y c i    one side of FJ07 (13) without its denominator, (u_{i+n} - y) c_i + (y - u_i) c_{i+1} *)
From Torse Require Import Prelude Blossom Curves Points Insertion FJ07_3_net FJ21_5_changes Executable Executable_knots Executable_splines
  Executable_mappings Executable_joints Executable_refinement.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Side.
Variable F : fieldType.
Implicit Types (u c : nat -> F) (x y : F) (n p i k : nat).

Definition cell_half u n y c i := (u (i + n)%N - y) * c i + (y - u i) * c i.+1.

(* A side of a cell of the new net: those of the old cells i - 1 and i that it comes from. *)
Lemma side_inserted n p x u i : (n <= p)%N || (0 < i)%N -> (forall k, (k < p <= k + n)%N -> u (k + n)%N - u k != 0) ->
  exists a b, [/\ (i + n <= p)%N -> a = 0, (p <= i)%N -> b = 0 &
    forall c y, cell_half (insert_knot p x u) n y (insert_point n p x u c) i = a * cell_half u n y c i.-1 + b * cell_half u n y c i].
Proof.
move=> first_ nz; rewrite /cell_half /insert_knot /insert_point.
have [before|inside_] := ltnP (i + n) p.
  have [h1 h2] : (i + n <= p /\ i < p)%N by move: before; clear; lia.
  exists 0, 1; split=> [//|h|c y]; first by move: h2 h; clear; lia.
  by rewrite ?before ?h1 ?h2 mul0r add0r mul1r.
have [after|inside2] := ltnP p i.
  have [h1 h2 h3 h4 h5] : [/\ (i + n <= p) = false, (i + n < p) = false, (i + n == p) = false, (i < p) = false & (i == p) = false]%N.
    by move: after; clear; split; lia.
  have [h6 h7] : (p < i.+1)%N /\ (i.+1 + n <= p)%N = false by move: after; clear; lia.
  exists 1, 0; split=> [h|//|c y]; first by move: after h; clear; lia.
  rewrite ?after ?h1 ?h2 ?h3 ?h4 ?h5 ?h6 ?h7 mul1r mul0r addr0.
  by case: i {first_ inside_ h1 h2 h3 h4 h5 h6 h7} after.
case: n nz first_ inside_ => [|n] nz first_ inside_.
  have e : i = p by move: inside_ inside2; clear; lia.
  exists 0, 0; split=> // c y; rewrite e !addn0 ?ltnn ?eqxx ?leqnn ?ltnSn /=; ring.
have nz2 : (i < p)%N -> u (i + n.+1)%N - u i != 0 by move=> lt_i; apply: nz; move: inside_ lt_i; clear; lia.
have nz1 : (0 < i)%N -> (p < i + n.+1)%N -> u (i.-1 + n.+1)%N - u i.-1 != 0 by move=> i0 lt_p; apply: nz; move: inside2 i0 lt_p; clear; lia.
have [h6 h7] : (p < i)%N = false /\ (i.+1 + n.+1 <= p)%N = false by move: inside_ inside2; clear; split; lia.
have [e|ne] := eqVneq (i + n.+1)%N p.
  have [h1 h2 h3] : [/\ (i + n.+1 <= p)%N, (i < p)%N & (p < i.+1)%N = false] by move: e; clear; split; lia.
  exists 0, ((x - u i) / (u (i + n.+1)%N - u i)); split=> [//|h|c y]; first by move: h2 h; clear; lia.
  rewrite ?h1 ?h2 ?h3 ?h7 e ?ltnn ?eqxx /step /= e; move: (nz2 h2); rewrite e.
  move: (u p) (u i) (c i) (c i.+1) => q a c0 c1 nzq; field; exact: nzq.
have far : (p < i + n.+1)%N by move: ne inside_; clear; lia.
have [h1 h2 h3] : [/\ (i + n.+1 <= p) = false, (i + n.+1 < p) = false & (i + n.+1 == p) = false]%N by move: far; clear; split; lia.
have i0 : (0 < i)%N by case/orP: first_ => //; move: far; clear; lia.
have e_i : (i.-1 + n.+1 = (i + n.+1).-1)%N by move: i0; clear; lia.
have := nz1 i0 far; rewrite e_i; have e_c (c : nat -> F) : c i.-1.+1 = c i by rewrite prednK.
have [e|ne2] := eqVneq i p => nzD.
  have [h4 h5] : (i < p)%N = false /\ (p < i.+1)%N by move: e; clear; lia.
  exists ((u (i + n.+1).-1 - x) / (u (i + n.+1).-1 - u i.-1)), 0; split=> [h|//|c y]; first by move: far h; clear; lia.
  rewrite ?h1 ?h2 ?h3 ?h4 ?h5 ?h6 ?h7 /step /= e_c e_i.
  move: nzD; move: (u _.-1) (u i.-1) (c i.-1) (c i) (c i.+1) => q a c0 c1 c2 nzq. rewrite mul0r addr0; field; exact: nzq.
have [h4 h5] : (i < p)%N /\ (p < i.+1)%N = false by move: inside2 ne2; clear; split; lia.
exists ((u (i + n.+1).-1 - x) / (u (i + n.+1).-1 - u i.-1)), ((x - u i) / (u (i + n.+1)%N - u i)); split=> [h|h|c y];
  [by move: far h; clear; lia | by move: h4 h; clear; lia |].
rewrite ?h1 ?h2 ?h3 ?h4 ?h5 ?h6 ?h7 /step /= e_c e_i; move: nzD (nz2 h4).
move: (u _.-1) (u i.-1) (u i) (u (_ + _)%N) (c i.-1) (c i) (c i.+1) => q a b d c0 c1 c2 nz_q nz_d; field; by rewrite nz_d.
Qed.
End Side.

Section Net.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (x L M : F) (c d : nat -> 'rV[F]_m) (n p i k : nat).

Lemma cell_side u n L M c d i : cell u n L M c d i <-> forall l, cell_half u n L (coord c l) i = cell_half u n M (coord d l) i.
Proof. by rewrite /cell /cell_half; split=> [e l|e]; [have := congr1 (fun r : 'rV_m => r 0 l) e | apply/rowP=> l; have := e l]; rewrite !mxE. Qed.

(** FJ21.K net: Boehm's points over the knots with $x$ inserted as knot $p$ obey FJ07 (13) with the same $\Lambda^{*}$ and $M^{*}$ in the cell $i$ if the points of
    the old knots do in the cells that it comes from: $i-1$ if the new cell ends after $x$, $i$ if it begins before $x$. For $\sigma q$ in the place of $d$ it is
    FJ21 7.1.
    Hypotheses: $n\le p$ or $i\ge1$: $x$ is not inserted among the first knots; $u_k\ne u_{k+n}$ for the cells around $x$, so that Boehm's points have a meaning. *)
Theorem FJ21_K_net n p x u c d L M i (u' := insert_knot p x u) (c' := insert_points n p x u c) (d' := insert_points n p x u d) :
  (n <= p)%N || (0 < i)%N -> (forall k, (k < p <= k + n)%N -> u (k + n)%N - u k != 0) ->
  ((p < i + n)%N -> cell u n L M c d i.-1) -> ((i < p)%N -> cell u n L M c d i) -> cell u' n L M c' d' i.
Proof.
move=> first_ nz before after; apply/cell_side => k; have [a [b [a0 b0 e]]] := side_inserted x first_ nz.
have cE (f : nat -> 'rV[F]_m) y : cell_half u' n y (coord (insert_points n p x u f) k) i = cell_half u' n y (insert_point n p x u (coord f k)) i.
  by rewrite /cell_half /coord !mxE.
rewrite !cE !e; congr (_ + _).
  have [/before/cell_side -> //|/a0 ->] := ltnP p (i + n); by rewrite !mul0r.
by have [/after/cell_side -> //|/b0 ->] := ltnP i p; rewrite !mul0r.
Qed.
End Net.

Section Program.
Variables (F : realFieldType) (m : nat).
Local Notation K := (ordered F).
Local Notation V := (rows [fieldType of F] m).
Local Notation at_list := (nth 0).

(** FJ21.K program: from two rows with FJ07 (13) in all cells the program of knot insertion makes two rows with (13) in all cells of the new knots, with the same
    $\Lambda^{*}$ and $M^{*}$.
    Hypotheses: an ordered field. *)
Theorem FJ21_K_program n (u : seq F) (c d : seq 'rV[F]_m) x v r s L M :
  insertion_program K V n u c x = Value (v, r) -> insertion_program K V n u d x = Value (v, s) ->
  (forall i, (i < size u - n)%N -> cell (at_list u) n L M (at_list c) (at_list d) i) ->
  forall i, (i < size v - n)%N -> cell (at_list v) n L M (at_list r) (at_list s) i.
Proof.
move=> e1 e2 net i lt_i; have [[hu hv sv _] [bj _ vE rE]] := insertion_lists e1; have [_ [_ _ _ sE]] := insertion_lists e2.
move: bj vE rE sE; set j := interval K n u x => bj vE rE sE; have [n0 le_n _] := bounds_of hu.
have lt_L : (size v - n = (size u - n).+1)%N by rewrite sv; move: le_n; clear; lia.
apply/cell_side => k; rewrite /cell_half !vE !rE ?sE ?(ltnW lt_i) //.
have /cell_side/(_ k) : cell (insert_knot j.+1 x (at_list u)) n L M (insert_points n j.+1 x (at_list u) (at_list c)) (insert_points n j.+1 x (at_list u) (at_list d)) i.
  apply: FJ21_K_net => [|q in_q|lt_p|lt_p].
  - by apply/orP; left; move: bj; clear; lia.
  - rewrite subr_eq0 gt_eqF // (repeated hu) //; move: in_q bj n0 le_n; clear; lia.
  - by apply: net; move: lt_i lt_p bj n0; rewrite lt_L; clear; lia.
  by apply: net; move: lt_p bj; clear; lia.
by rewrite /cell_half /coord !mxE.
Qed.
End Program.
