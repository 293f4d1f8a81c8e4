(* Rounding errors of the net when each equation (13) is solved as it stands in the paper, in any arithmetic that keeps the standard model.
   Definitions:
     printed_next, printed   the vertices d_{j+1} = ((u_{j+n} - L) c_j + (L - u_j) c_{j+1} + (M - u_{j+n}) d_j) / (M - u_j) from d_0 = d, in one coordinate, operation by
                             operation as the library's printed_net computes them
     kept_printed            the model holds for each operation of the first N steps
     printed_spread          the bound: the terms of (14), each in absolute value and times its gamma *)
From mathcomp Require Import all_ssreflect all_algebra ring zify.
From Torse Require Import Points FJ07_3_net Rounding.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import Order.TTheory GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Section Program.
Variables (T : Type) (A : arithmetic T) (u : nat -> T) (n : nat) (L M : T) (c : nat -> T) (d : T).

Definition printed_next v j := over A (plus A (plus A (times A (minus A (u (j + n)%N) L) (c j)) (times A (minus A L (u j)) (c j.+1)))
  (times A (minus A M (u (j + n)%N)) v)) (minus A M (u j)).
Fixpoint printed N := if N is j.+1 then printed_next (printed j) j else d.
End Program.

Section Unrolled.
Variables (F : realFieldType) (eps : F) (a b e f : nat -> F).
Hypothesis range : 0 <= eps < 1.
Local Notation P := (across a b).

Lemma across_last i N : (i <= N)%N -> P i N.+1 = P i N * (a N / b N).
Proof. by move=> le_i; rewrite /across big_nat_recr. Qed.

Lemma across_none N : P N N = 1.
Proof. by rewrite /across big_geq. Qed.

