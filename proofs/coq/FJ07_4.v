(* FJ07, section 4: a developable surface through a clamped curve with given end rulings, equations (20) and (21).
   The last vertex is c_L with L = K + 1.
   Definitions:
     aim u n c K M          the point a(M) of (20)
     factor u n K i         prod_{j < i} (X - u_j) prod_{i < j <= K} (X - u_{j+n})
     chord u n c K          sum_i factor_i (c_{i+1} - c_i): c_L - a(M) times prod_{j < K} (M - u_j), polynomials in M
     branches u n c K v w   the polynomial [chord, v, w] whose roots are the values M_0 *)
From Torse Require Import Prelude Blossom Curves Points Dependence FJ07_2 FJ07_3_net FJ21_4 FJ07_2_cones FJ07_3_generic.

Section LastRuling.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M : F) (n i K : nat).

Definition aim u n c K M : 'rV[F]_m := ((M - u K) / (M - u 0%N) * P u n M 1 K.+1) *: c 0%N
  + \sum_(1 <= i < K.+1) ((u (i + n)%N - u i.-1) / (M - u i.-1) * Q u n M i K.+1) *: c i.
Definition factor u n K i : {poly F} := \prod_(0 <= j < i) ('X - (u j)%:P) * \prod_(i.+1 <= j < K.+1) ('X - (u (j + n)%N)%:P).
Definition chord u n c K : 'rV[{poly F}]_m := \sum_(0 <= i < K.+1) factor u n K i *: fixed (c i.+1 - c i).

(** FJ07.20 last: $d_L-c_L=P(0,L)(d_0-c_0)+\frac{\Lambda^{*}-M^{*}}{M^{*}-u_{L-1}}(c_L-a(M^{*}))$.
    Hypotheses: $M^{*}$ is none of $u_0,\dots,u_{L-1}$, so that the quotients have a meaning. *)
Theorem FJ07_20_last u n L M c d K : (forall i, (i < K.+1)%N -> M - u i != 0) -> (forall i, (i < K.+1)%N -> cell u n L M c d i) ->
  d K.+1 - c K.+1 = P u n M 0 K.+1 *: (d 0%N - c 0%N) + ((L - M) / (M - u K)) *: (c K.+1 - aim u n c K M).
Proof. by move=> off cells; rewrite (FJ07_15_closed off cells (ltnSn K)) /aim opprD addrA. Qed.

Lemma aim_sum u n c K M : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  c K.+1 - aim u n c K M = (M - u K) *: \sum_(0 <= i < K.+1) (P u n M i.+1 K.+1 / (M - u i)) *: (c i.+1 - c i).
Proof.
move=> off; have nz := off K (ltnSn K); have [_ cells] := FJ07_13_exists n (M + 1) c (c 0%N) off.
have := FJ07_20_last off cells; rewrite (FJ07_16_closed off cells (leqnn _)) /= subrr scaler0 !add0r.
rewrite [M + 1]addrC addrK scale1r => ->; rewrite scalerA mulrA mulr1 mulfV // scale1r //.
Qed.

