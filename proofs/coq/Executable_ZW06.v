(* Programs: the constructions of ZW06 through a Bezier curve with the points c (degree n, one less than their number).
   Definitions:
     forward c i, backward c i   c_{i+1} - c_i, c_i - c_{i-1}
     cone_program c x d          12: d_{i+1} = d_i + x (c_{i+1} - c_i) from d_0 = d
     start_cone_program c s      13
     mean c i, mean_tangent_program c   A_i and the row of 16
     tangent_program c           17
     mean_chord_program c        18
     affine_net_program c x s d  20: d_{i+1} = c_i + x (c_{i+1} - c_i) + s (d_i - c_i) from d_0 = d
     ruling c r i                r_i - c_i *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier ZW06 Executable.

Section Programs.
Variables (T Q : Type) (K : scalars T) (V : points T Q).
Implicit Types (c : seq Q) (n i : nat) (x s : T) (d : Q).
Local Notation vertex c i := (nth (origin V) c i).
Local Notation "p + q" := (padd V p q).
Local Notation "p - q" := (psub V p q).
Local Notation "x *: p" := (pscale V x p).

Definition forward c i := vertex c i.+1 - vertex c i.
Definition backward c i := vertex c i - vertex c i.-1.
Definition nat_ k := of_nat K k.
Definition cone_program c x d := sequence (fun i (z : Q) => z + x *: forward c i) 0 d (size c).
Definition start_cone_program c s := let n := (size c).-1 in
  given (~~ same K s (zero K)) Factor (Value (mkseq (fun i =>
    vertex c i + sinv K (smul K (nat_ i.+1) s) *: (nat_ (n - i) *: vertex c i.+1 + nat_ i.+1 *: vertex c i - nat_ n.+1 *: vertex c 0)) (size c))).
Definition mean c i := sinv K (nat_ (i.+1 * i.+2)) *: total_of V (fun j => nat_ j.+1 *: forward c j) 0 i.+1.
Definition mean_tangent_program c := let n := (size c).-1 in
  mkseq (fun i => vertex c i + (nat_ (n - i) *: mean c i + nat_ i *: mean c i.-1)) (size c).
Definition tangent_program c := let n := (size c).-1 in
  mkseq (fun i => vertex c i + (nat_ (n - i) *: forward c i + nat_ i *: backward c i)) (size c).
Definition mean_chord_program c := sequence (fun i (z : Q) =>
  vertex c i.+1 + smul K (nat_ i.+1) (sinv K (nat_ i.+2)) *: (forward c i + (z - vertex c i))) 0 (vertex c 0) (size c).
Definition affine_net_program c x s d := sequence (fun i (z : Q) => vertex c i + x *: forward c i + s *: (z - vertex c i)) 0 d (size c).
End Programs.

Section Equal.
Variables (F : fieldType) (m : nat) (lt : F -> F -> bool).
Implicit Types (c r : seq 'rV[F]_m) (i : nat) (x s : F) (d : 'rV[F]_m).
Local Notation K := (of_field lt).
Local Notation V := (rows F m).
Local Notation at_list := (nth 0).

Definition ruling c r i : 'rV[F]_m := at_list r i - at_list c i.
Local Notation directrix c := (pbez (size c).-1 (at_list c)).
Local Notation rulings c r := (pbez (size c).-1 (ruling c r)).

Lemma in_row c i : (0 < size c)%N -> (i <= (size c).-1)%N -> (i < size c)%N.
Proof. by move=> c0 le_i; rewrite -(prednK c0). Qed.

Lemma good_row c : good F (size c) -> [/\ good F (size c).-1, independent F (size c).-1 &
  forall i, (0 < size c)%N -> (i <= (size c).-1)%N -> i.+1%:R != 0 :> F].
Proof.
move=> g; have g1 : good F (size c).-1 by apply: good_le g; exact: leq_pred.
split=> //; [exact: good_independent | move=> i c0 le_i; apply: (good_nat g)].
by rewrite ltnS in_row.
Qed.

(** ZW06.12 program: the program gives a row with $(\rho-1)a'=\tau'$ and $q_0=d$.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_12_program c x d (r := cone_program V c x d) : good F (size c) -> (0 < size c)%N ->
  at_list r 0 = d /\ (x - 1)%:P *: pderiv (directrix c) = pderiv (rulings c r).
Proof.
move=> /good_row[g ind nz] c0; split; first by rewrite /r /cone_program; case: (size c) c0.
apply/ZW06_12_unique => // i; have er j : at_list c j + ruling c r j = at_list r j by rewrite /ruling addrC subrK.
rewrite !er; elim: i => [|i ih] le_i; first by rewrite subrr scaler0 addr0.
rewrite /r /cone_program nth_sequence; last exact: in_row.
rewrite -/(cone_program V c x d) -/r ih 1?ltnW // add0n /forward /=.
by move: (at_list r 0) (at_list c i) (at_list c i.+1) (at_list c 0) => a b e f; by_entries k; ring.
Qed.

(** ZW06.13 program: the program gives a row with $a'=s\tau+su\tau'$, wherever it gives a row.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_13_program c s r : good F (size c) -> (0 < size c)%N -> start_cone_program K V c s = Value r ->
  pderiv (directrix c) = s%:P *: rulings c r + s%:P *: ('X *: pderiv (rulings c r)).
Proof.
move=> /good_row[g ind nz] c0 e; have [s0 {}e] := given_Value e; rewrite /= in s0; apply/ZW06_13_unique => // i le_i.
have ni : i.+1%:R != 0 :> F by exact: nz.
rewrite -(Value_inj e) /ruling nth_mkseq; last exact: in_row.
rewrite /nat_ !of_natE /= (addrC (at_list c i)) addrK prednK //.
by rewrite scalerKV // mulf_neq0.
Qed.

(** ZW06.16 program: the program gives a row with $a'=2\tau+u\tau'$.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_16_program c (r := mean_tangent_program K V c) : good F (size c) -> (0 < size c)%N ->
  pderiv (directrix c) = 2%:R%:P *: rulings c r + 'X *: pderiv (rulings c r).
Proof.
move=> gc c0; have gn : good F (size c).-1.+1 by rewrite prednK.
have := ZW06_16_closed (at_list c) gn; set tau := fun i => _ => e.
have eq_r : rulings c r = pbez (size c).-1 tau.
  apply: pbez_ext => i le_i; rewrite /ruling /r nth_mkseq; last exact: in_row.
  rewrite /mean /nat_ !of_natE !total_ofE /= (addrC (at_list c i)) addrK.
  by rewrite /tau /mean_step; congr (_ *: (_ *: _) + _ *: (_ *: _)); apply: eq_bigr => j _; rewrite -(of_natE lt j.+1).
by rewrite eq_r.
Qed.

(** ZW06.17 program: the program gives a row with $a'=\tau$.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_17_program c (r := tangent_program K V c) : good F (size c) -> (0 < size c)%N -> pderiv (directrix c) = rulings c r.
Proof.
move=> /good_row[g ind nz] c0; apply/ZW06_17_unique => // i le_i.
rewrite /ruling /r nth_mkseq; last exact: in_row.
by rewrite /nat_ !of_natE /= (addrC (at_list c i)) addrK.
Qed.

(** ZW06.18 program: the program gives a row with $u\,a'=\tau+u\tau'$.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_18_program c (r := mean_chord_program K V c) : good F (size c) -> (0 < size c)%N ->
  'X *: pderiv (directrix c) = rulings c r + 'X *: pderiv (rulings c r).
Proof.
move=> /good_row[g ind nz] c0; apply/ZW06_18_recursion => // -[|i] le_i.
  by rewrite scale0r /ruling /r /mean_chord_program; case: (size c) c0 => //= k _; rewrite subrr scaler0.
have ni : i.+2%:R != 0 :> F by exact: nz.
rewrite /prev /= /ruling /r /mean_chord_program nth_sequence; last exact: in_row.
rewrite -/(mean_chord_program K V c) -/r add0n /nat_ !of_natE /forward /=.
by rewrite addrAC subrr add0r scalerA mulrCA mulfV // mulr1.
Qed.

(** ZW06.20 program: the program gives Aumann's row: $(\rho-1)a'=n(1-s)\tau+(1-u+su)\tau'$ and $q_0=d$.
    Hypotheses: characteristic 0 or greater than the number of points; there are points. *)
Theorem ZW06_20_program c x s d (n := (size c).-1) (r := affine_net_program V c x s d) : good F (size c) -> (0 < size c)%N ->
  at_list r 0 = d /\ (x - 1)%:P *: pderiv (directrix c)
    = (n%:R * (1 - s))%:P *: rulings c r + ((1 - 'X) *: pderiv (rulings c r) + s%:P *: ('X *: pderiv (rulings c r))).
Proof.
move=> /good_row[g ind nz] c0; split; first by rewrite /r /affine_net_program; case: (size c) c0.
apply/ZW06_20_unique => // i lt_i.
rewrite {1}/ruling /r /affine_net_program nth_sequence; last exact: in_row.
rewrite -/(affine_net_program V c x s d) -/r add0n /forward /ruling /=.
by move: (at_list r i) (at_list c i) (at_list c i.+1) => a b e; by_entries k; ring.
Qed.
End Equal.
