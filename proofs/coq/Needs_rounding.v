(* What becomes of the bound of Rounding_binary64.v without its hypotheses.
   Definitions:
     zero, one, half, tiny, largest   0, 1, 1/2, the least positive double 2^-1074 and the largest (2^53 - 1) 2^971 *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Binary Rounding_binary Rounding_binary64.
Local Notation eps := (unit_roundoff 53).

Definition zero : double := B754_zero false.
Definition one : double := @B754_finite 53 1024 false 4503599627370496 (-52) erefl.
Definition half : double := @B754_finite 53 1024 false 4503599627370496 (-53) erefl.
Definition largest : double := @B754_finite 53 1024 false 9007199254740991 971 erefl.
Definition tiny : double := @B754_finite 53 1024 false 1 (-1074) erefl.

Lemma one_value : B2R one = 1%Re.
Proof. by rewrite /B2R /F2R /=; lra. Qed.
Lemma half_value : B2R half = (/ 2)%Re.
Proof. by rewrite /B2R /F2R /=; lra. Qed.
Lemma tiny_value : (0 < B2R tiny)%Re.
Proof. exact: F2R_gt_0. Qed.
Lemma largest_value : (0 < B2R largest)%Re.
Proof. exact: F2R_gt_0. Qed.

Lemma rational_zero : rational zero = 0.
Proof. by []. Qed.

Lemma rational_infinity : rational (B754_infinity false : double) = 0.
Proof. by []. Qed.

Lemma rational_one : rational one = 1.
Proof. exact: (real_inj (etrans (etrans (real_rational one) one_value) (esym (real_int 1)))). Qed.

Lemma rational_half : rational half = 2%:R^-1.
Proof.
have two : real 2%:R^-1 = (/ 2)%Re by rewrite -(real_int 2) -real_inv.
exact: (real_inj (etrans (etrans (real_rational half) half_value) (esym two))).
Qed.

Lemma rational_tiny : 0 < rational tiny.
Proof. exact: (real_gt0 (eq_ind_r (fun z => (0 < z)%Re) tiny_value (real_rational tiny))). Qed.

Lemma unit_small : eps <= 16%:R^-1.
Proof.
have e16 : 16%:R = 2%:R ^ 4 :> rat by [].
have le : (- 53%:Z <= - 4%:Z) by [].
have e : 2%:R ^ (- 4%:Z) = 16%:R^-1 :> rat by rewrite e16 -invr_expz.
have two : 1 <= 2%:R :> rat by [].
rewrite -e.
exact: (ler_weexpz2l two le).
Qed.

Lemma unit_range : 0 <= eps <= 16%:R^-1.
Proof. by apply/andP; split; [exact: (unit_ge0 53) | exact: unit_small]. Qed.

Lemma rational_largest : 0 < rational largest.
Proof. exact: (real_gt0 (eq_ind_r (fun z => (0 < z)%Re) largest_value (real_rational largest))). Qed.

Lemma zero_lt1 : rational zero < 1.
Proof. exact: ltr01. Qed.

Lemma half_lt1 : rational half < 1.
Proof. by rewrite rational_half invf_lt1 ?ltr0n // ltr_nat. Qed.

Lemma bound_fails (F : realFieldType) (e t : F) : 0 <= e <= 16%:R^-1 -> 0 < t -> e * t + (1 + e) * (gamma e 6 * t) < t.
Proof.
case/andP=> e0 e1 t0; have e13 : 13%:R * e < 1.
  by apply: le_lt_trans (ler_wpmul2l (ler0n _ 13) e1) _; rewrite ltr_pdivr_mulr ?ltr0n // mul1r ltr_nat.
have gap : 0 < 1 - 6%:R * e.
  by rewrite subr_gt0; apply: le_lt_trans e13; rewrite ler_wpmul2r // ler_nat.
have nz := lt0r_neq0 gap.
have -> : e * t + (1 + e) * (gamma e 6 * t) = 7%:R * e / (1 - 6%:R * e) * t by rewrite /gamma; field; rewrite nz.
have e' : 1 - 6%:R * e - 7%:R * e = 1 - 13%:R * e by ring.
by rewrite gtr_pmull // ltr_pdivr_mulr // mul1r -subr_gt0 e' subr_gt0.
Qed.

(* One cell of degree 1 with the knots a and b, L* = M* = 1 and c = 0: a ruling that is lost, or has no value, is not within the bound. *)
Lemma lost_ruling (F : realFieldType) (T : Type) (val : T -> F) (e : F) (zero one a b d0 computed : T) (u := fun i => if i is 0%N then a else b)
  (c := fun (_ : nat) (_ : 'I_1) => zero) : val zero = 0 -> val one = 1 -> val a < 1 -> val b < 1 -> 0 < val d0 -> val computed = 0 ->
  0 <= e <= 16%:R^-1 -> exists d : nat -> 'rV[F]_1, [/\ d 0%N = \row_k val d0, cell (fun i => val (u i)) 1 (val one) (val one) (read val c) d 0 &
    e * `|d 1%N 0 0| + (1 + e) * bound_up e (fun i => val (u i)) 1 (val one) (val one) (fun=> val zero) (val d0) 0 1 < `|val computed - d 1%N 0 0|].
Proof.
move=> v0 v1; rewrite -[val a < 1]subr_gt0 -[val b < 1]subr_gt0 => ha hb t0 vc small.
exists (fun i => if i is 0%N then \row_k val d0 else \row_k ((1 - val b) / (1 - val a) * val d0)); split=> //.
  rewrite /cell /u /= v1; apply/rowP=> k; rewrite !mxE /= ?v0; move: (val d0) (val a) (val b) ha => t x y /lt0r_neq0 nz.
  by field.
rewrite /bound_up /P /u !big_nat1 /= !mxE ?v0 v1 vc subrr normr0 mul0r addr0 !subr0 sub0r normrN -[gamma _ _ * _ * _]mulrA -normrM.
rewrite (gtr0_norm (x := _ / _ * _)) ?mulr_gt0 ?invr_gt0 //; apply: bound_fails => //.
by rewrite ?mulr_gt0 ?invr_gt0.
Qed.

(** rounding.binary64 needs_normal: a product that underflows breaks the bound, though all is finite: $n=1$, $u_0=0$, $u_1=\frac12$, $\Lambda^{*}=M^{*}=1$,
    $c_i=0$ and $d_0=2^{-1074}$ give $d_1=0$ in place of $2^{-1075}$. *)
Theorem rounding_binary64_needs_normal (u := fun i => if i is 0%N then zero else half) (c := fun (_ : nat) (_ : 'I_1) => zero)
  (computed := net_from doubles u 1 one one (fun=> zero) tiny 0 1) :
  is_finite computed = true /\ exists d : nat -> 'rV[rat]_1, [/\ d 0%N = \row_k rational tiny,
    cell (fun i => rational (u i)) 1 (rational one) (rational one) (read rational c) d 0 &
    eps * `|d 1%N 0 0| + (1 + eps) * bound_up eps (fun i => rational (u i)) 1 (rational one) (rational one) (fun=> rational zero) (rational tiny) 0 1
      < `|rational computed - d 1%N 0 0|].
Proof.
have ec : computed = zero by vm_compute.
rewrite ec; split; first by [].
exact: (lost_ruling rational_zero rational_one zero_lt1 half_lt1 rational_tiny rational_zero unit_range).
Qed.

(** rounding.binary64 needs_finite: a vertex that overflows has no value: so with $u_0=\frac12$, $u_1=0$ and the largest double as $d_0$, where $d_1=2d_0$. *)
Theorem rounding_binary64_needs_finite (u := fun i => if i is 0%N then half else zero) (c := fun (_ : nat) (_ : 'I_1) => zero)
  (computed := net_from doubles u 1 one one (fun=> zero) largest 0 1) :
  computed = B754_infinity false /\ exists d : nat -> 'rV[rat]_1, [/\ d 0%N = \row_k rational largest,
    cell (fun i => rational (u i)) 1 (rational one) (rational one) (read rational c) d 0 &
    eps * `|d 1%N 0 0| + (1 + eps) * bound_up eps (fun i => rational (u i)) 1 (rational one) (rational one) (fun=> rational zero) (rational largest) 0 1
      < `|rational computed - d 1%N 0 0|].
Proof.
have ec : computed = B754_infinity false by vm_compute.
rewrite ec; split; first by [].
exact: (lost_ruling rational_zero rational_one half_lt1 zero_lt1 rational_largest rational_infinity unit_range).
Qed.

(** rounding.binary64 needs_knots: an infinite knot has no value, and the net none to compare with: with $u_0=\infty$, $u_1=1$ and the rest 0, all
    computed vertices are 0. *)
Theorem rounding_binary64_needs_knots (u := fun i => if i is 0%N then B754_infinity false : double else one) (c := fun (_ : nat) (_ : 'I_1) => zero)
  (computed := net_from doubles u 1 zero zero (fun=> zero) zero 0 1) :
  computed = zero /\ exists d : nat -> 'rV[rat]_1, [/\ d 0%N = \row_k rational zero,
    cell (fun i => rational (u i)) 1 (rational zero) (rational zero) (read rational c) d 0 &
    eps * `|d 1%N 0 0| + (1 + eps) * bound_up eps (fun i => rational (u i)) 1 (rational zero) (rational zero) (fun=> rational zero) (rational zero) 0 1
      < `|rational computed - d 1%N 0 0|].
Proof.
have ec : computed = zero by vm_compute.
rewrite ec; split; first by [].
have none (val : double -> rat) (e : rat) : val zero = 0 -> val (B754_infinity false) = 0 -> e < 1 -> exists d : nat -> 'rV[rat]_1,
  [/\ d 0%N = \row_k val zero, cell (fun i => val (u i)) 1 (val zero) (val zero) (read val c) d 0 &
    e * `|d 1%N 0 0| + (1 + e) * bound_up e (fun i => val (u i)) 1 (val zero) (val zero) (fun=> val zero) (val zero) 0 1 < `|val zero - d 1%N 0 0|].
  move=> v0 vi e1; exists (fun i => if i is 0%N then \row_k val zero else const_mx 1 : 'rV[rat]_1); split=> //.
    by rewrite /cell /u /= v0 vi; apply/rowP=> k; rewrite !mxE v0 !subrr !mul0r !mulr0 !addr0.
  by rewrite /bound_up big_nat1 !mxE v0 !subrr normr0 !mulr0 mul0r !addr0 mulr0 addr0 sub0r normrN normr1 mulr1.
apply: none; [exact: rational_zero | exact: rational_infinity |].
by apply: le_lt_trans unit_small _; rewrite invf_lt1 ?ltr0n // ltr_nat.
Qed.
