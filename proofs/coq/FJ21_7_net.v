(* FJ21, section 7: constant Lam, M, sigma: the full polar form and the net. *)
From Torse Require Import Prelude Blossom Curves Points Functions FJ07_3_net FJ07_3_blossoms FJ07_2 FJ21_7 FJ21_3.

Section Net.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m) (L M s : F) (n : nat).

Lemma pblossom_scale u s d v : pblossom u (fun i => s *: d i) v = s *: pblossom u d v.
Proof.
apply/rowP=> k; rewrite !mxE -[RHS]addr0 -[X in _ + X](mul0r (blossom u (coord d k) v)) -blossom_linear.
by apply: blossom_ext => i _; rewrite /coord mxE mul0r addr0.
Qed.

(** FJ21.7.1 cells: $p[t_1,\dots,t_{n-1},\Lambda]=\sigma q[t_1,\dots,t_{n-1},M]$ for all $t_i$ iff
    $(u_{j+n}-\Lambda)p_j+(\Lambda-u_j)p_{j+1}=\sigma\bigl((u_{j+n}-M)q_j+(M-u_j)q_{j+1}\bigr)$ for $j=0..n-1$.
    Hypotheses: the knots carry the piece, so that the blossoms have a meaning. $\sigma$ may be 0 and $M$ a knot. *)
Theorem FJ21_7_1_cells u n L M s c d : span n u ->
  (forall v, (size v).+1 = n -> pblossom u c (at_ L :: v) = s *: pblossom u d (at_ M :: v)) <->
  forall j, (j < n)%N -> (u (j + n)%N - L) *: c j + (L - u j) *: c j.+1 = s *: ((u (j + n)%N - M) *: d j + (M - u j) *: d j.+1).
Proof.
move=> sp; have := FJ07_T1_piece L M c (fun i => s *: d i) sp; rewrite /related /cell => piece.
have e j : s *: ((u (j + n)%N - M) *: d j + (M - u j) *: d j.+1) = (u (j + n)%N - M) *: (s *: d j) + (M - u j) *: (s *: d j.+1).
  by rewrite scalerDr !scalerA ![s * _]mulrC.
split=> [h j lt_j|h v sz]; last by rewrite -pblossom_scale; apply: (iffRL piece) => // j lt_j; rewrite h // e.
by rewrite e; apply: (iffLR piece) => // v sz; rewrite pblossom_scale h.
Qed.

(** FJ21.7.1 weights: for rows $p_j=w_j(1,c_j)$, $q_j=\omega_j(1,d_j)$ the net is $(1-\Lambda)w_j+\Lambda w_{j+1}=\sigma\bigl((1-M)\omega_j+M\omega_{j+1}\bigr)$ for the
    weights and $(1-\Lambda)w_jc_j+\Lambda w_{j+1}c_{j+1}=\sigma\bigl((1-M)\omega_jd_j+M\omega_{j+1}d_{j+1}\bigr)$ for the points. *)
Theorem FJ21_7_1_weights (w omega : nat -> F) (a b : nat -> 'rV[F]_3) (p q : nat -> 'rV[F]_4) L M s j :
  (forall i, weight (p i) = w i /\ place (p i) = w i *: a i) -> (forall i, weight (q i) = omega i /\ place (q i) = omega i *: b i) ->
  (1 - L) *: p j + L *: p j.+1 = s *: ((1 - M) *: q j + M *: q j.+1) <->
  (1 - L) * w j + L * w j.+1 = s * ((1 - M) * omega j + M * omega j.+1) /\
  (1 - L) *: (w j *: a j) + L *: (w j.+1 *: a j.+1) = s *: ((1 - M) *: (omega j *: b j) + M *: (omega j.+1 *: b j.+1)).
Proof.
move=> ep eq; have [[<- <-] [<- <-]] := (ep j, ep j.+1); have [[<- <-] [<- <-]] := (eq j, eq j.+1); rewrite /weight.
split=> [/rowP e|[e0 /rowP e]]; first by split; [have := e 0; rewrite !mxE | apply/rowP=> k; have := e (lift ord0 k); rewrite !mxE].
by apply/rowP=> k; case: (unliftP ord0 k) => [k'|] ->; [have := e k'; rewrite !mxE | rewrite !mxE].
Qed.

(** FJ21.7.1 bezier: on $[0,1]$ the net is $(1-\Lambda)p_j+\Lambda p_{j+1}=\sigma\bigl((1-M)q_j+Mq_{j+1}\bigr)$, $j=0..n-1$. *)
Theorem FJ21_7_1_bezier n L M s c d :
  (forall v, (size v).+1 = n -> pblossom (step01 F n) c (at_ L :: v) = s *: pblossom (step01 F n) d (at_ M :: v)) <->
  forall j, (j < n)%N -> (1 - L) *: c j + L *: c j.+1 = s *: ((1 - M) *: d j + M *: d j.+1).
Proof.
rewrite FJ21_7_1_cells; last exact: span_step01.
by split=> h j lt_j; have := h j lt_j; rewrite /step01 leq_addl leqNgt lt_j /= !subr0.
Qed.

(** FJ21.7.1 diagonal: $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$ as polynomials in $t$ implies $p[t_1,\dots,t_{n-1},\Lambda]=\sigma q[t_1,\dots,t_{n-1},M]$ for all
    $t_i$, and conversely.
    Hypotheses: $(n-1)!\ne0$ in the field; $n>0$ and the knots carry the piece, so that there is an argument for $\Lambda$ and the blossoms have a meaning.
    Paper: does not say that the characteristic matters. *)
