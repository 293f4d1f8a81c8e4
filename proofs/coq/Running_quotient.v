(* Quotients and roots of running error analysis keep its invariant. *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core BinarySingleNaN Plus_error.
From Torse Require Import Binary Running Running_rounding Running_numbers Running_operations.

Section Quotients.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Hypothesis format_wide : wide prec emax.
Local Notation number := (number prec emax).
Local Notation running := (running prec emax).
Implicit Types (a b d q : number) (x y : running) (X Y : exact).
Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation format := (generic_format radix2 (FLT_exp emin prec)).
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Local Notation u := (bpow radix2 (- prec)).
Local Notation small := (bpow radix2 (emin + prec - 1)).
Local Notation eta := (bpow radix2 (emin - 1)).
Local Notation above := (above prec emax).
Local Notation lost := (lost prec emax).
Local Notation rounded_up := (rounded_up prec emax).
Local Notation down := (down prec emax).
Local Notation underflow := (underflow prec emax).
Local Notation exactly_zero := (exactly_zero prec emax).
Local Notation inexact := (inexact prec emax).
Let digits : (5 <= prec)%Z. Proof. exact (proj1 format_wide). Qed.
Let range : (prec + 8 <= emax)%Z. Proof. exact (proj2 format_wide). Qed.

Lemma minus_finite a b : is_finite a = true -> is_finite b = true -> 0 <= B2R a -> 0 <= B2R b -> is_finite (bminus a b) = true.
Proof.
intros fa fb ha hb; assert (c := Bminus_correct prec emax _ _ mode_NE a b fa fb); fold (bminus a b) in c.
rewrite Rlt_bool_true in c; [easy|].
assert (la := abs_B2R_lt_emax _ _ a); assert (lb := abs_B2R_lt_emax _ _ b); rewrite Rabs_pos_eq in la, lb by assumption.
destruct (Rle_lt_dec (B2R b) (B2R a)) as [h|h].
  apply Rle_lt_trans with (2 := la), abs_round_le_generic; [exact _|exact _|apply number_format|]; rewrite Rabs_pos_eq; lra.
apply Rle_lt_trans with (2 := lb), abs_round_le_generic; [exact _|exact _|apply number_format|]; rewrite Rabs_left; lra.
Qed.

Lemma times_down_finite a : is_finite a = true -> is_finite (btimes a down) = true.
Proof.
intros fa; destruct (down_value prec emax format_wide) as [fd vd].
assert (hu := unit_pos prec); assert (hu' := unit_small prec digits).
assert (c := Bmult_correct prec emax _ _ mode_NE a down); fold (btimes a down) in c; rewrite Rlt_bool_true in c.
  destruct c as [_ [-> _]]; now rewrite fa, fd.
apply Rle_lt_trans with (2 := abs_B2R_lt_emax _ _ a).
apply abs_round_le_generic; [exact _|exact _|rewrite <- B2R_Babs; apply number_format|].
rewrite Rabs_mult, vd, (Rabs_pos_eq (1 - _)) by lra; assert (h := Rabs_pos (B2R a)); nra.
Qed.

(* The difference of two sizes, rounded and taken down, is no more than the difference. *)
Lemma divisor_below (s e : R) : format s -> format e -> 0 <= s -> 0 <= e ->
  0 < rnd (rnd (s - e) * (1 - 2 * u)) -> rnd (rnd (s - e) * (1 - 2 * u)) <= s - e.
Proof.
intros fs fe hs he; set (f := rnd (s - e)); intros pos.
assert (hu := unit_pos prec); assert (hu' := unit_small prec digits); assert (h0 := small_pos prec emax).
assert (f0 : 0 < f).
  apply Rnot_le_lt; intros le; apply (Rlt_not_le _ _ pos).
  rewrite <- (round_0 radix2 (FLT_exp emin prec) ZnearestE); apply round_le; [exact _|exact _|nra].
assert (d0 : 0 < s - e).
  apply Rnot_le_lt; intros le; apply (Rlt_not_le _ _ f0).
  unfold f; rewrite <- (round_0 radix2 (FLT_exp emin prec) ZnearestE); apply round_le; [exact _|exact _|lra].
destruct (Rle_lt_dec (s - e) (2 * small)) as [h|h].
  assert (ff : format (s - e)).
    apply FLT_format_plus_small; [exact _|exact fs|now apply generic_format_opp|].
    rewrite Z.add_comm, <- twice_small; fold (s - e); rewrite Rabs_pos_eq; lra.
  unfold f; rewrite (round_generic _ _ _ (s - e)) by (try exact _; exact ff).
  apply round_le_generic; [exact _|exact _|exact ff|nra].
assert (big : 2 * small <= f).
  apply round_ge_generic; [exact _|exact _| |lra]; rewrite twice_small; apply generic_format_bpow; unfold FLT_exp; lia.
assert (c := rounded_sum prec emax s (- e) fs (generic_format_opp _ _ _ fe)); fold (s - e) in c; fold f in c.
rewrite (Rabs_pos_eq (s - e)) in c by lra; apply Rabs_le_inv in c.
set (z := f * (1 - 2 * u)) in *.
assert (zs : small <= rnd z).
  apply round_ge_generic; [exact _|exact _| |unfold z; nra]; apply generic_format_bpow; unfold FLT_exp; lia.
assert (c' := rounded_normal prec emax z); rewrite (Rabs_pos_eq (rnd z)) in c' by lra.
replace (2 - emax)%Z with (emin + prec - 1)%Z in c' by ring; specialize (c' zs); apply Rabs_le_inv in c'.
apply (Rmult_le_reg_r (1 - u)); [lra|].
apply Rle_trans with z; [lra|]; unfold z; apply Rle_trans with ((s - e) * (1 + u) * (1 - 2 * u)); [apply Rmult_le_compat_r; lra|].
rewrite Rmult_assoc; apply Rmult_le_compat_l; nra.
Qed.

Lemma divisor_known y Y : tracks y Y -> Bltb zero (btimes (bminus (Babs (value y)) (bound y)) down) = true ->
  let d := btimes (bminus (Babs (value y)) (bound y)) down in
  is_finite (bound y) = true /\ is_finite d = true /\ 0 < B2R d <= Rabs (B2R (value y)) - B2R (bound y).
Proof.
intros hy pos d; destruct (is_finite (bound y)) eqn:fb.
  destruct (known _ _ _ _ hy fb) as [fv [hb _]]; split; [easy|].
  assert (fm : is_finite (bminus (Babs (value y)) (bound y)) = true).
    apply minus_finite; [now rewrite is_finite_Babs|exact fb|apply abs_ge0|exact hb].
  assert (fd : is_finite d = true) by now apply times_down_finite.
  fold d in pos; rewrite Bltb_correct in pos by easy; revert pos; simpl; case Rlt_bool_spec; [intros pos _|easy].
  split; [exact fd|split; [exact pos|]]; revert pos; unfold d; rewrite (times_round fd), (minus_round _ _ _ _ fm), B2R_Babs.
  destruct (down_value prec emax format_wide) as [_ ->]; apply divisor_below; try apply number_format; try exact hb; try apply Rabs_pos.
  rewrite <- B2R_Babs; apply number_format.
exfalso; revert pos; rewrite (not_finite _ _ _ _ hy fb); destruct (down_positive prec emax format_wide) as [m [e [h ->]]].
now destruct (value y) as [s|s| |s my ey hy'].
Qed.

Lemma quotient_error (a b q ea eb d x y : R) : Rabs (a - x) <= ea -> Rabs (b - y) <= eb -> 0 < d <= Rabs b - eb ->
  y <> 0 /\ Rabs (q - x / y) <= (Rabs (- q * b + a) + (Rabs q * eb + ea)) / d.
Proof.
intros hx hy [d0 hd].
assert (size : d <= Rabs y).
  apply Rle_trans with (1 := hd); assert (c := Rabs_triang (b - y) y); replace (b - y + y) with b in c by ring; lra.
assert (ny : y <> 0) by (intros e; rewrite e, Rabs_R0 in size; lra).
split; [exact ny|].
replace (q - x / y) with ((q * y - x) / y) by (field; exact ny).
unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
apply Rmult_le_compat; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat; lra| |now apply Rinv_le_contravar].
replace (q * y - x) with (- (- q * b + a) + (- (q * (b - y)) + (a - x))) by ring.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; apply Rplus_le_compat_l.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, Rabs_mult; apply Rplus_le_compat; [|exact hx].
apply Rmult_le_compat_l; [apply Rabs_pos|exact hy].
Qed.

(* A quotient and a dividend that are not tiny: their residual loses nothing. *)
Lemma quotient_survives a b : is_finite (bover a b) = true -> is_finite b = true -> bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R a) ->
  bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R (bover a b)) -> bpow radix2 (emin + 2 * prec) <= Rabs (B2R (Bopp (bover a b)) * B2R b).
Proof.
intros f fb ha hq; assert (nb := divisor_neq0 f fb).
assert (normal : small <= Rabs (B2R (bover a b))) by (apply Rle_trans with (2 := hq), bpow_le; lia).
rewrite B2R_Bopp; set (q := B2R (bover a b)) in *; assert (eq : q = rnd (B2R a / B2R b)) by now apply over_round.
assert (c := rounded_normal prec emax (B2R a / B2R b)); rewrite <- eq in c.
replace (2 - emax)%Z with (emin + prec - 1)%Z in c by ring; specialize (c normal).
assert (hu := unit_pos prec); assert (hu' := unit_small prec digits).
assert (le : Rabs (B2R a) <= 2 * Rabs (- q * B2R b)).
  rewrite Rabs_mult, Rabs_Ropp, <- Rmult_assoc; replace (B2R a) with (B2R a / B2R b * B2R b) by (field; exact nb).
  rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos|].
  assert (t := Rabs_triang_inv (B2R a / B2R b) q); rewrite Rabs_minus_sym in t; assert (p := Rabs_pos q); nra.
assert (two : 2 * bpow radix2 (emin + 2 * prec) <= bpow radix2 (emin + 2 * prec + 8)).
  change 2 with (bpow radix2 1); rewrite <- bpow_plus; apply bpow_le; lia.
lra.
Qed.

Lemma zero_over a b : is_finite a = true -> B2R a = 0 -> is_finite b = true -> B2R b <> 0 -> is_finite (bover a b) = true /\ B2R (bover a b) = 0.
Proof.
intros fa va fb nb; assert (c := Bdiv_correct prec emax _ _ mode_NE a b nb); fold (bover a b) in c.
unfold Rdiv in c; rewrite va, Rmult_0_l, round_0, Rabs_R0, Rlt_bool_true in c; [|apply bpow_gt_0|exact _].
destruct c as [v [f _]]; now rewrite f.
Qed.

Lemma over_finite a d : is_finite (bover a d) = true -> is_finite a = true. Proof. exact finite_over. Qed.

(* The bound rest / d + underflow, or zero where rest is zero. *)
Lemma over_bound k t rest d : 0 <= k <= 5 -> is_finite d = true -> 0 < B2R d ->
  let c := if Beqb rest zero then zero else rounded_up (bplus (bover rest d) underflow) in
  (is_finite c = false -> c = unknown) /\
  (is_finite c = true -> is_finite rest = true /\ (above k t (B2R rest) -> t / B2R d <= B2R c)).
Proof.
intros hk fd hd c; unfold c; clear c; destruct (Beqb rest zero) eqn:z.
  destruct (is_zero_number _ _ _ z) as [f e]; split; [easy|intros _; split; [exact f|]]; rewrite e; simpl.
  intros [_ [_ h]]; specialize (h (small_pos prec emax)); assert (i := Rinv_0_lt_compat _ hd); unfold Rdiv; nra.
split; intros f; [assert (c := rounded_up_value prec emax format_wide (bplus (bover rest d) underflow)); now rewrite f in c|].
assert (c := rounded_up_value prec emax format_wide (bplus (bover rest d) underflow)); rewrite f in c; destruct c as [fp _].
destruct (finite_plus fp) as [fo _]; split; [exact (finite_over fo)|]; intros ha.
apply (bound_above prec emax format_wide (k + 2)); [lra|exact f|].
rewrite plus_round by exact fp; rewrite (over_round fo fd); destruct (underflow_value prec emax format_wide) as [_ ->].
apply above_over; assumption.
Qed.
(** rounding.binary.running quotient: likewise the computed quotient; that its bound is finite says as well that the exact divisor is not zero.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_quotient x y X Y : tracks x X -> tracks y Y -> tracks (over_running prec emax x y) (over_exact X Y).
Proof.
intros hx hy; unfold over_running.
set (q := bover (value x) (value y)); set (d := btimes _ down); destruct (Bltb zero d) eqn:pos; cbn [negb]; [|easy].
destruct (divisor_known _ _ hy pos) as [fby [fd hd]]; fold d in fd, hd.
destruct (known _ _ _ _ hy fby) as [fy [by' [ry [-> ey]]]].
destruct (exactly_zero x) eqn:z.
  destruct (exactly_zero_known _ _ _ _ hx z) as [-> [fx [vx [_ _]]]].
  destruct (quotient_error 0 (B2R (value y)) 0 0 (B2R (bound y)) (B2R d) 0 ry) as [ny _]; [rewrite Rminus_0_r, Rabs_R0; lra|exact ey|exact hd|].
  assert (nv : B2R (value y) <> 0) by (intros e; rewrite e, Rabs_R0 in hd; lra).
  destruct (zero_over _ _ fx vx fy nv) as [fq vq]; fold q in fq, vq.
  unfold tracks; simpl; split; [exact fq|]; exists (0 / ry); destruct (Req_EM_T ry 0); [easy|split; [easy|]].
  rewrite vq; unfold Rdiv; rewrite Rmult_0_l, Rminus_0_r, Rabs_R0; lra.
clear z; set (local := bplus (bplus (Babs _) _) _); match goal with |- context [Beqb ?c zero] => set (rest := c) end.
set (t := Rabs (- B2R q * B2R (value y) + B2R (value x)) + (Rabs (B2R q) * B2R (bound y) + B2R (bound x))).
assert (ob := over_bound 4 t rest d ltac:(lra) fd (proj1 hd)); cbv zeta in ob.
match goal with |- context [Running _ ?c] => set (bd := c) in *; unfold tracks; cbn [bound value]; destruct (is_finite bd); [|now apply ob] end.
destruct (proj2 ob eq_refl) as [fr key]; clear ob.
assert (fl : is_finite local = true) by (unfold rest in fr; destruct (_ || _)%bool; [apply (finite_plus fr)|exact fr]).
destruct (finite_plus fl) as [fl1 fl2]; destruct (finite_plus fl1) as [ff _]; rewrite is_finite_Babs in ff.
destruct (finite_fma _ _ _ _ _ ff) as [fq [_ fx]]; rewrite is_finite_Bopp in fq.
assert (fbx : is_finite (bound x) = true).
{ unfold rest in fr; destruct (inexact (bound x)) eqn:nx; cbn [orb] in fr.
    destruct (finite_plus fr) as [_ fe]; destruct (finite_plus fe) as [fe1 _]; apply (finite_plus fe1).
  unfold Running.inexact in nx; apply Bool.negb_false_iff in nx; now apply is_zero_number. }
destruct (known _ _ _ _ hx fbx) as [_ [bx [rx [-> ex]]]].
destruct (quotient_error _ _ (B2R q) _ _ _ _ _ ex ey hd) as [ny le].
split; [exact fq|]; exists (rx / ry); unfold over_exact; destruct (Req_EM_T ry 0); [easy|split; [easy|]].
apply Rle_trans with (1 := le), key.
assert (he := eta_pos prec emax); set (r := Rabs (- B2R q * B2R (value y) + B2R (value x))) in *.
assert (ha : above 3 r (B2R local)).
  assert (hq := lost_ge0 prec emax format_wide q fq).
  assert (hv := lost_ge0 prec emax format_wide (value x) fx).
  destruct (lost_value prec emax format_wide q fq) as [_ [e|[e big]]].
    apply (above_weaken prec emax digits 3 3 (r - 2 * eta + 0 + 32 * eta)); [lra|lra|].
    replace 3 with (1 + 1 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fl| |].
      apply (sum_above prec emax format_wide); [lra|exact fl1|unfold r; rewrite <- B2R_Bopp; now apply residual|].
      apply (above_weaken prec emax digits 0 _ (B2R (lost (value x)))); [lra|lra|now apply above_self].
    apply (above_weaken prec emax digits 0 _ (B2R (lost q))); [lra|lra|now apply above_self].
  apply (above_weaken prec emax digits 3 3 (r + 0)); [lra|lra|].
  replace 3 with (2 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fl| |].
    unfold r; rewrite <- B2R_Bopp; apply (residual_above prec emax format_wide); [exact fx|exact fl1|].
    intros ha; now apply quotient_survives.
  apply (above_weaken prec emax digits 0 _ (B2R (lost q))); [lra|lra|now apply above_self].
unfold rest in fr |- *; destruct (_ || _)%bool eqn:nz.
  destruct (finite_plus fr) as [_ fe]; destruct (finite_plus fe) as [fe1 _]; destruct (finite_plus fe1) as [fe2 _].
  replace 4 with (3 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fr|exact ha|].
  apply (above_weaken prec emax digits 3 _ (Rabs (B2R q) * B2R (bound y) - 2 * eta + B2R (bound x) + 32 * eta)); [lra|lra|].
  replace 3 with (1 + 1 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fe| |].
    apply (sum_above prec emax format_wide); [lra|exact fe1| |].
      rewrite <- B2R_Babs; apply (product_above prec emax format_wide); [exact fe2|apply abs_ge0|exact by'].
    apply (above_weaken prec emax digits 0 _ (B2R (bound x))); [lra|lra|now apply above_self].
  destruct (underflow_value prec emax format_wide) as [_ eu]; apply (above_weaken prec emax digits 0 _ (32 * eta)); [lra|lra|].
  rewrite eu; apply above_self; lra.
destruct (no_extra _ _ _ _ fbx fby nz) as [zx zy]; unfold t; fold r; rewrite zx, zy.
apply (above_weaken prec emax digits 3 _ r); [lra|lra|exact ha].
Qed.

Lemma root_error (a r ea x : R) : Rabs (a - x) <= ea -> ea < a -> 0 < r -> 0 <= x /\ Rabs (r - sqrt x) <= (Rabs (r * r + - a) + ea) / r.
Proof.
intros hx ha hr; assert (c := Rabs_le_inv _ _ hx); assert (x0 : 0 <= x) by lra; split; [exact x0|].
assert (s0 := sqrt_pos x); assert (ss := sqrt_sqrt x x0); set (s := sqrt x) in *.
replace (r - s) with ((r * r - x) / (r + s)) by (rewrite <- ss; field; lra).
unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq (r + s)) by lra.
apply Rmult_le_compat; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat; lra| |apply Rinv_le_contravar; lra].
replace (r * r - x) with (r * r + - a + (a - x)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

Lemma root_round a : is_finite (Bsqrt mode_NE a) = true -> B2R (Bsqrt mode_NE a) = rnd (sqrt (B2R a)).
Proof. intros _; apply (Bsqrt_correct prec emax _ _ mode_NE a). Qed.

Lemma root_large (s : R) : 0 < s -> s <= sqrt s \/ 1 <= sqrt s.
Proof.
intros hs; destruct (Rle_lt_dec 1 s) as [h|h]; [right|left].
  rewrite <- sqrt_1; now apply sqrt_le_1_alt.
rewrite <- (sqrt_square s) at 1 by lra; apply sqrt_le_1_alt; nra.
Qed.

Lemma root_positive a : is_finite a = true -> 0 < B2R a -> is_finite (Bsqrt mode_NE a) = true /\ 0 < B2R (Bsqrt mode_NE a).
Proof.
intros f pos; destruct (positive_number _ _ a f pos) as [m [e [h ea]]].
destruct (Bsqrt_correct prec emax _ _ mode_NE a) as [v [fin _]]; rewrite fin, v; split; [now rewrite ea|].
change (0 < rnd (sqrt (B2R a))).
assert (least : bpow radix2 emin <= B2R a).
  destruct (multiple_format prec emax _ (number_format _ _ a)) as [k ek]; rewrite ek in pos |- *.
  assert (p := bpow_gt_0 radix2 emin); assert (k0 : 0 < IZR k) by (apply (Rmult_lt_reg_r _ _ _ p); lra).
  apply lt_IZR in k0; assert (1 <= IZR k) by (apply IZR_le; lia).
  rewrite <- (Rmult_1_l (bpow _ _)) at 1; apply Rmult_le_compat_r; lra.
apply Rlt_le_trans with (bpow radix2 emin); [apply bpow_gt_0|].
apply round_ge_generic; [exact _|exact _|apply generic_format_bpow; unfold FLT_exp; lia|].
destruct (root_large _ pos) as [le|le]; [lra|apply Rle_trans with (2 := le); apply (bpow_le radix2 _ 0); lia].
Qed.

Lemma root_survives a : 0 < B2R a -> is_finite (Bsqrt mode_NE a) = true -> bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R a) ->
  bpow radix2 (emin + 2 * prec) <= Rabs (B2R (Bsqrt mode_NE a) * B2R (Bsqrt mode_NE a)).
Proof.
intros pos f big; rewrite Rabs_pos_eq in big by lra; rewrite (root_round a f).
assert (normal : small <= rnd (sqrt (B2R a))).
  apply round_ge_generic; [exact _|exact _|apply generic_format_bpow; unfold FLT_exp; lia|].
  destruct (root_large _ pos) as [le|le]; apply Rle_trans with (2 := le).
    apply Rle_trans with (2 := big), bpow_le; lia.
  apply (bpow_le radix2 _ 0); lia.
assert (c := rounded_normal prec emax (sqrt (B2R a))); assert (h0 := small_pos prec emax).
rewrite (Rabs_pos_eq (rnd _)) in c by lra.
replace (2 - emax)%Z with (emin + prec - 1)%Z in c by ring; specialize (c normal); apply Rabs_le_inv in c.
assert (ss := sqrt_sqrt (B2R a) (Rlt_le _ _ pos)); assert (s0 := sqrt_pos (B2R a)).
set (s := sqrt (B2R a)) in *; set (r := rnd s) in *; assert (hu := unit_pos prec); assert (hu' := unit_small prec digits).
assert (le : s <= 33 / 32 * r) by nra.
assert (sq : s * s <= 33 / 32 * r * (33 / 32 * r)) by (apply Rmult_le_compat; lra).
assert (two : 2 * bpow radix2 (emin + 2 * prec) <= bpow radix2 (emin + 2 * prec + 8)).
  change 2 with (bpow radix2 1); rewrite <- bpow_plus; apply bpow_le; lia.
rewrite Rabs_pos_eq; nra.
Qed.

(** rounding.binary.running root: likewise the computed square root; that its bound is finite says as well that the exact operand is not negative.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_root x X : tracks x X -> tracks (root_running prec emax x) (root_exact X).
Proof.
intros hx; unfold root_running; set (r := Bsqrt mode_NE (value x)).
destruct (exactly_zero x) eqn:z.
  destruct (exactly_zero_known _ _ _ _ hx z) as [-> [fx [vx [_ _]]]].
  destruct (Bsqrt_correct prec emax _ _ mode_NE (value x)) as [v [fin _]]; fold r in v, fin.
  unfold tracks; simpl; split.
    rewrite fin; revert vx fx; destruct (value x) as [s|s| |s m e h]; simpl; try easy.
    intros e0; apply eq_0_F2R in e0; now destruct s.
  exists (sqrt 0); destruct (Rlt_dec 0 0) as [l|_]; [now apply Rlt_irrefl in l|split; [easy|]].
  rewrite v, vx, sqrt_0, round_0, Rminus_0_r, Rabs_R0; [lra|exact _].
clear z; destruct (Bltb (bound x) (value x)) eqn:pos; cbn [negb]; [|easy].
set (local := bplus (Babs _) _); set (rest := bplus local _).
assert (fbx : is_finite (bound x) = true).
  destruct (is_finite (bound x)) eqn:f; [easy|]; rewrite (not_finite _ _ _ _ hx f) in pos; now destruct (value x) as [s|[|]| |].
destruct (known _ _ _ _ hx fbx) as [fx [bx [rx [-> ex]]]].
rewrite Bltb_correct in pos by easy; revert pos; case Rlt_bool_spec; [intros pos _|easy].
destruct (root_positive (value x) fx) as [fr r0]; [lra|fold r in fr, r0].
set (t := Rabs (B2R r * B2R r + - B2R (value x)) + B2R (bound x)).
assert (ob := over_bound 3 t rest r ltac:(lra) fr r0); cbv zeta in ob.
match goal with |- context [Running _ ?c] => set (bd := c) in *; unfold tracks; cbn [bound value]; destruct (is_finite bd); [|now apply ob] end.
destruct (proj2 ob eq_refl) as [frest key]; clear ob; destruct (finite_plus frest) as [fl _].
destruct (root_error _ (B2R r) _ _ ex pos r0) as [rx0 le].
split; [exact fr|]; exists (sqrt rx); unfold root_exact; destruct (Rlt_dec rx 0); [lra|split; [easy|]].
apply Rle_trans with (1 := le), key; unfold t; replace 3 with (2 + 1) by ring.
apply (sum_above prec emax format_wide); [lra|exact frest| |].
  rewrite <- B2R_Bopp; apply (residual_above prec emax format_wide); [exact fx|exact fl|].
  apply root_survives; [lra|exact fr].
apply (above_weaken prec emax digits 0 _ (B2R (bound x))); [lra|lra|now apply above_self].
Qed.
End Quotients.
