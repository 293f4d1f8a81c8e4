(* Every operation of running error analysis keeps its invariant: where the bound is finite the exact result exists and is within it. *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core BinarySingleNaN Plus_error Pff2Flocq.
From Torse Require Import Binary Running Running_rounding Running_numbers.

Section Operations.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Hypothesis format_wide : wide prec emax.
Local Notation number := (number prec emax).
Local Notation running := (running prec emax).
Implicit Types (a b : number) (x y : running) (X Y : exact).
Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation format := (generic_format radix2 (FLT_exp emin prec)).
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Local Notation u := (bpow radix2 (- prec)).
Local Notation small := (bpow radix2 (emin + prec - 1)).
Local Notation eta := (bpow radix2 (emin - 1)).
Local Notation above := (above prec emax).
Local Notation plus_running := (plus_running prec emax).
Local Notation opposite_running := (opposite_running prec emax).
Local Notation minus_running := (minus_running prec emax).
Local Notation times_running := (times_running prec emax).
Local Notation lost := (lost prec emax).
Local Notation rounded_up := (rounded_up prec emax).
Let digits : (5 <= prec)%Z. Proof. exact (proj1 format_wide). Qed.
Let range : (prec + 8 <= emax)%Z. Proof. exact (proj2 format_wide). Qed.

Lemma known x X : tracks x X -> is_finite (bound x) = true ->
  is_finite (value x) = true /\ 0 <= B2R (bound x) /\ exists r, X = Some r /\ Rabs (B2R (value x) - r) <= B2R (bound x).
Proof.
unfold tracks; intros h f; rewrite f in h; destruct h as [fv [r [e le]]]; split; [exact fv|split].
  apply Rle_trans with (2 := le), Rabs_pos.
now exists r.
Qed.

Lemma not_finite x X : tracks x X -> is_finite (bound x) = false -> bound x = unknown.
Proof. unfold tracks; intros h f; now rewrite f in h. Qed.

Lemma tracks_rounded a b X : (is_finite (rounded_up b) = true -> is_finite b = true ->
    is_finite a = true /\ exists r, X = Some r /\ Rabs (B2R a - r) <= B2R (rounded_up b)) ->
  tracks (Running a (rounded_up b)) X.
Proof.
intros h; unfold tracks; simpl; assert (c := rounded_up_value prec emax format_wide b).
destruct (is_finite (rounded_up b)); [apply h; easy|exact c].
Qed.

Lemma two_sum (x y : R) : format x -> format y -> let s := rnd (x + y) in let p := rnd (s - x) in
  rnd (rnd (x - rnd (s - p)) + rnd (y - p)) = x + y - s.
Proof.
intros fx fy s p; assert (c := TwoSum_correct emin prec (fun z : Z => negb (Z.even z)) ltac:(lia) ltac:(lia)).
assert (sym : forall z : Z, negb (Z.even z) = negb (negb (Z.even (- (z + 1))))).
  intros z; rewrite Z.even_opp, Z.even_add; now destruct (Z.even z).
specialize (c sym x y fx fy); fold s in c; fold p in c; lra.
Qed.

Lemma plus_tracks x y X Y : tracks x X -> tracks y Y -> tracks (plus_running x y) (both Rplus X Y).
Proof.
intros hx hy; unfold Running.plus_running.
set (sum := bplus _ _); set (part := bminus sum _); set (local := bplus (bminus _ _) _).
apply tracks_rounded; intros fb fc; destruct (finite_plus fc) as [fc1 fy]; destruct (finite_plus fc1) as [fl fx].
destruct (known _ _ hx fx) as [vx [bx [rx [-> ex]]]]; destruct (known _ _ hy fy) as [vy [by' [ry [-> ey]]]].
rewrite is_finite_Babs in fl; destruct (finite_plus fl) as [fl1 fl2].
destruct (finite_minus fl1) as [_ fl3]; destruct (finite_minus fl3) as [fsum _]; destruct (finite_minus fl2) as [_ fpart].
assert (local_value : B2R local = B2R (value x) + B2R (value y) - B2R sum).
  assert (e1 := plus_round _ _ _ _ fl); assert (e2 := minus_round _ _ _ _ fl1); assert (e3 := minus_round _ _ _ _ fl3).
  assert (e4 := minus_round _ _ _ _ fl2); assert (e5 := minus_round _ _ _ _ fpart); assert (e6 := plus_round _ _ _ _ fsum).
  fold part in e2, e3, e4, e5; fold sum in e3, e5, e6; fold local in e1; rewrite e1, e2, e3, e4, e5, e6.
  apply two_sum; apply number_format.
split; [exact fsum|]; exists (rx + ry); split; [easy|].
apply Rle_trans with (Rabs (B2R local) + B2R (bound x) + B2R (bound y)).
  rewrite local_value; apply Rabs_le; unfold Rabs in *; repeat destruct Rcase_abs in *; lra.
apply (bound_above prec emax format_wide 2); [lra|exact fb|].
replace 2 with (0 + 1 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fc| |].
  apply (sum_above prec emax format_wide); [lra|exact fc1| |]; [rewrite B2R_Babs; apply above_self, Rabs_pos|now apply above_self].
assert (0 <= u) by apply bpow_ge_0.
apply (above_weaken prec emax digits 0 _ (B2R (bound y))); [lra|lra|now apply above_self].
Qed.

Lemma opposite_tracks x X : tracks x X -> tracks (opposite_running x) (opposite_exact X).
Proof.
unfold tracks; simpl; destruct is_finite; [|easy]; intros [f [r [-> le]]]; rewrite is_finite_Bopp, B2R_Bopp.
split; [exact f|]; exists (- r); split; [easy|]; rewrite <- Rabs_Ropp; now replace (- (- B2R (value x) - - r)) with (B2R (value x) - r) by ring.
Qed.

(** rounding.binary.running sum: where the bounds of two results are finite the exact ones exist and lie within them; then so it is with the computed sum, difference and
    opposite, whose bounds are finite, or infinite and no NaN.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_sum x y X Y : tracks x X -> tracks y Y ->
  tracks (plus_running x y) (both Rplus X Y) /\ tracks (minus_running x y) (both Rminus X Y) /\ tracks (opposite_running x) (opposite_exact X).
Proof.
intros hx hy; split; [now apply plus_tracks|split; [|now apply opposite_tracks]].
assert (h := plus_tracks _ _ _ _ hx (opposite_tracks _ _ hy)).
unfold Running.minus_running; replace (both Rminus X Y) with (both Rplus X (opposite_exact Y)); [exact h|].
now destruct X, Y.
Qed.

Lemma is_zero_number a : Beqb a zero = true -> is_finite a = true /\ B2R a = 0.
Proof.
destruct (is_finite a) eqn:f; [|now destruct a as [|[|]| |]].
rewrite Beqb_correct by easy; simpl; case Req_bool_spec; easy.
Qed.

Lemma exactly_zero_known x X : tracks x X -> exactly_zero prec emax x = true ->
  X = Some 0 /\ is_finite (value x) = true /\ B2R (value x) = 0 /\ is_finite (bound x) = true /\ B2R (bound x) = 0.
Proof.
unfold exactly_zero; intros h z; apply andb_prop in z; destruct z as [zv zb].
destruct (is_zero_number _ zv) as [fv ev], (is_zero_number _ zb) as [fb eb].
destruct (known _ _ h fb) as [_ [_ [r [-> le]]]]; rewrite ev, eb in le.
split; [|easy]; f_equal; assert (c := Rabs_pos (0 - r)); assert (c' := Rabs_le_inv _ _ le); lra.
Qed.

Lemma no_extra a b : is_finite a = true -> is_finite b = true ->
  (inexact prec emax a || inexact prec emax b)%bool = false -> B2R a = 0 /\ B2R b = 0.
Proof.
intros fa fb h; apply Bool.orb_false_iff in h; destruct h as [ha hb]; unfold inexact in ha, hb.
apply Bool.negb_false_iff in ha; apply Bool.negb_false_iff in hb; now split; apply is_zero_number.
Qed.
Lemma abs_ge0 a : 0 <= B2R (Babs a). Proof. rewrite B2R_Babs; apply Rabs_pos. Qed.

Lemma lost_ge0 a : is_finite a = true -> 0 <= B2R (lost a).
Proof. intros f; assert (h := eta_pos prec emax); destruct (lost_value prec emax format_wide a f) as [_ [->|[-> _]]]; lra. Qed.

(* The size of a residual xy + z as computed, with what may be lost of it for the size of p. *)
Lemma residual_above (x y z p : number) : is_finite p = true -> let c := bplus (Babs (Bfma mode_NE x y z)) (lost p) in is_finite c = true ->
  (bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R p) -> bpow radix2 (emin + 2 * prec) <= Rabs (B2R x * B2R y)) ->
  above 2 (Rabs (B2R x * B2R y + B2R z)) (B2R c).
Proof.
intros fp c fc big; destruct (finite_plus fc) as [fl _]; rewrite is_finite_Babs in fl.
assert (h := eta_pos prec emax); assert (hl := lost_ge0 p fp).
destruct (lost_value prec emax format_wide p fp) as [_ [e|[e h']]].
  apply (above_weaken prec emax digits 2 2 (Rabs (B2R x * B2R y + B2R z) - 2 * eta + 32 * eta)); [lra|lra|].
  replace 2 with (1 + 1) at 1 by ring; apply (sum_above prec emax format_wide); [lra|exact fc|now apply residual|].
  apply (above_weaken prec emax digits 0 _ (B2R (lost p))); [lra|lra|now apply above_self].
apply (above_weaken prec emax digits 2 2 (Rabs (B2R x * B2R y + B2R z) + 0)); [lra|lra|].
replace 2 with (1 + 1) at 1 by ring; apply (sum_above prec emax format_wide); [lra|exact fc| |].
  apply (exact_residual prec emax format_wide); [exact fl|now apply big].
apply (above_weaken prec emax digits 0 _ (B2R (lost p))); [lra|lra|now apply above_self].
Qed.

Lemma finite_opp a : is_finite (Bopp a) = is_finite a. Proof. apply is_finite_Bopp. Qed.

Lemma product_survives a b : is_finite (btimes a b) = true -> bpow radix2 (emin + 2 * prec + 8) <= Rabs (B2R (btimes a b)) ->
  bpow radix2 (emin + 2 * prec) <= Rabs (B2R a * B2R b).
Proof.
intros f h; apply Rnot_lt_le; intros lt; rewrite (times_round f) in h.
assert (le : Rabs (rnd (B2R a * B2R b)) <= bpow radix2 (emin + 2 * prec)).
  apply abs_round_le_generic; [exact _|exact _| |lra]; apply generic_format_bpow; unfold FLT_exp; lia.
assert (lt' : bpow radix2 (emin + 2 * prec) < bpow radix2 (emin + 2 * prec + 8)) by (apply bpow_lt; lia).
lra.
Qed.

Lemma product_error (a b ex ey x y : R) : Rabs (a - x) <= ex -> Rabs (b - y) <= ey ->
  Rabs (a * b - x * y) <= Rabs a * ey + Rabs b * ex + ex * ey.
Proof.
intros hx hy; replace (a * b - x * y) with (a * (b - y) + b * (a - x) - (a - x) * (b - y)) by ring.
assert (h1 : Rabs (a * (b - y)) <= Rabs a * ey) by (rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|exact hy]).
assert (h2 : Rabs (b * (a - x)) <= Rabs b * ex) by (rewrite Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|exact hx]).
assert (h3 : Rabs ((a - x) * (b - y)) <= ex * ey) by (rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; assumption).
apply Rabs_le_inv in h1, h2, h3; apply Rabs_le; lra.
Qed.

(* Where one of two operands is exactly zero. *)
Lemma times_zero x y X Y : tracks x X -> tracks y Y -> (exactly_zero prec emax x || exactly_zero prec emax y)%bool = true ->
  tracks (Running (btimes (value x) (value y)) (if Bltb (bplus (bound x) (bound y)) unknown then zero else unknown)) (both Rmult X Y).
Proof.
intros hx hy z; unfold tracks; simpl; destruct (Bltb _ _) eqn:lt; [simpl|easy].
assert (fin : is_finite (bound x) = true /\ is_finite (bound y) = true).
{ destruct (is_finite (bound x)) eqn:fx, (is_finite (bound y)) eqn:fy; try easy; exfalso.
  - rewrite (not_finite _ _ hy fy) in lt; now destruct (bound x) as [s|s| |].
  - rewrite (not_finite _ _ hx fx) in lt; now destruct (bound y) as [s|s| |].
  - now rewrite (not_finite _ _ hx fx), (not_finite _ _ hy fy) in lt. }
destruct fin as [fx fy]; destruct (known _ _ hx fx) as [vx [_ [rx [ex _]]]]; destruct (known _ _ hy fy) as [vy [_ [ry [ey _]]]].
assert (product : B2R (value x) * B2R (value y) = 0 /\ rx * ry = 0).
  apply Bool.orb_true_iff in z; destruct z as [z|z].
    destruct (exactly_zero_known _ _ hx z) as [e [_ [v _]]]; rewrite ex in e; injection e as ->; rewrite v; split; ring.
  destruct (exactly_zero_known _ _ hy z) as [e [_ [v _]]]; rewrite ey in e; injection e as ->; rewrite v; split; ring.
destruct product as [pv pe]; assert (c := Bmult_correct prec emax _ _ mode_NE (value x) (value y)).
rewrite pv, round_0, Rabs_R0, Rlt_bool_true in c; [|apply bpow_gt_0|exact _].
destruct c as [v [f _]]; fold (btimes (value x) (value y)) in v, f; rewrite f, vx, vy, v, ex, ey; simpl.
split; [easy|]; exists (rx * ry); split; [easy|]; rewrite pe, Rminus_0_r, Rabs_R0; lra.
Qed.

(** rounding.binary.running product: likewise the computed product.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_product x y X Y : tracks x X -> tracks y Y -> tracks (times_running x y) (both Rmult X Y).
Proof.
intros hx hy; unfold Running.times_running.
destruct (exactly_zero _ _ _ || exactly_zero _ _ _)%bool eqn:z; [now apply times_zero|clear z].
set (product := btimes (value x) (value y)); set (local := bplus (Babs _) (lost _)).
apply tracks_rounded; intros fb fc.
assert (fl : is_finite local = true) by (destruct (inexact _ _ _ || inexact _ _ _)%bool; [apply (finite_plus fc)|exact fc]).
destruct (finite_plus fl) as [ff _]; rewrite is_finite_Babs in ff; destruct (finite_fma _ _ _ _ _ ff) as [fx [fy fp]].
rewrite finite_opp in fp; split; [exact fp|].
assert (ha := residual_above _ _ _ _ fp fl (product_survives _ _ fp)); fold local in ha; rewrite B2R_Bopp in ha.
assert (fin : is_finite (bound x) = true /\ is_finite (bound y) = true).
{ destruct (inexact _ _ (bound x)) eqn:nx; destruct (inexact _ _ (bound y)) eqn:ny; cbn [orb] in fc.
  1-3: destruct (finite_plus fc) as [_ fe]; destruct (finite_plus fe) as [fe1 _]; destruct (finite_plus fe1) as [_ fe2]; apply (finite_times fe2).
  unfold inexact in nx, ny; apply Bool.negb_false_iff in nx; apply Bool.negb_false_iff in ny; split; now apply is_zero_number. }
destruct fin as [fbx fby].
destruct (known _ _ hx fbx) as [_ [bx [rx [-> ex]]]]; destruct (known _ _ hy fby) as [_ [by' [ry [-> ey]]]].
exists (rx * ry); split; [easy|].
set (a := B2R (value x)) in *; set (b := B2R (value y)) in *; set (p := B2R product) in *.
set (t := Rabs (a * b + - p)) in *; set (dx := B2R (bound x)) in *; set (dy := B2R (bound y)) in *.
assert (h := eta_pos prec emax).
apply Rle_trans with (t + (Rabs a * dy + Rabs b * dx + dx * dy)).
  assert (e := product_error a b dx dy rx ry ex ey); unfold t; apply Rabs_le_inv in e.
  unfold Rabs at 1 2; repeat destruct Rcase_abs; lra.
apply (bound_above prec emax format_wide 5); [lra|exact fb|].
destruct (inexact _ _ _ || inexact _ _ _)%bool eqn:nz; cbn [orb] in fc |- *.
  destruct (finite_plus fc) as [_ fe]; destruct (finite_plus fe) as [fe1 _]; destruct (finite_plus fe1) as [fe2 fe3].
  destruct (finite_plus fe2) as [fe4 fe5].
  replace 5 with (4 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fc| |].
    apply (above_weaken prec emax digits 2 _ t); [lra|lra|exact ha].
  apply (above_weaken prec emax digits 4 _ (Rabs a * dy - 2 * eta + (Rabs b * dx - 2 * eta) + (dx * dy - 2 * eta) + 32 * eta)); [lra|lra|].
  replace 4 with (3 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fe| |].
    replace 3 with (2 + 1) by ring; apply (sum_above prec emax format_wide); [lra|exact fe1| |].
      replace 2 with (1 + 1) at 1 by ring; apply (sum_above prec emax format_wide); [lra|exact fe2| |].
        unfold a; rewrite <- B2R_Babs; apply (product_above prec emax format_wide); [exact fe4|apply abs_ge0|exact by'].
      unfold b; rewrite <- B2R_Babs; apply (product_above prec emax format_wide); [exact fe5|apply abs_ge0|exact bx].
    apply (above_weaken prec emax digits 1 _ (dx * dy - 2 * eta)); [lra|lra|]; now apply product_above.
  destruct (underflow_value prec emax format_wide) as [_ eu]; apply (above_weaken prec emax digits 0 _ (32 * eta)); [lra|lra|].
  rewrite eu; apply above_self; lra.
destruct (no_extra _ _ fbx fby nz) as [zx zy]; fold dx in zx; fold dy in zy; rewrite zx, zy.
apply (above_weaken prec emax digits 2 _ t); [lra|lra|exact ha].
Qed.
End Operations.
