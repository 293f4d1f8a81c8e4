(* Rounding errors of the net when each equation (13) is solved as it stands in the paper, in any arithmetic that keeps the standard model.
   Definitions:
     apart A x       the difference x.1 - x.2 of a pair
     printed         v_{j+1} = (before_j p_j + behind_j q_j + passed_j v_j) / divisor_j from v_0 = d, operation by operation; before_j, ... are differences
     printed_up, printed_down   the differences for d_{i+1} = ((u_{i+n} - L) c_i + (L - u_i) c_{i+1} + (M - u_{i+n}) d_i) / (M - u_i) after the vertex K,
                     and for d_i = ((u_{i+n} - L) c_i + (L - u_i) c_{i+1} + (u_i - M) d_{i+1}) / (u_{i+n} - M) before it, as the library's printed_net takes them
     printed_from    the vertex J from the vertex K
     kept_printed    the model holds for each operation of the first N steps
     printed_spread  the bound: the terms of (14), each in absolute value and times its gamma
     printed_bound_up, printed_bound_down   the same in the knots of the paper *)
From Torse Require Import Prelude Points FJ07_3_net Rounding Rounding_net.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Program.
Variables (T : Type) (A : arithmetic T).
Implicit Types (before behind passed divisor : nat -> T * T) (p q c u : nat -> T) (d L M : T) (n K J : nat).

Local Notation steps X := ((nat -> T * T) -> (nat -> T * T) -> (nat -> T * T) -> (nat -> T * T) -> (nat -> T) -> (nat -> T) -> X).

Definition apart (x : T * T) := minus A x.1 x.2.
Definition printed_next before behind passed divisor p q v j :=
  over A (plus A (plus A (times A (apart (before j)) (p j)) (times A (apart (behind j)) (q j))) (times A (apart (passed j)) v)) (apart (divisor j)).
Fixpoint printed before behind passed divisor p q d N :=
  if N is j.+1 then printed_next before behind passed divisor p q (printed before behind passed divisor p q d j) j else d.

Definition printed_up (X : Type) u n L M c K (f : steps X) :=
  f (fun j => (u (j + K + n)%N, L)) (fun j => (L, u (j + K)%N)) (fun j => (M, u (j + K + n)%N)) (fun j => (M, u (j + K)%N))
    (fun j => c (j + K)%N) (fun j => c (j + K).+1).
Definition printed_down (X : Type) u n L M c K (f : steps X) :=
  f (fun j => (u (K - j.+1 + n)%N, L)) (fun j => (L, u (K - j.+1)%N)) (fun j => (u (K - j.+1)%N, M)) (fun j => (u (K - j.+1 + n)%N, M))
    (fun j => c (K - j.+1)%N) (fun j => c (K - j.+1).+1).
Definition printed_from u n L M c d K J :=
  if (K <= J)%N then printed_up u n L M c K (fun b h s o p q => printed b h s o p q d (J - K))
  else printed_down u n L M c K (fun b h s o p q => printed b h s o p q d (K - J)).
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
Variables (before behind passed divisor : nat -> T * T) (p q : nat -> T) (d : T) (N : nat).
Local Notation computed := (printed A before behind passed divisor p q d).
Local Notation exact x := (val x.1 - val x.2).
Local Notation a := (fun j => exact (passed j)).
Local Notation b := (fun j => exact (divisor j)).
Local Notation e := (fun j => exact (before j) * val (p j)).
Local Notation f := (fun j => exact (behind j) * val (q j)).
Local Notation P := (across a b).

Definition kept_printed := forall j, (j < N)%N -> let v := computed j in
  let x := times A (apart A (before j)) (p j) in let y := times A (apart A (behind j)) (q j) in
  let z := times A (apart A (passed j)) v in let s := plus A x y in let t := plus A s z in
  [/\ close eps (exact (before j)) (val (apart A (before j))) /\ close eps (exact (behind j)) (val (apart A (behind j))),
    close eps (exact (passed j)) (val (apart A (passed j))) /\ close eps (exact (divisor j)) (val (apart A (divisor j))),
    rounded eps (val (apart A (before j)) * val (p j)) (val x) /\ rounded eps (val (apart A (behind j)) * val (q j)) (val y),
    rounded eps (val (apart A (passed j)) * val v) (val z) /\ close eps (val x + val y) (val s) &
    close eps (val s + val z) (val t) /\ rounded eps (val t / val (apart A (divisor j))) (val (computed j.+1))].
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
by move: (val (computed j)) (val (p j)) (val (q j)) (exact (divisor j))^-1 t4^-1 => *; ring.
Qed.

