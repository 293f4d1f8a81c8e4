(* The bound of Rounding_printed.v for the bits that a processor computes.
   Definitions:
     survives_printed ...   the vertex N and the divisors on the way are finite, and no product or quotient underflows *)
From Torse Require Import Prelude_binary Points FJ07_3_net Rounding Rounding_net Rounding_printed Binary Rounding_binary.

Section Steps.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).
Variables (before behind passed divisor : nat -> T * T) (p q : nat -> T) (d : T) (N : nat).
Local Notation v := (printed machine before behind passed divisor p q d).
Local Notation apart := (apart machine).
Local Notation sides j := (bplus (btimes (apart (before j)) (p j)) (btimes (apart (behind j)) (q j))).
Local Notation sum j := (bplus (sides j) (btimes (apart (passed j)) (v j))).

Definition survives_printed := is_finite (v N) = true /\ forall j, (j < N)%N ->
  [/\ is_finite (apart (divisor j)) = true, times_survives (apart (before j)) (p j), times_survives (apart (behind j)) (q j),
    times_survives (apart (passed j)) (v j) & over_survives (sum j) (apart (divisor j))].

Hypothesis ok : survives_printed.

Lemma finite_vertices j : (j <= N)%N -> is_finite (v j) = true.
Proof.
move=> le_j; rewrite -(subKn le_j); elim: (N - j)%N (leq_subr j N) => [|k ih] lt_k.
  by rewrite subn0; case: ok.
have fr : is_finite (v (N - k.+1).+1) = true by rewrite subnSK //; apply: ih; exact: ltnW.
by have [_ h] := finite_plus (finite_over fr); have [_ h'] := finite_times h; exact: h'.
Qed.

Lemma off_knots j : (j < N)%N -> rational (divisor j).1 - rational (divisor j).2 != 0.
Proof.
move=> lt_j; have [_ /(_ j lt_j) [fd _ _ _ okq]] := ok; apply/eqP=> e.
have [nz _] := rounding_binary_quotient (finite_vertices lt_j) fd okq; case/eqP: nz.
have [_ h] := rounding_binary_sum (divisor j).1 (divisor j).2; have := h fd; rewrite /close e normr0 mulr0 subr0 normr_le0.
by move/eqP.
Qed.

Lemma machine_kept_printed : kept_printed machine rational eps before behind passed divisor p q d N.
Proof.
move=> j lt_j v' x y z s t; have [_ /(_ j lt_j) [fd okx oky okz okq]] := ok.
have sums a b := (rounding_binary_sum a b).1; have diffs a b := (rounding_binary_sum a b).2.
have fq := finite_vertices lt_j; have ft := finite_over fq; have [fs fz] := finite_plus ft; have [fx fy] := finite_plus fs.
have [fb _] := finite_times fx; have [fe _] := finite_times fy; have [fp _] := finite_times fz.
split.
- split; [exact: diffs fb | exact: diffs fe].
- split; [exact: diffs fp | exact: diffs fd].
- split; [exact: (rounding_binary_product fx okx) | exact: (rounding_binary_product fy oky)].
- split; [exact: (rounding_binary_product fz okz) | exact: sums fs].
split; [exact: sums ft | exact: (rounding_binary_quotient fq fd okq).2].
Qed.
End Steps.

Section Nets.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).

Variables (m : nat) (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[rat]_m) (K J : nat).
Local Notation v := (fun i => rational (u i)).
Hypothesis start : d K = \row_k rational (dK k).

(** rounding.binary printed: the vertex $J\ge K$ that the library computes with $p$ bits from the vertex $K$ as (13) stands has in each coordinate an error of at most
    $\gamma_{5(J-K)}|P(K,J)||d_K|+\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}\frac{|P(i+1,J)|}{|M^{*}-u_i|}\bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$ with $u=2^{-p}$.
    Hypotheses: $(5(J-K)+1)u<1$; the computed $d_J$ and the computed $M^{*}-u_i$, $K\le i<J$, are finite; each computed product and quotient on the way is at least the
    smallest normal number in size, unless a factor of it, or the dividend, is zero. That $M^{*}$ is none of these knots follows. *)
Theorem rounding_binary_printed k : (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 ->
  (forall i, (K <= i < J)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  printed_up u n L M (c^~ k) K (fun b h s o p q => survives_printed b h s o p q (dK k) (J - K)) ->
  `|rational (printed_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_up rational eps u n L M c dK K J k.
Proof.
move=> le_KJ small cells ok; apply: (rounding_printed_net (unit_ge0 prec) start le_KJ small) cells _; last exact: machine_kept_printed.
move=> i range; have lt : (i - K < J - K)%N by lia.
by have := off_knots ok lt; rewrite /= subnK //; lia.
Qed.

(** rounding.binary printed_down: the vertex $J\le K$ has in each coordinate an error of at most
    $\gamma_{5(K-J)}|P(J,K)|^{-1}|d_K|+\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}\frac{|P(J,i)|^{-1}}{|M^{*}-u_{i+n}|}
    \bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$ with $u=2^{-p}$.
    Hypotheses: as upwards, with the computed $u_{i+n}-M^{*}$, $J\le i<K$. *)
Theorem rounding_binary_printed_down k : (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 ->
  (forall i, (J <= i < K)%N -> cell v n (rational L) (rational M) (read rational c) d i) ->
  printed_down u n L M (c^~ k) K (fun b h s o p q => survives_printed b h s o p q (dK k) (K - J)) ->
  `|rational (printed_from machine u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_down rational eps u n L M c dK K J k.
Proof.
move=> le_JK small cells ok; apply: (rounding_printed_net_down (unit_ge0 prec) start le_JK small) cells _; last exact: machine_kept_printed.
move=> i range; have lt : (K - i.+1 < K - J)%N by lia.
have := off_knots ok lt; rewrite /= (_ : K - (K - i.+1).+1 = i)%N; last by lia.
by rewrite subr_eq0 eq_sym -subr_eq0.
Qed.
End Nets.
