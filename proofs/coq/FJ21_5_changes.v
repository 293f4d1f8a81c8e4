(* FJ21, section 5: Moebius transformations, degree elevation with f = g = 1, other lengths of the rulings, knot insertion.
   Definitions:
     moebius n b c          the points b^(n-i) c_i
     insert_points n p x u c   Boehm's points with x inserted as knot p, coordinate by coordinate *)
From Torse Require Import Prelude Blossom Curves Points FJ07_3_blossoms FJ21_4 FJ21_5 Insertion.

Section Scaling.
Variable R : comUnitRingType.
Implicit Types (u c : nat -> R) (v w : seq (R * R)) (x : R * R) (D : R).

Lemma blossom_scale u c v w D x : blossom u c (v ++ (D * x.1, D * x.2) :: w) = D * blossom u c (v ++ x :: w).
Proof.
have -> : (D * x.1, D * x.2) = comb D x 0 x by rewrite /comb !mul0r !addr0.
by rewrite blossoms_multilinear mul0r addr0.
Qed.

Lemma blossom_scale_all u c v D x k : blossom u c (v ++ nseq k (D * x.1, D * x.2)) = D ^+ k * blossom u c (v ++ nseq k x).
Proof.
elim: k v => [|k ih] v /=; first by rewrite mul1r.
by rewrite blossom_scale -[v ++ x :: _](cat_rcons x v) ih cat_rcons exprS mulrA.
Qed.
End Scaling.

Section Moebius.
Variables (F : fieldType) (m : nat).
Implicit Types (c d : nat -> 'rV[F]_m) (b t x L M s : F) (n : nat).

Definition moebius n b c i := b ^+ (n - i) *: c i.

Lemma moebius_blossom n b c v k : size v = n -> blossom (step01 F n) (coord (moebius n b c) k) v
  = blossom (step01 F n) (coord c k) [seq (x.1, (1 - b) * x.1 + b * x.2) | x <- v].
Proof. by move=> <-; rewrite -FJ21_5_2_blossom; apply: blossom_ext => i _; rewrite /coord mxE. Qed.

(** FJ21.5.1 curve: weights times $b^{n-i}$ give $\tilde p(u)=((1-b)u+b)^n\,p(t(u))$, $t(u)=\frac u{(1-b)u+b}$.
    Hypotheses: $(1-b)u+b\ne0$. *)
Theorem FJ21_5_1_curve n b c x (D := (1 - b) * x + b) : D != 0 ->
  pblossom (step01 F n) (moebius n b c) (nseq n (at_ x)) = D ^+ n *: pblossom (step01 F n) c (nseq n (at_ (x / D))).
Proof.
move=> d0; apply/rowP=> k; rewrite !mxE moebius_blossom ?size_nseq // map_nseq /= mulr1 -/D.
have -> : (x, D) = (D * (at_ (x / D)).1, D * (at_ (x / D)).2) by rewrite /= mulr1 mulrC divfK.
exact: (blossom_scale_all _ _ [::]).
Qed.

(** FJ21.5.2 functions: $\tilde\Lambda=\frac{b\Lambda}{1+(b-1)\Lambda}$, $\tilde M=\frac{bM}{1+(b-1)M}$, $\tilde\sigma=\sigma\frac{1+(b-1)M}{1+(b-1)\Lambda}$ at
    $t=\frac u{(1-b)u+b}$: $\tilde p[u^{\langle n-1\rangle},\tilde\Lambda]=\tilde\sigma\tilde q[u^{\langle n-1\rangle},\tilde M]$ iff
    $p[t^{\langle n-1\rangle},\Lambda]=\sigma q[t^{\langle n-1\rangle},M]$.
    Hypotheses: $b\ne0$; $(1-b)u+b\ne0$; $1+(b-1)\Lambda\ne0$ and $1+(b-1)M\ne0$: the transformation does not send $\Lambda$, $M$ to infinity.
    Paper: states none of them. *)
Theorem FJ21_5_2_functions n b c d x L M s (D := (1 - b) * x + b) (A := 1 + (b - 1) * L) (B := 1 + (b - 1) * M) :
  b != 0 -> D != 0 -> A != 0 -> B != 0 ->
  pblossom (step01 F n.+1) (moebius n.+1 b c) (at_ (b * L / A) :: nseq n (at_ x))
    = (s * B / A) *: pblossom (step01 F n.+1) (moebius n.+1 b d) (at_ (b * M / B) :: nseq n (at_ x)) <->
  pblossom (step01 F n.+1) c (at_ L :: nseq n (at_ (x / D))) = s *: pblossom (step01 F n.+1) d (at_ M :: nseq n (at_ (x / D))).
Proof.
move=> b0 d0 a0 b1.
have moved (e : nat -> 'rV[F]_m) y : 1 + (b - 1) * y != 0 ->
    pblossom (step01 F n.+1) (moebius n.+1 b e) (at_ (b * y / (1 + (b - 1) * y)) :: nseq n (at_ x))
    = (b / (1 + (b - 1) * y) * D ^+ n) *: pblossom (step01 F n.+1) e (at_ y :: nseq n (at_ (x / D))).
  move=> y0; apply/rowP=> k; rewrite !mxE moebius_blossom; last by rewrite /= size_nseq.
  have -> : [seq (z.1, (1 - b) * z.1 + b * z.2) | z <- at_ (b * y / (1 + (b - 1) * y)) :: nseq n (at_ x)]
      = (b / (1 + (b - 1) * y) * (at_ y).1, b / (1 + (b - 1) * y) * (at_ y).2) :: nseq n (D * (at_ (x / D)).1, D * (at_ (x / D)).2).
    rewrite /= map_nseq /= !mulr1 -/D; congr ((_, _) :: nseq _ (_, _)); [by rewrite mulrAC | by field | by rewrite mulrC divfK].
  set be := b / _; set w := nseq n (D * _, _).
  have := blossom_scale (step01 F n.+1) (coord e k) [::] w be (at_ y); rewrite !cat0s => ->.
  rewrite -mulrA; congr (be * _); exact: (blossom_scale_all _ _ [:: at_ y]).
rewrite !moved // -/A -/B scalerA.
have -> : s * B / A * (b / B * D ^+ n) = b / A * D ^+ n * s by field; rewrite a0 b1.
rewrite -[(b / A * D ^+ n * s) *: _]scalerA; split=> [|-> //]; apply: scalerI.
by rewrite !mulf_neq0 ?invr_eq0 // expf_neq0.
Qed.
End Moebius.

Section Lengths.
Variables (F : fieldType) (m : nat).
Implicit Types (p q : 'rV[{poly F}]_m) (t L M s a b : F) (n : nat).

(** FJ21.5.3 usual: raising the degree in the usual way, $f=g=1$: $\tilde\Lambda=\frac{(n+1)\Lambda-t}n$, $\tilde M$ likewise, $\tilde\sigma=\sigma$.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_3_usual n p q t L M s : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  related_at n.+1 p q t ((n.+1%:R * L - t) / n%:R) ((n.+1%:R * M - t) / n%:R) s <-> related_at n p q t L M s.
Proof.
move=> n0 n1; rewrite /related_at /tangent.
have e x : ((n.+1%:R * x - t) / n%:R - t) / n.+1%:R = (x - t) / n%:R.
  by move: n0 n1; rewrite natrS; move: (n%:R) => N n0 n1; field; rewrite n0 n1.
by rewrite !e.
Qed.

Lemma by_entry (v w x y : 'rV[F]_m) : (forall k, v 0 k = w 0 k <-> x 0 k = y 0 k) -> v = w <-> x = y.
Proof. by move=> e; split=> /rowP h; apply/rowP=> k; apply/e. Qed.

Lemma multiple (z x y l r : F) : z != 0 -> x - y = z * (l - r) -> x = y <-> l = r.
Proof.
move=> z0 e; split=> h; apply/eqP; rewrite -subr_eq0; last by rewrite e h subrr mulr0.
by apply/eqP/(mulfI z0); rewrite mulr0 -e h subrr.
Qed.

(** FJ21.5.4 rulings: for $\tilde p=fp$, $\tilde q=fp+g(q-p)$ with $f,g$ of degree one a relation $\tilde\Lambda,\tilde M,\tilde\sigma$ in degree $n+1$ is one in
    degree $n$ with $\Lambda=\frac{f(\tilde\Lambda)t+nf(t)\tilde\Lambda+\tilde\sigma(n\tilde M(g(t)-f(t))+t(g(\tilde M)-f(\tilde M)))}H$,
    $M=\frac{g(\tilde M)t+ng(t)\tilde M}G$, $\sigma=\tilde\sigma\frac GH$, where $G=ng(t)+g(\tilde M)$,
    $H=f(\tilde\Lambda)+nf(t)+\tilde\sigma(g(\tilde M)-f(\tilde M)+n(g(t)-f(t)))$, and conversely.
    Hypotheses: $G\ne0$, $H\ne0$; $n$ and $n+1$ are not 0 in the field.
    Paper: states none of them; its first display of the derivation has $\Lambda$ in the place of $M$. *)
Theorem FJ21_5_4_rulings n p q t L M s a b a' b' (f := linear a b) (g := linear a' b')
    (G := n%:R * g.[t] + g.[M]) (H := f.[L] + n%:R * f.[t] + s * (g.[M] - f.[M] + n%:R * (g.[t] - f.[t]))) :
  n%:R != 0 :> F -> n.+1%:R != 0 :> F -> G != 0 -> H != 0 ->
  related_at n.+1 (f *: p) (f *: p + g *: (q - p)) t L M s <->
  related_at n p q t ((f.[L] * t + n%:R * f.[t] * L + s * (n%:R * M * (g.[t] - f.[t]) + t * (g.[M] - f.[M]))) / H)
    ((g.[M] * t + n%:R * g.[t] * M) / G) (s * G / H).
Proof.
move=> n0 n1; rewrite /H /G /f /g !FJ21_5.linearE => g0 h0; move: n1; rewrite natrS /related_at /tangent => n1.
apply: by_entry => k.
rewrite !mxE /linear !(derivD, derivN, derivM, derivZ, derivC, derivX) !(hornerD, hornerN, hornerM, hornerC, hornerZ, hornerX) ?natrS.
move: (p 0 k).[t] (q 0 k).[t] (p 0 k)^`().[t] (q 0 k)^`().[t] n%:R n0 n1 h0 g0 => P Q P' Q' N n0 n1 h0 g0.
apply: (multiple (z := (a + b * L + N * (a + b * t) + s * (a' + b' * M - (a + b * M) + N * (a' + b' * t - (a + b * t)))) / (N + 1))).
  by rewrite mulf_neq0 ?invr_neq0.
by field; rewrite n0 n1 h0 g0.
Qed.

(** FJ21.5.4 factor: for $f=1$ and $\tilde\sigma=1$, so $\tilde q=p+g(q-p)$: $\Lambda=\frac{n\tilde\Lambda+n\tilde M(g(t)-1)+tg(\tilde M)}G$,
    $M=\frac{g(\tilde M)t+ng(t)\tilde M}G$, $\sigma=1$, where $G=ng(t)+g(\tilde M)$, and conversely.
    Hypotheses: $G\ne0$; $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_4_factor n p q t L M a' b' (g := linear a' b') (G := n%:R * g.[t] + g.[M]) : n%:R != 0 :> F -> n.+1%:R != 0 :> F -> G != 0 ->
  related_at n.+1 p (p + g *: (q - p)) t L M 1 <->
  related_at n p q t ((n%:R * L + n%:R * M * (g.[t] - 1) + t * g.[M]) / G) ((g.[M] * t + n%:R * g.[t] * M) / G) 1.
Proof.
move=> n0 n1 G0; have := @FJ21_5_4_rulings n p q t L M 1 1 0 a' b' n0 n1 G0.
have one : linear 1 0 = 1 :> {poly F} by rewrite /linear scale0r addr0.
cbv zeta; rewrite one !hornerC !scale1r -/g; have -> : 1 + n%:R * 1 + 1 * (g.[M] - 1 + n%:R * (g.[t] - 1)) = G by rewrite /G; ring.
have -> : 1 * t + n%:R * 1 * L + 1 * (n%:R * M * (g.[t] - 1) + t * (g.[M] - 1)) = n%:R * L + n%:R * M * (g.[t] - 1) + t * g.[M] by ring.
by have -> : 1 * G / G = 1 by [rewrite mul1r divff]; apply.
Qed.

(** FJ21.5.3 blossom: for a factor $f$ of degree one $\tilde p=fp$ has $\tilde p[t^{\langle n\rangle},x]=\frac{nf(t)\,p[t^{\langle n-1\rangle},x]+f(x)\,p(t)}{n+1}$.
    Hypotheses: $n$ and $n+1$ are not 0 in the field. *)
Theorem FJ21_5_3_blossom n p t x a b (f := linear a b) : n%:R != 0 :> F -> n.+1%:R != 0 :> F ->
  tangent n.+1 (f *: p) t x = n.+1%:R^-1 *: ((n%:R * f.[t]) *: tangent n p t x + f.[x] *: ev p t).
Proof.
move=> n0; rewrite natrS /f !FJ21_5.linearE => n1; apply/rowP=> k.
rewrite !mxE derivM deriv_linear /linear !(hornerD, hornerM, hornerC, hornerZ, hornerX) natrS.
by move: (p 0 k).[t] (p 0 k)^`().[t] n%:R n0 n1 => P P' N n0 n1; field; rewrite n0 n1.
Qed.
End Lengths.

Section Insertion.
Variables (F : fieldType) (m : nat).
Implicit Types (u : nat -> F) (c d : nat -> 'rV[F]_m).

Definition insert_points n p x u c i : 'rV[F]_m := \row_k insert_point n p x u (coord c k) i.

Lemma pblossom_insertion n p x u c j w (k := if (j + n <= p)%N then j else j.-1) :
  (n <= p)%N || (0 < j)%N -> span n (drop_ k u) -> span n (drop_ j (insert_knot p x u)) -> size w = n ->
  pblossom (drop_ j (insert_knot p x u)) (drop_ j (insert_points n p x u c)) w = pblossom (drop_ k u) (drop_ k c) w.
Proof.
move=> le_n spk spj sz; apply/rowP=> h; have := blossoms_boehm (coord c h) le_n spk spj sz; rewrite -/k !mxE => <-.
by apply: blossom_ext => i _; rewrite /coord /drop_ mxE.
Qed.

(** FJ21.K relation: on every piece of the knots with $x$ inserted, $\hat p[t_1,\dots,t_{n-1},\Lambda]=\sigma\hat q[t_1,\dots,t_{n-1},M]$ iff
    $p[t_1,\dots,t_{n-1},\Lambda]=\sigma q[t_1,\dots,t_{n-1},M]$ on the piece of the old knots that holds it: $\Lambda,M,\sigma$ do not change.
    Hypotheses: $n\le p$, or the piece is not the first: $x$ is not inserted among the first knots of the first piece; both pieces carry their knots, so that the
    blossoms have a meaning. *)
Theorem FJ21_K_relation n p x u c d j v L M s (u' := insert_knot p x u) (k := if (j + n <= p)%N then j else j.-1) :
  (n <= p)%N || (0 < j)%N -> span n (drop_ k u) -> span n (drop_ j u') -> (size v).+1 = n ->
  pblossom (drop_ j u') (drop_ j (insert_points n p x u c)) (at_ L :: v)
    = s *: pblossom (drop_ j u') (drop_ j (insert_points n p x u d)) (at_ M :: v) <->
  pblossom (drop_ k u) (drop_ k c) (at_ L :: v) = s *: pblossom (drop_ k u) (drop_ k d) (at_ M :: v).
Proof.
move=> le_n spk spj sz.
have e y (b : nat -> 'rV[F]_m) : pblossom (drop_ j u') (drop_ j (insert_points n p x u b)) (at_ y :: v) = pblossom (drop_ k u) (drop_ k b) (at_ y :: v).
  exact: pblossom_insertion.
by rewrite !e.
Qed.
End Insertion.
