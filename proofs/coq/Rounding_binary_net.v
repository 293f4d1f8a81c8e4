(* The a-priori bound for the bits that a processor computes.
   Definitions:
     survives ...     the vertex N and the knots far_j on the way are finite, and no product or quotient underflows *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Binary Rounding_binary.

Section Steps.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).
Variables (L M : T) (near far p : nat -> T) (d : T) (N : nat).
Local Notation r := (ruling machine L M near far p d).
Local Notation side j := (bminus (p j.+1) (p j)).
Local Notation gap := (bminus L M).
Local Notation moved j := (btimes (side j) gap).
Local Notation passed j := (btimes (bminus M (near j)) (r j)).
Local Notation divisor j := (bminus M (far j)).

Definition survives := is_finite (vertex machine L M near far p d N) = true /\ forall j, (j < N)%N ->
  [/\ is_finite (far j) = true, times_survives (side j) gap, times_survives (bminus M (near j)) (r j) &
    over_survives (bplus (moved j) (passed j)) (divisor j)].

Hypothesis ok : survives.

Lemma finite_step j : (j < N)%N -> is_finite (r j.+1) = true -> [/\ is_finite (bplus (moved j) (passed j)) = true, is_finite (moved j) = true,
  is_finite (passed j) = true, is_finite (r j) = true & is_finite (side j) = true /\ is_finite gap = true /\ is_finite (bminus M (near j)) = true].
Proof.
move=> lt_j fr; have fs := finite_over fr; have [fm fp] := finite_plus fs; have [fe fg] := finite_times fm; have [fn fj] := finite_times fp.
by split; [exact: fs | exact: fm | exact: fp | exact: fj | split; [exact: fe | split; [exact: fg | exact: fn]]].
Qed.

Hypothesis pos : (0 < N)%N.

Lemma finite_last : is_finite (bplus (p N) (r N)) = true.
Proof. by have [] := ok; case: (N) pos. Qed.

Lemma finite_rulings j : (j <= N)%N -> is_finite (r j) = true.
Proof.
move=> le_j; rewrite -(subKn le_j); elim: (N - j)%N (leq_subr j N) => [|k ih] lt_k.
  by rewrite subn0; have [_ h] := finite_plus finite_last; exact: h.
have lt : (N - k.+1 < N)%N by lia.
have fr : is_finite (r (N - k.+1).+1) = true by rewrite subnSK //; apply: ih; exact: ltnW.
by have [_ _ _ h _] := finite_step lt fr; exact: h.
Qed.

Lemma quotient_kept j : (j < N)%N -> is_finite (divisor j) = false ->
  rational (bplus (moved j) (passed j)) = 0 /\ rational (r j.+1) = 0.
Proof.
move=> lt_j inf; have [_ /(_ j lt_j) [_ _ _ okq]] := ok.
have q0 : rational (r j.+1) = 0.
  by apply: real_inj; rewrite real_rational (real_int 0); exact: (infinite_divisor (finite_rulings lt_j) inf).
split; last exact: q0.
case: okq => [h|]; first exact: h.
move: q0 => /= ->; rewrite normr0 leNgt => /negP h; exfalso; apply: h; exact: (least_gt0 emax).
Qed.

Lemma off j : (j < N)%N -> rational M - rational (far j) != 0.
Proof.
move=> lt_j; have [_ /(_ j lt_j) [ff _ _ okq]] := ok; rewrite subr_eq0; apply/eqP=> e.
have [_ _ _ _ [_ [_ fn]]] := finite_step lt_j (finite_rulings lt_j); have [fM _] := finite_minus fn.
have eR : B2R M = B2R (far j) by rewrite -!real_rational e.
have [fd|inf] := boolP (is_finite (divisor j)); last exact: (overflown_difference fM ff (negbTE inf) eR).
have [nz _] := rounding_binary_quotient (finite_rulings lt_j) fd okq; case/eqP: nz.
have [_ h] := rounding_binary_sum M (far j); have := h fd; rewrite /close e subrr normr0 mulr0 subr0 normr_le0.
by move/eqP.
Qed.