(** rounding printed: numbers that are computed by $v_{j+1}=(x_jp_j+y_jq_j+a_jv_j)/b_j$ from $v_0$, with $x_j,y_j,a_j,b_j$ computed as differences, have
    $|\hat v_N-v_N|\le\gamma_{5N}\Bigl|\prod_{j<N}\frac{a_j}{b_j}\Bigr||v_0|
    +\sum_{i=0}^{N-1}\gamma_{5(N-i)+1}\Bigl|\prod_{i<j<N}\frac{a_j}{b_j}\Bigr|\frac{|x_ip_i|+|y_iq_i|}{|b_i|}$.
    Hypotheses: the operations keep the standard model; $(5N+1)\varepsilon<1$; $b_i\ne0$ for $i<N$. *)
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
Variables (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[F]_m) (K J : nat).
Local Notation v := (fun i => val (u i)).
Local Notation P := (P v n (val M)).
Local Notation size k i := (`|v (i + n)%N - val L| * `|val (c i k)| + `|val L - v i| * `|val (c i.+1 k)|).

Definition printed_bound_up k := gamma eps (5 * (J - K)) * `|P K J| * `|val (dK k)|
  + \sum_(K <= i < J) gamma eps (5 * (J - i) + 1) * (`|P i.+1 J| / `|val M - v i|) * size k i.
Definition printed_bound_down k := gamma eps (5 * (K - J)) * `|(P J K)^-1| * `|val (dK k)|
  + \sum_(J <= i < K) gamma eps (5 * (i.+1 - J) + 1) * (`|(P J i)^-1| / `|val M - v (i + n)%N|) * size k i.

Hypothesis eps_ge0 : 0 <= eps.
Hypothesis start : d K = \row_k val (dK k).

(** rounding printed_net: the vertex $J\ge K$ of a net that is computed from the vertex $K$ with (13) solved as it stands has in each coordinate an error of at most
    $\gamma_{5(J-K)}|P(K,J)||d_K|+\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}\frac{|P(i+1,J)|}{|M^{*}-u_i|}\bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$:
    it grows with the distance of the points from the origin, where that of the rulings depends on their differences only.
    Hypotheses: the operations keep the standard model; $(5(J-K)+1)\varepsilon<1$; $M^{*}$ is none of $u_K,\dots,u_{J-1}$. *)