Lemma two_terms (g k x y s t : F) : 0 <= k -> `|s| <= g -> `|t| <= g -> k * `|x * s + y * t| <= g * k * (`|x| + `|y|).
Proof.
move=> k0 hs ht; rewrite [g * k]mulrC -mulrA; apply: ler_wpmul2l => //; apply: le_trans (ler_norm_add _ _) _.
by rewrite !normrM mulrDr; apply: ler_add; rewrite mulrC; apply: ler_wpmul2r.
Qed.

Lemma unroll_two (x : nat -> F) N : (forall j, (j < N)%N -> exists s t w, [/\ factor eps 6 s, factor eps 6 t, factor eps 5 w &
    x j.+1 = (e j * s + f j * t + a j * x j * w) / b j]) ->
  exists w0 (s t : nat -> F), [/\ factor eps (5 * N) w0,
    forall i, (i < N)%N -> factor eps (5 * (N - i) + 1) (s i) /\ factor eps (5 * (N - i) + 1) (t i) &
    x N = P 0 N * x 0%N * w0 + \sum_(0 <= i < N) P i.+1 N / b i * (e i * s i + f i * t i)].
Proof.
elim: N => [|N ih] steps.
  exists 1, (fun=> 1), (fun=> 1); split=> //; first by rewrite /factor expr0 invr1 lexx.
  by rewrite across_none big_geq // mulr1 mul1r addr0.
have [w0 [s [t [f0 st ex]]]] := ih (fun j lt_j => steps j (ltnW lt_j)).
have [s' [t' [w [fs ft fw ew]]]] := steps N (leqnn _).
exists (w0 * w), (fun i => if i == N then s' else s i * w), (fun i => if i == N then t' else t i * w); split.
- by rewrite mulnS addnC; exact: factor_mul.
- move=> i; rewrite ltnS leq_eqVlt; case: eqVneq => [-> _|_ /= lt_i]; first by rewrite subSnn.
  have [fsi fti] := st i lt_i.
  by rewrite subSn ?(ltnW lt_i) // mulnS [(5 + _)%N]addnC addnAC; split; apply: factor_mul.
rewrite ew ex big_nat_recr //= eqxx across_last // across_none mul1r.
rewrite [in RHS](eq_big_nat _ _ (F2 := fun i => (P i.+1 N / b i * (e i * s i + f i * t i)) * (a N / b N * w))); last first.
  by move=> i /andP[_ lt_i]; rewrite ltn_eqF // across_last //; move: (P _ _) => y; ring.
rewrite -mulr_suml; move: (\sum_(_ <= _ < _) _) (P 0 N) (b N)^-1 => S P0 v; ring.
Qed.
End Unrolled.

Section Bound.
Variables (F : realFieldType) (T : Type) (A : arithmetic T) (val : T -> F) (eps : F).
Variables (u : nat -> T) (n : nat) (L M : T) (c : nat -> T) (d : T) (N : nat).
Local Notation computed := (printed A u n L M c d).
Local Notation a := (fun j => val M - val (u (j + n)%N)).
Local Notation b := (fun j => val M - val (u j)).
Local Notation e := (fun j => (val (u (j + n)%N) - val L) * val (c j)).
Local Notation f := (fun j => (val L - val (u j)) * val (c j.+1)).
Local Notation P := (across a b).

Definition kept_printed := forall j, (j < N)%N -> let v := computed j in
  let x := times A (minus A (u (j + n)%N) L) (c j) in let y := times A (minus A L (u j)) (c j.+1) in
  let z := times A (minus A M (u (j + n)%N)) v in let s := plus A x y in let t := plus A s z in
  [/\ close eps (val (u (j + n)%N) - val L) (val (minus A (u (j + n)%N) L)) /\ close eps (val L - val (u j)) (val (minus A L (u j))),
    close eps (val M - val (u (j + n)%N)) (val (minus A M (u (j + n)%N))) /\ close eps (val M - val (u j)) (val (minus A M (u j))),
    rounded eps (val (minus A (u (j + n)%N) L) * val (c j)) (val x) /\ rounded eps (val (minus A L (u j)) * val (c j.+1)) (val y),
    rounded eps (val (minus A M (u (j + n)%N)) * val v) (val z) /\ close eps (val x + val y) (val s) &
    close eps (val s + val z) (val t) /\ rounded eps (val t / val (minus A M (u j))) (val (computed j.+1))].
Definition printed_spread := gamma eps (5 * N) * `|P 0 N| * `|val d|
  + \sum_(0 <= i < N) gamma eps (5 * (N - i) + 1) * (`|P i.+1 N| / `|b i|) * (`|e i| + `|f i|).

Hypothesis eps_ge0 : 0 <= eps.
Hypothesis off : forall j, (j < N)%N -> b j != 0.
Hypothesis model : kept_printed.

Lemma printed_cell j : eps < 1 -> (j < N)%N -> exists s t w, [/\ factor eps 6 s, factor eps 6 t, factor eps 5 w &
  val (computed j.+1) = (e j * s + f j * t + a j * val (computed j) * w) / b j].
Proof.
move=> eps1 lt_j; have range : 0 <= eps < 1 by rewrite eps_ge0.
have [[h1 h2] [h3 h4] [h5 h6] [h7 h8] [h9 h10]] := model lt_j.
have cf x y : close eps x y -> exists2 t, factor eps 1 t & y = x * t by move=> h; apply: (rounded_factor range); left.
have [t1 f1 e1] := cf _ _ h1; have [t2 f2 e2] := cf _ _ h2; have [t3 f3 e3] := cf _ _ h3; have [t4 f4 e4] := cf _ _ h4.
have [t5 f5 e5] := rounded_factor range h5; have [t6 f6 e6] := rounded_factor range h6; have [t7 f7 e7] := rounded_factor range h7.
have [t8 f8 e8] := cf _ _ h8; have [t9 f9 e9] := cf _ _ h9; have [t10 f10 e10] := rounded_factor range h10.
have f4' := factor_inv range f4; have mul := factor_mul range.
exists (t1 * t5 * t8 * t9 * t4^-1 * t10), (t2 * t6 * t8 * t9 * t4^-1 * t10), (t3 * t7 * t9 * t4^-1 * t10); split.
- exact: (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ f1 f5) f8) f9) f4') f10).
- exact: (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ f2 f6) f8) f9) f4') f10).
- exact: (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ (mul _ _ _ _ f3 f7) f9) f4') f10).
rewrite e10 e9 e8 e7 e6 e5 e4 e3 e2 e1 invfM.
by move: (val (computed j)) (val (c j)) (val (c j.+1)) (val M - val (u j))^-1 t4^-1 => *; ring.
Qed.

(** rounding printed: the vertices that are computed as (13) stands in the paper have $|\hat d_N-d_N|\le\gamma_{5N}|P(0,N)||d_0|
    +\sum_{i=0}^{N-1}\gamma_{5(N-i)+1}\frac{|P(i+1,N)|}{|M^{*}-u_i|}\bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$: the bound grows with the distance of
    the points from the origin, where that of the rulings depends on their differences only.
    Hypotheses: the operations keep the standard model; $(5N+1)\varepsilon<1$; $M^{*}\ne u_i$ for $i<N$. *)
Theorem rounding_printed (r : nat -> F) : (5 * N + 1)%:R * eps < 1 -> r 0%N = val d ->
  (forall j, (j < N)%N -> b j * r j.+1 = e j + f j + a j * r j) -> `|val (computed N) - r N| <= printed_spread.
Proof.
move=> small r0 rec; have small_k k : (k <= 5 * N + 1)%N -> k%:R * eps < 1.
  by move=> le_k; apply: le_lt_trans small; rewrite ler_wpmul2r // ler_nat.
