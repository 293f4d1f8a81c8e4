(* FJ07, section 2: cones, equations (5) and (6).
   Definitions:
     fixed a                the constant curve at the point a
     ruled C D v            the curve (1 - v) C + v D on the surface, v a number or a function of the parameter
     proportional al c d K  d_{i+1} - d_i = al (c_{i+1} - c_i) for i < K, equation (6)
     vertex al c d          the point (al c_0 - d_0) / (al - 1) *)
From Torse Require Import Prelude Blossom Curves Points Bernstein Bezier BZZ19_4 Segments FJ07_2.

Section Combinations.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (a : 'rV[F]_m) (c d w : nat -> 'rV[F]_m) (n i : nat) (s k : F).

Definition fixed a : 'rV[{poly F}]_m := map_mx polyC a.
Definition ruled (C D : 'rV[{poly F}]_m) v : 'rV[{poly F}]_m := (1 - v) *: C + v *: D.

Lemma pcurve_comb n u (s t : F) c d :
  pcurve n u (fun i => s *: c i + t *: d i) = s%:P *: pcurve n u c + t%:P *: pcurve n u d.
Proof.
apply/rowP=> k; rewrite !mxE -curve_comb; apply: blossom_ext => i _.
by rewrite /polys /coord !mxE.
Qed.

Lemma pcurve_ext n u c d : (forall i, (i <= n)%N -> c i = d i) -> pcurve n u c = pcurve n u d.
Proof.
move=> eq_cd; apply/rowP=> k; rewrite !mxE; apply: blossom_ext => i; rewrite size_nseq => le_i.
by rewrite /polys /coord eq_cd.
Qed.

Lemma pcurve_fixed n u a : span n u -> pcurve n u (fun=> a) = fixed a.
Proof.
move=> sp; apply/rowP=> k; rewrite !mxE -(curve_const _ sp); apply: blossom_ext => i _.
by rewrite /polys /coord.
Qed.

Lemma pcurve_move n u a k w : span n u ->
  pcurve n u (fun i => a + k *: w i) = fixed a + k%:P *: pcurve n u w.
Proof.
move=> sp; rewrite -(pcurve_fixed a sp) -[pcurve n u (fun=> a)]scale1r -polyC1 -pcurve_comb.
by apply: pcurve_ext => i _; rewrite scale1r.
Qed.
End Combinations.

Section Cone.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (a : 'rV[F]_m) (c d w : nat -> 'rV[F]_m) (n i K : nat) (k al : F) (v : {poly F}).

(** FJ07.5 cone: for $c=a+kw$, $d=a+(k+1)w$: $b(t,v)=a+(v+k)w(t)$, so that every ruling passes through $a=b(t,-k)$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_5_cone n u a k w v (c := fun i => a + k *: w i) (d := fun i => a + (k + 1) *: w i) : span n u ->
  ruled (pcurve n u c) (pcurve n u d) v = fixed a + (v + k%:P) *: pcurve n u w.
Proof.
move=> sp; rewrite /c /d !pcurve_move // /ruled polyCD; move: (fixed a) (pcurve n u w) => A W.
by by_entries j; ring.
Qed.

(** FJ07.5 vertex: all rulings pass through $a$ at the same $v=-k$ iff $c_i=a+kw_i$ with $w_i=d_i-c_i$, $i=0..n$, that is $c=a+kw$,
    $d=a+(k+1)w$.
    Hypotheses: the knots carry the piece, so that its points have a meaning; no $C(n,i)$ vanishes in the field, as in characteristic 0, for the direction from the surface to the net. *)
Theorem FJ07_5_vertex n u a k c d : independent F n -> span n u ->
  ruled (pcurve n u c) (pcurve n u d) (- k)%:P = fixed a <-> forall i, (i <= n)%N -> c i = a + k *: (d i - c i).
Proof.
move=> nz sp; have -> : ruled (pcurve n u c) (pcurve n u d) (- k)%:P = pcurve n u (fun i => (1 + k) *: c i + (- k) *: d i).
  by rewrite pcurve_comb /ruled polyCN polyCD opprK.
rewrite -(pcurve_fixed a sp); split=> [/(pcurve_inj nz sp) eq_a i le_i | eq_c].
  by rewrite -(eq_a i le_i); by_entries j; ring.
apply: pcurve_ext => i /eq_c /(canLR (addrK _)) <-; move: (c i) (d i) => p q.
by by_entries j; ring.
Qed.

Definition proportional al c d K := forall i, (i < K)%N -> d i.+1 - d i = al *: (c i.+1 - c i).
Definition vertex al c d := (al - 1)^-1 *: (al *: c 0%N - d 0%N).

(** FJ07.6 vertex: $d_i-d_{i-1}=\alpha(c_i-c_{i-1})$, $i=1..L$, iff $d_i-a=\alpha(c_i-a)$, $i=0..L$, with $a=(\alpha c_0-d_0)/(\alpha-1)$: the
    rows are the same but for a change of scale by $\alpha$ from $a$.
    Hypotheses: $\alpha\ne1$, so that $a$ has a meaning. *)
Theorem FJ07_6_vertex al c d K (a := vertex al c d) : al - 1 != 0 ->
  proportional al c d K <-> forall i, (i <= K)%N -> d i - a = al *: (c i - a).
Proof.
move=> nz; split=> [sides | scale i lt_i]; last first.
  have := scale i.+1 lt_i; have := scale i (ltnW lt_i); move: (a) => b.
  move=> /(canRL (subrK _)) -> /(canRL (subrK _)) ->; by_entries j; ring.
elim=> [_|i ih lt_i].
  by rewrite /a /vertex; by_entries j; field.
have := sides i lt_i => /(canRL (subrK _)) ->; rewrite -addrA ih 1?ltnW //.
by move: (a) => b; by_entries j; ring.
Qed.

(** FJ07.6 unique: no other point will do, so that all pieces of a spline have the same vertex.
    Hypotheses: $\alpha\ne1$. *)
Theorem FJ07_6_unique al c d a : al - 1 != 0 -> d 0%N - a = al *: (c 0%N - a) -> a = vertex al c d.
Proof.
move=> nz eq_a; apply: (scalerI nz); rewrite /vertex scalerA mulfV // scale1r.
by move: eq_a => /(canRL (subrK _)) ->; by_entries j; ring.
Qed.

(** FJ07.6 cone: proportional sides give equation (5) with $k=1/(\alpha-1)$, that is $\alpha=1+1/k$: $b(t,v)=a+(v+k)(d(t)-c(t))$ on every
    piece; all rulings pass through $a$ at $v=-k$.
    Hypotheses: $\alpha\ne1$, so that $k$ has a meaning; the points of the piece are among $c_0,\dots,c_L$; the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_6_cone al c d K n j u v (k := (al - 1)^-1) (C := pcurve n (drop_ j u) (drop_ j c))
    (D := pcurve n (drop_ j u) (drop_ j d)) : al - 1 != 0 -> (j + n <= K)%N -> span n (drop_ j u) ->
  proportional al c d K -> al = 1 + 1 / k /\ ruled C D v = fixed (vertex al c d) + (v + k%:P) *: (D - C).
Proof.
move=> nz le_j sp /(FJ07_6_vertex _ _ _ nz) scale; split; first by rewrite /k div1r invrK addrC subrK.
set a := vertex al c d; pose w i := drop_ j d i - drop_ j c i.
have eq_w i : (i <= n)%N -> (al - 1) *: (drop_ j c i - a) = w i.
  move=> le_i; rewrite /w /drop_; have := scale (j + i)%N; rewrite -/a => /(_ _)/(canRL (subrK _)) -> //; last by lia.
  by by_entries l; ring.
have eq_c i : (i <= n)%N -> drop_ j c i = a + k *: w i.
  by move=> le_i; rewrite -eq_w // scalerA mulVf // scale1r addrC subrK.
have eq_d i : (i <= n)%N -> drop_ j d i = a + (k + 1) *: w i.
  by move=> le_i; rewrite scalerDl scale1r addrA -eq_c // /w addrC subrK.
rewrite /C /D (pcurve_ext _ eq_c) (pcurve_ext _ eq_d) FJ07_5_cone //; congr (_ + _ *: _).
by rewrite !pcurve_move // polyCD; move: (fixed a) (pcurve _ _ _) => A W; by_entries l; ring.
Qed.

(** FJ07.6 converse: a surface all of whose rulings pass through $a$ at $v=-k$ has proportional sides with $\alpha=1+1/k$.
    Hypotheses: $k\ne0$; the knots carry the piece, so that its points have a meaning; no $C(n,i)$ vanishes in the field, as in characteristic 0.
    Paper: takes the same $v$ on every ruling for granted in (5). *)
Theorem FJ07_6_converse n u a k c d : independent F n -> k != 0 -> span n u ->
  ruled (pcurve n u c) (pcurve n u d) (- k)%:P = fixed a -> proportional (1 + 1 / k) c d n.
Proof.
move=> nz k0 sp /(FJ07_5_vertex _ _ _ _ nz sp) eq_c i lt_i.
apply: (scalerI k0); rewrite scalerA (_ : k * _ = k + 1); last by field.
have := eq_c i.+1 lt_i; have := eq_c i (ltnW lt_i); move: (c i) (c i.+1) (d i) (d i.+1) => p q r s e e'.
rewrite [RHS]scalerDl scale1r [in X in _ = _ + X]e' [in X in _ = _ + X]e.
by by_entries j; ring.
Qed.

(** FJ07.6 needs_alpha: at $\alpha=1$ all rulings $d_i-c_i$ are equal, and no point has $d_0-a=c_0-a$ unless $d_0=c_0$: a cylinder. *)
Theorem FJ07_6_needs_alpha c d K : proportional 1 c d K <-> forall i, (i <= K)%N -> d i - c i = d 0%N - c 0%N.
Proof.
split=> [sides | eq_w i lt_i].
  elim=> // i ih lt_i; rewrite -ih 1?ltnW //; have := sides i lt_i.
  by rewrite scale1r => /(canRL (subrK _)) ->; by_entries j; ring.
have := eq_w i.+1 lt_i; rewrite -(eq_w i (ltnW lt_i)) scale1r => /(canRL (subrK _)) ->; by_entries j; ring.
Qed.
End Cone.

Lemma triple_parallel (R : comUnitRingType) (s t : R) (v w : 'rV[R]_3) : triple (s *: v) (t *: v) w = 0.
Proof. by coordinates; hide_entries; ring. Qed.

Lemma pderiv_moved (F : fieldType) m (a : 'rV[F]_m) (k : F) (W : 'rV[{poly F}]_m) : pderiv (fixed a + k%:P *: W) = k%:P *: pderiv W.
Proof. by apply/rowP=> j; rewrite !mxE derivD derivM !derivC mul0r !add0r. Qed.

(** FJ07.5 developable: proportional rows span a developable surface, for any $k$.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_5_developable (F : fieldType) n (u : nat -> F) (a : 'rV[F]_3) k (w : nat -> 'rV[F]_3) : span n u ->
  developable (pcurve n u (fun i => a + k *: w i)) (pcurve n u (fun i => a + (k + 1) *: w i)).
Proof.
by move=> sp; rewrite /developable !pcurve_move // !pderiv_moved triple_parallel.
Qed.

(** FJ07.6 developable: rows with proportional sides span a developable surface on every piece, $d(t)=\alpha c(t)+$ a point; for $\alpha=1$ too.
    Hypotheses: the points of the piece are among $c_0,\dots,c_L$; the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_6_developable (F : fieldType) n (u : nat -> F) (c d : nat -> 'rV[F]_3) al K j (C := pcurve n (drop_ j u) (drop_ j c))
    (D := pcurve n (drop_ j u) (drop_ j d)) : (j + n <= K)%N -> span n (drop_ j u) -> proportional al c d K ->
  D = fixed (d 0%N - al *: c 0%N) + al%:P *: C /\ developable C D.
Proof.
move=> le_j sp sides.
have eq_d i : (i <= K)%N -> d i = (d 0%N - al *: c 0%N) + al *: c i.
  elim: i => [_|i ih lt_i]; first by rewrite subrK.
  by have := sides i lt_i => /(canRL (subrK _)) ->; rewrite ih 1?ltnW //; by_entries r; ring.
have eq_D : D = fixed (d 0%N - al *: c 0%N) + al%:P *: C.
  rewrite -pcurve_move //; apply: pcurve_ext => i le_i; rewrite /drop_ eq_d //; lia.
by split=> //; rewrite eq_D /developable pderiv_moved -[X in triple _ X]scale1r triple_parallel.
Qed.

Section Counterexamples.
Variable F : fieldType.

(** FJ07.6 needs_k: at $k=0$ the row $c$ is the point $a$ and $d$ any: it has proportional sides only if it is a point too.
    Hypotheses: the knots carry the piece, so that its points have a meaning. *)
Theorem FJ07_6_needs_k m n (u : nat -> F) (a : 'rV[F]_m) (d : nat -> 'rV[F]_m) al K : span n u ->
  ruled (pcurve n u (fun=> a)) (pcurve n u d) (- 0)%:P = fixed a /\
  (proportional al (fun=> a) d K -> forall i, (i <= K)%N -> d i = d 0%N).
Proof.
move=> sp; rewrite /ruled oppr0 polyC0 subr0 scale1r scale0r addr0 pcurve_fixed //; split=> // sides.
elim=> // i ih lt_i; rewrite -ih 1?ltnW //; apply/eqP.
by rewrite -subr_eq0 (sides i lt_i) subrr scaler0.
Qed.

Lemma hidden_point n i : (i <= n)%N -> 'C(n, i)%:R = 0 :> F ->
  pcurve n (step01 F n) (fun j => const_mx (j == i)%:R) = fixed 0 :> 'rV[{poly F}]_1.
Proof.
move=> le_i e; apply/rowP=> j; rewrite !mxE; transitivity (curve n (step01 F n) (fun l => (l == i)%:R)).
  by apply: blossom_ext => l _; rewrite /polys /coord mxE.
by rewrite blossoms_needs_binomials // -(curve_const 0 (@span_step01 F n)).
Qed.

(** FJ07.5 needs_binomials: where $C(n,i)=0$ in the field a Bezier curve can be the point $a=0$ though its point $c_i$ is not 0. *)
Theorem FJ07_5_needs_binomials n i : (i <= n)%N -> 'C(n, i)%:R = 0 :> F ->
  exists c : nat -> 'rV[F]_1, forall k, ruled (pcurve n (step01 F n) c) (pcurve n (step01 F n) c) (- k)%:P = fixed 0 /\
    c i <> 0 + k *: (c i - c i).
Proof.
move=> le_i e; exists (fun j => const_mx (j == i)%:R) => k; split.
  by rewrite /ruled -scalerDl subrK scale1r hidden_point.
by rewrite subrr scaler0 addr0 eqxx => /rowP/(_ 0); rewrite !mxE => /eqP; rewrite oner_eq0.
Qed.

Lemma pcurve_onto m n (p : 'rV[{poly F}]_m) : independent F n ->
  (forall k, (size (p 0%R k) <= n.+1)%N) -> pcurve n (step01 F n) (fun i => \row_k in_bernstein n (p 0 k) i) = p.
Proof.
move=> nz sz; apply/rowP=> k; rewrite mxE bezier_curve [RHS](BZZ19_14_bernstein nz (sz k)).
by apply: bez_ext => i _; rewrite /coord mxE.
Qed.

(** FJ07.6 converse_needs_binomials: where $C(n,i)=0$ in the field the rows $c=d$ with $c_i=1$, all other points 0, have all their rulings through
    0 at every $v=-k$, and their sides are not proportional with $\alpha=1+1/k$. *)
Theorem FJ07_6_converse_needs_binomials n i (c := fun j => const_mx (j == i)%:R : 'rV[F]_1) k : (i <= n)%N -> 'C(n, i)%:R = 0 :> F -> k != 0 ->
  ruled (pcurve n (step01 F n) c) (pcurve n (step01 F n) c) (- k)%:P = fixed 0 /\ ~ proportional (1 + 1 / k) c c n.
Proof.
case: i @c => [|i] c le_i e k0; first by move/eqP: e; rewrite bin0 oner_eq0.
split; first by rewrite /ruled -scalerDl subrK scale1r hidden_point.
move=> /(_ i le_i)/rowP/(_ 0); rewrite /c !mxE eqxx (ltn_eqF (ltnSn i)) subr0 mulr1 => /eqP.
by rewrite -subr_eq0 opprD addrA subrr sub0r oppr_eq0 div1r invr_eq0 (negPf k0).
Qed.

(** FJ07.6 needs_scale: a cone whose rulings do not pass through the vertex at the same $v$ need not have proportional sides:
    $c=(1,t,t^2)$, $d=(1+t)c$, all rulings through 0, for $n\ge3$.
    Hypotheses: no $C(n,i)$ vanishes in the field, as in characteristic 0.
    Paper: says that every conical surface has (6). *)
Theorem FJ07_6_needs_scale n : (2 < n)%N -> independent F n -> exists c d : nat -> 'rV[F]_3,
  [/\ pcurve n (step01 F n) d = (1 + 'X) *: pcurve n (step01 F n) c, developable (pcurve n (step01 F n) c) (pcurve n (step01 F n) d)
    & forall al, ~ proportional al c d n].
Proof.
move=> lt_n nz; pose p : 'rV[{poly F}]_3 := \row_(k < 3) 'X^k; pose q : 'rV[{poly F}]_3 := (1 + 'X) *: p.
have sp k : (size (p 0%R k) <= n.+1)%N by rewrite mxE size_polyXn; apply: leq_trans (ltn_ord k) _; lia.
have s1 : size (1 + 'X : {poly F}) = 2%N by rewrite addrC -polyC1 size_XaddC.
have sq k : (size (q 0%R k) <= n.+1)%N.
  rewrite mxE (leq_trans (size_mul_leq _ _)) // s1 mxE size_polyXn; have := ltn_ord k; lia.
pose c i : 'rV[F]_3 := \row_k in_bernstein n (p 0 k) i; pose d i : 'rV[F]_3 := \row_k in_bernstein n (q 0 k) i.
exists c, d.
have eq_c : pcurve n (step01 F n) c = p by exact: pcurve_onto.
have eq_d : pcurve n (step01 F n) d = q by exact: pcurve_onto.
rewrite eq_c eq_d; split=> // [|al sides].
  rewrite /developable /q; move: p {sp q sq c d eq_c eq_d} => p; rewrite /pderiv; coordinates.
  by rewrite !derivM !derivD !derivX !derivC; hide_entries; ring.
have eq_a i : (i <= n)%N -> d i = (d 0%N - al *: c 0%N) + al *: c i.
  elim: i => [_|i ih lt_i]; first by rewrite subrK.
  by have := sides i lt_i => /(canRL (subrK _)) ->; rewrite ih 1?ltnW //; by_entries j; ring.
have := pcurve_ext (step01 F n) eq_a; rewrite pcurve_move ?eq_d ?eq_c; last exact: span_step01.
move=> /rowP/(_ 0); rewrite !mxE expr0 !mulr1 => /polyP/(_ 1%N).
by rewrite !coefD !coefC !coefX /= !addr0 add0r => /eqP; rewrite oner_eq0.
Qed.
End Counterexamples.
