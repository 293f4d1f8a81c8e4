(* Running error analysis of the construction of a net: the doubles of the library and the exact row.
   Definitions:
     respects R A B        R between two types is kept by their operations A and B
     given x              a number as an exact operand *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Binary Rounding_binary Rounding_binary64.
From Torse Require Import Running Running_numbers Running_operations Running_quotient Running_programs.

Section Related.
Variables (S T : Type) (A : arithmetic S) (B : arithmetic T) (R : S -> T -> Prop).
Definition respects := forall x y x' y', R x x' -> R y y' ->
  [/\ R (plus A x y) (plus B x' y'), R (minus A x y) (minus B x' y'), R (times A x y) (times B x' y') & R (over A x y) (over B x' y')].

Hypothesis kept : respects.
Lemma keep_plus x y x' y' : R x x' -> R y y' -> R (plus A x y) (plus B x' y'). Proof. by move=> hx /(kept hx) []. Qed.
Lemma keep_minus x y x' y' : R x x' -> R y y' -> R (minus A x y) (minus B x' y'). Proof. by move=> hx /(kept hx) []. Qed.
Lemma keep_times x y x' y' : R x x' -> R y y' -> R (times A x y) (times B x' y'). Proof. by move=> hx /(kept hx) []. Qed.
Lemma keep_over x y x' y' : R x x' -> R y y' -> R (over A x y) (over B x' y'). Proof. by move=> hx /(kept hx) []. Qed.

Lemma keep_ruling L M near far p d L' M' near' far' p' d' N : R L L' -> R M M' -> (forall j, R (near j) (near' j)) ->
  (forall j, R (far j) (far' j)) -> (forall j, R (p j) (p' j)) -> R d d' -> R (ruling A L M near far p d N) (ruling B L' M' near' far' p' d' N).
Proof.
move=> hL hM hn hf hp hd; elim: N => [|N ih] /=; first exact: keep_minus.
apply: keep_over; last exact: keep_minus.
by apply: keep_plus; apply: keep_times => //; exact: keep_minus.
Qed.

Lemma keep_vertex L M near far p d L' M' near' far' p' d' N : R L L' -> R M M' -> (forall j, R (near j) (near' j)) ->
  (forall j, R (far j) (far' j)) -> (forall j, R (p j) (p' j)) -> R d d' -> R (vertex A L M near far p d N) (vertex B L' M' near' far' p' d' N).
Proof. by move=> *; case: N => [//|N]; apply: keep_plus => //; exact: keep_ruling. Qed.

Lemma keep_net u n L M c d u' L' M' c' d' K J : (forall i, R (u i) (u' i)) -> R L L' -> R M M' -> (forall i, R (c i) (c' i)) -> R d d' ->
  R (net_from A u n L M c d K J) (net_from B u' n L' M' c' d' K J).
Proof. by move=> *; rewrite /net_from; case: ifP => _; exact: keep_vertex. Qed.

End Related.

Definition agrees (X : exact) (x : rat) := forall r, X = Some r -> r = real x.

Lemma agrees_related : respects exacts (exactly [fieldType of rat]) agrees.
Proof.
move=> [x|] [y|] x' y' hx hy; split=> //= r; rewrite ?(hx _ erefl) ?(hy _ erefl).
- by case=> <-; rewrite real_add.
- by case=> <-; rewrite real_sub.
- by case=> <-; rewrite real_mul.
case: Req_EM_T => // ny [<-]; rewrite real_mul real_inv //.
by apply/eqP=> y0; apply: ny; rewrite y0 (real_int 0).
Qed.

Lemma both_exist f X Y r : both f X Y = Some r -> (exists x, X = Some x) /\ exists y, Y = Some y.
Proof. by case: X Y => [x|] [y|] // _; split; [exists x | exists y]. Qed.
Lemma over_exist X Y r : over_exact X Y = Some r -> (exists x, X = Some x) /\ exists2 y : R, Y = Some y & y <> 0%Re.
Proof. by case: X Y => [x|] [y|] //=; case: Req_EM_T => // ny _; split; [exists x | exists y]. Qed.

Section Divisors.
Variables (L M : exact) (near far p : nat -> exact) (d : exact) (N : nat) (r : R).
Lemma divisors_exist : vertex exacts L M near far p d N = Some r -> forall j, (j < N)%N -> exists2 s : R, minus exacts M (far j) = Some s & s <> 0%Re.
Proof.
have last k s : ruling exacts L M near far p d k.+1 = Some s ->
    (exists t, ruling exacts L M near far p d k = Some t) /\ exists2 s : R, minus exacts M (far k) = Some s & s <> 0%Re.
  move=> /over_exist[[t /both_exist[_ [w /both_exist[_ rk]]]] far_k]; by split.
have all k : (exists s, ruling exacts L M near far p d k = Some s) -> forall j, (j < k)%N -> exists2 s : R, minus exacts M (far j) = Some s & s <> 0%Re.
  elim: k => [//|k ih] [s /last[ex here]] j; rewrite ltnS leq_eqVlt => /orP[/eqP->//|]; exact: ih.
case: N => [//|k] h; apply: all; move: h; rewrite [vertex _ _ _ _ _ _ _ _]/=.
by case/both_exist.
Qed.
End Divisors.

Section Net.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation running := (running prec emax).
Local Notation runnings := (runnings prec emax).
Local Notation machine := (machine prec emax).
Local Notation given := (of_number prec emax).
Implicit Types (x y : running) (X Y : exact).

Lemma minus_opposite (a b : T) : bplus a (Bopp b) = bminus a b.
Proof. by case: a b => [s|s||s m e h] [s'|s'||s' m' e' h'] //=; case: s s' => [] []. Qed.

Lemma values_related : respects runnings machine (fun x a => value x = a).
Proof.
move=> x y _ _ <- <-; split=> //=; first exact: minus_opposite.
  by rewrite /times_running; case: ifP.
by rewrite /over_running; case: ifP => // _; case: ifP.
Qed.

Hypothesis format_wide : wide prec emax.

Lemma tracks_related : respects runnings exacts tracks.
Proof.
move=> x y X Y hx hy; have [h1 [h2 _]] := rounding_binary_running_sum prec emax format_wide x y X Y hx hy.
by split; [exact: h1 | exact: h2 | exact: rounding_binary_running_product | exact: rounding_binary_running_quotient].
Qed.

(* What a running result says of the number that a program without bounds computes and of the exact one, if the exact result is that number where it exists. *)
Lemma running_close x X (a : T) q : tracks x X -> value x = a -> (forall s, X = Some s -> s = real q) -> is_finite (bound x) = true ->
  `|rational a - q| <= rational (bound x).
Proof.
rewrite /tracks => + + + fin; rewrite fin => -[_ [s [-> close]]] <- /(_ _ erefl) e.
by apply: real_le; rewrite real_norm real_sub !real_rational -e.
Qed.

Lemma given_agrees (a : T) : agrees (Some (B2R a)) (rational a).
Proof. by move=> _ [<-]; rewrite real_rational. Qed.

Lemma off_exact (a b : T) : (exists2 t : R, minus exacts (Some (B2R a)) (Some (B2R b)) = Some t & t <> 0%Re) -> rational a - rational b != 0.
Proof. by case=> t [<-] nt; apply/eqP=> z; apply: nt; rewrite -!real_rational -real_sub z (real_int 0). Qed.

Variables (m : nat) (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat).
Hypothesis start : d K = \row_k rational (dK k).
Local Notation v := (fun i => rational (u i)).

Lemma running_net k (r := net_from runnings (fun i => given (u i)) n (given L) (given M) (fun i => given (c i k)) (given (dK k)) K J) :
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  is_finite (bound r) = true -> `|rational (net_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= rational (bound r).
Proof.
move=> cells; pose X := net_from exacts (fun i => Some (B2R (u i))) n (Some (B2R L)) (Some (B2R M)) (fun i => Some (B2R (c i k))) (Some (B2R (dK k))) K J.
apply: (running_close (X := X)).
- by rewrite /r /X; apply: (keep_net (@tracks_related)) => *; exact: number_tracks.
- by rewrite /r; apply: (keep_net (@values_related)).
move=> s eX; have after i : (K <= i < J)%N -> rational M - v i != 0.
  move=> range; have lt : (i - K < J - K)%N by lia.
  have le : (K <= J)%N by lia.
  apply: off_exact; move: eX; rewrite /X /net_from le /upwards => /divisors_exist/(_ _ lt).
  by rewrite subnK //; case/andP: range.
have before i : (J <= i < K)%N -> rational M - v (i + n)%N != 0.
  move=> range; have lt : (K - i.+1 < K - J)%N by lia.
  have le : (K <= J)%N = false by lia.
  apply: off_exact; move: eX; rewrite /X /net_from le /downwards => /divisors_exist/(_ _ lt).
  by rewrite (_ : K - (K - i.+1).+1 = i)%N //; lia.
rewrite -(rounding_exact (c := fun i k => rational (c i k)) k after before cells) start mxE.
by apply: (keep_net (@agrees_related)) eX => *; exact: given_agrees.
Qed.
End Net.

(** rounding.binary64.running constants: in doubles the constants are those of the header: $1+2^{-49}$, $1-2^{-52}$, $2^{-1070}$, $2^{-960}$, $2^{53}$ and $2^{-52}$,
    and the format has the digits and the exponents that the theorems ask for. *)
Theorem rounding_binary64_running_constants :
  [/\ wide 53 1024, B2R (up 53 1024) = (1 + bpow radix2 (-49))%Re, B2R (down 53 1024) = (1 - bpow radix2 (-52))%Re,
    B2R (underflow 53 1024) = bpow radix2 (-1070) /\ B2R (tiny 53 1024) = bpow radix2 (-960) &
    B2R (most 53 1024) = bpow radix2 53 /\ B2R (ulps 53 1024) = bpow radix2 (-52)].
Proof.
have w : wide 53 1024 by split.
have [_ eu] := up_value 53 1024 w; have [_ ed] := down_value 53 1024 w.
have power e h : B2R (binary 53 1024 1 e) = bpow radix2 e := proj2 (power_value 53 1024 w e h).
split=> //; first by rewrite eu (bpow_plus radix2 4 (-53)).
- by rewrite ed (bpow_plus radix2 1 (-53)).
- by split; [refine (power _ _ (Zneg 1070) _) | refine (power _ _ (Zneg 960) _)].
by split; [refine (power _ _ (Zpos 53) _) | refine (power _ _ (Zneg 52) _)].
Qed.

Section Doubles.
Local Notation runnings := (runnings 53 1024).
Local Notation given := (of_number 53 1024).
Variables (m : nat) (u : nat -> double) (n : nat) (L M : double) (c : nat -> 'I_m -> double) (dK : 'I_m -> double) (d : nat -> 'rV[rat]_m) (K J : nat).
Hypothesis start : d K = \row_k rational (dK k).

(** rounding.binary64.running net: the bound that running error analysis gives of the vertex $J$, which the library computes in doubles from the vertex $K$, before or
    after it, bounds in each coordinate the distance of the computed vertex from the exact one, $d$ being the exact row (13).
    Hypotheses: the bound is finite. That nothing overflows and $M^{*}$ is none of the knots follows; what underflows is in the bound. *)
Theorem rounding_binary64_running_net k (r := net_from runnings (fun i => given (u i)) n (given L) (given M) (fun i => given (c i k)) (given (dK k)) K J) :
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (read rational c) d i) ->
  is_finite (bound r) = true -> `|rational (net_from doubles u n L M (c^~ k) (dK k) K J) - d J 0 k| <= rational (bound r).
Proof. by have [w _ _ _ _] := rounding_binary64_running_constants; exact: (running_net w start). Qed.
End Doubles.
