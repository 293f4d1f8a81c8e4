(* Lower bounds that survive roundings: what a bound, itself computed in binary numbers, is certainly no less than.
   Definitions:
     unit, small, eta     2^-prec, the least normal number, half of the least number
     above k t x          x >= 0 is no less than t but for k roundings, and no less where it is subnormal
     multiple x           x is an integer times the least number *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core Operations Plus_error.
From Torse Require Import Binary.

Section Rounding.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec}.
Hypothesis digits : (5 <= prec)%Z.
Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation format := (generic_format radix2 (FLT_exp emin prec)).
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Local Notation u := (bpow radix2 (- prec)).
Local Notation small := (bpow radix2 (emin + prec - 1)).
Local Notation eta := (bpow radix2 (emin - 1)).
Implicit Types (k s t x y : R).

Definition above k t x := 0 <= x /\ (1 - k * u) * t <= x /\ (x < small -> t <= x).
Definition multiple x := exists m : Z, x = IZR m * bpow radix2 emin.

Lemma unit_pos : 0 < u. Proof. apply bpow_gt_0. Qed.
Lemma unit_small : u <= / 32.
Proof. replace (/ 32) with (bpow radix2 (-5)) by (simpl; lra); apply bpow_le; lia. Qed.
Lemma small_pos : 0 < small. Proof. apply bpow_gt_0. Qed.
Lemma eta_pos : 0 < eta. Proof. apply bpow_gt_0. Qed.
Lemma eta_small : eta = u * small.
Proof. rewrite <- bpow_plus; f_equal; ring. Qed.
Lemma twice_small : 2 * small = bpow radix2 (emin + prec).
Proof. change (IZR radix2 * small = bpow radix2 (emin + prec)); now rewrite <- (bpow_plus_1 radix2 (emin + prec - 1)), Z.sub_add. Qed.

Lemma rnd_ge0 x : 0 <= x -> 0 <= rnd x.
Proof. intros h; rewrite <- (round_0 radix2 (FLT_exp emin prec) ZnearestE); apply round_le; try exact h; exact _. Qed.

Lemma rnd_small x : 0 <= x -> rnd x < small -> x < 2 * small.
Proof.
intros h lt; apply Rnot_le_lt; intros le; apply (Rlt_irrefl small), Rle_lt_trans with (2 := lt).
assert (0 < small) by apply small_pos; apply Rle_trans with (2 * small); [lra|].
apply round_ge_generic; [exact _|exact _| |exact le].
rewrite twice_small; apply generic_format_bpow; unfold FLT_exp; lia.
Qed.

Lemma multiple_format x : format x -> multiple x.
Proof.
intros h; apply generic_format_FIX_FLT, FIX_format_generic in h; destruct h as [[m e] -> he]; simpl in he; subst e.
now exists m.
Qed.

Lemma multiple_minus x y : multiple x -> multiple y -> multiple (x - y).
Proof. intros [m ->] [n ->]; exists (m - n)%Z; rewrite minus_IZR; ring. Qed.
Lemma multiple_opp x : multiple x -> multiple (- x).
Proof. intros [m ->]; exists (- m)%Z; rewrite opp_IZR; ring. Qed.
Lemma multiple_abs x : multiple x -> multiple (Rabs x).
Proof. intros h; unfold Rabs; destruct Rcase_abs; [apply multiple_opp|]; exact h. Qed.

Lemma format_multiple x : multiple x -> Rabs x <= 2 * small -> format x.
Proof.
intros [m ->] h; apply generic_format_FLT_FIX; [exact _|rewrite twice_small in h; exact h|].
apply generic_format_FIX; exists (Float radix2 m emin); reflexivity.
Qed.

