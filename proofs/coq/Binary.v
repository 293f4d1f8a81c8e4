(* The operations of IEEE 754 in any precision, as Flocq defines them, keep the standard model. The files Binary.v to Needs_rounding.v in _CoqProject
   are the only ones that rest on axioms: those of Coq's real numbers, in terms of which Flocq says what rounding is.
   Definitions (prec bits, exponents up to emax):
     number prec emax   a binary number; infinities, a NaN and both zeros among them
     bplus, bminus, btimes, bover   its operations, rounded to nearest, ties to even *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core BinarySingleNaN Relative Plus_error.

Definition number := binary_float.

Section Operations.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation number := (number prec emax).
Implicit Types x y : number.

Definition bplus x y : number := Bplus mode_NE x y.
Definition bminus x y : number := Bminus mode_NE x y.
Definition btimes x y : number := Bmult mode_NE x y.
Definition bover x y : number := Bdiv mode_NE x y.

Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation unit := (bpow radix2 (- prec)).
Local Notation least := (bpow radix2 (2 - emax)).
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).

Lemma half_ulp : / 2 * bpow radix2 (- prec + 1) = unit.
Proof. rewrite bpow_plus_1; simpl; lra. Qed.

Lemma rounded_sum (x y : R) : generic_format radix2 (FLT_exp emin prec) x -> generic_format radix2 (FLT_exp emin prec) y ->
  Rabs (rnd (x + y) - (x + y)) <= unit * Rabs (x + y).
Proof.
intros hx hy.
destruct (FLT_plus_error_N_ex radix2 emin prec (fun z : Z => negb (Z.even z)) x y hx hy) as [e [he ->]].
replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring.
rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|].
apply Rle_trans with (1 := he); unfold u_ro; rewrite half_ulp.
assert (0 < unit) by apply bpow_gt_0.
apply Rmult_le_reg_r with (1 + unit); [lra|].
unfold Rdiv; rewrite Rmult_assoc, Rinv_l; [nra|lra].
Qed.

Lemma rounded_normal (x : R) : least <= Rabs (rnd x) -> Rabs (rnd x - x) <= unit * Rabs (rnd x).
Proof.
intros h.
apply Rle_trans with (1 := error_le_half_ulp_round radix2 (FLT_exp emin prec) (fun z : Z => negb (Z.even z)) x).
assert (u : ulp radix2 (FLT_exp emin prec) (rnd x) <= Rabs (rnd x) * bpow radix2 (1 - prec)).
  apply ulp_FLT_le; replace (emin + prec - 1)%Z with (2 - emax)%Z by ring; exact h.
rewrite <- half_ulp; replace (- prec + 1)%Z with (1 - prec)%Z by ring.
lra.
Qed.

Ltac finite_cases x y := destruct x as [sx|sx| |sx mx ex hx], y as [sy|sy| |sy my ey hy]; simpl; try easy; try (destruct sx, sy; easy).

Lemma finite_plus x y : is_finite (bplus x y) = true -> is_finite x = true /\ is_finite y = true.
Proof. finite_cases x y. Qed.
Lemma finite_minus x y : is_finite (bminus x y) = true -> is_finite x = true /\ is_finite y = true.
Proof. finite_cases x y. Qed.
Lemma finite_times x y : is_finite (btimes x y) = true -> is_finite x = true /\ is_finite y = true.
Proof. finite_cases x y. Qed.
Lemma finite_over x y : is_finite (bover x y) = true -> is_finite x = true.
Proof. finite_cases x y. Qed.
Lemma divisor_neq0 x y : is_finite (bover x y) = true -> is_finite y = true -> B2R y <> 0.
Proof. finite_cases x y; intros _ _; apply F2R_neq_0; destruct sy; easy. Qed.
Lemma infinite_divisor x y : is_finite (bover x y) = true -> is_finite y = false -> B2R (bover x y) = 0.
Proof. finite_cases x y. Qed.