Lemma machine_kept : kept_vertex machine rational eps L M near far p d N.
Proof.
move=> _; have [last _] := rounding_binary_sum (p N) (r N); split; last exact: last finite_last.
have sums x y := (rounding_binary_sum x y).1; have diffs x y := (rounding_binary_sum x y).2.
split; first by apply: diffs; exact: (finite_rulings (leq0n N)).
  have [_ _ _ _ [_ [fg _]]] := finite_step pos (finite_rulings pos); exact: diffs fg.
move=> j lt_j side' r' moved' passed' sum' divisor' quotient'.
have [fs fm fp fr [fe [fg fn]]] := finite_step lt_j (finite_rulings lt_j).
have [_ /(_ j lt_j) [ff okm okp okq]] := ok.
split; [exact: diffs fe | exact: diffs fn | exact: (rounding_binary_product fm okm) | exact: (rounding_binary_product fp okp) |].
split; first exact: sums fs.
have [fd|inf] := boolP (is_finite (divisor j)); [left | right; exact: (quotient_kept lt_j (negbTE inf))].
split; first exact: diffs fd.
exact: (rounding_binary_quotient (finite_rulings lt_j) fd okq).2.
Qed.
End Steps.

Section Nets.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).
Variables (m : nat) (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T).
Variables (d : nat -> 'rV[rat]_m) (K J : nat).
Local Notation v := (fun i => rational (u i)).
Local Notation c_ k := (fun i => rational (c i k)).
Hypothesis start : d K = \row_k rational (dK k).

(** rounding.binary net: the vertex $J\ge K$ that the library computes with $p$ bits from the vertex $K$ has in each coordinate an error of at most
    $u|d_J|+(1+u)\bigl(\gamma_{5(J-K)+1}|P(K,J)||d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}|P(i+1,J)|\frac{|c_{i+1}-c_i|}{|M^{*}-u_i|}\bigr)$ with $u=2^{-p}$, where $d$ is the exact row (13).
    Hypotheses: $(5(J-K)+1)u<1$; the computed $d_J$ and the knots $u_K,\dots,u_{J-1}$ are finite; each computed product and quotient on the way is at
    least the smallest normal number in size, unless a factor of it, or the dividend, is zero. That $M^{*}$ is none of these knots follows. *)
Theorem rounding_binary_net k : (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 ->
  (forall i, (K <= i < J)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  upwards u n (c^~ k) K (fun near far p => survives L M near far p (dK k) (J - K)) ->
  `|rational (net_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_up eps v n (rational L) (rational M) (c_ k) (rational (dK k)) K J.
Proof.
move=> le_KJ small cells ok; apply: (rounding_net (unit_ge0 prec) start le_KJ small) cells _.
  move=> i range; have lt : (i - K < J - K)%N by lia.
  by have := off ok (leq_ltn_trans (leq0n _) lt) lt; rewrite subnK //; lia.
by move=> pos; apply: (machine_kept ok pos).
Qed.

(** rounding.binary net_down: the vertex $J\le K$ has in each coordinate an error of at most
    $u|d_J|+(1+u)\bigl(\gamma_{5(K-J)+1}|P(J,K)|^{-1}|d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}|P(J,i)|^{-1}\frac{|c_{i+1}-c_i|}{|M^{*}-u_{i+n}|}\bigr)$ with $u=2^{-p}$.
    Hypotheses: as upwards, with the knots $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_binary_net_down k : (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 ->
  (forall i, (J <= i < K)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  downwards u n (c^~ k) K (fun near far p => survives L M near far p (dK k) (K - J)) ->
  `|rational (net_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_down eps v n (rational L) (rational M) (c_ k) (rational (dK k)) K J.
Proof.
move=> le_JK small cells ok; apply: (rounding_net_down (unit_ge0 prec) start le_JK small) cells _.
  move=> i range; have lt : (K - i.+1 < K - J)%N by lia.
  by have := off ok (leq_ltn_trans (leq0n _) lt) lt; rewrite (_ : K - (K - i.+1).+1 = i)%N //; lia.
by move=> pos; apply: (machine_kept ok pos).
Qed.
End Nets.
