(* The parts of running error analysis: its constants, and what its computed bounds are no less than.
   Definitions:
     wide prec emax       what the constants need of a format: 5 digits or more, and exponents up to 8 more than that *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core Operations BinarySingleNaN Plus_error Pff2Flocq.
From Torse Require Import Binary Running Running_rounding.

Definition wide (prec emax : Z) := (5 <= prec /\ prec + 8 <= emax)%Z.

Section Numbers.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Hypothesis format_wide : wide prec emax.
Local Notation number := (number prec emax).
Implicit Types a b c x y : number.
Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation format := (generic_format radix2 (FLT_exp emin prec)).
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Local Notation u := (bpow radix2 (- prec)).
Local Notation small := (bpow radix2 (emin + prec - 1)).
Local Notation eta := (bpow radix2 (emin - 1)).
Local Notation above := (above prec emax).
Local Notation multiple := (multiple prec emax).
Local Notation up := (up prec emax).
Local Notation down := (down prec emax).
Local Notation tiny := (tiny prec emax).
Local Notation underflow := (underflow prec emax).
Local Notation lost := (lost prec emax).
Local Notation rounded_up := (rounded_up prec emax).

Let digits : (5 <= prec)%Z. Proof. exact (proj1 format_wide). Qed.
Let range : (prec + 8 <= emax)%Z. Proof. exact (proj2 format_wide). Qed.

Lemma number_format a : format (B2R a). Proof. apply generic_format_B2R. Qed.

Lemma binary_value (m e : Z) : format (F2R (Float radix2 m e)) -> Rabs (F2R (Float radix2 m e)) < bpow radix2 emax ->
  is_finite (binary prec emax m e) = true /\ B2R (binary prec emax m e) = F2R (Float radix2 m e).
Proof.
intros f lt; assert (c := binary_normalize_correct prec emax _ _ mode_NE m e false); cbv zeta in c.
rewrite round_generic in c; [|exact _|exact f].
rewrite Rlt_bool_true in c by exact lt; destruct c as [v [fin _]]; split; assumption.
Qed.

Lemma format_float (m e : Z) : (emin <= e)%Z -> (Z.abs m < 2 ^ prec)%Z -> format (F2R (Float radix2 m e)).
Proof.
intros he hm; apply generic_format_FLT; exists (Float radix2 m e); [reflexivity| |exact he]; exact hm.
Qed.

Lemma power_value (e : Z) : (emin <= e < emax)%Z -> is_finite (binary prec emax 1 e) = true /\ B2R (binary prec emax 1 e) = bpow radix2 e.
Proof.
intros he; rewrite <- (F2R_bpow radix2 e); apply binary_value; [apply format_float; [lia|]|].
  apply (Z.pow_gt_1 2 prec); lia.
rewrite F2R_bpow, Rabs_pos_eq by apply bpow_ge_0; apply bpow_lt; lia.
Qed.

Lemma underflow_value : is_finite underflow = true /\ B2R underflow = 32 * eta.
Proof.
replace (32 * eta) with (bpow radix2 (emin + 4)); [apply power_value; lia|].
now replace (emin + 4)%Z with (5 + (emin - 1))%Z by ring; rewrite bpow_plus.
Qed.

Lemma tiny_value : is_finite tiny = true /\ B2R tiny = bpow radix2 (emin + 2 * prec + 8).
Proof. apply power_value; lia. Qed.

Lemma scaled_power (k e : Z) : (0 <= k)%Z -> IZR (2 ^ k) * bpow radix2 e = bpow radix2 (k + e).
Proof. intros hk; change (2 ^ k)%Z with (radix2 ^ k)%Z; rewrite IZR_Zpower by exact hk; now rewrite <- bpow_plus. Qed.

Lemma unit_lt1 : u < 1. Proof. apply (bpow_lt radix2 _ 0); lia. Qed.
Lemma emax_big : 4 <= bpow radix2 emax.
Proof. change 4 with (bpow radix2 2); apply bpow_le; lia. Qed.

Lemma up_value : is_finite up = true /\ B2R up = 1 + 16 * u.
Proof.
assert (e : F2R (Float radix2 (2 ^ (prec - 4) + 1) (4 - prec)) = 1 + 16 * u).
  unfold F2R; cbn [Fnum Fexp]; rewrite plus_IZR, Rmult_plus_distr_r, scaled_power by lia.
  replace (prec - 4 + (4 - prec))%Z with 0%Z by ring; rewrite Rmult_1_l; unfold Z.sub; now rewrite bpow_plus.
rewrite <- e; apply binary_value.
  apply format_float; [lia|].
  assert (0 < 2 ^ (prec - 4))%Z by (apply Z.pow_pos_nonneg; lia).
  assert (2 ^ prec = 2 ^ (prec - 4) * 16)%Z by (change 16%Z with (2 ^ 4)%Z; rewrite <- Z.pow_add_r by lia; f_equal; ring).
  lia.
rewrite e; assert (h := bpow_gt_0 radix2 (- prec)); assert (h' := unit_small prec digits); assert (h'' := emax_big).
rewrite Rabs_pos_eq; lra.
Qed.

Lemma down_value : is_finite down = true /\ B2R down = 1 - 2 * u.
Proof.
assert (e : F2R (Float radix2 (2 ^ (prec - 1) - 1) (1 - prec)) = 1 - 2 * u).
  unfold F2R; cbn [Fnum Fexp]; rewrite minus_IZR, Rmult_minus_distr_r, scaled_power by lia.
  replace (prec - 1 + (1 - prec))%Z with 0%Z by ring; rewrite Rmult_1_l; unfold Z.sub; now rewrite (bpow_plus _ 1 (- prec)).
rewrite <- e; apply binary_value.
  apply format_float; [lia|].
  assert (0 < 2 ^ (prec - 1))%Z by (apply Z.pow_pos_nonneg; lia).
  assert (2 ^ prec = 2 ^ (prec - 1) * 2)%Z by (replace prec with (Z.succ (prec - 1)) at 1 by ring; rewrite Z.pow_succ_r by lia; ring).
  lia.
rewrite e; assert (h := bpow_gt_0 radix2 (- prec)); assert (h' := unit_small prec digits); assert (h'' := emax_big).
rewrite Rabs_pos_eq; lra.
Qed.

Lemma positive_number a : is_finite a = true -> 0 < B2R a -> exists m e h, a = B754_finite false m e h.
Proof.
destruct a as [s|s| |s m e h]; simpl; try easy; [intros _ lt; now apply Rlt_irrefl in lt|intros _ lt].
destruct s; [|now exists m, e, h].
assert (n := F2R_lt_0 radix2 (Float radix2 (Z.neg m) e)); simpl in n; specialize (n eq_refl); simpl in lt; lra.
Qed.
Lemma up_positive : exists m e h, up = B754_finite false m e h.
Proof. destruct up_value as [f v]; apply positive_number; [exact f|rewrite v]; assert (h := bpow_gt_0 radix2 (- prec)); lra. Qed.
Lemma down_positive : exists m e h, down = B754_finite false m e h.
Proof. destruct down_value as [f v]; apply positive_number; [exact f|rewrite v]; assert (h := unit_small prec digits); lra. Qed.

Lemma plus_round x y : is_finite (bplus x y) = true -> B2R (bplus x y) = rnd (B2R x + B2R y).
Proof.
intros h; destruct (finite_plus h) as [hx hy]; assert (c := Bplus_correct prec emax _ _ mode_NE x y hx hy).
destruct Rlt_bool; [easy|]; destruct c as [c _]; exfalso; unfold bplus in h; rewrite <- is_finite_SF_B2SF in h; now rewrite c in h.
Qed.
Lemma minus_round x y : is_finite (bminus x y) = true -> B2R (bminus x y) = rnd (B2R x - B2R y).
Proof.
intros h; destruct (finite_minus h) as [hx hy]; assert (c := Bminus_correct prec emax _ _ mode_NE x y hx hy).
destruct Rlt_bool; [easy|]; destruct c as [c _]; exfalso; unfold bminus in h; rewrite <- is_finite_SF_B2SF in h; now rewrite c in h.
Qed.

Lemma finite_fma x y z : is_finite (Bfma mode_NE x y z) = true -> is_finite x = true /\ is_finite y = true /\ is_finite z = true.
Proof. destruct x as [sx|sx| |sx mx ex hx], y as [sy|sy| |sy my ey hy], z as [sz|sz| |sz mz ez hz]; simpl; try easy; now destruct sx, sy, sz. Qed.
Lemma fma_round x y z : is_finite (Bfma mode_NE x y z) = true -> B2R (Bfma mode_NE x y z) = rnd (B2R x * B2R y + B2R z).
Proof.
intros h; destruct (finite_fma x y z h) as [hx [hy hz]]; assert (c := Bfma_correct prec emax _ _ mode_NE x y z hx hy hz); cbv zeta in c.
destruct Rlt_bool; [easy|]; exfalso; rewrite <- is_finite_SF_B2SF in h; now rewrite c in h.
Qed.

Lemma abs_rnd (r : R) : Rabs (rnd r) = rnd (Rabs r).
Proof. now rewrite round_NE_abs; [|apply FLT_exp_valid]. Qed.

(* The size of a rounded number is no less than the size of the number, but for a rounding and where it is tiny. *)
Lemma residual x y z : is_finite (Bfma mode_NE x y z) = true -> above 1 (Rabs (B2R x * B2R y + B2R z) - 2 * eta) (B2R (Babs (Bfma mode_NE x y z))).
Proof. intros h; rewrite B2R_Babs, fma_round, abs_rnd by exact h; apply above_rounded; [exact _|exact digits|apply Rabs_pos]. Qed.
Lemma exact_residual x y z : is_finite (Bfma mode_NE x y z) = true -> bpow radix2 (emin + 2 * prec) <= Rabs (B2R x * B2R y) ->
  above 1 (Rabs (B2R x * B2R y + B2R z)) (B2R (Babs (Bfma mode_NE x y z))).
Proof.
intros h big; rewrite B2R_Babs, fma_round, abs_rnd by exact h; apply above_multiple; [exact _|exact digits|apply Rabs_pos|].
apply multiple_abs; rewrite <- (Ropp_involutive (B2R z)); apply multiple_minus.
  apply multiple_product; [apply number_format|apply number_format|exact big].
apply multiple_opp, multiple_format, number_format.
Qed.

Lemma sum_above k s t x y : 0 <= k <= 6 -> is_finite (bplus x y) = true -> above k s (B2R x) -> above k t (B2R y) ->
  above (k + 1) (s + t) (B2R (bplus x y)).
Proof. intros hk h hx hy; rewrite plus_round by exact h; apply above_plus; try apply number_format; try exact digits; try exact _; assumption. Qed.
Lemma product_above x y : is_finite (btimes x y) = true -> 0 <= B2R x -> 0 <= B2R y -> above 1 (B2R x * B2R y - 2 * eta) (B2R (btimes x y)).
Proof. intros h hx hy; rewrite (times_round h); apply above_rounded; [exact _|exact digits|]; now apply Rmult_le_pos. Qed.

Lemma lost_value x : is_finite x = true -> is_finite (lost x) = true /\
  (B2R (lost x) = 32 * eta \/ B2R (lost x) = 0 /\ bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R x)).
Proof.
intros h; destruct tiny_value as [ft vt]; unfold Running.lost; rewrite Bltb_correct by (try rewrite is_finite_Babs; assumption).
rewrite B2R_Babs, vt; case Rlt_bool_spec; intros lt; [|now split; [|right]].
destruct underflow_value as [fu vu]; split; [exact fu|now left].
Qed.

Lemma rounded_up_value b : if is_finite (rounded_up b) then is_finite b = true /\ 0 <= B2R b /\ B2R (rounded_up b) = rnd (B2R b * (1 + 16 * u))
  else rounded_up b = unknown.
Proof.
destruct up_value as [fu vu]; destruct up_positive as [m [e [hu eu]]]; unfold Running.rounded_up.
destruct (Bleb zero b) eqn:le; [|easy].
destruct (is_finite b) eqn:fb; [|destruct b as [|[|]| |]; try easy; now rewrite eu].
rewrite Bleb_correct in le by easy; revert le; case Rle_bool_spec; [intros le _|easy].
assert (c := Bmult_correct prec emax _ _ mode_NE b up); fold (btimes b up) in c; revert c; case Rlt_bool_spec; intros lt c.
  destruct c as [v [f _]]; rewrite f, fb, fu; simpl; split; [easy|split; [exact le|]]; now rewrite v, vu.
destruct (Rle_lt_or_eq_dec _ _ le) as [pos|z].
  destruct (positive_number b fb pos) as [mb [eb [hb ->]]]; rewrite eu in c; simpl in c.
  assert (n : btimes (B754_finite false mb eb hb) up = unknown) by (rewrite eu; now apply B2SF_inj).
  now rewrite n.
exfalso; simpl in z; rewrite <- z, Rmult_0_l, round_0, Rabs_R0 in lt; [|exact _].
assert (h := bpow_gt_0 radix2 emax); lra.
Qed.

Lemma bound_above k t b : 0 <= k <= 7 -> is_finite (rounded_up b) = true -> above k t (B2R b) -> t <= B2R (rounded_up b).
Proof.
intros hk h ha; assert (c := rounded_up_value b); rewrite h in c; destruct c as [_ [_ ->]].
apply (rounded_up_above prec emax digits k); [exact hk|apply number_format|exact ha].
Qed.
End Numbers.