Theorem rounding_printed_net k : (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 -> (forall i, (K <= i < J)%N -> val M - v i != 0) ->
  (forall i, (K <= i < J)%N -> cell v n (val L) (val M) (read val c) d i) ->
  printed_up u n L M (c^~ k) K (fun b h s o p q => kept_printed A val eps b h s o p q (dK k) (J - K)) ->
  `|val (printed_from A u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_up k.
Proof.
move=> le_KJ small off cells; rewrite /printed_from le_KJ /printed_up => model.
have at_J : (J - K + K)%N = J by rewrite subnK. have range j : (j < J - K)%N -> (K <= j + K < J)%N by lia.
have := rounding_printed (r := fun j => d (j + K)%N 0 k) eps_ge0 _ model small _ _; rewrite /= at_J => h.
apply: le_trans (h _ _ _) _ => {h} [j lt_j||j lt_j|].
- exact: off (range j lt_j).
- by rewrite add0n start mxE.
- have /rowP/(_ k) := cells _ (range j lt_j); rewrite !mxE !addSn => ->.
  by move: (d (j + K)%N 0 k) (d (j + K).+1 0 k) (v (j + K)%N) (v (j + K + n)%N) (val M) => *; ring.
rewrite le_eqVlt (_ : printed_spread _ _ _ _ _ _ _ _ _ _ = printed_bound_up k) ?eqxx //.
have eP i : across (fun j => val M - v (j + K + n)%N) (fun j => val M - v (j + K)%N) i (J - K) = P (i + K) J by rewrite /P big_addn.
have eS (f : nat -> F) : \sum_(K <= i < J) f i = \sum_(0 <= i < J - K) f (i + K)%N by rewrite -{1}[K]add0n big_addn.
rewrite /printed_spread /printed_bound_up eS (eP 0%N); congr (_ + _); apply: eq_big_nat => i _.
by rewrite (eP i.+1) subnDA subnAC /= !normrM.
Qed.

(** rounding printed_net_down: the vertex $J\le K$ has in each coordinate an error of at most
    $\gamma_{5(K-J)}|P(J,K)|^{-1}|d_K|+\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}\frac{|P(J,i)|^{-1}}{|M^{*}-u_{i+n}|}
    \bigl(|u_{i+n}-\Lambda^{*}||c_i|+|\Lambda^{*}-u_i||c_{i+1}|\bigr)$.
    Hypotheses: the operations keep the standard model; $(5(K-J)+1)\varepsilon<1$; $M^{*}$ is none of $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_printed_net_down k : (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 -> (forall i, (J <= i < K)%N -> val M - v (i + n)%N != 0) ->
  (forall i, (J <= i < K)%N -> cell v n (val L) (val M) (read val c) d i) ->
  printed_down u n L M (c^~ k) K (fun b h s o p q => kept_printed A val eps b h s o p q (dK k) (K - J)) ->
  `|val (printed_from A u n L M (c^~ k) (dK k) K J) - d J 0 k| <= printed_bound_down k.
Proof.
move=> le_JK small off cells model; have -> : printed_from A u n L M (c^~ k) (dK k) K J = printed_down u n L M (c^~ k) K (fun b h s o p q => printed A b h s o p q (dK k) (K - J)).
  by rewrite /printed_from; case: ltngtP le_JK => // -> _; rewrite /printed_up /printed_down subnn.
have at_J : (K - (K - J))%N = J by rewrite subKn. have range j : (j < K - J)%N -> (J <= K - j.+1 < K)%N by lia.
move: model; rewrite /printed_down => model.
have := rounding_printed (r := fun j => d (K - j)%N 0 k) eps_ge0 _ model small _ _; rewrite /= at_J => h.
apply: le_trans (h _ _ _) _ => {h} [j lt_j||j lt_j|].
- by rewrite subr_eq0 eq_sym -subr_eq0; exact: off (range j lt_j).
- by rewrite subn0 start mxE.
- have ej : (K - j = (K - j.+1).+1)%N by lia.
  have /rowP/(_ k) := cells _ (range j lt_j); rewrite !mxE ej => ->.
  by move: (d (K - j.+1)%N 0 k) (d (K - j.+1).+1 0 k) (v (K - j.+1)%N) (v (K - j.+1 + n)%N) (val M) => *; ring.
rewrite le_eqVlt (_ : printed_spread _ _ _ _ _ _ _ _ _ _ = printed_bound_down k) ?eqxx //.
have eP j : (j <= K - J)%N ->
    across (fun j => v (K - j.+1)%N - val M) (fun j => v (K - j.+1 + n)%N - val M) j (K - J) = (P J (K - j))^-1.
  move=> le_j; rewrite /P -prodfV -backwards //; apply: eq_bigr => i _.
  by rewrite invf_div -opprB -[_ - val M]opprB invrN mulrNN.
have rev (g : nat -> F) : \sum_(J <= i < K) g i = \sum_(0 <= i < K - J) g (K - i.+1)%N by rewrite backwards ?subn0.
rewrite /printed_spread /printed_bound_down (eP 0%N) // subn0 rev; congr (_ + _); apply: eq_big_nat => i /andP[_ lt_i].
have -> : (K - i.+1).+1 = (K - i)%N by lia.
by rewrite eP // subnAC /= !normrM [`|_ - val M|]distrC.
Qed.
End Nets.

Section Exact.
Variables (F : fieldType) (m : nat) (u : nat -> F) (n : nat) (L M : F) (c : nat -> 'I_m -> F) (d : nat -> 'rV[F]_m) (K J : nat).

(** rounding printed_exact: without rounding errors this recursion gives the row (13), upwards and downwards from any of its vertices.
    Hypotheses: $M^{*}$ is none of $u_K,\dots,u_{J-1}$, or for $J<K$ none of $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_printed_exact k : (forall i, (K <= i < J)%N -> M - u i != 0) -> (forall i, (J <= i < K)%N -> M - u (i + n)%N != 0) ->
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell u n L M (fun i => \row_k c i k) d i) ->
  printed_from (exactly F) u n L M (c^~ k) (d K 0 k) K J = d J 0 k.
Proof.
move=> up down cells; rewrite /printed_from; case: leqP => le.
  rewrite -{2}(subnK le) /printed_up; elim: {-2}(J - K)%N (leqnn (J - K)) => [|j ih] lt_j; first by rewrite add0n.
  rewrite [LHS]/= ih ?(ltnW lt_j) // /printed_next /apart /=; have nz : M - u (j + K)%N != 0 by apply: up; lia.
  have /rowP/(_ k) : cell u n L M (fun i => \row_k c i k) d (j + K) by apply/cells/orP; left; lia.
  rewrite !mxE addSn => e; apply: (mulIf nz); rewrite divfK // [RHS]mulrC; move: e.
  by move: (d (j + K)%N 0 k) (d (j + K).+1 0 k) (u (j + K)%N) (u (j + K + n)%N) => x y a b e; rewrite e; ring.
rewrite -{2}(subKn (ltnW le)) /printed_down; elim: {-2}(K - J)%N (leqnn (K - J)) => [|j ih] lt_j; first by rewrite subn0.
rewrite [LHS]/= ih ?(ltnW lt_j) // /printed_next /apart /=.
have nz : u (K - j.+1 + n)%N - M != 0 by rewrite subr_eq0 eq_sym -subr_eq0; apply: down; lia.
have ej : (K - j = (K - j.+1).+1)%N by lia.
have /rowP/(_ k) : cell u n L M (fun i => \row_k c i k) d (K - j.+1) by apply/cells/orP; right; lia.
rewrite !mxE ej => e; apply: (mulIf nz); rewrite divfK //; move: e.
by move: (d (K - j.+1)%N 0 k) (d (K - j.+1).+1 0 k) (u (K - j.+1)%N) (u (K - j.+1 + n)%N) => x y a b e; rewrite e; ring.
Qed.
End Exact.
