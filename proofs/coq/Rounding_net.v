(* The a-priori bound of the rounding errors of the construction FJ07.13.rulings, in the numbering of the papers.
   Definitions:
     upwards, downwards     what a computation along near_j, far_j and p_j is from the vertex K to later ones, and to earlier ones
     net_from ... K J       the coordinate of the vertex J that the library computes from the vertex K
     kept_vertex ...        the standard model holds for each operation that leads to the vertex N, if any does
     bound_up, bound_down   the terms of FJ07.16 from the vertex K to J, each in absolute value and times its gamma
     read val c i           the point c_i, the values of whose coordinates val gives *)
From Torse Require Import Prelude Points FJ07_3_net Rounding.
From mathcomp Require Import order ssrnum.
Import Order.TTheory Num.Theory.

Section Program.
Variables (T : Type) (A : arithmetic T) (u : nat -> T) (n : nat) (L M : T) (c : nat -> T) (d : T) (K : nat).

(* What a computation along the knots near_j, far_j and the read p_j is, going up from the vertex K or down from it. *)
Definition upwards (X : Type) (run : (nat -> T) -> (nat -> T) -> (nat -> T) -> X) :=
  run (fun j => u (j + K + n)%N) (fun j => u (j + K)%N) (fun j => c (j + K)%N).
Definition downwards (X : Type) (run : (nat -> T) -> (nat -> T) -> (nat -> T) -> X) :=
  run (fun j => u (K - j.+1)%N) (fun j => u (K - j.+1 + n)%N) (fun j => c (K - j)%N).
Definition net_from J := if (K <= J)%N then upwards (fun near far p => vertex A L M near far p d (J - K))
  else downwards (fun near far p => vertex A L M near far p d (K - J)).
End Program.

Lemma gamma_ge0 (F : realFieldType) (eps : F) k : 0 <= eps -> k%:R * eps < 1 -> 0 <= gamma eps k.
Proof. by move=> e0 small; rewrite divr_ge0 ?mulr_ge0 ?ler0n // subr_ge0 ltW. Qed.

Section Vertex.
Variables (F : realFieldType) (T : Type) (A : arithmetic T) (val : T -> F) (eps : F).
Variables (L M : T) (near far p : nat -> T) (d : T) (N : nat).
Local Notation computed := (ruling A L M near far p d N).

Definition kept_vertex := (0 < N)%N -> kept A val eps L M near far p d N /\
  close eps (val (p N) + val computed) (val (plus A (p N) computed)).

Hypothesis eps_ge0 : 0 <= eps.
Hypothesis off : forall j, (j < N)%N -> val M - val (far j) != 0.

(** rounding vertex: $|\hat d_N-d_N|\le\varepsilon|d_N|+(1+\varepsilon)B_N$ for $d_N=p_N+r_N$, where $B_N$ is the bound of $|\hat r_N-r_N|$.
    Hypotheses: the operations keep the standard model; $(5N+1)\varepsilon<1$; $M^{*}\ne\mathit{far}_i$ for $i<N$. *)
Theorem rounding_vertex (r : nat -> F) : (5 * N + 1)%:R * eps < 1 -> r 0%N = val d - val (p 0%N) ->
  (forall j, (j < N)%N -> (val M - val (far j)) * r j.+1 = (val M - val (near j)) * r j + (val L - val M) * (val (p j.+1) - val (p j))) ->
  kept_vertex -> `|val (vertex A L M near far p d N) - (val (p N) + r N)|
    <= eps * `|val (p N) + r N| + (1 + eps) * spread val eps L M near far p d N.