Lemma plus_close x y : is_finite (bplus x y) = true -> Rabs (B2R (bplus x y) - (B2R x + B2R y)) <= unit * Rabs (B2R x + B2R y).
Proof.
intros h; destruct (finite_plus _ _ h) as [hx hy]; assert (c := Bplus_correct prec emax _ _ mode_NE x y hx hy).
destruct Rlt_bool.
  destruct c as [e _]; unfold bplus; rewrite e; apply rounded_sum; apply generic_format_B2R.
destruct c as [c _]; exfalso; unfold bplus in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma minus_close x y : is_finite (bminus x y) = true -> Rabs (B2R (bminus x y) - (B2R x - B2R y)) <= unit * Rabs (B2R x - B2R y).
Proof.
intros h; destruct (finite_minus _ _ h) as [hx hy]; assert (c := Bminus_correct prec emax _ _ mode_NE x y hx hy).
destruct Rlt_bool.
  destruct c as [e _]; unfold bminus; rewrite e; apply rounded_sum; [|apply generic_format_opp]; apply generic_format_B2R.
destruct c as [c _]; exfalso; unfold bminus in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma overflown_difference x y : is_finite x = true -> is_finite y = true -> is_finite (bminus x y) = false -> B2R x <> B2R y.
Proof.
intros hx hy h e; assert (c := Bminus_correct prec emax _ _ mode_NE x y hx hy).
rewrite e, Rminus_eq_0, round_0, Rabs_R0, Rlt_bool_true in c; [|apply bpow_gt_0|apply valid_rnd_round_mode].
destruct c as [_ [c _]]; unfold bminus in h; rewrite h in c; easy.
Qed.

Lemma times_round x y : is_finite (btimes x y) = true -> B2R (btimes x y) = rnd (B2R x * B2R y).
Proof.
intros h; assert (c := Bmult_correct prec emax _ _ mode_NE x y).
destruct Rlt_bool; [easy|].
exfalso; unfold btimes in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma over_round x y : is_finite (bover x y) = true -> is_finite y = true -> B2R (bover x y) = rnd (B2R x / B2R y).
Proof.
intros h hy; assert (ny := divisor_neq0 x y h hy); assert (c := Bdiv_correct prec emax _ _ mode_NE x y ny).
destruct Rlt_bool; [easy|].
exfalso; unfold bover in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma quotient_eq a b c d : b <> 0 -> d <> 0 -> c * b = a * d -> c / d = a / b.
Proof. intros hb hd h; field_simplify_eq; [rewrite h; ring|easy]. Qed.
Lemma quotient_sum a b c d : b <> 0 -> d <> 0 -> (a * d + c * b) / (b * d) = a / b + c / d.
Proof. intros; field; easy. Qed.
Lemma quotient_product a b c d : b <> 0 -> d <> 0 -> (a * c) / (b * d) = a / b * (c / d).
Proof. intros; field; easy. Qed.
End Operations.
Arguments bplus {prec emax prec_pos prec_emax} x y.
Arguments bminus {prec emax prec_pos prec_emax} x y.
Arguments btimes {prec emax prec_pos prec_emax} x y.
Arguments bover {prec emax prec_pos prec_emax} x y.
Arguments plus_close {prec emax prec_pos prec_emax x y} _.
Arguments minus_close {prec emax prec_pos prec_emax x y} _.
Arguments times_round {prec emax prec_pos prec_emax x y} _.
Arguments over_round {prec emax prec_pos prec_emax x y} _ _.
Arguments finite_plus {prec emax prec_pos prec_emax x y} _.
Arguments finite_minus {prec emax prec_pos prec_emax x y} _.
Arguments finite_times {prec emax prec_pos prec_emax x y} _.
Arguments finite_over {prec emax prec_pos prec_emax x y} _.
Arguments divisor_neq0 {prec emax prec_pos prec_emax x y} _ _.
Arguments infinite_divisor {prec emax prec_pos prec_emax x y} _ _.
Arguments overflown_difference {prec emax prec_pos prec_emax x y} _ _ _.
