(* Whole programs in running error analysis, and what they decide.
   Definitions:
     program              a tree of operations on numbers and integers
     run p, result p      its running result, and its exact one
     runnings, exacts     the four operations on running and on exact results *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core Operations BinarySingleNaN.
From Torse Require Import Binary Rounding Running Running_rounding Running_numbers Running_operations Running_quotient.

Section Programs.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation number := (number prec emax).
Local Notation running := (running prec emax).
Implicit Types (a b : number) (x y : running) (X Y : exact).

Inductive program :=
  | Number a | Integer (i : Z)
  | Sum (p q : program) | Difference (p q : program) | Opposite (p : program)
  | Product (p q : program) | Quotient (p q : program) | Root (p : program).

Fixpoint run (p : program) : running :=
  match p with
  | Number a => of_number prec emax a
  | Integer i => of_int prec emax i
  | Sum p q => plus_running prec emax (run p) (run q)
  | Difference p q => minus_running prec emax (run p) (run q)
  | Opposite p => opposite_running prec emax (run p)
  | Product p q => times_running prec emax (run p) (run q)
  | Quotient p q => over_running prec emax (run p) (run q)
  | Root p => root_running prec emax (run p)
  end.

Fixpoint result (p : program) : exact :=
  match p with
  | Number a => Some (B2R a)
  | Integer i => Some (IZR i)
  | Sum p q => both Rplus (result p) (result q)
  | Difference p q => both Rminus (result p) (result q)
  | Opposite p => opposite_exact (result p)
  | Product p q => both Rmult (result p) (result q)
  | Quotient p q => over_exact (result p) (result q)
  | Root p => root_exact (result p)
  end.

Definition runnings : arithmetic running :=
  Arithmetic (plus_running prec emax) (minus_running prec emax) (times_running prec emax) (over_running prec emax).
Definition exacts : arithmetic exact := Arithmetic (both Rplus) (both Rminus) (both Rmult) over_exact.

Hypothesis format_wide : wide prec emax.
Local Open Scope R_scope.
Local Notation emin := (3 - emax - prec)%Z.
Local Notation rnd := (round radix2 (FLT_exp emin prec) ZnearestE).
Local Notation u := (bpow radix2 (- prec)).
Local Notation small := (bpow radix2 (emin + prec - 1)).
Local Notation is_zero := (is_zero prec emax).
Local Notation is_less := (is_less prec emax).
Let digits : (5 <= prec)%Z. Proof. exact (proj1 format_wide). Qed.
Let range : (prec + 8 <= emax)%Z. Proof. exact (proj2 format_wide). Qed.

Lemma number_tracks a : tracks (of_number prec emax a) (Some (B2R a)).
Proof.
unfold tracks, of_number; simpl; destruct (is_finite a) eqn:f; simpl; [split; [easy|]|easy].
exists (B2R a); split; [easy|]; rewrite Rminus_eq_0, Rabs_R0; lra.
Qed.

Lemma integer_value (i : Z) : F2R (Float radix2 i 0) = IZR i. Proof. unfold F2R; simpl; ring. Qed.

Lemma small_le1 : small <= 1. Proof. apply (bpow_le radix2 _ 0); lia. Qed.

(* Integers below 2^prec are numbers, and rounding takes no greater one below it. *)
Lemma rounded_integer (i : Z) : let v := rnd (IZR i) in
  (Rabs v < bpow radix2 prec -> v = IZR i) /\ (bpow radix2 prec <= Rabs v -> Rabs (v - IZR i) <= u * Rabs v).
Proof.
intros v; split; intros h.
  apply round_generic; [exact _|]; rewrite <- integer_value; apply format_float; [lia|].
  apply Z.lt_nge; intros le; apply (Rlt_not_le _ _ h); apply abs_round_ge_generic; [exact _|exact _| |].
    apply generic_format_bpow; unfold FLT_exp; lia.
  rewrite <- abs_IZR; change (2 ^ prec)%Z with (radix2 ^ prec)%Z in le; rewrite <- IZR_Zpower by lia; now apply IZR_le.
apply (rounded_normal prec emax (IZR i)); replace (2 - emax)%Z with (emin + prec - 1)%Z by ring; fold v.
apply Rle_trans with (2 := h), bpow_le; lia.
Qed.

Lemma integer_tracks (i : Z) : tracks (of_int prec emax i) (Some (IZR i)).
Proof.
unfold tracks, of_int; set (v := binary prec emax i 0); cbn [bound value].
destruct (power_value prec emax format_wide prec) as [fm vm]; [lia|]; fold (most prec emax) in fm, vm.
destruct (power_value prec emax format_wide (1 - prec)) as [fu vu]; [lia|]; fold (ulps prec emax) in fu, vu.
assert (c := binary_normalize_correct prec emax _ _ mode_NE i 0 false); cbv zeta in c; rewrite integer_value in c.
fold (binary prec emax i 0) in c; fold v in c; change (round radix2 _ _ _) with (rnd (IZR i)) in c.
destruct (Rlt_bool _ _) in c.
  destruct c as [ev [fv _]]; rewrite Bleb_correct by (try rewrite is_finite_Babs; assumption); rewrite vm, B2R_Babs.
  destruct (rounded_integer i) as [small_int large_int]; rewrite <- ev in small_int, large_int.
  case Rle_bool_spec; intros h; [|simpl; split; [exact fv|]; exists (IZR i); split; [easy|]].
    2: rewrite small_int by exact h; rewrite Rminus_eq_0, Rabs_R0; lra.
  assert (hu := unit_pos prec); assert (hu' := unit_small prec digits); set (s := Rabs (B2R v)) in *.
  assert (twice : bpow radix2 (1 - prec) = 2 * u) by (unfold Z.sub; now rewrite bpow_plus).
  assert (s0 : 0 < s) by (apply Rlt_le_trans with (2 := h), bpow_gt_0).
  assert (p := Bmult_correct prec emax _ _ mode_NE (Babs v) (ulps prec emax)); fold (btimes (Babs v) (ulps prec emax)) in p.
  rewrite B2R_Babs, vu in p; fold s in p; change (round radix2 _ _ _) with (rnd (s * bpow radix2 (1 - prec))) in p.
  rewrite twice in p; rewrite Rlt_bool_true in p; [destruct p as [vb [fb _]]|].
    rewrite fb, is_finite_Babs, fv, fu; cbn [andb]; split; [easy|]; exists (IZR i); split; [easy|].
    apply Rle_trans with (1 := large_int h); rewrite vb.
    assert (n : small <= rnd (s * (2 * u))).
      apply round_ge_generic; [exact _|exact _|apply generic_format_bpow; unfold FLT_exp; lia|].
      apply Rle_trans with (1 := small_le1); rewrite <- twice; apply Rle_trans with (bpow radix2 prec * bpow radix2 (1 - prec)).
        rewrite <- bpow_plus; apply (bpow_le radix2 0); lia.
      apply Rmult_le_compat_r; [apply bpow_ge_0|exact h].
    assert (gain : 0 <= u * s * (1 - 2 * u)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
    apply Rle_trans with ((1 - u) * (s * (2 * u))); [lra|apply above_normal; [exact _|exact digits|apply Rmult_le_pos; lra|exact n]].
  apply Rle_lt_trans with (2 := abs_B2R_lt_emax _ _ v); fold s; rewrite <- (Rabs_pos_eq s) at 2 by lra.
  apply abs_round_le_generic; [exact _|exact _|unfold s; rewrite Rabs_Rabsolu, <- B2R_Babs; apply number_format|].
  rewrite Rabs_mult, (Rabs_pos_eq (2 * u)) by lra; rewrite <- (Rmult_1_r (Rabs s)) at 2; apply Rmult_le_compat_l; [apply Rabs_pos|lra].
destruct (positive_number prec emax _ fu) as [m [e [hh eu]]]; [rewrite vu; apply bpow_gt_0|].
destruct (positive_number prec emax _ fm) as [m' [e' [hh' em]]]; [rewrite vm; apply bpow_gt_0|].
destruct v as [s|s| |s mv ev hv]; simpl in c; try easy; rewrite eu, em; reflexivity.
Qed.

(** rounding.binary.running program: a tree of operations on numbers and integers: where the bound of its running result is finite, its exact result exists,
    that is, no divisor is zero and no root is of a negative number, and the value is within the bound of it.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_program (p : program) : is_finite (bound (run p)) = true ->
  is_finite (value (run p)) = true /\ exists r, result p = Some r /\ Rabs (B2R (value (run p)) - r) <= B2R (bound (run p)).
Proof.
assert (h : tracks (run p) (result p)).
  induction p as [a|i|p hp q hq|p hp q hq|p hp|p hp q hq|p hp q hq|p hp]; simpl.
  - apply number_tracks.
  - apply integer_tracks.
  - exact (proj1 (rounding_binary_running_sum prec emax format_wide _ _ _ _ hp hq)).
  - exact (proj1 (proj2 (rounding_binary_running_sum prec emax format_wide _ _ _ _ hp hq))).
  - now apply opposite_tracks.
  - now apply rounding_binary_running_product.
  - now apply rounding_binary_running_quotient.
  - now apply rounding_binary_running_root.
intros f; unfold tracks in h; now rewrite f in h.
Qed.

Lemma zero_decided x X : tracks x X ->
  (is_zero x = yes -> X = Some 0) /\
  (is_zero x = no -> exists r, X = Some r /\ r <> 0 /\ (Bltb zero (value x) = true <-> 0 < r)).
Proof.
intros hx; unfold Running.is_zero; destruct (is_finite (bound x)) eqn:fb.
  destruct (known _ _ _ _ hx fb) as [fv [b0 [r [-> le]]]]; apply Rabs_le_inv in le.
  rewrite Bltb_correct by (try rewrite is_finite_Babs; assumption); rewrite Beqb_correct by easy.
  rewrite Bltb_correct by easy; rewrite B2R_Babs; change (B2R zero) with 0.
  case Rlt_bool_spec; intros h; split; try easy.
  - intros _; exists r; split; [easy|]; revert h; unfold Rabs; destruct Rcase_abs as [n|n]; intros h.
      split; [lra|]; case Rlt_bool_spec; intros s; split; try easy; lra.
    split; [lra|]; case Rlt_bool_spec; intros s; split; try easy; lra.
  - case Req_bool_spec; intros e; [intros _|easy]; f_equal; rewrite e in *.
    assert (p := Rabs_pos (B2R (value x))); assert (z : Rabs (B2R (value x)) = 0) by lra.
    apply Rabs_eq_R0 in z; lra.
  - now case Req_bool.
rewrite (not_finite _ _ _ _ hx fb); now destruct (value x) as [s|[|]| |].
Qed.

(** rounding.binary.running decisions: an exact result that is said to be zero is zero, one that is said not to be is not; of two exact results of which one is said to
    be less than the other it is, and of which it is said not to be, is not. Where such an answer is given the exact results exist.
    Hypotheses: numbers of five digits or more, with exponents up to eight more than that. *)
Theorem rounding_binary_running_decisions x y X Y : tracks x X -> tracks y Y ->
  (is_zero x = yes -> X = Some 0) /\ (is_zero x = no -> exists r, X = Some r /\ r <> 0) /\
  (is_less x y = yes -> exists r s, X = Some r /\ Y = Some s /\ r < s) /\
  (is_less x y = no -> exists r s, X = Some r /\ Y = Some s /\ s <= r).
Proof.
intros hx hy; destruct (zero_decided x X hx) as [z n]; split; [exact z|split].
  intros h; destruct (n h) as [r [e [nz _]]]; now exists r.
destruct (rounding_binary_running_sum prec emax format_wide _ _ _ _ hy hx) as [_ [hd _]].
destruct (zero_decided _ _ hd) as [zd nd]; unfold Running.is_less; revert zd nd; clear z n.
destruct (is_zero (minus_running prec emax y x)); intros zd nd.
- split; [easy|intros _]; specialize (zd eq_refl); destruct X as [r|], Y as [s|]; try easy; injection zd as e.
  exists r, s; split; [easy|split; [easy|lra]].
- destruct (nd eq_refl) as [d [e [nz s]]]; destruct X as [p|], Y as [q|]; try easy; injection e as e.
  destruct (Bltb zero _); split; try easy; intros _; exists p, q; split; try easy; split; try easy.
    assert (0 < d) by now apply s.
    lra.
  apply Rnot_lt_le; intros lt; assert (false = true) by (apply s; lra); easy.
- easy.
Qed.
End Programs.