Theorem FJ21_7_1_diagonal u n L M s c d : (n.-1)`!%:R != 0 :> F -> (0 < n)%N -> span n u ->
  last_point n u c L = s%:P *: last_point n u d M <->
  (forall v, (size v).+1 = n -> pblossom u c (at_ L :: v) = s *: pblossom u d (at_ M :: v)).
Proof.
case: n => // n nz _ sp.
have lift (e : nat -> F) x : blossom (polys u) (polys e) (at_ x%:P :: nseq n (at_ 'X)) = curve n (shift u) (step u n.+1 (at_ x) e).
  rewrite /curve /= size_nseq; apply: blossom_ext => i _.
  by rewrite /polys /step /= polyCM -polyCV !(polyCB, polyCD, polyCM).
have scale_curve (e : nat -> F) k : s%:P * curve k (shift u) e = curve k (shift u) (fun i => s * e i).
  have := curve_comb k (shift u) s 0 e e; rewrite polyC0 mul0r addr0 => <-.
  by apply: blossom_ext => i _; rewrite /polys mul0r addr0.
split=> [/rowP e v [sz]|h].
  apply/rowP=> k; have := e k; rewrite !mxE !lift scale_curve => /(FJ21_7_1_polarisation nz (span_shift sp)) eq_i.
  rewrite /= sz (@blossom_ext _ _ _ (fun i => s * step u n.+1 (at_ M) (coord d k) i + 0 * step u n.+1 (at_ M) (coord d k) i)).
    by rewrite blossom_linear mul0r addr0.
  by move=> i; rewrite sz => le_i; rewrite mul0r addr0 eq_i.
apply/rowP=> k; rewrite !mxE !lift scale_curve; apply: blossom_ext => i; rewrite size_nseq => le_i; rewrite /polys; congr (_%:P).
rewrite -(blossoms_knots (step u n.+1 (at_ L) (coord c k)) (span_shift sp) le_i) -(blossoms_knots (step u n.+1 (at_ M) (coord d k)) (span_shift sp) le_i).
by have /rowP/(_ k) := h (knots (shift u) i n) (congr1 S (size_knots _ _ _)); rewrite !mxE /= size_knots.
Qed.

(** FJ21.7.1 spline: on a spline of $N$ pieces the relation holds on every piece that is not empty, with the same $\Lambda,M,\sigma$, iff the net equations hold for
    $j=0..n+N-2$.
    Hypotheses: every cell belongs to a piece that is not empty, as when no knot is more than $n$-fold and the first and the last piece are not
    empty; this serves the direction from blossoms to the net only. *)
Theorem FJ21_7_1_spline u n L M s c d N :
  (forall i, (i < n + N.-1)%N -> exists k, [/\ (k < N)%N, (k <= i < k + n)%N & span n (drop_ k u)]) ->
  (forall k, (k < N)%N -> span n (drop_ k u) -> forall v, (size v).+1 = n ->
    pblossom (drop_ k u) (drop_ k c) (at_ L :: v) = s *: pblossom (drop_ k u) (drop_ k d) (at_ M :: v)) <->
  (forall j, (j < n + N.-1)%N -> (u (j + n)%N - L) *: c j + (L - u j) *: c j.+1 = s *: ((u (j + n)%N - M) *: d j + (M - u j) *: d j.+1)).
Proof.
move=> cover; have := FJ07_C2_spans L M c (fun i => s *: d i) cover; rewrite /related /cell => spans.
have e j : s *: ((u (j + n)%N - M) *: d j + (M - u j) *: d j.+1) = (u (j + n)%N - M) *: (s *: d j) + (M - u j) *: (s *: d j.+1).
  by rewrite scalerDr !scalerA ![s * _]mulrC.
split=> [h j lt_j|h k lt_k sp v sz].
  by rewrite e; apply: (iffLR spans) => // k lt_k sp v sz; rewrite pblossom_scale h.
by rewrite -pblossom_scale; apply: (iffRL spans) => // j lt_j; rewrite h // e.
Qed.

(** FJ21.7.1 needs_factorial: in characteristic 2 the points 0, 1, 0 of degree 2 belong to the polynomial $2t(1-t)=0$: the diagonal form
    determines neither the points nor the polar form.
    Hypotheses: $2=0$ in the field. *)
Theorem FJ21_7_1_needs_factorial (c := fun i => (i == 1%N)%:R : F) : 2%:R = 0 :> F ->
  span 2 (step01 F 2) /\ curve 2 (step01 F 2) c = curve 2 (step01 F 2) (fun=> 0) /\ c 1%N <> 0.
Proof.
move=> two; split; first exact: span_step01.
split; last by move=> /eqP; rewrite /c oner_eq0.
rewrite [RHS](_ : _ = 0); last by exact: (blossom0 (polys (step01 F 2))).
have t0 (x : {poly F}) : x + x = 0 by rewrite -mulr2n -mulr_natr -(rmorph_nat [rmorphism of @polyC F]) /= two mulr0.
rewrite /curve /= /step /polys /step01 /c /shift /= !polyC0 !polyC1 !subr0 !divr1.
by rewrite !mul1r !mulr1 !mulr0 add0r addr0 !subr0 [(1 - 'X) * _]mulrC t0.
Qed.
End Net.