Lemma ev_sum (I : Type) (r : seq I) (f : I -> 'rV[{poly F}]_m) t : ev (\sum_(i <- r) f i) t = \sum_(i <- r) ev (f i) t.
Proof.
elim: r => [|i r ih]; first by rewrite !big_nil; apply/rowP=> k; rewrite !mxE horner0.
by rewrite !big_cons -ih; apply/rowP=> k; rewrite !mxE hornerD.
Qed.

(** FJ07.20 polynomial: $(c_L-a(M))\prod_{j<L-1}(M-u_j)=\sum_{i=0}^{L-1}(c_{i+1}-c_i)\prod_{j<i}(M-u_j)\prod_{i<j<L}(M-u_{j+n})$.
    Hypotheses: $M$ is none of $u_0,\dots,u_{L-1}$, so that $a(M)$ has a meaning. *)
Theorem FJ07_20_polynomial u n c K M : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  (\prod_(0 <= j < K) (M - u j)) *: (c K.+1 - aim u n c K M) = ev (chord u n c K) M.
Proof.
move=> off; rewrite aim_sum // scalerA /chord ev_sum -big_nat_recr //= scaler_sumr.
apply: eq_big_nat => i /andP[_ lt_i]; rewrite scalerA.
have -> : ev (factor u n K i *: fixed (c i.+1 - c i)) M = (factor u n K i).[M] *: (c i.+1 - c i).
  by apply/rowP=> k; rewrite !mxE hornerM hornerC.
congr (_ *: _); rewrite /factor hornerM !horner_prod.
have hX f a b : \prod_(a <= j < b) ('X - (f j : F)%:P).[M] = \prod_(a <= j < b) (M - f j).
  by apply: eq_bigr => j _; rewrite hornerXsubC.
rewrite !hX.
rewrite (big_cat_nat _ _ _ (leq0n i) (ltnW lt_i)) /= [\prod_(i <= _ < _) _]big_ltn // /P prodf_div.
have nz : \prod_(i.+1 <= j < K.+1) (M - u j) != 0.
  by rewrite prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota => /andP[_ lt_j]; apply: off.
move: nz (off i lt_i); move: (\prod_(i.+1 <= j < K.+1) (M - u j)) (\prod_(i.+1 <= j < K.+1) (M - u (j + n)%N)) (\prod_(0 <= j < i) _).
by move=> a b e a0 e0; field; rewrite a0 e0.
Qed.

Lemma factor_monic u n K i : factor u n K i \is monic.
Proof. by rewrite monicMl ?monic_prod_XsubC //; apply: monic_prod_XsubC. Qed.

Lemma size_factor u n K i : (i <= K)%N -> size (factor u n K i) = K.+1.
Proof.
move=> le_i; rewrite /factor size_monicM ?monic_prod_XsubC // ?monic_neq0 ?monic_prod_XsubC //.
by rewrite !size_prod_XsubC !size_iota; lia.
Qed.

(** FJ07.20 degree: that polynomial has degree at most $L-1$, with the coefficient $c_L-c_0$ of $M^{L-1}$. *)
Theorem FJ07_20_degree u n c K k :
  (size (chord u n c K 0%R k) <= K.+1)%N /\ (chord u n c K 0 k)`_K = (c K.+1 - c 0%N) 0 k.
Proof.
have eq_k : chord u n c K 0 k = \sum_(0 <= i < K.+1) ((c i.+1 - c i) 0 k) *: factor u n K i.
  rewrite /chord summxE; apply: eq_big_nat => i _; rewrite -mul_polyC mulrC.
  by rewrite [LHS]mxE; congr (_ * _); rewrite /fixed [LHS]mxE.
split.
  rewrite eq_k; apply: leq_trans (size_sum _ _ _) _; apply/bigmax_leqP_seq => i; rewrite mem_index_iota => /andP[_ lt_i] _.
  by rewrite (leq_trans (size_scale_leq _ _)) // size_factor.
rewrite eq_k coef_sum -(telescope_sumr c (leq0n K.+1)) summxE; apply: eq_big_nat => i /andP[_ lt_i].
by rewrite coefZ; have := monicP (factor_monic u n K i); rewrite lead_coefE size_factor // => ->; rewrite mulr1.
Qed.
End LastRuling.

Section Interpolation.
Variable F : fieldType.
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_3) (v w x : 'rV[F]_3) (L M sigma tau alpha beta : F) (n i K : nat).

Definition branches u n c K v w : {poly F} := triple (chord u n c K) (fixed v) (fixed w).

Lemma ev_triple (p q r : 'rV[{poly F}]_3) t : (triple p q r).[t] = triple (ev p t) (ev q t) (ev r t).
Proof. by coordinates; rewrite !hornerE. Qed.

Lemma ev_fixed v t : ev (fixed v) t = v.
Proof. by apply/rowP=> k; rewrite !mxE hornerC. Qed.

Lemma tripleZl (s : F) v w x : triple (s *: v) w x = s * triple v w x.
Proof. by coordinates; ring. Qed.

Lemma tripleN v w x : triple (- v) w x = - triple v w x.
Proof. by coordinates; ring. Qed.

(** FJ07.20 branches: $[a(M)-c_L,v,w]=0$ iff $M$ is a root of the polynomial $[\sum_i(c_{i+1}-c_i)\prod\dots,v,w]$.
    Hypotheses: $M$ is none of $u_0,\dots,u_{L-1}$, so that $a(M)$ has a meaning. *)
Theorem FJ07_20_branches u n c K v w M : (forall i, (i < K.+1)%N -> M - u i != 0) ->
  triple (aim u n c K M - c K.+1) v w = 0 <-> root (branches u n c K v w) M.
Proof.
move=> off; rewrite /root /branches ev_triple !ev_fixed -FJ07_20_polynomial // tripleZl -opprB tripleN mulf_eq0.
have -> : (\prod_(0 <= j < K) (M - u j) == 0) = false.
  apply/negbTE; rewrite prodf_seq_neq0; apply/allP=> j; rewrite mem_index_iota => /andP[_ lt_j].
  by apply: off; apply: ltnW.
by split=> [/eqP|/eqP ->]; rewrite ?oppr0 // oppr_eq0.
Qed.

(** FJ07.20 count: its degree is at most $L-1$, with the coefficient $[c_L-c_0,v,w]$ of $M^{L-1}$, which is 0 where the lines through $c_0$
    along $v$ and through $c_L$ along $w$ meet or are parallel. *)
Theorem FJ07_20_count u n c K v w : (size (branches u n c K v w) <= K.+1)%N /\
  (branches u n c K v w)`_K = triple (c K.+1 - c 0%N) v w.
Proof.
have sz j : (size (chord u n c K 0%R j) <= K.+1)%N by case: (FJ07_20_degree u n c K j).
have co j : (chord u n c K 0 j)`_K = (c K.+1 - c 0%N) 0 j by case: (FJ07_20_degree u n c K j).
have eq_b : branches u n c K v w = (x_ (cross v w)) *: x_ (chord u n c K) + (y_ (cross v w)) *: y_ (chord u n c K)
    + (z_ (cross v w)) *: z_ (chord u n c K).
  rewrite /branches tripleE /cross /vec -!mul_polyC /x_ /y_ /z_ !mxE /= !polyCB !polyCM; ring.
rewrite eq_b; split.
  rewrite (leq_trans (size_add _ _)) // geq_max (leq_trans (size_add _ _)) ?geq_max.
    by rewrite (leq_trans (size_scale_leq _ _)) //; apply: sz.
  by rewrite !(leq_trans (size_scale_leq _ _)) //; apply: sz.
rewrite !coefD !coefZ /x_ /y_ /z_ !co; move: (c K.+1 - c 0%N) => e; coordinates; ring.
Qed.

(** FJ07.20 finite: for skew end rulings there are at most $L-1$ values $M_0$, whatever the degree and the number of pieces.
    Hypotheses: $[c_L-c_0,v,w]\ne0$. *)
Theorem FJ07_20_finite u n c K v w (values : seq F) : triple (c K.+1 - c 0%N) v w != 0 -> uniq values ->
  all (root (branches u n c K v w)) values -> (size values <= K)%N.
Proof.
move=> skew un roots; have [sz co] := FJ07_20_count u n c K v w; rewrite -ltnS; apply: leq_trans sz.
apply: max_poly_roots => //; apply: contra_neq skew => z; by rewrite -co z coef0.
Qed.
End Interpolation.
