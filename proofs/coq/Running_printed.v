(* Running error analysis of (13) solved as it stands: the doubles of the library and the exact row. *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Rounding_printed Binary Rounding_binary Rounding_binary64.
From Torse Require Import Running Running_numbers Running_operations Running_quotient Running_programs Running_net.

Section Related.
Variables (S T : Type) (A : arithmetic S) (B : arithmetic T) (R : S -> T -> Prop).
Hypothesis kept : respects A B R.
Local Notation pairs x y := (R x.1 y.1 /\ R x.2 y.2).

Lemma keep_printed before behind passed divisor p q d before' behind' passed' divisor' p' q' d' N :
  (forall j, pairs (before j) (before' j)) -> (forall j, pairs (behind j) (behind' j)) -> (forall j, pairs (passed j) (passed' j)) ->
  (forall j, pairs (divisor j) (divisor' j)) -> (forall j, R (p j) (p' j)) -> (forall j, R (q j) (q' j)) -> R d d' ->
  R (printed A before behind passed divisor p q d N) (printed B before' behind' passed' divisor' p' q' d' N).
Proof.
move=> hb hh hs ho hp hq hd; elim: N => [//|N ih] /=; rewrite /printed_next /apart.
have [[b1 b2] [h1 h2]] := (hb N, hh N); have [[s1 s2] [o1 o2]] := (hs N, ho N).
apply: keep_over => //; last exact: keep_minus.
by apply: keep_plus => //; [apply: keep_plus => //|]; apply: keep_times => //; exact: keep_minus.
Qed.

Lemma keep_printed_from u n L M c d u' L' M' c' d' K J : (forall i, R (u i) (u' i)) -> R L L' -> R M M' -> (forall i, R (c i) (c' i)) -> R d d' ->
  R (printed_from A u n L M c d K J) (printed_from B u' n L' M' c' d' K J).
Proof. by move=> *; rewrite /printed_from /printed_up /printed_down; case: ifP => _; apply: keep_printed => // j; split=> /=. Qed.
End Related.

Lemma printed_divisors before behind passed divisor p q d N r : printed exacts before behind passed divisor p q d N = Some r ->
  forall j, (j < N)%N -> exists2 s : R, minus exacts (divisor j).1 (divisor j).2 = Some s & s <> 0%Re.
Proof.
elim: N r => // N ih r /over_exist[[s /both_exist[_ [t /both_exist[_ [w ew]]]]] here] j.
by rewrite ltnS leq_eqVlt => /orP[/eqP -> //|]; exact: ih ew _.
Qed.

Section Net.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation runnings := (runnings prec emax).
Local Notation machine := (machine prec emax).
Local Notation given := (of_number prec emax).
Hypothesis format_wide : wide prec emax.

Variables (m : nat) (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat).
Hypothesis start : d K = \row_k rational (dK k).
Local Notation v := (fun i => rational (u i)).

Lemma running_printed k (r := printed_from runnings (fun i => given (u i)) n (given L) (given M) (fun i => given (c i k)) (given (dK k)) K J) :
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  is_finite (bound r) = true -> `|rational (printed_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= rational (bound r).
Proof.
move=> cells; pose X := printed_from exacts (fun i => Some (B2R (u i))) n (Some (B2R L)) (Some (B2R M)) (fun i => Some (B2R (c i k))) (Some (B2R (dK k))) K J.
apply: (running_close (X := X)).
- by rewrite /r /X; apply: (keep_printed_from (tracks_related format_wide)) => *; exact: number_tracks.
- by rewrite /r; apply: (keep_printed_from (@values_related prec emax _ _)).
move=> s eX; have after i : (K <= i < J)%N -> rational M - v i != 0.
  move=> range; have lt : (i - K < J - K)%N by lia.
  have le : (K <= J)%N by lia.
  apply: off_exact; move: eX; rewrite /X /printed_from le /printed_up => /printed_divisors/(_ _ lt).
  by rewrite /= subnK //; case/andP: range.
have before i : (J <= i < K)%N -> rational M - v (i + n)%N != 0.
  move=> range; have lt : (K - i.+1 < K - J)%N by lia.
  have le : (K <= J)%N = false by lia.
  rewrite subr_eq0 eq_sym -subr_eq0; apply: off_exact; move: eX; rewrite /X /printed_from le /printed_down => /printed_divisors/(_ _ lt).
  by rewrite /= (_ : K - (K - i.+1).+1 = i)%N //; lia.
rewrite -(rounding_printed_exact (c := fun i k => rational (c i k)) k after before cells) start mxE.
by apply: (keep_printed_from agrees_related) eX => *; exact: given_agrees.
Qed.
End Net.

Section Doubles.
Local Notation runnings := (runnings 53 1024).
Local Notation given := (of_number 53 1024).
Variables (m : nat) (u : nat -> double) (n : nat) (L M : double) (c : nat -> 'I_m -> double) (dK : 'I_m -> double) (d : nat -> 'rV[rat]_m) (K J : nat).
Hypothesis start : d K = \row_k rational (dK k).

(** rounding.binary64.running printed: the bound that running error analysis gives of the vertex $J$, which the library computes in doubles from the vertex $K$, before
    or after it, with (13) solved as it stands, bounds in each coordinate the distance of the computed vertex from the exact one, $d$ being the exact row (13).
    Hypotheses: the bound is finite. That nothing overflows and $M^{*}$ is none of the knots follows; what underflows is in the bound. *)
Theorem rounding_binary64_running_printed k (r := printed_from runnings (fun i => given (u i)) n (given L) (given M) (fun i => given (c i k)) (given (dK k)) K J) :
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  is_finite (bound r) = true -> `|rational (printed_from doubles u n L M (c^~ k) (dK k) K J) - d J 0 k| <= rational (bound r).
Proof. by have [w _ _ _ _] := rounding_binary64_running_constants; exact: (running_printed w start). Qed.
End Doubles.
