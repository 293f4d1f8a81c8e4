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

Lemma good_row c i : good F (size c) -> (0 < size c)%N -> (i <= (size c).-1)%N -> i.+1%:R != 0 :> F.
Proof. by move=> g c0 le_i; apply: (good_nat g); rewrite ltnS in_row. Qed.

Lemma no_points c r : size c = 0%N -> size r = 0%N -> [/\ pderiv (directrix c) = 0, rulings c r = 0 & pderiv (rulings c r) = 0].
Proof.
move=> /size0nil -> /size0nil ->; have z (f : nat -> 'rV[F]_m) : f 0%N = 0 -> pbez 0 f = 0.
  by move=> f0; apply/rowP=> k; rewrite !mxE /bez big_nat1 /coord f0 mxE polyC0 mul0r.
have d0 : pderiv (0 : 'rV[{poly F}]_m) = 0 by apply/rowP=> k; rewrite !mxE linear0.
by rewrite !z ?d0 // /ruling subrr.
Qed.

(** ZW06.12 program: the program gives a row with $(\rho-1)a'=\tau'$, and with $q_0=d$ where there are points. *)
Theorem ZW06_12_program c x d (r := cone_program V c x d) :
  ((0 < size c)%N -> at_list r 0 = d) /\ (x - 1)%:P *: pderiv (directrix c) = pderiv (rulings c r).
Proof.
split; first by rewrite /r /cone_program; case: (size c).
apply: ZW06_12_solves => i lt_i; rewrite /ruling /r /cone_program nth_sequence; last by lia.
rewrite -/(cone_program V c x d) -/r add0n /forward /=.
by move: (at_list r i) (at_list c i) (at_list c i.+1) => a b e; by_entries k; ring.
Qed.

(** ZW06.13 program: the program gives a row with $a'=s\tau+su\tau'$, wherever it gives a row.
    Hypotheses: characteristic 0 or greater than the number of points, so that none of the program's divisors $1,\dots,n+1$ is 0. *)
Theorem ZW06_13_program c s r : good F (size c) -> start_cone_program K V c s = Value r ->
  pderiv (directrix c) = s%:P *: rulings c r + s%:P *: ('X *: pderiv (rulings c r)).
Proof.
move=> g e; have [s0 {}e] := given_Value e; rewrite /= in s0; have sr : size r = size c by rewrite -(Value_inj e) size_mkseq.
have [c0|c0] := posnP (size c); first by have [|-> -> ->] := @no_points c r c0; rewrite ?sr // !(scaler0, addr0).
apply: ZW06_13_solves => i le_i; have ni := good_row g c0 le_i.
rewrite -(Value_inj e) /ruling nth_mkseq; last exact: in_row.
rewrite /nat_ !of_natE /= (addrC (at_list c i)) addrK prednK //.
by rewrite scalerKV // mulf_neq0.
Qed.

(** ZW06.16 program: the program gives a row with $a'=2\tau+u\tau'$.
    Hypotheses: characteristic 0 or greater than the number of points, so that none of the divisors $(i+1)(i+2)$ of the means that count, those with $i<n$, is 0. *)
Theorem ZW06_16_program c (r := mean_tangent_program K V c) : good F (size c) ->
  pderiv (directrix c) = 2%:R%:P *: rulings c r + 'X *: pderiv (rulings c r).
Proof.
move=> gc; have [c0|c0] := posnP (size c); first by have [|-> -> ->] := @no_points c r c0; rewrite ?size_mkseq // !(scaler0, addr0).
have gn : good F (size c).-1.+1 by rewrite prednK.
have := ZW06_16_closed (at_list c) gn; set tau := fun i => _ => e.
have eq_r : rulings c r = pbez (size c).-1 tau.
  apply: pbez_ext => i le_i; rewrite /ruling /r nth_mkseq; last exact: in_row.
  rewrite /mean /nat_ !of_natE !total_ofE /= (addrC (at_list c i)) addrK.
  by rewrite /tau /mean_step; congr (_ *: (_ *: _) + _ *: (_ *: _)); apply: eq_bigr => j _; rewrite -(of_natE lt j.+1).
by rewrite eq_r.
Qed.

(** ZW06.17 program: the program gives a row with $a'=\tau$. *)
Theorem ZW06_17_program c (r := tangent_program K V c) : pderiv (directrix c) = rulings c r.
Proof.
have [c0|c0] := posnP (size c); first by have [|-> -> _] := @no_points c r c0; rewrite ?size_mkseq.
apply: ZW06_17_solves => i le_i; rewrite /ruling /r nth_mkseq; last exact: in_row.
by rewrite /nat_ !of_natE /= (addrC (at_list c i)) addrK.
Qed.

(** ZW06.18 program: the program gives a row with $u\,a'=\tau+u\tau'$.
    Hypotheses: characteristic 0 or greater than the number of points, so that none of the program's divisors $2,\dots,n+1$ is 0. *)
Theorem ZW06_18_program c (r := mean_chord_program K V c) : good F (size c) ->
  'X *: pderiv (directrix c) = rulings c r + 'X *: pderiv (rulings c r).
Proof.
move=> g; have [c0|c0] := posnP (size c); first by have [|-> -> ->] := @no_points c r c0; rewrite ?size_sequence // !(scaler0, addr0).
apply: ZW06_18_solves => -[|i] le_i.
  by rewrite scale0r /ruling /r /mean_chord_program; case: (size c) c0 => //= k _; rewrite subrr scaler0.
have ni := good_row g c0 le_i.
rewrite /prev /= /ruling /r /mean_chord_program nth_sequence; last exact: in_row.
rewrite -/(mean_chord_program K V c) -/r add0n /nat_ !of_natE /forward /=.
by rewrite addrAC subrr add0r scalerA mulrCA mulfV // mulr1.
Qed.

(** ZW06.20 program: the program gives Aumann's row: $(\rho-1)a'=n(1-s)\tau+(1-u+su)\tau'$, and $q_0=d$ where there are points. *)
Theorem ZW06_20_program c x s d (n := (size c).-1) (r := affine_net_program V c x s d) :
  ((0 < size c)%N -> at_list r 0 = d) /\ (x - 1)%:P *: pderiv (directrix c)
    = (n%:R * (1 - s))%:P *: rulings c r + ((1 - 'X) *: pderiv (rulings c r) + s%:P *: ('X *: pderiv (rulings c r))).
Proof.
split; first by rewrite /r /affine_net_program; case: (size c).
apply: ZW06_20_solves => i lt_i.
rewrite {1}/ruling /r /affine_net_program nth_sequence; last by lia.
rewrite -/(affine_net_program V c x s d) -/r add0n /forward /ruling /=.
by move: (at_list r i) (at_list c i) (at_list c i.+1) => a b e; by_entries k; ring.
Qed.
End Equal.
