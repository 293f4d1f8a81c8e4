(* The bound of Rounding_printed.v for the bits that a processor computes.
   Definitions:
     survives_printed ...   the vertex N and the differences M - u_j on the way are finite, and no product or quotient underflows *)
From Coq Require Import ZArith Reals Psatz.
From Flocq Require Import Core BinarySingleNaN.
From mathcomp Require Import all_ssreflect all_algebra ring zify ssrZ.
From Torse Require Import Points FJ07_3_net Rounding Rounding_printed Binary Rounding_binary.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.
Delimit Scope R_scope with Re.

Section Steps.
Variables (prec emax : Z).
Context {prec_pos : Prec_gt_0 prec} {prec_emax : Prec_lt_emax prec emax}.
Local Notation T := (number prec emax).
Local Notation machine := (machine prec emax).
Local Notation eps := (unit_roundoff prec).
Variables (u : nat -> T) (n : nat) (L M : T) (c : nat -> T) (d : T) (N : nat).
Local Notation v := (printed machine u n L M c d).
Local Notation before j := (bminus (u (j + n)%N) L).
Local Notation behind j := (bminus L (u j)).
Local Notation passed j := (bminus M (u (j + n)%N)).
Local Notation divisor j := (bminus M (u j)).
Local Notation sides j := (bplus (btimes (before j) (c j)) (btimes (behind j) (c j.+1))).
Local Notation sum j := (bplus (sides j) (btimes (passed j) (v j))).

Definition survives_printed := is_finite (v N) = true /\ forall j, (j < N)%N ->
  [/\ is_finite (divisor j) = true, times_survives (before j) (c j), times_survives (behind j) (c j.+1), times_survives (passed j) (v j) &
    over_survives (sum j) (divisor j)].

Hypothesis ok : survives_printed.

Lemma finite_vertices j : (j <= N)%N -> is_finite (v j) = true.
Proof.
move=> le_j; rewrite -(subKn le_j); elim: (N - j)%N (leq_subr j N) => [|k ih] lt_k.
  by rewrite subn0; case: ok.
have fr : is_finite (v (N - k.+1).+1) = true by rewrite subnSK //; apply: ih; exact: ltnW.
by have [_ h] := finite_plus (finite_over fr); have [_ h'] := finite_times h; exact: h'.
Qed.

Lemma off_knots j : (j < N)%N -> rational M - rational (u j) != 0.
Proof.
move=> lt_j; have [_ /(_ j lt_j) [fd _ _ _ okq]] := ok; apply/eqP=> e.
have [nz _] := rounding_binary_quotient (finite_vertices lt_j) fd okq; case/eqP: nz.
have [_ h] := rounding_binary_sum M (u j); have := h fd; rewrite /close e normr0 mulr0 subr0 normr_le0.
by move/eqP.
Qed.

Lemma machine_kept_printed : kept_printed machine rational eps u n L M c d N.
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

(** rounding.binary printed: the vertex $N$ that the library computes with $p$ bits from $d_0$ as (13) stands has in each coordinate an error of at most
    $\gamma_{5N}|P(0,N)||d_0|+\sum_{i=0}^{N-1}\gamma_{5(N-i)+1}\frac{|P(i+1,N)|}{|M^{*}-u_i|}\bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$ with $u=2^{-p}$.
    Hypotheses: $(5N+1)u<1$; the computed $d_N$ and the computed $M^{*}-u_i$, $i<N$, are finite; each computed product and quotient on the way is at least the smallest normal number in size,
    unless a factor of it, or the dividend, is zero. That $M^{*}$ is none of these knots follows. *)
Theorem rounding_binary_printed m (u : nat -> T) n (L M : T) (c : nat -> 'I_m -> T) (d0 : 'I_m -> T) (d : nat -> 'rV[rat]_m) N k :
  (5 * N + 1)%:R * eps < 1 -> d 0%N = \row_k rational (d0 k) ->
  (forall i, (i < N)%N -> cell (fun i => rational (u i)) n (rational L) (rational M) (fun i => \row_k rational (c i k)) d i) ->
  survives_printed u n L M (c^~ k) (d0 k) N ->
  `|rational (printed machine u n L M (c^~ k) (d0 k) N) - d N 0 k| <= printed_spread rational eps u n L M (c^~ k) (d0 k) N.
Proof.
move=> small start cells ok; apply: (rounding_printed_net (unit_ge0 prec) small _ start cells); last exact: machine_kept_printed.
by move=> i lt_i; exact: (off_knots ok).
Qed.
End Nets.