Proof.
move=> small r0 rec kv; case: (posnP N) kv => [N0 _|pos [//|model h]].
  move: small; rewrite /spread N0 /vertex big_geq // r0 [_ + (_ - _)]addrC subrK subrr normr0 mulr0 addr0 => small.
  by do !first [exact: (gamma_ge0 eps_ge0 small) | apply: ler01 | apply: addr_ge0 | apply: mulr_ge0].
have hB := rounding_ruling eps_ge0 off model small r0 rec.
have -> : vertex A L M near far p d N = plus A (p N) computed by case: (N) pos.
move: (val (plus _ _ _)) (val computed) (val (p N)) (r N) (spread _ _ _ _ _ _ _ _ _) h hB {r0 rec} => y w v s B; rewrite /close => h hB.
have e1 : `|v + w| <= `|v + s| + B.
  rewrite (_ : v + w = v + s + (w - s)); last by ring.
  by apply: le_trans (ler_norm_add _ _) _; rewrite ler_add2l.
rewrite (_ : y - (v + s) = y - (v + w) + (w - s)); last by ring.
apply: le_trans (ler_norm_add _ _) _; rewrite mulrDl mul1r [B + _]addrC addrA -mulrDr.
by apply: ler_add => //; apply: le_trans h _; exact: ler_wpmul2l.
Qed.
End Vertex.

Section Bounds.
Variables (F : realFieldType) (eps : F) (u : nat -> F) (n : nat) (L M : F) (c : nat -> F) (d : F) (K J : nat).
Local Notation P := (P u n M).

Definition bound_up := gamma eps (5 * (J - K) + 1) * `|P K J| * `|d - c K|
  + `|L - M| * \sum_(K <= i < J) gamma eps (5 * (J - i) + 1) * `|P i.+1 J| * `|c i.+1 - c i| / `|M - u i|.
Definition bound_down := gamma eps (5 * (K - J) + 1) * `|(P J K)^-1| * `|d - c K|
  + `|L - M| * \sum_(J <= i < K) gamma eps (5 * (i.+1 - J) + 1) * `|(P J i)^-1| * `|c i.+1 - c i| / `|M - u (i + n)%N|.
End Bounds.

Lemma backwards (X : Type) (idx : X) (op : Monoid.com_law idx) (f : nat -> X) j J K : (J <= K)%N -> (j <= K - J)%N ->
  \big[op/idx]_(j <= i < K - J) f (K - i.+1)%N = \big[op/idx]_(J <= i < K - j) f i.
Proof.
have shift a b g : \big[op/idx]_(a <= i < b) g i = \big[op/idx]_(0 <= i < b - a) g (i + a)%N by rewrite -{1}[a]add0n big_addn.
move=> le_JK le_j; rewrite [RHS]big_nat_rev [LHS]shift [RHS]shift subnAC.
by apply: eq_big_nat => i lt_i; congr f; lia.
Qed.

Section Nets.
Variables (F : realFieldType) (T : Type) (A : arithmetic T) (val : T -> F) (eps : F) (m : nat).
Variables (u : nat -> T) (n : nat) (L M : T) (c : nat -> 'I_m -> T) (dK : 'I_m -> T) (d : nat -> 'rV[F]_m) (K J : nat).
Definition read i : 'rV[F]_m := \row_k val (c i k).
Local Notation v := (fun i => val (u i)).
Hypothesis eps_ge0 : 0 <= eps.
Hypothesis start : d K = \row_k val (dK k).

(** rounding net: the library's vertex $J\ge K$ from the vertex $K$ has in each coordinate an error of at most
    $\varepsilon|d_J|+(1+\varepsilon)\bigl(\gamma_{5(J-K)+1}|P(K,J)||d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=K}^{J-1}\gamma_{5(J-i)+1}|P(i+1,J)|\frac{|c_{i+1}-c_i|}{|M^{*}-u_i|}\bigr)$.
    Hypotheses: the operations keep the standard model; $(5(J-K)+1)\varepsilon<1$; $M^{*}$ is none of $u_K,\dots,u_{J-1}$. *)
Theorem rounding_net k : (K <= J)%N -> (5 * (J - K) + 1)%:R * eps < 1 ->
  (forall i, (K <= i < J)%N -> val M - v i != 0) -> (forall i, (K <= i < J)%N -> cell v n (val L) (val M) read d i) ->
  upwards u n (c^~ k) K (fun near far p => kept_vertex A val eps L M near far p (dK k) (J - K)) ->
  `|val (net_from A u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_up eps v n (val L) (val M) (fun i => val (c i k)) (val (dK k)) K J.
Proof.
move=> le_KJ small off cells; rewrite /net_from le_KJ /upwards => model.
have at_J : (J - K + K)%N = J by rewrite subnK.
have range j : (j < J - K)%N -> (K <= j + K < J)%N by lia.
have := rounding_vertex (r := fun j => d (j + K)%N 0 k - val (c (j + K)%N k)) eps_ge0 _ small _ _ model.
have e : val (c J k) + (d J 0 k - val (c J k)) = d J 0 k by rewrite addrC subrK.
rewrite /= at_J e => h; apply: le_trans (h _ _ _) _ => {h} [j lt_j||j lt_j|].
- exact: off (range j lt_j).
- by rewrite add0n start mxE.
- have := cells _ (range j lt_j); rewrite FJ07_13_rulings => /rowP/(_ k); rewrite !mxE.
  by rewrite addSn addnAC => ->.
rewrite le_eqVlt (_ : spread _ _ _ _ _ _ _ _ _ = bound_up eps v n (val L) (val M) (fun i => val (c i k)) (val (dK k)) K J) ?eqxx //.
have eP i : across (fun j => val M - v (j + K + n)%N) (fun j => val M - v (j + K)%N) i (J - K) = P v n (val M) (i + K) J.
  by rewrite /P big_addn.
have eS (f : nat -> F) : \sum_(K <= i < J) f i = \sum_(0 <= i < J - K) f (i + K)%N by rewrite -{1}[K]add0n big_addn.
rewrite /spread /bound_up eS (eP 0%N); congr (_ + _ * _); apply: eq_big_nat => i _.
by rewrite (eP i.+1) subnDA subnAC.
Qed.

(** rounding net_down: the library's vertex $J\le K$ from the vertex $K$ has in each coordinate an error of at most
    $\varepsilon|d_J|+(1+\varepsilon)\bigl(\gamma_{5(K-J)+1}|P(J,K)|^{-1}|d_K-c_K|
    +|\Lambda^{*}-M^{*}|\sum_{i=J}^{K-1}\gamma_{5(i+1-J)+1}|P(J,i)|^{-1}\frac{|c_{i+1}-c_i|}{|M^{*}-u_{i+n}|}\bigr)$.
    Hypotheses: the operations keep the standard model; $(5(K-J)+1)\varepsilon<1$; $M^{*}$ is none of $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_net_down k : (J <= K)%N -> (5 * (K - J) + 1)%:R * eps < 1 ->
  (forall i, (J <= i < K)%N -> val M - v (i + n)%N != 0) -> (forall i, (J <= i < K)%N -> cell v n (val L) (val M) read d i) ->
  downwards u n (c^~ k) K (fun near far p => kept_vertex A val eps L M near far p (dK k) (K - J)) ->
  `|val (net_from A u n L M (c^~ k) (dK k) K J) - d J 0 k|
    <= eps * `|d J 0 k| + (1 + eps) * bound_down eps v n (val L) (val M) (fun i => val (c i k)) (val (dK k)) K J.
Proof.
move=> le_JK small off cells model.
have -> : net_from A u n L M (c^~ k) (dK k) K J = downwards u n (c^~ k) K (fun near far p => vertex A L M near far p (dK k) (K - J)).
  by rewrite /net_from; case: ltngtP le_JK => // -> _; rewrite /upwards /downwards subnn.
have at_J : (K - (K - J))%N = J by rewrite subKn.
have range j : (j < K - J)%N -> (J <= K - j.+1 < K)%N by lia.
move: model; rewrite /downwards => model.
have := rounding_vertex (r := fun j => d (K - j)%N 0 k - val (c (K - j)%N k)) eps_ge0 _ small _ _ model.
have e : val (c J k) + (d J 0 k - val (c J k)) = d J 0 k by rewrite addrC subrK.
rewrite /= at_J e => h; apply: le_trans (h _ _ _) _ => {h} [j lt_j||j lt_j|].
- exact: off (range j lt_j).
- by rewrite subn0 start mxE.
- have := cells _ (range j lt_j); rewrite FJ07_13_rulings => /rowP/(_ k); rewrite !mxE -subSn ?subSS; last by lia.
  by move=> ->; rewrite -addrA -mulrDr addrA subrK subrr mulr0 addr0.
rewrite le_eqVlt (_ : spread _ _ _ _ _ _ _ _ _ = bound_down eps v n (val L) (val M) (fun i => val (c i k)) (val (dK k)) K J) ?eqxx //.
have eP j : (j <= K - J)%N ->
    across (fun j => val M - v (K - j.+1)%N) (fun j => val M - v (K - j.+1 + n)%N) j (K - J) = (P v n (val M) J (K - j))^-1.
  move=> le_j; rewrite /P -prodfV -backwards //; apply: eq_bigr => i _.
  by rewrite invf_div.
have rev (g : nat -> F) : \sum_(J <= i < K) g i = \sum_(0 <= i < K - J) g (K - i.+1)%N by rewrite backwards ?subn0.
rewrite /spread /bound_down (eP 0%N) // subn0 rev; congr (_ + _ * _); apply: eq_big_nat => i /andP[_ lt_i].
have -> : (K - i.+1).+1 = (K - i)%N by lia.
by rewrite eP // subnAC [`|_ - val (c (K - i)%N k)|]distrC.
Qed.
End Nets.

Section Sense.
Variables (F : realFieldType) (m : nat) (u : nat -> F) (n : nat) (L M : F) (c : nat -> 'I_m -> F) (d : nat -> 'rV[F]_m).

(** rounding exact: without rounding errors the library's recursion gives the row (13), upwards and downwards from any of its vertices.
    Hypotheses: $M^{*}$ is none of $u_K,\dots,u_{J-1}$, or for $J<K$ none of $u_{J+n},\dots,u_{K-1+n}$. *)
Theorem rounding_exact K J k : (forall i, (K <= i < J)%N -> M - u i != 0) -> (forall i, (J <= i < K)%N -> M - u (i + n)%N != 0) ->
  (forall i, (K <= i < J)%N || (J <= i < K)%N -> cell u n L M (read id c) d i) ->
  net_from (exactly F) u n L M (c^~ k) (d K 0 k) K J = d J 0 k.
Proof.
have same (x : F) : close 0 x x by rewrite /close subrr normr0 mul0r.
have same' (x : F) : rounded 0 x x by left.
have start : d K = \row_k d K 0 k by apply/rowP=> i; rewrite mxE.
have none (B x y : F) : `|x - y| <= 0 * `|y| + (1 + 0) * B -> B = 0 -> x = y.
  by move=> h B0; apply/eqP; rewrite -subr_eq0 -normr_le0; move: h; rewrite B0 mul0r mulr0 addr0.
have gamma0 i : gamma (0 : F) i = 0 by rewrite /gamma mulr0 mul0r.
have kept0 near far p x N : kept_vertex (exactly F) id 0 L M near far p x N.
  by move=> _; split=> [|//]; split=> [//|//|j _]; split=> [//|//|//|//|]; split=> [//|]; left.
have small i : i%:R * 0 < (1 : F) by rewrite mulr0 ltr01.
move=> up down cells; have [le|/ltnW le] := leqP K J.
- apply: (none (bound_up 0 u n L M (c^~ k) (d K 0 k) K J)).
    by apply: (rounding_net (A := exactly F) (val := id) (c := c) (lexx 0) start le (small _) up _ (kept0 _ _ _ _ _)) => i r; apply: cells; rewrite r.
  by rewrite /bound_up !gamma0 !mul0r add0r big1 ?mulr0 // => i _; rewrite gamma0 !mul0r.
apply: (none (bound_down 0 u n L M (c^~ k) (d K 0 k) K J)).
  by apply: (rounding_net_down (A := exactly F) (val := id) (c := c) (lexx 0) start le (small _) down _ (kept0 _ _ _ _ _)) => i r; apply: cells; rewrite r orbT.
by rewrite /bound_down !gamma0 !mul0r add0r big1 ?mulr0 // => i _; rewrite gamma0 !mul0r.
Qed.

(** rounding needs_small: where $k\varepsilon>1$, $\gamma_k$ is negative and bounds no error at all. *)
Theorem rounding_needs_small (eps t : F) k : 1 < k%:R * eps -> gamma eps k < `|t - 1|.
Proof.
move=> large; apply: lt_le_trans (normr_ge0 _).
by rewrite /gamma pmulr_rlt0 ?invr_lt0 ?subr_lt0 // (lt_trans ltr01).
Qed.
End Sense.