Lemma multiple_product x y : format x -> format y -> bpow radix2 (emin + 2 * prec) <= Rabs (x * y) -> multiple (x * y).
Proof.
intros hx hy h; rewrite hx, hy; rewrite <- F2R_mult; simpl.
set (ex := cexp _ _ x); set (ey := cexp _ _ y); set (m := (_ * _)%Z).
assert (le : (emin <= ex + ey)%Z).
  assert (nz : x * y <> 0) by (intros z; rewrite z, Rabs_R0 in h; assert (q := bpow_gt_0 radix2 (emin + 2 * prec)); lra).
  assert (bx := bpow_mag_gt radix2 x); assert (by' := bpow_mag_gt radix2 y).
  assert (lt : Rabs (x * y) < bpow radix2 (mag radix2 x + mag radix2 y)).
    rewrite Rabs_mult, bpow_plus; apply Rmult_le_0_lt_compat; try apply Rabs_pos; assumption.
  assert (e := lt_bpow radix2 _ _ (Rle_lt_trans _ _ _ h lt)).
  unfold ex, ey, cexp, FLT_exp; lia.
exists (m * radix2 ^ (ex + ey - emin))%Z; unfold F2R; cbn [Fnum Fexp].
rewrite mult_IZR, Rmult_assoc, (IZR_Zpower radix2 (ex + ey - emin)) by lia.
now rewrite <- bpow_plus, Z.sub_add.
Qed.

Lemma above_self x : 0 <= x -> above 0 x x.
Proof. intros h; split; [exact h|split]; intros; lra. Qed.

Lemma above_weaken j k s t x : j <= k <= 7 -> t <= s -> above j s x -> above k t x.
Proof.
assert (hu := unit_pos); assert (hu' := unit_small).
intros hk hst [h0 [h1 h2]]; split; [exact h0|split]; [|intros lt; apply h2 in lt; lra].
destruct (Rle_lt_dec t 0) as [ht|ht].
  apply Rle_trans with 0; [|exact h0]; assert (0 <= 1 - k * u) by nra; nra.
apply Rle_trans with (2 := h1); assert (k * u <= 7 * u) by nra; assert (j * u <= k * u) by nra.
apply Rle_trans with ((1 - j * u) * t); [|apply Rmult_le_compat_l]; nra.
Qed.

Lemma above_plus k s t x y : 0 <= k <= 6 -> format x -> format y -> above k s x -> above k t y -> above (k + 1) (s + t) (rnd (x + y)).
Proof.
assert (hu := unit_pos); assert (hu' := unit_small).
intros hk fx fy [x0 [hx sx]] [y0 [hy sy]].
assert (g0 : 0 <= rnd (x + y)) by (apply rnd_ge0; lra).
split; [exact g0|split].
  destruct (Rle_lt_dec (s + t) 0) as [h|h].
    apply Rle_trans with 0; [|exact g0]; assert (0 <= 1 - (k + 1) * u) by nra; nra.
  assert (c := rounded_sum prec emax x y fx fy); apply Rabs_le_inv in c; rewrite (Rabs_pos_eq (x + y)) in c by lra.
  apply Rle_trans with ((1 - u) * (x + y)); [|lra].
  apply Rle_trans with ((1 - u) * ((1 - k * u) * (s + t))); [|apply Rmult_le_compat_l; lra].
  rewrite <- Rmult_assoc; apply Rmult_le_compat_r; nra.
intros lt; assert (lt' := rnd_small (x + y) (Rplus_le_le_0_compat _ _ x0 y0) lt).
assert (e : rnd (x + y) = x + y).
  apply round_generic; [exact _|]; apply FLT_format_plus_small; try assumption.
  rewrite Rabs_pos_eq by lra; rewrite Z.add_comm, <- twice_small; lra.
rewrite e in *; assert (s <= x) by (apply sx; lra); assert (t <= y) by (apply sy; lra); lra.
Qed.

Lemma above_normal t : 0 <= t -> small <= rnd t -> (1 - u) * t <= rnd t.
Proof.
intros ht h; assert (hu := unit_pos); assert (g0 := rnd_ge0 t ht); assert (s0 := small_pos).
assert (c := rounded_normal prec emax t); rewrite (Rabs_pos_eq (rnd t)) in c by lra.
replace (2 - emax)%Z with (emin + prec - 1)%Z in c by ring; specialize (c h); apply Rabs_le_inv in c.
assert (u <= 1) by (assert (e := unit_small); lra).
nra.
Qed.

Lemma subnormal_error t : 0 <= t -> rnd t < small -> t - eta <= rnd t.
Proof.
intros ht h; assert (lt := rnd_small t ht h).
assert (c := error_le_half_ulp radix2 (FLT_exp emin prec) (fun z : Z => negb (Z.even z)) t).
rewrite ulp_FLT_small in c; [|exact _|rewrite Rabs_pos_eq, <- twice_small; lra].
apply Rabs_le_inv in c; replace eta with (/ 2 * bpow radix2 emin); [lra|].
replace emin with (emin - 1 + 1)%Z at 1 by ring; rewrite bpow_plus_1; change (IZR radix2) with 2; lra.
Qed.

Lemma above_rounded t : 0 <= t -> above 1 (t - 2 * eta) (rnd t).
Proof.
intros ht; assert (hu := unit_pos); assert (hu' := unit_small); assert (he := eta_pos); assert (g0 := rnd_ge0 t ht).
destruct (Rle_lt_dec small (rnd t)) as [h|h].
  split; [exact g0|split]; [|intros; lra]; assert (c := above_normal t ht h); nra.
assert (c := subnormal_error t ht h); split; [exact g0|split]; [|intros; lra].
destruct (Rle_lt_dec (t - 2 * eta) 0); nra.
Qed.

Lemma above_multiple t : 0 <= t -> multiple t -> above 1 t (rnd t).
Proof.
intros ht m; assert (hu := unit_pos); assert (g0 := rnd_ge0 t ht).
destruct (Rle_lt_dec small (rnd t)) as [h|h].
  split; [exact g0|split]; [|intros; lra]; assert (c := above_normal t ht h); lra.
assert (e : rnd t = t).
  apply round_generic; [exact _|]; apply format_multiple; [exact m|].
  rewrite Rabs_pos_eq by exact ht; apply Rlt_le, rnd_small; assumption.
rewrite e in *; split; [exact g0|split]; [|intros]; nra.
Qed.

(* The factor of the header, 1 + 2^-49 in doubles, makes up for seven roundings. *)
Lemma rounded_up_above k t x : 0 <= k <= 7 -> format x -> above k t x -> t <= rnd (x * (1 + 16 * u)).
Proof.
assert (hu := unit_pos); assert (hu' := unit_small); intros hk fx [x0 [h1 h2]].
assert (le : x <= rnd (x * (1 + 16 * u))) by (apply round_ge_generic; [exact _|exact _|exact fx|nra]).
destruct (Rle_lt_dec small x) as [h|h]; [|specialize (h2 h); lra].
destruct (Rle_lt_dec t 0) as [ht|ht]; [lra|].
assert (c := above_normal (x * (1 + 16 * u))); apply Rle_trans with (2 := c ltac:(nra) ltac:(lra)).
apply Rle_trans with ((1 - u) * (((1 - k * u) * t) * (1 + 16 * u))).
  replace ((1 - u) * ((1 - k * u) * t * (1 + 16 * u))) with (t * ((1 - u) * (1 - k * u) * (1 + 16 * u))) by ring.
  rewrite <- (Rmult_1_r t) at 1; apply Rmult_le_compat_l; [lra|].
  assert (1 - 8 * u <= (1 - u) * (1 - k * u)) by nra; nra.
apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat_r; lra.
Qed.

Lemma above_over k t x d : 0 <= k <= 5 -> 0 < d -> above k t x -> above (k + 2) (t / d) (rnd (rnd (x / d) + 32 * eta)).
Proof.
intros hk hd [x0 [h1 h2]].
assert (hu := unit_pos); assert (hu' := unit_small); assert (he := eta_pos); assert (hs := small_pos).
assert (q0 : 0 <= x / d) by (apply Rmult_le_pos; [exact x0|apply Rlt_le, Rinv_0_lt_compat, hd]).
assert (q1 : (1 - k * u) * (t / d) <= x / d).
  unfold Rdiv; rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, hd|exact h1].
assert (f32 : format (32 * eta)).
  replace (32 * eta) with (bpow radix2 (emin + 4)).
    apply generic_format_bpow; unfold FLT_exp; lia.
  replace (emin + 4)%Z with (5 + (emin - 1))%Z by ring; now rewrite bpow_plus.
assert (ff : format (rnd (x / d))) by (apply generic_format_round; exact _).
set (q := x / d) in *; set (r := t / d) in *; set (f := rnd q) in *; assert (f0 : 0 <= f) by now apply rnd_ge0.
assert (g0 : 0 <= rnd (f + 32 * eta)) by (apply rnd_ge0; lra).
split; [exact g0|].
destruct (Rle_lt_dec small f) as [h|h].
  assert (c := above_normal q q0 h); fold f in c.
  assert (le : f <= rnd (f + 32 * eta)) by (apply round_ge_generic; [exact _|exact _|exact ff|lra]).
  split; [|intros; lra]; apply Rle_trans with (2 := le).
  destruct (Rle_lt_dec r 0) as [hr|hr]; [assert (0 <= 1 - (k + 2) * u) by nra; nra|].
  apply Rle_trans with ((1 - u) * ((1 - k * u) * r)); [|nra].
  rewrite <- Rmult_assoc; apply Rmult_le_compat_r; nra.
assert (c := subnormal_error q q0 h); fold f in c; assert (lt := rnd_small q q0 h).
assert (key : r <= f + 32 * eta).
  destruct (Rle_lt_dec r 0) as [hr|hr]; [lra|].
  assert (/ 2 * r <= (1 - k * u) * r) by (apply Rmult_le_compat_r; nra).
  assert (r <= 4 * small) by lra.
  assert (k * u * r <= 20 * eta).
    rewrite eta_small; apply Rle_trans with (5 * u * r); [apply Rmult_le_compat_r; nra|].
    replace (20 * (u * small)) with (5 * u * (4 * small)) by ring; apply Rmult_le_compat_l; lra.
  lra.
assert (e : rnd (f + 32 * eta) = f + 32 * eta).
  apply round_generic; [exact _|]; apply FLT_format_plus_small; try assumption.
  assert (eta <= / 32 * small) by (rewrite eta_small; apply Rmult_le_compat_r; lra).
  rewrite Rabs_pos_eq by lra; rewrite Z.add_comm, <- twice_small; lra.
rewrite e; split; [|intros _; exact key].
destruct (Rle_lt_dec r 0) as [hr|hr]; [assert (0 <= 1 - (k + 2) * u) by nra; nra|].
assert (0 <= (k + 2) * u) by nra; nra.
Qed.
End Rounding.
