(* FJ21, equations (3.1) and (4.4): points of a rational curve by the algorithm of de Casteljau, and the frame in its last but one points.
   Definitions:
     level t w r i           w_i^r: the numbers w_i after r steps x_i <- (1-t) x_i + t x_{i+1}
     point_level t w c r i   c_i^r: the points c_i after r steps of (3.1), with the weights w *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_blossoms FJ21_4.

Section Algorithm.
Variables (F : fieldType) (m : nat).
Implicit Types (w : nat -> F) (c : nat -> 'rV[F]_m) (t : F) (n r i : nat).

Fixpoint level t w r i : F := if r is r'.+1 then (1 - t) * level t w r' i + t * level t w r' i.+1 else w i.
Fixpoint point_level t w c r i : 'rV[F]_m :=
  if r is r'.+1 then ((1 - t) * level t w r' i / level t w r i) *: point_level t w c r' i
                     + (t * level t w r' i.+1 / level t w r i) *: point_level t w c r' i.+1
  else c i.

Lemma level_first t w r i : level t w r.+1 i = level t (level t w 1) r i.
Proof. by elim: r i => // r ih i; rewrite [LHS]/= -!/(level t w r.+1 _) !ih. Qed.

Lemma level_ext t w w' r i : (forall j, (i <= j <= i + r)%N -> w j = w' j) -> level t w r i = level t w' r i.
Proof.
elim: r i => [|r ih] i e /=; first by apply: e; lia.
by congr (_ * _ + _ * _); apply: ih => j le_j; apply: e; lia.
Qed.

Lemma level_blossom t w n : level t w n 0 = blossom (step01 F n) w (nseq n (at_ t)).
Proof.
elim: n w => [|n ih] w; first by [].
rewrite level_first /= size_nseq (@blossom_ext_knots _ _ (step01 F n)); last first.
  by move=> i; rewrite size_nseq => lt_i; rewrite /shift /step01 ltnS.
rewrite -ih; apply: level_ext => j le_j; rewrite /step /step01 /= leq_addl leqNgt ltnS (_ : (j <= n)%N) /=; last by lia.
by rewrite !subr0 divr1 !mul1r subr0.
Qed.

Lemma level_row t w c r i k : (forall s j, (0 < s <= r)%N -> (i <= j)%N -> (j + s <= i + r)%N -> level t w s j != 0) ->
  level t w r i * point_level t w c r i 0 k = level t (fun j => w j * c j 0 k) r i.
Proof.
elim: r i => [|r ih] i nz //=.
have nz0 : level t w r.+1 i != 0 by apply: nz; lia.
rewrite -/(level t w r.+1 i) -ih; last by move=> s j h1 h2 h3; apply: nz; lia.
rewrite -ih; last by move=> s j h1 h2 h3; apply: nz; lia.
rewrite !mxE; move: nz0; move: (level t w r.+1 i) (level t w r i) (level t w r i.+1) (point_level t w c r i 0 k) (point_level t w c r i.+1 0 k).
by move=> a x y p q a0; field.
Qed.

(** FJ21.3.1 algorithm: $w_i^r=(1-t)w_i^{r-1}+tw_{i+1}^{r-1}$ and
    $c_i^r=(1-t)\frac{w_i^{r-1}}{w_i^r}c_i^{r-1}+t\frac{w_{i+1}^{r-1}}{w_i^r}c_{i+1}^{r-1}$ end in the weight and the point of the rational curve:
    $w_0^n=w(t)$ and $w_0^nc_0^n=p(t)$.
    Hypotheses: no weight $w_i^r$, $r=1..n$, vanishes, so that all points $c_i^r$ have a meaning.
    Paper: states none; positive weights and $0\le t\le1$ suffice. *)
Theorem FJ21_3_1_algorithm t w c n : (forall r i, (0 < r)%N -> (i + r <= n)%N -> level t w r i != 0) ->
  level t w n 0 = blossom (step01 F n) w (nseq n (at_ t)) /\
  level t w n 0 *: point_level t w c n 0 = pblossom (step01 F n) (fun i => w i *: c i) (nseq n (at_ t)).
Proof.
move=> nz; split; first exact: level_blossom.
apply/rowP=> k; rewrite !mxE level_row; last by move=> s j h1 _ h3; apply: nz; lia.
by rewrite level_blossom; apply: blossom_ext => j _; rewrite /coord mxE.
Qed.

(** FJ21.3.1 needs_weights: an intermediate weight may vanish where the curve has a point: for the weights $1,-1,2$ and $t=1/2$,
    $w_0^1=0$, so that there is no $c_0^1$, but $w_0^2=w(1/2)=1/4$.
    Hypotheses: $2\ne0$ in the field, so that $t$ has a meaning. *)
Theorem FJ21_3_1_needs_weights (w := fun i => nth 0 [:: 1; -1; 2%:R] i : F) (t := 2%:R^-1 : F) : 2%:R != 0 :> F ->
  level t w 1 0 = 0 /\ level t w 2 0 = 4%:R^-1.
Proof.
move=> two; have four : 4%:R != 0 :> F by rewrite (natrM _ 2 2) mulf_neq0.
by split; rewrite /= /w /t /=; field; rewrite ?two ?four.
Qed.
End Algorithm.

Section Frame.
Variables (F : fieldType) (m : nat).
Implicit Types (p q : 'rV[{poly F}]_m) (t lam mu nu : F) (n : nat).

(** FJ21.4.4 points: $p(t)=(1-t)p_0+tp_1$ and $p'(t)=n(p_1-p_0)$ for $p_i=p[t^{\langle n-1\rangle},i]$.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_4_4_points n p t : n%:R != 0 :> F ->
  ev p t = (1 - t) *: tangent n p t 0 + t *: tangent n p t 1 /\
  ev (pderiv p) t = n%:R *: (tangent n p t 1 - tangent n p t 0).
Proof.
by move=> n0; split; apply/rowP=> k; rewrite !mxE; move: (p 0 k).[t] (p 0 k)^`().[t] n%:R n0 => P P' N n0; field.
Qed.

(** FJ21.4.4 frame: $p'-\lambda W-\mu W'-\nu p=(n(1+\mu)+t(\lambda-\nu))p_1+((1-t)(\lambda-\nu)-n(1+\mu))p_0-(\lambda t+n\mu)q_1-(\lambda(1-t)-n\mu)q_0$
    for $W=q-p$ and $p_i=p[t^{\langle n-1\rangle},i]$, $q_i=q[t^{\langle n-1\rangle},i]$.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_4_4_frame n p q t lam mu nu : n%:R != 0 :> F ->
  ev (pderiv p) t - lam *: ev (q - p) t - mu *: ev (pderiv (q - p)) t - nu *: ev p t
    = (n%:R * (1 + mu) + t * (lam - nu)) *: tangent n p t 1 + ((1 - t) * (lam - nu) - n%:R * (1 + mu)) *: tangent n p t 0
      - (lam * t + n%:R * mu) *: tangent n q t 1 - (lam * (1 - t) - n%:R * mu) *: tangent n q t 0.
Proof.
move=> n0; apply/rowP=> k; rewrite !mxE !derivB !hornerD !hornerN.
by move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0; field.
Qed.

(** FJ21.6 points: $(1-v)p'+vq'-\alpha(q-p)-\beta((1-v)p+vq)=(n(v-1)+(1-t)(\alpha+(v-1)\beta))p_0+(n(1-v)+t(\alpha+(v-1)\beta))p_1
    -(nv+(1-t)(\alpha+v\beta))q_0-(-nv+t(\alpha+v\beta))q_1$ for $p_i=p[t^{\langle n-1\rangle},i]$, $q_i=q[t^{\langle n-1\rangle},i]$.
    Hypotheses: $n\ne0$ in the field. *)
Theorem FJ21_6_points n p q t v al be : n%:R != 0 :> F ->
  (1 - v) *: ev (pderiv p) t + v *: ev (pderiv q) t - al *: ev (q - p) t - be *: ((1 - v) *: ev p t + v *: ev q t)
    = (n%:R * (v - 1) + (1 - t) * (al + (v - 1) * be)) *: tangent n p t 0 + (n%:R * (1 - v) + t * (al + (v - 1) * be)) *: tangent n p t 1
      - (n%:R * v + (1 - t) * (al + v * be)) *: tangent n q t 0 - (- (n%:R * v) + t * (al + v * be)) *: tangent n q t 1.
Proof.
move=> n0; apply/rowP=> k; rewrite !mxE !hornerD !hornerN.
by move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 => P Q P' Q' N n0; field.
Qed.
End Frame.
