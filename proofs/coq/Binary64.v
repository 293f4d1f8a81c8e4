(* The operations of IEEE 754 on doubles, as Flocq defines them, keep the standard model. This file and Rounding_binary64.v are the only ones that
   rest on axioms: those of Coq's real numbers, in terms of which Flocq says what rounding is.
   Definitions:
     number     a binary64: 53 bits, exponents up to 1024; infinities, a NaN and both zeros among them
     bplus, bminus, btimes, bover   its operations, rounded to nearest, ties to even
     zero, one, half, tiny, largest 0, 1, 1/2, the least positive double 2^-1074 and the largest (2^53 - 1) 2^971 *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core BinarySingleNaN Relative Plus_error.

Definition number := binary_float 53 1024.
#[local] Instance prec_pos : Prec_gt_0 53 := eq_refl.
#[local] Instance prec_emax : Prec_lt_emax 53 1024 := eq_refl.
Definition bplus : number -> number -> number := Bplus mode_NE.
Definition bminus : number -> number -> number := Bminus mode_NE.
Definition btimes : number -> number -> number := Bmult mode_NE.
Definition bover : number -> number -> number := Bdiv mode_NE.

Section Operations.
Local Open Scope R_scope.
Local Notation unit := (bpow radix2 (-53)).
Local Notation least := (bpow radix2 (-1022)).
Local Notation rnd := (round radix2 (FLT_exp (-1074) 53) ZnearestE).

Lemma rounded_sum x y : generic_format radix2 (FLT_exp (-1074) 53) x -> generic_format radix2 (FLT_exp (-1074) 53) y ->
  Rabs (rnd (x + y) - (x + y)) <= unit * Rabs (x + y).
Proof.
intros hx hy.
destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun x => negb (Z.even x)) x y hx hy) as [e [he ->]].
replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring.
rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|].
apply Rle_trans with (1 := he); unfold u_ro.
replace (/ 2 * bpow radix2 (- (53) + 1)) with (bpow radix2 (-53)) by (simpl; lra).
assert (0 < unit) by apply bpow_gt_0.
apply Rmult_le_reg_r with (1 + unit); [lra|].
unfold Rdiv; rewrite Rmult_assoc, Rinv_l; [nra|lra].
Qed.

Lemma rounded_normal x : least <= Rabs (rnd x) -> Rabs (rnd x - x) <= unit * Rabs (rnd x).
Proof.
intros h.
apply Rle_trans with (1 := error_le_half_ulp_round radix2 (FLT_exp (-1074) 53) (fun x => negb (Z.even x)) x).
assert (u := ulp_FLT_le radix2 (-1074) 53 (rnd x) h).
replace unit with (/ 2 * bpow radix2 (1 - 53)) by (simpl; lra).
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
intros h; destruct (finite_plus _ _ h) as [hx hy]; assert (c := Bplus_correct 53 1024 _ _ mode_NE x y hx hy).
destruct Rlt_bool.
  destruct c as [e _]; unfold bplus; rewrite e; apply rounded_sum; apply generic_format_B2R.
destruct c as [c _]; exfalso; unfold bplus in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma minus_close x y : is_finite (bminus x y) = true -> Rabs (B2R (bminus x y) - (B2R x - B2R y)) <= unit * Rabs (B2R x - B2R y).
Proof.
intros h; destruct (finite_minus _ _ h) as [hx hy]; assert (c := Bminus_correct 53 1024 _ _ mode_NE x y hx hy).
destruct Rlt_bool.
  destruct c as [e _]; unfold bminus; rewrite e; apply rounded_sum; [|apply generic_format_opp]; apply generic_format_B2R.
destruct c as [c _]; exfalso; unfold bminus in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma overflown_difference x y : is_finite x = true -> is_finite y = true -> is_finite (bminus x y) = false -> B2R x <> B2R y.
Proof.
intros hx hy h e; assert (c := Bminus_correct 53 1024 _ _ mode_NE x y hx hy).
rewrite e, Rminus_eq_0, round_0, Rabs_R0, Rlt_bool_true in c; [|apply bpow_gt_0|apply valid_rnd_round_mode].
destruct c as [_ [c _]]; unfold bminus in h; rewrite h in c; easy.
Qed.

Lemma times_round x y : is_finite (btimes x y) = true -> B2R (btimes x y) = rnd (B2R x * B2R y).
Proof.
intros h; assert (c := Bmult_correct 53 1024 _ _ mode_NE x y).
destruct Rlt_bool; [easy|].
exfalso; unfold btimes in h; rewrite <- is_finite_SF_B2SF in h; rewrite c in h; easy.
Qed.

Lemma over_round x y : is_finite (bover x y) = true -> is_finite y = true -> B2R (bover x y) = rnd (B2R x / B2R y).
Proof.
intros h hy; assert (ny := divisor_neq0 x y h hy); assert (c := Bdiv_correct 53 1024 _ _ mode_NE x y ny).
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
Arguments plus_close {x y} _.
Arguments minus_close {x y} _.
Arguments times_round {x y} _.
Arguments over_round {x y} _ _.
Arguments finite_plus {x y} _.
Arguments finite_minus {x y} _.
Arguments finite_times {x y} _.
Arguments finite_over {x y} _.
Arguments divisor_neq0 {x y} _ _.
Arguments infinite_divisor {x y} _ _.
Arguments overflown_difference {x y} _ _ _.

Definition zero : number := B754_zero false.
Definition one : number := @B754_finite 53 1024 false 4503599627370496 (-52) eq_refl.
Definition half : number := @B754_finite 53 1024 false 4503599627370496 (-53) eq_refl.
Definition largest : number := @B754_finite 53 1024 false 9007199254740991 971 eq_refl.
Definition tiny : number := @B754_finite 53 1024 false 1 (-1074) eq_refl.

Lemma one_value : B2R one = 1%R.
Proof. unfold B2R, F2R; simpl; lra. Qed.
Lemma half_value : B2R half = (/ 2)%R.
Proof. unfold B2R, F2R; simpl; lra. Qed.
Lemma tiny_value : (0 < B2R tiny)%R.
Proof. apply F2R_gt_0; easy. Qed.
Lemma largest_value : (0 < B2R largest)%R.
Proof. apply F2R_gt_0; easy. Qed.