have eps1 : eps < 1 by rewrite -[eps]mul1r (small_k 1%N) // addn1.
have range : 0 <= eps < 1 by rewrite eps_ge0.
have [w0 [s [t [f0 st ->]]]] := unroll_two range (x := fun j => val (computed j)) (fun j => printed_cell eps1).
have exact_r K : (K <= N)%N -> r K = P 0 K * val d + \sum_(0 <= i < K) P i.+1 K / b i * (e i + f i).
  elim: K => [|K ih] lt_K; first by rewrite across_none big_geq // mul1r addr0.
  apply: (mulfI (off lt_K)); rewrite rec // ih ?(ltnW lt_K) // big_nat_recr //= across_last // across_none mul1r.
  rewrite [in RHS](eq_big_nat _ _ (F2 := fun i => (P i.+1 K / b i * (e i + f i)) * (a K / b K))); last first.
    by move=> i /andP[_ lt_i]; rewrite across_last //; move: (P _ _) => y; ring.
  rewrite -mulr_suml; move: (off lt_K); move: (\sum_(_ <= _ < _) _) (P 0 K) => S P0 nz; by field.
rewrite (exact_r N (leqnn N)) /= opprD addrACA -sumrB.
apply: le_trans (ler_norm_add _ _) _; rewrite /printed_spread; apply: ler_add.
  rewrite (_ : P 0 N * val d * w0 - P 0 N * val d = (w0 - 1) * (P 0 N * val d)); last by ring.
  by rewrite !normrM -mulrA ler_wpmul2r ?mulr_ge0 // (rounding_factors range _ f0) // small_k // leq_addr.
apply: le_trans (ler_norm_sum _ _ _) _; rewrite !big_mkord; apply: ler_sum => i _.
have [fs ft] := st i (ltn_ord i); have le_k : (5 * (N - i) + 1 <= 5 * N + 1)%N by rewrite leq_add2r leq_mul2l leq_subr.
have hs := rounding_factors range (small_k _ le_k) fs; have ht := rounding_factors range (small_k _ le_k) ft.
rewrite -mulrBr (_ : _ - _ = e i * (s i - 1) + f i * (t i - 1)); last by ring.
rewrite normrM normf_div; apply: two_terms => //; rewrite mulr_ge0 ?invr_ge0 //.
Qed.
End Bound.

Section Nets.
Variables (F : realFieldType) (T : Type) (A : arithmetic T) (val : T -> F) (eps : F) (m : nat).
Variables (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (d0 : 'I_m -> T) (d : nat -> 'rV[F]_m) (N : nat).

(** rounding printed_net: so each coordinate of the vertex $N$ of a net of (13) that is computed from $d_0$ as (13) stands has at most this error.
    Hypotheses: the operations keep the standard model; $(5N+1)\varepsilon<1$; $M^{*}$ is none of $u_0,\dots,u_{N-1}$. *)
Theorem rounding_printed_net k : 0 <= eps -> (5 * N + 1)%:R * eps < 1 -> (forall i, (i < N)%N -> val M - val (u i) != 0) ->
  d 0%N = \row_k val (d0 k) ->
  (forall i, (i < N)%N -> cell (fun i => val (u i)) n (val L) (val M) (fun i => \row_k val (c i k)) d i) ->
  kept_printed A val eps u n L M (c^~ k) (d0 k) N ->
  `|val (printed A u n L M (c^~ k) (d0 k) N) - d N 0 k| <= printed_spread val eps u n L M (c^~ k) (d0 k) N.
Proof.
move=> e0 small off start cells model; apply: (rounding_printed (r := fun j => d j 0 k) e0 off model small); first by rewrite start mxE.
move=> j lt_j; have /rowP/(_ k) := cells j lt_j; rewrite !mxE => ->.
by move: (d j 0 k) (d j.+1 0 k) (val (u j)) (val (u (j + n)%N)) (val M) => x y v w z; ring.
Qed.
End Nets.

Section Exact.
Variables (F : fieldType) (m : nat) (u : nat -> F) (n : nat) (L M : F) (c : nat -> 'I_m -> F) (d : nat -> 'rV[F]_m) (N : nat).

(** rounding printed_exact: without rounding errors this recursion gives the row (13).
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{N-1}$. *)
Theorem rounding_printed_exact k : (forall i, (i < N)%N -> M - u i != 0) ->
  (forall i, (i < N)%N -> cell u n L M (fun i => \row_k c i k) d i) -> printed (exactly F) u n L M (c^~ k) (d 0%N 0 k) N = d N 0 k.
Proof.
elim: N => [//|j ih] off cells /=; rewrite ih; [|by move=> i lt_i; apply: off; exact: ltnW|by move=> i lt_i; apply: cells; exact: ltnW].
have nz := off j (ltnSn j); apply: (mulIf nz); rewrite /printed_next /= divfK //.
have /rowP/(_ k) := cells j (ltnSn j); rewrite !mxE => ->.
by move: (u (j + n)%N) (d j 0 k) (d j.+1 0 k) => x y z; ring.
Qed.
End Exact.
