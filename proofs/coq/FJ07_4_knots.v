(* FJ07, section 4, where a root of equation (20) is an end knot: which of them are surfaces. *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_net FJ07_3_vertices FJ21_4 FJ07_2_cones FJ07_4.

Section Ends.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (v w y : 'rV[F]_3) (L M s : F) (n i K : nat).

(** FJ07.20 first_knot: at $M^{*}=u_0$ the first ruling runs along the first side of the polygon, $d_0-c_0=\frac{\Lambda^{*}-u_0}{u_n-u_0}(c_1-c_0)$.
    Hypotheses: $u_n\ne u_0$. *)
Theorem FJ07_20_first_knot u n L c d : u n - u 0%N != 0 ->
  cell u n L (u 0%N) c d 0 <-> d 0%N - c 0%N = ((L - u 0%N) / (u n - u 0%N)) *: (c 1%N - c 0%N).
Proof.
move=> w0; rewrite FJ07_13_rulings add0n subrr scale0r; split=> [e|->]; last by by_entries k; field.
apply: (scalerI w0); apply/eqP; rewrite -subr_eq0; apply/eqP; rewrite -[RHS]oppr0 e.
by move: (d 0%N - c 0%N) (c 1%N - c 0%N) => a b; by_entries k; field.
Qed.

(** FJ07.20 last_knot: at $M^{*}=u_{L+n-1}$ the last ruling runs along the last side, $d_L-c_L=\frac{\Lambda^{*}-M^{*}}{M^{*}-u_{L-1}}(c_L-c_{L-1})$.
    Hypotheses: $u_{L+n-1}\ne u_{L-1}$. *)
Theorem FJ07_20_last_knot u n L c d K (M := u (K + n)%N) : M - u K != 0 ->
  cell u n L M c d K <-> d K.+1 - c K.+1 = ((L - M) / (M - u K)) *: (c K.+1 - c K).
Proof.
move=> w0; rewrite FJ07_13_rulings subrr scale0r add0r; split=> [e|->]; last by rewrite scalerA mulrC divfK.
by apply: (scalerI w0); rewrite e scalerA mulrC divfK.
Qed.

(** FJ07.20 end_roots: $u_0$ is a root of the polynomial of (20) iff $[c_1-c_0,v,w]=0$, and $u_{L+n-1}$ iff $[c_L-c_{L-1},v,w]=0$.
    Hypotheses: $u_0$ is none of $u_{n+1},\dots,u_{L+n-1}$, and $u_{L+n-1}$ none of $u_0,\dots,u_{L-2}$, as for a clamped curve with inner knots. *)
Theorem FJ07_20_end_roots u n c K v w :
  ((forall j, (0 < j <= K)%N -> u 0%N - u (j + n)%N != 0) -> root (branches u n c K v w) (u 0%N) <-> triple (c 1%N - c 0%N) v w = 0) /\
  ((forall j, (j < K)%N -> u (K + n)%N - u j != 0) -> root (branches u n c K v w) (u (K + n)%N) <-> triple (c K.+1 - c K) v w = 0).
Proof.
have evf i M : ev (factor u n K i *: fixed (c i.+1 - c i)) M = (factor u n K i).[M] *: (c i.+1 - c i).
  by apply/rowP=> k; rewrite !mxE hornerM hornerC.
have hX f a b M : (\prod_(a <= j < b) ('X - (f j : F)%:P)).[M] = \prod_(a <= j < b) (M - f j).
  by rewrite horner_prod; apply: eq_bigr => j _; rewrite hornerXsubC.
have nz a b (f : nat -> F) : (forall j, (a <= j < b)%N -> f j != 0) -> \prod_(a <= j < b) f j != 0.
  by move=> h; rewrite prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota => /h.
have scale f (x : 'rV[F]_3) : f != 0 -> triple (f *: x) v w == 0 <-> triple x v w = 0.
  by move=> f0; rewrite tripleZl mulf_eq0 (negPf f0) /=; split=> [/eqP|->].
rewrite /root /branches !ev_triple !ev_fixed /chord !ev_sum; split=> off.
  rewrite big_ltn // big_nat_cond big1 => [|i /andP[/andP[lt_i _] _]]; last first.
    by rewrite evf /factor hornerM hX big_ltn // subrr !mul0r scale0r.
  by rewrite addr0 evf; apply: scale; rewrite /factor hornerM !hX big_geq // mul1r nz.
rewrite big_nat_recr //= big_nat_cond big1 => [|i /andP[/andP[_ lt_i] _]]; last first.
  by rewrite evf /factor hornerM !hX (big_nat_recr K) //= subrr !mulr0 scale0r.
by rewrite add0r evf; apply: scale; rewrite /factor hornerM !hX [\prod_(K.+1 <= _ < _) _]big_geq // mulr1 nz.
Qed.

(** FJ07.21 first_knot: for $M_0=u_0$ and $\Lambda^{*}\ne M_0$ there is a net of (13) with the first ruling along $v$ and the last along $w$ iff the first side of the
    polygon is along $v$, $c_1-c_0=sv$; then the last ruling may be any vector $y$.
    Hypotheses: $u_0$ is none of $u_n,\dots,u_{L+n-1}$, as for a clamped curve.
    Paper: excludes no root; $[c_1-c_0,v,w]=0$ alone makes $u_0$ a root. *)
Theorem FJ07_21_first_knot u n L c K v w : (forall i, (i < K.+1)%N -> u 0%N - u (i + n)%N != 0) -> L != u 0%N ->
  ((exists d, [/\ forall i, (i < K.+1)%N -> cell u n L (u 0%N) c d i, exists s, d 0%N - c 0%N = s *: v & exists s, d K.+1 - c K.+1 = s *: w])
    <-> exists s, c 1%N - c 0%N = s *: v) /\
  ((exists s, c 1%N - c 0%N = s *: v) ->
    forall y, exists d, [/\ forall i, (i < K.+1)%N -> cell u n L (u 0%N) c d i, exists s, d 0%N - c 0%N = s *: v & d K.+1 - c K.+1 = y]).
Proof.
move=> off; rewrite -subr_eq0 => L0; have w0 : u n - u 0%N != 0 by rewrite -opprB oppr_eq0; apply: (off 0%N).
have make : (exists s, c 1%N - c 0%N = s *: v) ->
    forall y, exists d, [/\ forall i, (i < K.+1)%N -> cell u n L (u 0%N) c d i, exists s, d 0%N - c 0%N = s *: v & d K.+1 - c K.+1 = y].
  move=> [s es] y; have [|d [ed cells]] := @FJ07_13_vertex F 3 u n L (u 0%N) c (c K.+1 + y) K.+1 K.+1 (leqnn _) _ off.
    by move=> i /andP[h1 h2]; move: (leq_trans h2 h1); rewrite ltnn.
  exists d; split=> //; last by rewrite ed addrC addKr.
  by exists ((L - u 0%N) / (u n - u 0%N) * s); rewrite -scalerA -es; apply/FJ07_20_first_knot => //; apply: cells.
split=> //; split=> [[d [cells [s es] _]]|h].
  have /(FJ07_20_first_knot L c d w0) := cells 0%N (ltn0Sn _); rewrite es => e.
  exists ((u n - u 0%N) / (L - u 0%N) * s); by rewrite -scalerA e scalerA mulrA divfK // mulfV // scale1r.
by have [d [cells e0 ew]] := make h (0 *: w); exists d; split=> //; exists 0.
Qed.

(** FJ07.21 last_knot: for $M_0=u_{L+n-1}$ and $\Lambda^{*}\ne M_0$ there is a net of (13) with the first ruling along $v$ and the last along $w$ iff the last side of
    the polygon is along $w$; then the first ruling may be any vector $y$.
    Hypotheses: $u_{L+n-1}$ is none of $u_0,\dots,u_{L-1}$, as for a clamped curve. *)
Theorem FJ07_21_last_knot u n L c K v w (M := u (K + n)%N) : (forall i, (i < K.+1)%N -> M - u i != 0) -> L != M ->
  ((exists d, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, exists s, d 0%N - c 0%N = s *: v & exists s, d K.+1 - c K.+1 = s *: w])
    <-> exists s, c K.+1 - c K = s *: w) /\
  ((exists s, c K.+1 - c K = s *: w) ->
    forall y, exists d, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N - c 0%N = y & exists s, d K.+1 - c K.+1 = s *: w]).
Proof.
move=> off; rewrite -subr_eq0 => L0; have w0 : M - u K != 0 by apply: off.
have make : (exists s, c K.+1 - c K = s *: w) ->
    forall y, exists d, [/\ forall i, (i < K.+1)%N -> cell u n L M c d i, d 0%N - c 0%N = y & exists s, d K.+1 - c K.+1 = s *: w].
  move=> [s es] y; have [ed cells] := FJ07_13_exists n L c (c 0%N + y) off; exists (net u n L M c (c 0%N + y)); split=> //.
    by rewrite ed addrC addKr.
  by exists ((L - M) / (M - u K) * s); rewrite -scalerA -es; apply/FJ07_20_last_knot => //; apply: cells.
split=> //; split=> [[d [cells _ [s es]]]|h].
  have /(FJ07_20_last_knot L c d w0) := cells K (ltnSn _); rewrite es => e.
  exists ((M - u K) / (L - M) * s); by rewrite -scalerA e scalerA mulrA divfK // mulfV // scale1r.
by have [d [cells e0 ew]] := make h (0 *: v); exists d; split=> //; exists 0.
Qed.
End Ends.
